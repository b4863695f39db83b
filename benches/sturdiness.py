"""Writes docs/sturdiness.md: how stiff the wire prints of the shared models are, and at what cost.

python benches/sturdiness.py [--before] [--only TEXT] [-o PAGE] [--jobs N] [--most SECONDS]

Measured by `../shared/tools/stiffness.py` (a beam frame from the G-code alone). --before keeps what
is measured as what later prints are compared with. A print that was measured once is not measured
again: results are kept in `target/sturdiness` by the hash of its moves. What takes the tool longer
than --most is shown without its stiffness.
"""

import argparse
import csv
import functools
import hashlib
import json
import os
import subprocess
import sys
import tempfile
from pathlib import Path
from statistics import median

import shared_models
import sturdiness_goals
from certificates import BREACHES
from wireprint.duration import duration
from wireprint.pipeline import make

MACHINES = ("kossel-mini/abs", "prusa-mk4s/pla", "voron-2.4/abs", "printrbot-simple/pla")
#: Moduli of the materials, MPa, as the tool has them.
MODULI_MPA = {"abs": 2200.0, "pla": 3300.0}
BEFORE = Path(__file__).parent / "sturdiness_before.tsv"
CACHE = shared_models.REPOSITORY / "target" / "sturdiness"
TOOL = shared_models.SHARED / "tools" / "stiffness.py"
#: What is kept of a print, and to how many decimals.
FIGURES = {
    "posts": 0,
    "diagonals": 0,
    "braced": 3,
    "travel_share": 3,
    "tip_median_mm_n": 2,
    "tip_95_mm_n": 2,
    "tip_worst_mm_n": 2,
    "pinch_x_n_mm": 4,
    "pinch_y_n_mm": 4,
    "loose": 0,
    "print_time_s": 1,
    "coverage": 4,
    "breaches": 0,
}
#: Columns of the page, and how a figure is shown.
SHOWN = {
    "braced": ("braced", "{:.2f}".format),
    "travel share": ("travel_share", "{:.2f}".format),
    "tip, mm/N": ("tip_median_mm_n", "{:.1f}".format),
    "95 %": ("tip_95_mm_n", "{:.1f}".format),
    "worst": ("tip_worst_mm_n", "{:.0f}".format),
    "pinch x, N/mm": ("pinch_x_n_mm", "{:.3g}".format),
    "pinch y": ("pinch_y_n_mm", "{:.3g}".format),
    "time": ("print_time_s", duration),
    "coverage": ("coverage", "{:.1%}".format),
    "breaches": ("breaches", "{:.0f}".format),
}
PAGE = """# How sturdy the prints are

Written by `python benches/sturdiness.py`. Each model of `../shared/models` at the size of its
manifest, with all defaults of four printers, on beds that are large enough for all of them.
Stiffness is that of `../shared/tools/stiffness.py`: a frame of straight beams with rigid joints,
from the G-code alone; a measure to compare prints with. Before (version 0.1.0 at 96d4ec5) → now.

{tables}
- **braced**: diagonals per post. **travel share**: length of travels over that of strands.
- **tip**: how far a post's peak gives way under 1 N at the moment when it is printed, in the
  median, for 95 % of the posts, and at worst. **pinch**: force for 1 mm between two fingers at half
  the height of the finished print, along x and y.
- A dash: nothing printed, nothing to measure there, or more than {most} s of the tool's work.

## Goals

{goals}
"""


def evaluate(model, settings, row, most_s):
    """Fill in a print's figures and, unless it is known, how stiff it is."""
    made = make(model.mesh, settings, partial=True)
    told = made.figures()
    row["print_time_s"], row["coverage"] = told["print_time_s"], told["coverage"]
    row["breaches"] = sum(told["breaches"][name] for name in BREACHES)
    row["posts"], row["diagonals"] = made.wireframe.post_count, made.wireframe.diagonal_count
    row["braced"] = row["diagonals"] / max(1, row["posts"])
    row["travel_share"] = told["travel_mm"] / told["strand_mm"]
    modulus_mpa = MODULI_MPA[settings.material.name]
    row |= stiffness(made.gcode, settings.printer.head.nozzle_mm, modulus_mpa, most_s)


