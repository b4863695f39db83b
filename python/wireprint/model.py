"""Models with what is marked on them: painted 3MF files, and projects."""

from __future__ import annotations

from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

from wireprint._core import Mesh, ModelError, SettingError, WireprintError
from wireprint.mesh import AS_IT_IS, load_mesh
from wireprint.threemf.archive import Archive
from wireprint.threemf.scene import PROJECT_TYPE, read_scene, related_part

if TYPE_CHECKING:
    import os
    from collections.abc import Collection, Iterator

    from wireprint.project import Saved
    from wireprint.regions import Region
    from wireprint.settings import Settings


@dataclass(frozen=True)
class Model:
    """A mesh on the bed, and what its file says besides."""

    mesh: Mesh
    #: What is marked in the file, in the mesh's frame.
    region: Region
    #: The settings of a project.
    settings: Settings | None


def load_model(
    path: str | os.PathLike[str],
    *,
    states: Collection[int] = (),
    sets: Collection[str] = (),
    **placement: Any,
) -> Model:
    """Read a model, repair it and place it on the bed, with what is marked on it.

    Parameters
    ----------
    path
        As for `wireprint.load_mesh`. Files besides 3MF have no marks.
    states
        Numbers of extruders whose paint counts; none: that of all.
    sets
        Names of 3MF triangle sets that count as painted, too. Sets that are not named do not
        count, for most of them have nothing to do with printing.
    **placement
        See `wireprint.load_mesh`.

    Raises
    ------
    ModelError, SettingError
        See `wireprint.load_mesh`. Also where the painting is damaged, a set is not there, or a
        project's settings are wrong.
    """
    if Path(path).suffix.lower() != ".3mf":
        from wireprint.regions import Region

        return Model(load_mesh(path, **placement), Region(), None)
    file = File3mf(Path(path))
    mesh = file.mesh(**placement)
    return Model(mesh, file.region(mesh, states, sets), file.settings())


def load_marks(
    path: str | os.PathLike[str],
    *,
    states: Collection[int] = (),
    sets: Collection[str] = (),
    **placement: Any,
) -> Region:
    """Read the marks of a 3MF file that is placed as the model is; its mesh is not kept.

    Where nothing is painted and `sets` is empty, all triangle sets count.

    Parameters
    ----------
    path, states, sets, **placement
        See `load_model`.

    Raises
    ------
    ModelError
        See `load_model`. Also where the file has no mark at all.
    """
    file = File3mf(Path(path))
    mesh = file.mesh(**placement | {"units": "mm"})
    region = file.region(mesh, states, sets) or file.region(mesh, states, file.scene.set_names)
    if not region:
        raise ModelError(f"{path}: nothing in it is painted or marked as asked for")
    return region


def project_settings(path: Path) -> Settings | None:
    """Return the settings of a project without reading its mesh; None for any other file.

    Raises
    ------
    ModelError, SettingError
        It is damaged, or its settings are wrong.
    """
    if path.suffix.lower() != ".3mf":
        return None
    with _named(path), Archive(path) as archive:
        return _settings(_saved(archive))


class File3mf:
    """A 3MF file that was read, and not placed yet."""

    def __init__(self, path: Path) -> None:
        self.path = path
        with _named(path), Archive(path) as archive:
            self.scene = read_scene(archive)
            self._saved = _saved(archive)

    def mesh(self, **placement: Any) -> Mesh:
        """Return the mesh where `wireprint.load_mesh` puts it.

        A project's mesh stays as it was saved, unless it is to be placed otherwise, or another
        program changed it.
        """
        options = AS_IT_IS | placement
        as_it_is = options == AS_IT_IS
        if options.pop("units") != AS_IT_IS["units"]:
            msg = f"{self.path}: a 3MF file states its own unit; use scale instead of units"
            raise SettingError(msg)
        vertices, faces = self.scene.facets()
        options["scale"] *= self.scene.unit_mm
        with _named(self.path):
            if as_it_is and self._saved is not None and self._saved.is_of(vertices, faces):
                return Mesh.restored(vertices, faces, self._saved.paired)
            return Mesh.from_arrays(vertices, faces, **options)

    def region(self, mesh: Mesh, states: Collection[int], sets: Collection[str]) -> Region:
        """Return what is painted, and then marked in the project, in a mesh's frame."""
        from wireprint.regions.painted import painted

        with _named(self.path):
            region = painted(self.scene, states, sets)
        if self._saved is not None:
            region = region.add(self._saved.strokes.region())
        return region.transformed(mesh.placement)

    def settings(self) -> Settings | None:
        """Return a project's settings."""
        with _named(self.path):
            return _settings(self._saved)


def _saved(archive: Archive) -> Saved | None:
    """Return what a file holds besides its mesh; None where it is no project."""
    name = related_part(archive, PROJECT_TYPE)
    if name is None:
        return None
    # Here and above, what imports pydantic comes after what ends a hostile file.
    from wireprint.project import read_saved

    return read_saved(archive, name)


def _settings(saved: Saved | None) -> Settings | None:
    """Validate the settings of a project."""
    if saved is None:
        return None
    from wireprint.settings import Settings

    return Settings.from_mapping(saved.settings)


@contextmanager
def _named(path: Path) -> Iterator[None]:
    """Name the file in errors about it."""
    try:
        yield
    except WireprintError as error:
        raise type(error)(f"{path}: {error}") from error
