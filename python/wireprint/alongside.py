"""Which strands of a print lie along others: what stands already, whoever laid it."""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

import numpy as np

if TYPE_CHECKING:
    import numpy.typing as npt

    from wireprint._core import Wireframe
    from wireprint.verdict import Point

#: A strand of the new print that lies along standing ones to this stands already, mm: G-code has
#: thousandths along each axis.
SAME_MM: Final = 0.002


def lying_along(frame: Wireframe, origin_mm: Point, strands: npt.NDArray[np.float64]) -> list[int]:
    """Return the numbers of a print's strands that lie along others from end to end, ascending.

    Parameters
    ----------
    frame, origin_mm
        See `wireprint.standing.Standing.printed_of`.
    strands
        The others, in the machine's coordinates, mm, shape (N, 2, 3).
    """
    own = frame.strands + np.array(origin_mm)
    if not len(own) or not len(strands):
        return []
    # A strand may have been written in two pieces, one with the air on: its ends are looked for,
    # and whatever leads from one to the other.
    cells = {_cell(end): True for ends in strands for end in ends}
    near = [all(_known(cells, end) for end in ends) for ends in own]
    return _along(own, np.flatnonzero(near), strands)


def _cell(end: npt.NDArray[np.float64]) -> tuple[int, int, int]:
    x, y, z = (round(float(value) / SAME_MM) for value in end)
    return x, y, z


def _known(cells: dict[tuple[int, int, int], bool], end: npt.NDArray[np.float64]) -> bool:
    x, y, z = _cell(end)
    steps = (-1, 0, 1)
    return any((x + i, y + j, z + k) in cells for i in steps for j in steps for k in steps)


def _along(
    own: npt.NDArray[np.float64],
    numbers: npt.NDArray[np.int64],
    standing: npt.NDArray[np.float64],
) -> list[int]:
    """Return which of these strands lie along standing ones from end to end."""
    from shapely import STRtree, box

    low, high = standing.min(axis=1), standing.max(axis=1)
    tree = STRtree(box(low[:, 0], low[:, 1], high[:, 0], high[:, 1]))
    found = []
    for number in numbers:
        start, end = own[number]
        run = end - start
        length = float(np.linalg.norm(run))
        if length == 0.0:
            continue
        a, b = np.minimum(start, end) - SAME_MM, np.maximum(start, end) + SAME_MM
        near = standing[tree.query(box(a[0], a[1], b[0], b[1]))]
        place = (near - start) @ run / length
        off = np.linalg.norm(near - start - place[..., None] * run / length, axis=-1)
        along = np.sort(place[(off <= SAME_MM).all(axis=1)], axis=1)
        at = 0.0
        for begin, finish in along[np.argsort(along[:, 0])]:
            if begin > at + SAME_MM:
                break
            at = max(at, float(finish))
        if at >= length - SAME_MM:
            found.append(int(number))
    return found
