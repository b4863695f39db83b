"""One run: what is not there yet is evaluated, and every row is kept at once."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from wireprint.bench import pool
from wireprint.bench.task import started

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator, Sequence
    from contextlib import AbstractContextManager

    from wireprint.bench.plan import Task
    from wireprint.bench.table import Table
    from wireprint.bench.task import Job, Row


def run(
    tasks: Sequence[Task],
    table: Table,
    workers: Callable[[int], AbstractContextManager[Any]],
    *,
    retry_failed: bool = False,
    on_row: Callable[[Task, Row], None] = lambda task, row: None,
) -> list[Row]:
    """Evaluate models, and write the table.

    Parameters
    ----------
    tasks
        The models.
    table
        Keeps the rows; those that it has are not made again.
    workers
        Opens a `pool.Pool` for a number of tasks.
    retry_failed
        Whether rows that are failures are made again.
    on_row
        Is told each task with its row, in the order in which they are finished.

    Returns
    -------
    list
        One row for each task, in their order.
    """
    rows: dict[int, Row] = {}
    for task, row in _known(tasks, table, retry_failed):
        rows[task.index] = row
        on_row(task, row)
    with table:
        for task, row in _computed([task for task in tasks if task.index not in rows], workers):
            rows[task.index] = row
            table.add(row)
            on_row(task, row)
    ordered = [rows[task.index] for task in tasks]
    table.finish(ordered)
    return ordered


def local(job: Job, jobs: int | None) -> Callable[[int], AbstractContextManager[Any]]:
    """Return what opens processes on this machine: `jobs`, or one a core."""
    from wireprint.bench.local import Processes
    from wireprint.threads import cores

    return lambda tasks: Processes(job, min(jobs or cores(), tasks))


def cluster(job: Job, address: str) -> Callable[[int], AbstractContextManager[Any]]:
    """Return what opens the workers of a Dask scheduler."""
    from wireprint.bench.cluster import Cluster

    return lambda _: Cluster(job, address)


def _known(tasks: Sequence[Task], table: Table, retry_failed: bool) -> Iterator[tuple[Task, Row]]:
    """Yield the rows that need no worker."""
    for task in tasks:
        row = started(task) if task.error else table.row_of(task)
        if row is not None and not (retry_failed and row.get("error") and not task.error):
            yield task, row


def _computed(
    tasks: Sequence[Task], workers: Callable[[int], AbstractContextManager[Any]]
) -> Iterator[tuple[Task, Row]]:
    if tasks:
        with workers(len(tasks)) as opened:
            yield from pool.rows(tasks, opened)
