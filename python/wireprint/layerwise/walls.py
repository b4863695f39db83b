"""Walls: lines along the contours, and the area that they leave."""

from __future__ import annotations

from dataclasses import dataclass

from wireprint.layerwise.areas import Geometries, offset
from wireprint.layerwise.lines import Lines


@dataclass(frozen=True)
class Walls:
    """The walls of many islands."""

    #: Closed lines, the innermost first; `Lines.owner` is the index of the island.
    lines: tuple[Lines, ...]
    #: What the centres of filling lines may cover, shape (N,).
    inner: Geometries


def walls(
    islands: Geometries, count: int, inset_mm: float, spacing_mm: float, overlap_mm: float
) -> Walls:
    """Lay walls inside islands.

    Parameters
    ----------
    islands
        Polygons, shape (N,).
    count
        Walls side by side.
    inset_mm
        From the contour to the centre of the outer wall, mm: half a line's width puts its edge on
        the contour.
    spacing_mm
        From line to line, mm.
    overlap_mm
        By which the fill runs into the innermost wall, mm.
    """
    area = offset(islands, -inset_mm) if inset_mm else islands
    lines: list[Lines] = []
    for number in range(count):
        if number:
            area = offset(area, -spacing_mm)
        lines.append(Lines.rims(area))
    # Without walls, the fill reaches to the contour, as far as its own width allows.
    inner = offset(area, overlap_mm - spacing_mm) if count else area
    return Walls(tuple(reversed(lines)), inner)
