"""The lines of a region's layers: walls along what is painted, fill where they close."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

import numpy as np
import shapely

from wireprint.layerwise.areas import Geometries, islands, of_contours, offset
from wireprint.layerwise.hatch import hatched
from wireprint.layerwise.lines import Lines
from wireprint.layerwise.route import routed
from wireprint.layerwise.shells import split
from wireprint.layerwise.walls import walls

if TYPE_CHECKING:
    import numpy.typing as npt

    from wireprint.hybrid.cut import Cut, Samples
    from wireprint.hybrid.runs import Runs
    from wireprint.layerwise.recipe import Recipe
    from wireprint.layerwise.route import Route

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
class _Group:
    """Lines that are printed before those of the next group on the same place of a layer."""

    lines: Lines
    layer: Ints
    #: What each lies on: the number of an island, or −1.
    place: Ints
    #: Whether they lie behind the outer wall.
    is_inside: bool


def route(cut: Cut, samples: Samples, runs: Runs, recipe: Recipe, inset_mm: float) -> Route | None:
    """Lay the lines of all runs and bring them into printing order; None where there are none.

    The outer walls are group 0, all that lies behind them is group 1.

    Parameters
    ----------
    cut, samples, runs
        The layers, and what of them is painted.
    recipe
        Widths and counts.
    inset_mm
        From the model's surface to the centre of the outer wall, mm.
    """
    whole = _whole_contours(cut, samples, runs)
    areas = of_contours(cut, cut.closed, recipe.resolution_mm)
    filled = _in_whole_islands(cut, whole)
    fringe = _fringe(cut, samples, runs, filled, areas, recipe, inset_mm)
    groups = [*_islands(cut, filled, areas, recipe, inset_mm), *fringe]
    groups = [group for group in groups if len(group.lines)]
    if not groups:
        return None
    return _routed(groups, cut.z, recipe)


def _routed(groups: list[_Group], z: Floats, recipe: Recipe) -> Route:
    """Order lines by layer, and on each by place and group."""
    keys = [np.column_stack([group.layer, group.place]) for group in groups]
    places, owners = np.unique(np.concatenate(keys), axis=0, return_inverse=True)
    parts = np.split(owners.reshape(-1), np.cumsum([len(key) for key in keys])[:-1])
    lines = [
        Lines(group.lines.points, group.lines.offsets, owner, group.lines.closed)
        for group, owner in zip(groups, parts, strict=True)
    ]
    found = routed(lines, places[:, 0], z, recipe.seam_gap_mm)
    inside = np.array([group.is_inside for group in groups])
    return replace(found, group=inside[found.group].astype(np.int64))


def _whole_contours(cut: Cut, samples: Samples, runs: Runs) -> Bools:
    """Tell which contours are painted all around."""
    missing = np.bincount(samples.contour, runs.of_sample < 0, len(cut.closed))
    there = np.bincount(samples.contour, minlength=len(cut.closed))
    whole: Bools = cut.closed & (there > 0) & (missing == 0)
    return whole


def _in_whole_islands(cut: Cut, whole: Bools) -> Bools:
    """Tell which contours bound an island whose contours are all painted all around."""
    number = np.arange(len(whole))
    shell = np.where(cut.depth % 2 == 0, number, cut.parent)
    shell = np.where(shell < 0, number, shell)
    broken = np.bincount(shell, ~whole, len(whole)) > 0
    return whole & ~broken[shell]


def _islands(
    cut: Cut, filled: Bools, areas: Geometries, recipe: Recipe, inset_mm: float
) -> list[_Group]:
    """Walls, solid and sparse fill of whole islands."""
    pieces, layer = islands(of_contours(cut, filled, recipe.resolution_mm))
    if not len(pieces):
        return []
    laid = walls(pieces, recipe.perimeters, inset_mm, recipe.spacing_mm, recipe.overlap_mm)
    solid, sparse = split(laid.inner, layer, areas, recipe.shells)
    turn = np.where(layer % 2 == 0, np.pi / 4, -np.pi / 4)
    # From the outside in: the outer wall stands on a contour, the others lean on it.
    groups = list(reversed(laid.lines))
    outer = bool(groups)
    width, spacing = recipe.width_mm, recipe.spacing_mm
    groups.append(hatched(solid, turn, spacing, width, recipe.solid_link_mm))
    if recipe.infill_density > 0:
        wide = spacing / recipe.infill_density
        groups.append(hatched(sparse, turn, wide, width, recipe.link_mm))
    return [
        _Group(lines, layer[lines.owner], lines.owner, is_inside=not (outer and number == 0))
        for number, lines in enumerate(groups)
    ]


def _fringe(
    cut: Cut,
    samples: Samples,
    runs: Runs,
    filled: Bools,
    areas: Geometries,
    recipe: Recipe,
    inset_mm: float,
) -> list[_Group]:
    """Walls along stretches of contours, and along whole ones of islands that are not whole."""
    painted = (runs.of_sample >= 0) & ~filled[samples.contour]
    strings, contour = _strings(cut, samples, painted, _SHORTEST * recipe.width_mm)
    if not len(strings):
        return []
    layer = cut.layer[contour]
    groups = []
    for number in range(max(recipe.perimeters, 1)):
        inward = inset_mm + number * recipe.spacing_mm
        lines = shapely.offset_curve(strings, inward, join_style="mitre") if inward else strings
        if number:
            room = offset(areas, -(inward - _ASIDE * recipe.width_mm))
            lines = shapely.intersection(lines, room[layer])
        least_mm = _SHORTEST * recipe.width_mm
        groups.append(_open_lines(lines, layer, least_mm, is_inside=number > 0))
    return groups


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


def _open_lines(lines: Geometries, layer: Ints, least_mm: float, *, is_inside: bool) -> _Group:
    """Return line strings, and pieces of them, as open lines."""
    merged = shapely.line_merge(lines)
    parts, origin = shapely.get_parts(merged, return_index=True)
    long = (shapely.get_dimensions(parts) == 1) & (shapely.length(parts) >= least_mm)
    parts, origin = parts[long], origin[long]
    points, index = shapely.get_coordinates(parts, return_index=True)
    sizes = np.bincount(index, minlength=len(parts))
    offsets = np.concatenate([[0], np.cumsum(sizes)])
    place = np.full(len(origin), -1)
    return _Group(Lines(points, offsets, origin, closed=False), layer[origin], place, is_inside)
