"""Prints of a window that are sent to the user's hosts: one at a time, and none started unasked.

What a page is told of a host is its name. Neither its address nor its key is in anything that is
told, nor in what a failure says.
"""

from __future__ import annotations

import hashlib
import sys
import threading
import traceback
from typing import TYPE_CHECKING, Any, Final

from wireprint._core import SettingError, UnprintableError, WireprintError
from wireprint.window.answer import encoded

if TYPE_CHECKING:
    from collections.abc import Callable

    from wireprint.hosts import Host
    from wireprint.window.messages import Send
    from wireprint.window.outputs import Printed

#: Shares between which nothing is told.
_STEP: Final = 0.01


class Dispatch:
    """Sends prints to hosts, on a thread of its own: the window goes on meanwhile.

    Parameters
    ----------
    tell
        Takes events, from any thread: name and bytes.
    """

    def __init__(self, tell: Callable[[str, bytes], None]) -> None:
        self._tell = tell
        #: Where to a file is on its way; empty: nowhere.
        self._under_way = ""
        self._guard = threading.Lock()

    def offered(self) -> dict[str, Any]:
        """Return the names of the user's hosts, or what is wrong with their file."""
        from wireprint import hosts

        try:
            return {"hosts": hosts.names(), "hosts_fault": "", "hosts_file": str(hosts.path())}
        except SettingError as error:
            return {"hosts": [], "hosts_fault": str(error), "hosts_file": str(hosts.path())}

    def send(self, message: Send, printed: Printed | None, name: str) -> dict[str, Any]:
        """Begin to send a print, or ask whether it shall really be started.

        Parameters
        ----------
        message
            What a page asks.
        printed
            What is shown.
        name
            What the file is called here.

        Returns
        -------
        dict
            The file's name at the host; ``asks``, if the start must be agreed to first, is what a
            message then brings back. It stands for the very print, so that none is started but
            the one that was agreed to.

        Raises
        ------
        SettingError
            There is no such host, or a file is on its way already.
        UnprintableError
            There is no print, or it breaks the rules or leaves much bare.
        """
        from wireprint import hosts
        from wireprint.hosts.sending import plain_name

        host = hosts.find(message.host)
        if printed is None:
            raise UnprintableError("there is no print to send")
        if printed.refused:
            msg = f"{printed.refused}; export it, if you want to print it all the same"
            raise UnprintableError(msg)
        name = plain_name(name)
        sure = hashlib.sha256(printed.gcode).hexdigest()
        if message.start and message.sure != sure:
            return {"asks": sure, "file": name}
        with self._guard:
            if self._under_way:
                msg = f"a file is on its way to {self._under_way}; wait until it is there"
                raise SettingError(msg)
            self._under_way = host.name
        self._say(host, name, message.start, share=0.0)
        work = (host, name, printed.gcode, message.start)
        threading.Thread(target=self._work, args=work, name="send", daemon=True).start()
        return {"asks": None, "file": name}

    def _work(self, host: Host, name: str, content: bytes, start: bool) -> None:
        from wireprint.hosts.sending import send

        told = 0.0

        def on_sent(share: float) -> None:
            nonlocal told
            if share >= told + _STEP:
                told = share
                self._say(host, name, start, share=share)

        error = ""
        try:
            send(host, name, content, start=start, on_sent=on_sent)
        except WireprintError as fault:
            error = _plain(str(fault), host)
        except Exception as fault:
            # The window outlives a fault, and says so.
            traceback.print_exc(file=sys.stderr)
            error = f"unexpected {type(fault).__name__}: a fault of wireprint"
        with self._guard:
            self._under_way = ""
        self._say(host, name, start, share=None, error=error)

    def _say(self, host: Host, name: str, start: bool, **what: Any) -> None:
        """Tell how far a file is: ``share`` of it went out, None: it is over."""
        told = {"event": "sending", "host": host.name, "file": name, "start": start, "error": ""}
        self._tell("sending", encoded(told | what))


def _plain(words: str, host: Host) -> str:
    """Return words without a host's address."""
    return words.replace(f" ({host.url})", "").replace(host.url, host.name)
