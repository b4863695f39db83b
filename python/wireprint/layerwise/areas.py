"""What is inside a model at each layer, as polygons."""

from __future__ import annotations

from itertools import pairwise
from typing import TYPE_CHECKING, Any, Protocol

import numpy as np
import shapely

from wireprint import _core
from wireprint.layerwise.threads import mapped

if TYPE_CHECKING:
    import numpy.typing as npt

    from wireprint._core import Mesh, Slices

#: Geometries of shapely, dtype object.
Geometries = np.ndarray[Any, np.dtype[np.object_]]

_EMPTY = shapely.MultiPolygon()


def layer_count(height_mm: float, layer_mm: float) -> int:
    """Layers that a model of this height has: those whose middle lies within it."""
    return int(np.floor(height_mm / layer_mm + 0.5))


def areas(mesh: Mesh, layer_mm: float, resolution_mm: float) -> Geometries:
    """Cut a mesh at the middle of each layer.

    Parameters
    ----------
    mesh
        The model, its lowest point at z = 0.
    layer_mm
        Height of a layer, mm.
    resolution_mm
        How far a simplified contour may leave the exact one, mm.

    Returns
    -------
    numpy.ndarray
        One polygon or multipolygon for each layer, from the lowest, possibly empty.
    """
    count = layer_count(mesh.size_mm[2], layer_mm)
    heights = (np.arange(count, dtype=np.float64) + 0.5) * layer_mm
    return of_slices(_core.slice_mesh(mesh, heights), resolution_mm)


def of_slices(slices: Slices, resolution_mm: float) -> Geometries:
    """Return the area of each slice; open contours enclose none."""
    return of_contours(slices, slices.closed, resolution_mm)


class Contours(Protocol):
    """Contours of many slices; see `Slices`."""

    @property
    def points(self) -> npt.NDArray[np.float64]:
        """Points of all contours, mm, shape (P, 2)."""

    @property
    def offsets(self) -> npt.NDArray[np.int64]:
        """Where each contour's points begin, shape (M + 1,)."""

    @property
    def slice_offsets(self) -> npt.NDArray[np.int64]:
        """Where each slice's contours begin, shape (K + 1,)."""

    @property
    def parent(self) -> npt.NDArray[np.int64]:
        """What directly encloses each contour, shape (M,)."""

    @property
    def depth(self) -> npt.NDArray[np.uint32]:
        """How many contours enclose each one, shape (M,)."""


def of_contours(slices: Contours, which: npt.NDArray[np.bool_], resolution_mm: float) -> Geometries:
    """Return the area that some of the contours enclose in each slice.

    Parameters
    ----------
    slices
        The contours.
    which
        Those that count, shape (M,); all are closed. A hole counts only with what it is in.
    resolution_mm
        How far a simplified contour may leave the exact one, mm.
    """
    sizes = np.diff(slices.offsets)
    usable = which & (sizes >= 3)
    result: Geometries = np.full(len(slices.slice_offsets) - 1, _EMPTY, dtype=object)
    if not usable.any():
        return result
    contours = np.flatnonzero(usable)
    number = np.full(len(sizes), -1)
    number[contours] = np.arange(len(contours))
    of_point = np.repeat(number, sizes)
    rings = shapely.linearrings(slices.points[of_point >= 0], indices=of_point[of_point >= 0])
    rings = simplified(rings, resolution_mm)
    shells = np.where(slices.depth % 2 == 0, np.arange(len(sizes)), slices.parent)[contours]
    # Simplified to a line or a point, a ring is a line string.
    is_ring = shapely.get_type_id(rings) == shapely.GeometryType.LINEARRING
    kept = is_ring & ~shapely.is_empty(rings) & np.isin(shells, contours[is_ring])
    is_hole = shells != contours
    order = np.lexsort((is_hole, shells))
    order = order[kept[order]]
    shell_ids, polygon_of_ring = np.unique(shells[order], return_inverse=True)
    polygons = shapely.polygons(rings[order], indices=polygon_of_ring)
    layers = np.searchsorted(slices.slice_offsets, shell_ids, side="right") - 1
    return _by_layer(sound(polygons), layers, result)


