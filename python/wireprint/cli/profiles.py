"""``wireprint profiles``."""

from __future__ import annotations

import importlib
from typing import Final

import click
from click.shell_completion import CompletionItem

from wireprint import catalogue
from wireprint._core import SettingError
from wireprint.cli import completion
from wireprint.cli.say import say, say_all

#: Name of each subcommand → its module, the command in it, and the summary for ``--help``.
_COMMANDS: Final[dict[str, tuple[str, str, str]]] = {
    "import": (
        "wireprint.cli.profiles_import",
        "import_profile",
        "Write a profile of your own printer from files of other programs.",
    ),
    "head": (
        "wireprint.cli.profiles_head",
        "measure",
        "Measure the head of your printer, and write it into a profile.",
    ),
    "gauge": (
        "wireprint.cli.profiles_gauge",
        "gauge",
        "Write a small print that the head touches where its profile is wrong.",
    ),
}


class _Profiles(click.Group):
    """A group whose first word may be the name of a profile, which it then shows."""

    def list_commands(self, ctx: click.Context) -> list[str]:
        """Names of the subcommands."""
        return list(_COMMANDS)

    def get_command(self, ctx: click.Context, cmd_name: str) -> click.Command | None:
        """Import a subcommand's module; any other word is the name of a profile."""
        if cmd_name not in _COMMANDS:
            return click.Command(
                cmd_name, callback=lambda: _show(cmd_name), add_help_option=False, hidden=True
            )
        module, attribute, _ = _COMMANDS[cmd_name]
        command: click.Command = getattr(importlib.import_module(module), attribute)
        return command

    def format_commands(self, ctx: click.Context, formatter: click.HelpFormatter) -> None:
        """List the subcommands without importing them."""
        if _COMMANDS:
            with formatter.section("Commands"):
                formatter.write_dl([(name, text) for name, (_, _, text) in _COMMANDS.items()])

    def shell_complete(self, ctx: click.Context, incomplete: str) -> list[CompletionItem]:
        """Offer subcommands and profiles."""
        names = [name for name in _COMMANDS if name.startswith(incomplete)]
        names += completion.profiles(incomplete)
        return [CompletionItem(name) for name in names]


@click.group(cls=_Profiles, invoke_without_command=True, subcommand_metavar="[NAME]")
@click.pass_context
def profiles(ctx: click.Context) -> None:
    """List the profiles, or show one.

    NAME is a printer or a material. What is shown is the profile's file, with all that it inherits
    written out: redirect it into a file of your own, change it there, and give that to --printer or
    --material.
    """
    if ctx.invoked_subcommand is None:
        for kind in catalogue.KINDS:
            say(f"{kind}:")
            for known in catalogue.names(kind):
                say(f"  {known:20}{catalogue.headline(catalogue.find(kind, known))}")


def _show(name: str) -> None:
    """Print a profile."""
    from wireprint.profile_text import whole

    for kind in catalogue.KINDS:
        if name in catalogue.names(kind):
            say_all(whole(kind, name))
            return
    everything = [known for kind in catalogue.KINDS for known in catalogue.names(kind)]
    msg = f"no profile is called {name!r}; {catalogue.hint(name, everything)}"
    raise SettingError(msg)
