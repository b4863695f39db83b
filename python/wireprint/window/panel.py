"""What can be set, as fields of a form."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Final, TypedDict

from wireprint import keys
from wireprint.settings import describe

if TYPE_CHECKING:
    from collections.abc import Iterator, Mapping

    from wireprint.settings import Settings

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
    order = list(SECTIONS)
    shown = [
        _field(key, section)
        for key in describe()
        if key.kind not in ("list", "table") and (section := _section(key.key)) is not None
    ]
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


def _section(key: str) -> str | None:
    return next((section for section in SECTIONS if key.startswith(f"{section}.")), None)


def _field(key: keys.Key, section: str) -> Field:
    return {
        "key": key.key,
        "section": section,
        "name": keys.named(key.key)[0],
        "unit": key.unit,
        "kind": key.kind,
        "low": key.low,
        "high": key.high,
        "choices": list(key.choices),
        "automatic": key.automatic,
        "help": key.help,
    }
