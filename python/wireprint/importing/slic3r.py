"""PrusaSlicer's and SuperSlicer's settings, and OrcaSlicer's under the same names, as a profile."""

from __future__ import annotations

import re
from typing import TYPE_CHECKING, Any, Final

from wireprint._core import SettingError
from wireprint.gcode.sequence import END_NAMES, START_NAMES
from wireprint.importing.draft import Draft, number, whole_if_it_is
from wireprint.importing.names import TEMPERATURES, Names
from wireprint.importing.placeholders import resolved
from wireprint.importing.reading import Given, unescaped
from wireprint.importing.sequences import end_of, start_of, tell_left_out
from wireprint.text import one_line

if TYPE_CHECKING:
    from wireprint.importing.reading import Config

#: Their names of firmwares → ours.
_FLAVORS: Final = {
    "marlin": "marlin",
    "marlin2": "marlin",
    "klipper": "klipper",
    "reprapfirmware": "reprapfirmware",
    "rrf": "reprapfirmware",
    "reprap": "marlin",
    "reprap/sprinter": "marlin",
    "repetier": "repetier",
}
#: A first value of a vector → one of ours, where it is above 0.
_FIGURES: Final = {
    "max_print_height": "bed.height_mm",
    "nozzle_diameter": "head.nozzle_mm",
    "filament_diameter": "extruder.filament_diameter_mm",
    "retract_length": "extruder.retract_mm",
    "retract_speed": "extruder.retract_speed_mm_s",
    "deretract_speed": "extruder.unretract_speed_mm_s",
    "filament_max_volumetric_speed": "extruder.max_flow_mm3_s",
    "machine_max_feedrate_x": "motion.max_velocity",
    "machine_max_feedrate_z": "motion.max_z_velocity",
    "machine_max_feedrate_e": "motion.max_extrude_only_velocity",
    "machine_max_acceleration_extruding": "motion.max_accel",
    "machine_max_acceleration_z": "motion.max_z_accel",
    "machine_max_acceleration_retracting": "motion.max_extrude_only_accel",
    "machine_max_jerk_x": "motion.square_corner_velocity",
    "extruder_clearance_height": "head.carriage_height_mm",
    "extruder_clearance_radius": "head.carriage_radius_mm",
}
#: Those that Marlin keeps for each axis: key of theirs, key of ours.
_PER_AXIS: Final = {
    "machine_max_feedrate_": "motion.marlin.max_velocity",
    "machine_max_acceleration_": "motion.marlin.max_accel",
    "machine_max_jerk_": "motion.marlin.jerk",
}
#: What is said of printers with two motors to both axes, or how such ones are called.
_COREXY: Final = re.compile(
    r"core[ _-]?(?:xy|one)|voron[ _]?(?:v?[02]|trident)|rat[ _]?rig|bambu lab (?:p1|x1)|creality k1"
    r"|prusa xl|^xl",
    re.IGNORECASE,
)
_POINT: Final = re.compile(
    r"\s*(-?[\d.]+(?:e[-+]?\d+)?)x(-?[\d.]+(?:e[-+]?\d+)?)\s*", re.IGNORECASE
)
#: A circle is drawn with more corners than any other bed has.
_ROUND_FROM: Final = 12


def draft_of(config: Config, name: str) -> Draft:
    """Return what the settings of a slicer say of a printer.

    Parameters
    ----------
    config
        Its settings, under PrusaSlicer's names.
    name
        The file, for errors.

    Raises
    ------
    SettingError
        Nothing in it describes a printer, or a value is damaged.
    """
    known = {"bed_shape", "nozzle_diameter", "max_print_height", "start_gcode"}
    if not known & set(config):
        msg = f"{name}: nothing in it describes a printer ({', '.join(sorted(known))})"
        raise SettingError(msg)
    draft = Draft()
    _add_name(draft, config)
    _add_bed(draft, config)
    for theirs, ours in _FIGURES.items():
        if theirs in config and (value := _said(config[theirs])) > 0:
            draft.put(ours, whole_if_it_is(value), _source(config[theirs]))
    _add_kinematics(draft, config)
    _add_marlin(draft, config)
    _add_gcode(draft, config)
    _add_temperatures(draft, config)
    return draft


