"""How far a run is: a bar on a terminal, where it takes long; a line now and then elsewhere."""

from __future__ import annotations

import sys
import threading
import time
from typing import TYPE_CHECKING

from wireprint.cli.say import say
from wireprint.duration import duration
from wireprint.text import one_line

if TYPE_CHECKING:
    from typing import Self

    import rich.progress

#: Work that ends sooner shows nothing, s.
PATIENCE_S = 1.0
#: Without a terminal, a line is printed no more often than this, s.
LINE_EVERY_S = 30.0


class Progress:
    """Counts what is finished on stderr, if that is a terminal and a second has passed.

    Parameters
    ----------
    total
        How many there are.
    lines
        Whether lines are printed where there is no terminal.
    what
        What is counted.
    """

    def __init__(self, total: int, *, lines: bool = False, what: str = "models") -> None:
        self._total = total
        self._what = what
        self._lines = lines and not sys.stderr.isatty()
        self._failed = 0
        self._begin_s = self._told_s = time.monotonic()
        self._done = 0
        self._text = ""
        self._lock = threading.Lock()
        self._bar: rich.progress.Progress | None = None
        self._timer = threading.Timer(PATIENCE_S, self._begin)
        self._timer.daemon = True

    def __enter__(self) -> Self:
        """Begin to wait."""
        if sys.stderr.isatty():
            self._timer.start()
        return self

    def __exit__(self, *_: object) -> None:
        """Remove the bar."""
        self._timer.cancel()
        self.clear()

    def show(self, text: str) -> None:
        """Say what is being done."""
        self._text = one_line(text)
        self._update()

    def advance(self, *, failed: bool = False) -> None:
        """Count one model as finished."""
        self._done += 1
        self._failed += failed
        self._update()
        self._tell(f", {self._failed} failed")

    def reach(self, done: int) -> None:
        """Say how many are finished."""
        self._done = min(done, self._total)
        self._update()
        self._tell()

    def _tell(self, more: str = "") -> None:
        now_s = time.monotonic()
        if self._lines and now_s - self._told_s >= LINE_EVERY_S:
            self._told_s = now_s
            say(
                f"{self._done} of {self._total} {self._what}{more}, "
                f"{duration(now_s - self._begin_s)}",
                err=True,
            )

    def clear(self) -> None:
        """Remove the bar, so that other lines may be written."""
        with self._lock:
            if self._bar is not None:
                self._bar.stop()
                self._bar = None

    def _begin(self) -> None:
        import rich.console
        import rich.progress

        with self._lock:
            self._bar = rich.progress.Progress(
                rich.progress.SpinnerColumn(),
                rich.progress.TextColumn("{task.description}", markup=False),
                rich.progress.BarColumn(),
                rich.progress.MofNCompleteColumn(),
                rich.progress.TimeElapsedColumn(),
                rich.progress.TextColumn("left:"),
                rich.progress.TimeRemainingColumn(),
                console=rich.console.Console(stderr=True),
                transient=True,
            )
            self._bar.add_task(self._text, total=self._total, completed=self._done)
            self._bar.start()

    def _update(self) -> None:
        with self._lock:
            if self._bar is not None:
                task = self._bar.task_ids[0]
                self._bar.update(task, description=self._text, completed=self._done)
