"""A machine and its dialect: ``profiles/printers/*.toml``."""

# No `from __future__ import annotations` here: pydantic would have to evaluate every one of
# them, which costs more than the rest of this module.

from typing import Annotated, Literal, Self

from pydantic import Field, field_validator, model_validator

from wireprint.bounds import BedSize
from wireprint.choices import CoolingMethod, Flavor, TypeWords
from wireprint.gcode import sequence
from wireprint.settings.head import Head
from wireprint.settings.motion import Homing, Motion
from wireprint.settings.section import Name, Section

Pixels = Annotated[int, Field(ge=8, le=2000)]
#: Width, height, and how the picture is written: PNG where that is not said.
Thumbnail = tuple[Pixels, Pixels] | tuple[Pixels, Pixels, Literal["PNG", "QOI"]]


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
