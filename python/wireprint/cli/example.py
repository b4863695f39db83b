"""``wireprint example``."""

from __future__ import annotations

import click

from wireprint import examples, files
from wireprint.cli.paths import OutputName
from wireprint.cli.say import say
from wireprint.streams import STREAM


@click.command()
@click.argument("name", type=click.Choice(examples.names()))
@click.option("-o", "--output", type=OutputName(), help="STL file to write; default: NAME.stl.")
def example(name: str, output: str | None) -> None:
    """Write a model to try.

    NAME is the cube (28 mm) or the sphere (radius 39 mm) of the paper, a bottle (180 mm), an
    arch, whose two legs merge, an upright torus, or a branch that forks and merges.
    """
    target = files.output(output or f"{name}.stl", f"{name}.stl", files.EXAMPLE_SUFFIXES, ())
    target.write(examples.stl(name))
    say(f"{target}: {name}", err=output == STREAM)
