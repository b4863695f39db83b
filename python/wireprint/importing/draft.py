"""A printer's profile while it is gathered: figures, their sources, and what was not understood."""

from __future__ import annotations

import math
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any

from wireprint._core import SettingError
from wireprint.text import one_line

if TYPE_CHECKING:
    from wireprint.importing.reading import Given
    from wireprint.toml import Key


@dataclass
class Draft:
    """What is known of a printer so far."""

    values: dict[str, Any] = field(default_factory=dict)
    #: Source of each value, as it will stand in the profile's comment.
    comments: dict[Key, str] = field(default_factory=dict)
    #: Sentences about what a user should know.
    remarks: list[str] = field(default_factory=list)
    #: Where the rest stands, for one who misses it.
    hint: str = ""
    #: What the source calls the printer, in any of its keys.
    called: list[str] = field(default_factory=list)
    #: Temperatures that the source has for its filament, °C.
    temperatures: dict[str, float] = field(default_factory=dict)

    def put(self, key: str, value: Any, source: str) -> None:
        """Keep a value; a later one replaces it."""
        *tables, name = key.split(".")
        table = self.values
        for part in tables:
            table = table.setdefault(part, {})
        table[name] = value
        self.comments[tuple(key.split("."))] = one_line(source)

    def get(self, key: str) -> Any:
        """Return a value; None where there is none yet."""
        found: Any = self.values
        for part in key.split("."):
            found = found.get(part) if isinstance(found, dict) else None
        return found

    def fill(self, key: str, value: Any, source: str) -> None:
        """Keep a value where there is none."""
        if self.get(key) is None:
            self.put(key, value, source)

    def drop(self, key: str) -> None:
        """Forget a value."""
        *tables, name = key.split(".")
        table: Any = self.values
        for part in tables:
            table = table.get(part, {})
        table.pop(name, None)
        self.comments.pop(tuple(key.split(".")), None)

    def remark(self, sentence: str) -> None:
        """Keep a sentence, once."""
        if sentence not in self.remarks:
            self.remarks.append(one_line(sentence))


def number(given: Given) -> float:
    """Return a value as a number.

    Raises
    ------
    SettingError
        It is none; the error names file, line and key.
    """
    try:
        # PrusaSlicer reads a number and leaves the rest; its own bundles have remarks there.
        value = float(given.text.partition("#")[0])
    except ValueError:
        value = math.nan
    if not math.isfinite(value):
        raise SettingError(f"{given.place}: {one_line(given.text)[:40]!r} is no number")
    return value


def whole_if_it_is(value: float) -> float | int:
    """Return a number without the point that says nothing."""
    return int(value) if float(value).is_integer() and abs(value) < 1e15 else value
