"""Follows the items of a build through the parts of a 3MF file to the meshes that they place."""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

import numpy as np

from wireprint._core import MOST_TRIANGLES, MOST_VERTICES, ModelError
from wireprint.threemf.archive import name_of
from wireprint.threemf.instance import Instance, Volume
from wireprint.threemf.part import Object, Part, Placed, read_part
from wireprint.threemf.roles import Role

if TYPE_CHECKING:
    from collections.abc import Iterator

    import numpy.typing as npt

    from wireprint.threemf.archive import Archive
    from wireprint.threemf.slicers import Config

#: Most copies of objects that a file may place, components of components multiplied.
MOST_COPIES: Final = 10_000
#: Factors beyond this make no sense in any unit.
LARGEST: Final = 1e9
#: Most components within one another.
MOST_DEEP: Final = 64


class Build:
    """The build of a file: its items, and the meshes that they place."""

    def __init__(self, archive: Archive, name: str, config: Config) -> None:
        self.root = read_part(archive, name)
        self._archive = archive
        self._config = config
        self._name = name
        self._parts = {name_of(name): self.root}
        self._copies = 0
        self._triangles = 0
        self._vertices = 0

    def name(self, item: Placed) -> str:
        """Return what people call the object that an item places; may be empty."""
        named = self._config.names.get(item.object_id)
        if named or item.path is not None or item.object_id not in self.root.objects:
            return named or ""
        return self.root.objects[item.object_id].name

    def role(self, item: Placed) -> Role:
        """Return what the object of an item is for, by its own type."""
        return self._object(item, self._name)[1].role

    def instances(self, index: int) -> Iterator[Instance]:
        """Yield every mesh that an item of the build places, in the order of the file."""
        item = self.root.items[index]
        yield from self._placed(item, self._name, np.eye(4), (), Role.PART, index)

    def _placed(
        self,
        placed: Placed,
        within: str,
        outer: npt.NDArray[np.float64],
        above: tuple[tuple[str, str], ...],
        role: Role,
        item: int,
    ) -> Iterator[Instance]:
        part, mesh = self._object(placed, within)
        name = placed.path or within
        key = (name_of(name), placed.object_id)
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
        top = above[0][1] if above else placed.object_id
        own, called = self._config.parts.get((top, placed.object_id), (mesh.role, mesh.name))
        # What is no part as a whole has no parts.
        role = own if role == Role.PART else role
        printed = role in (Role.PART, Role.NEGATIVE)
        if mesh.foreign is not None and printed:
            raise ModelError(
                f"object {called or placed.object_id!r} has a shape by {mesh.foreign}, "
                "which is not supported; export the model as plain triangles"
            )
        if len(mesh.faces):
            volumes = self._volumes(
                mesh, placed.object_id, Volume(role, called, 0, len(mesh.faces))
            )
            yield self._instance(mesh, placed.object_id, matrix, part.unit_mm, volumes, item)
        for component in mesh.components:
            yield from self._placed(component, name, matrix, (*above, key), role, item)

    def _volumes(self, mesh: Object, name: str, whole: Volume) -> tuple[Volume, ...]:
        """Return the volumes of a mesh: what a slicer says, or all of it as one."""
        ranges = self._config.ranges.get(name)
        if not ranges or whole.role != Role.PART:
            return (whole,)
        found, at = [], 0
        for one in sorted(ranges, key=lambda one: one.first):
            if not at <= one.first <= one.last < len(mesh.faces):
                raise ModelError(
                    f"a volume of object {name!r} has its triangles {one.first} to {one.last}, "
                    f"of {len(mesh.faces)}, or some that another volume has"
                )
            if at < one.first:
                found.append(Volume(Role.PART, whole.name, at, one.first))
            at = one.last + 1
            found.append(Volume(one.role, one.name, one.first, at))
        if at < len(mesh.faces):
            found.append(Volume(Role.PART, whole.name, at, len(mesh.faces)))
        return tuple(found)

    def _instance(
        self,
        mesh: Object,
        name: str,
        matrix: npt.NDArray[np.float64],
        unit_mm: float,
        volumes: tuple[Volume, ...],
        item: int,
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
        return Instance(mesh, scaled, volumes, item)

    def _object(self, placed: Placed, within: str) -> tuple[Part, Object]:
        """Return an object that is placed, and the part that has it."""
        name = placed.path or within
        key = name_of(name)
        if key not in self._parts:
            self._parts[key] = read_part(self._archive, name)
        part = self._parts[key]
        mesh = part.objects.get(placed.object_id)
        if mesh is None:
            raise ModelError(f"places an object {placed.object_id!r} that {name} does not have")
        return part, mesh
