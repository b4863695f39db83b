"""Points on a model's level faces: lids and floors, which no layer's contour passes."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from wireprint.records import Record

if TYPE_CHECKING:
    import numpy.typing as npt

    from wireprint._core import Mesh

    Floats = npt.NDArray[np.float64]

#: Points lie about this far apart, mm …
_PITCH_MM = 1.0
#: … but no edge of a face is divided more often.
_MOST = 128
#: A face that leans more than by this cosine is a wall.
_LEVEL = 0.999


@dataclass(frozen=True, repr=False)
class Flats(Record):
    """What is marked of the level faces."""

    #: Points, mm, shape (N, 3), and whether each is marked, shape (N,).
    points: Floats
    marked: npt.NDArray[np.bool_]


def level_points(mesh: Mesh, normals: Floats) -> tuple[Floats, Floats]:
    """Return points on the level faces of a mesh whose faces have these unit normals.

    Returns
    -------
    tuple of numpy.ndarray
        The points, mm, and the normals there, float64 of shape (N, 3).
    """
    level = np.flatnonzero(np.abs(normals[:, 2]) > _LEVEL)
    # Each access makes an array.
    vertices, faces = mesh.vertices, mesh.faces
    corners = vertices[faces[level]]
    sides = np.linalg.norm(corners - np.roll(corners, -1, axis=1), axis=2)
    count = np.clip(np.ceil(sides.max(axis=1, initial=0.0) / _PITCH_MM), 1, _MOST).astype(np.int64)
    found, owner = [np.zeros((0, 3))], [np.zeros(0, np.int64)]
    for divisions in np.unique(count).tolist():
        alike = np.flatnonzero(count == divisions)
        parts = _inside(corners[alike], divisions)
        found.append(parts.reshape(-1, 3))
        owner.append(np.repeat(alike, parts.shape[1]))
    order = np.argsort(np.concatenate(owner), kind="stable")
    face = level[np.concatenate(owner)[order]]
    return np.concatenate(found)[order], np.ascontiguousarray(normals[face])


def _inside(corners: Floats, count: int) -> Floats:
    """Return the centres of the `count`² small triangles that each of (F, 3, 3) is divided into."""
    a, b, c = (corners[:, None, corner] for corner in range(3))
    i, j = np.mgrid[0:count, 0:count]
    upright = np.stack([i, j])[:, i + j < count] + 1 / 3
    turned = np.stack([i, j])[:, i + j < count - 1] + 2 / 3
    u, v = np.concatenate([upright, turned], axis=1)[:, None, :, None] / count
    points: Floats = a + u * (b - a) + v * (c - a)
    return points
