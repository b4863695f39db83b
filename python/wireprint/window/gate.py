"""Who may talk to the window: only its own page, and only on this machine.

The server can read one model and says what it sees, so pages of others and other users of the
machine are kept out: by a token that the address carries once and a cookie carries from then on, by
the name that the server was called (against rebinding), and by the page that a request comes from.
"""

from __future__ import annotations

import hmac
from typing import TYPE_CHECKING, Final
from urllib.parse import parse_qs

from starlette.datastructures import Headers, MutableHeaders
from starlette.responses import PlainTextResponse, RedirectResponse, Response

from wireprint.window.address import secret
from wireprint.window.messages import MOST_BYTES

if TYPE_CHECKING:
    from starlette.types import ASGIApp, Message, Receive, Scope, Send

#: Names that this machine has for itself.
_NAMES: Final = ("127.0.0.1", "localhost")
#: Said with every answer: nothing but this server is asked for anything, nobody frames the page,
#: nothing is kept.
_HEADERS: Final = {
    "Content-Security-Policy": (
        "default-src 'self'; img-src 'self' blob: data:; base-uri 'none'; form-action 'none'; "
        "frame-ancestors 'none'; object-src 'none'"
    ),
    "X-Frame-Options": "DENY",
    "X-Content-Type-Options": "nosniff",
    "Referrer-Policy": "no-referrer",
    "Cross-Origin-Opener-Policy": "same-origin",
    "Cross-Origin-Resource-Policy": "same-origin",
    "Cache-Control": "no-store",
}


class Gate:
    """Lets through what comes from the window's own page.

    Parameters
    ----------
    port
        The server's port.
    token
        What opens the window.
    """

    def __init__(self, port: int, token: str) -> None:
        self._token, self._pass = token, secret()
        self._cookie = f"wireprint-{port}"
        self._hosts = frozenset(f"{name}:{port}" for name in _NAMES)
        self._origins = frozenset(f"http://{host}" for host in self._hosts)

    def around(self, app: ASGIApp) -> ASGIApp:
        """Return an application that is asked only what this one lets through."""

        async def guarded(scope: Scope, receive: Receive, send: Send) -> None:
            if scope["type"] not in ("http", "websocket"):
                await app(scope, receive, send)
                return
            send = _with_headers(send)
            refused = self._refused(scope)
            if refused is None:
                await app(scope, receive, send)
            elif scope["type"] == "http":
                await refused(scope, receive, send)
            else:
                await receive()
                await send({"type": "websocket.close", "code": 1008})

        return guarded

    def _refused(self, scope: Scope) -> Response | None:
        """Return the answer to what is not let through."""
        headers = Headers(scope=scope)
        hosts = headers.getlist("host")
        if len(hosts) != 1 or hosts[0].lower() not in self._hosts:
            return PlainTextResponse("this server has another name", 421)
        origins = headers.getlist("origin")
        if any(origin.lower() not in self._origins for origin in origins):
            return PlainTextResponse("not from this page", 403)
        given = self._token_in(scope)
        if given is not None and _equal(given, self._token):
            return self._admitted()
        if not self._has_pass(headers):
            return PlainTextResponse("open the address that wireprint printed", 403)
        if scope["type"] == "http":
            return _unfit(scope["method"], headers)
        return None

    def _token_in(self, scope: Scope) -> str | None:
        """Return the token of a request for the page."""
        if scope["type"] != "http" or scope["path"] != "/" or scope["method"] != "GET":
            return None
        found = parse_qs(scope["query_string"].decode("latin-1")).get("token", [])
        return found[0] if len(found) == 1 else None

    def _admitted(self) -> Response:
        """Send the browser to the bare address, with a cookie in place of the token."""
        response = RedirectResponse("/", 303)
        response.set_cookie(self._cookie, self._pass, httponly=True, samesite="strict", path="/")
        return response

    def _has_pass(self, headers: Headers) -> bool:
        cookies = "; ".join(headers.getlist("cookie")).split(";")
        pairs = (cookie.strip().partition("=") for cookie in cookies)
        return any(name == self._cookie and _equal(value, self._pass) for name, _, value in pairs)


def _equal(given: str, wanted: str) -> bool:
    """Compare secrets in a time that tells nothing."""
    return hmac.compare_digest(given.encode(), wanted.encode())


def _unfit(method: str, headers: Headers) -> Response | None:
    """Refuse what asks in another way than the page does: forms, and bodies without end."""
    if method != "POST":
        return None
    if headers.get("content-type", "").partition(";")[0].strip().lower() != "application/json":
        return PlainTextResponse("messages are application/json", 400)
    length = headers.get("content-length", "")
    if not length.isdecimal() or int(length) > MOST_BYTES:
        return PlainTextResponse(f"messages say their length, {MOST_BYTES} bytes at most", 400)
    return None


def _with_headers(send: Send) -> Send:
    async def sent(message: Message) -> None:
        if message["type"] == "http.response.start":
            headers = MutableHeaders(scope=message)
            for name, value in _HEADERS.items():
                headers[name] = value
        await send(message)

    return sent
