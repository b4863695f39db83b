"""What shells offer while a command line is typed."""

from __future__ import annotations

from typing import TYPE_CHECKING

from wireprint import catalogue

if TYPE_CHECKING:
    import click


def printers(_ctx: click.Context, _param: click.Parameter, begun: str) -> list[str]:
    """Names of printers that begin so."""
    return _beginning(begun, catalogue.names("printers"))


def materials(_ctx: click.Context, _param: click.Parameter, begun: str) -> list[str]:
    """Names of materials that begin so."""
    return _beginning(begun, catalogue.names("materials"))


def profiles(begun: str) -> list[str]:
    """Names of profiles of any kind that begin so."""
    return _beginning(begun, [name for kind in catalogue.KINDS for name in catalogue.names(kind)])


def settings(_ctx: click.Context, _param: click.Parameter, begun: str) -> list[str]:
    """Keys of settings that begin so, each with the sign that its value follows."""
    from wireprint._compose import keys
    from wireprint.settings import Settings

    return _beginning(begun, [f"{key}=" for key in keys(Settings)])


def _beginning(begun: str, names: list[str]) -> list[str]:
    return [name for name in names if name.startswith(begun)]
