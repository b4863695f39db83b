"""Workers on many machines, through a Dask scheduler."""

from __future__ import annotations

import time
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Any, Final

from wireprint._core import SettingError, WireprintError
from wireprint.bench import task as bench_task

if TYPE_CHECKING:
    from typing import Self

    from distributed import Client, Future

    from wireprint.bench.plan import Task
    from wireprint.bench.task import Job, Row

#: How long to wait for the scheduler to answer, s.
CONNECT_WITHIN_S: Final = 10.0
#: How long to go on without a single worker, s.
WORKERS_WITHIN_S: Final = 60.0
#: How often to look whether the workers still live, s.
LOOK_EVERY_S: Final = 0.5


class Cluster:
    """A pool of the threads of all workers that a scheduler knows, now and later.

    Each task is pinned to a worker: Dask on its own would move the tasks of a lost worker, count
    the loss against those that had merely waited there, and give up after a number of losses that
    only the scheduler's configuration knows.
    """

    def __init__(self, job: Job, address: str) -> None:
        self._job = job
        self._client = _client(address)
        self._threads: dict[str, int] = self._client.nthreads()
        self._running: dict[Future[Any], tuple[str, Task]] = {}
        self._last_seen = time.monotonic()

    def __enter__(self) -> Self:
        """Nothing begins before the first task."""
        return self

    def __exit__(self, *_: object) -> None:
        """Take back what has not begun, and leave the cluster as it was."""
        self._client.cancel(list(self._running))
        self._client.close()

    def has_room(self) -> bool:
        """Tell whether a thread of a worker is idle."""
        return self._idle() is not None

    def start(self, task: Task) -> None:
        """Give a task to an idle worker."""
        worker = self._idle()
        if worker is None:
            raise ValueError("no worker is idle")
        self._submit(worker, task)

    def wait(self) -> list[tuple[Task, Row | None]]:
        """Wait a little; return the tasks that ended, and those that were lost.

        Raises
        ------
        WireprintError
            There has been no worker for too long.
        """
        self._pause()
        self._threads = self._client.nthreads()
        self._expect_workers()
        ended = []
        for future, (worker, task) in list(self._running.items()):
            if future.done():
                del self._running[future]
                ended += self._ended(future, worker, task)
            elif worker not in self._threads:
                del self._running[future]
                future.cancel()
                ended.append((task, None))
        return ended

    def _idle(self) -> str | None:
        """Return the worker with the most idle threads, if there is one."""
        free = dict(self._threads)
        for worker, _ in self._running.values():
            if worker in free:
                free[worker] -= 1
        best = max(free, key=lambda worker: free[worker], default=None)
        return best if best is not None and free[best] > 0 else None

    def _submit(self, worker: str, task: Task) -> None:
        future = self._client.submit(
            bench_task.run, self._job, task, workers=[worker], pure=False, retries=0
        )
        self._running[future] = worker, task

    def _pause(self) -> None:
        """Wait until a task ends, but not for long: a worker may be lost, or a new one come."""
        from distributed import wait

        if not self._running:
            time.sleep(LOOK_EVERY_S)
            return
        try:
            wait(list(self._running), timeout=LOOK_EVERY_S, return_when="FIRST_COMPLETED")
        except TimeoutError:
            return

    def _ended(self, future: Future[Any], worker: str, task: Task) -> list[tuple[Task, Row | None]]:
        """Take a row from the worker; one that cannot see the file is sent it."""
        from distributed.scheduler import KilledWorker

        if future.status == "cancelled":
            return [(task, None)]
        error = future.exception()
        if isinstance(error, KilledWorker):
            return [(task, None)]
        if error is not None:
            return [(task, bench_task.failed(task, f"the worker failed: {error!r}"))]
        row: Row | None = future.result()
        if row is not None:
            return [(task, row)]
        if task.content is not None:
            return [(task, bench_task.failed(task, "the file changed while it waited"))]
        self._submit(worker, _with_content(task))
        return []

    def _expect_workers(self) -> None:
        now = time.monotonic()
        if self._threads:
            self._last_seen = now
        elif now - self._last_seen > WORKERS_WITHIN_S:
            msg = (
                f"the cluster has had no worker for {WORKERS_WITHIN_S:g} s; "
                "the rows so far are kept: start workers, then run this again"
            )
            raise WireprintError(msg)


def _with_content(task: Task) -> Task:
    return replace(task, content=Path(task.model).read_bytes())


def _client(address: str) -> Client:
    try:
        from distributed import Client
    except ImportError as error:
        msg = "--scheduler needs Dask: pip install 'wireprint[dask]'"
        raise SettingError(msg) from error
    try:
        return Client(address, timeout=CONNECT_WITHIN_S)
    except (OSError, ValueError) as error:
        msg = f"no scheduler answers at {address}: {error}"
        raise SettingError(msg) from error
