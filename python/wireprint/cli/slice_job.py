"""What ``wireprint slice`` does with one model."""

from __future__ import annotations

from dataclasses import asdict, dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

from wireprint._core import MemoryLimitError, ModelError, SettingError, UnprintableError
from wireprint.streams import is_stream

if TYPE_CHECKING:
    from wireprint._core import Mesh
    from wireprint.budget import Budget, Budgeted
    from wireprint.cli.marks import Marks
    from wireprint.cli.onto import Onto
    from wireprint.cli.options import Chosen
    from wireprint.cli.progress import Progress
    from wireprint.clock import Clock
    from wireprint.files import Output
    from wireprint.forecast import Forecast
    from wireprint.hosts import Host
    from wireprint.regions import Region
    from wireprint.settings import Settings
    from wireprint.stiffening import Stiffened
    from wireprint.wire_print import WirePrint


@dataclass(frozen=True)
class Sliced:
    """A print that is not written yet."""

    gcode: bytes
    figures: dict[str, Any]
    clock: Clock
    #: What it was chosen from, where there is a budget.
    budgeted: Budgeted | None = None

    def written(self, target: Output) -> dict[str, Any]:
        """Write the file; return the figures, among them where it is."""
        with self.clock.stage("write"):
            target.write(self.gcode)
        figures = dict(self.figures)
        return {"model": figures.pop("model"), "output": str(target), **figures}

    def sent(self, host: Host, target: Output, *, start: bool) -> dict[str, Any]:
        """Send the file to a host; return where it is, and whether it is printed."""
        from wireprint.hosts.sending import send

        name = Path(self.figures["model"]).stem if target.path is None else target.path.name
        with self.clock.stage("send"):
            return asdict(send(host, name, self.gcode, start=start))

    def chart(self) -> bytes:
        """Draw what it was chosen from."""
        from wireprint.budget.chart import png

        if self.budgeted is None:
            raise SettingError("alternatives are those within a budget: give --time")
        return png(self.budgeted, str(self.figures["model"]))


@dataclass(frozen=True)
class Job:
    """What all models of one run share."""

    chosen: Chosen
    #: What they amount to, unless the model is a project.
    settings: Settings
    marks: Marks
    placement: dict[str, Any]
    force: bool
    #: Whether it is asked for how far strands lie off the surface.
    compare: bool
    #: Whether it is asked for where the print gives way easily.
    weak: bool
    #: Whether it is asked for what strands would do when they are hot and heavy.
    forecast: bool
    #: What it is to bear between two fingers, N; None: that does not matter.
    grip_n: float | None
    #: Whether each model is turned into its best pose.
    orient: bool
    #: What the print may take; None: whatever it takes.
    budget: Budget | None = None
    #: Keys of settings that a budget leaves as they are.
    kept: frozenset[str] = frozenset()
    #: What stands on the bed already; None: nothing.
    onto: Onto | None = None

    def run(self, model: Path, progress: Progress) -> Sliced:
        """Turn one model into G-code."""
        from wireprint.clock import Clock
        from wireprint.gcode.document import dated
        from wireprint.pipeline import make
        from wireprint.report import breaches, led_out, units_meant
        from wireprint.wholeness import IncompleteError, is_whole, shortfall

        clock = Clock(on_stage=lambda stage: progress.show(f"{model.name}: {stage}"))
        with clock.stage("load"):
            mesh, settings, region = self._loaded(model)
        x, y, z = mesh.size_mm
        warnings = units_meant((x, y, z), self.placement)
        options: dict[str, Any] = {
            "date": dated(None if is_stream(model) else model),
            "clock": clock,
            "compare": self.compare,
            "orient": self.orient,
            "partial": self.force,
            "oversize": self.force,
            "weak": self.weak,
        }
        budgeted = None
        try:
            if self.onto is not None:
                options |= self.onto.options(settings)
            if self.budget is None:
                made = make(mesh, settings, region, **options)
            else:
                from wireprint.budget import within

                with clock.stage("budget"):
                    budgeted = within(
                        mesh, settings, self.budget, region, kept=self.kept, **options
                    )
                made, settings = budgeted.made, budgeted.made.settings
        except IncompleteError as error:
            forced = "\n--force writes it all the same" if error.usable else ""
            raise UnprintableError(f"{model}: {error}{forced}") from error
        except (ModelError, UnprintableError, MemoryLimitError) as error:
            raise type(error)("; ".join([f"{model}: {error}", *warnings])) from error
        forecast = stiffer = None
        if self.forecast:
            with clock.stage("forecast"):
                made, forecast, stiffer = self._stiffened(mesh, made, region, options)
            settings = made.settings
        if made.certificate is not None and not made.certificate.ok:
            sequence = led_out(made.certificate, settings)
            if sequence is not None and not self.force:
                raise SettingError(sequence)
            reason = sequence or breaches(made.certificate, settings)
            if not self.force:
                raise UnprintableError(f"{model}: {reason}")
            warnings.append(f"written although {reason}")
        if made.certificate is not None and not is_whole(made.certificate, settings):
            warnings.append(f"written although {shortfall(made.certificate, settings)}")
        figures = {
            "model": str(model),
            "printer": settings.printer.name,
            "material": settings.material.name,
        } | made.figures()
        if self.weak and made.weak is None:
            warnings.append("how far it gives way while it grows was not judged: too much work")
        figures["warnings"] += warnings
        figures["sent"] = None
        if forecast is not None:
            from wireprint.forecast_words import told

            figures["forecast"] = told(forecast)
            figures["stiffened"] = None if stiffer is None else asdict(stiffer)
        figures["budget"] = None if budgeted is None else budgeted.to_dict()
        return Sliced(made.gcode, figures, clock, budgeted)

    def _stiffened(
        self, mesh: Mesh, made: WirePrint, region: Region | None, options: dict[str, Any]
    ) -> tuple[WirePrint, Forecast, Stiffened | None]:
        """Make a print anew that gives way; within a budget, or onto others, only tell it."""
        from wireprint.forecast import simulate
        from wireprint.stiffening import stiffened

        stands = self.onto is not None and (bool(self.onto) or any(self.onto.at_mm))
        as_it_is = self.budget is not None or stands or self.force
        if as_it_is or made.certificate is None or not made.certificate.ok:
            return made, simulate(made.gcode, made.settings, self.grip_n), None
        return stiffened(mesh, made, region, options, grip_n=self.grip_n, kept=self.kept)

    def _loaded(self, path: Path) -> tuple[Mesh, Settings, Region | None]:
        """Read a model; one that cannot be marked is spared what marks import."""
        if not self.marks.concern(path, self.placement):
            from wireprint.mesh import load_mesh

            return load_mesh(path, **self.placement), self.settings, None
        model = self.marks.load(path, self.placement)
        settings = self.settings if model.settings is None else self.chosen.over(model.settings)
        return model.mesh, settings, model.region
