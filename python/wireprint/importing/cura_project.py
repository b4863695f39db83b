"""Cura's projects: 3MF files with the machine, its extruders and all that was changed of them."""

from __future__ import annotations

import configparser
from typing import TYPE_CHECKING, Final

from wireprint._core import SettingError
from wireprint.importing import cura_files
from wireprint.importing.orca import json_object
from wireprint.importing.reading import MOST_BYTES, Config, Given, decoded

if TYPE_CHECKING:
    from collections.abc import Callable, Mapping

    Parts = Mapping[str, Callable[[], bytes]]

#: Where Cura keeps its own files.
_FOLDER: Final = "Cura/"
_MACHINE: Final = ".global.cfg"
_EXTRUDER: Final = ".extruder.cfg"
#: What a machine is called.
_NAMES: Final = ("machine_name", "definition")
#: A stack has eight containers; more are no stack of Cura's.
_MOST_CONTAINERS: Final = 32


def settings(parts: Parts, project: str) -> Config:
    """Return a machine's settings with its first extruder's, as Cura would find them.

    Parameters
    ----------
    parts
        The files of the archive by name, each read when it is called.
    project
        The archive's name.

    Returns
    -------
    dict
        Empty where it is no project of Cura's.

    Raises
    ------
    SettingError
        One of Cura's files is damaged; the error names it.
    """
    machines = [name for name in sorted(parts) if _is(name, _MACHINE)]
    if not machines:
        return {}
    found = _of_stack(machines[0], parts, project, {})
    for name in sorted(parts):
        if _is(name, _EXTRUDER) and _parsed(name, parts, project).get(
            "metadata", "position", fallback=""
        ) in ("", "0"):
            extruder = _of_stack(name, parts, project, found)
            # Its definition is no machine's.
            return found | {key: extruder[key] for key in extruder if key not in _NAMES}
    return found


def _is(name: str, end: str) -> bool:
    return name.startswith(_FOLDER) and name.endswith(end)


def _of_stack(name: str, parts: Parts, project: str, known: Config) -> Config:
    """Return what the containers of a stack say together; the first of them says last."""
    stack = _parsed(name, parts, project)
    numbered = dict(stack.items("containers")) if stack.has_section("containers") else {}
    names = [numbered[str(i)] for i in range(_MOST_CONTAINERS) if str(i) in numbered]
    found: Config = {}
    for container in reversed(names):
        base = f"{_FOLDER}{container}"
        if (file := f"{base}.def.json") in parts:
            found |= _definition(file, parts, project)
        elif (file := f"{base}.inst.cfg") in parts:
            found |= _instance(file, parts, project, known | found)
    return found


def _definition(name: str, parts: Parts, project: str) -> Config:
    place = f"{project}, {name}"
    text = _text(name, parts, project)
    table = json_object(text, place)
    found = cura_files.stated(table, text, place, {})
    if isinstance(table.get("name"), str):
        found["machine_name"] = Given(table["name"], f"{place}, name")
        own = name.removeprefix(_FOLDER).removesuffix(".def.json")
        found["definition"] = Given(own, place)
    return found


def _instance(name: str, parts: Parts, project: str, known: Config) -> Config:
    parser = _parsed(name, parts, project)
    found: Config = {}
    for key, value in parser.items("values") if parser.has_section("values") else ():
        place = f"{project}, {name}, {key}"
        given = cura_files.given(value.removeprefix("="), place, known | found)
        if given is not None:
            found[key] = given
    return found


def _parsed(name: str, parts: Parts, project: str) -> configparser.ConfigParser:
    parser = configparser.ConfigParser(interpolation=None, strict=False)
    try:
        parser.read_string(_text(name, parts, project))
    except configparser.Error as error:
        msg = f"{project}, {name}: no settings of Cura: {str(error).splitlines()[0]}"
        raise SettingError(msg) from None
    return parser


def _text(name: str, parts: Parts, project: str) -> str:
    content = parts[name]()
    if len(content) > MOST_BYTES:
        raise SettingError(f"{project}: {name} is larger than any settings")
    return decoded(content, f"{project}, {name}")
