"""``wireprint slice``."""

from __future__ import annotations

from dataclasses import dataclass, field
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from wireprint import files
from wireprint._core import WireprintError
from wireprint.cli.amounts import Amount
from wireprint.cli.budget import budget_from, budget_options, named_keys, table
from wireprint.cli.failure import exit_code_of, say_failure
from wireprint.cli.marks import marks_from, marks_options
from wireprint.cli.onto import onto_from, onto_options
from wireprint.cli.options import chosen_from, settings_options
from wireprint.cli.parallel import as_they_finish
from wireprint.cli.paths import InputFile, OutputName
from wireprint.cli.placement import orient_option, placement_options
from wireprint.cli.progress import Progress
from wireprint.cli.say import say_all, say_json
from wireprint.cli.slice_job import Job
from wireprint.streams import STREAM
from wireprint.threads import workers

if TYPE_CHECKING:
    from wireprint.cli.slice_job import Sliced
    from wireprint.files import Output
    from wireprint.hosts import Host


@click.command()
@click.argument("models", nargs=-1, required=True, type=InputFile(must_be_there=False))
@click.option(
    "-o",
    "--output",
    required=True,
    type=OutputName(),
    metavar="OUT",
    help="G-code file to write, - for stdout; a folder for several models.",
)
@marks_options
@settings_options
@placement_options
@orient_option
@budget_options
@onto_options
@click.option("--json", "as_json", is_flag=True, help="Print one JSON object instead of words.")
@click.option(
    "--force",
    is_flag=True,
    help="Write the file even if it breaks the rules or leaves much of the model out.",
)
@click.option(
    "--weak", is_flag=True, help="Tell where the print gives way easily; --json always does."
)
@click.option(
    "--forecast",
    is_flag=True,
    help="Tell what strands would do when they are hot and heavy, as wireprint simulate does, and "
    "print lower slabs or thicker strands where the print would give way.",
)
@click.option(
    "--grip",
    type=Amount(0.1, 1000),
    metavar="N",
    help="Ask for a print that bears so many newtons between two fingers at half its height; with "
    "--forecast.",
)
@click.option("--send", metavar="NAME", help="Host of yours to send the file to, certified.")
@click.option("--start", is_flag=True, help="Print at once what is sent.")
@click.option("-q", "--quiet", is_flag=True, help="Print nothing but errors.")
@click.pass_context
def slice_models(
    ctx: click.Context,
    /,
    models: tuple[Path, ...],
    output: str,
    as_json: bool,
    force: bool,
    weak: bool,
    forecast: bool,
    grip: float | None,
    send: str | None,
    start: bool,
    quiet: bool,
    orient: bool,
    **options: Any,
) -> None:
    """Turn models into wire prints.

    MODEL is an STL, OBJ, PLY, OFF, 3MF or AMF file, or a project; - is stdin, with --format.
    Options that name a single setting win over --set, --set wins over --load, and --load over the
    profiles, or over the settings of a project. What is marked by --fill, or painted in a 3MF
    file, is printed as layers.

    The file is judged before it is written, as by `wireprint check`: one that would drive the head
    into its own strands, leave them hanging, or leave more than a twentieth of the surface bare
    (wire.coverage_min), is refused.
    """
    if grip is not None:
        from wireprint.frames import can_solve

        if not can_solve():
            raise click.UsageError("--grip takes scipy: pip install 'wireprint[grip]'")
    forecast = forecast or grip is not None
    chosen, marks = chosen_from(options), marks_from(options, models)
    host = _host(send, start, models)
    wanted = budget_from(options)
    onto = onto_from(options)
    if len(models) > 1 and (onto or any(onto.at_mm)):
        raise click.UsageError("one model at a time is printed onto what stands already")
    if wanted.budget is not None and (onto or any(onto.at_mm)):
        raise click.UsageError("a budget is for a bed on which nothing stands: leave --time out")
    inputs = [*models, *chosen.files, *marks.files, *onto.files]
    targets = _targets(models, output, inputs)
    pictures = _pictures(models, wanted.picture, inputs)
    job = Job(
        chosen,
        # A budget and a forecast ask them more than a print does.
        chosen.recalled() if wanted.budget is None and not forecast else chosen.settings(),
        marks,
        options,
        force=force,
        compare=as_json or not quiet,
        weak=as_json or weak,
        forecast=forecast,
        grip_n=grip,
        orient=orient,
        budget=wanted.budget,
        kept=named_keys(chosen),
        onto=onto,
    )
    told = Told(
        models, as_json=as_json, quiet=quiet, table=wanted.table, to_stderr=output == STREAM
    )
    told.host, told.start = host, start
    with Progress(len(models)) as progress:
        calls = [partial(job.run, model, progress) for model in models]
        for place, found in as_they_finish(calls, workers()):
            progress.advance()
            if isinstance(found, BaseException) and len(models) == 1:
                raise found
            progress.clear()
            told.add(place, found, targets[place], None if pictures is None else pictures[place])
    told.finish()
    ctx.exit(told.exit_code)


