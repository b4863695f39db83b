"""``wireprint config``."""

from __future__ import annotations

import os

import click

from wireprint import catalogue
from wireprint.cli import defaults
from wireprint.cli.say import say
from wireprint.files import OutputError, written_whole


@click.command()
@click.argument("key", required=False, type=click.Choice(list(defaults.BUILT_IN)))
@click.argument("name", required=False)
@click.option("--unset", is_flag=True, help="Forget what was kept for KEY.")
def config(key: str | None, name: str | None, unset: bool) -> None:
    """Show or keep the default printer and material.

    KEY is printer or material, NAME a profile or a TOML file. The variables WIREPRINT_PRINTER and
    WIREPRINT_MATERIAL win over what is kept, --printer and --material over both.
    """
    values = defaults.kept()
    if key is not None and (name is not None or unset):
        values.pop(key, None)
        if name is not None:
            found = catalogue.find("printers" if key == "printer" else "materials", name)
            values[key] = os.path.abspath(found) if name.endswith(".toml") else name
        path = defaults.path()
        try:
            path.parent.mkdir(parents=True, exist_ok=True)
        except OSError as error:
            raise OutputError(f"{path}: {error.strerror}") from None
        written_whole(path, defaults.as_toml(values))
    for shown in defaults.BUILT_IN if key is None else [key]:
        value, origin = defaults.default(shown)
        say(f"{shown}: {value} ({origin})")
