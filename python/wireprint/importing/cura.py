"""Cura's machines, and what users changed, as a profile."""

from __future__ import annotations

import re
from typing import Final

from wireprint._core import SettingError
from wireprint.gcode.sequence import END_NAMES, START_NAMES
from wireprint.importing.cura_files import BASES, known_value
from wireprint.importing.draft import Draft, number, whole_if_it_is
from wireprint.importing.expressions import Ours, Value
from wireprint.importing.placeholders import resolved
from wireprint.importing.reading import Config, Given
from wireprint.importing.sequences import end_of, start_of, tell_left_out
from wireprint.text import one_line

_FLAVORS: Final = {
    "RepRap (Marlin/Sprinter)": "marlin",
    "RepRap (Volumetric)": "marlin",
    "RepRap (RepRap)": "reprapfirmware",
    "Repetier": "repetier",
    "Cheetah": "marlin",
    # What no list of Cura's has, but its makers' files do; Cura writes Marlin's then.
    "Marlin": "marlin",
    "RepRap": "marlin",
    "UltiGCode": "marlin",
    "Griffin": "griffin",
}
#: What Cura takes where a machine says nothing: fdmprinter.def.json. A head's shape is not among
#: it, for there it is nobody's.
_DEFAULTS: Final = {
    "machine_gcode_flavor": "RepRap (Marlin/Sprinter)",
    "machine_nozzle_size": "0.4",
    "machine_max_feedrate_x": "500",
    "machine_max_feedrate_z": "5",
    "machine_max_feedrate_e": "25",
    "machine_acceleration": "4000",
    "machine_max_acceleration_z": "100",
    "machine_max_acceleration_e": "10000",
    "machine_max_jerk_xy": "20",
    "retraction_amount": "6.5",
    "retraction_speed": "25",
    "material_diameter": "2.85",
    "speed_travel": "120",
    "speed_print": "60",
    "layer_height": "0.1",
    "layer_height_0": "0.3",
}
#: What starts and ends a file where the printer does the rest by itself.
_GRIFFIN: Final = {
    "gcode.start": "\nT0\nM109 S{nozzle_c}\nG280 S1\n",
    "gcode.end": "\nG1 Z{park_z_mm} F1200\nM107\nM104 S0\nM140 S0\n",
}
_FIGURES: Final = {
    "machine_nozzle_size": "head.nozzle_mm",
    "machine_nozzle_expansion_angle": "head.slant_deg",
    "machine_nozzle_head_distance": "head.cone_height_mm",
    "gantry_height": "head.carriage_height_mm",
    "machine_height": "bed.height_mm",
    "machine_max_feedrate_x": "motion.max_velocity",
    "machine_max_feedrate_z": "motion.max_z_velocity",
    "machine_max_feedrate_e": "motion.max_extrude_only_velocity",
    "machine_acceleration": "motion.max_accel",
    "machine_max_acceleration_z": "motion.max_z_accel",
    "machine_max_acceleration_e": "motion.max_extrude_only_accel",
    "machine_max_jerk_xy": "motion.square_corner_velocity",
    "material_diameter": "extruder.filament_diameter_mm",
    "retraction_amount": "extruder.retract_mm",
    "retraction_speed": "extruder.retract_speed_mm_s",
}
_TEMPERATURES: Final = {
    "material_print_temperature_layer_0": "nozzle_c",
    "material_print_temperature": "nozzle_c",
    "material_initial_print_temperature": "nozzle_c",
    "default_material_print_temperature": "nozzle_c",
    "material_standby_temperature": "nozzle_c",
    "material_bed_temperature_layer_0": "bed_c",
    "material_bed_temperature": "bed_c",
    "default_material_bed_temperature": "bed_c",
}
_USUAL_C: Final = {"nozzle_c": 210.0, "bed_c": 60.0}


