"""A model with its history, and the thread that prints the newest of it."""

from __future__ import annotations

import sys
import threading
import time
import traceback
from collections import OrderedDict
from functools import partial
from typing import TYPE_CHECKING, Final, TypeVar

from wireprint._core import SettingError, WireprintError
from wireprint.window import heap, telling
from wireprint.window.answer import encoded
from wireprint.window.history import History
from wireprint.window.outputs import Printed
from wireprint.window.watch import Watch

if TYPE_CHECKING:
    from collections.abc import Callable

    from wireprint._core import Mesh
    from wireprint.hybrid.sketch import Sketch
    from wireprint.settings import Settings
    from wireprint.window.history import State
    from wireprint.window.source import Source

    Found = TypeVar("Found")

#: Prints that are kept for undo and redo, bytes in all.
_KEPT_BYTES: Final = 1 << 24
#: Longest that an export waits for its print, s.
_PATIENCE_S: Final = 600.0
#: A print that takes longer tells what it is at, s.
_SILENT_S: Final = 0.3
#: Events that a page that comes later is told, too, in this order.
_LASTING: Final = ("model", "state", "print", "current", "paint", "rest", "failed", "notice")


class _Superseded(Exception):  # noqa: N818 - nothing is wrong
    """What is computed is no longer wanted."""


