"""Where a layer must be solid: near the model's tops and bottoms."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
import shapely

from wireprint.layerwise.areas import Geometries, islands, offset
from wireprint.layerwise.threads import mapped

if TYPE_CHECKING:
    import numpy.typing as npt

_EMPTY = shapely.MultiPolygon()


@dataclass(frozen=True)
class Shells:
    """What decides between solid and sparse."""

    #: Solid layers above a bottom and below a top.
    bottom: int
    top: int
    #: Width of a line, mm; narrower solid slivers are the walls' business.
    line_mm: float
    #: By how much solid areas reach over sparse ones, mm.
    anchor_mm: float
    #: Sparse pieces below this area become solid, mm².
    smallest_mm2: float


def split(
    inner: Geometries,
    layer: npt.NDArray[np.int64],
    areas: Geometries,
    shells: Shells,
    below: Geometries | None = None,
) -> tuple[Geometries, Geometries]:
    """Split what the walls leave into solid and sparse fill.

    Parameters
    ----------
    inner
        Area within the walls of each island, shape (N,).
    layer
        Layer of each island, shape (N,).
    areas
        What each layer covers, shape (K,).
    shells
        How many layers are solid, and what is too small for either fill.
    below
        What of each layer carries those above, shape (K,); default: all that it covers.

    Returns
    -------
    solid, sparse
        Areas, shape (N,) each.
    """
    sparse = inner.copy()
    below = areas if below is None else below
    for carrying, steps in (
        (below, range(-shells.bottom, 0)),
        (areas, range(1, shells.top + 1)),
    ):
        shapely.prepare(carrying)
        for step in steps:
            _cover(sparse, layer + step, carrying)
    sparse = _without_small(sparse, shells.smallest_mm2)
    solid: Geometries = np.full(len(inner), _EMPTY, dtype=object)
    change = shapely.area(inner) - shapely.area(sparse) > shells.line_mm**2
    whole = change & shapely.is_empty(sparse)
    part = np.flatnonzero(change & ~whole)
    solid[whole] = inner[whole]
    rest = mapped(shapely.difference, inner[part], sparse[part])
    # Slivers go; what stays reaches over the sparse fill that holds its ends.
    rest = offset(offset(rest, -shells.line_mm / 2), shells.line_mm / 2 + shells.anchor_mm)
    solid[part] = mapped(_common, rest, inner[part])
    sparse[part] = mapped(shapely.difference, inner[part], rest)
    return solid, sparse


def _cover(sparse: Geometries, layer: npt.NDArray[np.int64], areas: Geometries) -> None:
    """Keep, in place, what a layer's area covers; nothing where there is no such layer."""
    left = np.flatnonzero(~shapely.is_empty(sparse))
    exists = (layer[left] >= 0) & (layer[left] < len(areas))
    sparse[left[~exists]] = _EMPTY
    left = left[exists]
    # Most areas lie well within their neighbours, which prepared geometries tell at a glance; it
    # is asked in one thread, since a prepared geometry builds its index when first asked.
    cut = left[~shapely.contains_properly(areas[layer[left]], sparse[left])]
    sparse[cut] = mapped(_common, sparse[cut], areas[layer[cut]])


def _common(areas: Geometries, others: Geometries) -> Geometries:
    """Return what areas have in common with others, made sound where rims cross by rounding."""
    try:
        found: Geometries = shapely.intersection(areas, others)
    except shapely.errors.GEOSException:
        sound = (shapely.make_valid(each) for each in (areas, others))
        found = shapely.intersection(*sound)
    return found


def _without_small(geometries: Geometries, smallest_mm2: float) -> Geometries:
    parts, origin = islands(geometries)
    large: npt.NDArray[np.bool_] = shapely.area(parts) >= smallest_mm2
    result: Geometries = np.full(len(geometries), _EMPTY, dtype=object)
    filled, group = np.unique(origin[large], return_inverse=True)
    if len(filled):
        result[filled] = shapely.multipolygons(parts[large], indices=group)
    return result
