"""Where a mesh went since a region was marked on it."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np

if TYPE_CHECKING:
    import numpy.typing as npt

    from wireprint._core import Mesh


def motion(
    before: Mesh, after: Mesh, rotate_deg: tuple[float, float, float]
) -> npt.NDArray[np.float64]:
    """Return the map from one place of a mesh to another.

    Parameters
    ----------
    before, after
        The same mesh, before it was turned and shifted and after.
    rotate_deg
        The turn about x, then y, then z, degrees.

    Returns
    -------
    numpy.ndarray
        Affine map of shape (4, 4), for column vectors.
    """
    turn = np.eye(3)
    for axis, degrees in enumerate(rotate_deg):
        one, other = (axis + 1) % 3, (axis + 2) % 3
        about = np.eye(3)
        cosine, sine = math.cos(math.radians(degrees)), math.sin(math.radians(degrees))
        about[one, one] = about[other, other] = cosine
        about[one, other], about[other, one] = -sine, sine
        turn = about @ turn
    matrix = np.eye(4)
    matrix[:3, :3] = turn
    turned = before.vertices @ turn.T
    matrix[:3, 3] = after.vertices.min(axis=0) - turned.min(axis=0)
    return matrix
