"""What a 3MF file places: objects and components, each with its transform."""

from __future__ import annotations

import re
from dataclasses import dataclass
from itertools import groupby
from typing import TYPE_CHECKING, Final

import numpy as np

from wireprint._core import ModelError, carve, find_relationship
from wireprint.threemf.build import Build
from wireprint.threemf.contents import Contents, PlateContents, counted, shown
from wireprint.threemf.instance import joined
from wireprint.threemf.roles import Role
from wireprint.threemf.slicers import Config, read_config

if TYPE_CHECKING:
    from collections.abc import Iterator, Sequence

    import numpy.typing as npt

    from wireprint.threemf.archive import Archive
    from wireprint.threemf.instance import Instance, Soup

RELATIONSHIPS: Final = "_rels/.rels"
MODEL_TYPE: Final = "http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel"
#: The relationship to the part that makes a 3MF file a project.
PROJECT_TYPE: Final = "urn:wireprint:project"
USUAL_MODEL: Final = "3D/3dmodel.model"
#: Where slicers keep the G-code of a plate, in the form of `archive.name_of`.
GCODE: Final = re.compile(r"metadata/plate_\d+\.gcode$")
#: Why an item of the build is left out.
_NOT_PRINTABLE: Final = "object that is not to be printed"
_OFF_PLATES: Final = "object beside all plates"


@dataclass(frozen=True)
class Scene:
    """All meshes that a file's build places on one plate, and that are printed or cut out."""

    unit_mm: float
    instances: tuple[Instance, ...]
    contents: Contents

    @property
    def set_names(self) -> list[str]:
        """Names of all triangle sets, each once, in the order of the file."""
        return list(dict.fromkeys(name for one in self.instances for name in one.mesh.sets))

    def facets(self) -> tuple[npt.NDArray[np.float64], npt.NDArray[np.uint32]]:
        """Join the meshes: vertices (N, 3) in the file's unit, and faces (M, 3).

        Raises
        ------
        ModelError
            A negative part cannot be cut out of its object.
        """
        vertices: list[npt.NDArray[np.float64]] = []
        faces: list[npt.NDArray[np.uint32]] = []
        count = 0
        for _, placed in groupby(self.instances, key=lambda one: one.item):
            for points, own in _carved(list(placed)):
                faces.append(own + np.uint32(count) if count else own)
                vertices.append(points)
                count += len(points)
        if not any(map(len, faces)):
            raise ModelError("nothing is left where its negative parts were cut out")
        return joined(vertices), joined(faces)


def _carved(instances: Sequence[Instance]) -> Iterator[Soup]:
    """Yield the parts that an item of the build places, its negative parts cut out of them."""
    tools = [
        instance.soup(volume)
        for instance in instances
        for volume in instance.volumes
        if volume.role == Role.NEGATIVE
    ]
    for instance in instances:
        for volume in instance.volumes:
            if volume.role == Role.PART and tools:
                try:
                    yield carve(instance.soup(volume), tools)
                except ModelError as error:
                    raise ModelError(f"object {shown(volume.name)} {error}") from error
            elif volume.role == Role.PART:
                yield instance.soup(volume)


def read_scene(archive: Archive, plate: int | None = None) -> Scene:
    """Read all that a file's build places on a plate.

    Parameters
    ----------
    archive
        The file.
    plate
        Number of the plate; None: the first one that has something to print. All that is placed
        lies on plate 1 where the file knows no plates.

    Raises
    ------
    ModelError
        A part is missing or damaged; an extension is needed that is not supported; components
        contain one another, or make too many copies; a triangle names a vertex that does not exist;
        there is no such plate; or nothing is printed.
    """
    name = related_part(archive, MODEL_TYPE) or USUAL_MODEL
    if name not in archive:
        raise ModelError(f"no 3MF, it has no part {name.removeprefix('/')}")
    config = read_config(archive)
    build = Build(archive, name, config)
    items = build.root.items
    if not items:
        raise ModelError(_nothing(archive))
    # Why an item is not printed, if it is not.
    reasons: list[str | None] = [None if item.printable else _NOT_PRINTABLE for item in items]
    for index, item in enumerate(items):
        role = build.role(item)
        if role != Role.PART:
            reasons[index] = role
    numbers = config.plate_of(items)
    plates = _plates(build, config, reasons, numbers, plate)
    if plates:
        taken = next(one.number for one in plates if one.taken)
        for index, number in enumerate(numbers):
            if number is None:
                reasons[index] = reasons[index] or _OFF_PLATES
        here = [index for index, number in enumerate(numbers) if number in (None, taken)]
    else:
        here = list(range(len(items)))
    instances: list[Instance] = []
    found: list[tuple[str, str, int]] = []
    for index in here:
        reason = reasons[index]
        if reason is not None:
            found.append((build.name(items[index]), reason, 0))
            continue
        for instance in build.instances(index):
            instances.append(instance)
            found += [
                (
                    volume.name or build.name(items[index]),
                    str(volume.role),
                    volume.end - volume.begin,
                )
                for volume in instance.volumes
            ]
    contents = Contents(plates, counted(found))
    if not any(volume.role == Role.PART for one in instances for volume in one.volumes):
        left = "; ".join(contents.sentences())
        raise ModelError(f"nothing in it is to be printed: {left}" if left else _nothing(archive))
    return Scene(build.root.unit_mm, tuple(instances), contents)


def _plates(
    build: Build,
    config: Config,
    reasons: Sequence[str | None],
    numbers: Sequence[int | None],
    wanted: int | None,
) -> tuple[PlateContents, ...]:
    """Return the plates that hold something, one of which is taken; none where none is known."""
    known = [plate for plate in config.plates if plate.number in numbers]
    objects = {plate.number: list[str]() for plate in known}
    for item, reason, number in zip(build.root.items, reasons, numbers, strict=True):
        if number in objects and reason is None:
            objects[number].append(build.name(item))
    usable = [number for number, names in objects.items() if names]
    there = list(objects) or [1]
    if wanted is not None and wanted not in there:
        listed = ", ".join(map(str, there))
        raise ModelError(f"there is no plate {wanted} with objects on it; there are {listed}")
    taken = wanted if wanted is not None else next(iter(usable), there[0])
    return tuple(
        PlateContents(plate.number, plate.name, tuple(objects[plate.number]), plate.number == taken)
        for plate in known
    )


def _nothing(archive: Archive) -> str:
    """Say why nothing is printed where nothing is placed."""
    gcode = sorted(name for name in archive.names() if GCODE.match(name))
    if gcode:
        return (
            f"a sliced plate: it holds G-code ({gcode[0]}) and no model; "
            "take the project that it was sliced from"
        )
    return "nothing is to be built: no item of its build places a triangle"


def related_part(archive: Archive, kind: str) -> str | None:
    """Name of the part to which the package has a relationship of a type; None without one."""
    if RELATIONSHIPS not in archive:
        return None
    return archive.read(RELATIONSHIPS, lambda chunks: find_relationship(chunks, kind))
