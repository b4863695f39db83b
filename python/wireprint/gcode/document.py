"""The whole of a G-code file: header, thumbnails, start, moves, end, footer.

Comments have the form that Moonraker, Mainsail and OctoPrint read. Moonraker asks which program
wrote a file and takes apart only those that it knows; the second line names PrusaSlicer, whose
form this is, so that it finds thumbnails and figures.
"""

from __future__ import annotations

import base64
import json
import os
from dataclasses import dataclass
from datetime import UTC, datetime
from typing import TYPE_CHECKING, Any

from wireprint import limits
from wireprint._core import (
    GcodeError,
    SettingError,
    __version__,
    estimate,
    format_moves,
    insert_progress,
)
from wireprint.gcode.flavors import FLAVORS, LAYER, labels
from wireprint.timing import Filament

if TYPE_CHECKING:
    from collections.abc import Iterable, Iterator, Mapping
    from pathlib import Path

    from wireprint._core import Estimate, Toolpath
    from wireprint.settings import Settings

_THUMBNAIL_COLUMNS = 78
_PARK_MM = 10.0
_SETTINGS_BEGIN = "; wireprint_settings = begin"
_SETTINGS_END = "; wireprint_settings = end"


@dataclass(frozen=True)
class Thumbnail:
    """A small picture for the file list of a printer's host."""

    width: int
    height: int
    png: bytes


def dated(model: Path | None) -> datetime:
    """Date that same-input runs share.

    Parameters
    ----------
    model
        File that the print comes from: its date is taken, unless SOURCE_DATE_EPOCH is set.
        Without a file it is the epoch.
    """
    epoch = os.environ.get("SOURCE_DATE_EPOCH")
    if epoch is not None:
        try:
            return datetime.fromtimestamp(int(epoch), UTC)
        except (ValueError, OverflowError, OSError):
            msg = f"SOURCE_DATE_EPOCH is {epoch!r}; it must be a number of seconds"
            raise SettingError(msg) from None
    seconds = int(model.stat().st_mtime) if model is not None else 0
    return datetime.fromtimestamp(seconds, UTC)


def body(
    toolpath: Toolpath,
    settings: Settings,
    date: datetime,
    thumbnails: Iterable[Thumbnail] = (),
    remarks: Iterable[str] = (),
) -> bytes:
    """Everything but the footer: what a printer executes, and the header before it.

    `remarks` are lines for the header.
    """
    gcode = settings.printer.gcode
    material = settings.material
    names: dict[str, Any] = {"nozzle_c": material.nozzle_c, "bed_c": material.bed_c}
    park_z = min(toolpath.top_mm + _PARK_MM, settings.printer.bed.height_mm)
    parts = [
        _header(settings, date, thumbnails, remarks).encode(),
        _sequence(gcode.start, names).encode(),
        _modes(settings).encode(),
        moves(toolpath, settings),
        _sequence(gcode.end, {"park_z_mm": f"{park_z:.3f}"}).encode(),
    ]
    return b"".join(parts)


def moves(toolpath: Toolpath, settings: Settings) -> bytes:
    """Return the lines of the moves alone, in the flavour of the settings."""
    gcode = settings.printer.gcode
    flavor = FLAVORS[gcode.flavor]
    air_on, air_off = flavor.air(settings.printer.cooling)
    return format_moves(
        toolpath,
        relative_extrusion=gcode.relative_extrusion,
        dwell=flavor.dwell,
        air_on=air_on,
        air_off=air_off,
        layer=LAYER,
        retract=flavor.retract if gcode.firmware_retraction else "",
        unretract=flavor.unretract if gcode.firmware_retraction else "",
        labels=labels(),
    )


def timed(text: bytes, settings: Settings) -> tuple[bytes, Estimate]:
    """Add M73 lines to the text; return it with the estimate that they come from."""
    found = timing(text, settings, per_move=True)
    template = FLAVORS[settings.printer.gcode.flavor].progress
    return insert_progress(text, found, template), found


def timing(text: bytes, settings: Settings, *, per_move: bool = False) -> Estimate:
    """Time a text as the printer of the settings would take, without heating and homing."""
    return estimate(
        text,
        limits.of_printer(settings.printer),
        limits.firmware_of(settings.printer),
        allowances_s=(0.0, 0.0, 0.0),
        per_move=per_move,
    )


