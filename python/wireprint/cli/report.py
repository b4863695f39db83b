"""``wireprint report``."""

from __future__ import annotations

from dataclasses import asdict
from typing import TYPE_CHECKING, Any

import click

from wireprint import files
from wireprint.cli.paths import InputFile, OutputName
from wireprint.cli.say import say, say_json
from wireprint.streams import STREAM

if TYPE_CHECKING:
    from pathlib import Path

    from wireprint.bench.kinds import Changes


@click.command()
@click.argument("results", type=InputFile(), metavar="RESULTS")
@click.option(
    "-o", "--output", required=True, type=OutputName(), metavar="PAGE", help="HTML page to write."
)
@click.option(
    "--against",
    type=InputFile(),
    metavar="BEFORE",
    help="Older results of the same models: tells what changed.",
)
@click.option("--json", "as_json", is_flag=True, help="Print one JSON object instead of words.")
def report(results: Path, output: str, against: Path | None, as_json: bool) -> None:
    """Write a page about the results of a bench.

    RESULTS is a table of `wireprint bench`, .parquet or .csv. The kind of a model is the folder
    that it is in. The page is one file that needs no other.
    """
    inputs = [path for path in (results, against) if path is not None]
    target = files.output(output, f"{results.stem}.html", files.PAGE_SUFFIXES, inputs)
    from wireprint.bench.kinds import by_kind, changes
    from wireprint.bench.page import html
    from wireprint.bench.summary import summary
    from wireprint.bench.table import rows_of

    rows = rows_of(results)
    before = None if against is None else rows_of(against)
    target.write(html(rows, f"Results: {results.name}", before, str(against)))
    found: dict[str, Any] = {
        "page": str(target),
        "kinds": {kind: summary(members) for kind, members in by_kind(rows).items()},
        "changes": None if before is None else _told(changes(before, rows)),
    }
    to_stderr = output == STREAM
    if as_json:
        say_json(found, err=to_stderr)
        return
    say(f"{target}: {len(rows)} models of {len(found['kinds'])} kinds", err=to_stderr)
    if found["changes"] is not None:
        for name in ("lost", "won", "failing", "mended"):
            say(f"  {name:12}{len(found['changes'][name])}", err=to_stderr)
        for name, changed in found["changes"]["figures"].items():
            if changed:
                say(f"  {name:24}{len(changed)} changed", err=to_stderr)


def _told(found: Changes) -> dict[str, Any]:
    return asdict(found)
