"""Straight lines that fill areas, joined to zigzags where neighbours allow."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
import shapely

from wireprint.layerwise.lines import Lines

if TYPE_CHECKING:
    import numpy.typing as npt

    from wireprint.layerwise.areas import Geometries

    Floats = npt.NDArray[np.float64]
    Ints = npt.NDArray[np.int64]


@dataclass(frozen=True)
class Strokes:
    """Parts of scan lines inside areas, in the order of area, scan line and x."""

    #: Index of the area, shape (N,).
    area: Ints
    #: Number of the scan line, shape (N,).
    line: Ints
    #: Ends in the turned frame, where scan lines are parallel to x, mm.
    low: Floats
    high: Floats

    def __len__(self) -> int:
        """Return the number of strokes."""
        return len(self.area)

    def ends(self, turn_rad: Floats, spacing_mm: float) -> Floats:
        """Return both ends of each stroke, mm, shape (N, 2, 2), given what they were made with."""
        y = (self.line.astype(np.float64) + 0.5) * spacing_mm
        turn = turn_rad[self.area]
        return np.stack([_turned(self.low, y, turn), _turned(self.high, y, turn)], axis=1)


def hatched(
    areas: Geometries, turn_rad: Floats, spacing_mm: float, line_mm: float, link_mm: float
) -> Lines:
    """Fill areas with parallel lines.

    Parameters
    ----------
    areas
        What the lines' centres may cover, shape (N,).
    turn_rad
        Direction of the lines from the x axis, for each area, shape (N,).
    spacing_mm
        From line to line, mm.
    line_mm
        Width of a line, mm: shorter pieces are left out, and a link may stray by half of it.
    link_mm
        Neighbouring lines whose ends are no further apart are joined, mm.

    Returns
    -------
    Lines
        Open lines; `Lines.owner` is the index of the area.
    """
    found = strokes(areas, turn_rad, spacing_mm, line_mm)
    if not len(found):
        return Lines.empty()
    chain, rank = _chains(found)
    order = np.lexsort((rank, chain))
    area, line = found.area[order], found.line[order]
    backwards = rank[order] % 2 == 1
    low, high = found.low[order], found.high[order]
    begin, end = np.where(backwards, high, low), np.where(backwards, low, high)
    y = (line.astype(np.float64) + 0.5) * spacing_mm
    joined = chain[order][1:] == chain[order][:-1]
    joined &= np.hypot(begin[1:] - end[:-1], spacing_mm) <= link_mm
    inward = np.where(backwards[1:], -line_mm / 2, line_mm / 2)
    begins, ends = _turned(begin, y, turn_rad[area]), _turned(end, y, turn_rad[area])
    candidates = np.flatnonzero(joined)
    from_ = _turned(end[:-1] + inward, y[:-1], turn_rad[area[:-1]])[candidates]
    to = _turned(begin[1:] + inward, y[1:], turn_rad[area[1:]])[candidates]
    joined[candidates] = _inside(areas, area[candidates], from_, to)
    points = np.stack([begins, ends], axis=1).reshape(-1, 2)
    firsts = 2 * np.flatnonzero(np.concatenate([[True], ~joined]))
    offsets = np.append(firsts, len(points))
    return Lines(points, offsets, area[firsts // 2], closed=False)


def strokes(areas: Geometries, turn_rad: Floats, spacing_mm: float, line_mm: float) -> Strokes:
    """Return the parts of scan lines that lie in areas; see `hatched`.

    Notes
    -----
    Every edge is crossed with every scan line; between odd and even crossings lies the area.
    """
    parts, area_of_part = shapely.get_parts(areas, return_index=True)
    rings, part_of_ring = shapely.get_rings(parts, return_index=True)
    points, ring_of_point = shapely.get_coordinates(rings, return_index=True)
    area = area_of_part[part_of_ring[ring_of_point]]
    turned = _turned(points[:, 0], points[:, 1], -turn_rad[area])
    edge = np.flatnonzero(ring_of_point[1:] == ring_of_point[:-1])
    x0, y0 = turned[edge].T
    x1, y1 = turned[edge + 1].T
    first = np.ceil(np.minimum(y0, y1) / spacing_mm - 0.5).astype(np.int64)
    crossings = np.ceil(np.maximum(y0, y1) / spacing_mm - 0.5).astype(np.int64) - first
    which = np.repeat(np.arange(len(edge)), crossings)
    line = np.arange(len(which)) - np.repeat(np.cumsum(crossings) - crossings, crossings)
    line += first[which]
    share = ((line + 0.5) * spacing_mm - y0[which]) / (y1[which] - y0[which])
    x = x0[which] + share * (x1[which] - x0[which])
    owner = area[edge][which]
    order = np.lexsort((x, line, owner))
    low, high = x[order][::2], x[order][1::2]
    long = high - low >= line_mm / 2
    keep = order[::2][long]
    return Strokes(owner[keep], line[keep], low[long], high[long])


def _chains(strokes: Strokes) -> tuple[Ints, Ints]:
    """Link each stroke to the one on the next scan line if these two alone overlap.

    Returns, for each stroke, the first stroke of its chain and its rank in the chain.
    """
    following = _only_overlap(strokes, step=1)
    previous = _only_overlap(strokes, step=-1)
    index = np.arange(len(strokes))
    mutual = (previous >= 0) & (following[previous] == index)
    parent = np.where(mutual, previous, index)
    rank = mutual.astype(np.int64)
    # Pointer jumping: every round doubles the reach.
    while True:
        grandparent = parent[parent]
        if np.array_equal(grandparent, parent):
            return parent, rank
        rank = rank + rank[parent]
        parent = grandparent


def _only_overlap(strokes: Strokes, step: int) -> Ints:
    """Return the one stroke on the scan line `step` further that overlaps; −1 for none or many."""
    width = 4.0 * (1.0 + max(np.abs(strokes.low).max(), np.abs(strokes.high).max()))
    # Scan lines of one area follow each other; a gap of two keeps areas apart.
    fresh = np.concatenate([[0], np.diff(strokes.area) != 0])
    leap = np.where(fresh, 2, np.concatenate([[0], np.diff(strokes.line)]))
    row = np.cumsum(leap)
    first = np.searchsorted(row * width + strokes.high, (row + step) * width + strokes.low, "right")
    last = np.searchsorted(row * width + strokes.low, (row + step) * width + strokes.high, "left")
    return np.where(last - first == 1, first, -1)


def _inside(areas: Geometries, owner: Ints, begin: Floats, end: Floats) -> npt.NDArray[np.bool_]:
    if not len(owner):
        return np.zeros(0, dtype=bool)
    chords = shapely.linestrings(np.stack([begin, end], axis=1))
    # Prepared geometries build their index when first asked, which threads must not do at once.
    shapely.prepare(areas)
    inside: npt.NDArray[np.bool_] = shapely.covers(areas[owner], chords)
    return inside


def _turned(x: Floats, y: Floats, by_rad: Floats) -> Floats:
    cos, sin = np.cos(by_rad), np.sin(by_rad)
    return np.stack([x * cos - y * sin, x * sin + y * cos], axis=1)
