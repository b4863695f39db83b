"""A wire print: a model with everything that was made from it."""

from __future__ import annotations

from dataclasses import asdict, dataclass
from typing import TYPE_CHECKING, Any

from wireprint import report, report_regions
from wireprint.filament import Filament
from wireprint.slimness import strand_of
from wireprint.wholeness import is_whole

if TYPE_CHECKING:
    from wireprint._core import Estimate, Mesh, Toolpath, Wireframe
    from wireprint.certificate import Certificate
    from wireprint.hybrid.prove import Proved
    from wireprint.hybrid.sketch import Sketch
    from wireprint.orientation import Orientation
    from wireprint.settings import Settings
    from wireprint.weakness import Weak


@dataclass(frozen=True, repr=False)
class WirePrint:
    """A model with everything that was made from it."""

    settings: Settings
    #: The model as it stands on the bed.
    mesh: Mesh
    wireframe: Wireframe
    toolpath: Toolpath
    #: What of it is layers; None where nothing was marked.
    regions: Proved | None
    #: The whole file.
    gcode: bytes
    estimate: Estimate
    #: The verdict on the file; None where it was not asked for.
    certificate: Certificate | None
    #: Seconds per stage.
    timings_s: dict[str, float]
    #: How the model was turned, where that was left to us.
    orientation: Orientation | None = None
    #: By how much it was turned about z to fit the bed, degrees.
    turn_to_fit_deg: float = 0.0
    #: Where it gives way too easily while it grows; None where that was not asked for, or is too
    #: much work to find out.
    weak: tuple[Weak, ...] | None = None
    #: The wire print without marks, before strands that break the rules were left out of it: what
    #: broke them may well be layers once something is marked. None: `wireframe`.
    planned: Wireframe | None = None

    @property
    def sketch(self) -> Sketch:
        """What marks do not change, to be kept for the next print."""
        if self.regions is not None:
            return self.regions.plan.sketch
        from wireprint.hybrid.sketch import Sketch

        plain, judged = self.planned or self.wireframe, self.certificate is not None
        return Sketch(self.mesh, plain, self.settings, judged)

    def figures(self) -> dict[str, Any]:
        """Tell what people want to know, under the keys of ``wireprint slice --json``.

        Returns
        -------
        dict
            Values that JSON knows.
        """
        moves = self.toolpath.figures()
        filament, filament_mm = Filament.of(self.settings), self.estimate.filament_mm
        return {
            "size_mm": self.mesh.size_mm,
            "orientation": None if self.orientation is None else self.orientation.to_dict(),
            "turn_to_fit_deg": self.turn_to_fit_deg,
            "slices": self.wireframe.slice_count,
            "posts": self.wireframe.post_count,
            "strand_mm": moves["strand_mm"],
            "travel_mm": moves["travel_mm"],
            "strand": strand_of(self.settings),
            "low_slabs_mm": [list(band) for band in self.settings.wire.low_slabs_mm],
            "brim_rings": self.toolpath.brim_rings,
            "pauses": moves["pauses"],
            "pause_s": moves["pause_s"],
            "filament_mm": filament_mm,
            "filament_g": filament.grams(filament_mm),
            "filament_cost": filament.cost(filament_mm),
            "print_time_s": self.estimate.total_s,
            **self._verdict(),
            "repaired": report.repairs(self.mesh),
            "unprinted": self.unprinted(),
            "weak": None if self.weak is None else [asdict(place) for place in self.weak],
            "regions": None if self.regions is None else report_regions.regions(self.regions),
            "warnings": [*report.warnings(self.mesh), *report.slowed(self.settings)],
            "timings_s": self.timings_s,
        }

    def unprinted(self) -> list[report.Unprinted]:
        """List what is not printed: what the certificate finds bare, and what planning left out.

        Returns
        -------
        list of Unprinted
            Parts, the largest first.
        """
        fidelity = None if self.certificate is None else self.certificate.fidelity
        return report.unprinted(self.wireframe.unprinted, fidelity, self.settings)

    def _told(self) -> str:
        """Say time, filament and verdict."""
        from wireprint.notebook import told

        figures = {
            "print_time_s": self.estimate.total_s,
            "filament_g": Filament.of(self.settings).grams(self.estimate.filament_mm),
        }
        return told(figures | self._verdict())

    def __repr__(self) -> str:
        """Say what it comes to; the parts are attributes."""
        return f"<WirePrint {self.settings.printer.name}: {self._told()}>"

    def _repr_png_(self) -> bytes:
        """Draw the picture that a notebook shows."""
        from wireprint.notebook import picture

        return picture(self)

    def _repr_html_(self) -> str:
        """Draw it, and say time, filament and verdict below."""
        from wireprint.notebook import page

        return page(self, self._told())

    def _verdict(self) -> dict[str, Any]:
        """Return whether the file keeps the rules, and how faithful it is."""
        certificate = self.certificate
        if certificate is None:
            return {}
        breaches = {name: len(found) for name, found in certificate.breaches().items()}
        verdict: dict[str, Any] = {"certified": certificate.ok, "breaches": breaches}
        if certificate.fidelity is not None:
            verdict["whole"] = is_whole(certificate, self.settings)
            verdict["coverage"] = certificate.fidelity.coverage
            if certificate.fidelity.deviation_mm is not None:
                verdict["deviation_mm"] = certificate.fidelity.deviation_mm
                verdict["chord_deviation_mm"] = certificate.fidelity.chord_deviation_mm
        return verdict
