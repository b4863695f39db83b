"""Where output goes: whole or not at all, and never over what is read.

Every file that wireprint writes passes through here.
"""

from __future__ import annotations

import errno
import os
import re
import stat
import sys
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Final

from wireprint import _aside
from wireprint._core import WireprintError
from wireprint.streams import STREAM

if TYPE_CHECKING:
    from collections.abc import Iterable, Sequence

GCODE_SUFFIXES: Final = (".gcode", ".gco", ".g", ".nc", ".ngc")
PICTURE_SUFFIXES: Final = (".png",)
PAGE_SUFFIXES: Final = (".html",)
EXAMPLE_SUFFIXES: Final = (".stl",)
PROJECT_SUFFIXES: Final = (".3mf",)

#: Names of descriptors that are open already: opened anew, a file would be written from its start.
_DESCRIPTOR: Final = re.compile(r"/(?:dev|proc/self)/fd/(\d+)|/dev/(stdin|stdout|stderr)")
_STANDARD: Final = ("stdin", "stdout", "stderr")


class OutputError(WireprintError):
    """A file cannot be written, or must not be."""

    exit_code = 2


@dataclass(frozen=True)
class Output:
    """A place to write to, which was found to be safe."""

    #: None: stdout.
    path: Path | None
    #: Whether its folder is made where there is none.
    makes_folder: bool = False

    def write(self, content: bytes) -> None:
        """Write all of it.

        Raises
        ------
        OutputError
            It cannot be written; then nothing has changed, unless it went to a pipe or device.
        """
        if self.path is None:
            to_stdout(content)
            return
        self.make_folder()
        written_whole(self.path, content)

    def make_folder(self) -> None:
        """Make the folder where it shall be made, as `write` does.

        Raises
        ------
        OutputError
            It cannot be made.
        """
        if self.path is None or not self.makes_folder:
            return
        try:
            self.path.parent.mkdir(parents=True, exist_ok=True)
        except OSError as error:
            raise _refused(self.path, error) from None

    def __str__(self) -> str:
        """Return the path as the user knows it."""
        return STREAM if self.path is None else os.fspath(self.path)


def output(
    given: str | os.PathLike[str],
    default: str,
    suffixes: Sequence[str],
    inputs: Iterable[str | os.PathLike[str]],
) -> Output:
    """Decide where output goes.

    Parameters
    ----------
    given
        What the user names: a file, a folder (one that is there, or with a slash at the end), a
        device, a pipe, or ``-`` for stdout.
    default
        Name of the file where a folder is given.
    suffixes
        What its name may end in, the usual one first; devices and pipes have any name.
    inputs
        Files that are read, none of which it may be, under whatever name.

    Raises
    ------
    OutputError
        It is an input, ends in something else, or its folder is not there.
    """
    given = os.fspath(given)
    if given == STREAM:
        apart(1, inputs)
        return Output(None)
    path = Path(given)
    in_folder = given.endswith(("/", os.sep)) or os.path.isdir(path)
    if in_folder:
        path = path / default
    apart(path, inputs)
    if not _is_special(path):
        _check_suffix(path, suffixes)
        _check_target(path, suffixes)
    if not in_folder and not os.path.isdir(path.parent):
        raise OutputError(f"{path}: there is no folder {path.parent}")
    return Output(path, makes_folder=in_folder)


def distinct(outputs: Iterable[Output | None]) -> None:
    """Refuse to write two things to one file.

    Raises
    ------
    OutputError
        Two of the outputs are the same.
    """
    taken: set[str] = set()
    for path in (one.path for one in outputs if one is not None):
        if path is None or _is_special(path):
            continue
        real = os.path.realpath(path)
        if real in taken:
            raise OutputError(f"{path}: two outputs would be written to this file; name another")
        taken.add(real)


