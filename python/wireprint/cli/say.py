"""What the command says: lines that no name of a file can break, or take a terminal over with."""

from __future__ import annotations

import json
from typing import TYPE_CHECKING, Any

import click

from wireprint.files import OutputError
from wireprint.text import one_line

if TYPE_CHECKING:
    from collections.abc import Iterable


def say(*lines: str, err: bool = False) -> None:
    """Print lines, each of which stays one.

    Parameters
    ----------
    *lines
        What is said.
    err
        Whether on stderr: where it is no result, or stdout holds the result itself.
    """
    for line in lines:
        _echo(one_line(line), err)


def say_all(lines: Iterable[str], *, err: bool = False) -> None:
    """Print lines as they come."""
    for line in lines:
        say(line, err=err)


def say_json(found: Any, *, indent: int | None = None, err: bool = False) -> None:
    """Print an object as JSON, all of it ASCII."""
    _echo(json.dumps(found, indent=indent), err)


def _echo(text: str, err: bool) -> None:
    try:
        click.echo(text, err=err)
    except BrokenPipeError:
        raise
    except OSError as error:
        name = "stderr" if err else "stdout"
        raise OutputError(f"{name}: {error.strerror or error}") from None
