"""``wireprint compare``."""

from __future__ import annotations

import json
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from wireprint.cli.marks import marks_from, marks_options
from wireprint.cli.options import chosen_from, settings_options
from wireprint.cli.placement import placement_options

if TYPE_CHECKING:
    from wireprint.comparison import Comparison

#: Length of the longest bar, characters.
_BAR = 20


@click.command()
@click.argument("model", type=click.Path(path_type=Path))
@click.option(
    "-o",
    "--output",
    type=click.Path(dir_okay=False, path_type=Path),
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
    output: Path | None,
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
    loaded = marks.load(model, options)
    settings = chosen.of(loaded)
    found = compared(loaded.mesh, settings, conditions or None, loaded.region)
    if output is not None:
        from wireprint import chart
        from wireprint.files import written_whole

        written_whole(output, chart.png(found, f"{model.name} on {settings.printer.name}"))
    if as_json:
        about = {"model": str(model), "printer": settings.printer.name}
        click.echo(json.dumps(about | found.to_dict(), indent=2))
    else:
        _show(found)


def _show(found: Comparison) -> None:
    from rich import box
    from rich.console import Console
    from rich.table import Table

    from wireprint.timing import clock

    longest_s = max(row.print_time_s for row in found.conditions)
    table = Table(box=box.SIMPLE_HEAD)
    table.add_column("condition", no_wrap=True)
    for name in ("time", "filament", "speed-up"):
        table.add_column(name, justify="right", no_wrap=True)
    table.add_column("")
    for row in found.conditions:
        table.add_row(
            row.condition,
            clock(row.print_time_s),
            f"{row.filament_g:.1f} g",
            f"{row.speedup:.1f}×",
            "█" * max(1, round(_BAR * row.print_time_s / longest_s)),
        )
    Console().print(table)
