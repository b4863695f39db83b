"""From a planned wire print to the whole file and the verdict on it."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

from wireprint.certificate import check
from wireprint.stages import toolpath
from wireprint.whole_file import written_file
from wireprint.wholeness import is_as_wished, is_braced
from wireprint.wire_print import WirePrint

if TYPE_CHECKING:
    from datetime import datetime

    from wireprint._core import Toolpath, Wireframe
    from wireprint.certificate import Certificate
    from wireprint.clock import Clock
    from wireprint.fitting import Placed
    from wireprint.gcode.file import Written
    from wireprint.hybrid.prove import Proved
    from wireprint.hybrid.sketch import Sketch
    from wireprint.orientation import Orientation
    from wireprint.regions import Region
    from wireprint.settings import Settings
    from wireprint.standing import Standing
    from wireprint.verdict import Point


class NothingPlannedError(Exception):
    """A plan has not one strand."""


@dataclass(frozen=True)
class Finishing:
    """What a print is made with besides its plan and settings; see `wireprint.make`."""

    place: Placed
    orientation: Orientation | None
    #: In the coordinates of the placed mesh.
    region: Region | None
    #: What marks do not change, of an earlier print.
    kept: Sketch | None
    date: datetime | None
    clock: Clock
    certify: bool
    compare: bool
    weak: bool
    standing: Standing | None
    at_mm: Point
    #: Whether slabs may be made lower where the plan falls short.
    lower: bool

    def of(self, settings: Settings, planned: Wireframe) -> WirePrint:
        """Make the file of a plan, judge it, and mend it where it breaks the rules.

        Raises
        ------
        NothingPlannedError
            There is nothing to print.
        """
        if self.region and self.lower:
            other = self._replanned(settings, planned, None)
            if other is not None:
                return replace(self, lower=False, kept=None).of(*other)
        strands, regions = planned, self._regions(settings, planned)
        if regions is not None:
            strands = regions.wireframe
        if not strands.strand_count:
            raise NothingPlannedError
        with self.clock.stage("toolpath"):
            if regions is not None:
                path = regions.toolpath
            else:
                path = toolpath(strands, settings, self.standing, self.at_mm)
        with self.clock.stage("gcode"):
            gcode, estimate = self._written(path, settings) if regions is None else regions.written
        certificate = None
        if self.certify:
            with self.clock.stage("check"):
                if regions is None:
                    certificate = self._judged(gcode, settings)
                else:
                    certificate = regions.verdict.compared(self.place.mesh, deviation=self.compare)
            if self.lower and regions is None:
                other = self._replanned(settings, planned, certificate)
                if other is not None:
                    return replace(self, lower=False, kept=None).of(*other)
            if not certificate.ok:
                from wireprint.mending import mended

                with self.clock.stage("mend"):
                    left = mended(strands, certificate, settings, self.standing, self.at_mm)
                if left is not None:
                    strands = left
                    path = toolpath(left, settings, self.standing, self.at_mm)
                    gcode, estimate = mended_file = self._written(path, settings)
                    certificate = self._judged(gcode, settings)
                    regions = regions and replace(
                        regions,
                        wireframe=strands,
                        toolpath=path,
                        written=mended_file,
                        verdict=certificate,
                    )
        places = None
        if self.weak:
            from wireprint.weakness import find_weak

            with self.clock.stage("weak"):
                places = find_weak(gcode, settings)
        return WirePrint(
            settings,
            self.place.mesh,
            strands,
            path,
            regions,
            gcode,
            estimate,
            certificate,
            self.clock.timings_s,
            self.orientation,
            self.place.turn_deg,
            places,
            planned,
        )

    def _regions(self, settings: Settings, planned: Wireframe) -> Proved | None:
        if not self.region:
            return None
        from wireprint.hybrid.prove import proved
        from wireprint.hybrid.sketch import Sketch

        def written(path: Toolpath) -> Written:
            return self._written(path, settings)

        def draft(path: Toolpath) -> Written:
            return self._written(path, settings, pictures=False)

        with self.clock.stage("regions"):
            sketch = self.kept or Sketch(self.place.mesh, planned, settings, self.certify)
            return proved(sketch, self.region, self.clock.step, written, draft)

    def _replanned(
        self, settings: Settings, planned: Wireframe, certificate: Certificate | None
    ) -> tuple[Settings, Wireframe] | None:
        """Plan anew what would be bare, or braced too little."""
        known = None if certificate is None else certificate.fidelity
        if known is not None and is_as_wished(known, settings) and is_braced(planned, settings):
            return None
        from wireprint.replanning import replanned

        with self.clock.stage("lower slabs"):
            return replanned(self.place.mesh, settings, planned, certificate, self.clock.step)

    def _judged(self, text: bytes, settings: Settings) -> Certificate:
        return check(
            text,
            settings,
            self.place.mesh,
            deviation=self.compare,
            standing=self.standing,
            at_mm=self.at_mm,
        )

    def _written(self, path: Toolpath, settings: Settings, *, pictures: bool = True) -> Written:
        remarks = [] if self.orientation is None else [str(self.orientation)]
        remarks += [str(self.place)] if self.place.turn_deg else []
        if self.standing is not None:
            from wireprint.beginning import over

            settings, started = over(settings, self.standing)
            remarks += started
        return written_file(path, settings, self.date, remarks, pictures=pictures)
