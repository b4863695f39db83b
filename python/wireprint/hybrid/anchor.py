"""Lines begin and end on something: the layer below, wire, or lines of their own layer."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np
import shapely

from wireprint.layerwise.route import Route

if TYPE_CHECKING:
    import numpy.typing as npt

    from wireprint.hybrid.cut import Cut

    Floats = npt.NDArray[np.float64]
    Ints = npt.NDArray[np.int64]
    Bools = npt.NDArray[np.bool_]

#: What is this part of a strand away, in plan, touches on the same layer.
_TOUCH_BESIDE = 0.98
#: The same on a neighbouring layer, as a part of the farthest that still touches.
_TOUCH = 0.94
#: The same, as a part of a strand, for the rim of a slab, which may stray by half its diameter.
_TOUCH_RIM = 0.45
#: A line that begins or ends in the air is searched for support in steps of this part of a strand.
_STEP = 0.4
#: An outer wall is at most this part of a strand behind the surface, with any inset.
_OUTER = 0.6
#: No model is as wide, mm.
_APART_MM = 1e4
#: Layers that share a tree.
_TOGETHER = 32
#: Most times that all lines are gone through.
_PASSES = 24
#: What is left of a line must be this many strands long.
_LEAST = 1.5


class Touchable:
    """What lines may begin on besides other lines: contours, and rims of slabs.

    Trees of it are made for the layers that are asked for, and kept.
    """

    def __init__(self, cut: Cut, rims: tuple[Floats, Ints], strand_mm: float) -> None:
        """Take the layers, and other segments that are there before them.

        Parameters
        ----------
        cut
            The layers; the contours at the tops of slabs are there before the layers above them.
        rims
            Other segments that are, shape (S, 2, 2), mm, and the layer at whose height they lie.
        strand_mm
            Diameter of a strand, mm.
        """
        self.strand_mm = strand_mm
        # Strands touch whose centrelines are one strand apart: in plan less, by a layer's height.
        thickest_mm = min(float(cut.thickness.max(initial=0.0)), strand_mm)
        self.touch_mm = _TOUCH * math.sqrt(strand_mm**2 - thickest_mm**2)
        segments, contour = _segments(cut)
        layer = cut.layer[contour]
        # The rims of slabs count as lines of the layer at that height; a bed has its own.
        is_rim, on_bed = cut.is_last()[layer], layer == 0
        self.contours = _Layers(segments, layer)
        self.rims = _Layers(
            np.concatenate([segments[is_rim], segments[on_bed], rims[0]]),
            np.concatenate([layer[is_rim], layer[on_bed] - 1, rims[1]]),
        )


def anchored(route: Route, touchable: Touchable, loose: tuple[Floats, Ints]) -> Route:
    """Mend each line that begins or ends in the air: the head leaves its end at once.

    Parameters
    ----------
    route
        Lines in printing order.
    touchable
        What they may begin on besides each other.
    loose
        Places where nothing holds a line, whatever seems to, shape (P, 2), mm, and their layers.

    Returns
    -------
    Route
        The same lines, turned round or parted where that lets them begin on something, cut off
        behind the last place that holds them. Outer walls that nothing holds come last on their
        layers.
    """
    if len(route.offsets) < 2:
        return route
    # What is cut off may have held what is printed later.
    waits, waiting = True, len(route.offsets)
    places = _Layers(np.stack([loose[0], loose[0]], axis=1), loose[1])
    for _ in range(_PASSES):
        mended, late = _mended(route, _Ground(route, touchable, places, waits=waits))
        if mended is route:
            break
        # Where the order helps no more, what nothing holds is done without.
        still, waiting = waits and 0 < late < waiting, late
        # A line that waits behind its layer already changes nothing, and nor would the next pass.
        settled = still == waits and _same(mended, route)
        waits, route = still, mended
        if settled:
            break
    return route


def _same(one: Route, other: Route) -> bool:
    """Tell whether two routes lay the same lines in the same order."""
    return np.array_equal(one.offsets, other.offsets) and np.array_equal(one.points, other.points)


def _mended(route: Route, ground: _Ground) -> tuple[Route, int]:
    """Return the mended lines, the same object if there is nothing to mend, and how many wait."""
    begins, ends = route.offsets[:-1], route.offsets[1:]
    lines = np.arange(len(begins))
    loose = ~ground.holds(route.points[begins, :2], lines)
    loose |= ~ground.holds(route.points[ends - 1, :2], lines, barely=True)
    if not loose.any():
        return route, 0
    aloft = np.flatnonzero(loose)
    left = ground.mended([route.points[begins[n] : ends[n]] for n in aloft], aloft)
    pieces: list[tuple[Floats, int]] = []
    layers: list[Ints] = []
    late: list[tuple[Floats, int]] = []
    changed, waiting = False, 0
    for line in lines:
        points, layer = route.points[begins[line] : ends[line]], ground.layer[line]
        group = int(route.group[line])
        parts = left[int(line)] if loose[line] else [points]
        if parts is None:
            late.append((points, group))
            waiting += 1
            parts = []
        changed |= len(parts) != 1 or not np.array_equal(parts[0], points)
        laid = [(part, group) for part in parts]
        if line == lines[-1] or ground.layer[line + 1] != layer:
            laid, late = [*laid, *late], []
        pieces += laid
        layers += [np.full(len(part), layer) for part, _ in laid]
    if not (pieces and changed):
        return route, 0
    offsets = np.concatenate([[0], np.cumsum([len(part) for part, _ in pieces])]).astype(np.int64)
    points = np.concatenate([part for part, _ in pieces])
    groups = np.array([group for _, group in pieces])
    return Route(points, np.concatenate(layers), offsets, groups), waiting


class _Ground:
    """What is there before each line is printed, and what will be."""

    def __init__(self, route: Route, touchable: Touchable, loose: _Layers, *, waits: bool) -> None:
        #: Whether what nothing holds waits for the rest of its layer.
        self.waits = waits
        self.layer = route.layer[route.offsets[:-1]]
        line = np.repeat(np.arange(len(self.layer)), np.diff(route.offsets))
        own = np.flatnonzero(line[1:] == line[:-1])
        self.strand_mm, self.touch_mm = touchable.strand_mm, touchable.touch_mm
        self.order = line[own]
        ends = np.stack([route.points[own, :2], route.points[own + 1, :2]], axis=1)
        self.lines = _Layers(ends, self.layer[line[own]])
        self.contours, self.rims = touchable.contours, touchable.rims
        self.loose = loose

    def holds(self, points: Floats, line: Ints, *, barely: bool = False) -> Bools:
        """Tell which points lie on what is there before the lines of these numbers.

        A rim must be so near that it holds wherever its strand strays to, or only `barely`.
        """
        held = np.zeros(len(points), dtype=bool)
        layer, touch = self.layer[line], self.touch_mm
        beside = _TOUCH_BESIDE * self.strand_mm
        held[self.lines.near(points, layer - 1, touch)[0]] = True
        asked, found = self.lines.near(points, layer, beside)
        held[asked[self.order[found] < line[asked]]] = True
        rim = touch if barely else min(_TOUCH_RIM * self.strand_mm, touch)
        held[self.rims.near(points, layer - 1, rim)[0]] = True
        held[self.loose.near(points, layer, self.strand_mm)[0]] = False
        return held

    def mended(self, lines: list[Floats], numbers: Ints) -> dict[int, list[Floats] | None]:
        """Return what is left of lines, by their numbers, in parts that begin on something.

        None: nothing holds it yet, but the other lines of its layer may.
        """
        strings = [shapely.LineString(points[:, :2]) for points in lines]
        step_mm = _STEP * self.strand_mm
        along = [np.linspace(0.0, s.length, int(s.length / step_mm) + 2) for s in strings]
        sizes = np.array([len(each) for each in along])
        at = shapely.line_interpolate_point(np.repeat(strings, sizes), np.concatenate(along))
        places, line = shapely.get_coordinates(at), np.repeat(numbers, sizes)
        held, met = self.holds(places, line), self.holds(places, line, barely=True)
        cuts = np.cumsum(sizes)[:-1]
        each = zip(along, *(np.split(all_, cuts) for all_ in (places, held, met)), strict=True)
        return {
            number: self._held(points, number, *found)
            for points, number, found in zip(lines, numbers.tolist(), each, strict=True)
        }

    def _held(
        self, points: Floats, line: int, along: Floats, places: Floats, held: Bools, met: Bools
    ) -> list[Floats] | None:
        """Return what is left of a line of which it is known where it is held, and barely so."""
        if not held.any():
            held = met
        if not held.any():
            # It may lean on what comes later; only outer walls cannot be done without.
            return None if self.waits or self._is_outer(places, line) else []
        first, last = np.flatnonzero(met)[[0, -1]]
        path = _Path(points)
        if held[first]:
            return path.between(along[first], along[last], self._least_mm)
        if held[last]:
            return path.between(along[last], along[first], self._least_mm)
        middle = along[np.flatnonzero(held)[0]]
        return [
            *path.between(middle, along[last], self._least_mm),
            *path.between(middle, along[first], self._least_mm),
        ]

    def _is_outer(self, places: Floats, line: int) -> bool:
        """Tell whether most of a line is nearer to its layer's contours than a second wall is."""
        layer = np.full(len(places), self.layer[line])
        own = np.unique(self.contours.near(places, layer, _OUTER * self.strand_mm)[0])
        return 2 * len(own) > len(places)

    @property
    def _least_mm(self) -> float:
        return _LEAST * self.strand_mm


