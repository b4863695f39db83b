"""Files to hosts, as each kind takes them.

docs.octoprint.org/en/master/api/files.html; moonraker.readthedocs.io, "File Management";
Prusa-Link-Web, spec/openapi.yaml; Duet3D/RepRapFirmware wiki, "HTTP requests".
"""

from __future__ import annotations

import re
import zlib
from contextlib import suppress
from dataclasses import dataclass
from datetime import datetime
from typing import TYPE_CHECKING, Any, Final
from urllib.parse import quote, urlencode

from wireprint.hosts.web import SendError, ask, form

if TYPE_CHECKING:
    from collections.abc import Callable

    from wireprint.hosts import Host

#: What a name keeps; all else would mean something to one of the hosts.
_PLAIN: Final = re.compile(r"[^A-Za-z0-9._+-]+")
_LONGEST_NAME: Final = 80


@dataclass(frozen=True)
class Sent:
    """What became of a file."""

    host: str
    #: Its name there.
    file: str
    started: bool


@dataclass(frozen=True)
class _File:
    """What is sent, and what for."""

    name: str
    content: bytes
    start: bool
    on_sent: Callable[[float], None] | None


def plain_name(name: str) -> str:
    """Return a name that all hosts take: plain letters, and ``.gcode`` at its end."""
    stem = _PLAIN.sub("_", re.sub(r"\.(gcode|gco|g|nc|ngc)$", "", name, flags=re.IGNORECASE))
    return f"{stem.strip('._') or 'print'}"[:_LONGEST_NAME] + ".gcode"


def send(
    host: Host,
    name: str,
    content: bytes,
    *,
    start: bool = False,
    on_sent: Callable[[float], None] | None = None,
) -> Sent:
    """Send G-code to a host.

    Parameters
    ----------
    host
        Where to.
    name
        What the file is called here.
    content
        Its text.
    start
        Whether the host shall print it at once.
    on_sent
        Called with the share of the file that went out, from 0 to 1, while it does.

    Raises
    ------
    SendError
        The host was not reached, or did not take it.
    """
    name = plain_name(name)
    _KINDS[host.kind](host, _File(name, content, start, on_sent))
    return Sent(host.name, name, start)


def _key(host: Host) -> dict[str, str]:
    return {"X-Api-Key": host.key} if host.key else {}


def _octoprint(host: Host, file: _File) -> None:
    word = "true" if file.start else "false"
    body, bounds = form({"select": word, "print": word}, file.name, file.content)
    headers = bounds | _key(host)
    path = "/api/files/local"
    try:
        said = ask(host, "POST", path, body=body, headers=headers, on_sent=file.on_sent)
    except SendError as error:
        # So it calls a key that it does not know: it takes the sender for a page in a browser.
        if "CSRF" not in str(error):
            raise
        raise SendError(f"{host.name} ({host.url}): refused: it does not know the key") from None
    if file.start and isinstance(said, dict) and said.get("effectivePrint") is False:
        msg = f"{host.name}: the file is there, but was not started: is the printer connected?"
        raise SendError(msg)


def _moonraker(host: Host, file: _File) -> None:
    fields = {"root": "gcodes", "print": "true" if file.start else "false"}
    body, bounds = form(fields, file.name, file.content)
    headers = bounds | _key(host)
    path = "/server/files/upload"
    said = ask(host, "POST", path, body=body, headers=headers, on_sent=file.on_sent)
    if file.start and isinstance(said, dict) and said.get("print_started") is False:
        msg = f"{host.name}: the file is there, but was not started: is Klipper ready, and idle?"
        raise SendError(msg)


def _prusalink(host: Host, file: _File) -> None:
    headers = _key(host) | {
        "Content-Type": "text/x.gcode",
        "Print-After-Upload": "?1" if file.start else "?0",
        "Overwrite": "?1",
    }
    path = f"/api/v1/files/{host.storage}/{quote(file.name)}"
    ask(host, "PUT", path, body=file.content, headers=headers, on_sent=file.on_sent)


def _duet(host: Host, file: _File) -> None:
    now = datetime.now().isoformat(timespec="seconds")
    asked = urlencode({"password": host.key or "reprap", "time": now})
    session = ask(host, "GET", f"/rr_connect?{asked}")
    _demand(session, host, {1: "the password is wrong", 2: "too many others are connected"})
    number = session.get("sessionKey") if isinstance(session, dict) else None
    headers = {} if number is None else {"X-Session-Key": str(number)}
    try:
        path = f"0:/gcodes/{file.name}"
        asked = urlencode({"name": path, "time": now, "crc32": f"{zlib.crc32(file.content):08x}"})
        kind = headers | {"Content-Type": "application/octet-stream"}
        upload = f"/rr_upload?{asked}"
        said = ask(host, "POST", upload, body=file.content, headers=kind, on_sent=file.on_sent)
        _demand(said, host, {1: "the file was not taken whole; is there room on its card?"})
        if file.start:
            command = urlencode({"gcode": f'M32 "{path}"'})
            ask(host, "GET", f"/rr_gcode?{command}", headers=headers)
    finally:
        # Without it the session ends by itself a little later.
        with suppress(SendError):
            ask(host, "GET", "/rr_disconnect", headers=headers)


def _demand(said: Any, host: Host, meanings: dict[int, str]) -> None:
    """Refuse an answer with an error in it."""
    code = said.get("err") if isinstance(said, dict) else None
    if code != 0:
        meaning = meanings.get(code, "it answers as no Duet does") if code else "it is no Duet"
        raise SendError(f"{host.name} ({host.url}): refused: {meaning}")


_KINDS: Final[dict[str, Callable[[Host, _File], None]]] = {
    "octoprint": _octoprint,
    "moonraker": _moonraker,
    "prusalink": _prusalink,
    "duet": _duet,
}
