"""What was measured with one machine: ``[calibration]``."""

# No `from __future__ import annotations` here: pydantic would have to evaluate every one of
# them, which costs more than the rest of this module.

from pydantic import Field

from wireprint.choices import CoolingMethod
from wireprint.settings.section import Name, Section


class SagPoint(Section):
    """What a calibration says of level stretches of one length."""

    length_mm: float = Field(ge=1, le=500)
    sag_mm: float = Field(ge=1e-4, le=500)
    spread_mm: float = Field(ge=0, le=500, description="one standard deviation")


class Calibration(Section):
    """What prints of one machine told of its pause and its sags; ``wireprint calibrate fit``.

    It holds for what it was measured with: another strand, temperature or air asks for a new one.
    """

    date: Name = Field(description="day of the measurements, as 2026-11-27")
    measured: tuple[Name, ...] = Field(max_length=50, description="what, in words")
    strand_mm: float = Field(ge=0.05, le=5, description="diameter: the nozzle's, or wire.flow's")
    nozzle_c: float = Field(ge=100, le=500, description="of the nozzle measured with")
    method: CoolingMethod = Field(description="cooling measured with")
    print_mm_s: float = Field(ge=0.1, le=500, description="speed measured with")
    pause_s: float = Field(ge=1e-3, le=60, description="after which posts held")
    pause_spread_s: float = Field(ge=0, le=60, description="one standard deviation")
    bending_n_mm2: float | None = Field(
        None, ge=1e-4, le=1e6, description="bending stiffness of a strand, N·mm², by a mast"
    )
    bending_spread_n_mm2: float = Field(0.0, ge=0, le=1e6, description="one standard deviation")
    sags: tuple[SagPoint, ...] = Field(
        (), max_length=20, description="by length, the shortest first"
    )
