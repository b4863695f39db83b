"""Files on the command line: what is read, by ``-`` from stdin, and where output goes."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import click
from click.shell_completion import CompletionItem

from wireprint import streams
from wireprint.streams import STREAM


class _FileName(click.ParamType[Any]):
    """A name that shells complete with those of files."""

    def shell_complete(
        self, ctx: click.Context, param: click.Parameter, incomplete: str
    ) -> list[CompletionItem]:
        """Leave it to the shell."""
        return [CompletionItem(incomplete, type="file")]


class InputFile(_FileName):
    """A file that is read; ``-`` is stdin, and what comes through a pipe is kept meanwhile.

    Parameters
    ----------
    must_be_there
        Whether one that cannot be read ends the command, rather than failing by itself later.
    """

    name = "FILE"

    def __init__(self, *, must_be_there: bool = True) -> None:
        self._must_be_there = must_be_there

    def convert(self, value: Any, param: click.Parameter | None, ctx: click.Context | None) -> Path:
        """Return a path that can be read as often as needed."""
        if value == "":
            self.fail("the name of the file is empty", param, ctx)
        path = streams.STDIN if value == STREAM else Path(value)
        # What is not there, or is a folder, can wait to be found out; a pipe cannot.
        if not self._must_be_there and (not path.exists() or path.is_dir()):
            return path
        return streams.regular(path)


class OutputName(_FileName):
    """A name as it was given: a slash at its end matters."""

    name = "OUT"

    def convert(self, value: Any, param: click.Parameter | None, ctx: click.Context | None) -> str:
        """Return it."""
        if value == "":
            self.fail("the name of the file to write is empty", param, ctx)
        return str(value)
