"""From a mesh in memory to arrays, a region by rule, a figure and the time of each move."""

from pathlib import Path

import numpy as np
import numpy.typing as npt
import trimesh

import wireprint
from wireprint.regions import Predicate, Region
from wireprint.view import render_png


def rim(points: npt.NDArray[np.float64]) -> npt.NDArray[np.bool_]:
    """Whether the surface at each point, (N, 3) in mm, belongs to the rim: printed as layers."""
    high: npt.NDArray[np.bool_] = points[:, 2] > 26
    return high


# Radius and height, mm: a cup's wall, up the outside and down the inside.
profile = np.array([[0, 0], [14, 0], [20, 30], [18.5, 30], [12.5, 1.5], [0, 1.5]])
cup = trimesh.creation.revolve(profile, sections=72)

settings = wireprint.Settings.load(printer="prusa-mk4s", material="pla")
made = wireprint.make(cup, settings, Region().add(Predicate(function=rim)))
print(made)

# Every strand as two ends (N, 2, 3), with what it is for.
ends, kinds = made.wireframe.strands, made.wireframe.strand_kinds
lengths_mm = np.linalg.norm(ends[:, 1] - ends[:, 0], axis=1)
for code in np.unique(kinds):
    print(f"{wireprint.KINDS[code]:>12}: {lengths_mm[kinds == code].sum() / 1000:.2f} m")

# A figure for a paper; a notebook shows one of `made` by itself.
Path("cup.png").write_bytes(render_png(made, size=(800, 600), travels=True))

# How long each move takes, as the firmware would run it.
rows = wireprint.estimate(made.gcode, per_move=True).per_move
assert rows is not None
slowest = int(np.argmax(rows.duration_s))
print(f"slowest: line {rows.line[slowest]}, {rows.duration_s[slowest]:.2f} s")
