"""Files that a window gives, or writes beside its model: whole, and over nothing unasked."""

from __future__ import annotations

import os
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Final, Literal, TypeAlias

from wireprint._core import SettingError, UnprintableError
from wireprint.files import apart, written_whole
from wireprint.regions import document
from wireprint.text import one_line

if TYPE_CHECKING:
    from wireprint._core import Mesh
    from wireprint.settings import Settings
    from wireprint.window.history import State

Kind: TypeAlias = Literal["gcode", "project", "strokes"]
_SUFFIXES: Final[dict[Kind, str]] = {
    "gcode": ".gcode",
    "project": ".3mf",
    "strokes": ".strokes.json",
}


@dataclass(frozen=True)
class Printed:
    """A print, as it is told and exported."""

    state: State
    gcode: bytes
    #: Why it should not be printed as it is; empty: it may.
    refused: str
    told: dict[str, bytes]

    @property
    def size(self) -> int:
        """Bytes that it takes to keep."""
        return len(self.gcode) + sum(map(len, self.told.values()))


def gcode(printed: Printed | None, force: bool) -> bytes:
    """Return the G-code of a print.

    Raises
    ------
    UnprintableError
        There is none, or one that breaks the rules or leaves much bare, which needs `force`.
    """
    if printed is None:
        raise UnprintableError("there is no print to export")
    if printed.refused and not force:
        raise UnprintableError(printed.refused)
    return printed.gcode


def strokes(state: State) -> bytes:
    """Return the marks."""
    return document.to_json(state.region)


def project(mesh: Mesh, settings: Settings, state: State) -> bytes:
    """Return model, settings and marks as one file."""
    from wireprint.project import project_bytes

    return project_bytes(mesh, settings, state.region)


def name_of(kind: Kind, model: str) -> str:
    """Return what a file is called, by the name of its model, which it never is."""
    stem, suffix = one_line(Path(model).stem), _SUFFIXES[kind]
    return f"{stem}{suffix}" if f"{stem}{suffix}" != model else f"{stem}.studio{suffix}"


def save(model: Path, name: str, content: bytes, over: str | None) -> str | None:
    """Write a file beside a model, whole or not at all.

    Parameters
    ----------
    model
        The model's file.
    name
        What it shall be called.
    content
        The whole of it.
    over
        What was returned when a file was in the way, if it may be written over.

    Returns
    -------
    str or None
        None: it is written. Otherwise another file is in the way, as it is now.

    Raises
    ------
    OutputError
        It cannot be written.
    """
    path = model.absolute().parent / name
    apart(path, [model])
    there = _look(path)
    if there is not None and there != over:
        return there
    written_whole(path, content)
    return None


def picture(printed: Printed | None, angles: tuple[float, float], size: tuple[int, int]) -> bytes:
    """Draw a print without the browser's help, as a PNG file.

    Parameters
    ----------
    printed
        The print.
    angles
        Azimuth and elevation that it is seen from, degrees.
    size
        Width and height, pixels.
    """
    from wireprint._core import Strands
    from wireprint.view import render_png

    if printed is None:
        raise SettingError("there is no print to draw")
    camera = f"{angles[0]},{angles[1]}"
    strands = Strands.from_gcode(printed.gcode)
    return render_png(strands, size=size, camera=camera, with_legend=False)


def _look(path: Path) -> str | None:
    """Return what changes when a file does; None: there is none."""
    try:
        about = os.lstat(path)
    except FileNotFoundError:
        return None
    return f"{about.st_ino} {about.st_size} {about.st_mtime_ns}"