def footer(settings: Settings, filament_mm: float, print_time_s: float, layers: int) -> bytes:
    """Figures of the print and the settings it was made with, all in comments."""
    material, printer = settings.material, settings.printer
    filament = Filament.of(settings)
    grams, cost = filament.grams(filament_mm), filament.cost(filament_mm)
    entries = {
        "filament used [mm]": f"{filament_mm:.2f}",
        "filament used [cm3]": f"{grams / material.density_g_cm3:.2f}",
        "filament used [g]": f"{grams:.2f}",
        "filament cost": f"{cost:.2f}",
        "total filament used [g]": f"{grams:.2f}",
        "total filament cost": f"{cost:.2f}",
        "total layers count": f"{layers}",
        "estimated printing time (normal mode)": duration(print_time_s),
        "printer_settings_id": printer.name,
        "filament_settings_id": material.name,
        "filament_type": material.name.upper(),
        "filament_diameter": f"{printer.extruder.filament_diameter_mm:g}",
        "filament_density": f"{material.density_g_cm3:g}",
        "nozzle_diameter": f"{printer.head.nozzle_mm:g}",
        "layer_height": f"{settings.slab_max_mm:g}",
        "first_layer_height": f"{settings.first_layer_height_mm:g}",
        "first_layer_temperature": f"{material.nozzle_c}",
        "temperature": f"{material.nozzle_c}",
        "first_layer_bed_temperature": f"{material.bed_c}",
        "bed_temperature": f"{material.bed_c}",
    }
    lines = [f"; {key} = {value}" for key, value in entries.items()]
    lines += [_SETTINGS_BEGIN, *_settings_lines(settings.model_dump()), _SETTINGS_END]
    return ("\n" + "\n".join(lines) + "\n").encode()


def settings_in(text: bytes) -> Settings | None:
    """Return the settings that a file of wireprint was made with; None in any other file.

    Raises
    ------
    GcodeError
        The block of settings is damaged.
    """
    begin, end = text.rfind(_SETTINGS_BEGIN.encode()), text.rfind(_SETTINGS_END.encode())
    if not 0 <= begin < end:
        return None
    from wireprint.settings import Settings

    values: dict[str, Any] = {}
    try:
        for line in text[begin:end].decode().splitlines()[1:]:
            key, _, value = line.removeprefix("; ").partition(" = ")
            *groups, name = key.split(".")
            table = values
            for group in groups:
                table = table.setdefault(group, {})
            table[name] = json.loads(value)
        return Settings.from_mapping(values)
    except (ValueError, AttributeError) as error:
        msg = f"the settings in the file are damaged: {error}"
        raise GcodeError(msg) from None


def duration(seconds: float) -> str:
    """Return a time as PrusaSlicer writes it: ``1d 2h 3m 4s``, from the first unit that counts."""
    left = round(seconds)
    parts: list[str] = []
    for unit, size in (("d", 86400), ("h", 3600), ("m", 60)):
        count, left = divmod(left, size)
        if count or parts:
            parts.append(f"{count}{unit}")
    return " ".join([*parts, f"{left}s"])


def _header(
    settings: Settings,
    date: datetime,
    thumbnails: Iterable[Thumbnail],
    remarks: Iterable[str],
) -> str:
    lines = [
        f"; generated by wireprint {__version__} on {date:%Y-%m-%d at %H:%M:%S} UTC",
        "; comments in the form of PrusaSlicer 2.8 on purpose",
        "",
    ]
    for thumbnail in thumbnails:
        lines += _thumbnail_lines(thumbnail)
    lines += [f"; {settings.printer.name}, {settings.material.name}"]
    lines += [f"; {remark}" for remark in remarks]
    lines += ["", ""]
    return "\n".join(lines)


def _thumbnail_lines(thumbnail: Thumbnail) -> list[str]:
    code = base64.b64encode(thumbnail.png).decode()
    rows = (
        code[start : start + _THUMBNAIL_COLUMNS]
        for start in range(0, len(code), _THUMBNAIL_COLUMNS)
    )
    size = f"{thumbnail.width}x{thumbnail.height}"
    return [
        f"; thumbnail begin {size} {len(code)}",
        *(f"; {row}" for row in rows),
        "; thumbnail end",
        "",
    ]


def _sequence(template: str, names: Mapping[str, Any]) -> str:
    text = template.format_map(names).strip()
    return f"{text}\n" if text else ""


def _modes(settings: Settings) -> str:
    """Return what the moves build on, whatever the start sequence left behind."""
    extrusion = "M83" if settings.printer.gcode.relative_extrusion else "M82"
    return f"G21\nG90\n{extrusion}\nG92 E0\n"


def _settings_lines(values: Mapping[str, Any], prefix: str = "") -> Iterator[str]:
    for name, value in values.items():
        if isinstance(value, dict):
            yield from _settings_lines(value, f"{prefix}{name}.")
        else:
            yield f"; {prefix}{name} = {json.dumps(value)}"
