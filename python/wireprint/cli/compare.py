"""``wireprint compare``."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import click

from wireprint import files
from wireprint._core import MemoryLimitError
from wireprint.cli.marks import marks_from, marks_options
from wireprint.cli.options import chosen_from, settings_options
from wireprint.cli.paths import InputFile, OutputName
from wireprint.cli.placement import placement_options
from wireprint.cli.say import say, say_json
from wireprint.naming import named
from wireprint.streams import STREAM
from wireprint.text import one_line

if TYPE_CHECKING:
    from pathlib import Path

    from wireprint.comparison import Comparison

#: Length of the longest bar, characters.
_BAR = 20


@click.command()
@click.argument("model", type=InputFile())
@click.option(
    "-o",
    "--output",
    type=OutputName(),
    metavar="CHART.png",
    help="PNG file to draw a bar chart to.",
)
@click.option(
    "--condition",
    "conditions",
    multiple=True,
    metavar="NAME",
    help="Only this way to print; may be repeated.",
)
@marks_options
@settings_options
@placement_options
@click.option("--json", "as_json", is_flag=True, help="Print one JSON object instead of a table.")
def compare(
    model: Path,
    output: str | None,
    conditions: tuple[str, ...],
    as_json: bool,
    **options: Any,
) -> None:
    """Tell how long a model takes as a wire print, and how long in layers.

    The model is sliced in every way: in solid layers with sparse infill, as a frame of its edges,
    as a vase, on a modern fast machine, and as a wire print; where something is marked, as a wire
    print with layers there, too. Every print is timed as its printer's firmware would run it.
    Speed-ups count from the first.
    """
    from wireprint.comparison import compare as compared

    chosen, marks = chosen_from(options), marks_from(options, [model])
    target = None
    if output is not None:
        inputs = [model, *chosen.files, *marks.files]
        target = files.output(output, f"{model.stem}.png", files.PICTURE_SUFFIXES, inputs)
    loaded = marks.load(model, options)
    settings = chosen.of(loaded)
    with named(model, MemoryLimitError):
        found = compared(loaded.mesh, settings, conditions or None, loaded.region)
    to_stderr = output == STREAM
    machine = f"{settings.printer.name} with {settings.material.name}"
    if target is not None:
        from wireprint import chart

        target.write(chart.png(found, one_line(f"{model.name} on {machine}")))
    if as_json:
        about = {
            "model": str(model),
            "printer": settings.printer.name,
            "material": settings.material.name,
        }
        say_json(about | found.to_dict(), indent=2, err=to_stderr)
    else:
        say(f"{model} on {machine}", err=to_stderr)
        _show(found, to_stderr=to_stderr)
        for name, reason in found.failures.items():
            say(f"  {name}: cannot be printed so: {reason}", err=to_stderr)


def _show(found: Comparison, *, to_stderr: bool) -> None:
    from rich import box
    from rich.console import Console
    from rich.table import Table

    from wireprint.duration import duration

    longest_s = max(row.print_time_s for row in found.conditions)
    table = Table(box=box.SIMPLE_HEAD)
    table.add_column("condition", no_wrap=True)
    for name in ("time", "filament", "speed-up"):
        table.add_column(name, justify="right", no_wrap=True)
    table.add_column("")
    for row in found.conditions:
        table.add_row(
            row.condition,
            duration(row.print_time_s),
            f"{row.filament_g:.1f} g",
            f"{row.speedup:.1f}×",
            "█" * max(1, round(_BAR * row.print_time_s / longest_s)),
        )
    Console(stderr=to_stderr).print(table)
