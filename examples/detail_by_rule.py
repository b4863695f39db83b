"""A region given by a function: what lies high on one side is printed as layers."""

from pathlib import Path

import numpy as np
import numpy.typing as npt

import wireprint
from wireprint import examples
from wireprint.regions import Predicate, Region

Path("sphere.stl").write_bytes(examples.stl("sphere"))
mesh = wireprint.load_mesh("sphere.stl")
top_mm = mesh.size_mm[2]


def fine(points: npt.NDArray[np.float64]) -> npt.NDArray[np.bool_]:
    """Whether the surface at each point is wanted in detail; points of shape (N, 3), mm."""
    return (points[:, 2] > 0.8 * top_mm) & (points[:, 0] > 0)


region = Region().add(Predicate(function=fine))
printed = wireprint.make(mesh, wireprint.Settings.load(), region)
figures = printed.figures()
assert figures["certified"]
regions = figures["regions"]
print(f"{regions['layer_wise_mm'] / 1000:.1f} m in layers, {len(regions['dropped'])} runs dropped")
Path("sphere.gcode").write_bytes(printed.gcode)
