"""How fast a machine can move, and where its axes end: ``[motion]`` and ``[homing]``.

``[motion]`` keeps the names that Klipper and ``--limits`` files use: mm, mm/s and mm/s² throughout.
"""

# No `from __future__ import annotations` here: pydantic would have to evaluate every one of
# them, which costs more than the rest of this module.

from typing import Annotated, Literal

from pydantic import Field

from wireprint.bounds import Accel, CornerSpeed, Length, Speed
from wireprint.settings.section import Section

#: A coordinate, mm: ends of axes may lie beside the bed.
Place = Annotated[float, Field(ge=-5000, le=5000)]
StepsPerMm = Annotated[float, Field(ge=0.01, le=1e5)]
SpeedPerAxis = Annotated[tuple[Speed, Speed, Speed, Speed], Field(description="X, Y, Z, E")]
AccelPerAxis = Annotated[tuple[Accel, Accel, Accel, Accel], Field(description="X, Y, Z, E")]
StepsPerAxis = tuple[StepsPerMm, StepsPerMm, StepsPerMm, StepsPerMm]


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
