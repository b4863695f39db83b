"""How layers are printed, in marked regions and for comparison: ``[regions]``, ``[layerwise]``."""

# No `from __future__ import annotations` here: pydantic would have to evaluate every one of
# them, which costs more than the rest of this module.

from typing import Annotated

from pydantic import Field

from wireprint.bounds import Accel, Speed
from wireprint.settings.section import Millimetres, Section

LayerHeight = Annotated[float, Field(ge=0.02, le=2)]
PrintSpeed = Annotated[float, Field(ge=0.1, le=1000)]
TravelSpeed = Annotated[float, Field(ge=0.1, le=2000)]
#: mm³/s; None: the printer's.
Flow = Annotated[float, Field(ge=0.01, le=500)] | None


class LayerProfile(Section):
    """How the slicer that wire prints are compared with prints layers."""

    layer_height_mm: LayerHeight = Field(0.2, description="with 0.7 mm: the paper's times")
    width_ratio: float = Field(
        1.125, ge=0.5, le=2, description="line width by nozzle; PrusaSlicer's automatic width"
    )
    perimeters: int = Field(2, ge=0, le=50, description="walls; PrusaSlicer at the paper's times")
    bottom_layers: int = Field(3, ge=0, le=100, description="solid; PrusaSlicer's default")
    top_layers: int = Field(3, ge=0, le=100, description="solid; PrusaSlicer's default")
    infill_density: float = Field(0.1, ge=0, le=1, description="the paper's 10 %")
    infill_overlap: float = Field(
        0.25, ge=0, le=1, description="of the fill with the wall, in line widths; PrusaSlicer's"
    )
    solid_below_mm2: float = Field(
        70.0, ge=0, le=10000, description="smaller sparse areas are solid; PrusaSlicer's default"
    )
    solid_anchor: float = Field(
        3.0, ge=0, le=20, description="solid reaches over sparse, in line widths; fits PrusaSlicer"
    )
    link_mm: float = Field(
        50.0, ge=0, le=1000, description="longest link between sparse lines; PrusaSlicer's default"
    )
    solid_link: float = Field(
        3.0, ge=0, le=20, description="longest link between solid lines, in their spacings"
    )
    seam_gap: float = Field(
        0.15, ge=0, le=1, description="a wall ends so far before its start, in nozzles; Slic3r's"
    )
    retract_over_mm: float = Field(
        2.0, ge=0, le=100, description="shorter travels do not retract; PrusaSlicer's default"
    )
    resolution_mm: float = Field(
        0.02, ge=0, le=1, description="by which simplified contours stray; a tenth of a layer"
    )
    print_mm_s: PrintSpeed = Field(40.0, description="reproduces the paper's 24:59")
    first_layer_mm_s: PrintSpeed = Field(30.0, description="PrusaSlicer's default")
    travel_mm_s: TravelSpeed = Field(150.0, description="at most the machine's limit")
    max_flow_mm3_s: Flow = Field(None, description="what the hot end melts; None: the printer's")


class Regions(LayerProfile):
    """How marked regions of a wire print are printed layer-wise."""

    width_ratio: float = Field(
        1.0, ge=0.5, le=1.2, description="line width by nozzle; a strand's, so that lines touch"
    )
    inset: float = Field(
        0.0,
        ge=0,
        le=0.5,
        description="of the outer wall's centre, in line widths; 0: flush with the wire",
    )
    shortest_run: float = Field(
        4.0, ge=1, le=100, description="shorter runs of a region are dropped, in strands; estimated"
    )


class FastProfile(LayerProfile):
    """A modern machine in a hurry; speeds as in Bambu Lab's profiles for its X1 and P1."""

    layer_height_mm: LayerHeight = Field(0.3, description="coarse for a 0.4 mm nozzle")
    print_mm_s: PrintSpeed = Field(270.0, description="as far as the hot end melts")
    first_layer_mm_s: PrintSpeed = Field(50.0, description="Bambu Lab's")
    travel_mm_s: TravelSpeed = Field(500.0, description="Bambu Lab's")
    max_flow_mm3_s: Flow = Field(20.0, description="a high-flow hot end; None: the printer's")
    printer: str = Field("voron-2.4", description="profile of the CoreXY that it runs on")
    max_velocity_mm_s: Speed = Field(500.0, description="in place of that profile's")
    max_accel_mm_s2: Accel = Field(10000.0, description="in place of that profile's")


class Frame(Section):
    """A model's edges as beams; the paper's layer-wise wireframe, its figure 16b."""

    beam_mm: float = Field(
        2.0, ge=0.1, le=50, description="width of a beam; reproduces the paper's 10:23"
    )
    sharp_deg: float = Field(
        30.0, gt=0, lt=180, description="an edge that bends more is a feature; Blender's default"
    )
    simplify_mm: float = Field(
        0.5, ge=0, le=10, description="by which a beam may leave the edges it stands for"
    )
    pitch_mm: Millimetres = Field(
        20.0, description="of rings and posts where a model bends without edges; estimated"
    )
    bridge_mm: Millimetres = Field(
        20.0, description="flatter beams up to this length need no strut; estimated"
    )


class Layerwise(LayerProfile):
    """What wire prints are compared with."""

    fast: FastProfile = Field(default_factory=FastProfile)
    frame: Frame = Field(default_factory=Frame)
