"""What falls with strands that are left out of a print, told from the strands around them.

To judge a whole print again for each strand that hung on the last one takes long. A piece of it
is judged in its place, once as it was and once without what is left out: only what is to blame in
the second alone falls, for at the piece's edges much seems to hang in the air.
"""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Final

import numpy as np

if TYPE_CHECKING:
    from collections.abc import Callable

    import numpy.typing as npt

    from wireprint._core import Wireframe

    Floats = npt.NDArray[np.float64]
    Ints = npt.NDArray[np.int64]
    Judge = Callable[[Wireframe], dict[int, list[int]]]

#: A piece reaches so many strands' diameters beyond what is left out, …
_REACH: Final = 16.0
#: … and serves as long as nothing falls that is farther than this part of it away.
_INNER: Final = 0.5
#: A piece that holds more than this part of the strands is no quicker to judge than the print.
_MOST: Final = 0.5


def falling(
    strands: Wireframe,
    dropped: list[int],
    strand_mm: float,
    judge: Judge,
    rounds: int,
    most_mm: float = math.inf,
) -> tuple[list[int], int]:
    """Find what hangs on strands that are left out, what hangs on that, and so on.

    Parameters
    ----------
    strands
        The print.
    dropped
        Numbers of strands that are left out.
    strand_mm
        Diameter of a strand, mm.
    judge
        Tells the numbers of the strands of a print that are to blame for breaches, by the number
        of the strand that breaks a rule.
    rounds
        Most times that something may be found to fall.
    most_mm
        Where more than this is left out, mm, it need not be known what else falls.

    Returns
    -------
    tuple
        Numbers of all that is left out, ascending, and how many rounds found something.
    """
    piece: _Piece | None = None
    for number in range(rounds):
        if piece is None:
            piece = _Piece.around(strands, dropped, _REACH * strand_mm, judge)
        if piece is None:
            return dropped, number
        fresh = piece.fallen(dropped, judge)
        if not len(fresh):
            return dropped, number
        dropped = sorted({*dropped, *fresh.tolist()})
        if length_mm(strands.strands[dropped]) > most_mm:
            return dropped, number + 1
        if not piece.holds(fresh):
            piece = None
    return dropped, rounds


def length_mm(ends: Floats) -> float:
    """Return the length of all strands of (N, 2, 3), mm."""
    return float(np.sum(np.linalg.norm(ends[:, 1] - ends[:, 0], axis=1)))


class _Piece:
    """Some of a print's strands."""

    def __init__(self, strands: Wireframe, numbers: Ints, inner: Ints) -> None:
        #: Their numbers in the print, and those that are well within the piece, ascending.
        self.numbers, self.inner = numbers, inner
        others = np.setdiff1d(np.arange(strands.strand_count), numbers)
        self.strands = strands.beyond(others.tolist())
        #: What seems to break a rule in it as it is, by its numbers in the print.
        self.seeming: set[int] = set()

    @classmethod
    def around(
        cls,
        strands: Wireframe,
        dropped: list[int],
        reach_mm: float,
        judge: Judge,
    ) -> _Piece | None:
        """Take what is near to some strands; None where that is much of the print."""
        ends = strands.strands
        numbers = _near(ends, dropped, reach_mm)
        if len(numbers) > _MOST * len(ends):
            return None
        piece = cls(strands, numbers, _near(ends, dropped, _INNER * reach_mm))
        piece.seeming = {int(numbers[one]) for one in judge(piece.strands)}
        return piece

    def fallen(self, dropped: list[int], judge: Judge) -> Ints:
        """Return the numbers in the print of what falls with what is left out of it."""
        gone = np.isin(self.numbers, dropped)
        left = self.strands.beyond(np.flatnonzero(gone).tolist())
        kept = self.numbers[~gone]
        found = [
            kept[numbers]
            for one, numbers in judge(left).items()
            if int(kept[one]) not in self.seeming
        ]
        return np.unique(np.concatenate([*found, np.zeros(0, np.int64)]))

    def holds(self, numbers: Ints) -> bool:
        """Tell whether strands are well within the piece."""
        return bool(np.isin(numbers, self.inner).all())


def _near(ends: Floats, dropped: list[int], reach_mm: float) -> Ints:
    """Return the strands whose boxes come within a distance of those of others, ascending."""
    low, high = ends.min(axis=1) - reach_mm, ends.max(axis=1) + reach_mm
    begin, end = low[dropped] + reach_mm, high[dropped] - reach_mm
    # Those that are left out stand together: few strands near to one are not near to those before.
    rest = np.flatnonzero(((low <= end.max(axis=0)) & (high >= begin.min(axis=0))).all(axis=1))
    found = []
    for first, last in zip(begin, end, strict=True):
        near = ((low[rest] <= last) & (high[rest] >= first)).all(axis=1)
        found.append(rest[near])
        rest = rest[~near]
    return np.sort(np.concatenate(found))
