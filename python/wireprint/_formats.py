"""Mesh formats besides STL and 3MF, read through trimesh."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Final

from wireprint._core import ModelError

if TYPE_CHECKING:
    import numpy as np
    import numpy.typing as npt
    import trimesh

#: Formats that trimesh reads for us.
FORMATS: Final = ("obj", "ply", "off")


def read_facets(path: Path, suffix: str) -> tuple[npt.NDArray[np.float64], npt.NDArray[np.int64]]:
    """Read vertices and faces of a file; materials and textures are not read.

    Parameters
    ----------
    path
        The file.
    suffix
        One of `FORMATS`.

    Returns
    -------
    vertices
        float64 of shape (N, 3), in the file's unit.
    faces
        int64 of shape (M, 3), indices of vertices.

    Raises
    ------
    ModelError
        The file cannot be read.
    """
    import trimesh

    try:
        with path.open("rb") as file:
            scene = trimesh.load_scene(file, suffix, process=False, skip_materials=True)
        vertices, faces = _joined(scene)
    except MemoryError:
        raise
    except Exception as error:  # trimesh's loaders raise whatever their parsing trips over
        raise ModelError(f"{path}: cannot be read as {suffix.upper()}: {error}") from error
    if len(faces) == 0:
        raise ModelError(f"{path}: the file has no facets")
    return vertices, faces


def _joined(scene: trimesh.Scene) -> tuple[npt.NDArray[np.float64], npt.NDArray[np.int64]]:
    """Join the meshes of a trimesh scene; these formats know no transforms."""
    import numpy as np
    import trimesh

    vertices = [np.zeros((0, 3))]
    faces = [np.zeros((0, 3), np.int64)]
    count = 0
    for node in scene.graph.nodes_geometry:
        mesh = scene.geometry[scene.graph[node][1]]
        if isinstance(mesh, trimesh.Trimesh):
            vertices.append(mesh.vertices)
            faces.append(mesh.faces + count)
            count += len(mesh.vertices)
    return np.concatenate(vertices), np.concatenate(faces).astype(np.int64)