class Workshop:
    """A model with its history, and the thread that prints it.

    Parameters
    ----------
    source
        The model and its settings.
    tell
        Takes events, from any thread: name and bytes.
    """

    def __init__(self, source: Source, tell: Callable[[str, bytes], None]) -> None:
        self._source, self._tell_all = source, tell
        self._history: History | None = None
        self._mesh: Mesh | None = None
        #: What its G-code is dated.
        self._date = source.dated()
        self._revision = 0
        self._done = -1
        #: The newest change whose print is shown.
        self._shown = -1
        self._stale = True
        self._stopped = False
        self._lasting: dict[str, bytes] = {}
        #: Mesh and settings of the last print, and what it kept for the next one.
        self._sketch: tuple[Mesh, Settings, Sketch] | None = None
        self._kept: OrderedDict[int, Printed] = OrderedDict()
        #: Guards all of the above; told whenever one of them changes.
        self._changed = threading.Condition(threading.RLock())
        self._thread = threading.Thread(target=self._work, name="print", daemon=True)
        self._watch = None if source.path is None else Watch(source.path, self._saved)

    def start(self) -> None:
        """Begin to read, print and watch the model."""
        self._thread.start()
        if self._watch is not None:
            self._watch.start()

    def stop(self) -> None:
        """End the threads; a print that is under way is given up at its next stage."""
        if self._watch is not None:
            self._watch.stop()
        with self._changed:
            self._stopped = True
            self._revision += 1
            self._changed.notify_all()
        if self._thread.is_alive():
            self._thread.join(timeout=2.0)

    def known(self) -> list[bytes]:
        """Return the events that a page which comes now has missed."""
        with self._changed:
            return [self._lasting[name] for name in _LASTING if name in self._lasting]

    def edit(self, change: Callable[[History], Found]) -> tuple[Found, int]:
        """Change the history, and ask for a new print.

        Returns
        -------
        tuple
            What the change gives, and the number of the newest change.

        Raises
        ------
        SettingError
            The model is not read yet, or the change is refused, which leaves everything as it is.
        """
        with self._changed:
            history = self._ready()
            before = history.state
            found = change(history)
            if history.state is not before:
                self._revision += 1
                self._tell_state(history)
                self._show_kept(history.state)
                self._changed.notify_all()
            return found, self._revision

    def now(self) -> tuple[Mesh, State, Settings]:
        """Return the model, what is marked, and the settings.

        Raises
        ------
        SettingError
            The model is not read yet.
        """
        with self._changed:
            history = self._ready()
            assert self._mesh is not None, "a history has a mesh"  # noqa: S101
            return self._mesh, history.state, history.settings

    def printed(self) -> Printed | None:
        """Return the print of what is marked now, once it is there; None: there is none."""
        return self.newest()[1]

    def newest(self) -> tuple[int, Printed | None]:
        """Return the number of the newest change, and its print, likewise."""
        with self._changed:
            state, wanted = self._ready().state, self._revision
            self._changed.wait_for(lambda: self._done >= wanted or self._stopped, _PATIENCE_S)
            return wanted, self._kept.get(id(state))

    def _show_kept(self, state: State) -> None:
        """Show a print that is kept, whatever the thread is at: undo need not wait for it."""
        printed = self._kept.get(id(state))
        if printed is not None:
            for event, content in printed.told.items():
                self._tell_print(self._revision, event, content)
            self._done = self._revision

    def _ready(self) -> History:
        if self._history is None:
            raise SettingError("the model is not read yet")
        return self._history

    def _tell(self, event: str, content: bytes) -> None:
        with self._changed:
            if event in _LASTING:
                self._lasting[event] = content
        self._tell_all(event, content)

    def _notice(self, words: str) -> None:
        """Say something about the model's file; nothing takes back what was said before."""
        self._tell("notice", telling.words("notice", words))

    def _tell_state(self, history: History) -> None:
        self._tell("state", telling.state(self._revision, history))

    def _saved(self, there: bool) -> None:
        """Read the model again, or say that it went."""
        if not there:
            self._notice(f"{self._source.name} is gone; what is shown is what it was")
            return
        with self._changed:
            self._stale = True
            self._revision += 1
            self._changed.notify_all()

    def _work(self) -> None:
        """Read and print whatever is the newest, until the session ends."""
        while True:
            with self._changed:
                self._changed.wait_for(
                    lambda: self._stale or self._done < self._revision or self._stopped
                )
                if self._stopped:
                    return
                stale, revision = self._stale, self._revision
                self._stale = False
            try:
                if stale:
                    self._read()
                self._print(revision)
            except _Superseded:
                continue
            except Exception as error:
                # The window outlives a fault, and says so.
                traceback.print_exc(file=sys.stderr)
                self._failed(revision, f"unexpected {type(error).__name__}: a fault of wireprint")
            self._finish(revision)

    def _read(self) -> None:
        # A file that is damaged, or gone, must not date the print of what it was.
        date = self._source.dated()
        try:
            model = self._source.load()
        except (WireprintError, OSError) as error:
            self._notice(f"{error}" if self._mesh is None else f"{error}; the old one is shown")
            return
        mesh = model.mesh
        told = telling.model(self._source.name, mesh)
        with self._changed:
            self._mesh, self._date = mesh, date
            self._kept.clear()
            if self._history is None:
                self._history = History(partial(self._source.compose, model.settings), model.region)
            self._notice("")
            self._tell("model", told)
            self._tell_state(self._history)

    def _print(self, revision: int) -> None:
        with self._changed:
            if self._history is None or self._mesh is None:
                return
            mesh, state, settings = self._mesh, self._history.state, self._history.settings
            if id(state) in self._kept:
                self._show_kept(state)
                return
        try:
            self._make(revision, mesh, state, settings)
        except WireprintError as error:
            self._failed(revision, str(error))

    def _make(self, revision: int, mesh: Mesh, state: State, settings: Settings) -> None:
        """Print a state, tell each part as soon as it is there, and keep all of it."""
        from wireprint.window.printing import Printing

        printing = Printing(
            mesh,
            settings,
            state.region,
            self._date,
            self._stages(revision),
            self._sketch_of(mesh, settings),
        )
        self._sketch = mesh, settings, printing.sketch
        printed = Printed(state, printing.gcode, printing.refused, {})
        for event, content in printing.events():
            printed.told[event] = content
            self._tell_print(revision, event, content)
        self._keep(printed)
        self._finish(revision)
        printing.prepare()
        heap.give_back()

    def _stages(self, revision: int) -> Callable[[str], None]:
        """Return what is called before each stage: it gives up, or says what people wait for."""
        begin = time.monotonic()

        def stage(name: str) -> None:
            self._current(revision)
            if self._shown != revision and time.monotonic() - begin > _SILENT_S:
                self._tell("progress", telling.words("progress", name))

        return stage

    def _sketch_of(self, mesh: Mesh, settings: Settings) -> Sketch | None:
        """Return what was kept of a print of the same mesh with the same settings.

        What was kept of another one goes, before the new one takes as much memory again.
        """
        if self._sketch is None or self._sketch[0] is not mesh or self._sketch[1] is not settings:
            self._sketch = None
            return None
        return self._sketch[2]

    def _finish(self, revision: int) -> None:
        with self._changed:
            self._done = max(self._done, revision)
            self._changed.notify_all()

    def _tell_print(self, revision: int, event: str, content: bytes) -> None:
        with self._changed:
            self._current(revision)
            self._lasting.pop("failed", None)
            self._tell(event, content)
            if event == "print":
                self._shown = revision
                self._tell("current", encoded({"event": "current", "revision": revision}))

    def _current(self, revision: int) -> None:
        """Give up what nobody waits for any more."""
        if self._revision != revision:
            raise _Superseded

    def _keep(self, printed: Printed) -> None:
        """Keep a print for undo and redo; the oldest ones make room."""
        with self._changed:
            # States live as long as they can be undone to, and so do their addresses.
            self._kept[id(printed.state)] = printed
            while len(self._kept) > 1 and sum(p.size for p in self._kept.values()) > _KEPT_BYTES:
                self._kept.popitem(last=False)

    def _failed(self, revision: int, words: str) -> None:
        self._tell("failed", telling.words("failed", words, revision=revision))
