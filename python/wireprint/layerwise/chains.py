"""Edges joined end to end, and lines straightened."""

from __future__ import annotations

from collections import defaultdict
from typing import TYPE_CHECKING

import numpy as np

if TYPE_CHECKING:
    import numpy.typing as npt


def chains(edges: npt.NDArray[np.int64]) -> list[list[int]]:
    """Join edges at vertices where just two meet.

    Parameters
    ----------
    edges
        Vertices of each edge, shape (N, 2).

    Returns
    -------
    list of list of int
        The vertices of each chain in order; a closed one repeats its first at the end.
    """
    at_vertex: dict[int, list[int]] = defaultdict(list)
    ends: list[tuple[int, int]] = [(int(one), int(other)) for one, other in edges]
    for number, (one, other) in enumerate(ends):
        at_vertex[one].append(number)
        at_vertex[other].append(number)
    unused = dict.fromkeys(range(len(ends)))
    forks = [vertex for vertex, numbers in at_vertex.items() if len(numbers) != 2]
    found = []
    for vertex in forks:
        # Each walk may use up edges that come later, so they are asked for one by one.
        found += [
            _walk(vertex, number, ends, at_vertex, unused)
            for number in at_vertex[vertex]
            if number in unused
        ]
    # What is left are loops without a fork.
    while unused:
        number = next(iter(unused))
        found.append(_walk(ends[number][0], number, ends, at_vertex, unused))
    return found


def _walk(
    vertex: int,
    number: int,
    ends: list[tuple[int, int]],
    at_vertex: dict[int, list[int]],
    unused: dict[int, None],
) -> list[int]:
    chain = [vertex]
    while number in unused:
        del unused[number]
        one, other = ends[number]
        vertex = other if vertex == one else one
        chain.append(vertex)
        around = at_vertex[vertex]
        if len(around) != 2:
            break
        number = around[1] if around[0] == number else around[0]
    return chain


def thinned(points: npt.NDArray[np.float64], tolerance_mm: float) -> npt.NDArray[np.float64]:
    """Leave out points of a line that lie within a tolerance of what is left (Douglas, Peucker).

    Parameters
    ----------
    points
        The line, shape (N, 3), N at least 2.
    tolerance_mm
        Greatest distance, mm.
    """
    keep = np.zeros(len(points), dtype=bool)
    keep[[0, -1]] = True
    spans = [(0, len(points) - 1)]
    while spans:
        low, high = spans.pop()
        if high - low < 2:
            continue
        distances = _distances(points[low + 1 : high], points[low], points[high])
        worst = int(np.argmax(distances))
        if distances[worst] > tolerance_mm:
            middle = low + 1 + worst
            keep[middle] = True
            spans += [(low, middle), (middle, high)]
    return points[keep]


def _distances(
    points: npt.NDArray[np.float64],
    begin: npt.NDArray[np.float64],
    end: npt.NDArray[np.float64],
) -> npt.NDArray[np.float64]:
    """Distance of points from a segment, mm."""
    along = end - begin
    share = np.clip((points - begin) @ along / max(float(along @ along), 1e-30), 0.0, 1.0)
    distances: npt.NDArray[np.float64] = np.linalg.norm(
        points - begin - share[:, None] * along, axis=1
    )
    return distances
