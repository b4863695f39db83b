"""The window's server on 127.0.0.1: the page's files, and messages by WebSocket or POST."""

from __future__ import annotations

import asyncio
from contextlib import asynccontextmanager
from importlib import resources
from typing import TYPE_CHECKING, Final

import uvicorn
from starlette.applications import Starlette
from starlette.concurrency import run_in_threadpool
from starlette.responses import PlainTextResponse, Response
from starlette.routing import Route, WebSocketRoute
from starlette.websockets import WebSocketDisconnect

from wireprint.window.gate import Gate
from wireprint.window.messages import MOST_BYTES
from wireprint.window.session import Session

if TYPE_CHECKING:
    from collections.abc import AsyncIterator

    from starlette.requests import Request
    from starlette.types import ASGIApp
    from starlette.websockets import WebSocket

    from wireprint.window.address import Address
    from wireprint.window.source import Source

#: Path → file in ``static`` and its type. Nothing else is given.
_FILES: Final = {
    "/": ("index.html", "text/html; charset=utf-8"),
    "/studio.js": ("studio.js", "text/javascript; charset=utf-8"),
    "/licences.txt": ("licences.txt", "text/plain; charset=utf-8"),
}
#: Most windows on one model.
_MOST_WINDOWS: Final = 16


class _Window:
    """What one page is still to be told: answers in order, and of each event the newest."""

    def __init__(self, first: list[bytes]) -> None:
        self._waiting: dict[str, bytes] = {f"first {i}": one for i, one in enumerate(first)}
        self._answers = 0
        self._filled = asyncio.Event()
        self._filled.set()

    def event(self, name: str, content: bytes) -> None:
        """Tell an event in place of an older one of its name that was not yet sent."""
        self._waiting.pop(name, None)
        self._waiting[name] = content
        self._filled.set()

    def answer(self, content: bytes) -> None:
        """Tell an answer."""
        self._answers += 1
        self._waiting[f"answer {self._answers}"] = content
        self._filled.set()

    async def next(self) -> bytes:
        """Return the next that is to be sent."""
        while not self._waiting:
            self._filled.clear()
            await self._filled.wait()
        return self._waiting.pop(next(iter(self._waiting)))


class Hall:
    """All windows on a model, and the session behind them."""

    def __init__(self, source: Source) -> None:
        self._loop: asyncio.AbstractEventLoop | None = None
        self._windows: set[_Window] = set()
        self.session = Session(source, self._tell)

    def app(self) -> Starlette:
        """Return the application, which no gate guards yet."""
        routes = [Route(path, _file) for path in _FILES]
        app = Starlette(
            routes=[
                *routes,
                Route("/message", self._message, methods=["POST"]),
                WebSocketRoute("/messages", self._messages),
            ],
            lifespan=self._lifespan,
        )
        app.router.redirect_slashes = False
        return app

    @asynccontextmanager
    async def _lifespan(self, _app: Starlette) -> AsyncIterator[None]:
        self._loop = asyncio.get_running_loop()
        self.session.start()
        yield
        self._loop = None
        await run_in_threadpool(self.session.stop)

    def _tell(self, name: str, content: bytes) -> None:
        """Pass an event of the session's threads on to all windows."""
        loop = self._loop
        if loop is not None and not loop.is_closed():
            loop.call_soon_threadsafe(self._spread, name, content)

    def _spread(self, name: str, content: bytes) -> None:
        for window in self._windows:
            window.event(name, content)

    async def _message(self, request: Request) -> Response:
        body = bytearray()
        async for chunk in request.stream():
            body += chunk
            if len(body) > MOST_BYTES:
                return PlainTextResponse(f"{MOST_BYTES} bytes at most", 400)
        answer = await run_in_threadpool(self.session.handle, bytes(body))
        return Response(answer, media_type="application/octet-stream")

    async def _messages(self, websocket: WebSocket) -> None:
        if len(self._windows) >= _MOST_WINDOWS:
            await websocket.close(1013)
            return
        await websocket.accept()
        window = _Window(self.session.welcome())
        self._windows.add(window)
        sending = asyncio.create_task(_send(websocket, window))
        try:
            while True:
                content = await websocket.receive_text()
                window.answer(await run_in_threadpool(self.session.handle, content.encode()))
        except (WebSocketDisconnect, KeyError):
            # A message that is no text has no "text", and ends the talk.
            pass
        finally:
            self._windows.discard(window)
            sending.cancel()


async def _send(websocket: WebSocket, window: _Window) -> None:
    try:
        while True:
            await websocket.send_bytes(await window.next())
    except (WebSocketDisconnect, RuntimeError):
        # The page went away between two messages.
        return


async def _file(request: Request) -> Response:
    name, kind = _FILES[request.url.path]
    content = resources.files("wireprint.window").joinpath("static", name).read_bytes()
    return Response(content, headers={"Content-Type": kind})


def guarded(source: Source, gate: Gate) -> ASGIApp:
    """Return the whole application."""
    return gate.around(Hall(source).app())


def serve(source: Source, address: Address) -> None:
    """Serve until interrupted. Nothing of a request, and so no token, goes into a log."""
    config = uvicorn.Config(
        guarded(source, Gate(address.port, address.token)),
        access_log=False,
        log_level="error",
        ws="websockets-sansio",
        ws_max_size=MOST_BYTES,
        server_header=False,
        date_header=False,
        timeout_graceful_shutdown=1,
        lifespan="on",
    )
    uvicorn.Server(config).run([address.listening])
