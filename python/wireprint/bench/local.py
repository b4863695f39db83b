"""Workers on this machine: one process a core."""

from __future__ import annotations

import math
import multiprocessing
import os
import signal
import time
from contextlib import suppress
from multiprocessing import connection
from typing import TYPE_CHECKING, Final

from wireprint.bench import task as bench_task
from wireprint.bench.pool import Ended
from wireprint.threads import cores

if TYPE_CHECKING:
    from multiprocessing.connection import Connection
    from multiprocessing.process import BaseProcess
    from typing import Self

    from wireprint.bench.plan import Task
    from wireprint.bench.task import Job, Row


#: What a process may take to begin its first task, s, before the task's own time counts.
STARTS_WITHIN_S: Final = 30.0


class Processes:
    """A pool of processes, each of which evaluates one task at a time.

    A task that takes longer than the job allows ends with its process.

    They are spawned, never forked: the core's threads would not survive a fork. The standard
    library's pools are of no use here: they give everything up when one process dies.
    """

    def __init__(self, job: Job, count: int) -> None:
        self._job = job
        self._context = multiprocessing.get_context("spawn")
        self._threads = max(1, cores() // count)
        self._room = count
        self._idle: list[_Worker] = []
        self._busy: dict[Connection, tuple[_Worker, Task]] = {}

    def __enter__(self) -> Self:
        """Nothing begins before the first task."""
        return self

    def __exit__(self, *_: object) -> None:
        """Leave no process behind."""
        for worker in [*self._idle, *(worker for worker, _ in self._busy.values())]:
            worker.stop()

    def has_room(self, *, alone: bool) -> bool:
        """Tell whether a process is idle or may yet be started."""
        return len(self._busy) < self._room

    def start(self, task: Task, *, alone: bool) -> None:
        """Give a task to an idle process."""
        worker = self._idle.pop() if self._idle else self._started()
        if self._job.limit_s is not None:
            begins = 0.0 if worker.served else STARTS_WITHIN_S
            worker.until = time.monotonic() + self._job.limit_s + begins
        worker.served = True
        with suppress(OSError):  # It died while idle: `wait` finds the pipe closed.
            worker.pipe.send(task)
        self._busy[worker.pipe] = worker, task

    def wait(self) -> list[Ended]:
        """Wait until a task ends; return those that did."""
        first = min((worker.until for worker, _ in self._busy.values()), default=math.inf)
        patience_s = None if first == math.inf else max(0.0, first - time.monotonic())
        ready = set(connection.wait(list(self._busy), patience_s))
        ended = [self._ended(pipe) for pipe in list(self._busy) if pipe in ready]
        now = time.monotonic()
        late = [pipe for pipe, (worker, _) in self._busy.items() if worker.until <= now]
        return ended + [self._overrun(pipe) for pipe in late]

    def _started(self) -> _Worker:
        ours, theirs = self._context.Pipe()
        process = self._context.Process(
            target=_serve, args=(theirs, self._job, self._threads), daemon=True
        )
        process.start()
        theirs.close()  # Only so does the pipe end when the process does.
        return _Worker(process, ours)

    def _ended(self, pipe: Connection) -> Ended:
        worker, task = self._busy.pop(pipe)
        try:
            row: Row | None = pipe.recv()
        except (EOFError, OSError):
            worker.stop()
            return Ended(task, None)
        self._idle.append(worker)
        return Ended(task, row or bench_task.failed(task, "the file changed while it waited"))

    def _overrun(self, pipe: Connection) -> Ended:
        worker, task = self._busy.pop(pipe)
        worker.stop()
        return Ended(task, bench_task.overrun(task, self._job.limit_s or 0.0))


class _Worker:
    """A process and the pipe to it."""

    def __init__(self, process: BaseProcess, pipe: Connection) -> None:
        self._process = process
        self.pipe = pipe
        #: Whether it has had a task, and until when it may be at its present one.
        self.served = False
        self.until = math.inf

    def stop(self) -> None:
        self.pipe.close()
        self._process.kill()
        self._process.join()


def _serve(pipe: Connection, job: Job, threads: int) -> None:
    """Evaluate what comes through the pipe until it is closed."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)  # Ctrl-C is the parent's to answer.
    # The processes fill the cores; the core's own threads, started at first use, would only queue.
    os.environ["RAYON_NUM_THREADS"] = str(threads)
    with suppress(EOFError, OSError):
        while True:
            pipe.send(bench_task.run(job, pipe.recv()))
