"""``wireprint bench``."""

from __future__ import annotations

from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from wireprint import files
from wireprint.cli.budget import Duration
from wireprint.cli.options import Chosen, chosen_from, settings_options
from wireprint.cli.paths import OutputName
from wireprint.cli.placement import orient_option, placement_options
from wireprint.cli.progress import Progress
from wireprint.cli.say import say_all, say_json
from wireprint.files import Output
from wireprint.streams import STREAM

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
    type=OutputName(),
    metavar="RESULTS",
    help="Table to write, .parquet or .csv; rows that are already there are not made again. "
    "- writes CSV to stdout, and keeps nothing of a run that is stopped.",
)
@click.option(
    "--compare/--no-compare",
    default=True,
    help="Every condition of `wireprint compare`, or the wire print alone.",
)
@click.option("--jobs", type=click.IntRange(min=1), help="Processes; default: one a core.")
@click.option("--scheduler", metavar="ADDRESS", help="Dask scheduler, such as tcp://host:8786.")
@click.option(
    "--limit",
    "limit_s",
    type=Duration(),
    metavar="TIME",
    help="What one model may take, such as 90s or 5min; it is a failure then, like others.",
)
@click.option("--retry-failed", is_flag=True, help="Try models again whose row is a failure.")
@settings_options
@placement_options
@orient_option
@click.option("--json", "as_json", is_flag=True, help="Print one JSON object instead of words.")
@click.pass_context
def bench(
    ctx: click.Context,
    /,
    models: tuple[str, ...],
    output: str,
    compare: bool,
    jobs: int | None,
    scheduler: str | None,
    limit_s: float | None,
    retry_failed: bool,
    as_json: bool,
    orient: bool,
    **options: Any,
) -> None:
    """Compare and judge many models at once.

    MODELS are files, folders, glob patterns, or manifests: CSV files with a column `name` and, if
    need be, `scale` and `up_axis`; - is a manifest on stdin. Each model becomes a row; one that
    fails has the reason in the column `error`. Projects bring their settings, over which the
    options are laid; what is marked in a 3MF file is one more condition. A run that was stopped
    goes on where it was.
    """
    from wireprint.bench import figures, run
    from wireprint.bench.plan import Placement, plan
    from wireprint.bench.summary import summary
    from wireprint.bench.table import SUFFIXES, Table
    from wireprint.bench.task import Job

    chosen = chosen_from(options)
    settings = chosen.settings().model_dump(mode="json")
    job = Job(settings, figures.comparison if compare else figures.certificate, orient, limit_s)
    fingerprint = {"settings": settings, "compare": compare, "orient": orient}
    tasks = plan(models, Placement(**options), fingerprint, partial(_own_settings, chosen))
    inputs = [*(name for name in models if name != STREAM), *(task.model for task in tasks)]
    target = files.output(output, "results.csv", SUFFIXES, [*inputs, *chosen.files])
    picture = _picture(target) if compare else None
    workers = run.cluster(job, scheduler) if scheduler else run.local(job, jobs)
    with Progress(len(tasks), lines=True) as progress:

        def show(task: Task, row: Row) -> None:
            progress.show(Path(task.model).name)
            progress.advance(failed=bool(row["error"]))

        target.make_folder()
        table = Table(target.path)
        rows = run.run(tasks, table, workers, retry_failed=retry_failed, on_row=show)
    found = {
        "results": str(target),
        "printer": settings["printer"]["name"],
        "material": settings["material"]["name"],
        "histogram": _histogram(rows, picture),
        **summary(rows),
    }
    to_stderr = target.path is None
    if as_json:
        say_json(found, err=to_stderr)
    else:
        say_all(_lines(found), err=to_stderr)
    ctx.exit(1 if found["failed"] == found["models"] else 0)


def _own_settings(chosen: Chosen, path: Path) -> dict[str, Any] | None:
    """Return a project's settings with what was chosen laid over; None for other models."""
    from wireprint.file3mf import project_settings

    found = project_settings(path)
    return None if found is None else chosen.over(found).model_dump(mode="json")


def _picture(target: Output) -> Output | None:
    """Return where the histogram goes: beside the table, unless something else is there."""
    if target.path is None:
        return None
    from wireprint.bench.histogram import is_ours

    picture = target.path.with_suffix(".png")
    if picture.exists() and not is_ours(picture):
        msg = f"{picture}: this is no histogram of a bench, and would be lost; name another table"
        raise files.OutputError(msg)
    return Output(picture)


def _histogram(rows: Sequence[Row], picture: Output | None) -> str | None:
    """Draw the wire prints' speed-ups, if there are any."""
    from wireprint.bench.summary import speedups_of

    values = speedups_of(rows, "wireprint")
    if not values or picture is None:
        return None
    from wireprint.bench.histogram import png

    title = f"Wire prints of {len(values)} models"
    picture.write(png(values, title, "times faster than layer-wise, solid"))
    return str(picture)


def _lines(found: dict[str, Any]) -> Iterator[str]:
    """Say what the run amounts to."""
    yield (
        f"{found['results']}: {found['models']} models on {found['printer']} with "
        f"{found['material']}, {found['certified']} certified, {found['failed']} failed"
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
