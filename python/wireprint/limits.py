"""The motion limits that print time is computed from: of a printer, a file, or a mapping."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Any, Final, Literal, TypedDict, get_args

from wireprint import toml
from wireprint._core import SettingError
from wireprint.catalogue import FOREIGN_SUFFIXES

if TYPE_CHECKING:
    from collections.abc import Mapping

    from wireprint.settings.motion import Motion
    from wireprint.settings.printer import Extruder, Printer

Firmware = Literal["klipper", "marlin", "marlin-jerk"]
FIRMWARES: Final[tuple[Firmware, ...]] = get_args(Firmware)
KINEMATICS: Final = ("cartesian", "corexy", "delta")

_PerAxis = tuple[float, float, float, float]

#: DEFAULT_XJERK … DEFAULT_EJERK of Marlin 2.1, mm/s.
_JERK: Final[_PerAxis] = (10.0, 10.0, 0.3, 5.0)
#: DEFAULT_AXIS_STEPS_PER_UNIT of Marlin 2.1.
_STEPS_PER_MM: Final[_PerAxis] = (80.0, 80.0, 400.0, 500.0)
#: Default JD of Marlin 2.1, mm.
_JUNCTION_DEVIATION: Final = 0.013


class RetractionTable(TypedDict):
    """What G10 and G11 do until a file says otherwise (mm, mm/s)."""

    length_mm: float
    speed_mm_s: float
    recover_speed_mm_s: float


#: Every limit (mm, mm/s, mm/s²) under the names of `settings.Motion`, none left open; `kinematics`
#: with a delta's geometry, `retraction` (None: the firmware's own defaults), and what only Marlin
#: reads under `marlin`, its arrays X, Y, Z, E. The core's `planner::Limits` takes it as it stands.
MotionTable = dict[str, Any]


def of_printer(printer: Printer) -> MotionTable:
    """Limits of a printer's profile."""
    return _resolved(printer.motion, printer.kinematics, retraction_of(printer.extruder))


def of_mapping(table: Mapping[str, Any]) -> MotionTable:
    """Limits of a table with the keys of ``[motion]`` in a profile, and ``kinematics``.

    Raises
    ------
    SettingError
        Where a key is unknown or missing, or a value out of its bounds.
    """
    from wireprint import _compose
    from wireprint.settings.motion import Motion

    values = dict(table)
    kinematics = values.pop("kinematics", None)
    if kinematics not in KINEMATICS:
        msg = f"kinematics is {kinematics!r}; it must be one of {', '.join(KINEMATICS)}"
        raise SettingError(msg)
    return _resolved(_compose.validate(Motion, values, {}), kinematics, None)


def of_file(where: str) -> MotionTable:
    """Limits of ``FILE.toml#TABLE``; without a table, of the file's top.

    A file of another program will do as well: ``printer.cfg``, a slicer's profile, or its G-code.

    Raises
    ------
    SettingError
        Where the file, the table or one of its values is wrong.
    """
    name, _, table = where.partition("#")
    if name.lower().endswith(FOREIGN_SUFFIXES):
        from wireprint.importing import motion_of

        return of_mapping(motion_of(name))
    values: Any = toml.read(Path(name))[1]
    for part in filter(None, table.split(".")):
        if not isinstance(values, dict) or part not in values:
            known = ", ".join(key for key, value in values.items() if isinstance(value, dict))
            msg = f"{name}: no table is called {table!r}; there are {known or 'none'}"
            raise SettingError(msg)
        values = values[part]
    if not isinstance(values, dict):
        msg = f"{name}: {table} is no table"
        raise SettingError(msg)
    try:
        return of_mapping(values)
    except SettingError as error:
        msg = f"{where}: {error}"
        raise SettingError(msg) from None


def firmware_of(printer: Printer) -> Firmware:
    """Whose planner times a printer's moves: that of its flavour, or the nearest relative's."""
    if printer.gcode.flavor == "klipper":
        return "klipper"
    marlin = printer.motion.marlin
    return "marlin-jerk" if marlin is not None and marlin.jerk is not None else "marlin"


def retraction_of(extruder: Extruder) -> RetractionTable:
    """Return what a printer's firmware is to do at G10 and G11: what its profile has us do."""
    return {
        "length_mm": extruder.retract_mm,
        "speed_mm_s": extruder.retract_speed_mm_s,
        "recover_speed_mm_s": extruder.unretract_speed_mm_s,
    }


def _resolved(motion: Motion, kinematics: str, retraction: RetractionTable | None) -> MotionTable:
    limits = motion.model_dump()
    if kinematics == "delta":
        _require_geometry(limits)
    return limits | {
        "kinematics": {"delta": limits} if kinematics == "delta" else kinematics,
        "retraction": retraction,
        "marlin": _marlin(motion),
    }


def _require_geometry(limits: Mapping[str, Any]) -> None:
    for name in ("delta_radius", "arm_length", "step_distance", "endstop_height"):
        if limits[name] is None:
            msg = f"a delta needs motion.{name}"
            raise SettingError(msg)


def _marlin(motion: Motion) -> dict[str, Any]:
    """Limits for Marlin; where a profile states none, those of Klipper, axis by axis."""
    given = motion.marlin
    if given is not None:
        own = given.model_dump()
        return own | {
            "jerk": given.jerk or _JERK,
            "steps_per_mm": given.steps_per_mm or _STEPS_PER_MM,
        }
    speed, accel = motion.max_velocity, motion.max_accel
    corner = motion.square_corner_velocity or _JERK[0]
    return {
        "max_velocity": (speed, speed, motion.max_z_velocity, motion.max_extrude_only_velocity),
        "max_accel": (accel, accel, motion.max_z_accel, motion.max_extrude_only_accel),
        "jerk": (corner, corner, *_JERK[2:]),
        "junction_deviation": _JUNCTION_DEVIATION,
        "print_accel": accel,
        "travel_accel": accel,
        "retract_accel": motion.max_extrude_only_accel,
        "steps_per_mm": _STEPS_PER_MM,
    }
