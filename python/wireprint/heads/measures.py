"""Four measures of a head, and what they mean for its prints."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING, Final

from wireprint import _core
from wireprint._core import SettingError
from wireprint.bounds import bounds_of
from wireprint.rules import faults_of

if TYPE_CHECKING:
    from collections.abc import Mapping

    from wireprint.settings import Settings
    from wireprint.settings.head import Head


@dataclass(frozen=True)
class Measure:
    """Something to be measured at a head."""

    letter: str
    #: Key of `[head]` that it sets.
    key: str
    unit: str
    #: What is measured, in words.
    words: str
    #: The key's value is the measure times this: a width is twice a radius.
    factor: float = 1.0

    def of(self, head: Head) -> float:
        """Return what would be measured at a head."""
        return float(getattr(head, self.key)) / self.factor

    def within(self, value: float, head: Head) -> float:
        """Return a measure that a head can have.

        Raises
        ------
        SettingError
            None can; it says what could be.
        """
        bounds = bounds_of(type(head).model_fields[self.key])
        least, most = (bound / self.factor for bound in bounds)
        if self.key == "tip_radius_mm":
            # Its rim is around the opening.
            least = max(least, head.nozzle_mm)
        if not least <= value <= most:
            msg = f"{self.letter} is {value:g} {self.unit}, but must lie within {least:g}–{most:g}"
            raise SettingError(msg)
        return value


#: In the order in which they are asked, each under its letter in the drawing.
MEASURES: Final = (
    Measure("A", "tip_radius_mm", "mm", "width of the nozzle's flat tip", 0.5),
    Measure("B", "slant_deg", "°", "angle of the line from the tip's rim along the nozzle's flank"),
    Measure("C", "cone_height_mm", "mm", "height of whatever is lowest around the nozzle"),
    Measure("D", "block_radius_mm", "mm", "reach of heater block, sock and duct from the axis"),
)

#: Figures of the carriage that are no less than those of the block.
_ABOVE: Final = {"carriage_radius_mm": "block_radius_mm", "carriage_height_mm": "cone_height_mm"}


def measured(settings: Settings, figures: Mapping[str, float]) -> tuple[Settings, dict[str, float]]:
    """Return settings whose head has these figures, and all figures that differ by that.

    Parameters
    ----------
    settings
        The printer, and the head as it was believed to be.
    figures
        By key of `[head]`, in its units. A carriage that they would overtake grows with them.

    Raises
    ------
    SettingError
        There is no such head.
    """
    head = settings.printer.head
    given = dict(figures)
    for upper, lower in _ABOVE.items():
        least = given.get(lower, getattr(head, lower))
        if getattr(head, upper) < least:
            given[upper] = least
    changed = settings.but(overrides=[f"head.{key}={value!r}" for key, value in given.items()])
    faults = faults_of(changed.printer.head)
    if faults:
        raise SettingError(f"{faults[0].partition(';')[0]}: measure B, C and D again")
    return changed, given


def meaning(settings: Settings, before: Settings) -> list[str]:
    """Say what a head means for wire prints, and what it meant before it was measured."""

    def slabs(of: Settings) -> tuple[float, float]:
        head = of.printer.head
        shape, strand = head.model_dump(), head.nozzle_mm
        tallest = _core.tallest_slab(shape, strand, of.slab_max_mm)
        return tallest, _core.stroke_run(shape, strand, tallest)

    (tallest, run), (tallest_before, run_before) = slabs(settings), slabs(before)
    head = settings.printer.head
    flank = head.tip_radius_mm + head.cone_height_mm / math.tan(math.radians(head.slant_deg))
    return [
        f"slabs       up to {tallest:.2f} mm high (before: {tallest_before:.2f} mm)",
        f"posts       {run:.2f} mm apart in such a slab (before: {run_before:.2f} mm)",
        f"reach       the flank reaches {flank:.2f} mm where the block begins; what is higher than "
        f"{head.cone_height_mm:g} mm must be {head.block_radius_mm:g} mm away",
        *(f"part        {part}" for part in head.parts),
    ]
