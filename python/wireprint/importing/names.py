"""What PrusaSlicer's and OrcaSlicer's placeholders stand for in a sequence of ours."""

from __future__ import annotations

import re
from typing import TYPE_CHECKING, Final

from wireprint.importing.expressions import Ours, Unknown, Value
from wireprint.importing.sequences import bounds_mm

if TYPE_CHECKING:
    from wireprint.importing.draft import Draft
    from wireprint.importing.reading import Config

#: Their names of temperatures → ours.
TEMPERATURES: Final = {
    "temperature": "nozzle_c",
    "first_layer_temperature": "nozzle_c",
    "nozzle_temperature": "nozzle_c",
    "nozzle_temperature_initial_layer": "nozzle_c",
    "bed_temperature": "bed_c",
    "first_layer_bed_temperature": "bed_c",
    "hot_plate_temp": "bed_c",
    "hot_plate_temp_initial_layer": "bed_c",
    "bed_temperature_initial_layer": "bed_c",
    "bed_temperature_initial_layer_single": "bed_c",
}
#: Temperatures by which conditions are judged where the source has none, °C: of PLA.
_USUAL_C: Final = {"nozzle_c": 215.0, "bed_c": 60.0}
#: What conditions ask for that differs from print to print: an ordinary print from PLA.
_ASSUMED: Final[dict[str, Value]] = {
    "filament_type": "PLA",
    "filament_notes": "",
    "filament_settings_id": "",
    "filament_vendor": "",
    "print_settings_id": "",
    "print_notes": "",
    "layer_height": 0.2,
    "chamber_temperature": 0.0,
    "z_offset": 0.0,
    "total_layer_count": 100.0,
    "spiral_mode": False,
    "has_wipe_tower": False,
    "print_sequence": "by layer",
    "timelapse_type": 0.0,
    "default_acceleration": 0.0,
    # A smooth plate, which no texture raises.
    "curr_bed_type": "High Temp Plate",
}


#: The rectangle that a print covers → what begins our names of it.
_EDGES: Final = {"first_layer_print_min": "min", "first_layer_print_max": "max"}


def _parts(text: str) -> list[str]:
    """Return a vector's values, one for each extruder."""
    return [part.strip().strip('"') for part in re.split(r"[,;]", text)]


class Names:
    """What placeholders stand for."""

    def __init__(self, config: Config, draft: Draft) -> None:
        self._config = config
        self._draft = draft

    def __call__(self, name: str, index: int | None) -> Value:
        """Return a value; the first extruder's where several could be meant."""
        if name in TEMPERATURES:
            ours = TEMPERATURES[name]
            return Ours(ours, self._draft.temperatures.get(ours, _USUAL_C[ours]))
        if name in ("max_layer_z", "layer_z", "max_print_z"):
            return Ours("park_z_mm", 50.0, follows=True)
        if name in ("initial_tool", "initial_extruder", "current_extruder", "current_object_idx"):
            return 0.0
        if name in ("layer_num", "total_toolchanges", "initial_no_support_extruder"):
            return 0.0
        if name == "num_extruders":
            given = self._config.get("nozzle_diameter")
            return float(len(_parts(given.text))) if given else 1.0
        if name in _EDGES and index in (0, 1):
            return Ours(f"{_EDGES[name]}_{'xy'[index]}_mm")
        edges = {"print_bed_min": 0, "print_bed_max": 1}
        if name in edges and index in (0, 1):
            return bounds_mm(self._draft)[edges[name]][index]
        if name == "is_extruder_used":
            return index in (None, 0)
        given = self._config.get(name)
        if given is None:
            if name in _ASSUMED:
                return _ASSUMED[name]
            raise Unknown(name)
        parts = _parts(given.text)
        text = parts[index] if index is not None and index < len(parts) else parts[0]
        try:
            return float(text)
        except ValueError:
            return text
