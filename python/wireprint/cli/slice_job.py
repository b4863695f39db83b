"""What ``wireprint slice`` does with one model."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from wireprint._core import UnprintableError
from wireprint.streams import is_stream

if TYPE_CHECKING:
    from pathlib import Path

    from wireprint._core import Mesh
    from wireprint.certificate import Certificate
    from wireprint.cli.marks import Marks
    from wireprint.cli.options import Chosen
    from wireprint.cli.progress import Progress
    from wireprint.files import Output
    from wireprint.pipeline import Clock
    from wireprint.regions import Region
    from wireprint.settings import Settings


@dataclass(frozen=True)
class Sliced:
    """A print that is not written yet."""

    gcode: bytes
    figures: dict[str, Any]
    clock: Clock

    def written(self, target: Output) -> dict[str, Any]:
        """Write the file; return the figures, among them where it is."""
        with self.clock.stage("write"):
            target.write(self.gcode)
        figures = dict(self.figures)
        return {"model": figures.pop("model"), "output": str(target), **figures}


@dataclass(frozen=True)
class Job:
    """What all models of one run share."""

    chosen: Chosen
    #: What they amount to, unless the model is a project.
    settings: Settings
    marks: Marks
    placement: dict[str, Any]
    force: bool
    #: Whether coverage and deviation are asked for.
    compare: bool
    #: Whether each model is turned into its best pose.
    orient: bool

    def run(self, model: Path, progress: Progress) -> Sliced:
        """Turn one model into G-code."""
        from wireprint.gcode.document import dated
        from wireprint.pipeline import Clock, make

        clock = Clock(on_stage=lambda stage: progress.show(f"{model.name}: {stage}"))
        with clock.stage("load"):
            mesh, settings, region = self._loaded(model)
        made = make(
            mesh,
            settings,
            region,
            date=dated(None if is_stream(model) else model),
            clock=clock,
            compare=self.compare,
            orient=self.orient,
        )
        warnings = []
        if made.certificate is not None and not made.certificate.ok:
            reason = _breaches(made.certificate, settings)
            if not self.force:
                raise UnprintableError(f"{model}: {reason}")
            warnings.append(f"written although {reason}")
        figures = {
            "model": str(model),
            "printer": settings.printer.name,
            "material": settings.material.name,
        } | made.figures()
        figures["warnings"] += warnings
        return Sliced(made.gcode, figures, clock)

    def _loaded(self, path: Path) -> tuple[Mesh, Settings, Region | None]:
        """Read a model; one that cannot be marked is spared what marks import."""
        if not self.marks.concern(path, self.placement):
            from wireprint.mesh import load_mesh

            return load_mesh(path, **self.placement), self.settings, None
        model = self.marks.load(path, self.placement)
        settings = self.settings if model.settings is None else self.chosen.over(model.settings)
        return model.mesh, settings, model.region


def _breaches(certificate: Certificate, settings: Settings) -> str:
    """Say which rules a file breaks, how often, and where first."""
    outside = [b.value for b in certificate.out_of_bounds if b.bound == "volume"]
    if outside:
        return (
            f"the print leaves the build volume of {settings.printer.name} "
            f"({settings.printer.bed}) by {max(outside):.1f} mm; scale it or change the printer"
        )
    found = {name: breaches for name, breaches in certificate.breaches().items() if breaches}
    counts = ", ".join(f"{name.replace('_', ' ')}: {len(list_)}" for name, list_ in found.items())
    first = min((breach for list_ in found.values() for breach in list_), key=lambda b: b.line)
    return f"the print would break the rules ({counts}); first in line {first.line}, {first}"
