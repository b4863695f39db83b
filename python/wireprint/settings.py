"""Every knob of wireprint: its unit, its bounds, its default and where the default comes from.

Units stand in the names: ``_mm``, ``_mm_s``, ``_mm3_s``, ``_s``, ``_c``, ``_deg``. The one
exception is ``[motion]``, which keeps the names that Klipper and ``--limits`` files use
(mm, mm/s and mm/s² throughout).
"""

# No `from __future__ import annotations` here: pydantic would have to evaluate every one of
# them, which costs more than the rest of this module.

import math
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any, Final, Literal, Self

from pydantic import (
    AfterValidator,
    BaseModel,
    BeforeValidator,
    ConfigDict,
    Field,
    field_validator,
    model_validator,
)

from wireprint.bounds import (
    Accel,
    BedSize,
    CarriageHeight,
    CarriageReach,
    CornerSpeed,
    Length,
    Speed,
)
from wireprint.choices import (
    CoolingMethod,
    Flavor,
    Pattern,
    Placement,
    Strategy,
    Supports,
    TypeWords,
)
from wireprint.cooling import cooling_s
from wireprint.gcode import sequence

if TYPE_CHECKING:
    from collections.abc import Iterable, Mapping

    from wireprint.keys import Key

# The bounds of other figures are in `wireprint.bounds`.
Millimetres = Annotated[float, Field(ge=0.1, le=2000)]
Height = Annotated[float, Field(ge=0, le=5000, description="above the bed, mm")]
#: A coordinate of a part of the head, seen from the tip, mm.
FromTip = Annotated[float, Field(ge=-500, le=500)]
PartBottom = Annotated[
    float, Field(ge=0.1, le=300, description="height above the tip at which it begins, mm")
]
#: A coordinate, mm: ends of axes may lie beside the bed.
Place = Annotated[float, Field(ge=-5000, le=5000)]
StepsPerMm = Annotated[float, Field(ge=0.01, le=1e5)]
LayerHeight = Annotated[float, Field(ge=0.02, le=2)]
PrintSpeed = Annotated[float, Field(ge=0.1, le=1000)]
TravelSpeed = Annotated[float, Field(ge=0.1, le=2000)]
#: mm³/s; None: the printer's.
Flow = Annotated[float, Field(ge=0.01, le=500)] | None
Pixels = Annotated[int, Field(ge=8, le=2000)]
#: Share of what a hot end melts that is asked for: coordinates of three decimals shorten a strand
#: of a twentieth of a millimetre by so much, and its flow rises with that.
_ROUNDED: Final = 0.97
#: Width, height, and how the picture is written: PNG where that is not said.
Thumbnail = tuple[Pixels, Pixels] | tuple[Pixels, Pixels, Literal["PNG", "QOI"]]
SpeedPerAxis = Annotated[tuple[Speed, Speed, Speed, Speed], Field(description="X, Y, Z, E")]
AccelPerAxis = Annotated[tuple[Accel, Accel, Accel, Accel], Field(description="X, Y, Z, E")]
StepsPerAxis = tuple[StepsPerMm, StepsPerMm, StepsPerMm, StepsPerMm]


def _one_printable_line(name: str) -> str:
    """Refuse what would end a comment in G-code, or that a terminal would obey."""
    if not name.isprintable():
        raise ValueError("a name is one line of printable characters")
    return name


#: Written into comments of G-code, onto pages and into terminals.
Name = Annotated[str, Field(min_length=1, max_length=100), AfterValidator(_one_printable_line)]


def _auto_is_none(value: object) -> object:
    """Take the word for what None means."""
    return None if value == "auto" else value


#: s; None, or "auto": until a strand holds.
Pause = Annotated[float | None, BeforeValidator(_auto_is_none)]


#: A strand bears the nozzle's pull from a little above its glass transition on: a model of a
#: bending rod gives 4 to 14 K for all three materials.
_HOLDS_ABOVE_GLASS_K = 5.0


