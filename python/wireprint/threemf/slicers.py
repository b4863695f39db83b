"""What slicers write beside a model: roles of its volumes, names, and plates."""

from __future__ import annotations

from collections import Counter
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Final

from wireprint._core import ModelError, read_slicer_config
from wireprint.threemf import roles

if TYPE_CHECKING:
    from collections.abc import Sequence

    from wireprint.threemf.archive import Archive
    from wireprint.threemf.part import Placed
    from wireprint.threemf.roles import Role

#: Parts of Bambu Studio and OrcaSlicer, and of PrusaSlicer, its kin and its older versions.
_CONFIGS: Final = (
    "Metadata/model_settings.config",
    "Metadata/Slic3r_PE_model.config",
    "Metadata/Prusa_Slicer_model.config",
    "Metadata/SuperSlicer_model.config",
)


@dataclass(frozen=True)
class Range:
    """Triangles of an object that have a role of their own."""

    first: int
    last: int
    role: Role
    name: str


@dataclass(frozen=True)
class Plate:
    """What is printed together."""

    number: int
    name: str
    #: Objects by their ids, and which of the items that place one it is, counted from 0.
    instances: tuple[tuple[str, int], ...]


@dataclass(frozen=True)
class Config:
    """All that a slicer says; empty where it says nothing."""

    #: By the ids of objects: their ranges, in the order of the file.
    ranges: dict[str, list[Range]] = field(default_factory=dict)
    #: By the ids of an object and of one that it places: role and name.
    parts: dict[tuple[str, str], tuple[Role, str]] = field(default_factory=dict)
    #: By the ids of objects.
    names: dict[str, str] = field(default_factory=dict)
    plates: tuple[Plate, ...] = ()

    def plate_of(self, items: Sequence[Placed]) -> list[int | None]:
        """Return the number of the plate on which each item of the build lies, if any."""
        numbers = {place: plate.number for plate in self.plates for place in plate.instances}
        seen: dict[str, int] = {}
        found = []
        for item in items:
            instance = seen.get(item.object_id, 0)
            seen[item.object_id] = instance + 1
            found.append(numbers.get((item.object_id, instance)))
        return found


def read_config(archive: Archive) -> Config:
    """Read what slicers say beside the model.

    Raises
    ------
    ModelError
        A part is damaged, or plates share a number.
    """
    config = Config()
    plates: list[Plate] = []
    for name in _CONFIGS:
        if name not in archive:
            continue
        objects, found = archive.read(name, read_slicer_config)
        for key, label, volumes in objects:
            config.names[key] = label
            for triangles, component, kind, volume in volumes:
                role = roles.of_slicer(kind)
                if triangles is not None:
                    config.ranges.setdefault(key, []).append(Range(*triangles, role, volume))
                elif component is not None:
                    config.parts[key, component] = role, volume
        plates += [Plate(number, label, tuple(places)) for number, label, places in found]
    for number, count in Counter(plate.number for plate in plates).items():
        if count > 1:
            raise ModelError(
                f"{count} plates have the number {number}; export the one that is meant by itself"
            )
    return Config(config.ranges, config.parts, config.names, tuple(plates))
