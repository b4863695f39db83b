"""Many lines in flat arrays."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Self

import numpy as np
import shapely

if TYPE_CHECKING:
    import numpy.typing as npt

    from wireprint.layerwise.areas import Geometries


@dataclass(frozen=True)
class Lines:
    """Lines in a plane, open or closed."""

    #: Points of all lines, mm, shape (P, 2); a closed line does not repeat its first.
    points: npt.NDArray[np.float64]
    #: Line i has the points ``offsets[i]:offsets[i + 1]``, shape (N + 1,).
    offsets: npt.NDArray[np.int64]
    #: What each line belongs to, shape (N,).
    owner: npt.NDArray[np.int64]
    #: Whether the last point joins the first.
    closed: bool

    @classmethod
    def empty(cls) -> Self:
        """Return no lines at all."""
        return cls(np.zeros((0, 2)), np.zeros(1, np.int64), np.zeros(0, np.int64), closed=False)

    @classmethod
    def rims(cls, areas: Geometries, *, holes: bool = True) -> Self:
        """Return every ring around the areas, or the outer ones alone."""
        parts, origin = shapely.get_parts(areas, return_index=True)
        if holes:
            rings, of_part = shapely.get_rings(parts, return_index=True)
        else:
            rings, of_part = shapely.get_exterior_ring(parts), np.arange(len(parts))
        kept = ~shapely.is_empty(rings)
        rings, owner = rings[kept], origin[of_part[kept]]
        points, ring = shapely.get_coordinates(rings, return_index=True)
        is_last = np.append(ring[1:] != ring[:-1], True)[: len(ring)]
        sizes = np.bincount(ring, minlength=len(rings)) - 1
        offsets = np.concatenate([[0], np.cumsum(sizes)])
        return cls(points[~is_last], offsets, owner, closed=True)

    def __len__(self) -> int:
        """Return the number of lines."""
        return len(self.owner)

    def lengths_mm(self) -> npt.NDArray[np.float64]:
        """Length of each line, mm, shape (N,)."""
        if not len(self):
            return np.zeros(0)
        following = np.arange(1, len(self.points) + 1)
        following[self.offsets[1:] - 1] = self.offsets[:-1]
        steps = np.hypot(*(self.points[following] - self.points).T)
        if not self.closed:
            steps[self.offsets[1:] - 1] = 0.0
        return np.add.reduceat(steps, self.offsets[:-1])
