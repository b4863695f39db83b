"""What notebooks show of an object: a picture, and what there is to say, drawn when asked for."""

from __future__ import annotations

import base64
import html
from typing import TYPE_CHECKING, Any, Final

from wireprint.duration import duration
from wireprint.view import render_png

if TYPE_CHECKING:
    from wireprint.view_source import Source

#: Width and height, pixels.
SIZE: Final = (640, 480)


def picture(shown: Source) -> bytes:
    """Draw an object as a notebook shows it, a PNG file."""
    return render_png(shown, size=SIZE, title="")


def page(shown: Source, told: str) -> str:
    """Return a picture with a line below it, as HTML that needs nothing else."""
    data = base64.b64encode(picture(shown)).decode()
    text = html.escape(told)
    return (
        '<figure style="margin:0;max-width:640px">'
        f'<img alt="{text}" style="max-width:100%" src="data:image/png;base64,{data}">'
        f"<figcaption>{text}</figcaption></figure>"
    )


def told(figures: dict[str, Any]) -> str:
    """Say time, filament and verdict of a print in one line; figures as ``--json`` has them."""
    parts = [duration(figures["print_time_s"]), f"{figures['filament_g']:.1f} g"]
    if "certified" in figures:
        broken = {name: count for name, count in figures["breaches"].items() if count}
        said = ", ".join(f"{count} {name.replace('_', ' ')}" for name, count in broken.items())
        parts.append("certified" if figures["certified"] else f"not certified: {said}")
    else:
        parts.append("not judged")
    if "coverage" in figures:
        parts.append(f"{figures['coverage']:.1%} covered")
    return ", ".join(parts)
