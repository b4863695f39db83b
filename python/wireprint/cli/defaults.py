"""The printer and material that are used unless others are named: the user's own, or ours."""

from __future__ import annotations

import json
import os
from pathlib import Path
from typing import Final

from wireprint import toml
from wireprint._core import SettingError

#: What wireprint uses by itself.
BUILT_IN: Final = {"printer": "kossel-mini", "material": "abs"}


def path() -> Path:
    """Return where the user's own defaults are kept."""
    base = os.environ.get("XDG_CONFIG_HOME") or os.path.expanduser("~/.config")
    return Path(base) / "wireprint" / "config.toml"


def default(key: str) -> tuple[str, str]:
    """Return the default printer or material, and where it comes from.

    Parameters
    ----------
    key
        ``printer`` or ``material``.

    Raises
    ------
    SettingError
        The user's file is damaged.
    """
    variable = f"WIREPRINT_{key.upper()}"
    if name := os.environ.get(variable):
        return name, variable
    if name := kept().get(key):
        return name, str(path())
    return BUILT_IN[key], "built in"


def kept() -> dict[str, str]:
    """Return what the user's file says."""
    file = path()
    if not file.exists():
        return {}
    values = toml.read(file)[1]
    for key, value in values.items():
        if key not in BUILT_IN or not isinstance(value, str):
            known = " and ".join(BUILT_IN)
            msg = f"{file}: {key} = {value!r}: it holds {known}, each the name of a profile"
            raise SettingError(msg)
    return values


def as_toml(values: dict[str, str]) -> bytes:
    """Return the user's file."""
    return "".join(f"{key} = {json.dumps(value)}\n" for key, value in values.items()).encode()
