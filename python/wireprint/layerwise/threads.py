"""Shapely calls on many geometries, spread over the processor's cores."""

from __future__ import annotations

import os
from concurrent.futures import ThreadPoolExecutor
from itertools import pairwise
from typing import TYPE_CHECKING, Any

import numpy as np

if TYPE_CHECKING:
    from collections.abc import Callable

    import numpy.typing as npt

#: Fewer geometries than this are not worth a thread.
_CHUNK = 32


def _workers() -> int:
    """Return how many threads the core may use, too: one variable limits both."""
    limit = os.environ.get("RAYON_NUM_THREADS", "")
    if limit.isdecimal() and int(limit):
        return int(limit)
    if hasattr(os, "sched_getaffinity"):
        return len(os.sched_getaffinity(0))
    return os.cpu_count() or 1


def mapped(
    function: Callable[..., npt.NDArray[Any]], *columns: npt.NDArray[Any]
) -> npt.NDArray[Any]:
    """Apply a vectorised shapely function to rows of arrays; shapely releases the GIL.

    Parameters
    ----------
    function
        Takes as many arrays as there are columns and gives one of the same length.
    *columns
        Arrays of one length N.

    Returns
    -------
    numpy.ndarray
        The results, in order, shape (N,).
    """
    count = len(columns[0])
    workers = _workers()
    chunks = min(4 * workers, count // _CHUNK)
    if workers < 2 or chunks < 2:
        return function(*columns)
    cuts = np.linspace(0, count, chunks + 1).astype(int)
    parts = [tuple(column[low:high] for column in columns) for low, high in pairwise(cuts)]
    with ThreadPoolExecutor(workers) as pool:
        return np.concatenate(list(pool.map(lambda part: function(*part), parts)))
