"""The standard streams: what comes in by a pipe becomes a file, and all three are there."""

from __future__ import annotations

import io
import os
import stat
import sys
import tempfile
from pathlib import Path
from typing import TYPE_CHECKING, Final

from wireprint._core import WireprintError

if TYPE_CHECKING:
    from typing import BinaryIO

#: What stands for stdin and stdout on the command line.
STREAM: Final = "-"
#: The name under which stdin is read, as a file as often as needed.
STDIN: Final = Path("/dev/stdin")
#: More does not come through a pipe; a file may be as large as memory allows.
MOST_BYTES: Final = 1 << 30
_CHUNK: Final = 1 << 20


class InputError(WireprintError):
    """What shall be read is not there, or is no file."""

    exit_code = 3


def open_all() -> None:
    """Open the standard streams that whoever called us has closed.

    Otherwise the first file that is opened would take the place of stdout or stderr, and get what
    is said there.
    """
    for number in range(3):
        try:
            os.fstat(number)
        except OSError:
            # The lowest free number is taken, which is this one.
            os.open(os.devnull, os.O_RDWR)
    for stream in (sys.stdout, sys.stderr):
        # A name that the terminal's encoding does not have must not end the command.
        if isinstance(stream, io.TextIOWrapper):
            stream.reconfigure(errors="backslashreplace")
    for number, (name, mode) in enumerate((("stdin", "r"), ("stdout", "w"), ("stderr", "w"))):
        if getattr(sys, name) is None:
            setattr(sys, name, os.fdopen(number, mode, closefd=False))


def is_stream(path: Path) -> bool:
    """Whether a path is that of what came through a pipe."""
    return path == STDIN or path.parent == Path("/dev/fd")


def regular(path: Path) -> Path:
    """Return a file that can be read as often as needed, for one that may be a pipe.

    Parameters
    ----------
    path
        A file of any kind, such as `STDIN`.

    Returns
    -------
    Path
        The path itself, or where a pipe's content can be read.

    Raises
    ------
    InputError
        There is no such file, it is a folder, or a pipe does not end.
    """
    try:
        mode = os.stat(path).st_mode
        if stat.S_ISDIR(mode):
            raise InputError(f"{path}: this is a folder")
        if stat.S_ISREG(mode):
            return path
        with open(path, "rb", buffering=0) as pipe:
            kept = _kept(pipe, path)
    except OSError as error:
        raise InputError(f"{path}: {(error.strerror or str(error)).lower()}") from None
    if path == STDIN:
        os.dup2(kept, 0)
        os.close(kept)
        return path
    return Path(f"/dev/fd/{kept}")


def _kept(pipe: BinaryIO, path: Path) -> int:
    """Copy what comes through a pipe into a file without a name; its descriptor."""
    size = 0
    with tempfile.TemporaryFile(buffering=0) as kept:
        while chunk := pipe.read(_CHUNK):
            size += len(chunk)
            if size > MOST_BYTES:
                limit = f"{MOST_BYTES >> 20} MB"
                raise InputError(f"{path}: it does not end after {limit}; save it as a file first")
            kept.write(chunk)
        return os.dup(kept.fileno())
