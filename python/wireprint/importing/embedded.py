"""The settings that slicers leave in their G-code and 3MF files."""

from __future__ import annotations

import json
import re
import zipfile
import zlib
from typing import TYPE_CHECKING, Final

from wireprint._core import GcodeError, SettingError
from wireprint.gcode import source
from wireprint.importing import orca
from wireprint.importing.reading import MOST_BYTES, Config, Given, decoded
from wireprint.text import one_line

if TYPE_CHECKING:
    from pathlib import Path

#: Where projects keep the settings that they were made with: OrcaSlicer and Bambu Studio as JSON,
#: PrusaSlicer as lines of comments.
_ORCA_PART: Final = "Metadata/project_settings.config"
_PRUSA_PART: Final = "Metadata/Slic3r_PE.config"
_ENTRY: Final = re.compile(r"; ?([a-z]\w*) = ?(.*)")
_BEGINS: Final = (
    "; prusaslicer_config = begin",
    "; SuperSlicer_config = begin",
    "; CONFIG_BLOCK_START",
)
#: A block has more lines than anything else that looks like one.
_FEWEST: Final = 20
#: Lines of Cura's that hold what was changed, as JSON in pieces.
_CURA: Final = re.compile(r";SETTING_3 (.*)")


def in_3mf(path: Path) -> Config | None:
    """Return the settings in a project; None where it holds none.

    Raises
    ------
    SettingError
        The archive is damaged, or its settings are.
    """
    try:
        with zipfile.ZipFile(path) as archive:
            names = {info.filename: info for info in archive.infolist()}
            for part in (_ORCA_PART, _PRUSA_PART):
                if part in names:
                    with archive.open(names[part]) as file:
                        content = file.read(MOST_BYTES + 1)
                    if len(content) > MOST_BYTES:
                        raise SettingError(f"{path}: {part} is larger than any settings")
                    return _of_part(decoded(content, f"{path}, {part}"), part, path)
    except (zipfile.BadZipFile, zlib.error, OSError, RuntimeError, NotImplementedError) as error:
        raise SettingError(f"{path}: a damaged zip archive: {error}") from None
    return None


def _of_part(text: str, part: str, path: Path) -> Config:
    name = f"{path.name}, {part}"
    if part == _ORCA_PART:
        return orca.renamed(orca.config_of(orca.json_object(text, name), text, name))
    return _entries(text.splitlines(), name, 1)


def in_gcode(path: Path) -> Config:
    """Return the settings at the end of a G-code file, of whatever slicer.

    Raises
    ------
    SettingError
        It is no G-code, or no slicer left any in it.
    """
    try:
        content, _ = source.read(path)
    except GcodeError as error:
        raise SettingError(str(error)) from None
    text = decoded(content, str(path))
    lines = text.splitlines()
    begin = next((i for i, line in enumerate(lines) if line.strip() in _BEGINS), None)
    if begin is None:
        # Older slicers do not say where it begins: it is the last run of such lines.
        begin = len(lines)
        while begin and (lines[begin - 1].startswith(";") or not lines[begin - 1].strip()):
            begin -= 1
    found = orca.renamed(_entries(lines[begin:], path.name, begin + 1))
    if len(found) >= _FEWEST:
        return found
    cura = _of_cura(lines, path.name)
    if cura:
        return cura
    msg = (
        f"{path}: no slicer left its settings at the end of this file; import the printer's own "
        "profile (printer.cfg, .ini, .json)"
    )
    raise SettingError(msg)


def _entries(lines: list[str], name: str, first: int) -> Config:
    found: Config = {}
    for number, line in enumerate(lines, start=first):
        if entry := _ENTRY.match(line):
            found[entry[1]] = Given(entry[2].strip(), f"{name}:{number}, {entry[1]}")
    return found


def _of_cura(lines: list[str], name: str) -> Config:
    """Return what Cura wrote of changed settings; a machine's own figures are not among them."""
    pieces = [match[1] for line in lines if (match := _CURA.fullmatch(line))]
    found: Config = {}
    for line in lines[:100]:
        if line.startswith(";TARGET_MACHINE.NAME:"):
            found["machine_name"] = Given(line.partition(":")[2].strip(), f"{name}, TARGET_MACHINE")
    if not pieces:
        return {}
    try:
        parts = json.loads("".join(pieces).replace("\\\\", "\\"))
    except (ValueError, RecursionError):
        return {}
    texts = parts.values() if isinstance(parts, dict) else ()
    for text in (
        part for value in texts for part in (value if isinstance(value, list) else [value])
    ):
        if isinstance(text, str):
            for line in text.replace("\\n", "\n").splitlines():
                key, equals, value = line.partition(" = ")
                if equals and key.isidentifier():
                    found[key] = Given(value.strip(), f"{name}, SETTING_3 {one_line(key)}")
    return found if len(found) > 1 else {}
