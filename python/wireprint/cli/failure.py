"""Failures of the command: what is said about them, and the exit code."""

from __future__ import annotations

import os
import sys
from typing import TYPE_CHECKING, NoReturn

import click

from wireprint._core import WireprintError
from wireprint.cli.parallel import deserted
from wireprint.cli.say import say, say_json

if TYPE_CHECKING:
    from collections.abc import Sequence

# Those of wireprint's own exceptions are theirs; README has the table.
EXIT_FAULT = 1
EXIT_USAGE = 2
EXIT_UNREADABLE = 3
#: As shells do: 128 and the signal's number.
EXIT_INTERRUPTED = 130
EXIT_BROKEN_PIPE = 141


class Unread(Exception):  # noqa: N818 - nothing is wrong
    """Nobody reads any more what is written to stdout."""


def exit_code_of(error: BaseException) -> int:
    """Return the exit code of a failure."""
    if isinstance(error, click.ClickException):
        return EXIT_USAGE
    if isinstance(error, click.Abort | KeyboardInterrupt):
        return EXIT_INTERRUPTED
    if isinstance(error, WireprintError):
        return error.exit_code
    if isinstance(error, Unread):
        return EXIT_BROKEN_PIPE
    # What cannot be written is an `OutputError`.
    return EXIT_UNREADABLE if isinstance(error, OSError) else EXIT_FAULT


def message_of(error: BaseException) -> str:
    """Return what is said about a failure; more than one line only where the last one helps."""
    if isinstance(error, click.ClickException):
        return error.format_message()
    if isinstance(error, click.Abort | KeyboardInterrupt):
        return "stopped"
    if isinstance(error, WireprintError):
        return str(error)
    if isinstance(error, OSError):
        place = f"{error.filename}: " if error.filename else ""
        return f"{place}{error.strerror or error}"
    return f"unexpected {type(error).__name__}: {error}"


def say_failure(error: BaseException, about: str = "") -> None:
    """Say on stderr what failed.

    Parameters
    ----------
    error
        What was raised.
    about
        File that it is about, if the error may not name it.
    """
    message = message_of(error)
    if about and not message.startswith(about):
        message = f"{about}: {message}"
    say(*f"wireprint: error: {message}".split("\n"), err=True)
    if isinstance(error, click.UsageError) and error.ctx is not None:
        say(f"Try '{error.ctx.command_path} --help' for help.", err=True)
    elif exit_code_of(error) == EXIT_FAULT and not isinstance(error, WireprintError):
        say("This is a fault of wireprint; WIREPRINT_TRACEBACK=1 shows where.", err=True)


def fail(error: BaseException, arguments: Sequence[str]) -> NoReturn:
    """End the command: say why, and leave with the exit code.

    Parameters
    ----------
    error
        What was raised.
    arguments
        The command line; where it asks for JSON, the failure is an object on stdout, too.
    """
    if os.environ.get("WIREPRINT_TRACEBACK"):
        raise error
    code = exit_code_of(error)
    if isinstance(error, Unread):
        # What is left in the buffers would only fail again.
        os.dup2(os.open(os.devnull, os.O_WRONLY), 1)
    else:
        if "--json" in arguments:
            say_json({"error": message_of(error), "exit_code": code})
        say_failure(error)
    leave(code)


def leave(code: int) -> NoReturn:
    """Exit, with stdout written out or the failure to do so told."""
    try:
        sys.stdout.flush()
    except BrokenPipeError:
        os.dup2(os.open(os.devnull, os.O_WRONLY), 1)
        code = code or EXIT_BROKEN_PIPE
    except OSError as error:
        os.dup2(os.open(os.devnull, os.O_WRONLY), 1)
        say(f"wireprint: error: stdout: {error.strerror}", err=True)
        code = code or EXIT_USAGE
    if deserted():
        # Threads that are still at work in the core must not find the interpreter gone.
        sys.stderr.flush()
        os._exit(code)
    sys.exit(code)
