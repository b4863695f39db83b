"""What can be set, as fields of a form: made from the schema of the settings."""

from __future__ import annotations

import re
from typing import TYPE_CHECKING, Any, Final, TypedDict

from wireprint.settings import Settings

if TYPE_CHECKING:
    from collections.abc import Iterator, Mapping

#: Sections in the order in which they are shown; what changes the picture comes first.
SECTIONS: Final = {
    "wire": "Wire",
    "regions": "Layers where marked",
    "printer.head": "Head",
    "printer.cooling": "Cooling",
    "printer.speeds": "Speeds",
    "printer.extruder": "Extruder",
    "material": "Material",
    "printer.bed": "Bed",
    "printer.motion": "Motion",
    "printer.homing": "Homing",
    "printer.gcode": "G-code",
}
#: Ends of names that are units, and how these are written; longer ones first.
_UNITS: Final = {
    "_mm3_s": "mm³/s",
    "_mm_s2": "mm/s²",
    "_mm_s": "mm/s",
    "_mm2": "mm²",
    "_mm": "mm",
    "_g_cm3": "g/cm³",
    "_per_kg": "per kg",
    "_j_kgk": "J/(kg·K)",
    "_w_mk": "W/(m·K)",
    "_deg": "°",
    "_c": "°C",
    "_s": "s",
}
#: What follows from other settings where a field is left to itself.
_AUTOMATIC: Final = {
    "wire.slab_min_mm": "slab_min_mm",
    "wire.slab_max_mm": "slab_max_mm",
    "wire.first_layer_height_mm": "first_layer_height_mm",
    "wire.pause_s": "pause_s",
}


class Field(TypedDict):
    """A line of the form."""

    #: Dotted, from the top of the settings.
    key: str
    section: str
    name: str
    unit: str
    #: ``number``, ``integer``, ``choice``, ``switch`` or ``text``.
    kind: str
    low: float | None
    high: float | None
    #: Of a choice; of a number, words that stand for special amounts.
    choices: list[str]
    #: Whether it may be left to follow from others.
    automatic: bool
    help: str


def fields() -> list[Field]:
    """Return every setting that one line of a form can hold, in order."""
    schema = Settings.model_json_schema()
    found = list(_fields(schema, schema["$defs"], ""))
    order = list(SECTIONS)
    shown = [field for field in found if field["section"] in order]
    return sorted(shown, key=lambda field: order.index(field["section"]))


def values(settings: Settings) -> dict[str, Any]:
    """Return settings by dotted key, in JSON's types."""
    return dict(_flat(settings.model_dump(mode="json"), ""))


def automatic(settings: Settings) -> dict[str, float]:
    """Return what stands for the fields that are left to follow from others."""
    numbers = {key: getattr(settings, name) for key, name in _AUTOMATIC.items()}
    numbers["material.hold_c"] = settings.material.holding_c
    return {key: round(number, 4) for key, number in numbers.items()}


def differing(settings: Settings, others: Settings) -> dict[str, Any]:
    """Return the keys at which settings differ, with the others' values."""
    mine, theirs = values(settings), values(others)
    return {key: value for key, value in theirs.items() if mine.get(key) != value}


def _flat(table: Mapping[str, Any], prefix: str) -> Iterator[tuple[str, Any]]:
    for name, value in table.items():
        if isinstance(value, dict):
            yield from _flat(value, f"{prefix}{name}.")
        else:
            yield prefix + name, value


def _fields(node: Mapping[str, Any], known: Mapping[str, Any], prefix: str) -> Iterator[Field]:
    for name, given in node["properties"].items():
        about, automatic = _resolved(given, known)
        key = prefix + name
        if "properties" in about:
            yield from _fields(about, known, f"{key}.")
        elif (kind := _kind(about)) is not None:
            yield _field(key, about, given, kind, automatic)


def _resolved(given: Mapping[str, Any], known: Mapping[str, Any]) -> tuple[dict[str, Any], bool]:
    """Return a property without references, and whether it may be None."""
    about = dict(given)
    while "$ref" in about:
        about |= known[about.pop("$ref").rpartition("/")[2]]
    if "anyOf" not in about:
        return about, False
    ways = about.pop("anyOf")
    some = [way for way in ways if way.get("type") != "null"]
    # A number may have words for special amounts beside it.
    words = [way["const"] for way in some if "const" in way]
    inner, _ = _resolved(next(way for way in some if "const" not in way), known)
    return inner | about | {"words": words}, len(some) < len(ways)


def _kind(about: Mapping[str, Any]) -> str | None:
    """Return what holds a value; None for tables and lists, which need more than a line."""
    if "enum" in about:
        return "choice"
    names = {"number": "number", "integer": "integer", "boolean": "switch", "string": "text"}
    return names.get(about.get("type", ""))


def _field(
    key: str, about: Mapping[str, Any], given: Mapping[str, Any], kind: str, automatic: bool
) -> Field:
    name, unit = _named(key.rpartition(".")[2])
    return {
        "key": key,
        "section": next((one for one in SECTIONS if key.startswith(f"{one}.")), ""),
        "name": name,
        "unit": unit or _unit_of(about.get("description", "")),
        "kind": kind,
        "low": about.get("minimum", about.get("exclusiveMinimum")),
        "high": about.get("maximum", about.get("exclusiveMaximum")),
        "choices": list(about.get("enum", about.get("words", []))),
        "automatic": automatic,
        "help": given.get("description", about.get("description", "")),
    }


def _named(name: str) -> tuple[str, str]:
    """Split a name into words and its unit."""
    for end, unit in _UNITS.items():
        if name.endswith(end):
            return name.removesuffix(end).replace("_", " "), unit
    return name.replace("_", " "), ""


def _unit_of(help_text: str) -> str:
    """Return the unit that a description begins with: Klipper's names do not hold theirs."""
    found = re.match(r"(mm/s²|mm/s|mm)(?:;|$)", help_text)
    return found[1] if found else ""
