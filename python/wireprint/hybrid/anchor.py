"""Lines begin on something: on the layer below, on wire, or on lines of their own layer."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
import shapely

from wireprint.layerwise.route import Route

if TYPE_CHECKING:
    import numpy.typing as npt

    from wireprint.hybrid.cut import Cut

    Floats = npt.NDArray[np.float64]
    Ints = npt.NDArray[np.int64]

#: What is this part of a strand away still touches.
_TOUCH = 0.9
#: A line that begins in the air is searched for support in steps of this part of a strand.
_STEP = 0.4
#: Order of what never counts on its own layer.
_NEVER = np.iinfo(np.int64).max


def anchored(route: Route, cut: Cut, strand_mm: float) -> Route:
    """Turn, or part, each line that begins in the air so that it begins on something.

    Parameters
    ----------
    route
        Lines in printing order.
    cut
        The layers; the contours at the tops of slabs are there before the layers above them.
    strand_mm
        Diameter of a strand, mm.

    Returns
    -------
    Route
        The same lines. One that has no support anywhere stays as it is.
    """
    ground = _Ground(route, cut, strand_mm)
    starts = route.offsets[:-1]
    loose = np.flatnonzero(~ground.holds(route.points[starts, :2], np.arange(len(starts))))
    if not len(loose):
        return route
    pieces: list[Floats] = []
    layers: list[Ints] = []
    is_loose = np.zeros(len(starts), dtype=bool)
    is_loose[loose] = True
    for line, (begin, end) in enumerate(zip(starts, route.offsets[1:], strict=True)):
        points = route.points[begin:end]
        parts = ground.parted(points, line) if is_loose[line] else [points]
        pieces += parts
        layers += [np.full(len(part), route.layer[begin]) for part in parts]
    offsets = np.concatenate([[0], np.cumsum([len(part) for part in pieces])])
    return Route(np.concatenate(pieces), np.concatenate(layers), offsets)


class _Ground:
    """What is there before each line is printed."""

    def __init__(self, route: Route, cut: Cut, strand_mm: float) -> None:
        self.layer = route.layer[route.offsets[:-1]]
        line = np.repeat(np.arange(len(self.layer)), np.diff(route.offsets))
        own = np.flatnonzero(line[1:] == line[:-1])
        # The rims of slabs count as lines of the layer at that height; a bed has its own.
        ends, contour = _segments(cut)
        layer = cut.layer[contour]
        rims, on_bed = cut.is_last()[layer], layer == 0
        segments = [
            np.stack([route.points[own, :2], route.points[own + 1, :2]], axis=1),
            ends[rims],
            ends[on_bed],
        ]
        self.layers = np.concatenate([self.layer[line[own]], layer[rims], layer[on_bed] - 1])
        self.order = np.full(len(self.layers), _NEVER)
        self.order[: len(own)] = line[own]
        self.tree = shapely.STRtree(shapely.linestrings(np.concatenate(segments)))
        self.touch_mm = _TOUCH * strand_mm
        self.step_mm = _STEP * strand_mm

    def holds(self, points: Floats, line: Ints) -> npt.NDArray[np.bool_]:
        """Tell which points lie on what is there before the lines of these numbers."""
        asked, found = self.tree.query(
            shapely.points(points), predicate="dwithin", distance=self.touch_mm
        )
        own, below = self.layer[line[asked]], self.layers[found]
        earlier = (below == own) & (self.order[found] < line[asked])
        held = np.zeros(len(points), dtype=bool)
        held[asked[(below == own - 1) | earlier]] = True
        return held

    def parted(self, points: Floats, line: int) -> list[Floats]:
        """Return the parts of a line, from the first place that holds it to either end."""
        string = shapely.LineString(points[:, :2])
        count = int(string.length / self.step_mm) + 1
        along = np.linspace(0.0, string.length, count + 1)
        places = shapely.get_coordinates(shapely.line_interpolate_point(string, along))
        held = np.flatnonzero(self.holds(places, np.full(len(places), line)))
        if not len(held):
            return [points]
        if held[-1] == count:
            return [points[::-1]]
        at = np.append(places[held[0]], points[0, 2])
        steps = np.hypot(*np.diff(points[:, :2], axis=0).T)
        before = int(np.searchsorted(np.cumsum(steps), along[held[0]])) + 1
        return [np.vstack([at, points[before:]]), np.vstack([at, points[:before][::-1]])]


def _segments(cut: Cut) -> tuple[Floats, Ints]:
    """Return the segments of all contours, shape (S, 2, 2), and the contour of each."""
    following, lengths = cut.steps()
    kept = np.flatnonzero(lengths > 0)
    contour = np.repeat(np.arange(len(cut.closed)), np.diff(cut.offsets))
    return np.stack([cut.points[kept], cut.points[following[kept]]], axis=1), contour[kept]
