"""A budget in place of settings: the most faithful and stiffest print that keeps within it.

Slab heights, their spacing, the pattern and the distance of a cap's strands are searched over:
first a ladder of slab heights in each pattern, then the neighbours of the best print found so far,
until none is better. What is tried, and in which order, depends on model and settings alone.
"""

from __future__ import annotations

from dataclasses import asdict, dataclass
from typing import TYPE_CHECKING, Any

from wireprint.budget.figures import Alternative, Budget, BudgetError
from wireprint.budget.search import Search, fixed_knobs
from wireprint.pipeline import make

if TYPE_CHECKING:
    from collections.abc import Iterable

    from wireprint._core import Mesh
    from wireprint.regions import Region
    from wireprint.settings import Settings
    from wireprint.wire_print import WirePrint

__all__ = ["Alternative", "Budget", "BudgetError", "Budgeted", "within"]


@dataclass(frozen=True, repr=False)
class Budgeted:
    """The print that was chosen, and what it was chosen from."""

    made: WirePrint
    budget: Budget
    #: Prints that none of the others beats in time, deviation and stiffness alike, the fastest
    #: first.
    front: tuple[Alternative, ...]
    #: What stiffness was told by: ``growth``, the frame as it grows, or ``single posts``: each
    #: post as a cantilever by itself, where growth would take too much work.
    give_by: str
    #: Number of prints that were tried.
    tried: int

    def __repr__(self) -> str:
        """Say what was chosen."""
        return f"<Budgeted within {self.budget}: {self.made!r}, the best of {self.tried}>"

    @property
    def chosen(self) -> Alternative:
        """The print's own figures."""
        return next(one for one in self.front if one.chosen)

    def to_dict(self) -> dict[str, Any]:
        """Return everything as values that JSON knows.

        Returns
        -------
        dict
            The budget, what stiffness was told by, how many were tried, and the alternatives.
        """
        return {
            **asdict(self.budget),
            "give_by": self.give_by,
            "tried": self.tried,
            "alternatives": [
                asdict(one) | {"overrides": list(one.overrides)} for one in self.front
            ],
        }


def within(
    mesh: Mesh,
    settings: Settings,
    budget: Budget,
    region: Region | None = None,
    *,
    kept: Iterable[str] = (),
    **options: Any,
) -> Budgeted:
    """Make the most faithful and stiffest certified print that keeps within a budget.

    Parameters
    ----------
    mesh
        The model, placed.
    settings
        What holds besides: printer, material, and every knob that is not searched over. A knob that
        differs from its default there stays as it is.
    budget
        What it may take.
    region
        What is printed as layers, see `wireprint.make`.
    kept
        Keys of knobs that stay as they are although they have their defaults.
    **options
        For `wireprint.make`, once it is known what to make.

    Returns
    -------
    Budgeted
        Chosen is the print whose deviation, times how far its posts give way, is the least: a
        tenth less of the one outweighs a tenth more of the other.

    Raises
    ------
    BudgetError
        None keeps within it; the message names the least that was found.
    UnprintableError, ModelError
        See `wireprint.make`: no print that was tried is whole and keeps the rules.
    """
    search = Search(mesh, settings, budget, region, fixed_knobs(settings) | frozenset(kept))
    best = search.best_of_all()
    made = make(mesh, best.settings, region, **options)
    return Budgeted(made, budget, search.front(best), search.give_by, len(search.tried))