def _source(given: Given) -> str:
    return given.place


def _first(given: Given) -> Given:
    """Return the first value of a vector, which is that of the first extruder."""
    return Given(re.split(r"[,;]", given.text)[0].strip().strip('"'), given.place)


def _said(given: Given) -> float:
    """Return a vector's first number; 0 where it is empty, as for what has no such thing."""
    first = _first(given)
    return number(first) if first.text else 0.0


def _add_name(draft: Draft, config: Config) -> None:
    for key in ("printer_settings_id", "printer_model", "name"):
        given = config.get(key)
        if given is not None and (called := given.text.strip().strip('"').strip()):
            draft.called.append(called)
            draft.fill("name", one_line(called)[:100], _source(given))
            draft.fill("known_as", [one_line(called)[:100]], "as the slicer writes it")


def _add_bed(draft: Draft, config: Config) -> None:
    given = config.get("bed_shape")
    if given is None:
        return
    points = [_POINT.fullmatch(point) for point in re.split(r"[,;]", given.text.strip('"'))]
    corners = [(float(point[1]), float(point[2])) for point in points if point]
    if len(corners) < 3 or len(corners) != len(points):
        shown = one_line(given.text)[:40]
        raise SettingError(f"{given.place}: {shown!r} is no outline of a bed, as 0x0,250x0,…")
    add_outline(draft, corners, given.place)


def add_outline(draft: Draft, corners: list[tuple[float, float]], source: str) -> None:
    """Keep a bed's outline, as a rectangle or a circle."""
    low = [min(corner[axis] for corner in corners) for axis in (0, 1)]
    high = [max(corner[axis] for corner in corners) for axis in (0, 1)]
    size = [high[axis] - low[axis] for axis in (0, 1)]
    middle = [(high[axis] + low[axis]) / 2 for axis in (0, 1)]
    centred = all(abs(middle[axis]) < 0.02 * size[axis] for axis in (0, 1))
    origin = "centre" if centred else "corner"
    if len(corners) >= _ROUND_FROM and abs(size[0] - size[1]) < 0.05 * size[0]:
        draft.put("bed.shape", "round", source)
        draft.put("bed.diameter_mm", whole_if_it_is(round(min(size), 1)), source)
    else:
        draft.put("bed.shape", "rectangular", source)
        if not centred and any(abs(edge) > 0.01 for edge in low):
            # As far beyond its high edges as it begins behind 0: prints stand in its middle.
            size = [high[axis] + max(0.0, low[axis]) for axis in (0, 1)]
            draft.remark(
                f"{source}: the bed begins at ({low[0]:g}, {low[1]:g}); it is taken to begin at 0, "
                f"so keep to models of {high[0] - low[0]:g} × {high[1] - low[1]:g} mm"
            )
        elif centred:
            size = [2 * min(high[axis], -low[axis]) for axis in (0, 1)]
        draft.put("bed.width_mm", whole_if_it_is(round(size[0], 3)), source)
        draft.put("bed.depth_mm", whole_if_it_is(round(size[1], 3)), source)
    draft.put("bed.origin", origin, source)


def _add_kinematics(draft: Draft, config: Config) -> None:
    given = config.get("printer_structure")
    theirs = given.text.lower() if given else ""
    said = {"i3": "cartesian", "corexy": "corexy", "delta": "delta", "hbot": "corexy"}
    if given is not None and theirs in said:
        draft.put("kinematics", said[theirs], _source(given))
    elif draft.get("bed.shape") == "round" and draft.get("bed.origin") == "centre":
        draft.put("kinematics", "delta", "a round bed around x = y = 0")
    else:
        keys = ("printer_notes", "name", "printer_model", "printer_settings_id")
        notes = " ".join(config[key].text for key in keys if key in config)
        core = _COREXY.search(notes)
        draft.put(
            "kinematics",
            "corexy" if core else "cartesian",
            f"known of {core[0]}" if core else "assumed: slicers do not say it",
        )
    if draft.get("kinematics") == "cartesian":
        draft.put("motion.bed_moves_y", True, "as machines of the i3 kind are built")


