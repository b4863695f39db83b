"""Requests to a host: within a time, to no other address, and with its answers in words."""

from __future__ import annotations

import json
import secrets
import urllib.error
import urllib.request
from http.client import HTTPException
from io import BytesIO
from typing import TYPE_CHECKING, Any, Final

from wireprint._core import WireprintError
from wireprint.text import one_line

if TYPE_CHECKING:
    from collections.abc import Callable, Mapping
    from http.client import HTTPResponse

    from wireprint.hosts import Host

#: Of silence, s: a printer's board writes to its card while it takes a file.
TIMEOUT_S: Final = 30.0
_MOST_ANSWER: Final = 1 << 20
_MOST_SHOWN: Final = 160
#: What codes mean, where a host says no more.
_MEANINGS: Final = {
    401: "the key is wrong",
    403: "the key is wrong, or may not do this",
    404: "nothing is there; is it of this kind, and its url right?",
    409: "the host refuses: it prints, or is not connected to its printer, or the file is in use",
    413: "the file is too large for it",
    415: "the host takes no such file",
    507: "the host has no room left",
}


class SendError(WireprintError):
    """A host was not reached, or did not take a file."""

    exit_code = 6


class _Stay(urllib.request.HTTPRedirectHandler):
    """Goes nowhere else: a key is for one host."""

    def redirect_request(self, *_: Any, **__: Any) -> None:
        """Follow nothing; the answer counts as it is."""


# No proxy: a printer's host is nearby, and keys are not for others.
_OPENER: Final = urllib.request.build_opener(urllib.request.ProxyHandler({}), _Stay)


def ask(
    host: Host,
    method: str,
    path: str,
    *,
    body: bytes | None = None,
    headers: Mapping[str, str] | None = None,
    timeout_s: float = TIMEOUT_S,
    on_sent: Callable[[float], None] | None = None,
) -> Any:
    """Make a request; return what the answer's JSON says, None where it is none.

    Parameters
    ----------
    host
        Where to.
    method, path, body, headers
        Of the request; the path may hold secrets, which no message repeats.
    timeout_s
        Longest silence, s.
    on_sent
        Called with the share of the body that went out, from 0 to 1.

    Raises
    ------
    SendError
        The host was not reached, or refused.
    """
    where = f"{host.name} ({host.url})"
    data: bytes | _Told | None = body
    headers = dict(headers or {})
    if body is not None and on_sent is not None:
        data = _Told(body, on_sent)
        headers["Content-Length"] = str(len(body))
    request = urllib.request.Request(  # noqa: S310 - `hosts` lets pass http and https alone
        host.url + path, data=data, headers=headers, method=method
    )
    try:
        with _OPENER.open(request, timeout=timeout_s) as answer:
            return _said(answer)
    except urllib.error.HTTPError as error:
        meaning = _MEANINGS.get(error.code, "")
        if 300 <= error.code < 400:
            meaning = "it sends on to another address; name that one as its url"
        with error:
            said = _words(error)
        # A host that repeats what it was asked would tell the key to who reads its words.
        said = said.replace(host.key, "…") if host.key else said
        told = "; ".join(part for part in (meaning, said) if part)
        raise SendError(f"{where}: refused ({error.code}): {told or 'it says no more'}") from None
    except TimeoutError:
        raise SendError(f"{where}: no answer within {timeout_s:g} s") from None
    except urllib.error.URLError as error:
        reason = error.reason
        if isinstance(reason, TimeoutError):
            raise SendError(f"{where}: no answer within {timeout_s:g} s") from None
        why = getattr(reason, "strerror", None) or reason
        raise SendError(f"{where}: not reached: {one_line(str(why))}") from None
    except (OSError, HTTPException, ValueError) as error:
        why = getattr(error, "strerror", None) or type(error).__name__
        raise SendError(f"{where}: the connection broke: {one_line(str(why))}") from None


class _Told(BytesIO):
    """A body that tells how much of it was read."""

    def __init__(self, content: bytes, on_sent: Callable[[float], None]) -> None:
        super().__init__(content)
        self._size, self._on_sent = max(len(content), 1), on_sent

    def read(self, size: int | None = -1, /) -> bytes:
        """Return the next bytes, and tell what share went out before them."""
        self._on_sent(self.tell() / self._size)
        return super().read(size)


def _said(answer: HTTPResponse) -> Any:
    try:
        return json.loads(answer.read(_MOST_ANSWER))
    except (ValueError, RecursionError):
        return None


def _words(error: urllib.error.HTTPError) -> str:
    """Return what a refusal says of itself."""
    try:
        text = error.read(_MOST_ANSWER).decode("utf-8", "replace")
        found = json.loads(text)
    except (OSError, HTTPException):
        return ""
    except (ValueError, RecursionError):
        return "" if "<" in text else one_line(text.strip())[:_MOST_SHOWN]
    if isinstance(found, dict):
        found = found.get("error", found)
        if isinstance(found, dict):
            found = found.get("message") or found.get("title") or found.get("text") or ""
    return one_line(str(found))[:_MOST_SHOWN]


def form(fields: Mapping[str, str], name: str, content: bytes) -> tuple[bytes, dict[str, str]]:
    """Return a form with a file, and the header that tells its bounds.

    Parameters
    ----------
    fields
        Its other entries.
    name, content
        Of the file; a name holds no quotes, nor line ends.
    """
    bound = secrets.token_hex(16)
    while bound.encode() in content:
        bound = secrets.token_hex(16)
    parts = [
        f'--{bound}\r\nContent-Disposition: form-data; name="{key}"\r\n\r\n{value}\r\n'.encode()
        for key, value in fields.items()
    ]
    opening = (
        f'--{bound}\r\nContent-Disposition: form-data; name="file"; filename="{name}"\r\n'
        "Content-Type: application/octet-stream\r\n\r\n"
    )
    body = b"".join([*parts, opening.encode(), content, f"\r\n--{bound}--\r\n".encode()])
    return body, {"Content-Type": f"multipart/form-data; boundary={bound}"}