def stiffness(gcode, diameter_mm, modulus_mpa, most_s):
    """Measure G-code with the tool, once; nothing where that takes longer than `most_s`."""
    lines = [line for line in gcode.splitlines() if line.startswith((b"G", b";TYPE"))]
    lines += [b"%g %g" % (diameter_mm, modulus_mpa), TOOL.read_bytes()]
    kept = CACHE / f"{hashlib.sha256(b'|'.join(lines)).hexdigest()}.json"
    if kept.exists():
        return json.loads(kept.read_text())
    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder) / "print.gcode"
        file.write_bytes(gcode)
        given = [file, "--nozzle", str(diameter_mm), "--modulus", str(modulus_mpa)]
        try:
            ran = subprocess.run(
                [sys.executable, TOOL, *given], check=True, capture_output=True, timeout=most_s
            )
        except subprocess.TimeoutExpired:
            return {}
    found = json.loads(ran.stdout)
    tips, pinches = found.pop("tip_mm_n") or [None] * 3, found.pop("pinch_n_mm")
    found |= dict(zip(("tip_median_mm_n", "tip_95_mm_n", "tip_worst_mm_n"), tips, strict=True))
    found |= dict(zip(("pinch_x_n_mm", "pinch_y_n_mm"), pinches, strict=True))
    del found["file"]
    found = {name: value and float(value) for name, value in found.items()}
    CACHE.mkdir(parents=True, exist_ok=True)
    whole = kept.with_suffix(f".{os.getpid()}")
    whole.write_text(json.dumps(found))
    whole.replace(kept)
    return found


def measured(only, jobs, most_s):
    """Measure all models on all printers; figures by printer and model, in the manifest's order."""
    # Each process has one thread: the tool's linear algebra, too.
    os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")
    manifest = str(shared_models.SHARED / "models" / "manifest.csv")
    found = {}
    measure = functools.partial(evaluate, most_s=most_s)
    for machine, model, row in shared_models.on_each(MACHINES, [manifest], measure, jobs, only):
        figures = {name: row.get(name) for name in FIGURES}
        found[machine, model] = figures
        print(machine, model, row["error"] or figures, flush=True)
    with open(manifest, encoding="utf-8", newline="") as file:
        order = [row["name"] for row in csv.DictReader(file)]
    keys = [(machine, model) for machine in MACHINES for model in order]
    # What no printer prints is not in a format that we read.
    read = {model for (_, model), row in found.items() if row["braced"] is not None}
    return {key: found[key] for key in keys if key in found and key[1] in read}


def keep(found):
    """Keep what was measured as what later prints are compared with."""
    with BEFORE.open("w", encoding="utf-8", newline="") as file:
        table = csv.writer(file, delimiter="\t", lineterminator="\n")
        table.writerow(["printer", "model", *FIGURES])
        for (machine, model), row in found.items():
            cells = (rounded(row[name], places) for name, places in FIGURES.items())
            table.writerow([machine, model, *cells])


def rounded(value, places):
    """A figure as it is kept; empty where there is none."""
    return "" if value is None else f"{value:.{places}f}"


def before():
    """What was kept, by printer and model."""
    with BEFORE.open(encoding="utf-8", newline="") as file:
        return {
            (row.pop("printer"), row.pop("model")): {
                name: float(cell) if cell else None for name, cell in row.items()
            }
            for row in csv.DictReader(file, delimiter="\t")
        }


def table(machine, old, new):
    """The models on one printer, and below them the medians and, for the time, the sum."""
    columns = {"model": lambda row: row["model"]}
    columns |= {head: cell(*shown) for head, shown in SHOWN.items()}
    rows = [
        {"model": model, "old": old.get((of, model), {}), "new": row}
        for (of, model), row in new.items()
        if of == machine
    ]
    rows.append({"model": "**median**", **middles(rows)})
    return f"## {machine}\n\n{shared_models.markdown(columns, rows)}\n"


def cell(name, shown):
    """Show a figure before and now."""

    def one(row):
        return "–" if row.get(name) is None else shown(row[name])

    return lambda row: f"{one(row['old'])} → {one(row['new'])}"


def middles(rows):
    """Medians of all figures."""
    return {
        age: {name: middle(row[age].get(name) for row in rows) for name in FIGURES}
        for age in ("old", "new")
    }


def middle(values):
    """Median of what is there; None where nothing is."""
    there = [value for value in values if value is not None]
    return median(there) if there else None


def main():
    """Measure, and write the page or what it compares with."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--before", action="store_true", help=f"write {BEFORE.name} instead")
    parser.add_argument("--only", default="", help="models whose file's name has this text")
    target = shared_models.REPOSITORY / "docs" / "sturdiness.md"
    parser.add_argument("-o", "--output", type=Path, default=target)
    parser.add_argument("--jobs", type=int, default=1)
    parser.add_argument("--most", type=float, default=120.0, help="s of the tool's work a print")
    options = parser.parse_args()
    if not TOOL.exists():
        parser.exit(0, f"{TOOL} is absent: nothing measured\n")
    new = measured(options.only, options.jobs, options.most)
    if options.before:
        keep(new)
        return
    old = before()
    goals = sturdiness_goals.told(old, new)
    tables = "\n".join(table(machine, old, new) for machine in MACHINES)
    print(goals)
    options.output.write_text(
        PAGE.format(tables=tables, goals=goals, most=f"{options.most:g}"), encoding="utf-8"
    )


if __name__ == "__main__":
    main()