class Section(BaseModel):
    """A group of settings: immutable, and no key passes that it does not know."""

    # A group's own validator is built only if it is used by itself: half the time at start.
    model_config = ConfigDict(frozen=True, extra="forbid", allow_inf_nan=False, defer_build=True)


class Bed(Section):
    """The build volume."""

    shape: Literal["round", "rectangular"] = Field(description="round: a delta's, mostly")
    diameter_mm: BedSize | None = Field(None, description="of a round bed")
    width_mm: BedSize | None = Field(None, description="of a rectangular bed, along x")
    depth_mm: BedSize | None = Field(None, description="of a rectangular bed, along y")
    height_mm: BedSize = Field(description="greatest z of the tip")
    origin: Literal["centre", "corner"] = Field(description="where x = y = 0 lies")

    @model_validator(mode="after")
    def _has_the_sizes_of_its_shape(self) -> Self:
        given = {
            name
            for name in ("diameter_mm", "width_mm", "depth_mm")
            if getattr(self, name) is not None
        }
        wanted = {"diameter_mm"} if self.shape == "round" else {"width_mm", "depth_mm"}
        if given != wanted:
            msg = f"a {self.shape} bed has {' and '.join(sorted(wanted))}"
            raise ValueError(msg)
        return self

    @property
    def size_mm(self) -> tuple[float, float]:
        """Extent along x and y, mm."""
        if self.diameter_mm is not None:
            return self.diameter_mm, self.diameter_mm
        return self.width_mm or 0.0, self.depth_mm or 0.0

    def __str__(self) -> str:
        """Say how large it is."""
        width, depth = self.size_mm
        plan = f"{width:g} mm across" if self.shape == "round" else f"{width:g} × {depth:g} mm"
        return f"{plan}, {self.height_mm:g} mm high"

    @property
    def centre_mm(self) -> tuple[float, float]:
        """The bed's centre in the machine's coordinates, mm."""
        if self.origin == "centre":
            return 0.0, 0.0
        width, depth = self.size_mm
        return width / 2, depth / 2


class HeadBox(Section):
    """A part of the head as a box, such as a fan duct or a shroud; seen from the tip."""

    shape: Literal["box"]
    x_mm: tuple[FromTip, FromTip] = Field(description="where it begins and ends along x")
    y_mm: tuple[FromTip, FromTip] = Field(description="where it begins and ends along y")
    bottom_mm: PartBottom
    turn_deg: float = Field(
        0.0,
        ge=-360,
        le=360,
        description="how far x_mm and y_mm are turned about the nozzle, anticlockwise from above",
    )

    @model_validator(mode="after")
    def _has_an_extent(self) -> Self:
        for key in ("x_mm", "y_mm"):
            low, high = getattr(self, key)
            if not low < high:
                msg = f"{key} ends at {high:g}, where it must lie beyond {low:g}"
                raise ValueError(msg)
        return self

    def __str__(self) -> str:
        """Say what it is and where."""
        (left, right), (front, back) = self.x_mm, self.y_mm
        turned = f", turned by {self.turn_deg:g}°" if self.turn_deg else ""
        plan = f"x {left:g} to {right:g}, y {front:g} to {back:g}{turned}"
        return f"box {plan}, {self.bottom_mm:g} mm up"


class HeadCylinder(Section):
    """A part of the head as an upright cylinder, such as a probe; seen from the tip."""

    shape: Literal["cylinder"]
    centre_mm: tuple[FromTip, FromTip] = Field(description="x and y of its axis")
    radius_mm: float = Field(ge=0.1, le=200)
    bottom_mm: PartBottom

    def __str__(self) -> str:
        """Say what it is and where."""
        x, y = self.centre_mm
        return f"cylinder of {self.radius_mm:g} mm at x {x:g}, y {y:g}, {self.bottom_mm:g} mm up"


#: What of a head is not round about its nozzle.
HeadPart = Annotated[HeadBox | HeadCylinder, Field(discriminator="shape")]


