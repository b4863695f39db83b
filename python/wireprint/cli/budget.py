"""The options that give a budget, and what is said of the prints it was chosen from."""

from __future__ import annotations

import re
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Final, TypeVar

import click

from wireprint.cli.paths import OutputName
from wireprint.duration import duration

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator, Mapping

    from wireprint.budget import Budget
    from wireprint.cli.options import Chosen

Command = TypeVar("Command", bound="Callable[..., object]")

_SECONDS: Final = {"h": 3600.0, "min": 60.0, "m": 60.0, "s": 1.0}
_PART: Final = r"(\d+(?:\.\d+)?)\s*"
#: ``1h30min``, ``90min``, ``90s``.
_WORDS: Final = re.compile(
    rf"(?:{_PART}h)?\s*(?:{_PART}m(?:in)?)?\s*(?:{_PART}s)?", re.IGNORECASE | re.ASCII
)
#: ``1:30:00`` or ``20:00``, as times are told.
_CLOCK: Final = re.compile(r"(?:(\d+):)?(\d{1,2}):(\d{2})", re.ASCII)
_WEIGHT: Final = re.compile(rf"{_PART}(g|kg)", re.IGNORECASE | re.ASCII)


class Duration(click.ParamType[float]):
    """``20min``."""

    name = "TIME"

    def convert(
        self, value: Any, param: click.Parameter | None, ctx: click.Context | None
    ) -> float:
        """Read hours, minutes and seconds."""
        if isinstance(value, float):
            return value
        text = value.strip()
        found = _CLOCK.fullmatch(text) or (_WORDS.fullmatch(text) if text else None)
        seconds = 0.0
        if found is not None:
            parts = [float(part or 0) for part in found.groups()]
            seconds = sum(part * unit for part, unit in zip(parts, (3600, 60, 1), strict=True))
        if seconds <= 0:
            self.fail(f"{value!r} is no time with its unit, such as 20min or 1h30min", param, ctx)
        return seconds


class Weight(click.ParamType[float]):
    """``5g``."""

    name = "WEIGHT"

    def convert(
        self, value: Any, param: click.Parameter | None, ctx: click.Context | None
    ) -> float:
        """Read grams."""
        if isinstance(value, float):
            return value
        found = _WEIGHT.fullmatch(value.strip())
        grams = 0.0 if found is None else float(found[1]) * (1000 if len(found[2]) > 1 else 1)
        if grams <= 0:
            self.fail(f"{value!r} is no weight with its unit, such as 5g", param, ctx)
        return grams


def budget_options(command: Command) -> Command:
    """Add the options that `budget_from` takes."""
    options = (
        click.option(
            "--time",
            "budget_time",
            type=Duration(),
            help="Choose the settings: the most faithful and stiffest print within this time.",
        ),
        click.option(
            "--filament",
            "budget_filament",
            type=Weight(),
            help="Likewise, with this much filament at most.",
        ),
        click.option(
            "--alternatives", is_flag=True, help="Tell the prints it was chosen from, as a table."
        ),
        click.option(
            "--alternatives-picture",
            type=OutputName(),
            metavar="FILE.png",
            help="Draw them: deviation over time, the stiffer the darker.",
        ),
    )
    for option in reversed(options):
        command = option(command)
    return command


@dataclass(frozen=True)
class Wanted:
    """What the options say of a budget."""

    budget: Budget | None
    #: Whether the alternatives are told, and where they are drawn.
    table: bool
    picture: str | None


def budget_from(options: dict[str, Any]) -> Wanted:
    """Take the options of `budget_options` out of a command's own."""
    time_s, filament_g = options.pop("budget_time"), options.pop("budget_filament")
    table, picture = options.pop("alternatives"), options.pop("alternatives_picture")
    if time_s is None and filament_g is None:
        if table or picture is not None:
            raise click.UsageError("alternatives are those within a budget: give --time")
        return Wanted(None, table=False, picture=None)
    from wireprint.budget import Budget

    return Wanted(Budget(time_s, filament_g), table, picture)


def named_keys(chosen: Chosen) -> frozenset[str]:
    """Return the keys of ``[wire]`` that single options or --set named: they are kept."""
    names = (override.partition("=")[0].strip() for override in chosen.overrides)
    return frozenset(name if name.startswith("wire.") else f"wire.{name}" for name in names)


def table(found: Mapping[str, Any]) -> Iterator[str]:
    """Return the alternatives as a table; `found` is ``budget`` of ``--json``."""
    yield f"    {'time':>8} {'g':>6} {'off mm':>7} {'gives mm':>9} {'covered':>8}"
    for one in found["alternatives"]:
        mark = "→" if one["chosen"] else " " if one["within"] else "✗"
        sets = " ".join(one["overrides"]) or "as set"
        yield (
            f"  {mark} {duration(one['print_time_s']):>8} {one['filament_g']:6.2f} "
            f"{one['deviation_mm']:7.3f} {one['give_mm']:9.3f} {one['coverage']:8.1%}  {sets}"
        )
    by = {
        "growth": "95 % of the posts give way by no more to the nozzle's pull (wire.pull_n), "
        "in the frame as it grows",
        "single posts": "95 % of the posts give way by no more, each taken by itself: the frame "
        "as it grows would take too much work",
    }[found["give_by"]]
    yield f"    gives: {by}"
    yield f"    → printed, ✗ over the budget; {found['tried']} prints were tried"
