"""Lines begin and end on something: the layer below, wire, or lines of their own layer."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from wireprint._core import Touchable
from wireprint.layerwise.route import Route

if TYPE_CHECKING:
    import numpy.typing as npt

    from wireprint.hybrid.cut import Cut

    Floats = npt.NDArray[np.float64]
    Ints = npt.NDArray[np.int64]


def touchable_of(cut: Cut, rims: tuple[Floats, Ints], strand_mm: float) -> Touchable:
    """Return what lines may begin on besides other lines: contours, and rims of slabs.

    Parameters
    ----------
    cut
        The layers; the contours at the tops of slabs are there before the layers above them.
    rims
        Other segments that are, shape (S, 2, 2), mm, and the layer at whose height they lie.
    strand_mm
        Diameter of a strand, mm.
    """
    segments, contour = _segments(cut)
    layer = cut.layer[contour]
    # The rims of slabs count as lines of the layer at that height; a bed has its own.
    is_rim, on_bed = cut.is_last()[layer], layer == 0
    along = [segments[is_rim], segments[on_bed], rims[0]]
    at = [layer[is_rim], layer[on_bed] - 1, rims[1]]
    thickest_mm = float(cut.thickness.max(initial=0.0))
    there = np.concatenate(along), np.concatenate(at)
    return Touchable((segments, layer), there, strand_mm, thickest_mm)


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
    given = route.points, route.layer, route.offsets, route.group
    return Route(*touchable.anchored(given, loose))


def _segments(cut: Cut) -> tuple[Floats, Ints]:
    """Return the segments of all contours, shape (S, 2, 2), and the contour of each."""
    following, lengths = cut.steps
    kept = np.flatnonzero(lengths > 0)
    contour = np.repeat(np.arange(len(cut.closed)), np.diff(cut.offsets))
    return np.stack([cut.points[kept], cut.points[following[kept]]], axis=1), contour[kept]