@dataclass
class Told:
    """What is said about the models of a run, as they are finished."""

    models: tuple[Path, ...]
    as_json: bool
    quiet: bool
    to_stderr: bool
    #: Where files are sent, once they are written, and whether they are printed at once.
    host: Host | None = None
    start: bool = False
    #: Whether the prints that a budget was chosen from are told.
    table: bool = False
    exit_code: int = 0
    _figures: dict[int, dict[str, Any]] = field(default_factory=dict)

    def add(
        self, place: int, found: Sliced | BaseException, target: Output, picture: Output | None
    ) -> None:
        """Write a model's file, and say what came of it."""
        try:
            if isinstance(found, BaseException):
                raise found
            figures = found.written(target)
            if picture is not None:
                picture.write(found.chart())
            if self.host is not None:
                figures["sent"] = found.sent(self.host, target, start=self.start)
        except (WireprintError, OSError) as error:
            if len(self.models) == 1:
                raise
            self._failed(place, error)
            return
        self._figures[place] = figures
        if not self.as_json and not self.quiet:
            from wireprint.cli.summary import lines

            say_all(lines(figures), err=self.to_stderr)
            if self.table:
                say_all(table(figures["budget"]), err=self.to_stderr)

    def _failed(self, place: int, error: Exception) -> None:
        model = str(self.models[place])
        self.exit_code = self.exit_code or exit_code_of(error)
        self._figures[place] = {"model": model, "error": str(error)}
        say_failure(error, model)

    def finish(self) -> None:
        """Print the object that holds all of it, if that is what is asked for."""
        if self.as_json:
            every = [self._figures[place] for place in sorted(self._figures)]
            say_json(every[0] if len(self.models) == 1 else {"models": every}, err=self.to_stderr)


def _host(send: str | None, start: bool, models: tuple[Path, ...]) -> Host | None:
    """Return where to send to; what is wrong with it is told before anything is sliced."""
    if send is None:
        if start:
            raise click.UsageError("--start prints what --send NAME sends")
        return None
    if start and len(models) > 1:
        raise click.UsageError("--start prints one model")
    from wireprint import hosts

    return hosts.find(send)


def _pictures(
    models: tuple[Path, ...], picture: str | None, inputs: list[Path]
) -> list[Output] | None:
    """Where the alternatives of each model are drawn."""
    if picture is None:
        return None
    if len(models) > 1 and not picture.endswith("/"):
        picture = f"{picture}/"
    return [
        files.output(picture, f"{model.stem}.png", files.PICTURE_SUFFIXES, inputs)
        for model in models
    ]


def _targets(models: tuple[Path, ...], output: str, inputs: list[Path]) -> list[Output]:
    """Where each model goes: several go into a folder, which is made where there is none."""
    if len(models) > 1:
        path = Path(output)
        if output == STREAM or (path.exists() and not path.is_dir()):
            msg = f"{output} is no folder; several models need one"
            raise click.UsageError(msg)
        if path.suffix.lower() in files.GCODE_SUFFIXES and not path.exists():
            msg = f"{output} names one file; several models need a folder"
            raise click.UsageError(msg)
        output = f"{output}/"
    targets = [
        files.output(output, f"{model.stem}.gcode", files.GCODE_SUFFIXES, inputs)
        for model in models
    ]
    names = [str(target) for target in targets]
    twice = sorted({name for name in names if names.count(name) > 1})
    if twice:
        msg = f"{twice[0]} would be written by several models"
        raise click.UsageError(msg)
    return targets
