"""What a 3MF file places: objects and components, each with its transform."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING, Final

import numpy as np

from wireprint._core import MOST_TRIANGLES, MOST_VERTICES, ModelError, find_relationship
from wireprint.threemf.archive import name_of
from wireprint.threemf.part import Object, Part, Placed, read_part

if TYPE_CHECKING:
    from collections.abc import Iterator

    import numpy.typing as npt

    from wireprint.threemf.archive import Archive

#: Most copies of objects that a file may place, components of components multiplied.
MOST_COPIES: Final = 10_000
#: Factors beyond this make no sense in any unit.
LARGEST: Final = 1e9
#: Most components within one another.
MOST_DEEP: Final = 64

RELATIONSHIPS: Final = "_rels/.rels"
MODEL_TYPE: Final = "http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel"
#: The relationship to the part that makes a 3MF file a project.
PROJECT_TYPE: Final = "urn:wireprint:project"
USUAL_MODEL: Final = "3D/3dmodel.model"


@dataclass(frozen=True)
class Instance:
    """A mesh where the file puts it."""

    mesh: Object
    #: (4, 3): (x, y, z, 1) · matrix is where a point goes, in the file's unit.
    matrix: npt.NDArray[np.float64]

    @cached_property
    def vertices(self) -> npt.NDArray[np.float64]:
        """Float64 of shape (N, 3), in the file's unit."""
        placed: npt.NDArray[np.float64] = self.mesh.vertices @ self.matrix[:3] + self.matrix[3]
        return placed

    @property
    def mirrored(self) -> bool:
        """Whether corners that were counter-clockwise are clockwise where the file puts them."""
        return bool(np.linalg.det(self.matrix[:3]) < 0)


@dataclass(frozen=True)
class Scene:
    """All meshes that a file's build places."""

    unit_mm: float
    instances: tuple[Instance, ...]

    @property
    def set_names(self) -> list[str]:
        """Names of all triangle sets, each once, in the order of the file."""
        return list(dict.fromkeys(name for one in self.instances for name in one.mesh.sets))

    def facets(self) -> tuple[npt.NDArray[np.float64], npt.NDArray[np.uint32]]:
        """Join the meshes: vertices (N, 3) in the file's unit, and faces (M, 3)."""
        vertices, faces, count = [], [], 0
        for instance in self.instances:
            own = instance.mesh.faces
            faces.append((own[:, ::-1] if instance.mirrored else own) + np.uint32(count))
            vertices.append(instance.vertices)
            count += len(instance.vertices)
        return np.concatenate(vertices), np.concatenate(faces)


def read_scene(archive: Archive) -> Scene:
    """Read all that a file's build places.

    Raises
    ------
    ModelError
        A part is missing or damaged; components contain one another, or make too many copies; a
        triangle names a vertex that does not exist; or nothing is built.
    """
    name = related_part(archive, MODEL_TYPE) or USUAL_MODEL
    if name not in archive:
        raise ModelError(f"no 3MF, it has no part {name.removeprefix('/')}")
    build = _Build(archive, name)
    instances = tuple(build.instances())
    if not instances:
        raise ModelError("the file has no facets")
    return Scene(build.root.unit_mm, instances)


def related_part(archive: Archive, kind: str) -> str | None:
    """Name of the part to which the package has a relationship of a type; None without one."""
    if RELATIONSHIPS not in archive:
        return None
    return archive.read(RELATIONSHIPS, lambda chunks: find_relationship(chunks, kind))


class _Build:
    """Follows items and components through the parts of a file."""

    def __init__(self, archive: Archive, name: str) -> None:
        self.root = read_part(archive, name)
        self._archive = archive
        self._name = name
        self._parts = {name_of(name): self.root}
        self._copies = 0
        self._triangles = 0
        self._vertices = 0

    def instances(self) -> Iterator[Instance]:
        """Yield every mesh that the build places, in the order of the file."""
        for item in self.root.items:
            yield from self._placed(item, self._name, np.eye(4), ())

    def _placed(
        self,
        placed: Placed,
        within: str,
        outer: npt.NDArray[np.float64],
        above: tuple[tuple[str, str], ...],
    ) -> Iterator[Instance]:
        name = placed.path or within
        part, key = self._part(name), (name_of(name), placed.object_id)
        mesh = part.objects.get(placed.object_id)
        if mesh is None:
            raise ModelError(f"places an object {placed.object_id!r} that {name} does not have")
        if key in above:
            raise ModelError(
                f"object {placed.object_id!r} is a component of itself, copies without end"
            )
        self._copies += 1
        if self._copies > MOST_COPIES or len(above) > MOST_DEEP:
            raise ModelError(
                f"places more than {MOST_COPIES} copies of its objects, "
                f"or components more than {MOST_DEEP} deep"
            )
        inner = np.eye(4)
        inner[:, :3] = np.reshape(placed.transform, (4, 3))
        with np.errstate(over="ignore", invalid="ignore"):
            matrix = inner @ outer
        if len(mesh.faces):
            yield self._instance(mesh, placed.object_id, matrix, part.unit_mm)
        for component in mesh.components:
            yield from self._placed(component, name, matrix, (*above, key))

    def _instance(
        self, mesh: Object, name: str, matrix: npt.NDArray[np.float64], unit_mm: float
    ) -> Instance:
        self._triangles += len(mesh.faces)
        self._vertices += len(mesh.vertices)
        if self._triangles > MOST_TRIANGLES or self._vertices > MOST_VERTICES:
            raise ModelError(
                f"places more than {MOST_TRIANGLES} triangles or {MOST_VERTICES} vertices"
            )
        if not (np.abs(matrix) < LARGEST).all():
            raise ModelError(f"object {name!r} is placed by numbers that make no sense")
        scaled = matrix[:, :3].copy()
        scaled[:3] *= unit_mm / self.root.unit_mm
        return Instance(mesh, scaled)

    def _part(self, name: str) -> Part:
        key = name_of(name)
        if key not in self._parts:
            self._parts[key] = read_part(self._archive, name)
        return self._parts[key]