class Head(Section):
    """The nozzle and everything above it: a body of revolution, and parts that are not round.

    All of it opens upwards: what is above a part's bottom counts as part.
    """

    nozzle_mm: float = Field(ge=0.05, le=5, description="diameter of the opening")
    tip_radius_mm: float = Field(ge=0.025, le=10, description="radius of the flat tip")
    slant_deg: float = Field(
        ge=5, le=85, description="the flank's angle from the horizontal; the steepest descent"
    )
    cone_height_mm: float = Field(
        ge=0.1, le=100, description="height above the tip at which the heater block begins"
    )
    block_radius_mm: float = Field(
        ge=0.1, le=200, description="reach of heater block and fan ducts"
    )
    carriage_height_mm: CarriageHeight = Field(
        description="height above the tip at which the carriage begins"
    )
    carriage_radius_mm: CarriageReach = Field(description="reach of the carriage")
    parts: tuple[HeadPart, ...] = Field(
        (), max_length=16, description="fan ducts, probes, shrouds: what is not round"
    )

    @model_validator(mode="after")
    def _opens_upwards(self) -> Self:
        if self.tip_radius_mm < self.nozzle_mm / 2:
            raise ValueError("tip_radius_mm is smaller than half of nozzle_mm")
        if self.carriage_height_mm < self.cone_height_mm:
            raise ValueError("carriage_height_mm lies below cone_height_mm")
        if not self.tip_radius_mm <= self.block_radius_mm <= self.carriage_radius_mm:
            raise ValueError("a head widens upwards: tip, then block, then carriage")
        return self


class Marlin(Section):
    """Limits as Marlin, Repetier and RepRapFirmware keep them, per axis."""

    max_velocity: SpeedPerAxis = Field(description="M203, mm/s: X, Y, Z, E")
    max_accel: AccelPerAxis = Field(description="M201, mm/s²: X, Y, Z, E")
    print_accel: Accel = Field(description="M204 P, mm/s²")
    travel_accel: Accel = Field(description="M204 T, mm/s²")
    retract_accel: Accel = Field(description="M204 R, mm/s²")
    jerk: tuple[CornerSpeed, CornerSpeed, CornerSpeed, CornerSpeed] | None = Field(
        None, description="M205 X Y Z E, mm/s; None: junction deviation"
    )
    junction_deviation: Length = Field(0.013, description="mm; Marlin 2.1's default")
    steps_per_mm: StepsPerAxis | None = Field(None, description="M92: X, Y, Z, E")


class Motion(Section):
    """Limits of the machine under the names of Klipper (mm, mm/s, mm/s²)."""

    max_velocity: Speed
    max_accel: Accel
    square_corner_velocity: CornerSpeed = Field(5.0, description="Klipper's default")
    minimum_cruise_ratio: float = Field(0.5, ge=0, lt=1, description="Klipper's default")
    max_z_velocity: Speed
    max_z_accel: Accel
    max_extrude_only_velocity: Speed
    max_extrude_only_accel: Accel
    instantaneous_corner_velocity: CornerSpeed = Field(1.0, description="Klipper's default")
    arc_resolution: Length = Field(1.0, description="mm; Klipper's default")
    delta_radius: Length | None = Field(None, description="mm; delta: effector to tower")
    arm_length: Length | None = Field(None, description="mm; delta: diagonal rod")
    print_radius: Length | None = Field(
        None, description="mm; delta: as in Klipper's tables; the bed's size counts here"
    )
    step_distance: Length | None = Field(None, description="mm; delta: travel of one microstep")
    endstop_height: Length | None = Field(None, description="mm; delta: tip over bed after G28")
    bed_moves_x: bool = Field(False, description="the bed moves along x, and the print with it")
    bed_moves_y: bool = Field(False, description="the bed moves along y, and the print with it")
    marlin: Marlin | None = Field(None, description="the same for Marlin and its relatives")


