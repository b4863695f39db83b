"""What of a hybrid print no mark changes: kept from stroke to stroke, made once."""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING

import numpy as np
import shapely

from wireprint.hybrid.anchor import touchable_of
from wireprint.hybrid.cut import Cut, Samples, normals_of
from wireprint.hybrid.flats import level_points
from wireprint.hybrid.runs import Strips
from wireprint.layerwise.areas import buffered, of_contours
from wireprint.layerwise.recipe import Recipe
from wireprint.records import Record, sealed
from wireprint.stages import wireframe

if TYPE_CHECKING:
    import numpy.typing as npt

    from wireprint._core import Mesh, Touchable, Wireframe
    from wireprint.layerwise.areas import Geometries
    from wireprint.settings import Settings

    Floats = npt.NDArray[np.float64]
    Ints = npt.NDArray[np.int64]


@dataclass(frozen=True, repr=False)
class Sketch(Record):
    """A model and its plain wire print, divided into the layers that marks are printed in.

    Parts are made when they are first asked for. All of it is the same for any region, so one
    sketch serves all strokes on a model, and gives what a new one would.
    """

    #: The model as it stands on the bed.
    mesh: Mesh
    #: Its plain wire print.
    plain: Wireframe
    #: Printer, material, way of wiring and of printing regions.
    settings: Settings
    #: Whether lower slabs that cover more would be in it: the plain print was judged.
    judged: bool = True

    @classmethod
    def of(cls, mesh: Mesh, settings: Settings) -> Sketch:
        """Wire a model that stands on the bed."""
        return cls(mesh, wireframe(mesh, settings), settings)

    @cached_property
    def recipe(self) -> Recipe:
        """Widths and counts of the lines."""
        return Recipe.of(self.settings.regions, self.settings.printer, self.settings.strand_mm)

    @cached_property
    def cut(self) -> Cut:
        """The slabs, divided into layers."""
        return Cut.of(self.plain, self.mesh, self.settings.regions.layer_height_mm, self._strand_mm)

    @cached_property
    def areas(self) -> Geometries:
        """What the closed contours of each layer enclose; nobody may write to the array."""
        found = of_contours(self.cut, self.cut.closed, self.recipe.resolution_mm)
        return sealed(found)

    @cached_property
    def samples(self) -> Samples:
        """Points along the contours of all layers."""
        return Samples.of(self.cut, self._normals, self._strand_mm)

    @cached_property
    def strips(self) -> Strips:
        """The samples by the strip that they lie on."""
        born = {
            (slab, strip)
            for slab, strips in enumerate(self.plain.strips)
            for strip, (lower, _, _) in enumerate(strips)
            if not lower
        }
        least_mm = self.settings.regions.shortest_run * self._strand_mm
        # A stroke leans away from each end of a gap as steeply as the head allows.
        tip_mm = self.settings.printer.head.tip_radius_mm
        gap_mm = 2 * (tip_mm + self.heights_mm / self.slope)
        return Strips.of(self.cut, self.samples, born, least_mm, np.maximum(gap_mm, least_mm))

    @cached_property
    def level(self) -> tuple[Floats, Floats]:
        """Points on the model's level faces, and the unit normals there, shape (N, 3)."""
        return sealed(level_points(self.mesh, self._normals))

    @cached_property
    def heights_mm(self) -> Floats:
        """Heights of the slabs, mm."""
        return sealed(np.diff(self.plain.levels[:, 0]))

    @cached_property
    def touchable(self) -> Touchable:
        """Contours and rims that lines may begin on."""
        return touchable_of(self.cut, self._rims(), self._strand_mm)

    @cached_property
    def bed(self) -> shapely.Geometry:
        """What is solid on the bed, below the first layer."""
        area: shapely.Geometry = shapely.MultiPolygon()
        if not self.settings.wire.caps:
            return area
        above = self.plain.contours_above
        for number in np.flatnonzero(above["closed"][: above["slice_offsets"][1]]).tolist():
            points = above["points"][above["offsets"][number] : above["offsets"][number + 1]]
            ring = buffered(shapely.polygons(points), 0.0)
            area = shapely.symmetric_difference(area, ring)
        return area

    @property
    def slope(self) -> float:
        """Tangent of the steepest stroke down that the head leaves room for."""
        return math.tan(math.radians(self.settings.printer.head.slant_deg))

    @property
    def _strand_mm(self) -> float:
        return self.settings.strand_mm

    @cached_property
    def _normals(self) -> Floats:
        return normals_of(self.mesh)

    def _rims(self) -> tuple[Floats, Ints]:
        """Return the contours that begin the slabs above the bed as segments with their layers."""
        above = self.plain.contours_above
        points, offsets = above["points"], above["offsets"]
        following = np.arange(1, len(points) + 1)
        following[offsets[1:] - 1] = np.where(above["closed"], offsets[:-1], offsets[1:] - 1)
        slices = above["slice_offsets"]
        level = np.repeat(np.arange(len(slices) - 1), np.diff(slices)).repeat(np.diff(offsets))
        last = np.append(-1, np.flatnonzero(self.cut.is_last()))
        return np.stack([points, points[following]], axis=1), last[level]
