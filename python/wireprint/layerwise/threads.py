"""Shapely calls on many geometries, spread over the processor's cores."""

from __future__ import annotations

from concurrent.futures import ThreadPoolExecutor
from itertools import pairwise
from typing import TYPE_CHECKING, Any

import numpy as np

from wireprint.threads import workers

if TYPE_CHECKING:
    from collections.abc import Callable

    import numpy.typing as npt

#: Fewer geometries than this are not worth a thread.
_CHUNK = 32


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
    threads = workers()
    chunks = min(4 * threads, count // _CHUNK)
    if threads < 2 or chunks < 2:
        return function(*columns)
    cuts = np.linspace(0, count, chunks + 1).astype(int)
    parts = [tuple(column[low:high] for column in columns) for low, high in pairwise(cuts)]
    with ThreadPoolExecutor(threads) as pool:
        return np.concatenate(list(pool.map(lambda part: function(*part), parts)))
