"""Tells when a file was saved anew: once its size and time rest, for programs write in pieces."""

from __future__ import annotations

import threading
from typing import TYPE_CHECKING, Final, TypeAlias

if TYPE_CHECKING:
    from collections.abc import Callable
    from pathlib import Path

#: How often is looked, s, and so how long a file must rest.
_EVERY_S: Final = 0.1
#: What changes when a file does: inode, size, time in ns. None: it is not there.
_Look: TypeAlias = tuple[int, int, int] | None


class Watch:
    """A thread that looks after a file.

    Parameters
    ----------
    path
        The file.
    changed
        Called in the thread with whether the file is there, each time that it was saved or went.
    """

    def __init__(self, path: Path, changed: Callable[[bool], None]) -> None:
        self._path, self._changed = path, changed
        self._told = self._look()
        self._stop = threading.Event()
        self._thread = threading.Thread(target=self._run, name="watch", daemon=True)

    def start(self) -> None:
        """Begin to look."""
        self._thread.start()

    def stop(self) -> None:
        """End the thread."""
        self._stop.set()
        if self._thread.is_alive():
            self._thread.join()

    def _run(self) -> None:
        last = self._told
        while not self._stop.wait(_EVERY_S):
            now = self._look()
            if now == last and now != self._told:
                self._told = now
                self._changed(now is not None)
            last = now

    def _look(self) -> _Look:
        try:
            about = self._path.stat()
        except OSError:
            return None
        return about.st_ino, about.st_size, about.st_mtime_ns
