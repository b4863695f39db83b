"""Tasks go to workers, and what is lost with a worker goes to another one."""

from __future__ import annotations

from collections import Counter, deque
from dataclasses import dataclass
from typing import TYPE_CHECKING, Final, Protocol

from wireprint.bench.task import failed

if TYPE_CHECKING:
    from collections.abc import Iterable, Iterator

    from wireprint.bench.plan import Task
    from wireprint.bench.task import Row

#: A model whose worker is lost this often while it has nothing else to do is taken for the cause.
MOST_LOSSES: Final = 2
#: So often it must be where workers are known to be lost without any model's doing. Where one loss
#: in four hits the same model again, one in four thousand is blamed for what it did not do.
MOST_LOSSES_ANYWAY: Final = 6


@dataclass(frozen=True)
class Ended:
    """A task that a worker is done with, one way or another."""

    task: Task
    #: None where the worker is lost.
    row: Row | None
    #: Whether the worker had nothing else to do: only then may its loss be the task's doing.
    alone: bool = True


class Pool(Protocol):
    """Workers that evaluate tasks, some of them several at a time."""

    def has_room(self, *, alone: bool) -> bool:
        """Tell whether a worker is idle: one that would have nothing else to do if `alone`."""

    def start(self, task: Task, *, alone: bool) -> None:
        """Give a task to an idle worker; `alone`: the worker gets nothing else meanwhile."""

    def wait(self) -> list[Ended]:
        """Wait a little; return the tasks that ended."""


def rows(tasks: Iterable[Task], pool: Pool) -> Iterator[tuple[Task, Row]]:
    """Evaluate tasks and yield each one's row as soon as it is there.

    A task whose worker is lost is tried again after all others, on a worker of its own, so that a
    model that kills its workers cannot keep the others from being evaluated, and no model is blamed
    for what another one did. Blame comes last: if a model that had its worker to itself when that
    was lost is evaluated after all, workers are lost for other reasons.
    """
    # The largest begin first: the last to end should not have begun last.
    waiting = deque(sorted(tasks, key=lambda task: (-task.size_bytes, task.index)))
    suspects: deque[Task] = deque()
    accused: list[Task] = []
    losses: Counter[int] = Counter()
    running = 0
    most = MOST_LOSSES
    while waiting or suspects or accused or running:
        if not (waiting or suspects or running):
            for task in accused:
                if losses[task.index] < most:
                    suspects.append(task)
                else:
                    yield task, failed(task, f"its worker was lost {losses[task.index]} times")
            accused.clear()
            continue
        while waiting and pool.has_room(alone=False):
            pool.start(waiting.popleft(), alone=False)
            running += 1
        while not waiting and suspects and pool.has_room(alone=True):
            pool.start(suspects.popleft(), alone=True)
            running += 1
        for ended in pool.wait():
            running -= 1
            task = ended.task
            if ended.row is not None:
                most = MOST_LOSSES_ANYWAY if losses[task.index] else most
                yield task, ended.row
                continue
            losses[task.index] += ended.alone
            (suspects if losses[task.index] < MOST_LOSSES else accused).append(task)
