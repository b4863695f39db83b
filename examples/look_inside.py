"""Slices, posts and moves as numpy arrays; where the time goes."""

from pathlib import Path

import numpy as np

import wireprint
from wireprint import examples

Path("bottle.stl").write_bytes(examples.stl("bottle"))
mesh = wireprint.load_mesh("bottle.stl")
settings = wireprint.Settings.load()

strands = wireprint.wireframe(mesh, settings)
heights_mm = np.diff(strands.levels[:, 0])
print(f"{len(heights_mm)} slabs, {heights_mm.min():.1f} to {heights_mm.max():.1f} mm high")

bases, peaks = strands.posts[:, 0], strands.posts[:, 1]
print(f"{len(bases)} posts, the longest {np.linalg.norm(peaks - bases, axis=1).max():.1f} mm")

lengths_mm = np.linalg.norm(strands.strands[:, 1] - strands.strands[:, 0], axis=1)
for code in np.unique(strands.strand_kinds):
    chosen = strands.strand_kinds == code
    print(f"{wireprint.KINDS[code]:>10}: {lengths_mm[chosen].sum() / 1000:.2f} m")

path = wireprint.toolpath(strands, settings)
text = wireprint.to_gcode(path, settings)
for feature, seconds in wireprint.estimate(text).by_feature.items():
    print(f"{feature or 'start code':>10}: {seconds:.0f} s")
