"""The prints that a budget was chosen from, as a picture."""

from __future__ import annotations

import io
from typing import TYPE_CHECKING, Final

from wireprint.duration import duration

if TYPE_CHECKING:
    from wireprint.budget import Budgeted

#: Sizes in pixels.
_WIDTH: Final = 1000
_HEIGHT: Final = 620
_LEFT: Final = 110
_RIGHT: Final = 40
_TOP: Final = 70
_BOTTOM: Final = 80
_DOT: Final = 9
_FONT: Final = 20

_INK: Final = (34, 40, 49)
_PAPER: Final = (255, 255, 255)
_GRID: Final = (225, 229, 234)
_ACCENT: Final = (226, 98, 44)
#: The stiffest and the softest.
_STIFF: Final = (24, 52, 110)
_SOFT: Final = (176, 200, 236)
_TICKS: Final = 5


def png(found: Budgeted, title: str) -> bytes:
    """Draw deviation over time, one dot a print: the stiffer the darker, the chosen one ringed.

    Parameters
    ----------
    found
        What a search gave.
    title
        Written above.

    Returns
    -------
    bytes
        The PNG file.
    """
    from PIL import Image, ImageDraw, ImageFont

    # Pillow's own font lacks many signs.
    font = ImageFont.load_default(_FONT)
    image = Image.new("RGB", (_WIDTH, _HEIGHT), _PAPER)
    draw = ImageDraw.Draw(image)
    times = [one.print_time_s for one in found.front]
    if found.budget.time_s is not None:
        times.append(found.budget.time_s)
    most_s = 1.08 * max(times)
    most_mm = 1.15 * max(max(one.deviation_mm for one in found.front), 1e-6)
    room_x, room_y = _WIDTH - _LEFT - _RIGHT, _HEIGHT - _TOP - _BOTTOM

    def place(time_s: float, off_mm: float) -> tuple[float, float]:
        return _LEFT + room_x * time_s / most_s, _HEIGHT - _BOTTOM - room_y * off_mm / most_mm

    draw.text((_LEFT, _TOP / 2), title, _INK, font, anchor="lm")
    for tick in range(_TICKS + 1):
        x, y = place(most_s * tick / _TICKS, most_mm * tick / _TICKS)
        draw.line((x, _TOP, x, _HEIGHT - _BOTTOM), _GRID)
        draw.line((_LEFT, y, _WIDTH - _RIGHT, y), _GRID)
        draw.text((x, _HEIGHT - _BOTTOM + 8), duration(most_s * tick / _TICKS), _INK, font, "ma")
        draw.text((_LEFT - 8, y), f"{most_mm * tick / _TICKS:.2f}", _INK, font, anchor="rm")
    draw.text((_WIDTH - _RIGHT, _HEIGHT - 14), "print time", _INK, font, anchor="rs")
    draw.text((8, _TOP - 14), "deviation, mm", _INK, font, anchor="ls")
    if found.budget.time_s is not None:
        x, _ = place(found.budget.time_s, 0)
        draw.line((x, _TOP, x, _HEIGHT - _BOTTOM), _ACCENT, 2)
        draw.text((x - 6, _TOP + 4), f"budget {duration(found.budget.time_s)}", _ACCENT, font, "ra")
    gives = [one.give_mm for one in found.front]
    low, high = min(gives), max(gives)
    for one in found.front:
        x, y = place(one.print_time_s, one.deviation_mm)
        share = 0.0 if high <= low else (one.give_mm - low) / (high - low)
        mixed = [a + share * (b - a) for a, b in zip(_STIFF, _SOFT, strict=True)]
        colour = (round(mixed[0]), round(mixed[1]), round(mixed[2]))
        draw.ellipse((x - _DOT, y - _DOT, x + _DOT, y + _DOT), colour)
        if one.chosen:
            ring = 2 * _DOT
            draw.ellipse((x - ring, y - ring, x + ring, y + ring), outline=_ACCENT, width=3)
            text = f"{duration(one.print_time_s)}, {one.deviation_mm:.2f} mm"
            draw.text((x, y - ring - 4), text, _ACCENT, font, anchor="ms")
    buffer = io.BytesIO()
    image.save(buffer, "PNG", optimize=True)
    return buffer.getvalue()