def draft_of(config: Config, name: str) -> Draft:
    """Return what Cura says of a printer.

    Raises
    ------
    SettingError
        Nothing in it describes a printer, or a value is damaged.
    """
    if not any(key == "definition" or key.startswith("machine_") for key in config):
        msg = f"{name}: nothing in it describes a machine (machine_width, machine_height …)"
        raise SettingError(msg)
    if "machine_width" in config:
        usual = {key: Given(value, "Cura's own default") for key, value in _DEFAULTS.items()}
        config = usual | config
    draft = Draft()
    definition = config.get("definition")
    if definition is not None and definition.text not in BASES and "machine_width" not in config:
        called = one_line(definition.text)[:100]
        draft.hint = f"Cura's {called}.def.json has what it does not say; import both, it first"
    for key in ("machine_name", "definition"):
        draft.called += [config[key].text] if key in config else []
    given = config.get("machine_name", definition)
    if given is not None and given.text.strip():
        draft.put("name", one_line(given.text)[:100], given.place)
        draft.put("known_as", [one_line(given.text)[:100]], "as Cura writes it")
    _add_bed(draft, config)
    for theirs, ours in _FIGURES.items():
        # Faster is no machine: fdmprinter says so where a maker said nothing.
        if theirs in config and 0 < (value := number(config[theirs])) < 1e6:
            draft.put(ours, whole_if_it_is(value), config[theirs].place)
    if (given := config.get("machine_nozzle_tip_outer_diameter")) is not None:
        draft.put("head.tip_radius_mm", number(given) / 2, given.place)
    _add_reach(draft, config)
    round_bed = draft.get("bed.shape") == "round"
    kinematics = "delta" if round_bed and draft.get("bed.origin") == "centre" else "cartesian"
    draft.put("kinematics", kinematics, "assumed from the bed: Cura does not say it")
    if kinematics == "cartesian":
        draft.put("motion.bed_moves_y", True, "as machines of the i3 kind are built")
    if (given := config.get("machine_gcode_flavor")) is not None:
        flavor = _FLAVORS.get(given.text)
        if flavor is None:
            known = ", ".join(_FLAVORS)
            shown = one_line(given.text)[:40]
            raise SettingError(f"{given.place}: {shown!r} is no firmware of {known}")
        draft.put("gcode.flavor", flavor, given.place)
        if given.text == "UltiGCode":
            draft.remark(
                f"{given.place}: UltiGCode leaves heating to the printer; this file does it"
            )
    for key, ours in _TEMPERATURES.items():
        try:
            if key in config:
                draft.temperatures.setdefault(ours, number(config[key]))
        except SettingError:
            continue
    for theirs, ours, taken, names in (
        ("machine_start_gcode", "gcode.start", start_of, START_NAMES),
        ("machine_end_gcode", "gcode.end", end_of, END_NAMES),
    ):
        if theirs in config:
            text = config[theirs].text.replace("\\n", "\n")
            if draft.get("gcode.flavor") == "griffin" and not text.strip():
                draft.put(ours, _GRIFFIN[ours], "as CuraEngine writes it")
                continue
            lines, unknown = resolved(text, _Names(config, draft), names)
            tell_left_out(draft, config[theirs].place, ours, unknown)
            draft.put(ours, taken(lines, draft), config[theirs].place)
    return draft


def _add_bed(draft: Draft, config: Config) -> None:
    if not {"machine_width", "machine_depth"} <= set(config):
        return
    width, depth = config["machine_width"], config["machine_depth"]
    shape = config.get("machine_shape")
    if shape is not None and shape.text == "elliptic":
        draft.put("bed.shape", "round", shape.place)
        across = min(number(width), number(depth))
        draft.put("bed.diameter_mm", whole_if_it_is(across), width.place)
    else:
        draft.put("bed.shape", "rectangular", width.place)
        draft.put("bed.width_mm", whole_if_it_is(number(width)), width.place)
        draft.put("bed.depth_mm", whole_if_it_is(number(depth)), depth.place)
    centre = config.get("machine_center_is_zero")
    centred = centre is not None and centre.text in ("1", "True", "true")
    draft.put("bed.origin", "centre" if centred else "corner", (centre or width).place)


def _add_reach(draft: Draft, config: Config) -> None:
    """Keep how far the carriage reaches: to the farthest corner of the head's outline."""
    given = config.get("machine_head_with_fans_polygon")
    if given is None:
        return
    numbers = [float(word) for word in re.findall(r"-?\d+\.?\d*", given.text)]
    corners = list(zip(numbers[::2], numbers[1::2], strict=False))
    if corners:
        reach = max((x * x + y * y) ** 0.5 for x, y in corners)
        draft.put("head.carriage_radius_mm", round(reach, 1), f"{given.place}, its far corner")


class _Names:
    """What placeholders stand for."""

    def __init__(self, config: Config, draft: Draft) -> None:
        self._config = config
        self._draft = draft

    def __call__(self, name: str, index: int | None) -> Value:
        """Return a value."""
        if name in _TEMPERATURES:
            ours = _TEMPERATURES[name]
            return Ours(ours, self._draft.temperatures.get(ours, _USUAL_C[ours]))
        return known_value(name, self._config)
