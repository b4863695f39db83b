"""``wireprint project``."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import click

from wireprint import files
from wireprint.cli.marks import marks_from, marks_options
from wireprint.cli.options import chosen_from, settings_options
from wireprint.cli.paths import InputFile, OutputName
from wireprint.cli.placement import placement_options
from wireprint.cli.say import say
from wireprint.streams import STREAM

if TYPE_CHECKING:
    from pathlib import Path


@click.command()
@click.argument("model", type=InputFile())
@click.option(
    "-o",
    "--output",
    required=True,
    type=OutputName(),
    metavar="PROJECT.3mf",
    help="Project to write.",
)
@marks_options
@settings_options
@placement_options
def project(model: Path, output: str, **options: Any) -> None:
    """Write a model, its settings and its marks into one 3MF file.

    `wireprint slice` takes all of them from there; other programs open it as a plain model. MODEL
    may be a project itself: what the options say is laid over it.
    """
    chosen, marks = chosen_from(options), marks_from(options, [model])
    inputs = [model, *chosen.files, *marks.files]
    target = files.output(output, f"{model.stem}.3mf", files.PROJECT_SUFFIXES, inputs)
    from wireprint.project import project_bytes

    found = marks.load(model, options)
    target.write(project_bytes(found.mesh, chosen.of(found), found.region))
    count = len(found.region.marks)
    say(
        f"{target}: {model.name} with {count} mark{'' if count == 1 else 's'}",
        err=output == STREAM,
    )
