"""Surfaces of implicit functions, by marching tetrahedra.

Source: Doi and Koide, An efficient method of triangulating equi-valued surfaces by using
tetrahedral cells, IEICE Transactions E74, 1991.
"""

from __future__ import annotations

from itertools import permutations
from typing import TYPE_CHECKING, Final

import numpy as np

if TYPE_CHECKING:
    from collections.abc import Callable

    import numpy.typing as npt

    Floats = npt.NDArray[np.float64]
    Ints = npt.NDArray[np.int64]

#: Share of a grid edge that a vertex keeps from its ends, so that no facet degenerates.
_MARGIN: Final = 0.02


def surface(
    function: Callable[[Floats, Floats, Floats], Floats],
    low: tuple[float, float, float],
    high: tuple[float, float, float],
    step: float,
) -> Floats:
    """Triangulate where a function of x, y and z is 0, outward from where it is negative.

    Parameters
    ----------
    function
        Takes three arrays that broadcast; where it is negative on the box' sides, the surface is
        open there.
    low, high
        Corners of the box.
    step
        Edge of the cubes that the box is cut into, each into six tetrahedra.

    Returns
    -------
    ndarray
        Corners of the facets, float64 of shape (M, 3, 3).
    """
    axes = [np.arange(a, b + step, step) for a, b in zip(low, high, strict=True)]
    values = function(*np.meshgrid(*axes, indexing="ij", sparse=True))
    shape = values.shape
    strides = np.array([shape[1] * shape[2], shape[2], 1])
    cubes = np.arange(values.size).reshape(shape)[:-1, :-1, :-1].ravel()
    value = values.ravel()
    corners = np.array(list(np.ndindex(2, 2, 2))) @ strides
    inside = value[cubes[:, None] + corners] < 0
    cubes = cubes[inside.any(1) & ~inside.all(1)]
    # Kuhn's six tetrahedra: from one corner of the cube to the opposite one, axis by axis.
    paths = np.array([np.cumsum([0, *order]) for order in permutations(strides)])
    tetrahedra = (cubes[:, None, None] + paths).reshape(-1, 4)
    edges = _crossed_edges(tetrahedra, value[tetrahedra] < 0)
    nodes = np.stack(np.unravel_index(np.arange(values.size), shape), -1)
    return _triangles(edges, nodes * step + np.array([axis[0] for axis in axes]), value)


def _crossed_edges(tetrahedra: Ints, inside: npt.NDArray[np.bool_]) -> Ints:
    """For each triangle the three edges that it cuts: (M, 3, 2), inner node first."""
    order = np.argsort(~inside, axis=1, kind="stable")
    a, b, c, d = np.take_along_axis(tetrahedra, order, 1).T
    count = inside.sum(1)

    def cut(which: npt.NDArray[np.bool_], *edges: tuple[Ints, Ints]) -> Ints:
        return np.stack([np.stack([p[which], q[which]], -1) for p, q in edges], 1)

    one, two, three = (count == n for n in (1, 2, 3))
    return np.concatenate(
        [
            cut(one, (a, b), (a, c), (a, d)),
            cut(three, (a, d), (b, d), (c, d)),
            cut(two, (a, c), (a, d), (b, d)),
            cut(two, (a, c), (b, d), (b, c)),
        ]
    )


def _triangles(edges: Ints, points: Floats, value: Floats) -> Floats:
    """Vertices where the function vanishes along the edges, facets turned outward."""
    inner, outer = edges[..., 0], edges[..., 1]
    share = value[inner] / (value[inner] - value[outer])
    share = share.clip(_MARGIN, 1 - _MARGIN)[..., None]
    # The same sum for every facet at an edge, so that facets meet exactly.
    corners = points[inner] * (1 - share) + points[outer] * share
    outward = (points[outer] - points[inner]).sum(1)
    normal = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    reverse = (normal * outward).sum(1) < 0
    corners[reverse] = corners[reverse][:, ::-1]
    return corners
