"""Workers on many machines, through a Dask scheduler."""

from __future__ import annotations

import math
import time
from collections import Counter
from contextlib import suppress
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Any, Final

from wireprint._core import SettingError, WireprintError
from wireprint.bench import task as bench_task
from wireprint.bench.fingerprint import fingerprint
from wireprint.bench.pool import Ended

if TYPE_CHECKING:
    from collections.abc import Iterable
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
        self._address = address
        self._client = _client(address)
        self._ours = _ours()
        #: Workers that may be used, and why others may not.
        self._threads: dict[str, int] = {}
        self._refused: dict[str, str] = {}
        self._running: dict[Future[Any], tuple[str, Task]] = {}
        #: Until when each may take, by `time.monotonic`; those that were given up, and still run.
        self._until: dict[Future[Any], float] = {}
        self._given_up: dict[Future[Any], str] = {}
        #: Workers that one task has to itself.
        self._reserved: set[str] = set()
        self._last_seen = self._last_heard = time.monotonic()
        self._look()

    def __enter__(self) -> Self:
        """Nothing begins before the first task."""
        return self

    def __exit__(self, *_: object) -> None:
        """Take back what has not begun, and leave the cluster as it was."""
        if self._client.status == "running":
            self._client.cancel(list(self._running))
        self._client.close()

    def has_room(self, *, alone: bool) -> bool:
        """Tell whether a thread of a worker is idle, or all of one's if `alone`."""
        return self._idle(alone) is not None

    def start(self, task: Task, *, alone: bool) -> None:
        """Give a task to an idle worker, which it has to itself if `alone`."""
        worker = self._idle(alone)
        if worker is None:
            raise ValueError("no worker is idle")
        if alone:
            self._reserved.add(worker)
        self._submit(worker, task)

    def wait(self) -> list[Ended]:
        """Wait a little; return the tasks that ended, and those that were lost.

        Raises
        ------
        WireprintError
            There has been no worker for too long, or the scheduler is gone.
        """
        self._pause()
        self._look()
        ended: list[Ended] = []
        # All that ran when a worker was lost shares the suspicion.
        load = Counter(worker for worker, _ in self._running.values())
        for future, (worker, task) in list(self._running.items()):
            alone = load[worker] == 1
            if future.done():
                ended += self._ended(future, worker, task, alone)
            elif worker not in self._threads:
                future.cancel()
                ended.append(Ended(task, None, alone))
            elif self._until.get(future, math.inf) <= time.monotonic():
                self._give_up(future, worker)
                ended.append(Ended(task, bench_task.overrun(task, self._job.limit_s or 0.0)))
            else:
                continue
            del self._running[future]
            self._until.pop(future, None)
        self._given_up = {
            future: worker
            for future, worker in self._given_up.items()
            if worker in self._threads and not future.done()
        }
        self._reserved &= {worker for worker, _ in self._running.values()}
        return ended

    def _give_up(self, future: Future[Any], worker: str) -> None:
        """End a task that takes too long: with its worker, where a nanny starts that anew.

        Without a nanny nobody can end it; its thread is left to it until it ends by itself.
        """
        try:
            self._client.restart_workers([worker], timeout=CONNECT_WITHIN_S, raise_for_error=False)
            future.cancel()
        except (ValueError, OSError, TimeoutError):
            self._given_up[future] = worker

    def _look(self) -> None:
        """See which workers there are, and whether they run what we run."""
        found = self._nthreads()
        unknown = [one for one in found if one not in self._threads and one not in self._refused]
        if unknown:
            self._ask(unknown)
        self._threads = {one: n for one, n in found.items() if one not in self._refused}
        self._expect_workers(found)

    def _nthreads(self) -> dict[str, int]:
        """Return the threads of each worker; none while the scheduler does not answer."""
        now = time.monotonic()
        # A client that has lost its scheduler is "connecting" for a while, then "closed".
        with suppress(OSError, TimeoutError, AttributeError):
            if self._client.status == "running":
                found: dict[str, int] = self._client.nthreads()
                self._last_heard = now
                return found
        if now - self._last_heard > CONNECT_WITHIN_S:
            msg = (
                f"the scheduler at {self._address} is gone; the rows so far are kept: "
                "start it and its workers, then run this again"
            )
            raise WireprintError(msg)
        return {}

    def _ask(self, workers: list[str]) -> None:
        """Refuse workers that would run other code than ours."""
        answers = self._client.run(fingerprint, workers=workers, on_error="return")
        version, code = self._ours
        for worker, answer in answers.items():
            # Dask hands on what it could not load as a plain exception with the words of the cause.
            if isinstance(answer, Exception) and "No module named 'wireprint" in str(answer):
                self._refused[worker] = (
                    f"it has no wireprint {version}: pip install wireprint=={version}"
                )
            elif isinstance(answer, OSError):
                continue  # It is lost already; what it is given is counted so.
            elif isinstance(answer, Exception):
                self._refused[worker] = f"it fails: {answer!r}"
            elif tuple(answer) != self._ours:
                self._refused[worker] = (
                    f"it runs wireprint {answer[0]} ({answer[1]}), this is {version} ({code}): "
                    "install the same on both"
                )

    def _idle(self, alone: bool) -> str | None:
        """Return the worker with the most idle threads, if there is one."""
        free = {one: n for one, n in self._threads.items() if one not in self._reserved}
        busy = [*(worker for worker, _ in self._running.values()), *self._given_up.values()]
        for worker in busy:
            if worker in free:
                free[worker] -= self._threads[worker] if alone else 1
        best = max(free, key=lambda worker: free[worker], default=None)
        return best if best is not None and free[best] > 0 else None

    def _submit(self, worker: str, task: Task) -> None:
        future = self._client.submit(
            bench_task.run, self._job, task, workers=[worker], pure=False, retries=0
        )
        self._running[future] = worker, task
        if self._job.limit_s is not None:
            self._until[future] = time.monotonic() + self._job.limit_s

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

    def _ended(self, future: Future[Any], worker: str, task: Task, alone: bool) -> Iterable[Ended]:
        """Take a row from the worker; one that cannot see the file is sent it."""
        from distributed.scheduler import KilledWorker

        if future.status == "cancelled":
            return [Ended(task, None, alone)]
        error = future.exception()
        if isinstance(error, KilledWorker):
            return [Ended(task, None, alone)]
        if error is not None:
            return [Ended(task, bench_task.failed(task, f"the worker failed: {error!r}"))]
        row: Row | None = future.result()
        if row is not None:
            return [Ended(task, row)]
        if task.content is not None:
            return [Ended(task, bench_task.failed(task, "the file changed while it waited"))]
        self._submit(worker, _with_content(task))
        return []

    def _expect_workers(self, found: dict[str, int]) -> None:
        now = time.monotonic()
        if self._threads:
            self._last_seen = now
        elif found:
            refused = "; ".join(f"{one}: {self._refused[one]}" for one in found)
            raise WireprintError(f"no worker of the cluster can be used: {refused}")
        elif now - self._last_seen > WORKERS_WITHIN_S:
            msg = (
                f"the cluster has had no worker for {WORKERS_WITHIN_S:g} s; "
                "the rows so far are kept: start workers, then run this again"
            )
            raise WireprintError(msg)


def _with_content(task: Task) -> Task:
    return replace(task, content=Path(task.model).read_bytes())


def _ours() -> tuple[str, str]:
    return fingerprint()


def _client(address: str) -> Client:
    try:
        from distributed import Client
    except ImportError as error:
        msg = "--scheduler needs Dask: pip install 'wireprint[dask]'"
        raise SettingError(msg) from error
    try:
        return Client(address, timeout=CONNECT_WITHIN_S)
    except (OSError, ValueError, TypeError, RuntimeError) as error:
        msg = f"no scheduler answers at {address}: {error}"
        if address.startswith("tls:"):
            msg += (
                "; tls needs certificates: name them in Dask's configuration "
                "(distributed.comm.tls: ca-file, client.cert, client.key)"
            )
        raise SettingError(msg) from error
