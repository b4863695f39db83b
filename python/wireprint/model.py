"""Models with what is marked on them: painted 3MF files, and projects."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

from wireprint._core import Mesh, ModelError
from wireprint.file3mf import File3mf
from wireprint.mesh import format_of, load_mesh, placed

if TYPE_CHECKING:
    import os
    from collections.abc import Collection

    from wireprint.regions import Region
    from wireprint.settings import Settings
    from wireprint.threemf.contents import Contents


@dataclass(frozen=True)
class Model:
    """A mesh on the bed, and what its file says besides."""

    mesh: Mesh
    #: What is marked in the file, in the mesh's frame.
    region: Region
    #: The settings of a project.
    settings: Settings | None
    #: What a 3MF file holds.
    contents: Contents | None = None


def load_model(
    path: str | os.PathLike[str],
    *,
    file_format: str | None = None,
    plate: int | None = None,
    states: Collection[int] = (),
    sets: Collection[str] = (),
    **placement: Any,
) -> Model:
    """Read a model, repair it and place it on the bed, with what is marked on it.

    Parameters
    ----------
    path, file_format, plate
        As for `wireprint.load_mesh`. Files besides 3MF have no marks.
    states
        Numbers of extruders whose paint counts; none: that of all.
    sets
        Names of 3MF triangle sets that count as painted, too. Sets that are not named do not
        count, for most of them have nothing to do with printing.
    **placement
        See `wireprint.load_mesh`.

    Returns
    -------
    Model
        The mesh with its marks; of a project with its settings, too.

    Raises
    ------
    ModelError, SettingError
        See `wireprint.load_mesh`. Also where the painting is damaged, a set is not there, or a
        project's settings are wrong.
    """
    if format_of(path, file_format) != "3mf":
        from wireprint.regions import Region

        mesh = load_mesh(path, file_format=file_format, plate=plate, **placement)
        return Model(mesh, Region(), None, None)
    file = File3mf(Path(path), plate)
    mesh = placed(file, **placement)
    return Model(mesh, file.region(mesh, states, sets), file.settings(), file.scene.contents)


def load_marks(
    path: str | os.PathLike[str],
    *,
    plate: int | None = None,
    states: Collection[int] = (),
    sets: Collection[str] = (),
    **placement: Any,
) -> Region:
    """Read the marks of a 3MF file that is placed as the model is; its mesh is not kept.

    Where nothing is painted and `sets` is empty, all triangle sets count.

    Parameters
    ----------
    path, plate, states, sets, **placement
        See `load_model`.

    Raises
    ------
    ModelError
        See `load_model`. Also where the file has no mark at all.
    """
    file = File3mf(Path(path), plate)
    mesh = placed(file, **placement | {"units": "mm"})
    region = file.region(mesh, states, sets) or file.region(mesh, states, file.scene.set_names)
    if not region:
        raise ModelError(f"{path}: nothing in it is painted or marked as asked for")
    return region
