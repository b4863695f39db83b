"""What was measured, written into a profile: a new one, or one that is there."""

from __future__ import annotations

import tomllib
from pathlib import Path
from typing import TYPE_CHECKING, Final

from wireprint import catalogue, toml
from wireprint._core import SettingError
from wireprint.lineage import INHERITS, tables
from wireprint.toml_text import written

if TYPE_CHECKING:
    from collections.abc import Mapping

_TABLE: Final = "[head]"


def new(printer: str, name: str, figures: Mapping[str, float], source: str) -> str:
    """Return the text of a profile that is another's but for its head.

    Parameters
    ----------
    printer
        A shipped printer, which it then inherits from, or a file, whose figures it takes over.
    name
        What the printer is called.
    figures
        By key of `[head]`.
    source
        How they were found; a comment behind each.
    """
    comments: dict[toml.Key, str] = {("head", key): source for key in figures}
    head = [f"{printer} with its head as measured."]
    if printer in catalogue.names("printers"):
        values = {"name": name, INHERITS: printer, "head": dict(figures)}
    else:
        values = tables(printer)
        values["name"] = name
        toml.merge(values, {"head": dict(figures)})
    return written(values, comments, head)


def updated(path: Path, figures: Mapping[str, float], source: str) -> str:
    """Return the text of a profile with other figures in `[head]`, all else as it stands.

    Raises
    ------
    SettingError
        The figures stand where no line can be changed by itself.
    """
    text, table = toml.read(path)
    lines, numbers = text.splitlines(), dict(toml.lines_of_keys(text))
    missing = []
    for key, value in figures.items():
        entry = f"{key} = {value!r}"
        comment = f"{entry:27} # {source}"
        number = numbers.get(("head", key))
        if number is None:
            missing.append(comment)
        else:
            lines[number - 1] = comment
    if missing and ("head",) in numbers:
        lines[numbers["head",] : numbers["head",]] = missing
    elif missing:
        lines += ["", _TABLE, *missing]
    changed = "\n".join([*lines, ""])
    toml.merge(table, {"head": dict(figures)})
    try:
        as_meant = tomllib.loads(changed) == table
    except tomllib.TOMLDecodeError:
        as_meant = False
    if not as_meant:
        told = ", ".join(f"{key} = {value!r}" for key, value in figures.items())
        msg = f"{path}: {_TABLE} is not written line by line; put {told} there yourself"
        raise SettingError(msg)
    return changed
