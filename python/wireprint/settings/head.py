"""The head of a printer: ``[head]``."""

# No `from __future__ import annotations` here: pydantic would have to evaluate every one of
# them, which costs more than the rest of this module.

from typing import Annotated, Literal, Self

from pydantic import Field, model_validator

from wireprint.bounds import CarriageHeight, CarriageReach
from wireprint.settings.section import Section

#: A coordinate of a part of the head, seen from the tip, mm.
FromTip = Annotated[float, Field(ge=-500, le=500)]
PartBottom = Annotated[
    float, Field(ge=0.1, le=300, description="height above the tip at which it begins, mm")
]


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
