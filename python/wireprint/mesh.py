"""Stage 1: a model file becomes a mesh that stands on the bed."""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

from wireprint._core import Mesh, ModelError, SettingError

if TYPE_CHECKING:
    import os

#: Millimetres per unit.
UNITS_MM: Final = {"mm": 1.0, "cm": 10.0, "m": 1000.0, "inch": 25.4}
#: Formats that trimesh reads.
TRIMESH_FORMATS: Final = ("obj", "ply", "off", "3mf")


def load_mesh(
    path: str | os.PathLike[str],
    *,
    scale: float = 1.0,
    units: str = "mm",
    up: str = "z",
    rotate: tuple[float, float, float] = (0.0, 0.0, 0.0),
    height_mm: float | None = None,
) -> Mesh:
    """Read a model and place it on the bed.

    Parameters
    ----------
    path
        STL, OBJ, PLY, OFF or 3MF file.
    scale
        Factor on the model's size.
    units
        Unit of the file: ``mm``, ``cm``, ``m`` or ``inch``.
    up
        Axis of the file that points up: ``x``, ``y`` or ``z``.
    rotate
        Rotation about x, then y, then z, in degrees, after `up` was applied.
    height_mm
        Height to which the model is scaled in the end, mm.

    Returns
    -------
    Mesh
        Welded, oriented, centred at x = y = 0, its lowest point at z = 0.

    Raises
    ------
    ModelError
        The file cannot be read, or is too large or tiny for its units.
    SettingError
        An argument is out of its bounds.
    """
    if units not in UNITS_MM:
        raise SettingError(f"units is {units!r}; it must be one of {', '.join(UNITS_MM)}")
    suffix = str(path).rpartition(".")[2].lower()
    factor = scale * UNITS_MM[units]
    if suffix == "stl":
        return Mesh.load_stl(path, scale=factor, up=up, rotate=rotate, height_mm=height_mm)
    if suffix not in TRIMESH_FORMATS:
        raise ModelError(
            f"{path}: the format is not supported; use STL, {', '.join(TRIMESH_FORMATS).upper()}"
        )
    import numpy as np
    import trimesh

    model = trimesh.load_mesh(path, process=False)
    vertices = np.asarray(model.vertices, np.float64)
    faces = np.asarray(model.faces, np.int64)
    return Mesh.from_arrays(
        vertices, faces, scale=factor, up=up, rotate=rotate, height_mm=height_mm
    )
