"""The section of a head with its four measures: as SVG, and in characters for a terminal."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Final

from wireprint.heads.measures import MEASURES

if TYPE_CHECKING:
    from wireprint.settings.head import Head, HeadBox, HeadCylinder

#: Size of the drawing, and of what is drawn to scale in it, px.
_WIDTH, _HEIGHT, _REACH_PX = 720, 460, 250
#: Middle of the drawing, and height of the tip, px.
_AXIS, _TIP = 330, 330
#: The block is drawn so high, the carriage as a band above it: only their undersides matter, px.
_BLOCK, _BAND = 110, 26

_TERMINAL: Final = r"""
                      |<------ D ------->|
   ___________________|__________________|
  |                   |                  |
  |   heater block, sock, ducts          |
  |____________       |      ____________|____  ___
               \      |     /                    |
                \     |    /                     C
                 \    |   /  B                   |
   _______________\___|__/________ bed _________ ___
                  |<-A-->|
"""


def text(head: Head) -> list[str]:
    """Return the drawing in characters, and what each letter is and measures now."""
    lines = _TERMINAL.strip("\n").split("\n")
    told = [
        f" {measure.letter}  {measure.words}: {measure.of(head):g} {measure.unit}".rstrip()
        for measure in MEASURES
    ]
    return [*lines, "", *told]


def svg(head: Head) -> str:
    """Return the section of a head to scale, up to the reach of its block, as an SVG picture."""
    scale = _REACH_PX / head.block_radius_mm
    tip, cone = head.tip_radius_mm * scale, head.cone_height_mm * scale
    flank = tip + cone / math.tan(math.radians(head.slant_deg))
    under = _TIP - cone
    top = under - _BLOCK
    shape = [
        (-tip, _TIP), (tip, _TIP), (flank, under), (_REACH_PX, under), (_REACH_PX, top),
        (-_REACH_PX, top), (-_REACH_PX, under), (-flank, under),
    ]  # fmt: skip
    parts = [_part(part, scale, top) for part in head.parts]
    marks = [
        _across(_AXIS - tip, _AXIS + tip, _TIP + 34, _TIP, "A"),
        _angle(_AXIS + tip, head.slant_deg),
        _upright(_AXIS + _REACH_PX + 34, under, _TIP, "C"),
        _across(_AXIS, _AXIS + _REACH_PX, top - _BAND - 26, under, "D"),
    ]
    words = [
        f'<text x="24" y="{_TIP + 62 + 19 * row}">{one.letter}: {one.words}, '
        f"{one.of(head):g} {one.unit}</text>"
        for row, one in enumerate(MEASURES)
    ]
    axis = f'<path d="M{_AXIS} {_TIP + 18}V{top - _BAND - 14}" stroke-dasharray="9 3 2 3"/>'
    bed = f'<path d="M40 {_TIP}H{_WIDTH - 40}" stroke="#999"/>'
    band = f'<rect x="40" y="{top - _BAND}" width="{2 * (_AXIS - 40)}" height="{_BAND}"/>'
    return "\n".join(
        [
            f'<svg xmlns="http://www.w3.org/2000/svg" width="{_WIDTH}" height="{_HEIGHT}" '
            f'viewBox="0 0 {_WIDTH} {_HEIGHT}" font-family="sans-serif" font-size="13">',
            f'<rect width="{_WIDTH}" height="{_HEIGHT}" fill="white"/>',
            f'<g fill="#e8ecf2" stroke="#456" stroke-width="1.5">{band}',
            f'<polygon points="{" ".join(f"{_AXIS + x:.1f},{y:.1f}" for x, y in shape)}"/>',
            *parts,
            "</g>",
            f'<g fill="none" stroke="#222" stroke-width="1">{bed}{axis}</g>',
            *marks,
            f'<text x="{_AXIS - 150}" y="{top + 24}">heater block, sock, ducts</text>',
            f'<text x="{_AXIS - 150}" y="{top - _BAND / 3}">carriage</text>',
            *words,
            "</svg>",
            "",
        ]
    )


def _part(part: HeadBox | HeadCylinder, scale: float, top: float) -> str:
    """Return a part as it is seen along y."""
    if part.shape == "cylinder":
        low, high = (part.centre_mm[0] + sign * part.radius_mm for sign in (-1, 1))
    else:
        turn = math.radians(part.turn_deg)
        seen = [x * math.cos(turn) - y * math.sin(turn) for x in part.x_mm for y in part.y_mm]
        low, high = min(seen), max(seen)
    bottom = _TIP - part.bottom_mm * scale
    height = max(bottom - top, 4.0)
    return (
        f'<rect x="{_AXIS + low * scale:.1f}" y="{bottom - height:.1f}" '
        f'width="{(high - low) * scale:.1f}" height="{height:.1f}" fill="#f3dcc8" '
        'fill-opacity="0.7" stroke-dasharray="4 3"/>'
    )


def _line(path: str) -> str:
    return f'<path d="{path}" fill="none" stroke="#b03020" stroke-width="1.2"/>'


def _letter(x: float, y: float, letter: str) -> str:
    return (
        f'<text x="{x:.1f}" y="{y:.1f}" font-size="18" font-weight="bold" fill="#b03020" '
        f'text-anchor="middle">{letter}</text>'
    )


def _across(left: float, right: float, y: float, seen_at: float, letter: str) -> str:
    """Return a width with lines to where it is seen."""
    ends = "".join(f"M{x:.1f} {seen_at:.1f}V{y:.1f}" for x in (left, right))
    line = _line(f"{ends}M{left:.1f} {y:.1f}H{right:.1f}")
    beside = max(right + 14, (left + right) / 2) if right - left < 60 else (left + right) / 2
    return line + _letter(beside, y + (6 if right - left < 60 else -6), letter)


def _upright(x: float, top: float, bottom: float, letter: str) -> str:
    from_block = f"M{_AXIS + _REACH_PX} {top:.1f}H{x + 6}"
    line = _line(f"{from_block}M{x} {top:.1f}V{bottom:.1f}M{x - 6} {bottom:.1f}H{x + 6}")
    return line + _letter(x + 14, (top + bottom) / 2 + 6, letter)


def _angle(rim: float, degrees: float) -> str:
    """Return the angle between the bed and the flank at the tip's rim."""
    radius, turn = 64.0, math.radians(degrees)
    x, y = rim + radius * math.cos(turn), _TIP - radius * math.sin(turn)
    arc = _line(f"M{rim + radius:.1f} {_TIP}A{radius} {radius} 0 0 0 {x:.1f} {y:.1f}")
    half = turn / 2
    at = (rim + (radius + 16) * math.cos(half), _TIP - (radius + 16) * math.sin(half) + 6)
    return arc + _letter(*at, "B")
