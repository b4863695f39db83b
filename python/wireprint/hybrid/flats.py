"""Points on a model's level faces: lids and floors, which no layer's contour passes."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

if TYPE_CHECKING:
    import numpy.typing as npt

    from wireprint._core import Mesh
    from wireprint.regions import Region

#: Points lie about this far apart, mm …
_PITCH_MM = 1.0
#: … but no edge of a face is divided more often.
_MOST = 128
#: A face that leans more than by this cosine is a wall.
_LEVEL = 0.999


@dataclass(frozen=True)
class Flats:
    """What is marked of the level faces."""

    #: Points, mm, shape (N, 3), and whether each is marked, shape (N,).
    points: npt.NDArray[np.float64]
    marked: npt.NDArray[np.bool_]

    @classmethod
    def of(cls, mesh: Mesh, normals: npt.NDArray[np.float64], region: Region) -> Flats:
        """Ask a region about the level faces of a mesh whose faces have these unit normals."""
        level = np.flatnonzero(np.abs(normals[:, 2]) > _LEVEL)
        parts = [_inside(mesh.vertices[mesh.faces[face]]) for face in level.tolist()]
        if not parts:
            return cls(np.zeros((0, 3)), np.zeros(0, np.bool_))
        points = np.concatenate(parts)
        outward = np.repeat(normals[level], [len(part) for part in parts], axis=0)
        return cls(points, region.covers(points, np.ascontiguousarray(outward)))


def _inside(corners: npt.NDArray[np.float64]) -> npt.NDArray[np.float64]:
    """Return the centres of the small triangles that a triangle of shape (3, 3) is divided into."""
    a, b, c = corners
    longest = max(np.linalg.norm(b - a), np.linalg.norm(c - b), np.linalg.norm(a - c))
    count = int(np.clip(np.ceil(longest / _PITCH_MM), 1, _MOST))
    i, j = np.mgrid[0:count, 0:count]
    upright = np.stack([i, j])[:, i + j < count] + 1 / 3
    turned = np.stack([i, j])[:, i + j < count - 1] + 2 / 3
    u, v = np.concatenate([upright, turned], axis=1)[:, :, None] / count
    points: npt.NDArray[np.float64] = a + u * (b - a) + v * (c - a)
    return points
