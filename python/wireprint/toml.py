"""TOML files of the user's, with errors that name file and line."""

from __future__ import annotations

import re
import tomllib
from typing import TYPE_CHECKING, Any, Final, TypeAlias

from wireprint._core import SettingError

if TYPE_CHECKING:
    from collections.abc import Iterable, Mapping
    from pathlib import Path

#: A dotted key, part by part.
Key: TypeAlias = tuple[str, ...]

#: Settings take a hundredth of it.
MOST_BYTES: Final = 1 << 20


def read(path: Path) -> tuple[str, dict[str, Any]]:
    """Read a file; return its text and what it says.

    Raises
    ------
    SettingError
        It cannot be read, or is no TOML.
    """
    try:
        with path.open("rb") as file:
            content = file.read(MOST_BYTES + 1)
    except OSError as error:
        raise SettingError(f"{path}: {error.strerror or error}") from None
    if len(content) > MOST_BYTES:
        raise SettingError(f"{path}: more than {MOST_BYTES >> 20} MB; settings are shorter")
    try:
        # Windows' editors begin UTF-8 with a mark.
        text = content.decode("utf-8-sig")
    except UnicodeDecodeError as error:
        line = content.count(b"\n", 0, error.start) + 1
        msg = f"{path}:{line}: not UTF-8; save the file in this encoding"
        raise SettingError(msg) from None
    try:
        return text, tomllib.loads(text)
    except tomllib.TOMLDecodeError as error:
        msg = f"{path}: not TOML: {error}"
    except RecursionError:
        msg = f"{path}: not settings: it is nested too deep"
    except ValueError:
        msg = f"{path}: not settings: a number has too many digits"
    raise SettingError(msg)


_TABLE = re.compile(r"\s*\[\s*([\w.\-]+)\s*\]")
_LISTED = re.compile(r"\s*\[\[\s*([\w.\-]+)\s*\]\]")
_ENTRY = re.compile(r"\s*([\w.\-]+)\s*=")


def lines_of_keys(text: str) -> Iterable[tuple[Key, int]]:
    """Yield each table and entry with its line number, which `tomllib` does not tell."""
    table: Key = ()
    quotes = ""
    counts: dict[Key, int] = {}
    for number, line in enumerate(text.splitlines(), start=1):
        if not quotes:
            if listed := _LISTED.match(line):
                name = tuple(listed[1].split("."))
                counts[name] = counts.get(name, -1) + 1
                table = (*name, str(counts[name]))
                yield table, number
            elif head := _TABLE.match(line):
                table = tuple(head[1].split("."))
                yield table, number
            elif entry := _ENTRY.match(line):
                yield (*table, *entry[1].split(".")), number
        for mark in ('"""', "'''"):
            if quotes in ("", mark) and line.count(mark) % 2:
                quotes = "" if quotes else mark


def merge(into: dict[str, Any], layer: Mapping[str, Any]) -> None:
    """Lay tables over others, entry by entry."""
    for name, value in layer.items():
        below = into.get(name)
        if isinstance(below, dict) and isinstance(value, dict):
            merge(below, value)
        else:
            into[name] = value
