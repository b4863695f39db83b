"""Where a layer must be solid: near the model's tops and bottoms."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
import shapely

from wireprint.layerwise.areas import Geometries, islands, offset
from wireprint.layerwise.threads import mapped

if TYPE_CHECKING:
    import numpy.typing as npt

_EMPTY = shapely.MultiPolygon()


def buried(areas: Geometries, bottom: int, top: int) -> Geometries:
    """Return the part of each layer's plane that `bottom` layers below and `top` above cover.

    Parameters
    ----------
    areas
        Area of each layer, shape (K,).
    bottom, top
        Counts of solid layers.

    Returns
    -------
    numpy.ndarray
        Areas, shape (K,); for zero layers on both sides, the areas themselves.
    """
    below = _windows(areas, bottom, shift=-bottom)
    above = _windows(areas, top, shift=1)
    if below is None or above is None:
        both = below if above is None else above
        return areas if both is None else both
    return mapped(shapely.intersection, below, above)


def split(
    inner: Geometries, covered: Geometries, line_mm: float, smallest_mm2: float
) -> tuple[Geometries, Geometries]:
    """Split what the walls leave into solid and sparse fill.

    Parameters
    ----------
    inner
        Area within the walls, shape (N,).
    covered
        For each, what `buried` gives for its layer.
    line_mm
        Width of a line, mm; narrower solid slivers are the walls' business.
    smallest_mm2
        Sparse pieces below this area become solid, mm².

    Returns
    -------
    solid, sparse
        Areas, shape (N,) each.
    """
    sparse = mapped(shapely.intersection, inner, covered)
    sparse = _without_small(sparse, smallest_mm2)
    solid = mapped(shapely.difference, inner, sparse)
    touched = np.flatnonzero(~shapely.is_empty(solid))
    solid[touched] = offset(offset(solid[touched], -line_mm / 2), line_mm / 2)
    return solid, sparse


def _windows(areas: Geometries, count: int, shift: int) -> Geometries | None:
    """Intersect, for each layer k, the layers k + shift … k + shift + count − 1."""
    if count == 0:
        return None
    window = areas
    for reach in range(1, count):
        window = mapped(shapely.intersection, window, _shifted(areas, reach))
    return _shifted(window, shift)


def _shifted(areas: Geometries, by: int) -> Geometries:
    """Put area k + by in place k; nothing where there is no such layer."""
    result: Geometries = np.full(len(areas), _EMPTY, dtype=object)
    low, high = max(0, by), min(len(areas), len(areas) + by)
    result[low - by : high - by] = areas[low:high]
    return result


def _without_small(geometries: Geometries, smallest_mm2: float) -> Geometries:
    parts, origin = islands(geometries)
    large: npt.NDArray[np.bool_] = shapely.area(parts) >= smallest_mm2
    result: Geometries = np.full(len(geometries), _EMPTY, dtype=object)
    filled, group = np.unique(origin[large], return_inverse=True)
    if len(filled):
        result[filled] = shapely.multipolygons(parts[large], indices=group)
    return result
