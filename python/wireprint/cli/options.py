"""The options that choose settings, for every command that prints."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any, TypeVar, get_args

import click

from wireprint.choices import (
    CoolingMethod,
    Flavor,
    Pattern,
    Placement,
    Strategy,
    Supports,
    TypeWords,
)
from wireprint.cli import completion
from wireprint.cli.defaults import BUILT_IN, default
from wireprint.cli.paths import InputFile

if TYPE_CHECKING:
    from collections.abc import Callable

    from wireprint.model import Model
    from wireprint.settings import Settings

Command = TypeVar("Command", bound="Callable[..., object]")

#: Options that stand for one key of the settings: name → (key, choices or type, help).
_KEYS: dict[str, tuple[str, Any, str]] = {
    "flavor": (
        "gcode.flavor",
        click.Choice(get_args(Flavor)),
        "Firmware that reads the G-code.",
    ),
    "type_words": (
        "gcode.type_words",
        click.Choice(get_args(TypeWords)),
        "Words after ;TYPE:, ours or those that PrusaSlicer's viewer colours.",
    ),
    "slab_min": ("wire.slab_min_mm", float, "Lowest slab, mm."),
    "slab_max": ("wire.slab_max_mm", float, "Highest slab, mm."),
    "pattern": (
        "wire.pattern",
        click.Choice(get_args(Pattern)),
        "Contours and zigzags, or zigzags alone.",
    ),
    "placement": (
        "wire.placement",
        click.Choice(get_args(Placement)),
        "Rule by which posts are placed.",
    ),
    "strategy": (
        "wire.strategy",
        click.Choice(get_args(Strategy)),
        "What keeps floating strokes from sagging.",
    ),
    "pause": (
        "wire.pause_s",
        str,
        "Pause at the end of a floating stroke, s; auto: until it holds.",
    ),
    "cooling": (
        "cooling.method",
        click.Choice(get_args(CoolingMethod)),
        "What solidifies floating strokes.",
    ),
    "supports": (
        "wire.supports",
        click.Choice(get_args(Supports)),
        "What carries parts that would hang in the air.",
    ),
}


def settings_options(command: Command) -> Command:
    """Add the options that `chosen_from` understands."""
    options = [
        click.option(
            "--printer",
            shell_complete=completion.printers,
            show_default=BUILT_IN["printer"],
            metavar="NAME|FILE",
            help="Printer's profile.",
        ),
        click.option(
            "--material",
            shell_complete=completion.materials,
            show_default=BUILT_IN["material"],
            metavar="NAME|FILE",
            help="Material's profile.",
        ),
        click.option(
            "--nozzle",
            type=float,
            metavar="MM",
            help="Another nozzle than the profile's, such as 0.6; what depends on it changes, too.",
        ),
        click.option(
            "--load",
            multiple=True,
            type=InputFile(must_be_there=False),
            metavar="FILE.toml",
            help="File with settings that differ from the profiles; may be repeated.",
        ),
        click.option(
            "--set",
            "overrides",
            shell_complete=completion.settings,
            multiple=True,
            metavar="KEY=VALUE",
            help="A single setting, such as head.slant_deg=40; may be repeated.",
        ),
        *(
            click.option(f"--{name.replace('_', '-')}", name, type=kind, help=text)
            for name, (_, kind, text) in _KEYS.items()
        ),
        click.option(
            "--caps/--no-caps", default=None, help="Close flat faces, or leave them open."
        ),
    ]
    for option in reversed(options):
        command = option(command)
    return command


@dataclass(frozen=True)
class Chosen:
    """What the options of `settings_options` say; None: nothing."""

    printer: str | None
    material: str | None
    load: tuple[Path, ...]
    overrides: tuple[str, ...]
    #: Diameter of the nozzle, mm.
    nozzle_mm: float | None = None

    @property
    def files(self) -> list[Path]:
        """Files of the user's that are read."""
        # What stands behind a # completes a file of another program.
        named = [
            Path(name.partition("#")[0])
            for name in (self.printer, self.material)
            if name is not None
        ]
        return [*named, *self.load]

    def settings(self) -> Settings:
        """Compose the settings from profiles."""
        from wireprint.settings import Settings

        return Settings.load(*self._all())

    def recalled(self) -> Settings:
        """Compose the settings as `settings` does, for one who does no more than read them."""
        from wireprint import _recall

        return _recall.settings(*self._all())

    def of(self, model: Model) -> Settings:
        """Lay what was chosen over a project's settings; any other model has those of profiles."""
        return self.settings() if model.settings is None else self.over(model.settings)

    def _all(self) -> tuple[str, str, tuple[Path, ...], tuple[str, ...], float | None]:
        printer = self.printer or default("printer")[0]
        material = self.material or default("material")[0]
        return printer, material, self.load, self.overrides, self.nozzle_mm

    def over(self, settings: Settings) -> Settings:
        """Lay what was chosen over other settings, such as a project's."""
        return settings.but(self.printer, self.material, self.load, self.overrides, self.nozzle_mm)


def chosen_from(options: dict[str, Any]) -> Chosen:
    """Take the options of `settings_options` out of a command's own."""
    for name in ("printer", "material"):
        if options[name] == "":
            raise click.UsageError(f"--{name}: the name is empty")
    overrides = list(options.pop("overrides"))
    keys = {name: key for name, (key, _, _) in _KEYS.items()} | {"caps": "wire.caps"}
    for name, key in keys.items():
        value = options.pop(name)
        if value is not None:
            overrides.append(f"{key}={str(value).lower() if name == 'caps' else value}")
    return Chosen(
        options.pop("printer"),
        options.pop("material"),
        options.pop("load"),
        tuple(overrides),
        options.pop("nozzle"),
    )
