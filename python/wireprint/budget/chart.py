"""The prints that a budget was chosen from, as a picture."""

from __future__ import annotations

import io
from typing import TYPE_CHECKING, Final

from wireprint.budget.axis import Axis
from wireprint.duration import duration
from wireprint.text import one_line

if TYPE_CHECKING:
    from PIL.ImageDraw import ImageDraw
    from PIL.ImageFont import FreeTypeFont, ImageFont

    from wireprint.budget import Budgeted

#: Sizes in pixels.
_WIDTH: Final = 1000
_HEIGHT: Final = 660
_LEFT: Final = 110
_RIGHT: Final = 50
_TOP: Final = 104
_BOTTOM: Final = 88
_DOT: Final = 9
_FONT: Final = 20
_GAP: Final = 8

_INK: Final = (34, 40, 49)
_PAPER: Final = (255, 255, 255)
_GRID: Final = (225, 229, 234)
_GREY: Final = (104, 114, 128)
_ACCENT: Final = (200, 78, 28)
#: The stiffest and the softest.
_STIFF: Final = (24, 52, 110)
_SOFT: Final = (176, 200, 236)

Box = tuple[float, float, float, float]


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
    budget_s = found.budget.time_s
    times = Axis.of_times(
        [one.print_time_s for one in found.front] + ([] if budget_s is None else [budget_s])
    )
    offs = Axis.of_numbers(one.deviation_mm for one in found.front)
    right, foot = _WIDTH - _RIGHT, _HEIGHT - _BOTTOM

    def place(time_s: float, off_mm: float) -> tuple[float, float]:
        x = _LEFT + (right - _LEFT) * times.share(time_s)
        return x, foot - (foot - _TOP) * offs.share(off_mm)

    draw.text(
        (_LEFT, 30), _shortened(draw, font, one_line(title), right - _LEFT), _INK, font, anchor="lm"
    )
    for tick in times.ticks:
        x, _ = place(tick, offs.low)
        draw.line((x, _TOP, x, foot), _GRID)
        draw.text((x, foot + _GAP), duration(tick), _INK, font, anchor="ma")
    for tick in offs.ticks:
        _, y = place(times.low, tick)
        draw.line((_LEFT, y, right, y), _GRID)
        draw.text((_LEFT - _GAP, y), f"{tick:.{offs.decimals}f}", _INK, font, anchor="rm")
    draw.text((right, _HEIGHT - 16), "print time", _INK, font, anchor="rs")
    # Above the axis and left of it: the title has a line of its own.
    draw.text((_GAP, _TOP - 2 * _GAP), "deviation, mm", _INK, font, anchor="ls")
    gives = [one.give_mm for one in found.front]
    low, high = min(gives), max(gives)
    told = f"{low:.2f} mm" if high <= low else f"{low:.2f} (dark) to {high:.2f} mm (light)"
    draw.text((right, _TOP - 2 * _GAP), f"gives way by {told}", _GREY, font, anchor="rs")

    taken: list[Box] = []
    if budget_s is not None:
        x, _ = place(budget_s, offs.low)
        draw.line((x, _TOP, x, foot), _ACCENT, 2)
        taken.append((x - 1, _TOP, x + 1, foot))
    for one in found.front:
        x, y = place(one.print_time_s, one.deviation_mm)
        share = 0.0 if high <= low else (one.give_mm - low) / (high - low)
        mixed = [a + share * (b - a) for a, b in zip(_STIFF, _SOFT, strict=True)]
        colour = (round(mixed[0]), round(mixed[1]), round(mixed[2]))
        size = 2 * _DOT if one.chosen else _DOT
        draw.ellipse((x - _DOT, y - _DOT, x + _DOT, y + _DOT), colour)
        if one.chosen:
            draw.ellipse((x - size, y - size, x + size, y + size), outline=_ACCENT, width=3)
        taken.append((x - size, y - size, x + size, y + size))
    chosen = found.chosen
    within = (_LEFT, _TOP, right, foot)
    x, y = place(chosen.print_time_s, chosen.deviation_mm)
    text = f"{duration(chosen.print_time_s)}, {chosen.deviation_mm:.2f} mm"
    _write(draw, font, text, (x, y), 2 * _DOT + _GAP, within, taken)
    if budget_s is not None:
        x, _ = place(budget_s, offs.low)
        _write(draw, font, f"budget {duration(budget_s)}", (x, _TOP + 20), _GAP, within, taken)
    buffer = io.BytesIO()
    image.save(buffer, "PNG", optimize=True)
    return buffer.getvalue()


def _write(
    draw: ImageDraw,
    font: FreeTypeFont | ImageFont,
    text: str,
    at: tuple[float, float],
    away: float,
    within: Box,
    taken: list[Box],
) -> None:
    """Write beside a place where nothing else is drawn, right of it, left, below or above."""
    x, y = at
    ways = ((x + away, y, "lm"), (x - away, y, "rm"), (x, y + away, "ma"), (x, y - away, "md"))
    boxes = [(way, draw.textbbox(way[:2], text, font, anchor=way[2])) for way in ways]
    inside = [one for one in boxes if _holds(within, one[1])] or boxes
    # Where something is drawn on every side, over as little of it as can be.
    way, box = min(inside, key=lambda one: sum(_meet(one[1], other) for other in taken))
    draw.text(way[:2], text, _ACCENT, font, anchor=way[2])
    taken.append(box)


def _holds(outer: Box, inner: Box) -> bool:
    left, top, right, bottom = inner
    return outer[0] <= left and outer[1] <= top and right <= outer[2] and bottom <= outer[3]


def _meet(one: Box, other: Box) -> bool:
    return one[0] < other[2] and other[0] < one[2] and one[1] < other[3] and other[1] < one[3]


def _shortened(draw: ImageDraw, font: FreeTypeFont | ImageFont, text: str, room: float) -> str:
    """Cut the middle out of a text that has no room."""
    if draw.textlength(text, font) <= room:
        return text
    kept = len(text)
    while kept > 2 and draw.textlength(f"{text[: kept // 2]}...{text[-kept // 2 :]}", font) > room:
        kept -= 1
    return f"{text[: kept // 2]}...{text[-kept // 2 :]}"
