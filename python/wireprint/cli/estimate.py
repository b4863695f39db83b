"""``wireprint estimate``."""

from __future__ import annotations

from typing import TYPE_CHECKING

import click

from wireprint.cli.amounts import Amount
from wireprint.cli.paths import InputFile
from wireprint.cli.say import say, say_json
from wireprint.duration import duration
from wireprint.limits import FIRMWARES, Firmware
from wireprint.timed_machine import Choice
from wireprint.timing import Allowances, Estimate, estimate_files

if TYPE_CHECKING:
    from pathlib import Path


@click.command()
@click.argument(
    "files",
    nargs=-1,
    required=True,
    type=InputFile(),
)
@click.option(
    "--firmware",
    type=click.Choice(FIRMWARES),
    help="Whose planner; default: the printer's own, klipper with --limits.",
)
@click.option(
    "--printer", help="Profile whose limits apply; default: the file's own, else kossel-mini."
)
@click.option("--limits", metavar="FILE.toml#TABLE", help="Limits in place of a printer's.")
@click.option("--material", help="Profile of the filament; default: the file's own, else abs.")
@click.option("--homing-s", type=Amount(min=0), default=0.0, help="Seconds allowed for each G28.")
@click.option(
    "--nozzle-heating-s",
    type=Amount(min=0),
    default=0.0,
    help="Seconds allowed for each M109 that raises the temperature.",
)
@click.option(
    "--bed-heating-s",
    type=Amount(min=0),
    default=0.0,
    help="Seconds allowed for each M190 that raises the temperature.",
)
@click.option(
    "--tool-change-s",
    type=Amount(min=0),
    default=0.0,
    help="Seconds allowed for each change of tool or filament.",
)
@click.option("--json", "as_json", is_flag=True, help="Print one object; a list for many files.")
def estimate(
    files: tuple[Path, ...],
    firmware: Firmware | None,
    printer: str | None,
    limits: str | None,
    material: str | None,
    homing_s: float,
    nozzle_heating_s: float,
    bed_heating_s: float,
    tool_change_s: float,
    as_json: bool,
) -> None:
    """Tell how long G-code takes to print.

    FILES may come from any program; - is stdin. The time is that of the firmware's own look-ahead
    planner; homing, heating and changes of tool count nothing unless seconds are allowed for them.
    """
    choice = Choice(limits, printer, material, firmware)
    allowances = Allowances(homing_s, nozzle_heating_s, bed_heating_s, tool_change_s)
    estimates = estimate_files(files, choice, allowances)
    if as_json:
        objects = [
            {"file": str(path), **one.to_dict()} for path, one in zip(files, estimates, strict=True)
        ]
        say_json(objects[0] if len(objects) == 1 else objects, indent=2)
        return
    for path, one in zip(files, estimates, strict=True):
        _show(path, one)
    if len(files) > 1:
        say(f"all: {duration(sum(one.total_s for one in estimates))}")


def _show(path: Path, one: Estimate) -> None:
    machine = "limits" if one.printer is None else one.printer
    by = f"{one.firmware}, {machine} {one.why}"
    say(f"{path}: {duration(one.total_s)} ({one.total_s:.1f} s, {by})")
    if one.stated_s:
        share = one.total_s / one.stated_s - 1
        say(f"  the program that wrote it says {duration(one.stated_s)}: {share:+.0%}")
    rows = dict(sorted(one.by_feature.items(), key=lambda row: -row[1]))
    rows |= {"homing": one.homing_s, "heating": one.heating_s, "tool changes": one.tool_change_s}
    for name, seconds in rows.items():
        if seconds > 0:
            say(f"  {name:24} {duration(seconds):>8} {seconds / one.total_s:6.1%}")
    say(
        f"  filament: {one.filament_mm:.0f} mm, {one.filament_g:.1f} g, "
        f"cost {one.filament_cost:.2f}; layers: {len(one.by_layer)}"
    )
    for remark in one.remarks:
        say(f"  {remark}", err=True)
    if one.garbage_lines:
        say(f"  lines that firmware would refuse: {one.garbage_lines}", err=True)
