"""The settings that a file was made with, in comments at its end."""

from __future__ import annotations

import json
from functools import lru_cache
from typing import TYPE_CHECKING, Any, Final

from wireprint._core import GcodeError, SettingError

if TYPE_CHECKING:
    from collections.abc import Iterator, Mapping, Sequence

    from wireprint.settings import Settings

_BEGIN: Final = "; wireprint_settings = begin"
_END: Final = "; wireprint_settings = end"


@lru_cache(maxsize=8)
def block(settings: Settings) -> str:
    """Write all settings, a line each; files that are made together mostly share theirs."""
    return "\n".join([_BEGIN, *_lines(settings.model_dump()), _END])


def _lines(values: Mapping[str, Any], prefix: str = "") -> Iterator[str]:
    for name, value in values.items():
        if isinstance(value, dict):
            yield from _lines(value, f"{prefix}{name}.")
        else:
            # Most are numbers, all finite, which need no encoder.
            text = repr(value) if type(value) in (int, float) else json.dumps(value)
            yield f"; {prefix}{name} = {text}"


def settings_in(text: bytes) -> Settings | None:
    """Return the settings that a file of wireprint was made with; None in any other file.

    Raises
    ------
    GcodeError
        The block of settings is damaged, or another version wrote it; it names the line.
    """
    begin, end = text.rfind(_BEGIN.encode()), text.rfind(_END.encode())
    if not 0 <= begin < end:
        return None
    from wireprint.settings import Settings

    values: dict[str, Any] = {}
    number = first = text.count(b"\n", 0, begin) + 1
    way_out = "name what it was made for by --printer, for an estimate also by --material"
    try:
        for line in text[begin:end].decode().split("\n")[1:-1]:
            number += 1
            key, _, value = line.removeprefix("; ").partition(" = ")
            *groups, name = key.split(".")
            table = values
            for group in groups:
                table = table.setdefault(group, {})
            table[name] = json.loads(value)
    except (ValueError, AttributeError, TypeError, RecursionError):
        msg = f"line {number}: the settings that the file was made with are damaged; {way_out}"
        raise GcodeError(msg) from None
    try:
        return Settings.from_mapping(values)
    except SettingError as error:
        told = text[begin:end].decode().split("\n")
        number = first + _line_of(str(error).partition(":")[0], told)
        what = "the settings that the file was made with do not fit"
        raise GcodeError(f"line {number}: {what}: {error}; {way_out}") from None


def _line_of(key: str, lines: Sequence[str]) -> int:
    """Index of the line that gives a key, or the first key of a table; 0 where none does."""
    for given in (f"; {key} = ", f"; printer.{key} = ", f"; {key}.", f"; printer.{key}."):
        for index, line in enumerate(lines):
            if line.startswith(given):
                return index
    return 0
