"""Replacing a file in one step: whoever looks sees the older one or the new one, and no third.

A new file has no name until it is whole, where the system knows such files (Linux's O_TMPFILE):
whatever ends the program before leaves nothing. Only a file that replaces another must have a
name of its own for the moment before; what a killed program left under it, known by a lock that
nobody holds any more, is taken away by the next one that writes there.
"""

from __future__ import annotations

import contextlib
import os
import stat
import zlib
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from collections.abc import Iterator
    from pathlib import Path

try:
    import fcntl
except ImportError:  # Windows: what a killed program left behind stays.
    fcntl = None  # type: ignore[assignment]

#: Programs that write to one place at the same time.
_MOST_WRITERS = 100
#: The flag that opens a file without a name; None where it could get none later.
_UNNAMED = getattr(os, "O_TMPFILE", None) if os.path.isdir("/proc/self/fd") else None
_BINARY = os.O_WRONLY | getattr(os, "O_BINARY", 0) | getattr(os, "O_CLOEXEC", 0)


def replace(path: Path, content: bytes) -> None:
    """Put a file in place of an older one, or where none is, in one step.

    Parameters
    ----------
    path
        The file, a regular one if it is there already. An older one hands on its permissions and,
        as far as the system lets us, its owner and group.
    content
        The whole of it.

    Raises
    ------
    OSError
        It cannot be written; then nothing has changed.
    """
    refused = _crowded(path)
    for _ in range(_MOST_WRITERS):
        try:
            return _replace(path, content)
        except FileNotFoundError as error:
            # Another writer took the name before it was locked; without a folder there is none,
            # and a folder of the system's own takes no files.
            refused = error
            if not path.parent.is_dir():
                break
    raise refused


def _replace(path: Path, content: bytes) -> None:
    older = path.stat() if path.exists() else None
    handle, name = _opened(path)
    try:
        _write(handle, content)
        if older is not None:
            _take_after(handle, older)
        elif name is None and _named(handle, path):
            return
        if name is None:
            name = _lent_name(handle, path)
        os.replace(name, path)
    finally:
        if name is not None:
            _forget(handle, name)
        os.close(handle)


def _opened(path: Path) -> tuple[int, Path | None]:
    """Open a new file beside another; its name, unless it needs none yet."""
    if _UNNAMED is not None:
        # Where the file system knows no files without names, they are opened with one.
        with contextlib.suppress(OSError):
            return os.open(path.parent, _BINARY | _UNNAMED, 0o666), None
    for name in _names_beside(path):
        try:
            handle = os.open(name, _BINARY | os.O_CREAT | os.O_EXCL, 0o666)
        except FileExistsError:
            continue
        _lock(handle)
        return handle, name
    raise _crowded(path)


def _write(handle: int, content: bytes) -> None:
    left = memoryview(content)
    while left:
        left = left[os.write(handle, left) :]


def _take_after(handle: int, older: os.stat_result) -> None:
    """Give a file the owner, group and permissions of another, as far as we may."""
    if not hasattr(os, "fchown"):
        return
    for owner, group in ((older.st_uid, older.st_gid), (-1, older.st_gid)):
        with contextlib.suppress(PermissionError):
            os.fchown(handle, owner, group)
            break
    os.fchmod(handle, stat.S_IMODE(older.st_mode))


def _named(handle: int, path: Path) -> bool:
    """Give a file that has no name a free one; whether it was free and the system could."""
    folder = os.open(path.parent, os.O_RDONLY)
    try:
        # Only with a folder given does `link` follow the link in /proc to the file itself.
        os.link(
            f"/proc/self/fd/{handle}",
            path.name,
            src_dir_fd=folder,
            dst_dir_fd=folder,
            follow_symlinks=True,
        )
    except FileExistsError:
        return False
    finally:
        os.close(folder)
    return True


def _lent_name(handle: int, path: Path) -> Path:
    """Give a file that has no name one for the moment before it takes another's place."""
    _lock(handle)
    for name in _names_beside(path):
        if _named(handle, name):
            return name
    raise _crowded(path)


def _names_beside(path: Path) -> Iterator[Path]:
    """Yield names that may be free; those that dead programs left are free again."""
    mark = zlib.crc32(os.fsencode(path.name))
    for number in range(_MOST_WRITERS):
        name = path.with_name(f".wireprint-{mark:08x}-{number}.part")
        if name.exists() and _abandoned(name):
            with contextlib.suppress(OSError):
                name.unlink()
        yield name


def _abandoned(name: Path) -> bool:
    """Whether nobody holds the lock of a file."""
    if fcntl is None:
        return False
    try:
        handle = os.open(name, os.O_RDONLY)
    except OSError:
        return False
    try:
        fcntl.flock(handle, fcntl.LOCK_EX | fcntl.LOCK_NB)
    except OSError:
        return False
    finally:
        os.close(handle)
    return True


def _lock(handle: int) -> None:
    """Hold a file's lock until it is closed, be it by the end of the program."""
    if fcntl is not None:
        with contextlib.suppress(OSError):  # Some network file systems have no locks.
            fcntl.flock(handle, fcntl.LOCK_EX | fcntl.LOCK_NB)


def _forget(handle: int, name: Path) -> None:
    """Take a file's name away, if it still has it."""
    with contextlib.suppress(OSError):
        if os.path.samestat(os.fstat(handle), os.lstat(name)):
            name.unlink()


def _crowded(path: Path) -> OSError:
    return OSError(f"too many programs write to {path.name} at once")
