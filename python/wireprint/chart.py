"""A comparison as a bar chart."""

from __future__ import annotations

import io
from typing import TYPE_CHECKING, Final

from wireprint.duration import duration

if TYPE_CHECKING:
    from wireprint.comparison import Comparison

#: Sizes in pixels.
_WIDTH: Final = 1000
_ROW: Final = 64
_BAR: Final = 40
_MARGIN: Final = 24
_GAP: Final = 12
_FONT: Final = 22

_INK: Final = (34, 40, 49)
_PAPER: Final = (255, 255, 255)
_GREY: Final = (150, 160, 172)
_ACCENT: Final = (226, 98, 44)
#: Conditions in colour.
_OURS: Final = ("wireprint", "hybrid")


def png(comparison: Comparison, title: str) -> bytes:
    """Draw print times as bars, those of wire prints in colour.

    Parameters
    ----------
    comparison
        What to draw.
    title
        Written above the bars.

    Returns
    -------
    bytes
        The PNG file.
    """
    from PIL import Image, ImageDraw, ImageFont

    # Pillow's own font lacks the multiplication sign.
    font = ImageFont.load_default(_FONT)
    rows = comparison.conditions
    height = 2 * _MARGIN + _ROW * (len(rows) + 1)
    image = Image.new("RGB", (_WIDTH, height), _PAPER)
    draw = ImageDraw.Draw(image)
    draw.text((_MARGIN, _MARGIN + _ROW / 2), title, _INK, font, anchor="lm")
    values = [f"{duration(row.print_time_s)}  ({row.speedup:.1f} x)" for row in rows]
    left = 2 * _MARGIN + max(draw.textlength(row.condition, font) for row in rows)
    room = _WIDTH - _MARGIN - _GAP - left - max(draw.textlength(value, font) for value in values)
    longest_s = max(row.print_time_s for row in rows)
    for number, (row, value) in enumerate(zip(rows, values, strict=True), start=1):
        middle = _MARGIN + _ROW * (number + 0.5)
        length = max(1.0, room * row.print_time_s / longest_s)
        colour = _ACCENT if row.condition in _OURS else _GREY
        draw.text((_MARGIN, middle), row.condition, _INK, font, anchor="lm")
        draw.rectangle((left, middle - _BAR / 2, left + length, middle + _BAR / 2), colour)
        draw.text((left + length + _GAP, middle), value, _INK, font, anchor="lm")
    buffer = io.BytesIO()
    image.save(buffer, "PNG", optimize=True)
    return buffer.getvalue()
