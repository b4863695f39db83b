"""Klipper's configuration as a profile."""

from __future__ import annotations

import re
from typing import TYPE_CHECKING, Final

from wireprint._core import SettingError
from wireprint.importing.draft import Draft, number, whole_if_it_is
from wireprint.importing.sequences import end_of, start_of
from wireprint.text import one_line

if TYPE_CHECKING:
    from wireprint.importing.klipper_config import KlipperConfig
    from wireprint.importing.reading import Config

_KINEMATICS: Final = {
    "cartesian": "cartesian",
    "corexy": "corexy",
    "corexz": "corexy",
    "hybrid_corexy": "corexy",
    "hybrid_corexz": "corexy",
    "limited_cartesian": "cartesian",
    "limited_corexy": "corexy",
    "delta": "delta",
}
#: Section, its option → ours; Klipper's own defaults are ours, too.
_FIGURES: Final = (
    ("printer", "max_velocity", "motion.max_velocity"),
    ("printer", "max_accel", "motion.max_accel"),
    ("printer", "square_corner_velocity", "motion.square_corner_velocity"),
    ("printer", "minimum_cruise_ratio", "motion.minimum_cruise_ratio"),
    ("printer", "max_z_velocity", "motion.max_z_velocity"),
    ("printer", "max_z_accel", "motion.max_z_accel"),
    ("extruder", "nozzle_diameter", "head.nozzle_mm"),
    ("extruder", "filament_diameter", "extruder.filament_diameter_mm"),
    ("extruder", "max_extrude_only_velocity", "motion.max_extrude_only_velocity"),
    ("extruder", "max_extrude_only_accel", "motion.max_extrude_only_accel"),
    ("extruder", "pressure_advance", "extruder.pressure_lag_s"),
    (
        "extruder",
        "instantaneous_corner_velocity",
        "motion.instantaneous_corner_velocity",
    ),
    ("firmware_retraction", "retract_length", "extruder.retract_mm"),
    ("firmware_retraction", "retract_speed", "extruder.retract_speed_mm_s"),
    ("firmware_retraction", "unretract_speed", "extruder.unretract_speed_mm_s"),
    ("gcode_arcs", "resolution", "motion.arc_resolution"),
)
#: Names that people give to what starts and ends a print.
_STARTS: Final = ("print_start", "start_print", "start", "begin_print")
_ENDS: Final = ("print_end", "end_print", "end", "finish_print")
_PARAMETER: Final = re.compile(r"params\.(\w+)")
_LOGIC: Final = re.compile(r"\{[%{]?|%\}")


def draft_of(config: KlipperConfig, name: str) -> Draft:
    """Return what a configuration says of its printer.

    Parameters
    ----------
    config
        It, with all that it includes.
    name
        The file, for errors.

    Raises
    ------
    SettingError
        It describes no printer that prints wire, or a value is damaged.
    """
    printer = config.section("printer")
    if "kinematics" not in printer:
        msg = f"{name}: no [printer] with kinematics; is a file that it is included by meant?"
        raise SettingError(msg)
    draft = Draft()
    for sentence in config.remarks:
        draft.remark(sentence)
    draft.put("name", one_line(config.files[0].stem)[:100], "the file's name")
    given = printer["kinematics"]
    kinematics = _KINEMATICS.get(given.text)
    if kinematics is None:
        shown = one_line(given.text)[:40]
        known = ", ".join(sorted(set(_KINEMATICS.values())))
        raise SettingError(f"{given.place}: {shown!r} is none of {known}")
    draft.put("kinematics", kinematics, given.place)
    for section, option, ours in _FIGURES:
        if (found := config.section(section).get(option)) is not None:
            value = number(found)
            if value > 0 or ours.endswith(("_lag_s", "ratio", "corner_velocity", "retract_mm")):
                draft.put(ours, whole_if_it_is(value), found.place)
    if kinematics == "delta":
        _add_delta(draft, config)
    else:
        _add_axes(draft, config)
    if kinematics == "cartesian":
        draft.put("motion.bed_moves_y", True, "as machines of the i3 kind are built")
    draft.put("gcode.flavor", "klipper", "the file's own firmware")
    _add_extrusion_limits(draft)
    _add_macros(draft, config)
    return draft


