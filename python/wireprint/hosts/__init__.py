"""Printers' hosts in the user's configuration, and files that are sent to them.

A key is read where it is used, is in no message, and never leaves for another host than its own.
"""

from __future__ import annotations

import os
import stat
from dataclasses import dataclass, field
from pathlib import Path
from typing import TYPE_CHECKING, Any, Final
from urllib.parse import urlsplit

from wireprint import catalogue, toml
from wireprint._core import SettingError
from wireprint.text import one_line

if TYPE_CHECKING:
    from wireprint.toml import Key

KINDS: Final = ("octoprint", "moonraker", "prusalink", "duet")
#: Those that refuse whoever brings no key.
_NEED_A_KEY: Final = ("octoprint", "prusalink")
_KEYS: Final = ("kind", "url", "key", "storage")


@dataclass(frozen=True)
class Host:
    """One host of the user's."""

    name: str
    kind: str
    #: Without a slash at its end.
    url: str
    key: str = field(default="", repr=False)
    #: Where PrusaLink keeps files: ``usb`` on the printer, ``local`` on a Raspberry Pi.
    storage: str = "usb"


def path() -> Path:
    """Return where the user's hosts are kept."""
    base = os.environ.get("XDG_CONFIG_HOME") or os.path.expanduser("~/.config")
    return Path(base) / "wireprint" / "hosts.toml"


def names() -> list[str]:
    """Names of the user's hosts, sorted.

    Raises
    ------
    SettingError
        As `find`.
    """
    return sorted(_kept()[0]) if path().exists() else []


def find(name: str) -> Host:
    """Return a host.

    Raises
    ------
    SettingError
        There is none of that name, its entry is wrong, or others than the user may read the file.
    """
    file = path()
    if not file.exists():
        msg = (
            f"{file}: no such file; write one with a table for each host ([{one_line(name)}], "
            "kind, url, key) and keep it to yourself (chmod 600)"
        )
        raise SettingError(msg)
    tables, lines = _kept()
    if name not in tables:
        known = list(map(one_line, tables))
        told = catalogue.hint(one_line(name), known) if known else "there are none"
        raise SettingError(f"{file}: no host is called {one_line(name)!r}; {told}")
    return _host(file, name, tables[name], lines)


def _kept() -> tuple[dict[str, Any], dict[Key, int]]:
    file = path()
    _refuse_others(file)
    text, tables = toml.read(file)
    return tables, dict(toml.lines_of_keys(text))


def _refuse_others(file: Path) -> None:
    """Refuse a file with keys that others may read."""
    if os.name != "posix":
        return
    try:
        mode = stat.S_IMODE(file.stat().st_mode)
    except OSError as error:
        raise SettingError(f"{file}: {error.strerror or error}") from None
    if mode & 0o077:
        msg = f"{file}: it holds keys, and others than you may read it ({mode:o}); chmod 600 {file}"
        raise SettingError(msg)


def _host(file: Path, name: str, table: Any, lines: dict[Key, int]) -> Host:
    def place(key: str) -> str:
        line = lines.get((name, key)) or lines.get((name,)) or 1
        return f"{file}:{line}: {one_line(name)}.{key}"

    if not isinstance(table, dict):
        raise SettingError(f"{file}: {one_line(name)} is no table with kind, url and key")
    for key, value in table.items():
        if key not in _KEYS:
            raise SettingError(f"{place(one_line(key))}: unknown; there are {', '.join(_KEYS)}")
        if not isinstance(value, str) or not value.isascii() or not value.isprintable():
            raise SettingError(f"{place(key)}: it must be one line of plain characters")
    kind = table.get("kind", "")
    if kind not in KINDS:
        raise SettingError(f"{place('kind')}: {kind!r} is none of {', '.join(KINDS)}")
    url = str(table.get("url", "")).rstrip("/")
    try:
        parts = urlsplit(url)
        sound = parts.scheme in ("http", "https") and bool(parts.hostname) and parts.port != 0
    except ValueError:
        sound = False
    if not sound or parts.username is not None or parts.query or parts.fragment or " " in url:
        raise SettingError(f"{place('url')}: it must be like http://printer.local, and no more")
    if kind in _NEED_A_KEY and not table.get("key"):
        raise SettingError(f"{place('key')}: {kind} wants one; it is on the host's settings page")
    storage = table.get("storage", "usb")
    if storage not in ("usb", "local", "sdcard"):
        raise SettingError(f"{place('storage')}: it must be usb, local or sdcard")
    return Host(name, kind, url, table.get("key", ""), storage)
