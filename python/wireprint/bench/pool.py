"""Tasks go to workers, and what is lost with a worker goes to another one."""

from __future__ import annotations

from collections import Counter, deque
from typing import TYPE_CHECKING, Final, Protocol

from wireprint.bench.task import failed

if TYPE_CHECKING:
    from collections.abc import Iterable, Iterator

    from wireprint.bench.plan import Task
    from wireprint.bench.task import Row

#: A model whose worker is lost this often is taken for the cause.
MOST_LOSSES: Final = 2


class Pool(Protocol):
    """Workers that evaluate one task at a time each."""

    def has_room(self) -> bool:
        """Tell whether a worker is idle."""

    def start(self, task: Task) -> None:
        """Give a task to an idle worker."""

    def wait(self) -> list[tuple[Task, Row | None]]:
        """Wait a little; return the tasks that ended, without a row if their worker is lost."""


def rows(tasks: Iterable[Task], pool: Pool) -> Iterator[tuple[Task, Row]]:
    """Evaluate tasks and yield each one's row as soon as it is there.

    A task whose worker is lost is tried again after all others, so that a model that kills its
    workers cannot keep the others from being evaluated.
    """
    # The largest begin first: the last to end should not have begun last.
    waiting = deque(sorted(tasks, key=lambda task: (-task.size_bytes, task.index)))
    losses: Counter[int] = Counter()
    running = 0
    while waiting or running:
        while waiting and pool.has_room():
            pool.start(waiting.popleft())
            running += 1
        for task, row in pool.wait():
            running -= 1
            if row is not None:
                yield task, row
                continue
            losses[task.index] += 1
            if losses[task.index] < MOST_LOSSES:
                waiting.append(task)
            else:
                yield task, failed(task, f"its worker was lost {MOST_LOSSES} times")
