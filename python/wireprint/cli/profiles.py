"""``wireprint profiles``."""

from __future__ import annotations

import importlib
import tomllib
from typing import TYPE_CHECKING, Any, Final

import click
from click.shell_completion import CompletionItem

from wireprint import catalogue
from wireprint._core import SettingError
from wireprint.cli import completion
from wireprint.cli.say import say, say_all, say_json

if TYPE_CHECKING:
    from collections.abc import Iterator

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
        if cmd_name not in _COMMANDS or ctx.params.get("keys"):
            return click.Command(
                cmd_name,
                callback=lambda: _tell(cmd_name, **ctx.params),
                add_help_option=False,
                hidden=True,
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
@click.option("--keys", is_flag=True, help="List every key instead: unit, bounds, default, help.")
@click.option("--json", "as_json", is_flag=True, help="Print one JSON object instead of words.")
@click.pass_context
def profiles(ctx: click.Context, keys: bool, as_json: bool) -> None:
    """List the profiles, or show one.

    NAME is a printer or a material. What is shown is the profile's file, with all that it inherits
    written out: redirect it into a file of your own, change it there, and give that to --printer or
    --material. With --keys, NAME is what the keys begin with: wire, or head.
    """
    if ctx.invoked_subcommand is None:
        _tell(None, keys, as_json)


def _tell(name: str | None, keys: bool, as_json: bool) -> None:
    """Print keys, a profile, or the list of profiles."""
    if keys:
        _list_keys(name or "", as_json)
    elif name is None:
        _list_all(as_json)
    else:
        _show(name, as_json)


def _list_all(as_json: bool) -> None:
    headlines = {
        kind: {known: catalogue.headline(catalogue.find(kind, known)) for known in found}
        for kind in catalogue.KINDS
        if (found := catalogue.names(kind))
    }
    if as_json:
        say_json(headlines, indent=2)
        return
    for kind, lines in headlines.items():
        say(f"{kind}:")
        for known, line in lines.items():
            say(f"  {known:20}{line}")


def _show(name: str, as_json: bool) -> None:
    """Print a profile."""
    from wireprint.profile_text import whole

    for kind in catalogue.KINDS:
        if name in catalogue.names(kind):
            lines = list(whole(kind, name))
            if as_json:
                values: dict[str, Any] = tomllib.loads("\n".join(lines))
                say_json({kind.removesuffix("s"): values}, indent=2)
            else:
                say_all(lines)
            return
    everything = [known for kind in catalogue.KINDS for known in catalogue.names(kind)]
    msg = f"no profile is called {name!r}; {catalogue.hint(name, everything)}"
    raise SettingError(msg)


def _list_keys(begin: str, as_json: bool) -> None:
    from wireprint.settings import describe

    every = describe()
    found = [key for key in every if f"{key.short}.".startswith(f"{begin.rstrip('.')}.")]
    found = found if begin else list(every)
    if not found:
        sections = sorted({key.short.rpartition(".")[0] for key in every} - {""})
        msg = f"no key begins with {begin!r}; {catalogue.hint(begin, sections)}"
        raise SettingError(msg)
    if as_json:
        say_json({"keys": [key.to_dict() for key in found]}, indent=2)
        return

    def lines() -> Iterator[str]:
        for key in found:
            unit = f" {key.unit}" if key.unit else ""
            yield f"{key.short} = {key.default_text}{unit}  ({key.bounds})"
            if key.help:
                yield f"    {key.help}"

    say_all(lines())
