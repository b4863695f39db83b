"""What a 3MF file places: objects and components, each with its transform."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING, Final

import numpy as np

from wireprint._core import ModelError
from wireprint.threemf import xml
from wireprint.threemf.archive import name_of
from wireprint.threemf.part import Object, Part, Placed, read_part

if TYPE_CHECKING:
    from collections.abc import Iterator

    import numpy.typing as npt

    from wireprint.threemf.archive import Archive

#: Most copies of objects that a file may place, components of components multiplied.
MOST_COPIES: Final = 10_000
#: Coordinates and factors beyond this make no sense in any unit.
LARGEST: Final = 1e9
#: Most components within one another.
MOST_DEEP: Final = 64
#: Most triangles that they may have in all; a mesh of that many takes a gigabyte.
MOST_TRIANGLES: Final = 1 << 23

RELATIONSHIPS: Final = "_rels/.rels"
MODEL_TYPE: Final = "http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel"
USUAL_MODEL: Final = "3D/3dmodel.model"


@dataclass(frozen=True)
class Instance:
    """A mesh where the file puts it."""

    mesh: Object
    #: (4, 3): (x, y, z, 1) · matrix is where a point goes, in the file's unit.
    matrix: npt.NDArray[np.float64]

    @cached_property
    def own(self) -> npt.NDArray[np.float64]:
        """Float64 of shape (N, 3): the vertices as the object has them."""
        return np.frombuffer(self.mesh.vertices, np.float64).reshape(-1, 3)

    @cached_property
    def vertices(self) -> npt.NDArray[np.float64]:
        """Float64 of shape (N, 3), in the file's unit."""
        placed: npt.NDArray[np.float64] = self.own @ self.matrix[:3] + self.matrix[3]
        return placed

    @cached_property
    def faces(self) -> npt.NDArray[np.int64]:
        """int64 of shape (M, 3), corners in the order of the file."""
        return np.frombuffer(self.mesh.triangles, np.int64).reshape(-1, 3)

    @property
    def mirrored(self) -> bool:
        """Whether corners that were counter-clockwise are clockwise where the file puts them."""
        return bool(np.linalg.det(self.matrix[:3]) < 0)


@dataclass(frozen=True)
class Scene:
    """All meshes that a file's build places."""

    unit_mm: float
    instances: tuple[Instance, ...]

    def facets(self) -> tuple[npt.NDArray[np.float64], npt.NDArray[np.int64]]:
        """Join the meshes: vertices (N, 3) in the file's unit, and faces (M, 3)."""
        vertices, faces, count = [np.zeros((0, 3))], [np.zeros((0, 3), np.int64)], 0
        for instance in self.instances:
            turned = instance.faces[:, ::-1] if instance.mirrored else instance.faces
            faces.append(turned + count)
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
        raise ModelError(f"{archive.path}: no 3MF, it has no part {name.removeprefix('/')}")
    build = _Build(archive, name)
    instances = tuple(build.instances())
    if not instances:
        raise ModelError(f"{archive.path}: the file has no facets")
    return Scene(build.root.unit_mm, instances)


def related_part(archive: Archive, kind: str) -> str | None:
    """Name of the part to which the package has a relationship of a type; None without one."""
    found: list[str] = []

    def take(attributes: xml.Attributes) -> None:
        if attributes["Type"] == kind:
            found.append(attributes["Target"])

    if RELATIONSHIPS in archive:
        place = f"{archive.path}: {RELATIONSHIPS}"
        xml.parse(
            archive.chunks(RELATIONSHIPS),
            place,
            lambda space: ({f"{space} Relationship".strip(): take}, {}),
        )
    return found[0] if found else None


class _Build:
    """Follows items and components through the parts of a file."""

    def __init__(self, archive: Archive, name: str) -> None:
        self.root = read_part(archive, name)
        self._archive = archive
        self._name = name
        self._parts = {name_of(name): self.root}
        self._copies = 0
        self._triangles = 0

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
            raise self._fault(f"places an object {placed.object_id!r} that {name} does not have")
        if key in above:
            raise self._fault(
                f"object {placed.object_id!r} is a component of itself, copies without end"
            )
        self._copies += 1
        if self._copies > MOST_COPIES or len(above) > MOST_DEEP:
            raise self._fault(
                f"places more than {MOST_COPIES} copies of its objects, "
                f"or components more than {MOST_DEEP} deep"
            )
        inner = np.eye(4)
        inner[:, :3] = np.reshape(placed.transform, (4, 3))
        with np.errstate(over="ignore", invalid="ignore"):
            matrix = inner @ outer
        if mesh.triangles:
            yield self._instance(mesh, placed.object_id, matrix, part.unit_mm)
        for component in mesh.components:
            yield from self._placed(component, name, matrix, (*above, key))

    def _instance(
        self, mesh: Object, name: str, matrix: npt.NDArray[np.float64], unit_mm: float
    ) -> Instance:
        self._triangles += len(mesh.triangles) // 3
        if self._triangles > MOST_TRIANGLES:
            raise self._fault(f"places more than {MOST_TRIANGLES} triangles")
        if not (np.abs(matrix) < LARGEST).all():
            raise self._fault(f"object {name!r} is placed by numbers that make no sense")
        scaled = matrix[:, :3].copy()
        scaled[:3] *= unit_mm / self.root.unit_mm
        instance = Instance(mesh, scaled)
        absurd = np.flatnonzero(~(np.abs(instance.own) < LARGEST).all(axis=1))
        if len(absurd):
            raise self._fault(
                f"vertex {absurd[0]} of object {name!r} is {instance.own[absurd[0]].tolist()}: "
                "no finite, sensible coordinates"
            )
        faces, count = instance.faces, len(instance.own)
        wrong = np.flatnonzero(((faces < 0) | (faces >= count)).any(axis=1))
        if len(wrong):
            raise self._fault(
                f"triangle {wrong[0]} of object {name!r} names vertices "
                f"{faces[wrong[0]].tolist()}, but there are {count}"
            )
        return instance

    def _part(self, name: str) -> Part:
        key = name_of(name)
        if key not in self._parts:
            self._parts[key] = read_part(self._archive, name)
        return self._parts[key]

    def _fault(self, text: str) -> ModelError:
        return ModelError(f"{self._archive.path}: {text}")