def _add_axes(draft: Draft, config: KlipperConfig) -> None:
    sizes = {}
    for axis in "xyz":
        stepper = config.section(f"stepper_{axis}")
        if "position_max" not in stepper:
            msg = f"{config.files[0]}: [stepper_{axis}] has no position_max"
            raise SettingError(msg)
        sizes[axis] = (number(stepper["position_max"]), stepper["position_max"].place)
    for axis, ours in (("x", "bed.width_mm"), ("y", "bed.depth_mm"), ("z", "bed.height_mm")):
        most, place = sizes[axis]
        stepper = config.section(f"stepper_{axis}")
        least = number(stepper["position_min"]) if "position_min" in stepper else 0.0
        if axis != "z" and least > 0:
            draft.remark(f"{stepper['position_min'].place}: the bed is taken to begin at 0")
        draft.put(ours, whole_if_it_is(most), place)
    draft.put("bed.shape", "rectangular", draft.comments["kinematics",])
    draft.put("bed.origin", "corner", "Klipper's coordinates begin at the bed's corner")
    _add_homing(draft, config)


def _add_homing(draft: Draft, config: KlipperConfig) -> None:
    for axis in "xy":
        stepper = config.section(f"stepper_{axis}")
        if "position_endstop" in stepper:
            given = stepper["position_endstop"]
            draft.put(f"homing.{axis}_mm", whole_if_it_is(number(given)), given.place)
    stepper = config.section("stepper_z")
    endstop = stepper.get("position_endstop")
    height = draft.get("bed.height_mm")
    if endstop is not None and height and number(endstop) > height / 2:
        draft.put("homing.z_end", "top", endstop.place)
    else:
        draft.put("homing.z_end", "bed", (endstop or stepper["position_max"]).place)
    safe = config.section("safe_z_home")
    if "z_hop" in safe:
        draft.put("homing.lift_mm", whole_if_it_is(number(safe["z_hop"])), safe["z_hop"].place)
    if "home_xy_position" in safe:
        given = safe["home_xy_position"]
        try:
            x, y = (float(part) for part in given.text.split(","))
        except ValueError:
            raise SettingError(f"{given.place}: {given.text!r} is no x,y") from None
        draft.put("homing.z_place_mm", [whole_if_it_is(x), whole_if_it_is(y)], given.place)
    if "homing_override" in config.sections:
        draft.remark(
            f"{config.files[0].name}: [homing_override] is not looked into; see that [homing] of "
            "the profile says where the head is after G28"
        )


def _add_delta(draft: Draft, config: KlipperConfig) -> None:
    printer, tower = config.section("printer"), config.section("stepper_a")
    for section, option, ours in (
        (printer, "delta_radius", "motion.delta_radius"),
        (printer, "print_radius", "motion.print_radius"),
        (tower, "arm_length", "motion.arm_length"),
        (tower, "position_endstop", "motion.endstop_height"),
    ):
        if option in section:
            given = section[option]
            draft.put(ours, whole_if_it_is(number(given)), given.place)
        elif option != "print_radius":
            place = "printer" if section is printer else "stepper_a"
            raise SettingError(f"{config.files[0]}: [{place}] has no {option}, as a delta needs")
    radius = draft.get("motion.print_radius") or draft.get("motion.delta_radius")
    key = "print_radius" if draft.get("motion.print_radius") else "delta_radius"
    draft.put("bed.shape", "round", draft.comments["kinematics",])
    draft.put("bed.diameter_mm", whole_if_it_is(2 * radius), printer[key].place)
    height = draft.get("motion.endstop_height")
    # At its end stops the head cannot move sideways any more.
    lost = draft.get("motion.arm_length") * 0.15
    draft.put(
        "bed.height_mm",
        whole_if_it_is(round(height - lost)),
        f"{tower['position_endstop'].place}, less the arms' reserve",
    )
    draft.put("bed.origin", "centre", "Klipper's coordinates of a delta")
    draft.fill("motion.max_z_velocity", draft.get("motion.max_velocity"), "Klipper's default")
    draft.fill("motion.max_z_accel", draft.get("motion.max_accel"), "Klipper's default")
    if (step := _step_mm(tower)) is not None:
        draft.put("motion.step_distance", step, f"{tower['rotation_distance'].place} …")
    else:
        draft.put("motion.step_distance", 0.01, "assumed: 16 microsteps of a belt's 32 mm")


