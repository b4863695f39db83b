"""Where a window is: a port of this machine alone, and the token that opens it."""

from __future__ import annotations

import secrets
import socket
from dataclasses import dataclass, field
from typing import Final

#: Bytes of a secret; nobody guesses it.
_SECRET_BYTES: Final = 24
_HOST: Final = "127.0.0.1"


def secret() -> str:
    """Return a new secret that an address or a cookie can hold."""
    return secrets.token_urlsafe(_SECRET_BYTES)


@dataclass(frozen=True)
class Address:
    """A port that is listened on, and its token."""

    listening: socket.socket
    token: str = field(default_factory=secret)

    @classmethod
    def bound(cls, port: int) -> Address:
        """Listen on this machine alone; port 0: a free one.

        Raises
        ------
        OSError
            The port is taken.
        """
        listening = socket.socket(socket.AF_INET, socket.SOCK_STREAM)
        listening.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
        try:
            listening.bind((_HOST, port))
            listening.listen()
        except OSError:
            listening.close()
            raise
        return cls(listening)

    @property
    def port(self) -> int:
        """The port."""
        port: int = self.listening.getsockname()[1]
        return port

    @property
    def url(self) -> str:
        """What opens the window."""
        return f"http://{_HOST}:{self.port}/?token={self.token}"
