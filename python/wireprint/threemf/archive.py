"""A 3MF file as an archive of parts, opened with a guard against hostile ones.

Errors do not name the file; who opens it does.
"""

from __future__ import annotations

import io
import os
import re
import struct
import zipfile
import zlib
from typing import TYPE_CHECKING, Final, Self, TypeVar

from wireprint._core import ModelError

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator
    from pathlib import Path

T = TypeVar("T")

#: Most bytes that an archive may unpack to.
MOST_UNPACKED: Final = 1 << 28
#: Most bytes of its directory, which is held in memory: some ten thousand parts.
MOST_DIRECTORY: Final = 1 << 20
#: Most that a part may unpack to, as a multiple of its packed size, beyond a small one. The XML of
#: a mesh shrinks to a tenth; deflate can shrink zeros to a thousandth.
MOST_RATIO: Final = 50
#: Parts up to this many bytes may be packed as well as they like.
SMALL: Final = 1 << 22
#: Bytes that are unpacked at a time.
CHUNK: Final = 1 << 16

#: What the zip library raises; RuntimeError: a part is encrypted, or packed in a strange way.
_FAULTS: Final = (
    OSError,
    EOFError,
    RuntimeError,
    ValueError,
    struct.error,
    zipfile.BadZipFile,
    zlib.error,
)
#: A name that leads out of the archive: no part of a package has one.
_ESCAPES: Final = re.compile(r"^[A-Za-z]:|(^|/)\.\.(/|$)|[\x00-\x1f]")


class Archive:
    """The parts of a 3MF file, or of another in a zip archive, by name; a context manager.

    Parameters
    ----------
    path
        The file.
    kind
        What it should be, for errors.

    Raises
    ------
    ModelError
        No archive, damaged, or one that would unpack to too much or to elsewhere.
    """

    def __init__(self, path: Path, kind: str = "3MF") -> None:
        self._kind = kind
        try:
            self._file = _Guarded(path)
        except OSError as error:
            raise ModelError(f"cannot be read as {kind}: {error.strerror}") from error
        try:
            self._zip = self._guard(lambda: zipfile.ZipFile(self._file))
            self._parts = {name_of(info.filename): info for info in self._checked()}
        except ModelError:
            self._file.close()
            raise

    def __enter__(self) -> Self:
        """Return itself."""
        return self

    def __exit__(self, *_: object) -> None:
        """Close the file."""
        self._zip.close()
        self._file.close()

    def __contains__(self, name: str) -> bool:
        """Whether there is a part of this name."""
        return name_of(name) in self._parts

    def names(self) -> list[str]:
        """Return the names of all parts, in the form of `name_of`."""
        return list(self._parts)

    def read(self, name: str, reader: Callable[[Iterator[bytes]], T]) -> T:
        """Return what a reader makes of a part, which it is given a piece at a time.

        Raises
        ------
        ModelError
            There is no such part, or it is damaged, or the reader refuses it.
        """
        if _ESCAPES.search(name_of(name)):
            raise ModelError(f"refers to {name!r}, which leads out of the file")
        info = self._parts.get(name_of(name))
        if info is None:
            raise ModelError(f"has no part {name!r}")
        try:
            return reader(self._chunks(info))
        except ModelError as error:
            raise ModelError(f"{name.removeprefix('/')}: {error}") from error

    def _chunks(self, info: zipfile.ZipInfo) -> Iterator[bytes]:
        with self._guard(lambda: self._zip.open(info)) as part:
            while chunk := self._guard(lambda: part.read(CHUNK)):
                yield chunk

    def _checked(self) -> Iterator[zipfile.ZipInfo]:
        """Yield the entries if all of them are harmless."""
        seen, unpacked = set(), 0
        for info in self._zip.infolist():
            name = info.filename
            if _ESCAPES.search(name_of(name)):
                raise ModelError(f"has a part {name!r}, which leads out of the file")
            if name_of(name) in seen:
                raise ModelError(f"has two parts {name!r}")
            seen.add(name_of(name))
            if info.compress_type not in (zipfile.ZIP_STORED, zipfile.ZIP_DEFLATED):
                raise ModelError(f"part {name!r} is packed in a way that {self._kind} forbids")
            unpacked += info.file_size
            bomb = info.file_size > max(SMALL, MOST_RATIO * info.compress_size)
            if bomb or unpacked > MOST_UNPACKED:
                raise ModelError(
                    f"it unpacks to {unpacked} bytes or more "
                    f"(at most {MOST_UNPACKED}, and {MOST_RATIO} times its own size); "
                    "export it as binary STL"
                )
            yield info

    def _guard(self, call: Callable[[], T]) -> T:
        """Call the zip library; its many errors become one."""
        try:
            return call()
        except _FAULTS as error:
            raise ModelError(f"cannot be read as {self._kind}: {error}") from error


def name_of(name: str) -> str:
    """Return the form in which part names are compared: they differ in more than case.

    Some programs write a backslash, or begin with a slash.
    """
    return name.replace("\\", "/").lstrip("/").lower()


class _Guarded(io.FileIO):
    """A file that refuses to be read in pieces larger than a decent directory is."""

    def read(self, size: int | None = -1, /) -> bytes:
        """Read a piece, or the rest."""
        if size is None or size < 0:
            size = max(os.fstat(self.fileno()).st_size - self.tell(), 0)
        if size > MOST_DIRECTORY:
            raise zipfile.BadZipFile("its directory is too large")
        return super().read(size) or b""
