"""How a model becomes strands: ``[wire]``."""

# No `from __future__ import annotations` here: pydantic would have to evaluate every one of
# them, which costs more than the rest of this module.

from typing import Annotated, Literal

from pydantic import BeforeValidator, Field

from wireprint.bounds import Accel
from wireprint.choices import Pattern, Placement, Strategy, Supports
from wireprint.settings.section import Millimetres, Section

Height = Annotated[float, Field(ge=0, le=5000, description="above the bed, mm")]


def _auto_is_none(value: object) -> object:
    """Take the word for what None means."""
    return None if value == "auto" else value


#: s; None, or "auto": until a strand holds.
Pause = Annotated[float | None, BeforeValidator(_auto_is_none)]


def _one_is_several(value: object) -> object:
    """Take one band for a list of one, and None for an empty one."""
    if value is None:
        return ()
    if isinstance(value, list | tuple) and value:
        is_one = not any(isinstance(one, list | tuple) for one in value)
        return [value] if is_one else value
    return value


#: Bands of heights, and how high slabs are there; one band may stand alone.
LowSlabs = Annotated[
    tuple[tuple[Height, Height, Millimetres], ...], BeforeValidator(_one_is_several)
]


class Wire(Section):
    """How a model becomes strands. ``None`` means: follows from the printer."""

    slab_min_mm: Millimetres | None = Field(
        None, description="lowest slab; None: 2 nozzle diameters (paper: 1.4)"
    )
    slab_max_mm: Millimetres | None = Field(
        None, description="highest slab; None: the head's cone height (paper: 6)"
    )
    low_slabs_mm: LowSlabs = Field(
        (),
        max_length=50,
        description="from one height to another no slab is higher than so; slice --forecast",
    )
    pattern: Pattern = Field(
        "zigzag", description="zigzag: contours and zigzag; peaks: the paper's figure 7c"
    )
    placement: Placement = Field(
        "optimal", description="of posts; paper: average of even spacing and nearest points"
    )
    deviation_target_mm: float = Field(
        0.3, ge=0.001, le=10, description="mean deviation at which a slab counts as twice its time"
    )
    strategy: Strategy = Field(
        "pause", description="against sagging strokes; the paper found pause the fastest"
    )
    pause_s: Pause = Field(
        None,
        ge=0,
        le=60,
        description="at the end of a floating stroke; None or auto: until it holds",
    )
    slow_mm_s: float = Field(
        5.0, ge=0.1, le=100, description="floating strokes under slow; CuraEngine's wire speed"
    )
    overshoot_mm: float = Field(
        0.5, ge=0, le=5, description="over-travel under overshoot; CuraEngine's fall-down"
    )
    first_layer_height_mm: float | None = Field(
        None,
        ge=0.02,
        le=5,
        description="tip over bed; None: half a nozzle, which squeezes a strand",
    )
    brim_rings: Annotated[int, Field(ge=0, le=50)] | Literal["auto"] = Field(
        "auto", description="flat rings about the first contours; auto: what a small foot wants"
    )
    skirt_rings: int = Field(1, ge=0, le=20, description="prime the nozzle; CuraEngine's default")
    skirt_gap_mm: float = Field(3.0, ge=0, le=50, description="CuraEngine's default")
    prime_mm: float = Field(
        5.0, ge=0, le=100, description="filament fed where the print starts; fills the nozzle"
    )
    bed_accel_mm_s2: Accel = Field(
        500.0, description="of a bed that moves, lest it sway the print; estimated"
    )
    travel_lift_mm: float = Field(
        1.0, ge=0, le=50, description="by which a travel clears what stands; two strands' worth"
    )
    flow: float = Field(
        1.0,
        ge=0.5,
        le=3,
        description="filament by what a strand as wide as the nozzle takes; 1.5: a fifth wider",
    )
    span_limit_mm: float = Field(
        65.0, ge=1, le=500, description="longest stretch held at both ends; the paper's 6.5 cm"
    )
    free_end_limit_mm: float = Field(
        20.0, ge=1, le=200, description="longest stretch held at one end; estimated"
    )
    pull_n: float = Field(
        0.01,
        ge=1e-4,
        le=10,
        description="of the nozzle on a post, N; computed for steady printing: 0.002-0.007",
    )
    caps: bool = Field(True, description="close flat faces; off: the paper's open look")
    cap_spacing_mm: float = Field(
        6.0, gt=0.5, le=50, description="between a cap's strands; keeps coverage_within_mm"
    )
    supports: Supports = Field("wire", description="under what would hang in air")
    coverage_min: float = Field(
        0.95, ge=0, le=1, description="share of the surface to be covered, else nothing is written"
    )
    coverage_goal: float = Field(
        0.99, ge=0, le=1, description="below it slabs are lower where it would be bare; 0: never"
    )
    braced_goal: float = Field(
        0.6, ge=0, le=1, description="diagonals per post; slabs are lower where few are; 0: never"
    )
    coverage_within_mm: float = Field(
        4.0, ge=0.1, le=50, description="surface this near to a strand counts as covered"
    )
