"""Numbers that are laid on the bed, so that what stands beside them is told apart."""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

from wireprint._core import KINDS

if TYPE_CHECKING:
    from wireprint.heads.gauge_path import Path

_SKIRT: Final = KINDS.index("skirt")

#: Digits as strokes through the corners of a box one wide and two high, each without lifting.
_DIGITS: Final[tuple[tuple[tuple[float, float], ...], ...]] = (
    ((0, 0), (1, 0), (1, 2), (0, 2), (0, 0)),
    ((0, 1.5), (0.5, 2), (0.5, 0)),
    ((0, 2), (1, 2), (1, 1), (0, 1), (0, 0), (1, 0)),
    ((0, 2), (1, 2), (1, 1), (0.3, 1), (1, 1), (1, 0), (0, 0)),
    ((0.8, 0), (0.8, 2), (0, 0.7), (1, 0.7)),
    ((1, 2), (0, 2), (0, 1), (1, 1), (1, 0), (0, 0)),
    ((1, 2), (0, 1), (0, 0), (1, 0), (1, 1), (0, 1)),
    ((0, 2), (1, 2), (0.3, 0)),
    ((0, 0), (1, 0), (1, 2), (0, 2), (0, 1), (1, 1), (0, 1), (0, 0)),
    ((1, 1), (0, 1), (0, 2), (1, 2), (1, 1), (0.5, 0)),
)
#: Width of a digit in strands, and room between two.
_WIDE: Final = 5.0
_BETWEEN: Final = 2.5


def size_mm(number: int, strand_mm: float) -> tuple[float, float]:
    """Return how wide and how high a number is."""
    count = len(str(number))
    return strand_mm * (count * _WIDE + (count - 1) * _BETWEEN), 2 * strand_mm * _WIDE


def lay(path: Path, number: int, at: tuple[float, float], base: float) -> None:
    """Lay a number on the bed; `at` is its lower left corner, mm."""
    strand = path.settings.strand_mm
    x, y = at
    for digit in str(number):
        corners = [(x + _WIDE * strand * a, y + _WIDE * strand * b) for a, b in _DIGITS[int(digit)]]
        path.go((*corners[0], base))
        for corner in corners[1:]:
            path.strand((*corner, base), _SKIRT)
        x += (_WIDE + _BETWEEN) * strand
