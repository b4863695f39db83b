"""``wireprint bench``."""

from __future__ import annotations

import json
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from wireprint.cli.options import Chosen, chosen_from, settings_options
from wireprint.cli.placement import orient_option, placement_options
from wireprint.cli.progress import Progress

if TYPE_CHECKING:
    from collections.abc import Iterator, Sequence

    from wireprint.bench.plan import Task
    from wireprint.bench.task import Row

#: Failures that are named; the rest is counted.
SHOWN = 10


@click.command()
@click.argument("models", nargs=-1, required=True)
@click.option(
    "-o",
    "--output",
    required=True,
    type=click.Path(dir_okay=False, path_type=Path),
    metavar="RESULTS",
    help="Table to write, .parquet or .csv; rows that are already there are not made again.",
)
@click.option(
    "--compare/--no-compare",
    default=True,
    help="Every condition of `wireprint compare`, or the wire print alone.",
)
@click.option("--jobs", type=click.IntRange(min=1), help="Processes; default: one a core.")
@click.option("--scheduler", metavar="ADDRESS", help="Dask scheduler, such as tcp://host:8786.")
@click.option("--retry-failed", is_flag=True, help="Try models again whose row is a failure.")
@settings_options
@placement_options
@orient_option
@click.option("--json", "as_json", is_flag=True, help="Print one JSON object instead of words.")
def bench(
    models: tuple[str, ...],
    output: Path,
    compare: bool,
    jobs: int | None,
    scheduler: str | None,
    retry_failed: bool,
    as_json: bool,
    orient: bool,
    **options: Any,
) -> None:
    """Compare and judge many models at once.

    MODELS are files, folders, glob patterns, or manifests: CSV files with a column `name` and, if
    need be, `scale` and `up_axis`. Each model becomes a row; one that fails has the reason in the
    column `error`. Projects bring their settings, over which the options are laid; what is marked
    in a 3MF file is one more condition. A run that was stopped goes on where it was.
    """
    from wireprint.bench import figures, run
    from wireprint.bench.plan import Placement, plan
    from wireprint.bench.summary import summary
    from wireprint.bench.table import Table
    from wireprint.bench.task import Job

    chosen = chosen_from(options)
    settings = chosen.settings().model_dump(mode="json")
    job = Job(settings, figures.comparison if compare else figures.certificate, orient)
    fingerprint = {"settings": settings, "compare": compare, "orient": orient}
    tasks = plan(models, Placement(**options), fingerprint, partial(_own_settings, chosen))
    workers = run.cluster(job, scheduler) if scheduler else run.local(job, jobs)
    with Progress(len(tasks)) as progress:

        def show(task: Task, row: Row) -> None:
            progress.show(Path(task.model).name)
            progress.advance()

        rows = run.run(tasks, Table(output), workers, retry_failed=retry_failed, on_row=show)
    found = {"results": str(output), "histogram": _histogram(rows, output), **summary(rows)}
    click.echo(json.dumps(found) if as_json else "\n".join(_lines(found)))


def _own_settings(chosen: Chosen, path: Path) -> dict[str, Any] | None:
    """Return a project's settings with what was chosen laid over; None for other models."""
    from wireprint.file3mf import project_settings

    found = project_settings(path)
    return None if found is None else chosen.over(found).model_dump(mode="json")


def _histogram(rows: Sequence[Row], output: Path) -> str | None:
    """Draw the wire prints' speed-ups beside the table, if there are any."""
    from wireprint.bench.summary import speedups_of

    values = speedups_of(rows, "wireprint")
    if not values:
        return None
    from wireprint.bench.histogram import png
    from wireprint.files import written_whole

    picture = output.with_suffix(".png")
    title = f"Wire prints of {len(values)} models"
    written_whole(picture, png(values, title, "times faster than layer-wise, solid"))
    return str(picture)


def _lines(found: dict[str, Any]) -> Iterator[str]:
    """Say what the run amounts to."""
    yield (
        f"{found['results']}: {found['models']} models, {found['certified']} certified, "
        f"{found['failed']} failed"
    )
    for condition, spread in found["speedup"].items():
        yield f"  {condition:24}{_spread(spread, '.2f')} times as fast"
    for name, form in (("coverage", ".1%"), ("deviation_mm", ".2f"), ("compute_s", ".2f")):
        if found[name] is not None:
            yield f"  {name:24}{_spread(found[name], form)}"
    if found["histogram"] is not None:
        yield f"  {'histogram':24}{found['histogram']}"
    for failure in found["failures"][:SHOWN]:
        yield f"  failed: {failure['model']}: {failure['error']}"
    if len(found["failures"]) > SHOWN:
        yield f"  and {len(found['failures']) - SHOWN} more; see the column error"


def _spread(spread: dict[str, float], form: str) -> str:
    low, high = spread["lower_quartile"], spread["upper_quartile"]
    return f"{spread['median']:{form}} (half of them {low:{form}}–{high:{form}})"