class _Path:
    """A line by arc length."""

    def __init__(self, points: Floats) -> None:
        steps = np.hypot(*np.diff(points[:, :2], axis=0).T)
        self.points = points
        self.at = np.concatenate([[0.0], np.cumsum(steps)])

    def between(self, begin: float, end: float, least_mm: float) -> list[Floats]:
        """Return the part from one arc length to another, forwards or backwards, if long enough."""
        low, high = min(begin, end), max(begin, end)
        if high - low < least_mm:
            return []
        ends = np.column_stack([np.interp([low, high], self.at, c) for c in self.points.T])
        inside = (self.at > low) & (self.at < high)
        part = np.concatenate([ends[:1], self.points[inside], ends[1:]])
        return [part if begin <= end else part[::-1]]


class _Layers:
    """Segments on many layers, found by layer and place."""

    def __init__(self, segments: Floats, layer: Ints) -> None:
        # One tree for many layers, which lie side by side in it; those never asked for have none.
        self.layer = layer
        self.segments = segments
        self.order = np.argsort(layer // _TOGETHER, kind="stable")
        self.blocks = (layer // _TOGETHER)[self.order]
        self.trees: dict[int, tuple[shapely.STRtree, Ints]] = {}

    def near(self, points: Floats, layer: Ints, distance_mm: float) -> tuple[Ints, Ints]:
        """Return pairs of a point and a segment on the layer asked for that are near enough."""
        asked, found = [np.zeros(0, np.int64)], [np.zeros(0, np.int64)]
        places = shapely.points(_aside(points, layer))
        blocks = layer // _TOGETHER
        for block in np.unique(blocks).tolist():
            tree, numbers = self._tree(block)
            own = np.flatnonzero(blocks == block)
            at, hit = tree.query(places[own], predicate="dwithin", distance=distance_mm)
            asked.append(own[at])
            found.append(numbers[hit])
        return np.concatenate(asked), np.concatenate(found)

    def _tree(self, block: int) -> tuple[shapely.STRtree, Ints]:
        """Return the tree of a block of layers, and the number of each segment in it."""
        if block not in self.trees:
            begin, end = np.searchsorted(self.blocks, [block, block + 1])
            numbers = self.order[begin:end]
            lines = shapely.linestrings(_aside(self.segments[numbers], self.layer[numbers]))
            self.trees[block] = shapely.STRtree(lines), numbers
        return self.trees[block]


def _aside(points: Floats, layer: Ints) -> Floats:
    """Move points of shape (N, …, 2) to where their layer lies in the plane."""
    moved = points.copy()
    moved[..., 0] += (_APART_MM * layer).reshape(-1, *[1] * (points.ndim - 2))
    return moved


def _segments(cut: Cut) -> tuple[Floats, Ints]:
    """Return the segments of all contours, shape (S, 2, 2), and the contour of each."""
    following, lengths = cut.steps
    kept = np.flatnonzero(lengths > 0)
    contour = np.repeat(np.arange(len(cut.closed)), np.diff(cut.offsets))
    return np.stack([cut.points[kept], cut.points[following[kept]]], axis=1), contour[kept]
