"""Files of other programs, read within limits; where each value stands."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Final

from wireprint._core import SettingError

if TYPE_CHECKING:
    from pathlib import Path

#: The largest bundle of PrusaSlicer's is 1 MB.
MOST_BYTES: Final = 16 << 20
#: A value is a sequence of G-code at most.
MOST_IN_VALUE: Final = 1 << 17


@dataclass(frozen=True)
class Given:
    """A value as it is written, and where."""

    text: str
    #: File, line and key, as a comment or an error names them: ``printer.cfg:12, max_velocity``.
    place: str


#: Values by the names that their program gives them.
Config = dict[str, Given]


def text_of(path: Path, most_bytes: int = MOST_BYTES) -> str:
    """Read a file of text.

    Raises
    ------
    SettingError
        It cannot be read, is too large for what it should be, or is no text.
    """
    try:
        with path.open("rb") as file:
            content = file.read(most_bytes + 1)
    except OSError as error:
        raise SettingError(f"{path}: {error.strerror or error}") from None
    if len(content) > most_bytes:
        raise SettingError(f"{path}: more than {most_bytes >> 20} MB; no configuration is so large")
    return decoded(content, str(path))


def decoded(content: bytes, name: str) -> str:
    """Return bytes as text; windows' programs may have written Latin letters."""
    if (at := content.find(b"\0")) >= 0:
        line = content.count(b"\n", 0, at) + 1
        raise SettingError(f"{name}:{line}: it holds zeros, as no text does")
    try:
        return content.decode("utf-8-sig")
    except UnicodeDecodeError:
        return content.decode("latin-1")


def unescaped(text: str) -> str:
    """Return a value of PrusaSlicer's with its line ends written out, without quotes around it."""
    if len(text) > 1 and text[0] == text[-1] == '"':
        text = text[1:-1]
    parts = []
    rest = iter(text)
    for letter in rest:
        if letter != "\\":
            parts.append(letter)
            continue
        escaped = next(rest, "\\")
        parts.append({"n": "\n", "r": "", "t": "\t"}.get(escaped, escaped))
    return "".join(parts)
