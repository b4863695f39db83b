"""An AMF file as a mesh: a document, by itself or in a zip archive."""

from __future__ import annotations

from itertools import groupby
from typing import TYPE_CHECKING, Any, Final

import numpy as np

from wireprint._core import Mesh, ModelError, carve, read_amf
from wireprint.naming import named
from wireprint.threemf.archive import CHUNK, Archive
from wireprint.threemf.instance import joined

if TYPE_CHECKING:
    from collections.abc import Iterator
    from pathlib import Path
    from typing import BinaryIO, TypeAlias

    import numpy.typing as npt

    _Body: TypeAlias = tuple[npt.NDArray[np.float64], npt.NDArray[np.uint32], bool, int]

#: How a zip archive begins.
_ZIP: Final = b"PK\x03\x04"


def amf_mesh(path: Path, **placement: Any) -> Mesh:
    """Read an AMF file, repair its mesh and place it.

    Parameters
    ----------
    path
        The file.
    **placement
        What `Mesh.from_arrays` takes; `scale` is a factor on the unit that the file states.

    Raises
    ------
    ModelError
        The file is damaged, or makes no surface.
    """
    with named(path):
        unit_mm, bodies, notes = _read(path)
        placement["scale"] *= unit_mm
        vertices: list[npt.NDArray[np.float64]] = []
        faces: list[npt.NDArray[np.uint32]] = []
        count = 0
        for points, own in _carved(bodies):
            vertices.append(points)
            faces.append(own + np.uint32(count) if count else own)
            count += len(points)
        return Mesh.from_arrays(joined(vertices), joined(faces), **placement, notes=notes)


def _read(path: Path) -> tuple[float, list[_Body], list[str]]:
    """Read the document of a file."""
    try:
        with path.open("rb") as file:
            if file.read(len(_ZIP)) != _ZIP:
                file.seek(0)
                return read_amf(_chunks(file))
    except OSError as error:
        raise ModelError(f"cannot be read: {error.strerror}") from error
    with Archive(path, "AMF") as archive:
        names = archive.names()
        inner = [name for name in names if name.endswith(".amf")] or names
        if len(inner) != 1:
            raise ModelError(f"the archive holds {len(inner)} documents; an AMF file has one")
        return archive.read(inner[0], read_amf)


def _chunks(file: BinaryIO) -> Iterator[bytes]:
    while chunk := file.read(CHUNK):
        yield chunk


def _carved(
    bodies: list[_Body],
) -> Iterator[tuple[npt.NDArray[np.float64], npt.NDArray[np.uint32]]]:
    """Yield the bodies that are printed, what is negative cut out of those of its object."""
    for _, placed in groupby(bodies, key=lambda body: body[3]):
        own = list(placed)
        tools = [(vertices, faces) for vertices, faces, negative, _ in own if negative]
        for vertices, faces, negative, _ in own:
            if not negative:
                yield carve((vertices, faces), tools) if tools else (vertices, faces)
