"""Projects: a 3MF file that holds a mesh, all settings and the marks on it."""

# No `from __future__ import annotations` here, for pydantic's sake; see `settings`.

import hashlib
from collections.abc import Iterable
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any, Final, Literal

import numpy as np
import numpy.typing as npt
from pydantic import BaseModel, ConfigDict, Field

from wireprint._core import Mesh, ModelError, SettingError
from wireprint.files import written_whole
from wireprint.regions import Region
from wireprint.regions.document import MOST_BYTES, Document, check_size, validated
from wireprint.settings import Settings
from wireprint.threemf import write
from wireprint.threemf.scene import PROJECT_TYPE

if TYPE_CHECKING:
    from wireprint.threemf.archive import Archive

#: The part that makes a 3MF file a project; other programs pass over it.
PART: Final = "Metadata/wireprint.json"
CONTENT_TYPE: Final = "application/vnd.wireprint.project+json"


_Index = Annotated[int, Field(ge=0, lt=2**32)]


class Saved(BaseModel):
    """What a project holds besides its mesh."""

    model_config = ConfigDict(frozen=True, extra="forbid")

    format: Literal["wireprint-project"] = "wireprint-project"
    version: Literal[1] = 1
    #: Tells whether the mesh is still the one that was saved.
    mesh_sha256: str = Field(pattern="^[0-9a-f]{64}$")
    #: Face, edge and neighbour where the mesh's are not those that are found anew.
    paired: tuple[tuple[_Index, _Index, _Index], ...] = ()
    #: As ``Settings.model_dump`` gives them; checked when they are asked for.
    settings: dict[str, Any]
    #: Marks in the frame of the mesh.
    strokes: Document = Document()

    def is_of(self, vertices: npt.NDArray[np.float64], faces: npt.NDArray[np.uint32]) -> bool:
        """Whether a mesh is the one that was saved, number by number."""
        return _digest(vertices, faces) == self.mesh_sha256


def write_project(path: str | Path, mesh: Mesh, settings: Settings, region: Region) -> None:
    """Write a project: all of it, or nothing.

    Parameters
    ----------
    path
        The file, ``.3mf``; an older one is replaced.
    mesh, settings, region
        See `project_bytes`.

    Raises
    ------
    SettingError
        The region has a predicate, or is too large.
    OutputError
        The file cannot be written.
    """
    written_whole(Path(path), project_bytes(mesh, settings, region))


def project_bytes(mesh: Mesh, settings: Settings, region: Region) -> bytes:
    """Return a project's file; same input, same bytes.

    Parameters
    ----------
    mesh
        The model as it was placed.
    settings
        Written in full, so that it does not matter how profiles change.
    region
        Marks in the mesh's frame.

    Raises
    ------
    SettingError
        The region has a predicate, or is too large.
    """
    saved = Saved(
        mesh_sha256=_digest(mesh.vertices, mesh.faces),
        paired=_paired(mesh),
        settings=settings.model_dump(mode="json"),
        strokes=Document.of(region),
    )
    content = saved.model_dump_json(indent=1).encode()
    check_size(content, "the project", SettingError)
    part = write.Extra(PART, CONTENT_TYPE, PROJECT_TYPE, content)
    return write.package(mesh, part)


def read_saved(archive: "Archive", name: str) -> Saved:
    """Return what a project holds besides its mesh, given the name of the part.

    Raises
    ------
    ModelError
        The part is missing, damaged, too large, or of another version.
    """
    content = archive.read(name, _some)
    return validated(Saved, content, name.removeprefix("/"), ModelError)


def _some(chunks: Iterable[bytes]) -> bytes:
    """Join the pieces of a part until they are too much for a project."""
    content = bytearray()
    for chunk in chunks:
        content += chunk
        if len(content) > MOST_BYTES:
            break
    return bytes(content)


def _paired(mesh: Mesh) -> tuple[tuple[int, int, int], ...]:
    """Face, edge and neighbour wherever `Mesh.restored` would find another neighbour."""
    plain = Mesh.restored(mesh.vertices, mesh.faces)
    neighbours = mesh.neighbours
    wrong = np.argwhere(plain.neighbours != neighbours).tolist()
    return tuple((face, edge, int(neighbours[face, edge])) for face, edge in wrong)


def _digest(vertices: npt.NDArray[np.floating[Any]], faces: npt.NDArray[np.integer[Any]]) -> str:
    """SHA-256 of a mesh's numbers; adding 0 turns −0 into 0, which is as good."""
    numbers = (vertices + 0.0).astype("<f8").tobytes() + faces.astype("<u4").tobytes()
    return hashlib.sha256(numbers).hexdigest()
