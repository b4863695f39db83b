"""From a region to what the core needs to print it: runs, and the lines of their layers."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

import numpy as np

from wireprint.hybrid.anchor import anchored
from wireprint.hybrid.cut import Cut, Samples, normals_of
from wireprint.hybrid.flats import Flats
from wireprint.hybrid.lines import route
from wireprint.hybrid.runs import Runs, Section, runs_of
from wireprint.layerwise.recipe import Recipe
from wireprint.layerwise.route import Route
from wireprint.stages import line_section_mm2

if TYPE_CHECKING:
    from collections.abc import Mapping

    import numpy.typing as npt

    from wireprint._core import Mesh, Wireframe, _Layered
    from wireprint.regions import Region
    from wireprint.settings import Settings


@dataclass(frozen=True)
class Plan:
    """What of a model is printed as layers, and how."""

    cut: Cut
    samples: Samples
    runs: Runs
    flats: Flats
    #: The contours that slabs begin with, as segments of shape (S, 2, 2), mm, and the layers that
    #: end at their heights, shape (S,).
    rims: tuple[npt.NDArray[np.float64], npt.NDArray[np.int64]]
    settings: Settings

    @classmethod
    def of(cls, mesh: Mesh, wireframe: Wireframe, region: Region, settings: Settings) -> Plan:
        """Find what a region covers.

        Parameters
        ----------
        mesh
            The model as it stands on the bed.
        wireframe
            Its plain wire print, whose slabs are divided.
        region
            What is marked, in the mesh's coordinates.
        settings
            Printer, and how regions are printed.
        """
        regions, strand_mm = settings.regions, settings.printer.head.nozzle_mm
        cut = Cut.of(wireframe, mesh, regions.layer_height_mm, strand_mm)
        samples = Samples.of(cut, mesh, strand_mm)
        covered = region.covers(samples.middle, samples.normal)
        born = {
            (slab, strip)
            for slab, strips in enumerate(wireframe.strips)
            for strip, (lower, _, _) in enumerate(strips)
            if not lower
        }
        least_mm = regions.shortest_run * strand_mm
        head = settings.printer.head
        # A stroke leans away from each end of the gap as steeply as the head allows.
        slope = math.tan(math.radians(head.slant_deg))
        gap_mm = 2 * (head.tip_radius_mm + np.diff(wireframe.levels[:, 0]) / slope)
        runs = runs_of(cut, samples, covered, born, least_mm, np.maximum(gap_mm, least_mm))
        flats = Flats.of(mesh, normals_of(mesh), region)
        return cls(cut, samples, runs, flats, _rims(cut, wireframe), settings)

    @property
    def sections(self) -> tuple[Section, ...]:
        """Runs that are printed."""
        return self.runs.runs

    def without(self, numbers: Mapping[int, str]) -> Plan:
        """Return the plan without the runs of some numbers, dropped for a reason each."""
        return replace(self, runs=self.runs.without(numbers))

    def layered(self) -> _Layered | None:
        """Return what the core needs to know; None where nothing is layers."""
        regions, printer = self.settings.regions, self.settings.printer
        recipe = Recipe.of(regions, printer)
        lines = route(self.cut, self.samples, self.runs, recipe, regions.inset * recipe.width_mm)
        if lines is None and not self.flats.marked.any():
            return None
        lines = lines or Route.empty()
        lines = anchored(lines, self.cut, self.rims, printer.head.nozzle_mm)
        layer = lines.layer[lines.offsets[:-1]]
        strand_mm2 = math.pi / 4 * printer.head.nozzle_mm**2
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
        }


def _rims(cut: Cut, wireframe: Wireframe) -> tuple[npt.NDArray[np.float64], npt.NDArray[np.int64]]:
    """Return the contours that begin the slabs above the bed as segments with their layers."""
    above = wireframe.contours_above
    points, offsets = above["points"], above["offsets"]
    following = np.arange(1, len(points) + 1)
    following[offsets[1:] - 1] = np.where(above["closed"], offsets[:-1], offsets[1:] - 1)
    slices = above["slice_offsets"]
    level = np.repeat(np.arange(len(slices) - 1), np.diff(slices)).repeat(np.diff(offsets))
    last = np.append(-1, np.flatnonzero(cut.is_last()))
    return np.stack([points, points[following]], axis=1), last[level]
