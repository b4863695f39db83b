"""The order in which lines are printed, and the moves that print them."""

from __future__ import annotations

from dataclasses import dataclass
from itertools import pairwise
from typing import TYPE_CHECKING, Self

import numpy as np

from wireprint.records import Record

if TYPE_CHECKING:
    from collections.abc import Sequence

    import numpy.typing as npt

    from wireprint.layerwise.lines import Lines

    Floats = npt.NDArray[np.float64]
    Ints = npt.NDArray[np.int64]
    Complexes = npt.NDArray[np.complex128]


@dataclass(frozen=True, repr=False)
class Route(Record):
    """Lines cut open and in order: what the tip follows."""

    #: Points of all lines, mm, shape (P, 3).
    points: Floats
    #: Layer of each point, shape (P,).
    layer: Ints
    #: Line i has the points ``offsets[i]:offsets[i + 1]``, shape (N + 1,).
    offsets: Ints
    #: Group of each line, shape (N,).
    group: Ints

    @classmethod
    def empty(cls) -> Self:
        """Return a route without lines."""
        none = np.zeros(0, np.int64)
        return cls(np.zeros((0, 3)), none, np.zeros(1, np.int64), none)


def routed(
    groups: Sequence[Lines], layer_of_owner: Ints, heights_mm: Floats, gap_mm: float
) -> Route:
    """Order lines by layer, island and group, and within these by the nearest next end.

    Parameters
    ----------
    groups
        Lines that are printed before those of the next group on the same island; `Lines.owner`
        is the island.
    layer_of_owner
        Layer of each island, ascending, shape (M,).
    heights_mm
        Of each layer, mm, shape (K,).
    gap_mm
        A closed line ends this far before its beginning, mm: the strand's own width fills it.
    """
    points = np.concatenate([_complex(lines) for lines in groups])
    shifts = np.cumsum([0] + [len(lines.points) for lines in groups])
    firsts = np.concatenate(
        [lines.offsets[:-1] + shift for lines, shift in zip(groups, shifts, strict=False)]
    )
    ends = np.concatenate(
        [lines.offsets[1:] + shift for lines, shift in zip(groups, shifts, strict=False)]
    )
    closed = np.concatenate([np.full(len(lines), lines.closed) for lines in groups])
    owner = np.concatenate([lines.owner for lines in groups])
    group = np.concatenate([np.full(len(lines), i) for i, lines in enumerate(groups)])
    order = np.lexsort((group, owner))
    batch = np.concatenate(
        [[0], np.flatnonzero(_changes(owner[order], group[order])), [len(order)]]
    )
    walker = _Walker(points, firsts, ends, closed)
    for low, high in pairwise(batch):
        walker.visit(order[low:high])
    index, offsets = _gathered(walker)
    flat = _opened(points[index], offsets, closed[walker.visited], gap_mm)
    layer = layer_of_owner[owner[walker.visited]].repeat(np.diff(offsets))
    points_mm = np.column_stack([flat.real, flat.imag, heights_mm[layer]])
    return Route(points_mm, layer, offsets, group[walker.visited])


class _Walker:
    """Goes from line to line, always to the nearest end (a closed line: its nearest point)."""

    def __init__(
        self, points: Complexes, firsts: Ints, ends: Ints, closed: npt.NDArray[np.bool_]
    ) -> None:
        self.points, self.firsts, self.ends, self.closed = points, firsts, ends, closed
        self.place = 0j
        #: Line by line: its number, the point that it begins with, whether it is reversed.
        self.visited: list[int] = []
        self.begins: list[int] = []
        self.reversed: list[bool] = []

    def visit(self, lines: Ints) -> None:
        """Visit lines that may be printed in any order."""
        if len(lines) == 1:
            self._go(int(lines[0]))
            return
        ends = np.stack([self.points[self.firsts[lines]], self.points[self.ends[lines] - 1]])
        for _ in range(len(lines)):
            nearest = int(np.argmin(np.abs(ends - self.place))) % len(lines)
            ends[:, nearest] = np.inf
            self._go(int(lines[nearest]))

    def _go(self, line: int) -> None:
        first, end = self.firsts[line], self.ends[line]
        backwards = False
        if self.closed[line]:
            begin = int(np.argmin(np.abs(self.points[first:end] - self.place)))
            self.place = self.points[first + begin]
        else:
            head, tail = self.points[first], self.points[end - 1]
            backwards = bool(abs(tail - self.place) < abs(head - self.place))
            begin = int(end - first - 1) if backwards else 0
            self.place = head if backwards else tail
        self.visited.append(line)
        self.begins.append(begin)
        self.reversed.append(backwards)


def _gathered(walker: _Walker) -> tuple[Ints, Ints]:
    """Return the points' indices in the order of the visit, and the lines' offsets in it."""
    visited = np.array(walker.visited, dtype=np.int64)
    firsts, sizes = walker.firsts[visited], (walker.ends - walker.firsts)[visited]
    closed = walker.closed[visited]
    counts = sizes + closed
    offsets = np.concatenate([[0], np.cumsum(counts)])
    line = np.repeat(np.arange(len(visited)), counts)
    step = np.arange(offsets[-1]) - offsets[line]
    step = np.where(np.array(walker.reversed, dtype=bool)[line], -step, step)
    index = firsts[line] + (np.array(walker.begins, np.int64)[line] + step) % sizes[line]
    return index, offsets


def _opened(
    points: Complexes, offsets: Ints, closed: npt.NDArray[np.bool_], gap_mm: float
) -> Complexes:
    """Draw the ends of closed lines back from where these began."""
    seams = (offsets[1:] - 1)[closed]
    back = points[seams - 1] - points[seams]
    points[seams] += back * np.minimum(0.5, gap_mm / np.maximum(np.abs(back), 1e-9))
    return points


def _changes(*keys: Ints) -> npt.NDArray[np.bool_]:
    change = np.zeros(len(keys[0]), dtype=bool)
    for key in keys:
        change[1:] |= key[1:] != key[:-1]
    return change


def _complex(lines: Lines) -> Complexes:
    return lines.points[:, 0] + 1j * lines.points[:, 1]