def to_stdout(content: bytes) -> None:
    """Write to stdout.

    Raises
    ------
    OutputError
        It takes no more.
    BrokenPipeError
        Nobody reads it.
    """
    try:
        sys.stdout.buffer.write(content)
        sys.stdout.buffer.flush()
    except BrokenPipeError:
        raise
    except OSError as error:
        raise _refused(Path("stdout"), error) from None


def apart(target: str | os.PathLike[str] | int, inputs: Iterable[str | os.PathLike[str]]) -> None:
    """Refuse to write where something is read: the same file, through links or not.

    Parameters
    ----------
    target
        The path, or a descriptor that is open.
    inputs
        Paths of what is read.

    Raises
    ------
    OutputError
        It is one of them.
    """
    about = _stat(target)
    if about is None or stat.S_ISCHR(about.st_mode):
        return
    for path in inputs:
        other = _stat(path)
        if other is not None and os.path.samestat(about, other):
            name = "stdout" if isinstance(target, int) else os.fspath(target)
            msg = f"{name}: this is {os.fspath(path)}, which is read; name another output"
            raise OutputError(msg)


def written_whole(path: Path, content: bytes) -> None:
    """Write a file so that all of it is there, or nothing has changed.

    Parameters
    ----------
    path
        Where it shall stand. An older file there is replaced, and hands on its owner and
        permissions; a link is followed; devices and pipes are written to.
    content
        The whole of it.

    Raises
    ------
    OutputError
        It cannot be written.
    """
    try:
        number = _descriptor(path)
        if number is not None:
            sys.stdout.flush()
            _pour(os.dup(number), content)
        elif _is_special(path):
            _pour(os.open(path, os.O_WRONLY | getattr(os, "O_NOCTTY", 0)), content)
        else:
            real = Path(os.path.realpath(path))
            if real.is_symlink():
                raise OSError(errno.ELOOP, os.strerror(errno.ELOOP))
            if real.exists() and not os.access(real, os.W_OK):
                raise OutputError(f"{path}: the file is write-protected")
            _aside.replace(real, content)
    except OSError as error:
        raise _refused(path, error) from None


def _check_suffix(path: Path, suffixes: Sequence[str]) -> None:
    if path.suffix.lower() in suffixes:
        return
    *others, last = suffixes
    usual = f"{', '.join(others)} or {last}" if others else last
    if path.suffix:
        msg = f"{path}: {path.suffix} is not what is written here; end the name in {usual}"
    else:
        msg = f"{path}: end the name in {usual}, or in / for a folder"
    raise OutputError(msg)


def _check_target(path: Path, suffixes: Sequence[str]) -> None:
    """Refuse a link to what is there under a name that output does not have, such as a model."""
    real = Path(os.path.realpath(path))
    if path.is_symlink() and real.is_file() and real.suffix.lower() not in ("", *suffixes):
        msg = f"{path}: it leads to {real}, and {real.suffix} is not what is written here"
        raise OutputError(f"{msg}; name another output")


def _descriptor(path: Path) -> int | None:
    """Return the descriptor that a path is a name of."""
    found = _DESCRIPTOR.fullmatch(os.fspath(path))
    if found is None:
        return None
    number, name = found.groups()
    return int(number) if number else _STANDARD.index(name)


def _is_special(path: Path) -> bool:
    """Whether a path leads to a device or a pipe, which are written to and never replaced."""
    if _descriptor(path) is not None:
        return True
    about = _stat(path)
    return about is not None and not (stat.S_ISREG(about.st_mode) or stat.S_ISDIR(about.st_mode))


def _stat(target: str | os.PathLike[str] | int) -> os.stat_result | None:
    try:
        return os.stat(target)
    except (OSError, ValueError):
        return None


def _pour(handle: int, content: bytes) -> None:
    with open(handle, "wb", buffering=0) as file:
        left = memoryview(content)
        while left:
            left = left[file.write(left) or 0 :]


def _refused(path: Path, error: OSError) -> OutputError:
    return OutputError(f"{path}: {error.strerror or error}")
