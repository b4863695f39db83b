"""The settings that slicers leave in their G-code and 3MF files."""

from __future__ import annotations

import json
import re
import zipfile
import zlib
from functools import partial
from typing import TYPE_CHECKING, Final

from wireprint._core import GcodeError, SettingError
from wireprint.gcode import source
from wireprint.importing import cura_files, cura_project, orca
from wireprint.importing.reading import MOST_BYTES, Config, Given, decoded
from wireprint.text import one_line

if TYPE_CHECKING:
    from pathlib import Path

#: Where projects keep the settings that they were made with: OrcaSlicer and Bambu Studio as JSON,
#: PrusaSlicer as lines of comments.
_ORCA_PART: Final = "Metadata/project_settings.config"
_PRUSA_PART: Final = "Metadata/Slic3r_PE.config"
_ENTRY: Final = re.compile(r"; ?([a-z]\w*) = ?(.*)")
#: What opens and closes such settings.
_BLOCKS: Final = {
    "; prusaslicer_config = begin": "; prusaslicer_config = end",
    "; SuperSlicer_config = begin": "; SuperSlicer_config = end",
    "; CONFIG_BLOCK_START": "; CONFIG_BLOCK_END",
}
#: A block has more lines than anything else that looks like one.
_FEWEST: Final = 20
#: Lines of Cura's that hold what was changed, as JSON in pieces.
_CURA: Final = re.compile(r";SETTING_3 (.*)")
#: Lines of its header, and what settings they tell.
_HEADER: Final = 100
_OF_HEADER: Final = {
    ";TARGET_MACHINE.NAME": "machine_name",
    ";FLAVOR": "machine_gcode_flavor",
    ";EXTRUDER_TRAIN.0.NOZZLE.DIAMETER": "machine_nozzle_size",
}


def in_3mf(path: Path) -> Config | None:
    """Return the settings in a project; None where it holds none.

    Raises
    ------
    SettingError
        The archive is damaged, or its settings are.
    """
    try:
        with zipfile.ZipFile(path) as archive:
            parts = {name: partial(_read, archive, name) for name in archive.namelist()}
            for part in (_ORCA_PART, _PRUSA_PART):
                if part in parts:
                    content = parts[part]()
                    if len(content) > MOST_BYTES:
                        raise SettingError(f"{path}: {part} is larger than any settings")
                    return _of_part(decoded(content, f"{path}, {part}"), part, path)
            return cura_project.settings(parts, path.name) or None
    except (zipfile.BadZipFile, zlib.error, OSError, RuntimeError, NotImplementedError) as error:
        raise SettingError(f"{path}: a damaged zip archive: {error}") from None


def _read(archive: zipfile.ZipFile, name: str) -> bytes:
    """Return a part's bytes, a byte more than settings have at most."""
    with archive.open(name) as file:
        return file.read(MOST_BYTES + 1)


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
    begin = next((i for i, line in enumerate(lines) if line.strip() in _BLOCKS), None)
    if begin is None:
        found = _longest_run(lines, path.name)
    else:
        closes = _BLOCKS[lines[begin].strip()]
        end = next((i for i in range(begin, len(lines)) if lines[i].strip() == closes), len(lines))
        found = _entries(lines[begin:end], path.name, begin + 1)
    if len(found) >= _FEWEST:
        return orca.renamed(found)
    cura = _of_cura(lines, path.name)
    if cura:
        return cura
    msg = (
        f"{path}: no slicer left its settings at the end of this file; import the printer's own "
        "profile (printer.cfg, .ini, .json)"
    )
    raise SettingError(msg)


def _longest_run(lines: list[str], name: str) -> Config:
    """Return the most settings that stand in one run of comments.

    Older slicers do not say where theirs begin, and binary G-code has them ahead of the commands.
    """
    longest: Config = {}
    begin = 0
    for end in range(len(lines) + 1):
        if end < len(lines) and (lines[end].startswith(";") or not lines[end].strip()):
            continue
        if end - begin >= max(_FEWEST, len(longest)):
            found = _entries(lines[begin:end], name, begin + 1)
            longest = found if len(found) > len(longest) else longest
        begin = end + 1
    return longest


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
    for number, line in enumerate(lines[:_HEADER], start=1):
        key, colon, value = line.partition(":")
        if colon and key in _OF_HEADER and value.strip():
            found[_OF_HEADER[key]] = Given(value.strip(), f"{name}:{number}, {key[1:]}")
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
    if len(found) > 1:
        found.setdefault("definition", Given(cura_files.BASES[0], f"{name}, SETTING_3"))
    return found if "definition" in found else {}
