"""Many models at once: threads for the core, which lets them run side by side."""

from __future__ import annotations

import queue
import threading
from typing import TYPE_CHECKING, TypeVar

from wireprint._core import MemoryLimitError

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator, Sequence

Found = TypeVar("Found")

#: Calls that nobody waits for any more.
_deserted = 0


def as_they_finish(
    calls: Sequence[Callable[[], Found]], threads: int
) -> Iterator[tuple[int, Found | BaseException]]:
    """Run calls side by side; yield the place of each with what it returned or raised.

    The calling thread only waits, so Ctrl-C is obeyed at once, however long a call takes. What
    runs out of memory beside others gets another try alone.

    Parameters
    ----------
    calls
        What is run.
    threads
        How many at a time.
    """
    alone: list[int] = []
    for place, found in _run(calls, range(len(calls)), threads):
        if isinstance(found, MemoryLimitError) and min(threads, len(calls)) > 1:
            alone.append(place)
        else:
            yield place, found
    yield from _run(calls, alone, 1)


def deserted() -> bool:
    """Whether threads still run that were left when the command was stopped."""
    return _deserted > 0


def _run(
    calls: Sequence[Callable[[], Found]], places: Sequence[int], threads: int
) -> Iterator[tuple[int, Found | BaseException]]:
    global _deserted
    todo: queue.SimpleQueue[int] = queue.SimpleQueue()
    done: queue.SimpleQueue[tuple[int, Found | BaseException]] = queue.SimpleQueue()
    for place in places:
        todo.put(place)

    def work() -> None:
        while True:
            try:
                place = todo.get_nowait()
            except queue.Empty:
                return
            try:
                found: Found | BaseException = calls[place]()
            except BaseException as error:
                found = error
            done.put((place, found))

    for _ in range(min(threads, len(places))):
        threading.Thread(target=work, daemon=True).start()
    left = len(places)
    try:
        while left:
            found = done.get()
            left -= 1
            yield found
    finally:
        _deserted += left
