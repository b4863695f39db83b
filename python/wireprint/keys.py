"""Every key of the settings as data: unit, bounds, default, help; made from their schema."""

from __future__ import annotations

import re
from dataclasses import asdict, dataclass
from typing import TYPE_CHECKING, Any, Final, Literal

from wireprint._compose import keys

if TYPE_CHECKING:
    from collections.abc import Iterator, Mapping

    from pydantic import BaseModel

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
    "_mpa": "MPa",
    "_deg": "°",
    "_n": "N",
    "_c": "°C",
    "_s": "s",
}
#: A unit within a description: Klipper's names do not hold theirs.
_TOLD: Final = re.compile(r"(?:^|, )(mm/s²|mm/s|mm)(?=[;:]|$)")
_KINDS: Final = {"number": "number", "integer": "integer", "boolean": "switch", "string": "text"}

Kind = Literal["number", "integer", "choice", "switch", "text", "list", "table"]


@dataclass(frozen=True, slots=True)
class Key:
    """One key of the settings."""

    #: Dotted, from the top of the settings: ``printer.head.slant_deg``.
    key: str
    #: As ``--set`` takes it, in its shortest form: ``head.slant_deg``.
    short: str
    #: Unit of its value, ``""`` where it has none.
    unit: str
    #: What holds a value.
    kind: Kind
    #: Lowest value; None: no bound, or none that is a number.
    low: float | None
    #: Highest value, likewise.
    high: float | None
    #: Whether the lowest value itself is left out.
    above_low: bool
    #: Whether the highest value itself is left out.
    below_high: bool
    #: Of a choice; of a number, words that stand for special amounts.
    choices: tuple[str, ...]
    #: Value where nothing is said, in JSON's types; None where `required`, or where it follows
    #: from other settings (`automatic`).
    default: Any
    #: Whether profiles must state it.
    required: bool
    #: Whether it may be left to follow from others.
    automatic: bool
    #: What it is, and where the default comes from.
    help: str

    @property
    def bounds(self) -> str:
        """What it may be, in words: ``5 … 85``, ``zigzag | peaks``."""
        words = " | ".join(self.choices)
        if self.low is None and self.high is None:
            return words or {"switch": "true | false"}.get(self.kind, self.kind)
        low = "" if self.low is None else f"{'> ' if self.above_low else ''}{self.low:g}"
        high = "" if self.high is None else f"{'< ' if self.below_high else ''}{self.high:g}"
        return f"{low} … {high}" + (f" | {words}" if words else "")

    @property
    def default_text(self) -> str:
        """The default in words."""
        if self.required:
            return "from the profile"
        if self.default is None:
            return "automatic" if self.automatic else "none"
        if isinstance(self.default, bool):
            return str(self.default).lower()
        return f"{self.default:g}" if isinstance(self.default, float) else str(self.default)

    def to_dict(self) -> dict[str, Any]:
        """Return everything as values that JSON knows.

        Returns
        -------
        dict
            By the names of the attributes.
        """
        return asdict(self) | {"choices": list(self.choices)}


def described(model: type[BaseModel]) -> tuple[Key, ...]:
    """Return every key of the settings, whose model is given, in order."""
    schema = model.model_json_schema()
    found = list(_keys(schema, schema["$defs"], ""))
    shorts = {f"printer.{name}": name for name in keys(model)}
    return tuple(Key(key=key, short=shorts.get(key, key), **about) for key, about in found)


def named(key: str) -> tuple[str, str]:
    """Split the last part of a key into words and its unit."""
    name = key.rpartition(".")[2]
    for end, unit in _UNITS.items():
        if name.endswith(end):
            return name.removesuffix(end).replace("_", " "), unit
    return name.replace("_", " "), ""


def _keys(
    node: Mapping[str, Any], known: Mapping[str, Any], prefix: str
) -> Iterator[tuple[str, dict[str, Any]]]:
    for name, given in node["properties"].items():
        about, automatic = _resolved(given, known)
        key = prefix + name
        if "properties" in about:
            yield from _keys(about, known, f"{key}.")
        else:
            required = name in node.get("required", ())
            yield key, _about(key, about, given, required=required, automatic=automatic)


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


def _about(
    key: str, about: Mapping[str, Any], given: Mapping[str, Any], *, required: bool, automatic: bool
) -> dict[str, Any]:
    text = given.get("description", about.get("description", ""))
    told = _TOLD.search(about.get("description", ""))
    low, high = about.get("exclusiveMinimum"), about.get("exclusiveMaximum")
    return {
        "unit": named(key)[1] or (told[1] if told else ""),
        "kind": _kind(about),
        "low": about.get("minimum", low),
        "high": about.get("maximum", high),
        "above_low": low is not None,
        "below_high": high is not None,
        "choices": tuple(about.get("enum", about.get("words", ()))),
        "default": given.get("default"),
        "required": required,
        "automatic": automatic,
        "help": text,
    }


def _kind(about: Mapping[str, Any]) -> Kind:
    if "enum" in about:
        return "choice"
    kind: Kind = _KINDS.get(about.get("type", ""), "list")  # type: ignore[assignment]
    return kind
