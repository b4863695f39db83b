"""Straight strokes across what is hollow below, from something to something."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np
import shapely

from wireprint.layerwise.areas import buffered
from wireprint.layerwise.hatch import strokes

if TYPE_CHECKING:
    import numpy.typing as npt
    from shapely import Geometry

    from wireprint.layerwise.areas import Geometries
    from wireprint.layerwise.hatch import Strokes

    Floats = npt.NDArray[np.float64]
    Bools = npt.NDArray[np.bool_]

#: Bridges are looked for in so many directions, and along the longest edges of the area.
_DIRECTIONS = 12
_EDGES = 2
#: From bridge to bridge, in line widths.
_PITCH = 2.0
#: Directions in which this part of what the best one covers is covered are as good.
_AS_MUCH = 0.95
#: A bridge's end this part of a line's width away from something lies on it.
_HELD = 0.1


def bridged(
    area: Geometry, held: Geometry, width_mm: float, longest_mm: float
) -> tuple[Geometry, float] | None:
    """Find the part of an area that parallel bridges cover.

    Parameters
    ----------
    area
        What wants to be covered.
    held
        What of it something carries.
    width_mm
        Width of a line, mm.
    longest_mm
        Longest stretch between two supports, mm.

    Returns
    -------
    tuple or None
        What lies between bridges both of whose ends are held, and their direction from the x axis,
        radians: that of all directions tried in which they cover the most, the shortest way.
    """
    turns = np.concatenate([np.arange(_DIRECTIONS) * np.pi / _DIRECTIONS, _along_edges(area, held)])
    copies: Geometries = np.full(len(turns), area, dtype=object)
    found = strokes(copies, turns, _PITCH * width_mm, width_mm)
    if not len(found):
        return None
    ends = found.ends(turns, _PITCH * width_mm)
    shapely.prepare(held)
    near: Bools = shapely.dwithin(held, shapely.points(ends), _HELD * width_mm).all(axis=1)
    free = np.full(len(found), np.inf)
    free[near] = shapely.length(shapely.difference(shapely.linestrings(ends[near]), held))
    good = free <= longest_mm
    reach = np.bincount(found.area[good], free[good], len(turns))
    if reach.max() <= 0:
        return None
    longest = np.zeros(len(turns))
    np.maximum.at(longest, found.area[good], free[good])
    # Of those that cover as much, the one with the shortest way across.
    best = int(np.argmin(np.where(reach >= _AS_MUCH * reach.max(), longest, np.inf)))
    own = np.flatnonzero(good & (found.area == best))
    return shapely.intersection(_between(found, ends, own), area), float(turns[best])


def _along_edges(area: Geometry, held: Geometry) -> Floats:
    """Return the directions of the longest edges that nothing holds."""
    loose = shapely.difference(shapely.boundary(area), buffered(held, 1e-6))
    points, index = shapely.get_coordinates(shapely.get_parts(loose), return_index=True)
    same = index[1:] == index[:-1]
    steps = np.diff(points, axis=0)[same]
    longest = steps[np.argsort(-np.hypot(*steps.T), kind="stable")[:_EDGES]]
    turns: Floats = np.arctan2(longest[:, 1], longest[:, 0])
    return turns


def _between(found: Strokes, ends: Floats, own: npt.NDArray[np.intp]) -> Any:
    """Return what lies between those of the strokes that are neighbours."""
    quads = []
    for one in own.tolist():
        beside = own[(found.line[own] == found.line[one] + 1) & (found.low[own] < found.high[one])]
        beside = beside[found.high[beside] > found.low[one]]
        quads += [[*ends[one], *ends[other][::-1]] for other in beside.tolist()]
    return shapely.union_all(shapely.polygons(quads)) if quads else shapely.MultiPolygon()
