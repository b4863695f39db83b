"""Lines of layers on their way into printing order."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Self

import numpy as np
import shapely

from wireprint.layerwise.lines import Lines

if TYPE_CHECKING:
    import numpy.typing as npt

    from wireprint.layerwise.areas import Geometries

    Ints = npt.NDArray[np.int64]


@dataclass(frozen=True)
class Group:
    """Lines that are printed before those of the next group on the same place of a layer."""

    lines: Lines
    layer: Ints
    #: What each lies on: the number of an island, or −1.
    place: Ints
    #: Whether they lie behind the outer wall.
    is_inside: bool

    @property
    def strings(self) -> Geometries:
        """Its lines as line strings, which are open, shape (N,)."""
        sizes = np.diff(self.lines.offsets)
        indices = np.repeat(np.arange(len(sizes)), sizes)
        found: Geometries = shapely.linestrings(self.lines.points, indices=indices)
        return found

    @classmethod
    def of_strings(
        cls, strings: Geometries, layer: Ints, least_mm: float, *, is_inside: bool
    ) -> Self:
        """Return line strings, and pieces of them that are long enough, as open lines."""
        merged = shapely.line_merge(strings)
        parts, origin = shapely.get_parts(merged, return_index=True)
        long = (shapely.get_dimensions(parts) == 1) & (shapely.length(parts) >= least_mm)
        parts, origin = parts[long], origin[long]
        points, index = shapely.get_coordinates(parts, return_index=True)
        sizes = np.bincount(index, minlength=len(parts))
        offsets = np.concatenate([[0], np.cumsum(sizes)])
        place = np.full(len(origin), -1)
        lines = Lines(points, offsets, origin, closed=False)
        return cls(lines, layer[origin], place, is_inside)
