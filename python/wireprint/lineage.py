"""Profiles as files that inherit from each other: ``inherits = "NAME"``, or a path beside them."""

from __future__ import annotations

import re
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any, Final

from wireprint import catalogue, toml
from wireprint._core import SettingError

if TYPE_CHECKING:
    from collections.abc import Iterable, Sequence

    from wireprint.toml import Key

#: The key that names another profile, whose figures hold wherever a profile has none.
INHERITS: Final = "inherits"
#: A family has two or three generations; more is a mistake.
_MOST_GENERATIONS: Final = 10
#: What a printer is called is its own, and not that of the one it takes its figures from.
_OWN: Final = ("name", "known_as")
#: Sizes of a bed that go with its shape.
_SIZES_OF_SHAPES: Final = ("diameter_mm", "width_mm", "depth_mm")


#: What names of presets say of the nozzle, which is a figure of its own.
_NOZZLE: Final = re.compile(r"\s*\(?\b\d?\.\d+ ?(?:mm)? nozzle\b\)?", re.IGNORECASE)


@dataclass(frozen=True)
class Generation:
    """One file of a profile."""

    path: Path
    text: str
    #: What it says, without what only its heirs do not take over.
    table: dict[str, Any]
    #: Line of each table and entry, from 1.
    lines: dict[Key, int]


def generations(kind: catalogue.Kind, name: str) -> list[Generation]:
    """Read a profile and all that it inherits from, the oldest first.

    Parameters
    ----------
    kind, name
        As for `catalogue.find`. A printer may be a file of another program, too, with the name of
        its hot end, or of a printer that is like it: ``printer.cfg#v6``.

    Raises
    ------
    SettingError
        A file cannot be read, is no TOML, or inherits from nothing or from itself.
    """
    if kind == "printers" and (foreign := _foreign(name)) is not None:
        return [_imported(*foreign)]
    found: list[Generation] = []
    path = catalogue.find(kind, name)
    while True:
        text, table = toml.read(path)
        lines = dict(toml.lines_of_keys(text))
        parent = table.pop(INHERITS, None)
        found.append(Generation(path, text, table, lines))
        if parent is None:
            break
        path = _parent(kind, found, parent, f"{path.name}:{lines.get((INHERITS,), 1)}: {INHERITS}")
    if len(found) > 1:
        found[0].table.setdefault("name", found[0].path.stem)
    for place, heir in enumerate(found):
        elders = found[place + 1 :]
        for elder in elders:
            for key in _OWN:
                elder.table.pop(key, None)
        _give_up_sizes(heir.table, elders)
    return found[::-1]


def _parent(kind: catalogue.Kind, heirs: list[Generation], parent: Any, place: str) -> Path:
    """Return the file that the last of the heirs names."""
    if not isinstance(parent, str):
        raise SettingError(f"{place}: {parent!r} is no name of a profile, nor a path")
    # A path is meant from where the file that names it lies.
    beside = heirs[-1].path.parent / parent if parent.endswith(".toml") else None
    try:
        path = catalogue.find(kind, parent if beside is None else str(beside))
    except SettingError as error:
        raise SettingError(f"{place}: {error}") from None
    names = [heir.path.name for heir in heirs] + [path.name]
    if any(path.resolve() == heir.path.resolve() for heir in heirs):
        raise SettingError(f"{place}: a circle: {' → '.join(names)}")
    if len(names) > _MOST_GENERATIONS:
        raise SettingError(f"{place}: more than {_MOST_GENERATIONS} files: {' → '.join(names)}")
    return path


def _give_up_sizes(heir: dict[str, Any], elders: list[Generation]) -> None:
    """Take the sizes of a bed of another shape away, for nothing could be said in their place."""
    bed = heir.get("bed")
    shape = bed.get("shape") if isinstance(bed, dict) else None
    for elder in elders:
        other = elder.table.get("bed")
        if shape is not None and isinstance(other, dict) and other.get("shape", shape) != shape:
            for key in _SIZES_OF_SHAPES:
                other.pop(key, None)


def tables(name: str) -> dict[str, Any]:
    """Return what a printer's profile and its elders say together."""
    values: dict[str, Any] = {}
    for file in generations("printers", name):
        toml.merge(values, file.table)
    return values


def profile_called(names: Iterable[str]) -> tuple[str, str] | None:
    """Return the profile of a shipped printer that is called by one of the names, and that name."""
    wanted = {_plain(name): name for name in names}
    if not wanted:
        return None
    for profile in catalogue.names("printers"):
        for alias in (profile, *tables(profile).get("known_as", ())):
            if (written := wanted.get(_plain(alias))) is not None:
                return profile, written
    return None


def namesake(names: Sequence[str]) -> tuple[str, str, dict[str, Any]] | None:
    """Return the shipped printer that a preset's names mean, whatever nozzle they name.

    Returns
    -------
    tuple
        Its profile, the name that means it, and its tables.
    """
    found = profile_called([*names, *(_NOZZLE.sub("", name) for name in names)])
    return found and (*found, tables(found[0]))


def _plain(name: str) -> str:
    """Write a name so that spelling does not matter: ``Voron 2.4`` as ``voron24``."""
    return re.sub(r"[^a-z0-9]", "", name.lower())


def _foreign(name: str) -> tuple[str, str] | None:
    """Return a file of another program's, and what it is completed by; None for a profile."""
    path, _, by = name.partition("#")
    return (path, by) if path.lower().endswith(catalogue.FOREIGN_SUFFIXES) else None


def _imported(path: str, by: str) -> Generation:
    from wireprint.importing import imported
    from wireprint.importing.hotends import HOTENDS

    hotend = by if by in HOTENDS else None
    like = (by, tables(by)) if by and hotend is None else None
    found = imported([path], hotend=hotend, like=like, namesake=namesake)
    return Generation(Path(path), found.text(), dict(found.values), {})