def islands(geometries: Geometries) -> tuple[Geometries, npt.NDArray[np.int64]]:
    """Split each area into connected pieces; return them and the index that each comes from."""
    parts, origin = shapely.get_parts(geometries, return_index=True)
    is_area = (shapely.get_dimensions(parts) == 2) & ~shapely.is_empty(parts)
    return parts[is_area], origin[is_area]


def pieces_in(geometries: Geometries, boxes_mm: npt.NDArray[np.float64]) -> Geometries:
    """Return of each area the connected pieces whose own box meets one.

    Parameters
    ----------
    geometries
        Areas, shape (N,).
    boxes_mm
        The lowest and the highest x and y of each box, as `shapely.bounds` gives them, shape
        (N, 4); nothing meets what is not a number.
    """
    parts, origin = islands(geometries)
    own, other = shapely.bounds(parts), boxes_mm[origin]
    met = ((own[:, :2] <= other[:, 2:]) & (own[:, 2:] >= other[:, :2])).all(axis=1)
    found: Geometries = np.full(len(geometries), _EMPTY, dtype=object)
    there, group = np.unique(origin[met], return_inverse=True)
    if len(there):
        found[there] = shapely.multipolygons(parts[met], indices=group)
    return found


def buffered(geometries: Any, distance_mm: float | npt.NDArray[np.float64], **options: Any) -> Any:
    """Grow areas by a distance, mm, or each by one of its own, as `shapely.buffer` does.

    Notes
    -----
    GEOS may raise the processor's flag for an invalid operation on the way to a sound result, which
    NumPy then reports (github.com/shapely/shapely/issues/1709); each thread has its own setting.
    """
    with np.errstate(invalid="ignore"):
        return shapely.buffer(geometries, distance_mm, **options)


def grown(lines: Geometries, mm: npt.NDArray[np.float64]) -> Geometries:
    """Grow lines by a distance each, mm.

    Where lines meet they are parted, and to grow dozens of pieces at once that lie on each other
    takes long: those that go on are joined, and each piece is grown by itself.
    """
    parts, origin = shapely.get_parts(shapely.line_merge(lines), return_index=True)
    areas, ends = buffered(parts, mm[origin]), np.searchsorted(origin, np.arange(len(lines) + 1))
    found: Geometries = np.full(len(lines), _EMPTY, dtype=object)
    for number, (begin, end) in enumerate(pairwise(ends.tolist())):
        if end > begin:
            found[number] = shapely.union_all(areas[begin:end])
    return found


def offset(geometries: Geometries, distance_mm: float) -> Geometries:
    """Grow (or, below 0, shrink) each area by a distance, mm, with sharp corners."""
    result = geometries.copy()
    filled = np.flatnonzero(~shapely.is_empty(geometries))
    result[filled] = mapped(
        lambda part: buffered(part, distance_mm, join_style="mitre", mitre_limit=2.0),
        geometries[filled],
    )
    return result


def simplified(geometries: Geometries, resolution_mm: float) -> Geometries:
    """Leave out points whose absence moves a line by less than the resolution, mm."""
    return mapped(
        lambda part: shapely.simplify(part, resolution_mm, preserve_topology=False), geometries
    )


def sound(polygons: Geometries) -> Geometries:
    """Mend what simplifying made cross itself."""
    broken = ~mapped(shapely.is_valid, polygons)
    polygons[broken] = buffered(polygons[broken], 0.0)
    return polygons


def _by_layer(
    polygons: Geometries, layers: npt.NDArray[np.int64], result: Geometries
) -> Geometries:
    parts, origin = islands(polygons)
    filled, group = np.unique(layers[origin], return_inverse=True)
    order = np.argsort(group, kind="stable")
    if len(filled):
        result[filled] = shapely.multipolygons(parts[order], indices=group[order])
    return sound(result)
