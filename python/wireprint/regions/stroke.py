"""A stroke of a brush along a surface."""

from collections.abc import Iterator
from typing import Annotated, Literal, Self

import numpy as np
import numpy.typing as npt
from pydantic import Field, model_validator

from wireprint.regions.shapes import LEAST_VECTOR, Flags, Floats, Length, Point, Shape

Indices = npt.NDArray[np.intp]

#: Most points of one stroke: minutes of a mouse that is never lifted.
MOST_POINTS = 10_000


class Stroke(Shape):
    """All points near a polyline whose own normal agrees with the stroke's.

    It is swept by a ball, so it is round at its ends. The normals keep paint from bleeding through
    a thin wall: there the other side is near, but faces away.
    """

    noun = "stroke"
    kind: Literal["stroke"] = "stroke"
    points_mm: Annotated[tuple[Point, ...], Field(min_length=1, max_length=MOST_POINTS)]
    #: The surface's outward normals: one for all points, or one for each.
    normals: Annotated[tuple[Point, ...], Field(min_length=1, max_length=MOST_POINTS)]
    radius_mm: Length
    spread_deg: float = Field(
        80.0,
        gt=0,
        le=180,
        description="between normals that agree; the next face of a box is at 90",
    )

    @model_validator(mode="after")
    def _normals_have_directions(self) -> Self:
        if len(self.normals) not in (1, len(self.points_mm)):
            raise ValueError("normals must be one, or as many as points_mm")
        if (np.linalg.norm(self.normals, axis=1) < LEAST_VECTOR).any():
            raise ValueError("one of the normals has no direction")
        return self

    def _covered(self, points: Floats, normals: Floats) -> Flags:
        covered = np.zeros(len(points), np.bool_)
        ends = np.asarray(self.points_mm)
        low, high = ends.min(axis=0) - self.radius_mm, ends.max(axis=0) + self.radius_mm
        # Most points are out of reach of all of it, and need not even be sorted.
        order = np.arange(len(points))
        for axis in (2, 1, 0):
            at = points[order, axis]
            order = order[(at >= low[axis]) & (at <= high[axis])]
        order = order[np.argsort(points[order, 0], kind="stable")]
        points, normals = points[order], normals[order]
        swept = np.zeros(len(points), np.bool_)
        for ends, facing in self._segments():
            near = self._near(points, ends)
            near = near[~swept[near]]
            swept[near] = self._swept(points[near], normals[near], ends, facing)
        covered[order] = swept
        return covered

    def _near(self, points: Floats, ends: Floats) -> Indices:
        """Return which of the points, sorted by x, lie in the box around a capsule."""
        low, high = ends.min(axis=0) - self.radius_mm, ends.max(axis=0) + self.radius_mm
        first = int(np.searchsorted(points[:, 0], low[0]))
        end = int(np.searchsorted(points[:, 0], high[0], "right"))
        _, y, z = points[first:end].T
        inside = (y >= low[1]) & (y <= high[1]) & (z >= low[2]) & (z <= high[2])
        found: Indices = np.flatnonzero(inside) + first
        return found

    def _segments(self) -> Iterator[tuple[Floats, Floats]]:
        """Yield both ends of each segment, and the unit normals there; a lone point is one."""
        ends = np.asarray(self.points_mm)
        facing = np.asarray(self.normals) / np.linalg.norm(self.normals, axis=1, keepdims=True)
        facing = np.broadcast_to(facing, ends.shape)
        for index in range(max(len(ends) - 1, 1)):
            pair = [index, min(index + 1, len(ends) - 1)]
            yield ends[pair], facing[pair]

    def _swept(self, points: Floats, normals: Floats, ends: Floats, facing: Floats) -> Flags:
        """Tell which points are near one segment and agree with it."""
        run, offset = ends[1] - ends[0], points - ends[0]
        squared = run @ run
        along = np.clip(offset @ run / squared, 0, 1) if squared > 0 else np.zeros(len(points))
        near = np.square(offset - along[:, None] * run).sum(axis=1) <= self.radius_mm**2
        wanted = facing[0] + along[:, None] * (facing[1] - facing[0])
        length = np.maximum(np.linalg.norm(wanted, axis=1), LEAST_VECTOR)
        agreement = (wanted * normals).sum(axis=1) / length
        agrees: Flags = near & (agreement >= np.cos(np.radians(self.spread_deg)))
        return agrees
