"""From a region to what the core needs to print it: runs, and the lines of their layers."""

from __future__ import annotations

import math
from dataclasses import dataclass, field, replace
from functools import cached_property
from typing import TYPE_CHECKING

import numpy as np
import shapely

from wireprint.hybrid.anchor import anchored
from wireprint.hybrid.beside import beside_wire
from wireprint.hybrid.depth import Inside
from wireprint.hybrid.flats import Flats
from wireprint.hybrid.lines import Laid, lay
from wireprint.hybrid.runs import Runs, Section, runs_of
from wireprint.records import Record
from wireprint.regions.inside import sections
from wireprint.stages import line_section_mm2

if TYPE_CHECKING:
    from collections.abc import Callable, Mapping

    import numpy.typing as npt

    from wireprint._core import _Layered, _Lids
    from wireprint.hybrid.cut import Cut, Samples
    from wireprint.hybrid.sketch import Sketch
    from wireprint.layerwise.areas import Geometries
    from wireprint.regions import Region
    from wireprint.settings import Settings


#: What stays hollow is told from this volume on, mm³: corners that are rounded come to less.
_SPECK_MM3 = 1.0
#: Fill is at most this part of a line's width away from what it fills.
_BESIDE = 0.5
#: Heights are written to 1 µm.
_ROUNDING_MM = 1e-3


@dataclass(frozen=True)
class Hollow:
    """What of a region's inside is not filled for one reason."""

    reason: str
    volume_mm3: float
    #: The lowest and the highest layer where it is missing, mm.
    low_mm: float
    high_mm: float


