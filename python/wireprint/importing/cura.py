"""Cura's machines: ``.def.json`` with what they inherit, ``.inst.cfg``, and what users changed."""

from __future__ import annotations

import configparser
import re
from typing import TYPE_CHECKING, Any, Final

from wireprint._core import SettingError
from wireprint.importing.draft import Draft, number, whole_if_it_is
from wireprint.importing.expressions import Missing, Ours, Unknown, Value, evaluated
from wireprint.importing.orca import json_object
from wireprint.importing.placeholders import resolved
from wireprint.importing.reading import Config, Given, text_of
from wireprint.importing.sequences import end_of, start_of
from wireprint.text import one_line

if TYPE_CHECKING:
    from pathlib import Path

#: What all machines inherit; its figures are for none in particular.
_BASES: Final = ("fdmprinter", "fdmextruder")
_MOST_ELDERS: Final = 40
_FLAVORS: Final = {
    "RepRap (Marlin/Sprinter)": "marlin",
    "RepRap (Volumetric)": "marlin",
    "RepRap (RepRap)": "reprapfirmware",
    "Repetier": "repetier",
    "Cheetah": "marlin",
    "UltiGCode": "marlin",
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


#: A choice in Python's words, which nobody but Cura can make.
_FORMULA: Final = re.compile(r"\bif\b.*\belse\b", re.DOTALL)


def definition(path: Path, text: str, heirs: tuple[Path, ...] = ()) -> Config:
    """Return a machine's settings with what it inherits from files of its folder.

    Raises
    ------
    SettingError
        A file is no JSON object, or inherits from nothing or from itself.
    """
    table = json_object(text, str(path))
    found: Config = {}
    elder = table.get("inherits")
    chain = (*heirs, path)
    if isinstance(elder, str) and elder not in _BASES:
        place = f"{path.name}, inherits"
        other = path.parent / f"{elder}.def.json"
        if "/" in elder or "\\" in elder or "\0" in elder or not other.is_file():
            msg = f"{place}: {one_line(elder)}.def.json is not in {path.parent}; put it there"
            raise SettingError(msg)
        if any(other.resolve() == one.resolve() for one in chain) or len(chain) > _MOST_ELDERS:
            names = " → ".join(one.name for one in (*chain, other))
            raise SettingError(f"{place}: definitions inherit in a circle: {names}")
        found = definition(other, text_of(other), chain)
    found |= _extruder(path, table)
    overrides = table.get("overrides")
    if isinstance(table.get("name"), str):
        found["machine_name"] = Given(table["name"], f"{path.name}, name")
    return found | _overridden(overrides, text, path.name, found)


def _overridden(overrides: Any, text: str, name: str, known: Config) -> Config:
    """Return what a file states, formulas computed from that and from what is known."""
    lines = text.splitlines()
    found: Config = {}
    for key, entry in overrides.items() if isinstance(overrides, dict) else ():
        if isinstance(entry, dict):
            line = next((n for n, one in enumerate(lines, 1) if f'"{key}"' in one), 1)
            place = f"{name}:{line}, {one_line(key)}"
            # A formula that is none of ours leaves what stands beside it.
            usual = entry.get("default_value")
            for one in (entry.get("value", usual), usual):
                if (given := _given(one, place, known | found)) is not None:
                    found[key] = given
                    break
    return found


def _extruder(path: Path, table: dict[str, Any]) -> Config:
    """Return what a machine's first extruder says; its file lies beside, or in a folder of them."""
    metadata = table.get("metadata")
    trains = metadata.get("machine_extruder_trains") if isinstance(metadata, dict) else None
    name = trains.get("0") if isinstance(trains, dict) else None
    if not isinstance(name, str) or not name.isidentifier():
        return {}
    for folder in (path.parent, path.parent.parent / "extruders"):
        file = folder / f"{name}.def.json"
        if file.is_file():
            text = text_of(file)
            own = json_object(text, str(file))
            return _overridden(own.get("overrides"), text, file.name, {})
    return {}


def _given(value: Any, place: str, known: Config) -> Given | None:
    if isinstance(value, bool):
        return Given(str(int(value)), place)
    if isinstance(value, int | float):
        return Given(f"{value:.10g}", place)
    if isinstance(value, list):
        return Given(str(value), place)
    if not isinstance(value, str) or _FORMULA.search(value):
        return None
    if "\n" in value or (" " in value and ";" in value) or not value:
        return Given(value, place)
    try:
        found = evaluated(value, lambda name, _: _known(name, known))
    except Unknown:
        found = Missing(value)
    if isinstance(found, Missing | Ours):
        return Given(value, place) if not set(value) & set("()*/=") else None
    return Given(f"{found:.10g}" if isinstance(found, int | float) else str(found), place)


def _known(name: str, known: Config) -> Value:
    if name not in known:
        raise Unknown(name)
    try:
        return float(known[name].text)
    except ValueError:
        return known[name].text


def instance(path: Path, text: str) -> Config:
    """Return what an ``.inst.cfg`` changes.

    Raises
    ------
    SettingError
        It is none; the error names the line.
    """
    parser = configparser.ConfigParser(interpolation=None, strict=False)
    try:
        parser.read_string(text)
    except configparser.Error as error:
        line = getattr(error, "lineno", None)
        place = f"{path.name}:{line}" if line else path.name
        what = one_line(str(error).splitlines()[0])
        raise SettingError(f"{place}: no settings of Cura: {what}") from None
    found: Config = {}
    lines = text.splitlines()
    for key, value in parser.items("values") if parser.has_section("values") else ():
        line = next((n for n, one in enumerate(lines, 1) if one.startswith(key)), 1)
        found[key] = Given(value.removeprefix("="), f"{path.name}:{line}, {one_line(key)}")
    if parser.has_option("general", "definition"):
        name = parser.get("general", "definition")
        found.setdefault("definition", Given(name, f"{path.name}, definition"))
        beside = path.parent / f"{name}.def.json"
        if "/" not in name and "\0" not in name and beside.is_file():
            found = definition(beside, text_of(beside)) | found
    return found


def draft_of(config: Config, name: str) -> Draft:
    """Return what Cura says of a printer.

    Raises
    ------
    SettingError
        Nothing in it describes a printer, or a value is damaged.
    """
    if not any(key.startswith("machine_") for key in config):
        msg = f"{name}: nothing in it describes a machine (machine_width, machine_height …)"
        raise SettingError(msg)
    if "machine_width" in config:
        usual = {key: Given(value, "Cura's own default") for key, value in _DEFAULTS.items()}
        config = usual | config
    draft = Draft()
    if (given := config.get("machine_name")) is not None and given.text.strip():
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
    for theirs, ours, taken in (
        ("machine_start_gcode", "gcode.start", start_of),
        ("machine_end_gcode", "gcode.end", end_of),
    ):
        if theirs in config:
            lines, unknown = resolved(
                config[theirs].text.replace("\\n", "\n"), _Names(config, draft)
            )
            for line in unknown:
                draft.remark(f"{config[theirs].place}: left out of {ours}, not understood: {line}")
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
        return _known(name, self._config)
