"""The command ``wireprint``: each subcommand lives in its own module, imported when it is used."""

from __future__ import annotations

import importlib
import os
import sys
from typing import TYPE_CHECKING, Any, NoReturn

import click

from wireprint._core import WireprintError, __version__

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
    "check": ("wireprint.cli.check", "check", "Judge whether a G-code file can be printed."),
    "estimate": ("wireprint.cli.estimate", "estimate", "Tell how long G-code takes to print."),
    "compare": (
        "wireprint.cli.compare",
        "compare",
        "Tell how long a model takes as a wire print, and how long in layers.",
    ),
    "view": ("wireprint.cli.view", "view", "Draw G-code or a model."),
    "bench": ("wireprint.cli.bench", "bench", "Compare and judge many models at once."),
    "example": ("wireprint.cli.example", "example", "Write a model to try."),
}

# The command needs no pydantic plugins, and looking for some takes a tenth of a short run.
os.environ.setdefault("PYDANTIC_DISABLE_PLUGINS", "__all__")

EXIT_UNEXPECTED = 1
EXIT_USAGE = 2


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
        if not standalone_mode:
            return super().main(args, name, complete_var, standalone_mode=False, **extra)
        try:
            result = super().main(args, name, complete_var, standalone_mode=False, **extra)
        except Exception as error:
            _fail(error)
        sys.exit(result if isinstance(result, int) else 0)


def _fail(error: Exception) -> NoReturn:
    if os.environ.get("WIREPRINT_TRACEBACK"):
        raise error
    if isinstance(error, click.UsageError):
        message, code = error.format_message(), EXIT_USAGE
        if error.ctx is not None:
            message += f"\nTry '{error.ctx.command_path} --help' for help."
    elif isinstance(error, click.ClickException):
        message, code = error.format_message(), EXIT_USAGE
    elif isinstance(error, click.Abort):
        message, code = "stopped", 130
    elif isinstance(error, WireprintError):
        message, code = str(error), error.exit_code
    elif isinstance(error, OSError):
        place = f"{error.filename}: " if error.filename else ""
        message, code = f"{place}{error.strerror or error}", EXIT_USAGE
    else:
        message = (
            f"unexpected {type(error).__name__}: {error}\n"
            "This is a fault of wireprint; WIREPRINT_TRACEBACK=1 shows where."
        )
        code = EXIT_UNEXPECTED
    click.echo(f"wireprint: error: {message}", err=True)
    sys.exit(code)


@click.command(cls=Commands, context_settings={"help_option_names": ["-h", "--help"]})
@click.version_option(__version__, message="wireprint %(version)s")
def main() -> None:
    """Turn a 3D model into a wire print that an ordinary printer makes in minutes."""
