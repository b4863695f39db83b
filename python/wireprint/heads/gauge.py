"""A gauge of the head: teeth that tell the flank's angle, roofs that tell the cone's height.

All that is touched is a lone strand, and each only by the one descent beside it that is to try it.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING, Final

from wireprint import _core
from wireprint._core import SettingError

if TYPE_CHECKING:
    from collections.abc import Iterator

    from wireprint.settings import Settings
    from wireprint.settings.head import Head

#: Teeth are so many degrees apart, and this many of them lie below and above the profile's angle.
#: Of 3 mm, the flank bends a tooth by 0.3 mm at 32° if it is one step flatter than the tooth.
STEP_DEG: Final = 2.5
BELOW, ABOVE = 4, 5
#: No head is flatter or steeper (bounds of `head.slant_deg`).
FLATTEST_DEG, STEEPEST_DEG = 5.0, 85.0
#: Teeth are as high as this share of the cone: a block that hangs half as low would miss them.
TOOTH: Final = 0.55
#: Roofs begin at this share of the cone and rise by the other: 0.8 mm of 5 mm.
FIRST_ROOF, ROOF_STEP, MOST_ROOFS = 0.7, 0.15, 6
#: Roofs are no higher than this share of where the carriage begins.
BELOW_CARRIAGE: Final = 0.9
#: Fewer roofs tell too little.
FEWEST_ROOFS: Final = 2


@dataclass(frozen=True)
class Gauge:
    """What a gauge tries, by the head that it was made for."""

    head: Head
    #: Angle at which each tooth stands beside the tip, degrees, ascending.
    teeth_deg: tuple[float, ...]
    #: Height of each roof over the tip, mm, ascending; none where no roof fits below the block.
    roofs_mm: tuple[float, ...]

    @classmethod
    def of(cls, head: Head) -> Gauge:
        """Return the gauge of a head."""
        angles = (head.slant_deg + STEP_DEG * i for i in range(-BELOW, ABOVE + 1))
        teeth = tuple(round(a, 2) for a in angles if FLATTEST_DEG <= a <= STEEPEST_DEG)
        most = BELOW_CARRIAGE * head.carriage_height_mm
        cone = head.cone_height_mm
        heights = (round(cone * (FIRST_ROOF + ROOF_STEP * i), 3) for i in range(MOST_ROOFS))
        gauge = cls(head, teeth, ())
        fitting = tuple(
            h for h in heights if h <= most and gauge.beside_roof_mm(h) <= head.block_radius_mm
        )
        return cls(head, teeth, fitting if len(fitting) >= FEWEST_ROOFS else ())

    @property
    def tooth_mm(self) -> float:
        """How far a tooth rises over the tip beside it, mm."""
        return TOOTH * self.head.cone_height_mm

    @property
    def wary(self) -> Head:
        """A head flatter than any that the teeth tell, which the print alone must not touch."""
        slant = max(FLATTEST_DEG, self.teeth_deg[0] - STEP_DEG)
        return _with(self.head, slant, self.head.cone_height_mm)

    @property
    def supposed(self) -> Head:
        """The slimmest head that the gauge can tell: one that touches none of it."""
        slant = max(self.teeth_deg[-1], self.head.slant_deg)
        return _with(self.head, slant, max(self.head.cone_height_mm, *self.roofs_mm, 0.0))

    @property
    def pitch_mm(self) -> float:
        """How far posts stand apart, mm: a diagonal from one to the next clears a flat head."""
        # A tooth begins below the tip that tries it, by half a strand.
        high = self.tooth_mm + self.head.nozzle_mm
        return float(_core.stroke_run(self.wary.model_dump(), self.head.nozzle_mm, high))

    def beside_tooth_mm(self, degrees: float) -> float:
        """Distance from a tooth's axis at which a flank of this angle would just touch it, mm."""
        return self._beside(self.tooth_mm, degrees)

    def beside_roof_mm(self, height: float) -> float:
        """Distance from a roof at which no flank touches it that is at most a step flatter, mm."""
        return self._beside(height, max(FLATTEST_DEG, self.head.slant_deg - STEP_DEG))

    def _beside(self, height: float, degrees: float) -> float:
        flank = self.head.tip_radius_mm + height / math.tan(math.radians(degrees))
        return flank + self.head.nozzle_mm / 2

    def words(self) -> Iterator[str]:
        """Say what each tooth and roof tells, and which go beyond the profile."""
        head = self.head
        for number, angle in enumerate(self.teeth_deg, start=1):
            beyond = ", beyond the profile" if angle > head.slant_deg else ""
            yield f"tooth {number}: {angle:g} deg{beyond}"
        for number, height in enumerate(self.roofs_mm, start=1):
            beyond = ", beyond the profile" if height > head.cone_height_mm else ""
            yield f"roof {number}: {height:g} mm{beyond}"
        if not self.roofs_mm:
            yield "no roofs: the flank reaches as far as the block; measure C by hand"


def _with(head: Head, slant_deg: float, cone_mm: float) -> Head:
    """Return a head with another cone, and all above it wide and high enough for it."""
    flank = head.tip_radius_mm + cone_mm / math.tan(math.radians(slant_deg))
    block = max(head.block_radius_mm, math.ceil(flank * 100) / 100)
    return head.model_copy(
        update={
            "slant_deg": slant_deg,
            "cone_height_mm": cone_mm,
            "block_radius_mm": block,
            "carriage_radius_mm": max(head.carriage_radius_mm, block),
            "carriage_height_mm": max(head.carriage_height_mm, cone_mm),
        }
    )


def answered(settings: Settings, answer: str) -> dict[str, float]:
    """Return measures B and C from the first tooth and the first roof that were touched.

    Parameters
    ----------
    settings
        Those that the gauge was made with.
    answer
        ``TOOTH,ROOF``, each from 1; 0 where none was touched. The last that was *not* touched is
        what the head is known to clear.

    Raises
    ------
    SettingError
        It is no such answer, or even the first was touched.
    """
    gauge = Gauge.of(settings.printer.head)
    teeth, roofs = gauge.teeth_deg, gauge.roofs_mm
    try:
        tooth, roof = (int(word) for word in answer.split(","))
    except ValueError:
        msg = f"--gauge {answer}: expected TOOTH,ROOF, two numbers, 0 where none was touched"
        raise SettingError(msg) from None
    given = {"B": _last_free(tooth, teeth, "tooth")}
    if roofs or roof:
        given["C"] = _last_free(roof, roofs, "roof")
    return given


def _last_free(first: int, steps: tuple[float, ...], what: str) -> float:
    if not 0 <= first <= len(steps):
        msg = f"--gauge: there is no {what} {first}; this printer's gauge has {len(steps)}"
        raise SettingError(msg)
    if first == 1:
        key = "head.slant_deg" if what == "tooth" else "head.cone_height_mm"
        msg = (
            f"--gauge: even {what} 1 ({steps[0]:g}) was touched: {key} is known to be "
            f"less; print another gauge with --set {key}={0.7 * steps[0]:.3g}"
        )
        raise SettingError(msg)
    return steps[first - 2] if first else steps[-1]
