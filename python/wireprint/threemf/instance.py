"""Meshes where a 3MF file puts them, and what their volumes are for."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING, TypeVar

import numpy as np

if TYPE_CHECKING:
    from collections.abc import Sequence
    from typing import TypeAlias

    import numpy.typing as npt

    from wireprint.threemf.part import Object
    from wireprint.threemf.roles import Role

    #: Vertices, float64 of shape (N, 3), and faces, uint32 of shape (M, 3).
    Soup: TypeAlias = tuple[npt.NDArray[np.float64], npt.NDArray[np.uint32]]

_Kind = TypeVar("_Kind", bound=np.generic)


def joined(arrays: Sequence[npt.NDArray[_Kind]]) -> npt.NDArray[_Kind]:
    """Join arrays along their rows; one alone is not copied, for it may be large."""
    return arrays[0] if len(arrays) == 1 else np.concatenate(arrays)


@dataclass(frozen=True)
class Volume:
    """Some triangles of a mesh, and what they are for."""

    role: Role
    #: What people call it; may be empty.
    name: str
    #: The first triangle, and the one behind the last.
    begin: int
    end: int


@dataclass(frozen=True)
class Instance:
    """A mesh where the file puts it."""

    mesh: Object
    #: (4, 3): (x, y, z, 1) · matrix is where a point goes, in the file's unit.
    matrix: npt.NDArray[np.float64]
    #: Of every triangle there is one volume at most.
    volumes: tuple[Volume, ...]
    #: Which item of the build places it.
    item: int

    @cached_property
    def vertices(self) -> npt.NDArray[np.float64]:
        """Float64 of shape (N, 3), in the file's unit."""
        if np.array_equal(self.matrix, np.eye(4, 3)):
            return self.mesh.vertices
        placed: npt.NDArray[np.float64] = self.mesh.vertices @ self.matrix[:3]
        placed += self.matrix[3]
        return placed

    @property
    def mirrored(self) -> bool:
        """Whether corners that were counter-clockwise are clockwise where the file puts them."""
        return bool(np.linalg.det(self.matrix[:3]) < 0)

    def soup(self, volume: Volume) -> Soup:
        """Return the triangles of a volume, their corners counter-clockwise."""
        faces = self.mesh.faces[volume.begin : volume.end]
        return self.vertices, faces[:, ::-1] if self.mirrored else faces

    def of_role(self, role: Role) -> npt.NDArray[np.bool_]:
        """Tell which triangles are in a volume of a role."""
        found = np.zeros(len(self.mesh.faces), np.bool_)
        for volume in self.volumes:
            found[volume.begin : volume.end] |= volume.role == role
        return found
