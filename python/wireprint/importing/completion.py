"""What no source says of a printer, filled in, or asked for by name."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Any, Final

from wireprint._core import SettingError
from wireprint.bounds import (
    Accel,
    BedSize,
    CarriageHeight,
    CarriageReach,
    CornerSpeed,
    Speed,
    bounds_of,
)
from wireprint.importing import hotends, sequences
from wireprint.importing.draft import whole_if_it_is

if TYPE_CHECKING:
    from collections.abc import Mapping

    from wireprint.importing.draft import Draft

#: Finds a printer of ours by names: its profile, the name that means it, and its tables.
Namesake = Callable[[list[str]], "tuple[str, str, Mapping[str, Any]] | None"]
#: What makes a head's shape; a nozzle is known from anywhere.
_SHAPE: Final = ("tip_radius_mm", "slant_deg", "cone_height_mm", "block_radius_mm")
#: What must be known of any printer.
_NEEDED: Final = (
    "bed.shape",
    "bed.height_mm",
    "bed.origin",
    "motion.max_velocity",
    "motion.max_accel",
    "gcode.flavor",
)
#: Figures in which sources write "no limit", or nonsense, and what they can be.
BOUNDED: Final = {
    "bed.width_mm": BedSize,
    "bed.depth_mm": BedSize,
    "bed.diameter_mm": BedSize,
    "bed.height_mm": BedSize,
    "head.carriage_height_mm": CarriageHeight,
    "head.carriage_radius_mm": CarriageReach,
    "motion.max_velocity": Speed,
    "motion.max_accel": Accel,
    "motion.square_corner_velocity": CornerSpeed,
    "motion.max_z_velocity": Speed,
    "motion.max_z_accel": Accel,
    "motion.max_extrude_only_velocity": Speed,
    "motion.max_extrude_only_accel": Accel,
    "motion.marlin.max_velocity": Speed,
    "motion.marlin.max_accel": Accel,
    "motion.marlin.print_accel": Accel,
    "motion.marlin.travel_accel": Accel,
    "motion.marlin.retract_accel": Accel,
    "motion.marlin.jerk": CornerSpeed,
}
#: Of a carriage that nothing is known of: as the MK4S's and the Voron's.
_CARRIAGE_HEIGHT_MM: Final = 14
_CARRIAGE_RADIUS_MM: Final = 45
_DELTA: Final = ("delta_radius", "arm_length", "step_distance", "endstop_height")


def complete(
    draft: Draft,
    name: str,
    hotend: str | None,
    like: tuple[str, Mapping[str, Any]] | None,
    namesake: Namesake | None,
) -> None:
    """Fill a draft up until it is a profile.

    Parameters
    ----------
    draft
        What the source says.
    name
        The source, for errors.
    hotend
        Name in the table of hot ends; None: not said.
    like
        Printer whose figures hold where the source has none: its name and its tables.
    namesake
        Finds a printer by the names that the source has for it; see `imported`.

    Raises
    ------
    SettingError
        Something is missing that must not be guessed; the message says how to give it.
    """
    _settle(draft)
    _keep_within_bounds(draft)
    if hotend is not None:
        hotends.add_to(draft, hotend)
    find = namesake if like is None and _lacks(draft) else None
    if find is not None and (found := find(draft.called)) is not None:
        profile, called, values = found
        like = profile, values
        draft.remark(f"what is not said of {called!r} is as our {profile} has it, the head, too")
    if like is not None:
        elder, values = like
        _fill_from(draft, values, f"as {elder} has it", ())
    missing = [key for key in _NEEDED if draft.get(key) is None]
    if missing:
        msg = (
            f"{name}: it does not say {missing[0]}; name a printer that is like it by "
            "--like (wireprint profiles lists them), or import the printer's own profile"
        )
        raise SettingError(f"{msg}; {draft.hint}" if draft.hint else msg)
    missing = [key for key in _SHAPE if draft.get(f"head.{key}") is None]
    if missing:
        known = ", ".join(hotends.HOTENDS)
        msg = (
            f"{name}: it does not say the head's shape (head.{missing[0]}); import it with the hot "
            f"end, --hotend NAME ({known}), or with a printer that has such a head, --like NAME; "
            f"where a printer is named, put either behind a #: {name}#v6"
        )
        raise SettingError(msg)
    geometry = [key for key in _DELTA if draft.get(f"motion.{key}") is None]
    if draft.get("kinematics") == "delta" and geometry:
        msg = (
            f"{name}: it does not say motion.{geometry[0]} of a delta; import its firmware's "
            "configuration (printer.cfg), or name a delta that is like it by --like"
        )
        raise SettingError(msg)
    _estimate(draft)


def _lacks(draft: Draft) -> bool:
    """Whether something is missing that must not be guessed."""
    delta = _DELTA if draft.get("kinematics") == "delta" else ()
    needed = (*_NEEDED, *(f"head.{key}" for key in _SHAPE), *(f"motion.{key}" for key in delta))
    return any(draft.get(key) is None for key in needed)


def _settle(draft: Draft) -> None:
    """Bring what slicers mean in another way into the order of a head and its limits."""
    tip, nozzle = draft.get("head.tip_radius_mm"), draft.get("head.nozzle_mm")
    if tip is not None and nozzle is not None and tip < nozzle / 2:
        draft.drop("head.tip_radius_mm")
    for key, least in (("head.carriage_height_mm", 8.0), ("head.carriage_radius_mm", 25.0)):
        value = draft.get(key)
        if value is not None and value < least:
            draft.remark(f"{draft.comments[tuple(key.split('.'))]}: {value:g} mm is no carriage's")
            draft.drop(key)


def _keep_within_bounds(draft: Draft) -> None:
    """Bring figures that stand for "no limit" down to the most that a profile may have.

    Raises
    ------
    SettingError
        A figure is less than any printer's; the error names where it stands.
    """
    for key, kind in BOUNDED.items():
        value = draft.get(key)
        if value is None:
            continue
        least, most = bounds_of(kind)
        place = draft.comments[tuple(key.split("."))]
        numbers = value if isinstance(value, list) else [value]
        if min(numbers) < least:
            msg = f"{place}: {min(numbers):g} is less than any printer's {key}, {least:g}"
            raise SettingError(msg)
        if max(numbers) > most:
            draft.remark(f"{place}: {max(numbers):g} is taken as {most:g}, the most for {key}")
            kept = [whole_if_it_is(min(number, most)) for number in numbers]
            draft.put(key, kept if isinstance(value, list) else kept[0], place)


def _fill_from(
    draft: Draft, values: Mapping[str, Any], source: str, prefix: tuple[str, ...]
) -> None:
    for key, value in values.items():
        path = (*prefix, key)
        if path in (("name",), ("known_as",), ("homing",)):
            continue
        if path == ("bed",) and draft.get("bed.shape") is not None:
            value = {name: one for name, one in value.items() if name in ("height_mm", "origin")}
        if path == ("motion", "marlin") and draft.get("motion.max_velocity") is not None:
            continue
        if isinstance(value, dict):
            _fill_from(draft, value, source, path)
        else:
            draft.fill(".".join(path), value, source)


def _estimate(draft: Draft) -> None:
    """Fill in what differs little from printer to printer."""
    motion = draft.get("motion")
    draft.fill("name", "my printer", "nothing names it")
    draft.fill("head.nozzle_mm", 0.4, "assumed: the usual one")
    draft.fill("motion.max_z_velocity", min(10.0, motion["max_velocity"]), "estimate: a leadscrew")
    draft.fill("motion.max_z_accel", min(100.0, motion["max_accel"]), "estimate: a leadscrew")
    draft.fill("motion.max_extrude_only_velocity", 50, "estimate: a geared drive")
    draft.fill("motion.max_extrude_only_accel", 1000, "estimate: a geared drive")
    draft.fill("extruder.filament_diameter_mm", 1.75, "assumed: the usual one")
    draft.fill("extruder.retract_mm", 0.8, "estimate: a direct drive; a Bowden tube wants 4")
    fastest = motion["max_extrude_only_velocity"]
    draft.fill("extruder.retract_speed_mm_s", min(35, fastest), "estimate, within the drive's")
    back = draft.get("extruder.retract_speed_mm_s")
    draft.fill("extruder.unretract_speed_mm_s", back, "as fast, so that a strand starts full")
    draft.fill("extruder.max_flow_mm3_s", 11, "estimate: a V6-like hot end with PLA")
    fast = motion["max_velocity"]
    draft.fill("speeds.print_mm_s", 30, "the paper's optimum with a pause")
    draft.fill("speeds.travel_mm_s", round(min(fast, 150.0)), "estimate: at most 150")
    draft.fill("speeds.first_layer_mm_s", 20, "estimate: for a grip on the bed")
    for key in ("print_mm_s", "travel_mm_s", "first_layer_mm_s"):
        # Another printer's may be more than this one has.
        if draft.get(f"speeds.{key}") > fast:
            draft.put(f"speeds.{key}", fast, "all that the machine has")
    draft.fill("gcode.start", sequences.plain_start(), "nothing says how a print starts")
    draft.fill("gcode.end", sequences.PLAIN_END, "nothing says how a print ends")
    draft.fill("cooling.method", "fan", "as most are sold")
    head = draft.get("head")
    # Slicers tell a clearance that may be too large for the block, but not too small.
    height = max(head.get("carriage_height_mm") or _CARRIAGE_HEIGHT_MM, head["cone_height_mm"])
    draft.put(
        "head.carriage_height_mm",
        height,
        draft.comments.get(("head", "carriage_height_mm"), "estimate: measure it"),
    )
    radius = max(head.get("carriage_radius_mm") or _CARRIAGE_RADIUS_MM, head["block_radius_mm"])
    draft.put(
        "head.carriage_radius_mm",
        radius,
        draft.comments.get(("head", "carriage_radius_mm"), "estimate: measure it"),
    )
