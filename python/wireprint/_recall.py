"""Settings that were validated before, recalled from the user's cache.

Loading pydantic and building its validators takes longer than a small model's wire print. So the
command keeps what validation gave, beside the very text that it was given: profiles, files, single
keys, and the code that defines the settings. Where all of it is the same again, so is the outcome.
Whatever asks a recalled group for more than its values gets the real one, made then.
"""

from __future__ import annotations

import json
import os
import zlib
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Any, NamedTuple, cast

from wireprint._core import WireprintError, __version__
from wireprint.files import written_whole
from wireprint.lineage import generations

if TYPE_CHECKING:
    from collections.abc import Callable, Iterable, Mapping

    from wireprint.settings import Settings
    from wireprint.settings.section import Section

#: The cache holds at most this many outcomes; a new one replaces the one in its place.
PLACES = 64
#: What the outcome depends on besides the settings' own text.
_CODE = (
    *sorted((Path(__file__).parent / "settings").glob("*.py")),
    *(
        Path(__file__).parent / name
        for name in (
            "bounds.py",
            "choices.py",
            "_compose.py",
            "lineage.py",
            "nozzles.py",
            "cooling.py",
            "gcode/sequence.py",
        )
    ),
)


def settings(
    printer: str,
    material: str,
    load: Iterable[str | Path],
    overrides: Iterable[str],
    nozzle_mm: float | None = None,
) -> Settings:
    """Compose settings as `Settings.load` does, from the cache where it knows them.

    Raises
    ------
    SettingError
        As `Settings.load`.
    """
    asked = Asked(printer, material, tuple(load), tuple(overrides), nozzle_mm)
    key = _key(asked)
    if key is None:
        return _validated(asked)
    place = _folder() / f"settings-{zlib.crc32(key.encode()) % PLACES}.json"
    values = _read(place, key)
    if values is None:
        found = _validated(asked)
        _keep(place, key, found)
        return found
    return cast("Settings", Recalled(values, lambda: _validated(asked)))


class Asked(NamedTuple):
    """What `Settings.load` is asked for."""

    printer: str
    material: str
    load: tuple[str | Path, ...]
    overrides: tuple[str, ...]
    nozzle_mm: float | None


class Recalled:
    """A group of settings by its plain values; stands in for a `Section`.

    Parameters
    ----------
    values
        ``fields``: the group's own values; ``derived``: those of its properties. Groups within
        are mappings of the same form.
    real
        Makes the section itself.
    """

    def __init__(self, values: Mapping[str, Any], real: Callable[[], Any]) -> None:
        self._fields = {
            name: self._value(value, partial(_attribute, real, name))
            for name, value in values["fields"].items()
        }
        self._derived = {name: _tuples(value) for name, value in values["derived"].items()}
        self._real = real

    @classmethod
    def _value(cls, value: Any, real: Callable[[], Any]) -> Any:
        if isinstance(value, dict):
            return cls(value, real)
        if isinstance(value, list):
            return tuple(cls._value(one, partial(_item, real, i)) for i, one in enumerate(value))
        return value

    def __getattr__(self, name: str) -> Any:
        """Return a value; where it is none, what the section itself has."""
        if name in self._fields:
            return self._fields[name]
        if name in self._derived:
            return self._derived[name]
        return getattr(self._real(), name)

    def __str__(self) -> str:
        """Say what the section says."""
        return str(self._real())

    def model_dump(self, **options: Any) -> dict[str, Any]:
        """Return the values as `pydantic.BaseModel.model_dump` does."""
        if options:
            return cast("dict[str, Any]", self._real().model_dump(**options))
        return {name: _dumped(value) for name, value in self._fields.items()}


def _attribute(real: Callable[[], Any], name: str) -> Any:
    return getattr(real(), name)


def _item(real: Callable[[], Any], place: int) -> Any:
    return real()[place]


def _dumped(value: Any) -> Any:
    if isinstance(value, Recalled):
        return value.model_dump()
    return tuple(map(_dumped, value)) if isinstance(value, tuple) else value


def _plain(value: Any) -> Any:
    if isinstance(value, tuple):
        return [_plain(one) for one in value]
    return plain(value) if hasattr(value, "model_fields_set") else value


def plain(section: Section) -> dict[str, Any]:
    """Return a section's values in the form that `Recalled` takes, in JSON's types."""
    from wireprint.settings.section import Section

    kind = type(section)
    fields = {name: getattr(section, name) for name in kind.model_fields}
    bases = kind.__mro__[: kind.__mro__.index(Section)]
    derived = {
        name: getattr(section, name)
        for base in bases
        for name, value in vars(base).items()
        if isinstance(value, property)
    }
    return {
        "fields": {name: _plain(value) for name, value in fields.items()},
        "derived": derived,
    }


def _tuples(value: Any) -> Any:
    """Return JSON's lists as the tuples that they were."""
    return tuple(map(_tuples, value)) if isinstance(value, list) else value


def _validated(asked: Asked) -> Settings:
    from wireprint.settings import Settings

    return Settings.load(*asked)


def _key(asked: Asked) -> str | None:
    """Return all that the outcome depends on; None where it cannot be read."""
    try:
        family = [
            *generations("printers", asked.printer),
            *generations("materials", asked.material),
        ]
        texts = [Path(path).read_text(encoding="utf-8") for path in (*_CODE, *asked.load)]
    except (WireprintError, OSError, ValueError):
        return None
    given = [asked.printer, asked.material, asked.nozzle_mm, list(asked.overrides)]
    return json.dumps([__version__, *given, [file.text for file in family], texts])


def _folder() -> Path:
    base = os.environ.get("XDG_CACHE_HOME") or os.environ.get("LOCALAPPDATA")
    return Path(base or os.path.expanduser("~/.cache")) / "wireprint"


def _read(place: Path, key: str) -> dict[str, Any] | None:
    """Return the values of a place; None where it holds others, or is not as it was written."""
    try:
        digest, _, text = place.read_bytes().partition(b"\n")
        if digest != _digest(text):
            return None
        kept = json.loads(text)
        return cast("dict[str, Any]", kept["values"]) if kept["key"] == key else None
    except (OSError, ValueError, LookupError, TypeError):
        return None


def _keep(place: Path, key: str, found: Settings) -> None:
    """Write an outcome to its place; a cache that cannot be written to is done without."""
    text = json.dumps({"key": key, "values": plain(found)}).encode()
    try:
        place.parent.mkdir(parents=True, exist_ok=True)
        written_whole(place, _digest(text) + b"\n" + text)
    except (OSError, WireprintError):
        return


def _digest(text: bytes) -> bytes:
    """Return what tells whether a text was damaged, or changed by hand; a CRC imports nothing."""
    return f"{zlib.crc32(text):08x}".encode()
