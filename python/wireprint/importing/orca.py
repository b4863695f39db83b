"""OrcaSlicer's and Bambu Studio's ``.json`` profiles, under the names that PrusaSlicer uses."""

from __future__ import annotations

import json
import re
from contextlib import suppress
from itertools import islice
from pathlib import Path
from typing import Any, Final

from wireprint._core import SettingError
from wireprint.importing.reading import MOST_IN_VALUE, Config, Given, text_of
from wireprint.text import one_line

#: Their names of what PrusaSlicer has, too.
NAMES: Final = {
    "printable_area": "bed_shape",
    "printable_height": "max_print_height",
    "machine_start_gcode": "start_gcode",
    "machine_end_gcode": "end_gcode",
    "machine_max_speed_x": "machine_max_feedrate_x",
    "machine_max_speed_y": "machine_max_feedrate_y",
    "machine_max_speed_z": "machine_max_feedrate_z",
    "machine_max_speed_e": "machine_max_feedrate_e",
    "retraction_length": "retract_length",
    "retraction_speed": "retract_speed",
    "deretraction_speed": "deretract_speed",
    "extruder_clearance_height_to_rod": "extruder_clearance_height",
    "extruder_clearance_max_radius": "extruder_clearance_radius",
    "nozzle_temperature": "temperature",
    "nozzle_temperature_initial_layer": "first_layer_temperature",
    "hot_plate_temp": "bed_temperature",
    "hot_plate_temp_initial_layer": "first_layer_bed_temperature",
}
#: Presets of a printer's choice that complete it.
_USUAL: Final = ("default_filament_profile", "default_print_profile")
_MOST_ELDERS: Final = 40
#: Folders above a user's own presets in which the slicer may keep those of makers.
_UP: Final = 4
_SYSTEM: Final = "system"
#: Files of a folder that are looked through for an elder.
_MOST_FILES: Final = 20000


def configuration(path: Path, text: str) -> Config:
    """Return a profile with what it inherits from files of its folder, and those around it.

    Raises
    ------
    SettingError
        A file is no JSON object, or inherits from nothing or from itself.
    """
    found = _resolved(path, text, ())
    for usual in _USUAL:
        given = found.get(usual)
        name = re.split(r"[;,]", given.text)[0].strip() if given else ""
        if name and (other := _find(path, name)) is not None:
            # What only completes a printer may be damaged.
            with suppress(SettingError):
                found = _resolved(other, text_of(other), ()) | found
    return renamed(found)


def renamed(config: Config) -> Config:
    """Return values under PrusaSlicer's names."""
    return {NAMES.get(key, key): given for key, given in config.items()}


def _resolved(path: Path, text: str, heirs: tuple[Path, ...]) -> Config:
    table = json_object(text, str(path))
    own = config_of(table, text, path.name)
    elder = table.get("inherits")
    if not isinstance(elder, str) or not elder:
        return own
    place = own["inherits"].place
    chain = (*heirs, path)
    other = _find(path, elder)
    if other is None:
        msg = (
            f"{place}: {one_line(elder)!r} is not in the folder {path.parent}; "
            "put the file that is called so there"
        )
        raise SettingError(msg)
    if any(other.resolve() == one.resolve() for one in chain) or len(chain) > _MOST_ELDERS:
        names = " → ".join(one.name for one in (*chain, other))
        raise SettingError(f"{place}: profiles inherit in a circle: {names}")
    return _resolved(other, text_of(other), chain) | own


def _find(path: Path, elder: str) -> Path | None:
    """Return the file of a profile's name: beside the one that asks, or in the folders around.

    OrcaSlicer keeps a user's presets in ``user/default/machine``, those of makers in
    ``system/Maker/machine``.
    """
    name = f"{elder}.json"
    if "/" in elder or "\\" in elder or "\0" in elder or len(name) > 250:
        return None
    beside = path.parent / name
    if beside.is_file():
        return beside
    above = path.absolute().parents
    folders = [above[min(1, len(above) - 1)], *(one / _SYSTEM for one in above[1:_UP])]
    for folder in folders:
        files = islice(folder.rglob("*.json"), _MOST_FILES)
        # In no order of the file system's.
        if same := sorted(other for other in files if other.name == name):
            return same[0]
    return None


def json_object(text: str, name: str) -> dict[str, Any]:
    """Return the object that a text is.

    Raises
    ------
    SettingError
        It is something else; the error names file and line.
    """
    try:
        table = json.loads(text)
    except json.JSONDecodeError as error:
        raise SettingError(f"{name}:{error.lineno}: not JSON: {error.msg}") from None
    except (RecursionError, ValueError):
        raise SettingError(f"{name}: not settings: nested too deep, or numbers too long") from None
    if not isinstance(table, dict):
        raise SettingError(f"{name}: not settings: no object, but a {type(table).__name__}")
    return table


def config_of(table: dict[str, Any], text: str, name: str) -> Config:
    """Return an object's values as text, lists joined as PrusaSlicer joins them."""
    lines = _lines_of(text)
    found: Config = {}
    for key, value in table.items():
        shown = _as_text(value)
        if shown is None or len(shown) > MOST_IN_VALUE:
            continue
        line = lines.get(key)
        found[key] = Given(shown, f"{name}{'' if line is None else f':{line}'}, {one_line(key)}")
    return found


def _as_text(value: Any) -> str | None:
    if isinstance(value, bool):
        return str(int(value))
    if isinstance(value, int | float):
        return f"{value:g}"
    if isinstance(value, str):
        return value
    if isinstance(value, list) and all(isinstance(one, str) for one in value):
        # A vector of texts has one for each extruder, of which the first one counts.
        return value[0] if len(value) == 1 else ",".join(value)
    return None


def _lines_of(text: str) -> dict[str, int]:
    """Return the line of each key at an object's top."""
    found: dict[str, int] = {}
    for number, line in enumerate(text.splitlines(), start=1):
        key, colon, _ = line.strip().partition(":")
        if colon and len(key) > 2 and key[0] == key.rstrip()[-1] == '"':
            found.setdefault(key.rstrip()[1:-1], number)
    return found