@dataclass(frozen=True, repr=False)
class Plan(Record):
    """What of a model is printed as layers, and how."""

    sketch: Sketch
    runs: Runs
    flats: Flats
    #: What lies inside the region on each layer, shape (K,).
    inside: Geometries
    #: Slabs in which the inside stays hollow, and why.
    hollow: Mapping[int, str] = field(default_factory=dict)
    #: Places where lines turned out to begin or end in the air, shape (P, 3), mm.
    loose: npt.NDArray[np.float64] = field(default_factory=lambda: np.zeros((0, 3)))

    @classmethod
    def of(cls, sketch: Sketch, region: Region) -> Plan:
        """Find what a region covers.

        Parameters
        ----------
        sketch
            The model and its layers.
        region
            What is marked, in the mesh's coordinates.
        """
        samples = sketch.samples
        runs = runs_of(sketch.strips, region.covers_known(samples.middle, samples.normal))
        points, normals = sketch.level
        flats = Flats(points, region.covers_known(points, normals))
        strand_mm = sketch.settings.strand_mm
        return cls(sketch, runs, flats, _inside(sketch.cut, runs, region, strand_mm))

    @property
    def cut(self) -> Cut:
        """The layers."""
        return self.sketch.cut

    @property
    def samples(self) -> Samples:
        """Points along the layers' contours."""
        return self.sketch.samples

    @property
    def settings(self) -> Settings:
        """Printer, material, way of wiring and of printing regions."""
        return self.sketch.settings

    @property
    def sections(self) -> tuple[Section, ...]:
        """Runs that are printed."""
        return self.runs.runs

    def without(self, numbers: Mapping[int, str], hollow: Mapping[int, str]) -> Plan:
        """Return the plan without the runs of some numbers, and hollow in some slabs, and why."""
        return replace(self, runs=self.runs.without(numbers), hollow={**hollow, **self.hollow})

    def avoiding(self, places_mm: npt.NDArray[np.float64]) -> Plan:
        """Return the plan whose lines neither begin nor end near some places, shape (P, 3)."""
        plan = replace(self, loose=np.concatenate([self.loose, places_mm]))
        # They are the same lines until they are anchored.
        vars(plan)["_lines"] = self._lines
        return plan

    @cached_property
    def laid(self) -> Laid:
        """All lines, each of which begins on something."""
        loose = self.loose[:, :2], self._layer_at(self.loose[:, 2])
        route = anchored(self._lines.route, self.sketch.touchable, loose)
        return replace(self._lines, route=route)

    @cached_property
    def _lines(self) -> Laid:
        """All lines, wherever they begin."""
        return self._lay(lambda _: None)

    def _lay(self, on_step: Callable[[str], None]) -> Laid:
        inset_mm = self.settings.regions.inset * self.sketch.recipe.width_mm
        return lay(self.sketch, self.runs, self._behind(), inset_mm, on_step)

    def _layer_at(self, z: npt.NDArray[np.float64]) -> npt.NDArray[np.int64]:
        """Return the layers at whose height some places lie, mm."""
        return np.minimum(np.searchsorted(self.cut.z, z - _ROUNDING_MM), len(self.cut.z) - 1)

    def _behind(self) -> Inside:
        """Return what of the region lies behind the surface, and what wire leaves of it."""
        painted = self.runs.of_sample >= 0
        reach_mm = self.sketch.heights_mm / self.sketch.slope
        tip_mm = self.settings.printer.head.tip_radius_mm
        wanted = np.unique(self.cut.slab[~shapely.is_empty(self.inside)])
        slabs = beside_wire(self.cut, self.samples, painted, wanted, reach_mm, tip_mm)
        is_had = ~np.isin(self.cut.slab, list(self.hollow))
        longest_mm = self.settings.wire.span_limit_mm
        return Inside(self.inside, slabs[self.cut.slab], is_had, self.sketch.bed, longest_mm)

    def filled_at(self, place_mm: npt.NDArray[np.float64]) -> int | None:
        """Return the slab in which fill behind walls lies at a place, if there is any."""
        layer = int(self._layer_at(place_mm[2:])[0])
        place, reach_mm = shapely.Point(place_mm[:2]), _BESIDE * self.sketch.recipe.width_mm
        # Walls reach further inwards than that, and are no fill.
        filled = self.laid.depth.filled[layer], self.laid.within_walls(layer)
        if shapely.dwithin(filled, place, reach_mm).any():
            return int(self.cut.slab[layer])
        return None

    def left_hollow(self) -> list[Hollow]:
        """Return what of the region's inside is not filled, by reason."""
        deep, given_up = self.laid.depth, [self.hollow.get(slab) for slab in self.cut.slab.tolist()]
        marked, clear, filled = (
            shapely.area(part) * self.cut.thickness
            for part in (deep.marked, deep.clear, deep.filled)
        )
        why = np.array([reason or "over_hollow" for reason in given_up])
        lost = [("beside_wire", marked - clear)]
        open_ = clear - filled + self.laid.open_mm2() * self.cut.thickness
        lost += [(reason, open_ * (why == reason)) for reason in np.unique(why).tolist()]
        parts = []
        for reason, volume in lost:
            layers = np.flatnonzero(volume > 0)
            if volume.sum() >= _SPECK_MM3:
                low, high = self.cut.z[layers[[0, -1]]].tolist()
                parts.append(Hollow(reason, float(volume[layers].sum()), low, high))
        return parts

    @property
    def filled_mm3(self) -> float:
        """Volume behind the walls of contours that are painted in part, that is filled."""
        return float(np.sum(shapely.area(self.laid.depth.filled) * self.cut.thickness))

    def _lids(self) -> _Lids:
        """Return the rings around what the last layers of slabs close."""
        parts, layer = shapely.get_parts(self.laid.lids, return_index=True)
        rings, part = shapely.get_rings(parts, return_index=True)
        points, ring = shapely.get_coordinates(rings, return_index=True)
        sizes = np.bincount(ring, minlength=len(rings))
        return {
            "lid_slabs": self.cut.slab[layer[part]],
            "lid_points": points,
            "lid_offsets": np.concatenate([[0], np.cumsum(sizes)]),
        }

    def layered(self, on_step: Callable[[str], None] = lambda _: None) -> _Layered | None:
        """Return what the core needs to know; None where nothing is layers.

        Parameters
        ----------
        on_step
            Called before each step of laying the lines with its name; it may raise to give up.
        """
        if "_lines" not in vars(self):
            vars(self)["_lines"] = self._lay(on_step)
        recipe, lines = self.sketch.recipe, self.laid.route
        if not (len(lines.group) or self.flats.marked.any()):
            return None
        layer = lines.layer[lines.offsets[:-1]]
        strand_mm2 = math.pi / 4 * self.settings.strand_mm**2
        thickness = self.cut.thickness.tolist()
        section_mm2 = np.array([line_section_mm2(recipe.width_mm, mm) for mm in thickness])
        whole = {(run.slab, run.strip) for run in self.sections if run.whole}
        partial = [run for run in self.sections if not run.whole]
        return {
            "strips": np.array(sorted(whole), np.int64).reshape(-1, 2),
            "stretches": np.array([(r.slab, r.contour) for r in partial], np.int64).reshape(-1, 2),
            "stretch_spans": np.array([(r.from_mm, r.length_mm) for r in partial]).reshape(-1, 2),
            "points": np.ascontiguousarray(lines.points),
            "offsets": lines.offsets,
            "line_slabs": self.cut.slab[layer],
            "line_flows": section_mm2[layer] / strand_mm2,
            "flats": self.flats.points,
            "flats_marked": self.flats.marked,
            "line_inside": lines.group > 0,
            **self._lids(),
        }


def _inside(cut: Cut, runs: Runs, region: Region, strand_mm: float) -> Geometries:
    """Cut the inside of a region on the layers of all slabs that have runs."""
    found: Geometries = np.full(len(cut.z), shapely.MultiPolygon(), dtype=object)
    layers = np.flatnonzero(np.isin(cut.slab, [run.slab for run in runs.runs]))
    if len(layers):
        bounds = np.stack([cut.points.min(axis=0), cut.points.max(axis=0)])
        found[layers] = sections(region, cut.z[layers], bounds, strand_mm)
    return found
