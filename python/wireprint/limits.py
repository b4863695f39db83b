"""The motion limits that print time is computed from: of a printer, a file, or a mapping."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Any, Final, Literal, TypedDict, get_args

from wireprint import toml
from wireprint._core import SettingError

if TYPE_CHECKING:
    from collections.abc import Mapping

    from wireprint.settings import Extruder, Motion, Printer

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


class MarlinTable(TypedDict):
    """What only Marlin reads; arrays are X, Y, Z, E."""

    max_velocity: _PerAxis
    max_accel: _PerAxis
    jerk: _PerAxis
    junction_deviation: float
    print_accel: float
    travel_accel: float
    retract_accel: float
    steps_per_mm: _PerAxis


class RetractionTable(TypedDict):
    """What G10 and G11 do until a file says otherwise (mm, mm/s)."""

    length_mm: float
    speed_mm_s: float
    recover_speed_mm_s: float


class MotionTable(TypedDict):
    """Every limit (mm, mm/s, mm/s²), none left open but a delta's geometry."""

    kinematics: str
    max_velocity: float
    max_accel: float
    square_corner_velocity: float
    minimum_cruise_ratio: float
    max_z_velocity: float
    max_z_accel: float
    max_extrude_only_velocity: float
    max_extrude_only_accel: float
    instantaneous_corner_velocity: float
    arc_resolution: float
    delta_radius: float | None
    arm_length: float | None
    step_distance: float | None
    endstop_height: float | None
    #: None: the firmware's own defaults.
    retraction: RetractionTable | None
    marlin: MarlinTable


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
    from wireprint.settings import Motion

    values = dict(table)
    kinematics = values.pop("kinematics", None)
    if kinematics not in KINEMATICS:
        msg = f"kinematics is {kinematics!r}; it must be one of {', '.join(KINEMATICS)}"
        raise SettingError(msg)
    return _resolved(_compose.validate(Motion, values, {}), kinematics, None)


def of_file(where: str) -> MotionTable:
    """Limits of ``FILE.toml#TABLE``; without a table, of the file's top.

    Raises
    ------
    SettingError
        Where the file, the table or one of its values is wrong.
    """
    name, _, table = where.partition("#")
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
    return {
        "kinematics": kinematics,
        "max_velocity": motion.max_velocity,
        "max_accel": motion.max_accel,
        "square_corner_velocity": motion.square_corner_velocity,
        "minimum_cruise_ratio": motion.minimum_cruise_ratio,
        "max_z_velocity": motion.max_z_velocity,
        "max_z_accel": motion.max_z_accel,
        "max_extrude_only_velocity": motion.max_extrude_only_velocity,
        "max_extrude_only_accel": motion.max_extrude_only_accel,
        "instantaneous_corner_velocity": motion.instantaneous_corner_velocity,
        "arc_resolution": motion.arc_resolution,
        "delta_radius": motion.delta_radius,
        "arm_length": motion.arm_length,
        "step_distance": motion.step_distance,
        "endstop_height": motion.endstop_height,
        "retraction": retraction,
        "marlin": _marlin(motion),
    }


def _marlin(motion: Motion) -> MarlinTable:
    """Limits for Marlin; where a profile states none, those of Klipper, axis by axis."""
    given = motion.marlin
    if given is not None:
        return {
            "max_velocity": given.max_velocity,
            "max_accel": given.max_accel,
            "jerk": given.jerk or _JERK,
            "junction_deviation": given.junction_deviation,
            "print_accel": given.print_accel,
            "travel_accel": given.travel_accel,
            "retract_accel": given.retract_accel,
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
