"""A 3MF file that was read, and not placed yet: its meshes, marks and settings."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from wireprint._core import Mesh
from wireprint.naming import named
from wireprint.threemf.archive import Archive
from wireprint.threemf.scene import PROJECT_TYPE, read_scene, related_part

if TYPE_CHECKING:
    from collections.abc import Collection
    from pathlib import Path

    from wireprint.project import Saved
    from wireprint.regions import Region
    from wireprint.settings import Settings


class File3mf:
    """A 3MF file that was read, and not placed yet."""

    def __init__(self, path: Path, plate: int | None = None) -> None:
        self.path = path
        with named(path), Archive(path) as archive:
            self.scene = read_scene(archive, plate)
            self._saved = _saved(archive)

    def mesh(self, *, as_it_is: bool, **placement: Any) -> Mesh:
        """Return the mesh, repaired and placed.

        Parameters
        ----------
        as_it_is
            Whether a project's mesh stays as it was saved, unless another program changed it.
        **placement
            What `Mesh.from_arrays` takes.
        """
        placement["scale"] *= self.scene.unit_mm
        with named(self.path):
            vertices, faces = self.scene.facets()
            if as_it_is and self._saved is not None and self._saved.is_of(vertices, faces):
                return Mesh.restored(vertices, faces, self._saved.paired)
            notes = self.scene.contents.sentences()
            return Mesh.from_arrays(vertices, faces, **placement, notes=notes)

    def region(self, mesh: Mesh, states: Collection[int], sets: Collection[str]) -> Region:
        """Return what is painted, and then marked in the project, in a mesh's frame."""
        from wireprint.regions.painted import painted

        with named(self.path):
            region = painted(self.scene, states, sets)
        if self._saved is not None:
            region = region.add(self._saved.strokes.region())
        return region.transformed(mesh.placement)

    def settings(self) -> Settings | None:
        """Return a project's settings."""
        with named(self.path):
            return _settings(self._saved)


def project_settings(path: Path) -> Settings | None:
    """Return the settings of a project without reading its mesh; None for any other file.

    Raises
    ------
    ModelError, SettingError
        It is damaged, or its settings are wrong.
    """
    if path.suffix.lower() != ".3mf":
        return None
    with named(path), Archive(path) as archive:
        return _settings(_saved(archive))


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
