"""``wireprint profiles``."""

from __future__ import annotations

import click

from wireprint import catalogue
from wireprint._core import SettingError
from wireprint.cli import completion
from wireprint.cli.say import say, say_all


@click.command()
@click.argument("name", required=False, shell_complete=completion.profiles)
def profiles(name: str | None) -> None:
    """List the profiles, or show one.

    NAME is a printer or a material. What is shown is the profile's file: redirect it into a
    file of your own, change it there, and give that to --printer or --material.
    """
    if name is None:
        for kind in catalogue.KINDS:
            say(f"{kind}:")
            for known in catalogue.names(kind):
                say(f"  {known:18}{catalogue.headline(catalogue.find(kind, known))}")
        return
    for kind in catalogue.KINDS:
        if name in catalogue.names(kind):
            say_all(catalogue.find(kind, name).read_text(encoding="utf-8").splitlines())
            return
    everything = [known for kind in catalogue.KINDS for known in catalogue.names(kind)]
    msg = f"no profile is called {name!r}; {catalogue.hint(name, everything)}"
    raise SettingError(msg)
