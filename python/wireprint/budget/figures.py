"""What a print may take, and what one that was tried comes to."""

from __future__ import annotations

import math
from dataclasses import dataclass

from wireprint._core import SettingError, UnprintableError
from wireprint.duration import duration


class BudgetError(UnprintableError):
    """No certified print keeps within the budget."""


@dataclass(frozen=True, slots=True)
class Budget:
    """What a print may take."""

    #: Time, s; None: any.
    time_s: float | None = None
    #: Filament, g; None: any.
    filament_g: float | None = None

    def __post_init__(self) -> None:
        """Refuse what is no budget."""
        for name in self.__slots__:
            value = getattr(self, name)
            if value is not None and not (math.isfinite(value) and value > 0):
                raise SettingError(f"a budget's {name} is {value}; it must be positive")

    def excess(self, print_time_s: float, filament_g: float) -> float:
        """Tell how many times over the budget a print is.

        Parameters
        ----------
        print_time_s, filament_g
            What the print takes.

        Returns
        -------
        float
            At most 1 is within; 0 where nothing is limited.
        """
        pairs = ((print_time_s, self.time_s), (filament_g, self.filament_g))
        return max((found / most for found, most in pairs if most is not None), default=0.0)

    def __str__(self) -> str:
        """Say what it is."""
        parts = [] if self.time_s is None else [duration(self.time_s)]
        parts += [] if self.filament_g is None else [f"{self.filament_g:g} g"]
        return " and ".join(parts) or "no limit"


@dataclass(frozen=True, slots=True)
class Alternative:
    """One print that was made and judged."""

    #: What of the settings it has otherwise, as ``--set`` takes it.
    overrides: tuple[str, ...]
    print_time_s: float
    #: Filament that it takes, g.
    filament_g: float
    #: Mean distance of the strands from the surface, relaxed to chords, mm.
    deviation_mm: float
    #: By how much at most 95 % of the posts give way to the nozzle's pull, mm.
    give_mm: float
    #: Share of the outer surface that is covered.
    coverage: float
    #: Whether it keeps within the budget.
    within: bool
    #: Whether it is the one that is printed.
    chosen: bool = False

    def beats(self, other: Alternative) -> bool:
        """Tell whether it is at least as good in everything, and better in something.

        Parameters
        ----------
        other
            Another print of the same model.

        Returns
        -------
        bool
            In time, deviation and give.
        """
        mine, theirs = self._figures(), other._figures()
        return mine != theirs and all(a <= b for a, b in zip(mine, theirs, strict=True))

    def _figures(self) -> tuple[float, float, float]:
        return self.print_time_s, self.deviation_mm, self.give_mm