class Homing(Section):
    """What G28 does on a machine with an axis each for x, y and z; a delta climbs to its ends."""

    x_mm: Place | None = Field(None, description="where x is home; None: the bed's low edge")
    y_mm: Place | None = Field(None, description="where y is home; None: the bed's low edge")
    z_end: Literal["bed", "top"] = Field(
        "bed", description="bed: x, y, then z down to the bed; top: z first, up to bed.height_mm"
    )
    lift_mm: float = Field(
        0.0, ge=0, le=500, description="z is raised to this height before x and y are homed"
    )
    z_place_mm: tuple[Place, Place] | None = Field(
        None, description="x and y where z is homed; None: wherever the head is"
    )


class Extruder(Section):
    """What feeds the filament."""

    filament_diameter_mm: float = Field(ge=1, le=4, description="as it is sold: 1.75 or 2.85")
    retract_mm: float = Field(ge=0, le=20, description="pulled back before a travel; 0: never")
    retract_speed_mm_s: float = Field(ge=0.1, le=200, description="of pulling back")
    unretract_speed_mm_s: float = Field(ge=0.1, le=200, description="of pushing forward again")
    max_flow_mm3_s: float = Field(ge=0.01, le=200, description="what the hot end melts")
    pressure_lag_s: float = Field(
        0.0,
        ge=0,
        le=5,
        description="of the flow behind the feed, as the firmware's own test tells; 0: not minded",
    )


class Speeds(Section):
    """How fast the head moves."""

    print_mm_s: float = Field(
        ge=0.1, le=500, description="along strands; 30 is the paper's optimum with a 1 s pause"
    )
    travel_mm_s: float = Field(ge=0.1, le=1000, description="of the head without extruding")
    first_layer_mm_s: float = Field(ge=0.1, le=500, description="along strands that lie on the bed")


class AirSpeed(Section):
    """Speed of the air across a strand, mm/s, by cooling method."""

    none: float = Field(0.0, ge=0, le=1e5, description="still air")
    fan: float = Field(3000.0, ge=0, le=1e5, description="a part fan's, estimated")
    valve: float = Field(
        10000.0, ge=0, le=1e5, description="air jets'; with it the paper's pause of 1 s comes out"
    )


class Cooling(Section):
    """What solidifies a floating strand."""

    method: CoolingMethod = Field(
        description="valve: air jets switched by M42; fan: the part fan; none: a longer pause"
    )
    valve_pin: int | None = Field(
        None, ge=0, le=100000, description="number of the valve's pin for M42"
    )
    valve_output: str = Field(
        "wire_air", pattern=r"^\w+$", description="the valve's [output_pin] under Klipper"
    )
    air_mm_s: AirSpeed = Field(default_factory=AirSpeed)


class Macro(Section):
    """What a macro of the printer's configuration does, as the certificate judges it."""

    name: str = Field(pattern=r"^[A-Za-z_]{2}\w*$", max_length=100)
    gcode: str = Field(max_length=4000, description="its moves as G-code; it calls no macros")


class Gcode(Section):
    """The dialect, and what comes before and after the print."""

    flavor: Flavor = Field(description="firmware that reads the G-code")
    relative_extrusion: bool = Field(True, description="M83, not M82")
    type_words: TypeWords = Field(
        "own",
        description="what ;TYPE: says: what strands are for, or PrusaSlicer's role that comes "
        "nearest, which its viewer can colour; ours is a comment of its own then",
    )
    pressure_advance: bool = Field(
        True,
        description="the firmware minds the pressure lag if its flavour can; off: old versions",
    )
    firmware_retraction: bool = Field(
        False, description="G10 and G11, not moves of E; the firmware must know how far"
    )
    thumbnails: tuple[Thumbnail, ...] = Field(
        ((32, 32), (300, 300)),
        max_length=20,
        description="width and height of the pictures in the header, and QOI where that is read",
    )
    start: str = Field(
        description="heats and homes; may use {nozzle_c}, {bed_c}, and the print's edges on the "
        "bed, {min_x_mm}, {min_y_mm}, {max_x_mm}, {max_y_mm}"
    )
    end: str = Field(description="cools and parks; may use {park_z_mm}, 10 mm above the print")
    macros: tuple[Macro, ...] = Field(
        (), max_length=50, description="macros that files use; others are not judged in a print"
    )

    @field_validator("start")
    @classmethod
    def _start_uses_known_names(cls, text: str) -> str:
        sequence.check(text, sequence.START_NAMES)
        return text

    @field_validator("end")
    @classmethod
    def _end_uses_known_names(cls, text: str) -> str:
        sequence.check(text, sequence.END_NAMES)
        return text


