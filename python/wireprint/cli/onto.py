"""The options that tell what stands on the bed already."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, TypeVar

import click

from wireprint.cli.paths import InputFile

if TYPE_CHECKING:
    from collections.abc import Callable
    from pathlib import Path

    from wireprint.settings import Settings
    from wireprint.standing import Standing

Command = TypeVar("Command", bound="Callable[..., object]")


def onto_options(command: Command) -> Command:
    """Add the options that `onto_from` takes."""
    options = (
        click.option(
            "--onto",
            multiple=True,
            type=InputFile(),
            metavar="OTHER.gcode",
            help="An earlier print that stands on the bed: it is kept clear of, printed onto, and "
            "not printed again; may be repeated.",
        ),
        click.option(
            "--stopped",
            metavar="MM|line:N",
            help="Height or line at which the last of these prints was stopped.",
        ),
        click.option(
            "--obstacle",
            multiple=True,
            type=InputFile(),
            metavar="MODEL",
            help="An object that stands on the bed, in its file's own coordinates from the "
            "middle of the bed; may be repeated.",
        ),
        click.option(
            "--at",
            "at_mm",
            type=float,
            nargs=2,
            metavar="X Y",
            help="Where the model stands, from the middle of the bed, mm.",
        ),
        click.option(
            "--lift",
            "lift_mm",
            type=float,
            default=0.0,
            metavar="MM",
            help="Height of what the model stands on, such as the top of an earlier print.",
        ),
    )
    for option in reversed(options):
        command = option(command)
    return command


@dataclass(frozen=True)
class Onto:
    """What the options say."""

    prints: tuple[Path, ...]
    stopped: str | None
    obstacles: tuple[Path, ...]
    at_mm: tuple[float, float, float]

    def __bool__(self) -> bool:
        """Whether anything stands."""
        return bool(self.prints or self.obstacles)

    @property
    def files(self) -> list[Path]:
        """Files of the user's that are read."""
        return [*self.prints, *self.obstacles]

    def options(self, settings: Settings) -> dict[str, Any]:
        """Read what stands; return what `wireprint.make` takes."""
        found: dict[str, Any] = {} if not any(self.at_mm) else {"at_mm": self.at_mm}
        return found | ({"standing": self.standing(settings)} if self else {})

    def standing(self, settings: Settings) -> Standing:
        """Read what stands."""
        from wireprint.standing import Standing, read_prints
        from wireprint.stopped import Stopped

        stopped = None if self.stopped is None else Stopped.read(self.stopped)
        prints = read_prints(self.prints, settings, stopped)
        objects = b""
        for path in self.obstacles:
            from wireprint.obstacles import as_gcode, load_object

            mesh, at_mm = load_object(path)
            objects += as_gcode(mesh, settings, at_mm)
        return Standing(prints, objects, settings)


def onto_from(options: dict[str, Any]) -> Onto:
    """Take the options of `onto_options` out of a command's own."""
    x, y = options.pop("at_mm") or (0.0, 0.0)
    found = Onto(
        options.pop("onto"),
        options.pop("stopped"),
        options.pop("obstacle"),
        (x, y, options.pop("lift_mm")),
    )
    if found.stopped is not None and not found.prints:
        raise click.UsageError(
            "--stopped tells where an earlier print was stopped: name it by --onto"
        )
    return found
