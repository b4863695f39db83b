"""Cura's files: ``.def.json`` with what they inherit, and ``.inst.cfg``."""

from __future__ import annotations

import configparser
import re
from typing import TYPE_CHECKING, Any, Final

from wireprint._core import SettingError
from wireprint.importing.expressions import Missing, Ours, Unknown, Value, evaluated
from wireprint.importing.orca import json_object
from wireprint.importing.reading import Config, Given, text_of
from wireprint.text import one_line

if TYPE_CHECKING:
    from pathlib import Path

#: What all machines inherit; its figures are for none in particular.
BASES: Final = ("fdmprinter", "fdmextruder")
_MOST_ELDERS: Final = 40
#: Name of a file in the same folder, without its end.
_FILE: Final = re.compile(r"[\w.\- ]{1,200}")
#: A name in front of what it stands for.
_KEY: Final = re.compile(r'"(\w+)"\s*:')
#: A choice in Python's words, which nobody but Cura can make.
_FORMULA: Final = re.compile(r"\bif\b.*\belse\b", re.DOTALL)


def definition(path: Path, text: str) -> Config:
    """Return a machine's settings with what it inherits from files of its folder.

    Raises
    ------
    SettingError
        A file is no JSON object, or inherits from nothing or from itself.
    """
    machine, extruder = _machine(path, text, ())
    # An extruder's own file stands above the machine's.
    return machine | extruder


def _machine(path: Path, text: str, heirs: tuple[Path, ...]) -> tuple[Config, Config]:
    """Return what a machine says with its elders, and what its first extruder says."""
    table = json_object(text, str(path))
    found: Config = {}
    extruder: Config = {}
    elder = table.get("inherits")
    chain = (*heirs, path)
    if isinstance(elder, str) and elder not in BASES:
        place = f"{path.name}, inherits"
        other = path.parent / f"{elder}.def.json"
        if "/" in elder or "\\" in elder or "\0" in elder or not other.is_file():
            msg = f"{place}: {one_line(elder)}.def.json is not in {path.parent}; put it there"
            raise SettingError(msg)
        if any(other.resolve() == one.resolve() for one in chain) or len(chain) > _MOST_ELDERS:
            names = " → ".join(one.name for one in (*chain, other))
            raise SettingError(f"{place}: definitions inherit in a circle: {names}")
        found, extruder = _machine(other, text_of(other), chain)
    extruder = _extruder(path, table) or extruder
    if isinstance(table.get("name"), str):
        found["machine_name"] = Given(table["name"], f"{path.name}, name")
    return found | stated(table, text, path.name, found | extruder), extruder


def stated(table: dict[str, Any], text: str, name: str, known: Config) -> Config:
    """Return what a definition states, formulas computed from that and from what is known.

    Parameters
    ----------
    table, text
        The file, parsed and as it is.
    name
        What places call it.
    known
        What other files state.
    """
    lines: dict[str, int] = {}
    for number, line in enumerate(text.splitlines(), start=1):
        for key in _KEY.findall(line):
            lines.setdefault(key, number)
    found: Config = {}
    for key, entry in _entries(table):
        place = f"{name}:{lines.get(key, 1)}, {one_line(key)}"
        # A formula that is none of ours leaves what stands beside it.
        usual = entry.get("default_value")
        for one in (entry.get("value", usual), usual):
            stripped = one.removeprefix("=") if isinstance(one, str) else one
            if (value := given(stripped, place, known | found)) is not None:
                found[key] = value
                break
    return found


def _entries(table: dict[str, Any]) -> list[tuple[str, dict[str, Any]]]:
    """Return what a file overrides, and what it holds as groups within groups, as projects do."""
    found: list[tuple[str, dict[str, Any]]] = []
    groups = [table.get("settings"), table.get("overrides")]
    while groups:
        group = groups.pop()
        for key, entry in group.items() if isinstance(group, dict) else ():
            if isinstance(entry, dict):
                found.append((key, entry))
                groups.append(entry.get("children"))
    return found


def _extruder(path: Path, table: dict[str, Any]) -> Config:
    """Return what a machine's first extruder says; its file lies beside, or in a folder of them."""
    metadata = table.get("metadata")
    trains = metadata.get("machine_extruder_trains") if isinstance(metadata, dict) else None
    name = trains.get("0") if isinstance(trains, dict) else None
    if not isinstance(name, str) or not _FILE.fullmatch(name):
        return {}
    for folder in (path.parent, path.parent.parent / "extruders"):
        file = folder / f"{name}.def.json"
        if file.is_file():
            text = text_of(file)
            own = json_object(text, str(file))
            return stated(own, text, file.name, {})
    return {}


def given(value: Any, place: str, known: Config) -> Given | None:
    """Return a value as text, a formula computed; None where only Cura can."""
    if isinstance(value, bool):
        return Given(str(int(value)), place)
    if isinstance(value, int | float):
        return Given(f"{value:.10g}", place)
    if isinstance(value, list):
        return Given(str(value), place)
    if not isinstance(value, str) or _FORMULA.search(value):
        return None
    if "\n" in value or (" " in value and ";" in value) or not value:
        return Given(value, place)
    try:
        found = evaluated(value, lambda name, _: known_value(name, known))
    except Unknown:
        found = Missing(value)
    if isinstance(found, Missing | Ours):
        return Given(value, place) if not set(value) & set("()*/=") else None
    return Given(f"{found:.10g}" if isinstance(found, int | float) else str(found), place)


def known_value(name: str, known: Config) -> Value:
    """Return a setting as a number, or as the text that it is; `Unknown` where there is none."""
    if name not in known:
        raise Unknown(name)
    try:
        return float(known[name].text)
    except ValueError:
        return known[name].text


def instance(path: Path, text: str) -> Config:
    """Return what an ``.inst.cfg`` changes.

    Raises
    ------
    SettingError
        It is none; the error names the line.
    """
    parser = configparser.ConfigParser(interpolation=None, strict=False)
    try:
        parser.read_string(text)
    except configparser.Error as error:
        line = getattr(error, "lineno", None)
        place = f"{path.name}:{line}" if line else path.name
        what = one_line(str(error).splitlines()[0])
        raise SettingError(f"{place}: no settings of Cura: {what}") from None
    found: Config = {}
    lines = text.splitlines()
    for key, value in parser.items("values") if parser.has_section("values") else ():
        line = next((n for n, one in enumerate(lines, 1) if one.startswith(key)), 1)
        found[key] = Given(value.removeprefix("="), f"{path.name}:{line}, {one_line(key)}")
    if parser.has_option("general", "definition"):
        name = parser.get("general", "definition")
        found.setdefault("definition", Given(name, f"{path.name}, definition"))
        beside = path.parent / f"{name}.def.json"
        if "/" not in name and "\0" not in name and beside.is_file():
            found = definition(beside, text_of(beside)) | found
    return found