class Printer(Section):
    """A machine: ``profiles/printers/*.toml``."""

    name: Name = Field(description="what the profile is called")
    known_as: tuple[str, ...] = Field(
        (), max_length=50, description="what slicers call it in the files that they write"
    )
    kinematics: Literal["delta", "cartesian", "corexy"] = Field(
        description="how motors move the head; a cartesian's or corexy's axes are limited each"
    )
    bed: Bed
    head: Head
    motion: Motion
    homing: Homing = Field(default_factory=Homing)
    extruder: Extruder
    speeds: Speeds
    cooling: Cooling
    gcode: Gcode

    @model_validator(mode="after")
    def _a_delta_knows_its_geometry(self) -> Self:
        motion = self.motion
        needed = ("delta_radius", "arm_length", "step_distance", "endstop_height")
        missing = [name for name in needed if getattr(motion, name) is None]
        if self.kinematics == "delta" and missing:
            msg = f"a delta needs motion.{missing[0]}"
            raise ValueError(msg)
        return self


class Material(Section):
    """A filament: ``profiles/materials/*.toml``."""

    name: Name = Field(description="what the profile is called")
    density_g_cm3: float = Field(gt=0.5, le=10, description="of the filament")
    price_per_kg: float = Field(ge=0, le=1e6, description="in the user's currency")
    nozzle_c: int = Field(ge=100, le=500, description="temperature of the nozzle")
    bed_c: int = Field(ge=0, le=200, description="temperature of the bed")
    glass_c: float = Field(ge=-50, le=400, description="glass transition")
    hold_c: float | None = Field(
        None,
        ge=-45,
        le=450,
        description="temperature at which a strand bears the nozzle's pull; None: glass_c + 5",
    )
    air_c: float = Field(25.0, ge=-20, le=100, description="temperature around the print")
    specific_heat_j_kgk: float = Field(gt=100, le=5000, description="between nozzle and hold")
    conductivity_w_mk: float = Field(ge=0.01, le=10, description="of heat, W/(m·K)")
    modulus_mpa: float = Field(
        2200.0, ge=1, le=1e6, description="Young's, of the cold material; ABS unless told"
    )
    strength_mpa: float = Field(
        35.0, ge=0.1, le=1e4, description="of a cold strand, drawn or bent; ABS unless told"
    )
    melt_viscosity_pa_s: float = Field(
        3000.0, ge=1, le=1e7, description="in shear, at the nozzle's temperature; estimated"
    )
    plateau_modulus_pa: float = Field(
        2e5, ge=1, le=1e9, description="of the entangled melt, in shear; estimated"
    )
    draw: float = Field(
        1.1, ge=1, le=2, description="by which the nozzle draws a strand out; a harp tells it"
    )

    @model_validator(mode="after")
    def _cools_from_nozzle_through_hold_to_air(self) -> Self:
        if not self.air_c < self.holding_c < self.nozzle_c:
            name = "glass_c + 5" if self.hold_c is None else "hold_c"
            msg = f"{name} must lie between air_c and nozzle_c"
            raise ValueError(msg)
        return self

    @property
    def holding_c(self) -> float:
        """Temperature at which a strand bears the nozzle's pull, °C."""
        return self.glass_c + _HOLDS_ABOVE_GLASS_K if self.hold_c is None else self.hold_c

    def solidify_s(self, strand_mm: float, air_mm_s: float) -> float:
        """Time in which a strand cools until it holds, s.

        Parameters
        ----------
        strand_mm
            Diameter of the strand, mm.
        air_mm_s
            Speed of the air across it, mm/s.
        """
        return cooling_s(
            strand_mm,
            self.nozzle_c,
            self.holding_c,
            air_c=self.air_c,
            air_mm_s=air_mm_s,
            density_g_cm3=self.density_g_cm3,
            specific_heat_j_kgk=self.specific_heat_j_kgk,
            conductivity_w_mk=self.conductivity_w_mk,
        )


