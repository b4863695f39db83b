"""An axis with ticks at round figures."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING, Final

if TYPE_CHECKING:
    from collections.abc import Iterable

#: Steps between ticks that read well, in seconds; beyond: whole hours.
_TIME_STEPS_S: Final = (1, 2, 5, 10, 15, 30, 60, 120, 300, 600, 900, 1800, 3600, 7200, 14400, 36000)
#: The same of plain numbers, times powers of ten.
_STEPS: Final = (1.0, 2.0, 2.5, 5.0, 10.0)
#: Ticks at most.
_MOST: Final = 7
#: Room beside the least and the greatest value, as a share of what lies between.
_MARGIN: Final = 0.06


@dataclass(frozen=True)
class Axis:
    """From where to where, with a tick at each step."""

    low: float
    high: float
    step: float

    @classmethod
    def of_numbers(cls, values: Iterable[float]) -> Axis:
        """Return an axis about values that are not negative."""
        low, high = _bounds(values)
        power = 10.0 ** math.floor(math.log10((high - low) / (_MOST - 1)))
        return cls._of(low, high, [step * power for step in (*_STEPS, 20.0)])

    @classmethod
    def of_times(cls, seconds: Iterable[float]) -> Axis:
        """Return an axis about times, s: its ticks are whole seconds, minutes or hours."""
        low, high = _bounds(seconds)
        hours = [3600.0 * 10**power * step for power in range(2, 9) for step in (1, 2, 5)]
        return cls._of(low, high, [*map(float, _TIME_STEPS_S), *hours])

    @classmethod
    def _of(cls, low: float, high: float, steps: list[float]) -> Axis:
        axes = (
            cls(step * math.floor(low / step), step * math.ceil(high / step), step)
            for step in steps
        )
        return next(axis for axis in axes if len(axis.ticks) <= _MOST)

    @property
    def ticks(self) -> list[float]:
        """Where its ticks are, ascending."""
        count = round((self.high - self.low) / self.step)
        return [self.low + number * self.step for number in range(count + 1)]

    @property
    def decimals(self) -> int:
        """How many decimals tell one tick from the next."""
        return next(count for count in range(16) if _is_whole(self.step * 10**count))

    def share(self, value: float) -> float:
        """Return how far along the axis a value lies, 0 to 1."""
        return (value - self.low) / (self.high - self.low)


def _is_whole(value: float) -> bool:
    return abs(value - round(value)) < 1e-6 * max(abs(value), 1.0) and round(value) != 0


def _bounds(values: Iterable[float]) -> tuple[float, float]:
    """Return the least and the greatest with room beside them; never the same, never below 0."""
    found = list(values)
    low, high = min(found), max(found)
    room = max(_MARGIN * (high - low), 0.02 * high, 1e-6)
    return max(low - room, 0.0), high + room
