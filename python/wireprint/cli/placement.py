"""The options that place a model, for every command that reads one."""

from __future__ import annotations

from typing import TYPE_CHECKING, TypeVar

import click

from wireprint.mesh import SUFFIXES, UNITS_MM

if TYPE_CHECKING:
    from collections.abc import Callable

Command = TypeVar("Command", bound="Callable[..., object]")


def placement_options(command: Command) -> Command:
    """Add the options that ``wireprint.mesh.load_mesh`` takes, under its parameters' names."""
    options = (
        click.option(
            "--format",
            "file_format",
            type=click.Choice(SUFFIXES, case_sensitive=False),
            help="Format of the model; default: what its name ends in.",
        ),
        click.option(
            "--plate",
            type=click.IntRange(min=1),
            metavar="N",
            help="Plate of a slicer's project (3MF); default: the first that has something on it.",
        ),
        click.option("--scale", type=float, default=1.0, help="Factor on the model's size."),
        click.option(
            "--units", type=click.Choice(list(UNITS_MM)), default="mm", help="Unit of the file."
        ),
        click.option(
            "--up", type=click.Choice(["x", "y", "z"]), default="z", help="Axis that points up."
        ),
        click.option(
            "--rotate",
            type=float,
            nargs=3,
            default=(0.0, 0.0, 0.0),
            metavar="X Y Z",
            help="Degrees about x, then y, then z.",
        ),
        click.option(
            "--height", "height_mm", type=float, metavar="MM", help="Scale to this height."
        ),
    )
    for option in reversed(options):
        command = option(command)
    return command


def orient_option(command: Command) -> Command:
    """Add the option ``--orient``; the command takes `orient`, whether to turn the model."""
    return click.option(
        "--orient",
        type=click.Choice(["given", "auto"]),
        default="given",
        help="Leave the model as it is placed, or turn it so that it prints best.",
        callback=lambda _ctx, _option, value: value == "auto",
    )(command)
