"""G-code as it comes: from a file, from memory, out of a sliced plate, or as binary G-code."""

from __future__ import annotations

import os
import re
import zipfile
import zlib
from pathlib import Path
from typing import Final

from wireprint._core import GcodeError, bgcode_text

#: The way out where a file holds none.
NO_GCODE: Final = "if it is a model, slice it first (wireprint slice)"
#: What G-code in memory is called.
TEXT: Final = "the text"
#: Files that are no text, and can be read all the same.
ZIP: Final = "zip"
BINARY: Final = "binary G-code"
#: What a zip archive begins with, a binary G-code file, and files packed by gzip.
_ZIP: Final = b"PK\x03\x04"
_BINARY: Final = b"GCDE"
_GZIP: Final = b"\x1f\x8b"
#: A plate's G-code in a project that Bambu Studio or OrcaSlicer sliced, and that in Cura's UFP.
_PLATE: Final = re.compile(r"Metadata/plate_(\d+)\.gcode|/?3D/model\.gcode")
#: More is no G-code that a printer could hold.
_MOST_BYTES: Final = 1 << 30
#: G-code shrinks to a quarter; what shrinks so much more was made to fill memory.
_MOST_RATIO: Final = 200
#: Bytes that are looked at to tell whether a file is text.
_HEAD: Final = 1 << 12


def read(source: str | os.PathLike[str] | bytes) -> tuple[bytes, str]:
    """Return G-code and the name to call it by in errors.

    Parameters
    ----------
    source
        Path of a file, or the text itself. A plate that Bambu Studio, OrcaSlicer or Cura sliced
        (``.gcode.3mf``, ``.ufp``) is unpacked, if it holds one; so is binary G-code (``.bgcode``).

    Raises
    ------
    GcodeError
        The file holds something else, or several plates.
    OSError
        The file cannot be read.
    """
    if isinstance(source, bytes):
        return source, TEXT
    name = os.fspath(source)
    kind = kind_of(source)
    if kind is None:
        return Path(source).read_bytes(), name
    if kind == BINARY:
        try:
            return bgcode_text(Path(source).read_bytes()), name
        except GcodeError as error:
            raise GcodeError(f"{name}: {error}") from None
    if kind != ZIP:
        raise GcodeError(f"{name}: {kind}")
    return _unpacked(name), name


def kind_of(source: str | os.PathLike[str]) -> str | None:
    """Return what a file holds that is no text: `ZIP`, `BINARY`, or a sentence; None for text."""
    with open(source, "rb") as file:
        head = file.read(_HEAD)
    if head.startswith(_ZIP):
        return ZIP
    if head.startswith(_BINARY):
        return BINARY
    if head.startswith(_GZIP):
        return "it is packed by gzip; unpack it first (gunzip)"
    if b"\0" in head:
        return f"nothing in it is G-code: it holds zeros, as no text does; {NO_GCODE}"
    return None


def _unpacked(name: str) -> bytes:
    """Return the one plate in an archive."""
    try:
        with zipfile.ZipFile(name) as archive:
            plates = [info for info in archive.infolist() if _PLATE.fullmatch(info.filename)]
            if not plates:
                msg = f"{name}: a zip archive, and nothing in it is G-code; {NO_GCODE}"
                raise GcodeError(msg)
            if len(plates) > 1:
                names = ", ".join(info.filename for info in plates)
                msg = f"{name}: several plates ({names}); unzip the one that is meant"
                raise GcodeError(msg)
            plate = plates[0]
            most = min(_MOST_BYTES, _MOST_RATIO * max(plate.compress_size, _HEAD))
            with archive.open(plate) as part:
                text = part.read(most + 1)
    except (zipfile.BadZipFile, zlib.error, OSError, RuntimeError, NotImplementedError) as error:
        raise GcodeError(f"{name}: a damaged zip archive: {error}; write it again") from None
    if len(text) > most:
        raise GcodeError(f"{name}: {plate.filename} is larger than any G-code; unzip it first")
    return text
