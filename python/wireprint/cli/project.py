"""``wireprint project``."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import click

from wireprint.cli.marks import marks_from, marks_options
from wireprint.cli.options import chosen_from, settings_options
from wireprint.cli.placement import placement_options


@click.command()
@click.argument("model", type=click.Path(path_type=Path))
@click.option(
    "-o",
    "--output",
    required=True,
    type=click.Path(dir_okay=False, path_type=Path),
    metavar="PROJECT.3mf",
    help="Project to write.",
)
@marks_options
@settings_options
@placement_options
def project(model: Path, output: Path, **options: Any) -> None:
    """Write a model, its settings and its marks into one 3MF file.

    `wireprint slice` takes all of them from there; other programs open it as a plain model. MODEL
    may be a project itself: what the options say is laid over it.
    """
    if output.suffix.lower() != ".3mf":
        raise click.UsageError(f"{output}: a project's name ends in .3mf")
    from wireprint.project import write_project

    chosen, marks = chosen_from(options), marks_from(options, [model])
    found = marks.load(model, options)
    write_project(output, found.mesh, chosen.of(found), found.region)
    count = len(found.region.marks)
    click.echo(f"{output}: {model.name} with {count} mark{'' if count == 1 else 's'}")
