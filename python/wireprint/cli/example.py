"""``wireprint example``."""

from __future__ import annotations

from pathlib import Path

import click

from wireprint import examples
from wireprint.files import written_whole


@click.command()
@click.argument("name", type=click.Choice(examples.names()))
@click.option(
    "-o", "--output", type=click.Path(path_type=Path), help="File to write; default: NAME.stl."
)
def example(name: str, output: Path | None) -> None:
    """Write a model to try.

    NAME is the cube (28 mm) or the sphere (radius 39 mm) of the paper, a bottle (180 mm), an
    arch, whose two legs merge, an upright torus, or a branch that forks and merges.
    """
    target = output or Path(f"{name}.stl")
    written_whole(target, examples.stl(name))
    click.echo(f"{target}: {name}")
