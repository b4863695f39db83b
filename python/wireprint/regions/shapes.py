"""Shapes that mark a region: solids that hold points, whatever their normals."""

from collections.abc import Callable
from typing import Annotated, ClassVar, Literal, Self

import numpy as np
import numpy.typing as npt
from pydantic import BaseModel, ConfigDict, Field, model_validator

from wireprint._core import SettingError

Floats = npt.NDArray[np.float64]
Flags = npt.NDArray[np.bool_]

#: A coordinate: a hundred times the largest bed, and far from where numbers lose their micrometres.
Coordinate = Annotated[float, Field(ge=-1e5, le=1e5, allow_inf_nan=False)]
Length = Annotated[float, Field(gt=0, le=1e5, allow_inf_nan=False)]
Point = tuple[Coordinate, Coordinate, Coordinate]
#: Length below which a vector has no direction.
LEAST_VECTOR = 1e-9


class Shape(BaseModel):
    """What a mark covers; immutable."""

    model_config = ConfigDict(frozen=True, extra="forbid", defer_build=True)

    #: What people call one.
    noun: ClassVar[str] = "mark"

    def __eq__(self, other: object) -> bool:
        """Whether the other one is of the same kind and says the same."""
        if type(self) is not type(other):
            return NotImplemented
        return all(
            np.array_equal(getattr(self, name), getattr(other, name))
            for name in type(self).model_fields
        )

    def __hash__(self) -> int:
        """Return what equal shapes share: their fields may be arrays, which have no hash."""
        return hash(type(self))

    def covers(self, points: Floats, normals: Floats) -> Flags:
        """Tell which points the shape covers.

        Parameters
        ----------
        points, normals
            See `wireprint.regions.Region.covers`.

        Returns
        -------
        numpy.ndarray
            bool of shape (N,).
        """
        return self._covered(points, normals)

    def _covered(self, points: Floats, normals: Floats) -> Flags:
        raise NotImplementedError


class Box(Shape):
    """A box along the axes, its faces included."""

    noun = "box"
    kind: Literal["box"] = "box"
    low_mm: Point
    high_mm: Point

    @model_validator(mode="after")
    def _corners_in_order(self) -> Self:
        if any(low > high for low, high in zip(self.low_mm, self.high_mm, strict=True)):
            raise ValueError("low_mm exceeds high_mm")
        return self

    def _covered(self, points: Floats, normals: Floats) -> Flags:
        inside = (points >= self.low_mm) & (points <= self.high_mm)
        return inside[:, 0] & inside[:, 1] & inside[:, 2]


class Sphere(Shape):
    """A ball, its surface included."""

    noun = "ball"
    kind: Literal["sphere"] = "sphere"
    centre_mm: Point
    radius_mm: Length

    def _covered(self, points: Floats, normals: Floats) -> Flags:
        squared: Floats = np.square(points - self.centre_mm).sum(axis=1)
        return squared <= self.radius_mm**2


class HalfSpace(Shape):
    """All points p with normal · p ≥ offset, the normal taken as a unit vector."""

    noun = "half-space"
    kind: Literal["half"] = "half"
    normal: Point
    offset_mm: Coordinate = Field(description="distance of the plane from x = y = z = 0")

    @model_validator(mode="after")
    def _normal_has_a_direction(self) -> Self:
        if np.linalg.norm(self.normal) < LEAST_VECTOR:
            raise ValueError("normal has no direction")
        return self

    def _covered(self, points: Floats, normals: Floats) -> Flags:
        ahead: Floats = points @ (np.asarray(self.normal) / np.linalg.norm(self.normal))
        return ahead >= self.offset_mm


class ZRange(Shape):
    """All points between two heights, both included; an end that is None is open."""

    noun = "heights"
    kind: Literal["z"] = "z"
    low_mm: Coordinate | None = None
    high_mm: Coordinate | None = None

    @model_validator(mode="after")
    def _ends_in_order(self) -> Self:
        if self.low_mm is not None and self.high_mm is not None and self.low_mm > self.high_mm:
            raise ValueError("low_mm exceeds high_mm")
        return self

    def _covered(self, points: Floats, normals: Floats) -> Flags:
        height = points[:, 2]
        inside = np.ones(len(points), np.bool_)
        if self.low_mm is not None:
            inside &= height >= self.low_mm
        if self.high_mm is not None:
            inside &= height <= self.high_mm
        return inside


class Predicate(Shape):
    """Whatever a function of points says; cannot be written to a file."""

    #: float64 points of shape (N, 3), mm → bool of shape (N,).
    function: Callable[[Floats], npt.ArrayLike]

    def _covered(self, points: Floats, normals: Floats) -> Flags:
        covered = np.asarray(self.function(points))
        if covered.dtype != np.bool_ or covered.shape != (len(points),):
            msg = (
                f"the predicate gave dtype {covered.dtype} and shape {covered.shape} for "
                f"{len(points)} points; it must give a bool for each"
            )
            raise SettingError(msg)
        return covered
