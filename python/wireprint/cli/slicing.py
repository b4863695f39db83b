"""``wireprint slice``."""

from __future__ import annotations

import json
import sys
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from wireprint._core import UnprintableError, WireprintError
from wireprint.cli.marks import Marks, marks_from, marks_options
from wireprint.cli.options import Chosen, chosen_from, settings_options
from wireprint.cli.placement import orient_option, placement_options
from wireprint.cli.progress import Progress

if TYPE_CHECKING:
    from wireprint._core import Mesh
    from wireprint.certificate import Certificate
    from wireprint.regions import Region
    from wireprint.settings import Settings


@click.command()
@click.argument("models", nargs=-1, required=True, type=click.Path(path_type=Path))
@click.option(
    "-o",
    "--output",
    required=True,
    type=click.Path(path_type=Path),
    metavar="OUT",
    help="G-code file to write; for several models, a folder.",
)
@marks_options
@settings_options
@placement_options
@orient_option
@click.option("--json", "as_json", is_flag=True, help="Print one JSON object instead of words.")
@click.option("--force", is_flag=True, help="Write the file even if it breaks the rules.")
@click.option("-q", "--quiet", is_flag=True, help="Print nothing but errors.")
def slice_models(
    models: tuple[Path, ...],
    output: Path,
    as_json: bool,
    force: bool,
    quiet: bool,
    orient: bool,
    **options: Any,
) -> None:
    """Turn models into wire prints.

    MODEL is an STL, OBJ, PLY, OFF or 3MF file, or a project. Options that name a single setting
    win over --set, --set wins over --load, and --load over the profiles, or over the settings of
    a project. What is marked by --fill, or painted in a 3MF file, is printed as layers.

    The file is judged before it is written, as by `wireprint check`: one that would drive the head
    into its own strands, or leave them hanging, is refused.
    """
    targets = _targets(models, output)
    chosen, marks = chosen_from(options), marks_from(options, models)
    job = Job(
        chosen,
        chosen.recalled(),
        marks,
        options,
        force=force,
        compare=as_json or not quiet,
        orient=orient,
    )
    found: list[dict[str, Any]] = []
    exit_code = 0
    with Progress(len(models)) as progress:
        for model, target in zip(models, targets, strict=True):
            try:
                found.append(job.run(model, target, progress))
            except WireprintError as error:
                if len(models) == 1:
                    raise
                exit_code = exit_code or error.exit_code
                found.append({"model": str(model), "error": str(error)})
                progress.clear()
                name = "" if str(error).startswith(str(model)) else f"{model}: "
                click.echo(f"wireprint: error: {name}{error}", err=True)
    if as_json:
        click.echo(json.dumps(found[0] if len(models) == 1 else {"models": found}))
    elif not quiet:
        from wireprint.cli.summary import lines

        for figures in found:
            if "error" not in figures:
                click.echo("\n".join(lines(figures)))
    if exit_code:
        sys.exit(exit_code)


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

    def run(self, model: Path, target: Path, progress: Progress) -> dict[str, Any]:
        """Turn one model into a file; return its figures."""
        from wireprint.files import written_whole
        from wireprint.gcode.document import dated
        from wireprint.pipeline import Clock, make

        clock = Clock(on_stage=lambda stage: progress.show(f"{model.name}: {stage}"))
        with clock.stage("load"):
            mesh, settings, region = self._loaded(model)
        made = make(
            mesh,
            settings,
            region,
            date=dated(model),
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
        with clock.stage("write"):
            written_whole(target, made.gcode)
        progress.advance()
        figures = {
            "model": str(model),
            "output": str(target),
            "printer": settings.printer.name,
            "material": settings.material.name,
        } | made.figures()
        return figures | {"warnings": figures["warnings"] + warnings}

    def _loaded(self, path: Path) -> tuple[Mesh, Settings, Region | None]:
        """Read a model; one that cannot be marked is spared what marks import."""
        if not self.marks.concern(path):
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


def _targets(models: tuple[Path, ...], output: Path) -> list[Path]:
    """Where each model goes; a folder is made where several models need one."""
    if len(models) == 1 and not output.is_dir():
        return [output]
    targets = [output / f"{model.stem}.gcode" for model in models]
    twice = sorted({str(target) for target in targets if targets.count(target) > 1})
    if twice:
        msg = f"{twice[0]} would be written by several models"
        raise click.UsageError(msg)
    if output.exists() and not output.is_dir():
        msg = f"{output} is a file; several models need a folder"
        raise click.UsageError(msg)
    output.mkdir(parents=True, exist_ok=True)
    return targets
