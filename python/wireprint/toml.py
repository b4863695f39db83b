"""TOML files of the user's, with errors that name file and line."""

from __future__ import annotations

import tomllib
from typing import TYPE_CHECKING, Any, Final

from wireprint._core import SettingError

if TYPE_CHECKING:
    from pathlib import Path

#: Settings take a hundredth of it.
MOST_BYTES: Final = 1 << 20


def read(path: Path) -> tuple[str, dict[str, Any]]:
    """Read a file; return its text and what it says.

    Raises
    ------
    SettingError
        It cannot be read, or is no TOML.
    """
    try:
        with path.open("rb") as file:
            content = file.read(MOST_BYTES + 1)
    except OSError as error:
        raise SettingError(f"{path}: {error.strerror or error}") from None
    if len(content) > MOST_BYTES:
        raise SettingError(f"{path}: more than {MOST_BYTES >> 20} MB; settings are shorter")
    try:
        # Windows' editors begin UTF-8 with a mark.
        text = content.decode("utf-8-sig")
    except UnicodeDecodeError as error:
        line = content.count(b"\n", 0, error.start) + 1
        msg = f"{path}:{line}: not UTF-8; save the file in this encoding"
        raise SettingError(msg) from None
    try:
        return text, tomllib.loads(text)
    except tomllib.TOMLDecodeError as error:
        msg = f"{path}: not TOML: {error}"
    except RecursionError:
        msg = f"{path}: not settings: it is nested too deep"
    except ValueError:
        msg = f"{path}: not settings: a number has too many digits"
    raise SettingError(msg)