def _step_mm(stepper: Config) -> float | None:
    """Return the travel of a microstep, mm."""
    if not {"rotation_distance", "microsteps"} <= set(stepper):
        return None
    full = stepper.get("full_steps_per_rotation")
    steps = (number(full) if full else 200.0) * number(stepper["microsteps"])
    distance = number(stepper["rotation_distance"])
    return round(distance / steps, 6) if steps > 0 and distance > 0 else None


def _add_extrusion_limits(draft: Draft) -> None:
    """Fill in Klipper's own defaults, which follow from others: kinematics/extruder.py."""
    motion = draft.get("motion") or {}
    draft.fill("motion.max_z_velocity", motion.get("max_velocity"), "Klipper's default")
    draft.fill("motion.max_z_accel", motion.get("max_accel"), "Klipper's default")
    nozzle, filament = draft.get("head.nozzle_mm"), draft.get("extruder.filament_diameter_mm")
    if not (nozzle and filament and motion.get("max_velocity") and motion.get("max_accel")):
        return
    # Most of the cross section: four times the nozzle's diameter squared.
    ratio = 4 * nozzle**2 / (3.14159265 / 4 * filament**2)
    for key, of in (
        ("max_extrude_only_velocity", "max_velocity"),
        ("max_extrude_only_accel", "max_accel"),
    ):
        draft.fill(f"motion.{key}", round(motion[of] * ratio, 1), "Klipper's default")


def _add_macros(draft: Draft, config: KlipperConfig) -> None:
    macros = {
        name.split()[1].lower(): (name.split()[1], section)
        for name, section in config.sections.items()
        if name.startswith("gcode_macro ") and len(name.split()) == 2
    }
    start = next((macros[name] for name in _STARTS if name in macros), None)
    lines: list[str] = []
    if start is not None and "gcode" in start[1]:
        body = start[1]["gcode"]
        lines = [_called(start[0], body.text)]
        draft.put("gcode.start", start_of(lines, draft, _homes(body.text, macros)), body.place)
    else:
        lines = ["G28"]
        draft.put("gcode.start", start_of(lines, draft), "the file has no macro that starts")
    end = next((macros[name] for name in _ENDS if name in macros), None)
    if end is None or "gcode" not in end[1]:
        draft.put("gcode.end", end_of(["M107", "M84"], draft), "the file has no macro that ends")
        return
    called, section = end
    body = section["gcode"]
    # Only a plain macro can be judged, and only what is judged is written.
    if _LOGIC.search(body.text) or any(_word(line) in macros for line in body.text.splitlines()):
        draft.remark(
            f"{body.place}: the macro {one_line(called)} decides by itself what it does, so it "
            "cannot be judged; gcode.end parks, cools and stops without it"
        )
        draft.put("gcode.end", end_of(["M107", "M84"], draft), "in place of a macro with logic")
        return
    draft.put("gcode.end", end_of(body.text.splitlines(), draft), f"{body.place}, written out")


def _word(line: str) -> str:
    return line.strip().split(" ")[0].lower()


def _homes(body: str, macros: dict[str, tuple[str, Config]], depth: int = 0) -> bool:
    """Whether a macro homes, itself or by another one."""
    if re.search(r"\bG28\b", body):
        return True
    called = {_word(line) for line in body.splitlines()} & set(macros)
    return depth < 5 and any(
        _homes(macros[name][1]["gcode"].text, macros, depth + 1)
        for name in called
        if "gcode" in macros[name][1]
    )


def _called(name: str, body: str) -> str:
    """Return a call of a start macro, its temperatures given by the names that it asks for."""
    words = [name]
    for parameter in dict.fromkeys(_PARAMETER.findall(body)):
        lower = parameter.lower()
        if "bed" in lower:
            words.append(f"{parameter.upper()}={{bed_c}}")
        elif re.search(r"extruder|hotend|nozzle|tool|print_temp|^temp", lower):
            words.append(f"{parameter.upper()}={{nozzle_c}}")
    return " ".join(words)
