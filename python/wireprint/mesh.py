"""Stage 1: a model file becomes a mesh that stands on the bed."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Final

from wireprint._core import (
    FORMATS,
    HOLE_PERIMETER,
    WELD_DISTANCE,
    Mesh,
    ModelError,
    SettingError,
)

if TYPE_CHECKING:
    import os

    from wireprint.file3mf import File3mf

#: Millimetres per unit.
UNITS_MM: Final = {"mm": 1.0, "cm": 10.0, "m": 1000.0, "inch": 25.4}

#: Suffixes of files of exact surfaces, which the extra ``step`` reads.
_CAD: Final = ("step", "stp", "iges", "igs")
#: Suffixes of the files that `load_mesh` reads.
SUFFIXES: Final = (*FORMATS, "3mf", "amf", *_CAD)

#: Suffixes of files that slicers write for printers: no models.
_SLICED: Final = ("gcode", "gco", "g", "nc", "ngc", "bgcode", "ufp")


def load_mesh(
    path: str | os.PathLike[str],
    *,
    file_format: str | None = None,
    plate: int | None = None,
    scale: float = 1.0,
    units: str = "mm",
    up: str = "z",
    rotate: tuple[float, float, float] = (0.0, 0.0, 0.0),
    height_mm: float | None = None,
    hole_perimeter: float = HOLE_PERIMETER,
    weld_distance: float = WELD_DISTANCE,
) -> Mesh:
    """Read a model, repair it and place it on the bed.

    Parameters
    ----------
    path
        STL, OBJ, PLY, OFF, 3MF, AMF, STEP or IGES file. Objects, instances and components are
        joined, each with its transform; overlapping bodies stay as they are until slices are
        united. Of slicers' projects negative parts are cut out; modifiers, what is for supports,
        and what is not to be printed is left out; the mesh's `notes` say so.
    file_format
        One of `SUFFIXES`, where the name of the file does not end in it.
    plate
        Number of the plate of a slicer's project; None: the first one that has something to print.
    scale
        Factor on the model's size.
    units
        Unit of the file: ``mm``, ``cm``, ``m`` or ``inch``. 3MF, AMF and CAD files state their
        unit, which is respected, so `units` must stay ``mm`` there.
    up
        Axis of the file that points up: ``x``, ``y`` or ``z``.
    rotate
        Rotation about x, then y, then z, in degrees, after `up` was applied.
    height_mm
        Height to which the model is scaled in the end, mm.
    hole_perimeter
        Longest perimeter of a hole that is closed, as a share (0–1) of the model's diagonal;
        longer boundary loops are kept as rims of an open model. A hole of three edges is a
        missing facet and always closed.
    weld_distance
        Distance at which vertices on a crack are welded, as a share (0–1) of the diagonal.

    Returns
    -------
    Mesh
        Welded, oriented outwards, centred at x = y = 0, its lowest point at z = 0. Its `report`
        counts what was repaired.

    Raises
    ------
    ModelError
        The file cannot be read, makes no surface, or is too large for its units.
    SettingError
        An argument is out of its bounds.
    """
    unit_mm = mm_per(units)
    suffix = format_of(path, file_format)
    placement: dict[str, Any] = {
        "scale": scale,
        "up": up,
        "rotate": rotate,
        "height_mm": height_mm,
        "hole_perimeter": hole_perimeter,
        "weld_distance": weld_distance,
    }
    if suffix == "3mf":
        from pathlib import Path

        from wireprint.file3mf import File3mf

        return placed(File3mf(Path(path), plate), units=units, **placement)
    if suffix == "amf":
        from pathlib import Path

        from wireprint.fileamf import amf_mesh

        _states_its_unit(path, "an AMF", units)
        _no_plates(path, plate)
        return amf_mesh(Path(path), **placement)
    if suffix in _SLICED:
        msg = f"{path}: it holds G-code, sliced already, and no model; take what it was made from"
        raise ModelError(msg)
    if suffix in _CAD:
        from pathlib import Path

        from wireprint.cad import cad_mesh

        _states_its_unit(path, "a CAD", units)
        _no_plates(path, plate)
        return cad_mesh(Path(path), suffix, **placement)
    if suffix not in FORMATS:
        known = ", ".join(name.upper() for name in SUFFIXES)
        msg = (
            f"{path}: the format is not supported; convert it to one of {known}, or name the "
            "format (--format) if the file is in one of them"
        )
        raise ModelError(msg)
    _no_plates(path, plate)
    return Mesh.load(path, suffix, **placement | {"scale": scale * unit_mm})


def _no_plates(path: str | os.PathLike[str], plate: int | None) -> None:
    """Refuse the number of a plate where there are none.

    Raises
    ------
    ModelError
        It is not the first one's.
    """
    if plate not in (None, 1):
        raise ModelError(f"{path}: there is no plate {plate}; only 3MF files have plates")


def _states_its_unit(path: str | os.PathLike[str], kind: str, units: str) -> None:
    """Refuse another unit than a file's own.

    Raises
    ------
    SettingError
        A unit is given.
    """
    if units != "mm":
        raise SettingError(f"{path}: {kind} file states its own unit; use scale instead of units")


def mm_per(units: str) -> float:
    """Return how many millimetres a unit has.

    Raises
    ------
    SettingError
        There is no such unit.
    """
    if units not in UNITS_MM:
        raise SettingError(f"units is {units!r}; it must be one of {', '.join(UNITS_MM)}")
    return UNITS_MM[units]


def format_of(path: str | os.PathLike[str], file_format: str | None = None) -> str:
    """Return the format of a model's file: the one that is given, else what its name ends in."""
    return file_format or str(path).rpartition(".")[2].lower()


#: How `load_mesh` places a model unless it is told otherwise.
AS_IT_IS: Final[dict[str, Any]] = {
    name: value
    for name, value in (load_mesh.__kwdefaults__ or {}).items()
    if name not in ("file_format", "plate")
}


def placed(file: File3mf, **placement: Any) -> Mesh:
    """Place the mesh of a 3MF file as `load_mesh` does.

    A project's mesh stays as it was saved, unless it is to be placed otherwise, or another program
    changed it.

    Raises
    ------
    ModelError, SettingError
        See `load_mesh`.
    """
    options = AS_IT_IS | placement
    as_it_is = options == AS_IT_IS
    _states_its_unit(file.path, "a 3MF", options.pop("units"))
    return file.mesh(as_it_is=as_it_is, **options)
