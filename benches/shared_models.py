"""What the scripts have in common that measure the shared models: the run, and Markdown."""

import argparse
import os
from dataclasses import replace
from pathlib import Path

from wireprint.bench.local import Processes, cores
from wireprint.bench.plan import Placement, plan
from wireprint.bench.pool import rows
from wireprint.bench.task import Job
from wireprint.settings import Settings

REPOSITORY = Path(__file__).parents[1]
SHARED = Path(os.environ.get("WIREPRINT_SHARED", REPOSITORY.parent / "shared"))
#: Some models are larger than the Kossel Mini's bed; only the bed grows for them, not the head.
ROOMY = ("bed.diameter_mm=400", "bed.height_mm=400", "motion.print_radius=200")
#: The least that a bed measures which has room for every shared model, mm.
ROOM_MM = 400.0


def roomy(machine):
    """Settings of a "printer/material" on a bed with room for every shared model."""
    settings = Settings.load(*machine.split("/"))
    bed, motion = settings.printer.bed, settings.printer.motion
    sizes = [name for name, value in bed if name.endswith("_mm") and value is not None]
    wide = {f"bed.{name}": max(ROOM_MM, getattr(bed, name)) for name in sizes}
    if motion.print_radius is not None:
        wide["motion.print_radius"] = max(ROOM_MM / 2, motion.print_radius)
    overrides = [f"{name}={value}" for name, value in wide.items()]
    return Settings.load(*machine.split("/"), overrides=overrides)


def on_each(machines, models, evaluate, jobs, only="", known=()):
    """Evaluate models (see `plan`) on printers; yield printer, model and row as they come.

    `only`: those whose file's name has this text; `known`: printers and names that are left out.
    """
    tasks, of = [], {}
    for machine in machines:
        settings = roomy(machine).model_dump(mode="json")
        for task in plan(models, Placement(), {}):
            name = Path(task.model).name
            if only not in name or (machine, name) in known:
                continue
            of[len(tasks)] = machine
            tasks.append(replace(task, index=len(tasks), settings=settings))
    with Processes(Job(Settings.load().model_dump(mode="json"), evaluate), jobs) as pool:
        for task, row in rows(tasks, pool):
            yield of[task.index], Path(task.model).name, row


def arguments(description, target):
    """Read the command line: a manifest, the page to write, and the number of processes."""
    parser = argparse.ArgumentParser(description=description)
    parser.add_argument("manifest", nargs="?", default=str(SHARED / "models" / "manifest.csv"))
    parser.add_argument("-o", "--output", type=Path, default=REPOSITORY / "docs" / target)
    parser.add_argument("--jobs", type=int, default=cores())
    return parser.parse_args()


def evaluated(options, evaluate):
    """Evaluate every model of the manifest; return the rows in the manifest's order."""
    settings = Settings.load(overrides=ROOMY)
    tasks = plan([options.manifest], Placement(), {})
    with Processes(Job(settings.model_dump(mode="json"), evaluate), options.jobs) as pool:
        found = sorted(rows(tasks, pool), key=lambda pair: pair[0].index)
    return [row | {"model": Path(task.model).name} for task, row in found]


def markdown(columns, rows):
    """Lay out rows as a table; a column is a heading and a function of a row.

    The row of a model that failed holds the reason, after the columns that are known.
    """
    lines = [
        "| " + " | ".join(columns) + " |",
        "|---" + "|---:" * (len(columns) - 1) + "|",
    ]
    lines += ["| " + " | ".join(_cells(columns, row)) + " |" for row in rows]
    return "\n".join(lines)


def _cells(columns, row):
    cells = []
    for cell in columns.values():
        try:
            cells.append(cell(row))
        except KeyError:
            reason = (row["error"] or "").removesuffix(".").replace("|", "/")
            return [*cells, reason, *[""] * (len(columns) - len(cells) - 1)]
    return cells
