"""Mesh formats besides STL, read through trimesh with a guard against hostile archives."""

from __future__ import annotations

import zipfile
from collections import Counter
from pathlib import Path
from typing import IO, TYPE_CHECKING, Final

from wireprint._core import ModelError

if TYPE_CHECKING:
    import numpy as np
    import numpy.typing as npt
    import trimesh

#: Formats that trimesh reads for us.
FORMATS: Final = ("obj", "ply", "off", "3mf")
#: Millimetres per unit of a 3MF file (3MF core specification 1.3, table 3-1 "unit").
_UNITS_3MF_MM: Final = {
    "micron": 0.001,
    "millimeter": 1.0,
    "centimeter": 10.0,
    "inch": 25.4,
    "foot": 304.8,
    "meter": 1000.0,
}
#: Most bytes that a 3MF archive may unpack to; its parts are held in memory.
_MOST_UNPACKED: Final = 1 << 28
#: Most copies of objects that a 3MF file may place, components of components multiplied.
_MOST_COPIES: Final = 10_000


def read_facets(
    path: Path, suffix: str
) -> tuple[npt.NDArray[np.float64], npt.NDArray[np.int64], float]:
    """Read vertices, faces and the unit of a file that is no STL.

    Objects, instances and components are joined, each with its transform; materials and
    textures are not read.

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
    unit_mm
        Millimetres per unit where the format states one (3MF), else 1.

    Raises
    ------
    ModelError
        The file cannot be read, or is too large to unpack.
    """
    import trimesh

    unit_mm = _checked_3mf(path) if suffix == "3mf" else 1.0
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
    return vertices, faces, unit_mm


def _joined(scene: trimesh.Scene) -> tuple[npt.NDArray[np.float64], npt.NDArray[np.int64]]:
    """Join the meshes of a trimesh scene, each where its transform puts it."""
    import numpy as np
    import trimesh

    vertices = [np.zeros((0, 3))]
    faces = [np.zeros((0, 3), np.int64)]
    count = 0
    for node in scene.graph.nodes_geometry:
        matrix, name = scene.graph[node]
        mesh = scene.geometry[name]
        if not isinstance(mesh, trimesh.Trimesh):
            continue
        mirrored = np.linalg.det(matrix[:3, :3]) < 0
        vertices.append(mesh.vertices @ matrix[:3, :3].T + matrix[:3, 3])
        faces.append((mesh.faces[:, ::-1] if mirrored else mesh.faces) + count)
        count += len(mesh.vertices)
    return np.concatenate(vertices), np.concatenate(faces).astype(np.int64)


def _checked_3mf(path: Path) -> float:
    """Millimetres per unit of a 3MF file that is safe to unpack."""
    try:
        with zipfile.ZipFile(path) as archive:
            unpacked = sum(entry.file_size for entry in archive.infolist())
            if unpacked > _MOST_UNPACKED:
                raise ModelError(
                    f"{path}: unpacks to {unpacked} bytes (at most {_MOST_UNPACKED}); "
                    "export it as binary STL"
                )
            names = [name for name in archive.namelist() if "3d/3dmodel.model" in name.lower()]
            if not names:
                raise ModelError(f"{path}: no 3MF, it has no part 3D/3dmodel.model")
            with archive.open(names[0]) as part:
                unit, copies = _unit_and_copies(part)
    except (OSError, zipfile.BadZipFile, NotImplementedError, EOFError) as error:
        raise ModelError(f"{path}: cannot be read as 3MF: {error}") from error
    except SyntaxError as error:  # lxml's parse errors
        raise ModelError(f"{path}: its XML is damaged: {error}") from error
    if copies > _MOST_COPIES:
        raise ModelError(f"{path}: places more than {_MOST_COPIES} copies of its objects")
    if unit not in _UNITS_3MF_MM:
        raise ModelError(f"{path}: unknown unit {unit!r}")
    return _UNITS_3MF_MM[unit]


def _unit_and_copies(part: IO[bytes]) -> tuple[str, int]:
    """Read the unit of a 3MF model part and how many objects its build places, capped."""
    from lxml import etree  # type: ignore[import-untyped]

    unit = "millimeter"
    components: dict[str, list[str]] = {}
    items: list[str] = []
    inside: list[str] = []
    events = etree.iterparse(part, events=("start", "end"), resolve_entities=False)
    for event, element in events:
        tag = etree.QName(element).localname
        if event == "end":
            element.clear()
        elif tag == "model":
            unit = element.get("unit", unit)
        elif tag == "object":
            inside = components.setdefault(element.get("id", ""), [])
        elif tag == "component":
            inside.append(element.get("objectid", ""))
        elif tag == "item":
            items.append(element.get("objectid", ""))
    return unit, _copies(items, components)


def _copies(items: list[str], components: dict[str, list[str]]) -> int:
    """Count the objects that the items place, directly and as components; capped on cycles."""
    copies, level = 0, Counter(items)
    while level and copies <= _MOST_COPIES:
        copies += level.total()
        below: Counter[str] = Counter()
        for name, times in level.items():
            for child in components.get(name, ()):
                below[child] += times
        level = below
    return copies
