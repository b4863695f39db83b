"""A model part of a 3MF file: its objects, what they are made of, and what shall be built."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from wireprint._core import read_model_part
from wireprint.threemf.roles import of_object

if TYPE_CHECKING:
    import numpy as np
    import numpy.typing as npt

    from wireprint._core import Painting
    from wireprint.threemf.archive import Archive
    from wireprint.threemf.roles import Role


@dataclass(frozen=True)
class Placed:
    """An object that is placed: by the build, or as a component of another one."""

    object_id: str
    #: Twelve numbers, row by row: (x, y, z, 1) · matrix is where a point goes.
    transform: tuple[float, ...]
    #: The part that has the object, if it is another one.
    path: str | None
    #: Whether a slicer's project wants it printed.
    printable: bool


@dataclass(frozen=True)
class Object:
    """A mesh, or components."""

    #: float64 of shape (N, 3), in the part's unit; all finite and sensible.
    vertices: npt.NDArray[np.float64]
    #: uint32 of shape (M, 3), corners in the order of the file; all of them exist.
    faces: npt.NDArray[np.uint32]
    painting: Painting
    #: By the names of triangle sets: ranges of triangles, first and last, uint32 of shape (R, 2);
    #: unchecked.
    sets: dict[str, npt.NDArray[np.uint32]]
    components: tuple[Placed, ...]
    #: What people call it; may be empty.
    name: str
    role: Role
    #: The extension that gives it a shape which is not read, in words.
    foreign: str | None


@dataclass(frozen=True)
class Part:
    """One model part."""

    unit_mm: float
    objects: dict[str, Object]
    items: tuple[Placed, ...]


def read_part(archive: Archive, name: str) -> Part:
    """Read a model part.

    Raises
    ------
    ModelError
        There is no such part, or it is no model.
    """
    unit_mm, objects, items = archive.read(name, read_model_part)
    return Part(
        unit_mm,
        {
            key: Object(
                vertices,
                faces,
                painting,
                dict(sets),
                _placed(components),
                name,
                of_object(kind, flag),
                foreign,
            )
            for key, (
                vertices,
                faces,
                painting,
                sets,
                components,
                (name, kind, flag, foreign),
            ) in objects
        },
        _placed(items),
    )


def _placed(found: list[tuple[str, tuple[float, ...], str | None, bool]]) -> tuple[Placed, ...]:
    return tuple(Placed(*one) for one in found)
