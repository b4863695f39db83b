"""Writes docs/stiffening.md: what `slice --forecast` does about prints that would give way.

python benches/stiffening.py [manifest.csv] [-o PAGE] [--jobs N]

For each model of `../shared/models` at the size of its manifest, on two printers: how far what a
strand ends on is pulled aside at worst, before and after, and what that costs. Rows are kept in
`target/stiffening.jsonl` as they come: a run that was stopped is gone on with, as long as `rust`
and `python` are those that the rows were made by.
"""

import json
import subprocess
import sys

import shared_models
from wireprint.bench.local import cores
from wireprint.duration import duration
from wireprint.forecast import simulate
from wireprint.pipeline import make
from wireprint.stiffening import stiffened

MACHINES = ("kossel-mini/abs", "prusa-mk4s/pla")
PAGE = """# Prints that would give way

Written by `python benches/stiffening.py`. Each model of `../shared/models` at the size of its
manifest, as `wireprint slice --forecast` prints it; on beds that are large enough for all.
**Pulled aside** is the rule `meets` of the [forecast](forecast.md): how far the nozzle's pull of
0.01 N moves what a strand ends on, at worst, mm; it may be half a strand. Where it is more, what is
tried is thicker strands, lower slabs (about the places that still give way, where what bends is, or
throughout), posts by the other rule, no supports where those cover nothing, and several of these.
The quickest that suffices is printed, else what gives way least, if that is a tenth less; none
that takes more than four times as long. It is a model throughout, with ideal joints; no figure was
measured on a printer. All rows were made by the same sources: {sources}.

{tables}
{summary}
"""


def evaluate(model, settings, row):
    """Fill in how far a print gives way, before and after, and the time that it takes."""
    options = {"partial": True, "compare": False}
    made = make(model.mesh, settings, **options)
    _, found, told = stiffened(model.mesh, made, None, options)
    rule = found.rules["meets"]
    row["limit_mm"], row["verdict"] = rule.limit, rule.verdict
    row["before_mm"] = rule.worst if told is None else told.meets_before_mm
    row["after_mm"] = rule.worst
    time_s = made.estimate.total_s
    row["time_before_s"] = time_s
    row["time_after_s"] = time_s if told is None else told.print_time_after_s
    row["with"] = "" if told is None else " ".join(told.overrides) or "nothing helps"
    if told is None and rule.worst is not None:
        assert simulate(made.gcode, settings).rules["meets"].worst == rule.worst


ROWS = shared_models.REPOSITORY / "target" / "stiffening.jsonl"


def sources():
    """Name what prints are made by: the trees of git; none where something is not committed."""
    git = ["git", "-C", str(shared_models.REPOSITORY)]
    changed = subprocess.check_output([*git, "status", "--porcelain", "rust", "python"], text=True)
    if changed:
        sys.exit("commit what is changed in rust and python first: rows are told by that")
    trees = [
        subprocess.check_output([*git, "rev-parse", "--short=12", f"HEAD:{name}"], text=True)
        for name in ("rust", "python")
    ]
    return "`rust` {}, `python` {} (`git rev-parse HEAD:rust HEAD:python`)".format(
        *(tree.strip() for tree in trees)
    )


def kept(made_by):
    """Return the rows that the same sources made already, each with its machine and model."""
    lines = ROWS.read_text(encoding="utf-8").splitlines() if ROWS.exists() else []
    rows = [json.loads(line) for line in lines]
    return [row for row in rows if row["sources"] == made_by]


def millimetres(value):
    """Show a length, or that there is none."""
    return "–" if value is None else f"{value:.2g}"


COLUMNS = {
    "model": lambda row: row["model"],
    "pulled aside, mm": lambda row: (
        f"{millimetres(row['before_mm'])} → {millimetres(row['after_mm'])}"
    ),
    "limit": lambda row: millimetres(row["limit_mm"]),
    "time": lambda row: f"{duration(row['time_before_s'])} → {duration(row['time_after_s'])}",
    "with": lambda row: row["with"].replace("wire.", ""),
}


def told(machine, rows):
    """Say in a sentence how many prints were beyond the limit, and how many are."""
    judged = [row for row in rows if row.get("after_mm") is not None]
    over = [
        sum(row[when] > row["limit_mm"] for row in judged) for when in ("before_mm", "after_mm")
    ]
    before, after = (sum(row[key] for row in judged) for key in ("time_before_s", "time_after_s"))
    return (
        f"- {machine}: of {len(judged)} prints {over[0]} → {over[1]} are pulled aside by more than "
        f"half a strand; all together take {duration(before)} → {duration(after)}.\n"
    )


def main():
    """Measure, and write the page."""
    options = shared_models.arguments(__doc__.splitlines()[0], "stiffening.md")
    jobs = options.jobs or cores()
    made_by = sources()
    found = {machine: [] for machine in MACHINES}
    for row in kept(made_by):
        found[row["machine"]].append(row)
    known = {(machine, row["model"]) for machine, rows in found.items() for row in rows}
    fresh = shared_models.on_each(MACHINES, [options.manifest], evaluate, jobs, known=known)
    ROWS.parent.mkdir(exist_ok=True)
    for machine, model, row in fresh:
        row |= {"model": model, "machine": machine, "sources": made_by}
        found[machine].append(row)
        with ROWS.open("a", encoding="utf-8") as file:
            file.write(json.dumps(row) + "\n")
        print(machine, model, row.get("error") or row.get("after_mm"), file=sys.stderr, flush=True)
    options.output.write_text(page(found, made_by), encoding="utf-8")


def page(found, made_by):
    """Lay out the rows of each machine."""
    tables, summary = "", ""
    for machine, rows in found.items():
        rows.sort(key=lambda row: row["model"])
        tables += f"## {machine}\n\n{shared_models.markdown(COLUMNS, rows)}\n\n"
        summary += told(machine, rows)
    return PAGE.format(tables=tables.rstrip(), summary=summary.rstrip(), sources=made_by)


if __name__ == "__main__":
    main()
