"""Where the head cannot print layers because wire of the same slab stands there already."""

from __future__ import annotations

from itertools import pairwise
from typing import TYPE_CHECKING

import numpy as np
import shapely

from wireprint.layerwise.areas import buffered

if TYPE_CHECKING:
    import numpy.typing as npt

    from wireprint.hybrid.cut import Cut, Samples
    from wireprint.layerwise.areas import Geometries

    Floats = npt.NDArray[np.float64]
    Ints = npt.NDArray[np.int64]
    Bools = npt.NDArray[np.bool_]

#: Every so many points along a contour stand for all where the wire has its full height.
_SPARSE = 4
#: A circle's polygon lies within it by less than this part of its radius.
_ROUND = 1.02
_QUARTER = 4
#: Corners are left out that stray less, mm.
_FINE_MM = 0.02
#: Contours lie so far apart on the line that all of them are unrolled on, mm.
_APART_MM = 1e6


def beside_wire(
    cut: Cut, samples: Samples, painted: Bools, slabs: Ints, reach_mm: Floats, tip_mm: float
) -> Geometries:
    """Return what the head's tip must keep clear of in each slab.

    Parameters
    ----------
    cut, samples
        The layers.
    painted
        Which samples are layers, shape (S,); all others are wire.
    slabs
        Slabs that are asked for; of all others nothing is told.
    reach_mm
        For each slab, how far a strand as high as the slab bars a head whose tip is a point, mm.
    tip_mm
        Radius of the tip, mm.

    Notes
    -----
    A zigzag begins at a region's end with a stroke that leans away from it as steeply as the head
    allows: wire some way along the contour is no higher than what bars the head at that distance.
    """
    found: Geometries = np.full(len(reach_mm), shapely.MultiPolygon(), dtype=object)
    if not len(slabs):
        return found
    far = _along_to_painted(samples, painted, cut.closed)
    layer = cut.layer[samples.contour]
    slab = cut.slab[layer]
    is_end = (cut.is_last() | np.append(True, cut.is_last()[:-1]))[layer]
    number = np.arange(len(painted))
    chosen = (
        ~painted
        & is_end
        & np.isin(slab, slabs)
        & ((far < reach_mm[slab]) | (number % _SPARSE == 0))
    )
    radius = tip_mm + np.minimum(far[chosen], reach_mm[slab[chosen]])
    places = shapely.points(samples.middle[chosen, :2])
    discs = buffered(places, _ROUND * radius, quad_segs=_QUARTER)
    order = np.argsort(slab[chosen], kind="stable")
    ends = np.searchsorted(slab[chosen][order], np.arange(len(reach_mm) + 1))
    for row, (low, high) in enumerate(pairwise(ends.tolist())):
        found[row] = shapely.simplify(shapely.union_all(discs[order[low:high]]), _FINE_MM)
    return found


def _along_to_painted(samples: Samples, painted: Bools, closed: Bools) -> Floats:
    """Return how far along its contour each sample is from the nearest painted one, mm."""
    lengths = np.zeros(len(closed))
    np.maximum.at(lengths, samples.contour, samples.end)
    # All contours on one line, each with room for what is painted a lap before and after.
    begins = np.cumsum(3 * lengths + _APART_MM)
    at = begins[samples.contour] + (samples.begin + samples.end) / 2
    lap = lengths[samples.contour[painted]]
    around = closed[samples.contour[painted]]
    there = at[painted]
    # Three runs that are in order already.
    laps = [there, (there - lap)[around], (there + lap)[around]]
    marks = np.sort(np.concatenate(laps), kind="stable")
    if not len(marks):
        return np.full(len(at), np.inf)
    behind = np.searchsorted(marks, at)
    before, after = marks[np.maximum(behind - 1, 0)], marks[np.minimum(behind, len(marks) - 1)]
    far: Floats = np.minimum(np.abs(at - before), np.abs(after - at))
    return far
