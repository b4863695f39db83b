"""Writes docs/cost.md: what planning and proof cost, from a thousand strands to a million.

python benches/cost.py [-o PAGE] [--most STRANDS]
"""

import argparse
import math
import os
import platform
import time
from pathlib import Path

import numpy as np

from wireprint._core import Mesh
from wireprint.certificate import check
from wireprint.settings import Settings
from wireprint.stages import toolpath, wireframe
from wireprint.whole_file import to_gcode

ROOT = Path(__file__).resolve().parent.parent
PAGE = """# What planning and proof cost

Written by `python benches/cost.py` ({machine}). `kossel-mini` with 3 mm slabs;
arrays in, certified G-code out, in one process, the best of {repeats} runs. Times in ms.

| model | strands | wireframe | toolpath | G-code | check | all | ns per n·log₂n |
|---|--:|--:|--:|--:|--:|--:|--:|
{rows}

- **vase**: one five-lobed vase, scaled: contours grow longer and slabs more numerous.
- **pins**: ever more small vases side by side: contours of a slice grow more numerous.
- **ns per n·log₂n**: all of the time over n·log₂n strands; it does not rise where the cost grows no
  worse than n·log n. At the small end what every print costs weighs more.
- Large vases have wide roofs, which want columns: each floor of these is one more pass over all
  slabs, sixteen at most.
"""
#: Radii and heights of a vase's rings, mm, and how many strands it comes to in the end.
RADII, HEIGHTS = (30, 24, 36, 20, 30), (0, 10, 22, 36, 44)
VASE_STRANDS, PIN_STRANDS = 1900, 130
LOBES, AROUND = 5, 40
REPEATS = 2


def vase(scale):
    """Vertices and faces of a five-lobed vase, closed at both ends."""
    turn = np.linspace(0, 2 * np.pi, AROUND, endpoint=False)
    star = 1 + 0.1 * np.cos(LOBES * turn)
    rings = [
        np.column_stack([r * star * np.cos(turn), r * star * np.sin(turn), np.full(AROUND, z)])
        for r, z in zip(RADII, HEIGHTS, strict=True)
    ]
    ends = [[0, 0, HEIGHTS[0]], [0, 0, HEIGHTS[-1]]]
    here = np.arange(AROUND)
    ahead = (here + 1) % AROUND
    last = (len(rings) - 1) * AROUND
    faces = [np.column_stack([ahead, here, np.full(AROUND, last + AROUND)])]
    faces += [np.column_stack([last + here, last + ahead, np.full(AROUND, last + AROUND + 1)])]
    for begin in range(0, last, AROUND):
        a, b = begin, begin + AROUND
        faces += [np.column_stack([a + here, a + ahead, b + ahead])]
        faces += [np.column_stack([a + here, b + ahead, b + here])]
    return scale * np.vstack([*rings, ends]), np.vstack(faces)


def grown(strands):
    """One vase of about so many strands."""
    return vase(math.sqrt(strands / VASE_STRANDS))


def pins(strands):
    """A square of small vases that come to about so many strands."""
    side = max(1, round(math.sqrt(strands / PIN_STRANDS)))
    vertices, faces = vase(0.25)
    places = [(20 * i, 20 * j, 0) for i in range(side) for j in range(side)]
    return (
        np.concatenate([vertices + place for place in places]),
        np.concatenate([faces + i * len(vertices) for i in range(len(places))]),
    )


def seconds(mesh, settings):
    """Strands, and the time that each stage takes."""
    marks = [time.perf_counter()]
    wire = wireframe(mesh, settings)
    marks.append(time.perf_counter())
    path = toolpath(wire, settings)
    marks.append(time.perf_counter())
    text = to_gcode(path, settings)
    marks.append(time.perf_counter())
    certificate = check(text, settings)
    marks.append(time.perf_counter())
    found = {name: len(list_) for name, list_ in certificate.breaches().items() if list_}
    # The largest do not fit any bed, which is no fault of theirs.
    found.pop("out_of_bounds", None)
    if found:
        raise AssertionError(found)
    return wire.strand_count, np.diff(marks)


def row(name, strands, settings):
    """One line of the table."""
    vertices, faces = {"vase": grown, "pins": pins}[name](strands)
    mesh = Mesh.from_arrays(vertices, faces.astype(np.int64))
    runs = [seconds(mesh, settings) for _ in range(REPEATS)]
    count, stages = runs[0][0], np.min([run[1] for run in runs], axis=0)
    per = 1e9 * stages.sum() / (count * math.log2(count))
    cells = " | ".join(f"{1e3 * stage:.0f}" for stage in stages)
    print(name, count, cells, f"{per:.0f}", flush=True)
    return f"| {name} | {count} | {cells} | {1e3 * stages.sum():.0f} | {per:.0f} |"


def main():
    """Write the page."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("-o", "--output", type=Path, default=ROOT / "docs" / "cost.md")
    parser.add_argument("--most", type=float, default=1e6, help="strands of the largest models")
    arguments = parser.parse_args()
    settings = Settings.load(
        overrides=[
            "wire.slab_max_mm=3",
            "bed.diameter_mm=2000",
            "bed.height_mm=2000",
            "motion.print_radius=1000",
            "motion.endstop_height=2000",
        ]
    )
    counts = [10**power for power in range(3, 1 + round(math.log10(arguments.most)))]
    rows = [row(name, count, settings) for name in ("vase", "pins") for count in counts]
    cores = os.environ.get("RAYON_NUM_THREADS") or os.cpu_count()
    machine = f"{cores} threads, Python {platform.python_version()}"
    page = PAGE.format(rows="\n".join(rows), machine=machine, repeats=REPEATS)
    arguments.output.write_text(page)


if __name__ == "__main__":
    main()
