"""The command ``wireprint``: each subcommand lives in its own module, imported when it is used."""

from __future__ import annotations

import importlib
import os
import sys
from typing import TYPE_CHECKING, Any

import click

from wireprint import streams
from wireprint._core import __version__
from wireprint.cli.failure import Unread, fail, leave

if TYPE_CHECKING:
    from collections.abc import Sequence

#: Name of each subcommand → its module, the command in it, and the summary for ``--help``.
COMMANDS: dict[str, tuple[str, str, str]] = {
    "slice": ("wireprint.cli.slicing", "slice_models", "Turn models into wire prints."),
    "project": (
        "wireprint.cli.project",
        "project",
        "Write a model, its settings and its marks into one 3MF file.",
    ),
    "info": ("wireprint.cli.info", "info", "Tell size, surface, marks and faults of a model."),
    "profiles": ("wireprint.cli.profiles", "profiles", "List the profiles, or show one."),
    "config": (
        "wireprint.cli.config",
        "config",
        "Show or keep the default printer and material.",
    ),
    "check": ("wireprint.cli.check", "check", "Judge whether a G-code file can be printed."),
    "simulate": (
        "wireprint.cli.simulate",
        "simulate",
        "Forecast whether posts hold, stretches sag, and strands meet and weld.",
    ),
    "calibrate": (
        "wireprint.cli.calibrate",
        "calibrate",
        "Make forecasts true for your printer: print, measure, fit.",
    ),
    "estimate": ("wireprint.cli.estimate", "estimate", "Tell how long G-code takes to print."),
    "compare": (
        "wireprint.cli.compare",
        "compare",
        "Tell how long a model takes as a wire print, and how long in layers.",
    ),
    "studio": (
        "wireprint.cli.studio",
        "studio",
        "Open a window that paints, shows and prints a model.",
    ),
    "splice": (
        "wireprint.cli.splice",
        "splice",
        "Put a wire print of MODEL between the layers of another slicer's file.",
    ),
    "body": (
        "wireprint.cli.body",
        "body",
        "Write the strands of a print as tubes that other slicers print.",
    ),
    "order": (
        "wireprint.cli.order",
        "order",
        "Print a strut graph: find an order and directions that the head can follow.",
    ),
    "view": ("wireprint.cli.view", "view", "Draw G-code or a model."),
    "bench": ("wireprint.cli.bench", "bench", "Compare and judge many models at once."),
    "report": ("wireprint.cli.report", "report", "Write a page about the results of a bench."),
    "example": ("wireprint.cli.example", "example", "Write a model to try."),
}

# The command needs no pydantic plugins, and looking for some takes a tenth of a short run.
os.environ.setdefault("PYDANTIC_DISABLE_PLUGINS", "__all__")


class Commands(click.Group):
    """A group that imports a subcommand only when it is called."""

    def list_commands(self, ctx: click.Context) -> list[str]:
        """Names in the order of the pipeline."""
        return list(COMMANDS)

    def get_command(self, ctx: click.Context, cmd_name: str) -> click.Command | None:
        """Import the subcommand's module."""
        if cmd_name not in COMMANDS:
            return None
        module, attribute, _ = COMMANDS[cmd_name]
        command: click.Command = getattr(importlib.import_module(module), attribute)
        return command

    def format_commands(self, ctx: click.Context, formatter: click.HelpFormatter) -> None:
        """List the subcommands without importing them."""
        with formatter.section("Commands"):
            formatter.write_dl([(name, summary) for name, (_, _, summary) in COMMANDS.items()])

    def invoke(self, ctx: click.Context) -> Any:
        """Run the subcommand; a reader that went away is told, not taken for a fault by click."""
        try:
            return super().invoke(ctx)
        except BrokenPipeError as error:
            raise Unread from error

    def main(
        self,
        args: Sequence[str] | None = None,
        prog_name: str | None = None,
        complete_var: str | None = None,
        standalone_mode: bool = True,
        **extra: Any,
    ) -> Any:
        """Run, and turn every error into one or two lines and an exit code."""
        name = prog_name or "wireprint"
        given = list(sys.argv[1:] if args is None else args)
        streams.open_all()
        try:
            result = super().main(given, name, complete_var, standalone_mode=False, **extra)
        except Exception as error:
            if not standalone_mode:
                raise
            fail(error, given)
        return leave(result if isinstance(result, int) else 0) if standalone_mode else result


@click.command(cls=Commands, context_settings={"help_option_names": ["-h", "--help"]})
@click.version_option(__version__, message="wireprint %(version)s")
def main() -> None:
    """Turn a 3D model into a wire print that an ordinary printer makes in minutes."""
