"""Painting of triangles, as PrusaSlicer, Bambu Studio and OrcaSlicer keep it.

A triangle's painting is a string of hexadecimal digits that is read from its end. Each digit is a
node of a tree. Its lower two bits tell into how many triangles less one the node is split. Where
they are 0 the node is a leaf, and the upper two bits are its state: 0 unpainted, 1 and 2 the first
two extruders; 3 means that another digit follows, which is the state less 3. Where the node is
split, the upper two bits tell which corner the split is counted from, and its children follow, the
last one first.

Counted from corner a of a triangle a, b, c, with m between two corners their middle, the children
are

======  ==========================================================================
split   children
======  ==========================================================================
in 2    (a, b, m_bc), (m_bc, c, a)
in 3    (a, m_ab, m_ca), (m_ab, b, m_ca), (b, c, m_ca)
in 4    (a, m_ab, m_ca), (m_ab, b, m_bc), (m_bc, c, m_ca), (m_ab, m_bc, m_ca)
======  ==========================================================================

PrusaSlicer's makers describe the digits in https://github.com/prusa3d/PrusaSlicer/issues/5294; the
geometry was found by slicing painted triangles with PrusaSlicer 2.5.
"""

from __future__ import annotations

from functools import lru_cache
from typing import TYPE_CHECKING, TypeAlias

import numpy as np

if TYPE_CHECKING:
    from collections.abc import Iterator

    import numpy.typing as npt

    #: Weights of the whole triangle's corners.
    Corner: TypeAlias = tuple[float, float, float]
    Triangle: TypeAlias = tuple[Corner, Corner, Corner]

#: A leaf whose state stands in the next digit.
_EXTENDED = 3
_TURNS = ((0, 1, 2), (1, 2, 0), (2, 0, 1))
_WHOLE = ((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0))


@lru_cache(maxsize=1 << 12)
def decoded(painting: str) -> tuple[npt.NDArray[np.float64], npt.NDArray[np.uint8]]:
    """Return the leaves of a painted triangle.

    Parameters
    ----------
    painting
        Hexadecimal digits, not empty.

    Returns
    -------
    weights
        float64 of shape (L, 3, 3): weights of the triangle's corners for each corner of each leaf.
        They are exact, since every one is a sum of negative powers of 2.
    states
        uint8 of shape (L,): 0 unpainted, else the number of an extruder.

    Raises
    ------
    ValueError
        No such string.
    """
    leaves: list[Triangle] = []
    states: list[int] = []
    digits = iter([int(digit, 16) for digit in reversed(painting)])
    open_: list[Triangle] = [_WHOLE]
    while open_:
        triangle = open_.pop()
        node = _next(digits, painting)
        upper, split = node >> 2, node & 3
        if split:
            if upper == _EXTENDED:
                raise ValueError(f"{_shown(painting)} splits a triangle from a corner it lacks")
            open_ += _children(split, _TURNS[upper], triangle)
        else:
            leaves.append(triangle)
            states.append(_next(digits, painting) + _EXTENDED if upper == _EXTENDED else upper)
    if next(digits, None) is not None:
        raise ValueError(f"{_shown(painting)} has more digits than its tree has nodes")
    return np.array(leaves), np.array(states, np.uint8)


def _next(digits: Iterator[int], painting: str) -> int:
    digit = next(digits, None)
    if digit is None:
        raise ValueError(f"{_shown(painting)} has fewer digits than its tree has nodes")
    return digit


def _children(split: int, turn: tuple[int, int, int], triangle: Triangle) -> list[Triangle]:
    """Return the triangles into which one is split, counted from its corner ``turn[0]``."""
    a, b, c = (triangle[corner] for corner in turn)
    if split == 1:
        bc = _middle(b, c)
        return [(a, b, bc), (bc, c, a)]
    ab, ca = _middle(a, b), _middle(c, a)
    if split == 2:
        return [(a, ab, ca), (ab, b, ca), (b, c, ca)]
    bc = _middle(b, c)
    return [(a, ab, ca), (ab, b, bc), (bc, c, ca), (ab, bc, ca)]


def _middle(p: Corner, q: Corner) -> Corner:
    return (p[0] + q[0]) / 2, (p[1] + q[1]) / 2, (p[2] + q[2]) / 2


def _shown(painting: str) -> str:
    return repr(painting if len(painting) <= 20 else painting[:20] + "…")
