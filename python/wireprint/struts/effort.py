"""How long a search may go on: counted, so that the same lattice gives the same file everywhere."""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

if TYPE_CHECKING:
    from collections.abc import Callable

#: Looks at struts, strokes and what they bar: about half a minute of a processor.
_WORK: Final = 15_000_000_000
#: Of that, what each round of a search gets at least: supports and what is left out ask for many.
_LEAST: Final = 1 / 8


class Effort:
    """What is left of the effort of a search, and who is told how far it is.

    Parameters
    ----------
    factor
        Of the usual effort, about half a minute of a processor.
    told
        Is called now and then with how many struts could be printed at most so far.
    """

    def __init__(self, factor: float = 1.0, told: Callable[[int], object] | None = None) -> None:
        self._left = self._whole = max(round(factor * _WORK), 1)
        self.watch = told
        #: Whether a search ended because it was spent.
        self.is_spent = False

    @property
    def work(self) -> int:
        """What the next round may spend."""
        return max(self._left, round(self._whole * _LEAST), 1)

    def spend(self, left: int) -> None:
        """Note what a round left of its `work`."""
        self._left = min(left, self._left)
        self.is_spent = left == 0