def _add_marlin(draft: Draft, config: Config) -> None:
    for theirs, ours in _PER_AXIS.items():
        given = [config.get(theirs + axis) for axis in "xyze"]
        values = [number(_first(one)) for one in given if one is not None]
        if len(values) == 4 and all(value > 0 for value in values):
            place = given[0].place if given[0] else ""
            draft.put(ours, [whole_if_it_is(value) for value in values], f"{place} …")
    marlin = draft.get("motion.marlin") or {}
    if "max_velocity" not in marlin or "max_accel" not in marlin:
        if marlin:
            draft.drop("motion.marlin")
        return
    for ours, theirs, other in (
        ("print_accel", "machine_max_acceleration_extruding", "extruding"),
        ("travel_accel", "machine_max_acceleration_travel", "extruding"),
        ("retract_accel", "machine_max_acceleration_retracting", "retracting"),
    ):
        for key in (theirs, f"machine_max_acceleration_{other}"):
            if key in config and (value := number(_first(config[key]))) > 0:
                draft.put(f"motion.marlin.{ours}", whole_if_it_is(value), _source(config[key]))
                break
        else:
            first = marlin["max_accel"][3 if ours == "retract_accel" else 0]
            draft.put(f"motion.marlin.{ours}", first, "as the axis allows")


def _add_temperatures(draft: Draft, config: Config) -> None:
    for key, ours in TEMPERATURES.items():
        if key in config and (value := _said(config[key])) > 0:
            draft.temperatures.setdefault(ours, value)


def _add_gcode(draft: Draft, config: Config) -> None:
    given = config.get("gcode_flavor")
    if given is not None:
        flavor = _FLAVORS.get(given.text.strip('"').lower())
        if flavor is None:
            known = ", ".join(sorted(set(_FLAVORS.values())))
            shown = one_line(given.text)[:40]
            raise SettingError(f"{given.place}: {shown!r} is no firmware of {known}")
        draft.put("gcode.flavor", flavor, _source(given))
    if (given := config.get("use_firmware_retraction")) and _first(given).text == "1":
        draft.put("gcode.firmware_retraction", True, _source(given))
    _add_thumbnails(draft, config)
    _add_temperatures(draft, config)
    for theirs, ours, taken, names in (
        ("start_gcode", "gcode.start", start_of, START_NAMES),
        ("end_gcode", "gcode.end", end_of, END_NAMES),
    ):
        if theirs not in config:
            continue
        text = unescaped(config[theirs].text)
        lines, unknown = resolved(text, Names(config, draft), names)
        tell_left_out(draft, config[theirs].place, ours, unknown)
        draft.put(ours, taken(lines, draft), _source(config[theirs]))


def _add_thumbnails(draft: Draft, config: Config) -> None:
    given = config.get("thumbnails")
    if given is None:
        return
    form = _first(config["thumbnails_format"]).text if "thumbnails_format" in config else "PNG"
    sizes: list[list[Any]] = []
    for width, height, own in re.findall(r"(\d+)x(\d+)(?:/(\w+))?", given.text):
        kind = (own or form).upper()
        inside = 8 <= int(width) <= 2000 and 8 <= int(height) <= 2000
        if inside and kind in ("PNG", "QOI"):
            sizes.append([int(width), int(height), *(["QOI"] if kind == "QOI" else [])])
        else:
            draft.remark(f"{given.place}: a picture of {width}×{height} in {kind} is left out")
    if sizes:
        draft.put("gcode.thumbnails", sizes[:20], _source(given))
