"""Walls along the painted stretches of contours."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
import shapely

from wireprint.hybrid.group import Group
from wireprint.layerwise.areas import Geometries, offset, pieces_in

if TYPE_CHECKING:
    import numpy.typing as npt

    from wireprint.hybrid.cut import Cut, Samples
    from wireprint.layerwise.recipe import Recipe

    Floats = npt.NDArray[np.float64]
    Ints = npt.NDArray[np.int64]
    Bools = npt.NDArray[np.bool_]

#: Pieces of a line shorter than this many line widths are left out.
_SHORTEST = 1.0
#: Points nearer than this are one, mm.
_SAME_MM = 1e-6
#: A line may leave the model by this part of its width before it is cut.
_ASIDE = 0.1


@dataclass(frozen=True)
class Fringe:
    """Walls of what is painted in part."""

    #: The walls, the outer ones first.
    groups: list[Group]
    #: Centre lines of the outer and the innermost walls, by layer, shape (K,).
    outer: Geometries
    innermost: Geometries
    #: How far these lie behind the surface, mm.
    inward_mm: float


def fringe(
    cut: Cut,
    samples: Samples,
    painted: Bools,
    areas: Geometries,
    recipe: Recipe,
    inset_mm: float,
) -> Fringe:
    """Lay walls along painted stretches of contours.

    Parameters
    ----------
    cut, samples
        The layers.
    painted
        Which samples walls follow, shape (S,).
    areas
        What the model covers on each layer, shape (K,).
    recipe
        Widths and counts; one wall at least is laid.
    inset_mm
        From the model's surface to the centre of the outer wall, mm.
    """
    strings, contour = _strings(cut, samples, painted, _SHORTEST * recipe.width_mm)
    lines, layer = strings, cut.layer[contour]
    groups, inward, outer = [], inset_mm, strings
    for number in range(max(recipe.perimeters, 1) if len(strings) else 0):
        inward = inset_mm + number * recipe.spacing_mm
        lines = shapely.offset_curve(strings, inward, join_style="mitre") if inward else strings
        if number:
            there, place = np.unique(layer, return_inverse=True)
            boxes = shapely.bounds(_by_layer(lines, layer, len(areas))[there])
            room = offset(pieces_in(areas[there], boxes), -(inward - _ASIDE * recipe.width_mm))
            lines = shapely.intersection(lines, room[place])
        else:
            outer = lines
        least_mm = _SHORTEST * recipe.width_mm
        groups.append(Group.of_strings(lines, layer, least_mm, is_inside=number > 0))
    outermost, innermost = (_by_layer(each, layer, len(areas)) for each in (outer, lines))
    return Fringe(groups, outermost, innermost, inward)


def _by_layer(lines: Geometries, layer: Ints, count: int) -> Geometries:
    """Return the lines of each layer as one geometry."""
    found: Geometries = np.full(count, shapely.MultiLineString(), dtype=object)
    parts, origin = shapely.get_parts(lines, return_index=True)
    straight = shapely.get_dimensions(parts) == 1
    order = np.argsort(layer[origin[straight]], kind="stable")
    parts, layers = parts[straight][order], layer[origin[straight]][order]
    filled, group = np.unique(layers, return_inverse=True)
    if len(filled):
        found[filled] = shapely.multilinestrings(parts, indices=group)
    return found


def _strings(
    cut: Cut, samples: Samples, painted: Bools, least_mm: float
) -> tuple[Geometries, Ints]:
    """Return the painted stretches of contours as line strings, and the contour of each."""
    lines: list[Floats] = []
    contours: list[int] = []
    numbers = np.unique(samples.contour[painted])
    begins, ends = (np.searchsorted(samples.contour, numbers, side) for side in ("left", "right"))
    for number, begin, end in zip(numbers.tolist(), begins, ends, strict=True):
        ring = _Ring.of(cut, number)
        for low, high in _spans(
            painted[begin:end], samples.begin[begin:end], samples.end[begin:end], ring, least_mm
        ):
            lines.append(ring.part(low, high))
            contours.append(number)
    sizes = [len(line) for line in lines]
    if not lines:
        return np.zeros(0, object), np.zeros(0, np.int64)
    indices = np.repeat(np.arange(len(lines)), sizes)
    strings = shapely.linestrings(np.concatenate(lines), indices=indices)
    return strings, np.array(contours)


@dataclass(frozen=True)
class _Ring:
    """A contour by arc length."""

    points: Floats
    at: Floats
    closed: bool

    @classmethod
    def of(cls, cut: Cut, number: int) -> _Ring:
        points = cut.points[cut.offsets[number] : cut.offsets[number + 1]]
        closed = bool(cut.closed[number])
        if closed:
            points = np.concatenate([points, points[:1]])
        steps = np.hypot(*np.diff(points, axis=0).T)
        return cls(points, np.concatenate([[0.0], np.cumsum(steps)]), closed)

    @property
    def length(self) -> float:
        return float(self.at[-1])

    def part(self, low: float, high: float) -> Floats:
        """Return the points from `low` to `high`, which may lie beyond the last one."""
        at, points = self.at, self.points
        if self.closed and high > self.length:
            at = np.concatenate([at, at[1:] + self.length])
            points = np.concatenate([points, points[1:]])
        ends = np.column_stack([np.interp([low, high], at, column) for column in points.T])
        inside = (at > low + _SAME_MM) & (at < high - _SAME_MM)
        return np.concatenate([ends[:1], points[inside], ends[1:]])


def _spans(
    painted: Bools, begin: Floats, end: Floats, ring: _Ring, least_mm: float
) -> list[tuple[float, float]]:
    """Join painted samples to spans; short gaps are closed, short spans left out."""
    cuts = np.flatnonzero(painted[1:] != painted[:-1]) + 1
    parts = [part for part in np.split(np.arange(len(painted)), cuts) if painted[part[0]]]
    spans = [(float(begin[part[0]]), float(end[part[-1]])) for part in parts]
    joined = spans[:1]
    for low, high in spans[1:]:
        if low - joined[-1][1] < least_mm:
            joined[-1] = (joined[-1][0], high)
        else:
            joined.append((low, high))
    around = ring.closed and joined and ring.length - joined[-1][1] + joined[0][0] < least_mm
    if around and len(joined) > 1:
        joined[-1] = (joined[-1][0], ring.length + joined[0][1])
        del joined[0]
    return [(low, high) for low, high in joined if high - low >= least_mm]