class Wire(Section):
    """How a model becomes strands. ``None`` means: follows from the printer."""

    slab_min_mm: Millimetres | None = Field(
        None, description="lowest slab; None: 2 nozzle diameters (paper: 1.4)"
    )
    slab_max_mm: Millimetres | None = Field(
        None, description="highest slab; None: the head's cone height (paper: 6)"
    )
    low_slabs_mm: tuple[Height, Height, Millimetres] | None = Field(
        None, description="from one height to another no slab is higher than so; slice --forecast"
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
    coverage_within_mm: float = Field(
        4.0, ge=0.1, le=50, description="surface this near to a strand counts as covered"
    )


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


class Settings(Section):
    """One printer, one material, one way of wiring.

    Examples
    --------
    >>> settings = Settings.load(material="abs", overrides=["head.slant_deg=40"])
    >>> settings.printer.head.slant_deg
    40.0
    >>> round(settings.pause_s, 1)
    1.0
    """

    printer: Printer
    material: Material
    wire: Wire = Field(default_factory=Wire)
    layerwise: Layerwise = Field(default_factory=Layerwise)
    regions: Regions = Field(default_factory=Regions)
    calibration: Calibration | None = Field(None, description="None: nothing was measured")

    @model_validator(mode="after")
    def _a_valve_has_a_pin(self) -> Self:
        cooling, flavor = self.printer.cooling, self.printer.gcode.flavor
        if cooling.method == "valve" and cooling.valve_pin is None and flavor != "klipper":
            msg = f"cooling.method is valve: {flavor} needs cooling.valve_pin, the pin of the valve"
            raise ValueError(msg)
        return self

    @model_validator(mode="after")
    def _slabs_have_a_range(self) -> Self:
        if self.slab_min_mm > self.slab_max_mm:
            msg = (
                f"wire.slab_min_mm ({self.slab_min_mm:g}) exceeds "
                f"wire.slab_max_mm ({self.slab_max_mm:g})"
            )
            raise ValueError(msg)
        if self.slab_max_mm > self.printer.head.cone_height_mm:
            msg = (
                f"wire.slab_max_mm ({self.slab_max_mm:g}) exceeds "
                f"head.cone_height_mm ({self.printer.head.cone_height_mm:g}): "
                "the heater block would hit the posts"
            )
            raise ValueError(msg)
        return self

    @property
    def strand_mm(self) -> float:
        """Diameter of a strand, mm: as wide as the nozzle, unless more is fed."""
        return self.printer.head.nozzle_mm * math.sqrt(self.wire.flow)

    @property
    def slab_min_mm(self) -> float:
        """Lowest slab, mm."""
        return self.wire.slab_min_mm or min(2 * self.strand_mm, self.printer.head.cone_height_mm)

    @property
    def slab_max_mm(self) -> float:
        """Highest slab, mm."""
        return self.wire.slab_max_mm or self.printer.head.cone_height_mm

    @property
    def first_layer_height_mm(self) -> float:
        """Height of the tip over the bed where strands lie on it, mm."""
        return self.wire.first_layer_height_mm or self.strand_mm / 2

    @property
    def print_mm_s(self) -> float:
        """Speed along strands, mm/s: as asked for, but no faster than the hot end melts."""
        return min(self.printer.speeds.print_mm_s, self._melting_mm_s)

    @property
    def first_layer_mm_s(self) -> float:
        """Speed along strands on the bed, mm/s: likewise."""
        return min(self.printer.speeds.first_layer_mm_s, self._melting_mm_s)

    @property
    def _melting_mm_s(self) -> float:
        """Speed at which a strand takes all that the hot end melts, mm/s."""
        section_mm2 = math.pi / 4 * self.strand_mm**2
        return _ROUNDED * self.printer.extruder.max_flow_mm3_s / section_mm2

    @property
    def pause_s(self) -> float:
        """Pause at the end of a floating stroke, s: as asked for, as measured, or as computed."""
        if self.wire.pause_s is not None:
            return self.wire.pause_s
        calibration = self.calibrated_by()
        return self.solidify_s if calibration is None else calibration.pause_s

    def calibrated_by(self) -> Calibration | None:
        """Return the calibration, if it was measured with what these settings are.

        Returns
        -------
        Calibration or None
            What was measured; None where nothing was, or for another strand or temperature.
        """
        known = self.calibration
        if known is None or self.wire.flow != 1.0:
            return None
        then = (round(known.strand_mm, 6), known.nozzle_c, known.method)
        cooling = self.printer.cooling
        now = (round(self.strand_mm, 6), self.material.nozzle_c, cooling.method)
        return known if then == now else None

    @property
    def solidify_s(self) -> float:
        """Time in which a strand cools until it holds, s; see `Material.solidify_s`."""
        cooling = self.printer.cooling
        air_mm_s: float = getattr(cooling.air_mm_s, cooling.method)
        return self.material.solidify_s(self.strand_mm, air_mm_s)

    @classmethod
    def load(
        cls,
        printer: str = "kossel-mini",
        material: str = "abs",
        load: "Iterable[str | Path]" = (),
        overrides: "Iterable[str]" = (),
        nozzle_mm: float | None = None,
    ) -> Self:
        """Compose settings from profiles, files and single keys; later ones win.

        Parameters
        ----------
        printer, material
            Name of a profile that comes with the package, or path of a TOML file.
        load
            TOML files with any of the tables ``[bed]`` … ``[gcode]``, ``[material]``, ``[wire]``.
        overrides
            ``key=value`` with a dotted key, such as ``head.slant_deg=40``.
        nozzle_mm
            Diameter of another nozzle than the printer's profile has; None: that one. What depends
            on it changes, too: `wireprint.nozzles.changed`.

        Raises
        ------
        SettingError
            Where a profile, key or value is wrong; it names key, file and line.
        """
        from wireprint import _compose

        return _compose.compose(cls, {}, printer, material, load, overrides, nozzle_mm)

    def but(
        self,
        printer: str | None = None,
        material: str | None = None,
        load: "Iterable[str | Path]" = (),
        overrides: "Iterable[str]" = (),
        nozzle_mm: float | None = None,
    ) -> Self:
        """Return these settings with others laid over them.

        Parameters
        ----------
        printer, material
            As for `load`; None keeps what these settings have.
        load, overrides, nozzle_mm
            As for `load`.

        Returns
        -------
        Settings
            New ones; these stay as they are.

        Raises
        ------
        SettingError
            See `load`.
        """
        from wireprint import _compose

        base = self.model_dump(mode="json")
        return _compose.compose(type(self), base, printer, material, load, overrides, nozzle_mm)

    @classmethod
    def from_mapping(cls, values: "Mapping[str, Any]") -> Self:
        """Validate a mapping of the form that ``model_dump`` gives.

        Parameters
        ----------
        values
            Tables by name, values by key.

        Returns
        -------
        Settings
            What they amount to.

        Raises
        ------
        SettingError
            Where a key or value is wrong.
        """
        from wireprint import _compose

        return _compose.validate(cls, values, {})

    def __repr__(self) -> str:
        """Say whose they are; ``model_dump()`` holds every value."""
        return f"<Settings {self.printer.name} with {self.material.name}>"

    __str__ = __repr__


def describe() -> "tuple[Key, ...]":
    """List every key that can be set, with its unit, bounds, default and help.

    Returns
    -------
    tuple of Key
        In the order of the settings; `Key.to_dict` gives values that JSON knows.

    Examples
    --------
    >>> {key.short: key.bounds for key in describe()}["head.slant_deg"]
    '5 … 85'
    """
    from wireprint.keys import described

    return described(Settings)
