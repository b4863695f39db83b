"""Strands that moves leave behind, and where each touches what was there before, by halving.

A part of a strand is in contact throughout if its middle is nearer to something than the limit by
half of the part's length, out of contact throughout if it is farther by as much, and halved
otherwise: distances grow no faster than lengths.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

if TYPE_CHECKING:
    from brute_machine import Move
    from numpy.typing import NDArray

#: Coordinates are rounded in files: a contact may be missed by so much, mm.
ROUNDING_MM = 2e-3
#: Material of the own chain holds from so many diameters back.
BACK = 3.0
#: Parts are not halved any further than this, mm.
SHORTEST_MM = 1e-7


@dataclass
class Strands:
    """Strands in the order of printing."""

    #: The ends of each, ``(N, 2, 3)``, mm.
    ends: NDArray[Any]
    #: The move that lays each.
    move: list[int]
    #: Number of the chain of each, and the length of the chain before it, mm.
    chain: list[int]
    arc: NDArray[Any]
    length: NDArray[Any]
    #: Number of strands that lie there before each move.
    before: list[int]
    #: How long the head stays at the end of each, s; None: not at all.
    dwell: list[float | None]


def laid(moves: list[Move], dwells: list[tuple[int, float]]) -> Strands:
    """Lay the strands of moves."""
    ends: list[tuple] = []
    move, chain, arc, length, before = [], [], [], [], []
    dwell: list[float | None] = []
    number, so_far, at = 0, 0.0, None
    pauses: dict[int, list[float]] = {}
    for after, seconds in dwells:
        pauses.setdefault(after - 1, []).append(seconds)
    for index, step in enumerate(moves):
        long = float(np.linalg.norm(np.subtract(step.end, step.start)))
        travels = long > 1e-6 and step.filament <= 0
        if (travels or at not in (None, step.start)) and so_far > 0:
            number, so_far = number + 1, 0.0
        at = step.end
        before.append(len(ends))
        if long > 1e-6 and step.filament > 0:
            ends.append((step.start, step.end))
            move.append(index)
            chain.append(number)
            arc.append(so_far)
            length.append(long)
            dwell.append(None)
            so_far += long
        for seconds in pauses.get(index, ()):
            if ends and ends[-1][1] == step.end:
                dwell[-1] = (dwell[-1] or 0.0) + seconds
    array = np.array(ends, float).reshape(-1, 2, 3)
    return Strands(array, move, chain, np.array(arc), np.array(length), before, dwell)


def distances(point: NDArray[Any], segments: NDArray[Any]) -> NDArray[Any]:
    """Distances of a point from segments ``(N, 2, 3)``, mm."""
    start = segments[:, 0]
    run = segments[:, 1] - start
    squared = np.maximum(np.einsum("ij,ij->i", run, run), 1e-300)
    along = np.clip(np.einsum("ij,ij->i", point - start, run) / squared, 0, 1)
    return np.linalg.norm(start + along[:, None] * run - point, axis=1)


def holding(strands: Strands, index: int, strand_mm: float) -> NDArray[Any]:
    """Segments that may hold a strand: those before it, of its own chain those far back."""
    others = strands.ends[:index].copy()
    own = np.array(strands.chain[:index]) == strands.chain[index]
    if index == 0 or not own.any():
        return others
    left = strands.arc[index] - BACK * strand_mm - strands.arc[:index]
    share = np.where(own, np.clip(left / strands.length[:index], -1, 1), 1)
    run = others[:, 1] - others[:, 0]
    others[:, 1] = others[:, 0] + share[:, None] * run
    return others[share > 0]


def contacts(
    strands: Strands, index: int, strand_mm: float, bed_contact_mm: float
) -> list[tuple[float, float]]:
    """Parts of a strand in contact, as shares of its length, in order."""
    start, end = strands.ends[index]
    long = strands.length[index]
    limit = strand_mm + ROUNDING_MM
    low = np.minimum(start, end) - limit
    high = np.maximum(start, end) + limit
    others = holding(strands, index, strand_mm)
    apart = (others.min(axis=1) > high).any(axis=1) | (others.max(axis=1) < low).any(axis=1)
    others = others[~apart]
    slope = abs(end[2] - start[2]) / long

    def excess(share: float) -> float:
        """By how much the point is too far from everything, mm; it grows no faster than lengths."""
        point = start + share * (end - start)
        bed = point[2] - bed_contact_mm - ROUNDING_MM
        near = float(distances(point, others).min()) - limit if len(others) else np.inf
        return min(near, bed / slope if slope > 0 and bed > 0 else bed)

    parts: list[tuple[float, float]] = []
    queue = [(0.0, 1.0)]
    while queue:
        a, b = queue.pop()
        half = (b - a) * long / 2
        over = excess((a + b) / 2)
        if over > half:
            continue
        if over > -half and half > SHORTEST_MM:
            queue += [((a + b) / 2, b), (a, (a + b) / 2)]
        elif over <= 0:
            parts.append((a, b))
    return joined(parts)


def joined(parts: list[tuple[float, float]]) -> list[tuple[float, float]]:
    """Join parts that touch, over gaps of what was not halved any further."""
    found: list[tuple[float, float]] = []
    for a, b in sorted(parts):
        if found and a - found[-1][1] < 1e-9:
            found[-1] = (found[-1][0], max(found[-1][1], b))
        else:
            found.append((a, b))
    return found
