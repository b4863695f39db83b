"""The profiles that come with the package, as files."""

from __future__ import annotations

import difflib
from pathlib import Path
from typing import Literal

from wireprint._core import SettingError

Kind = Literal["printers", "materials"]
KINDS: tuple[Kind, ...] = ("printers", "materials")

#: Files of other programs that say what a printer is: firmware's, slicers', and their G-code.
FOREIGN_SUFFIXES = (".cfg", ".ini", ".json", ".gcode", ".bgcode", ".3mf")
_EXAMPLE: dict[Kind, str] = {"printers": "prusa-mk4s", "materials": "pla"}

_FOLDER = Path(__file__).parent / "profiles"


def names(kind: Kind) -> list[str]:
    """Names of the profiles of a kind, sorted."""
    return sorted(path.stem for path in (_FOLDER / kind).glob("*.toml"))


def find(kind: Kind, name: str) -> Path:
    """File of a profile.

    Parameters
    ----------
    kind
        What it describes.
    name
        Name of a profile of the package, or path of a TOML file of the user's.

    Raises
    ------
    SettingError
        Where there is no such profile; close names are suggested.
    """
    noun = kind.removesuffix("s")
    if name.endswith(".toml"):
        path = Path(name)
        if path.is_file():
            return path
        msg = f"{name}: {'this is a folder' if path.is_dir() else 'no such file'}"
        raise SettingError(msg)
    if name.endswith(FOREIGN_SUFFIXES):
        example = _EXAMPLE[kind]
        msg = (
            f"{name}: a {noun}'s profile is a TOML file; write one from the nearest "
            f"(wireprint profiles {example} > mine.toml), with the figures of that file"
        )
        raise SettingError(msg)
    known = names(kind)
    if name in known:
        return _FOLDER / kind / f"{name}.toml"
    msg = f"no {noun} is called {name!r}; {hint(name, known)}"
    raise SettingError(msg)


def headline(path: Path) -> str:
    """Return the comment on the first line of a profile: what it is."""
    with path.open(encoding="utf-8") as file:
        return file.readline().lstrip("# ").rstrip()


def hint(name: str, known: list[str]) -> str:
    """Say which of the known names were probably meant."""
    close = difflib.get_close_matches(name, known, n=2)
    if close:
        return f"did you mean {' or '.join(close)}?"
    return f"there are {', '.join(known)}"
