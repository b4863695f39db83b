"""Measures the engine of the window: processor seconds from a stroke to its proven print.

python benches/strokes.py [--same DEEDS] [--machine PRINTER/MATERIAL] [NAME…]

With --same it compares instead: after each of so many strokes, erasures and undos, what is printed
with what is kept must be what is printed without, byte for byte.

A stroke of 12 points and 3 mm, each upon a print that is kept, and half of a model, from the middle
of its height up. Needs the shared models.
"""

import argparse
import csv
import statistics
import time

import numpy as np

import shared_models
from wireprint.mesh import load_mesh
from wireprint.pipeline import make
from wireprint.regions import HalfSpace, Region, Stroke

STROKES = 5
#: Each is made so often, and the quickest counts: others use the machine, too.
REPEATS = 3
POINTS = 12
RADIUS_MM = 3.0
#: Strokes go over flanks: where the surface is no steeper to the horizontal than this, they end.
MOST_LEVEL = 0.7
#: A step from point to point, in radii.
STEP = (0.3, 1.3)


class Flank:
    """Middles of the triangles of a model that are neither level nor at its foot or top."""

    def __init__(self, mesh, rng):
        corners = mesh.vertices[mesh.faces]
        middles = corners.mean(axis=1)
        normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
        normals /= np.maximum(np.linalg.norm(normals, axis=1, keepdims=True), 1e-12)
        height = middles[:, 2] / mesh.size_mm[2]
        good = (np.abs(normals[:, 2]) < MOST_LEVEL) & (height > 0.2) & (height < 0.9)
        self.middles, self.normals, self.rng = middles[good], normals[good], rng

    def stroke(self):
        """Return a stroke that goes from triangle to triangle."""
        path = [int(self.rng.integers(len(self.middles)))]
        while len(path) < POINTS:
            away = np.linalg.norm(self.middles - self.middles[path[-1]], axis=1)
            near = (away > STEP[0] * RADIUS_MM) & (away < STEP[1] * RADIUS_MM)
            near &= self.normals @ self.normals[path[-1]] > 0
            if not near.any():
                break
            path.append(int(self.rng.choice(np.flatnonzero(near))))
        return Stroke(
            points_mm=tuple(map(tuple, self.middles[path].tolist())),
            normals=tuple(map(tuple, self.normals[path].tolist())),
            radius_mm=RADIUS_MM,
        )


def measured(mesh, settings):
    """Return the median of strokes, s, half of the model, s, and how many samples it has."""
    sketch = make(mesh, settings, compare=False, partial=True).sketch
    for part in ("samples", "strips", "level", "areas", "touchable"):
        getattr(sketch, part)

    def cpu_s(region, repeats):
        found = []
        for _ in range(repeats):
            begin = time.process_time()
            make(mesh, settings, region, compare=False, partial=True, kept=sketch)
            found.append(time.process_time() - begin)
        return min(found)

    flank = Flank(mesh, np.random.default_rng(1))
    strokes = [cpu_s(Region().add(flank.stroke()), REPEATS) for _ in range(STROKES)]
    upper = HalfSpace(normal=(0, 0, 1), offset_mm=mesh.size_mm[2] / 2)
    return statistics.median(strokes), cpu_s(Region().add(upper), 1), len(sketch.samples.middle)


def differing(mesh, settings, deeds):
    """Return how many of so many random deeds give another print than one that is made anew."""
    rng = np.random.default_rng(deeds)
    flank, sketch = Flank(mesh, rng), None
    states, wrong = [Region()], 0
    for _ in range(deeds):
        deed = rng.choice(["stroke", "stroke", "erasure", "undo"])
        if deed == "undo" and len(states) > 1:
            states.pop()
        else:
            mark = flank.stroke()
            last = states[-1]
            states.append(last.erase(mark) if deed == "erasure" and last else last.add(mark))
        kept = make(mesh, settings, states[-1], compare=False, partial=True, kept=sketch)
        sketch = kept.sketch
        anew = make(mesh, settings, states[-1], compare=False, partial=True)
        wrong += kept.gcode != anew.gcode
    return wrong


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("names", nargs="*")
    parser.add_argument("--same", type=int, default=0, metavar="DEEDS")
    parser.add_argument("--machine", default="kossel-mini/abs", help="printer/material")
    options = parser.parse_args()
    names, deeds = options.names, options.same
    settings = shared_models.roomy(options.machine)
    folder = shared_models.SHARED / "models"
    with (folder / "manifest.csv").open(newline="", encoding="utf-8") as file:
        rows = list(csv.DictReader(file))
    if not deeds:
        print(f"{'model':24} {'samples':>8} {'stroke':>8} {'half':>8}")
    for row in rows:
        if names and row["name"].rpartition(".")[0] not in names:
            continue
        height_mm = float(row["suggested_height_mm"])
        mesh = load_mesh(folder / row["name"], height_mm=height_mm, up=row["up_axis"])
        if deeds:
            print(
                f"{row['name']:24} {differing(mesh, settings, deeds)} of {deeds} differ", flush=True
            )
            continue
        stroke_s, half_s, samples = measured(mesh, settings)
        print(f"{row['name']:24} {samples:8} {stroke_s:6.3f} s {half_s:6.2f} s", flush=True)


if __name__ == "__main__":
    main()
