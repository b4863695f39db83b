"""Measure what users wait for, and add a line to docs/benchmarks.md.

Usage: python benches/history.py "what changed"

Only examples that the package makes itself are measured, so anybody can. Each figure is the best of
several runs; the machine's own speed at that time stands beside them, as the time that numpy takes
to sort two million numbers, since the same machine may be half as fast an hour later.
"""

import subprocess
import sys
import tempfile
from datetime import UTC, datetime
from pathlib import Path
from time import perf_counter

import numpy as np

from wireprint import check, estimate, examples, load_mesh, make
from wireprint.hybrid.prove import proved
from wireprint.hybrid.sketch import Sketch
from wireprint.regions import Region, Sphere, ZRange
from wireprint.settings import Settings

PAGE = Path(__file__).parents[1] / "docs" / "benchmarks.md"
RUNS = 7
COLUMNS = (
    "date",
    "commit",
    "change",
    "reference",
    "wire, bottle",
    "wire, branch",
    "whole, bottle",
    "check, bottle",
    "time, bottle",
    "ball on the bottle",
    "half a torus",
)
HEAD = f"""\
# Benchmarks over time

One line a change, by `python benches/history.py "what changed"`: best of seven runs, ms, on the
examples that `wireprint example` writes. *Reference* is numpy sorting two million numbers in the
same minute: divide by it to compare lines. Ratios against other programs are in
`benches/test_whole.py` and its neighbours.

| {" | ".join(COLUMNS)} |
|---|---|---{"|--:" * (len(COLUMNS) - 3)}|
"""


def best_ms(call):
    """Shortest time of several calls, ms."""
    times = []
    for _ in range(RUNS):
        begin = perf_counter()
        call()
        times.append(perf_counter() - begin)
    return 1000 * min(times)


def figures():
    """All that is measured, ms, in the order of the columns."""
    from wireprint import stages

    settings = Settings.load()
    with tempfile.TemporaryDirectory() as work:
        meshes = {}
        for name in ("bottle", "branch", "torus"):
            path = Path(work) / f"{name}.stl"
            path.write_bytes(examples.stl(name))
            meshes[name] = load_mesh(path)
    bottle, branch, torus = (meshes[name] for name in ("bottle", "branch", "torus"))
    text = make(bottle, settings).gcode
    numbers = np.random.default_rng(0).random(2_000_000)
    ball = Region().add(Sphere(centre_mm=(0, -25, 90), radius_mm=12))
    half = Region().add(ZRange(low_mm=torus.size_mm[2] / 2))
    kept = Sketch.of(bottle, settings)
    proved(kept, ball)
    return [
        best_ms(lambda: np.sort(numbers)),
        best_ms(lambda: stages.wireframe(bottle, settings)),
        best_ms(lambda: stages.wireframe(branch, settings)),
        best_ms(lambda: make(bottle, settings, compare=False)),
        best_ms(lambda: check(text)),
        best_ms(lambda: estimate(text)),
        best_ms(lambda: proved(kept, ball)),
        best_ms(lambda: proved(Sketch.of(torus, settings), half)),
    ]


def commit():
    """Short name of the commit; a star where the tree differs from it."""
    run = subprocess.run(
        ["git", "describe", "--always", "--dirty=*"], capture_output=True, text=True, check=True
    )
    return run.stdout.strip()


def main() -> None:
    """Add a line."""
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    cells = [datetime.now(UTC).date().isoformat(), commit(), sys.argv[1].replace("|", "/")]
    line = "| " + " | ".join([*cells, *(f"{ms:.1f}" for ms in figures())]) + " |\n"
    before = PAGE.read_text(encoding="utf-8") if PAGE.exists() else HEAD
    PAGE.write_text(before + line, encoding="utf-8")
    print(line, end="")


if __name__ == "__main__":
    main()
