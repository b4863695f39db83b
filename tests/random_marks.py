"""Random marks on a model: a band, a box, or a stroke of the brush; a seed is always the same."""

from dataclasses import dataclass

import numpy as np

from wireprint.regions import Box, Region, Stroke, ZRange

#: Bands are at least as high, mm.
LOWEST_MM = 4.0
#: Edges of boxes, in the model's largest extent.
EDGES = (0.15, 0.5)
#: Points of a stroke, and how far they lie from the first one, in the model's largest extent.
POINTS, APART = 8, 0.25
#: Of so many triangles near the first one.
NEAR = 40
#: Radius of the brush: mm at least, and in the model's largest extent at most beyond that.
BRUSH_MM, BRUSH = 3.0, 0.12


@dataclass(frozen=True)
class Mark:
    """A mark, with what it is in words."""

    kind: str
    region: Region
    told: str


def mark(mesh, seed):
    """Return the mark of a seed on a placed mesh."""
    rng = np.random.default_rng(seed)
    kind = str(rng.choice(sorted(KINDS)))
    region, told = KINDS[kind](mesh, rng)
    return Mark(kind, region, told)


def band(mesh, rng):
    """Mark all between two heights."""
    height_mm = mesh.size_mm[2]
    low, high = np.sort(rng.uniform(0, 1, 2) * height_mm).tolist()
    high = max(high, min(height_mm, low + LOWEST_MM))
    return Region().add(ZRange(low_mm=low, high_mm=high)), f"z {low:.2f} to {high:.2f}"


def box(mesh, rng):
    """Mark a box around a point of the surface."""
    surface = _Surface(mesh)
    middle = surface.middles[surface.somewhere(rng)]
    extent = rng.uniform(*EDGES, 3) * max(mesh.size_mm)
    low, high = (middle - extent / 2).tolist(), (middle + extent / 2).tolist()
    told = " to ".join(" ".join(f"{value:.2f}" for value in corner) for corner in (low, high))
    return Region().add(Box(low_mm=tuple(low), high_mm=tuple(high))), told


def stroke(mesh, rng):
    """Mark by a stroke over triangles that are near each other."""
    surface, largest = _Surface(mesh), max(mesh.size_mm)
    begin = surface.somewhere(rng)
    away = np.linalg.norm(surface.middles - surface.middles[begin], axis=1)
    near = np.flatnonzero(away < APART * largest)
    near = near[np.argsort(away[near], kind="stable")][:NEAR]
    path = near[np.sort(rng.choice(len(near), min(POINTS, len(near)), replace=False))]
    radius_mm = float(rng.uniform(BRUSH_MM, BRUSH * largest + BRUSH_MM))
    made = Stroke(
        points_mm=tuple(map(tuple, surface.middles[path].tolist())),
        normals=tuple(map(tuple, surface.normals[path].tolist())),
        radius_mm=radius_mm,
    )
    place = " ".join(f"{value:.2f}" for value in surface.middles[begin])
    return Region().add(made), f"radius {radius_mm:.2f} from {place}"


class _Surface:
    """The middles of triangles, their normals and areas."""

    def __init__(self, mesh):
        corners = mesh.vertices[mesh.faces]
        self.middles = corners.mean(axis=1)
        normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
        self.area = np.linalg.norm(normals, axis=1)
        self.normals = normals / np.maximum(self.area, 1e-12)[:, None]

    def somewhere(self, rng):
        """Return a triangle; large ones are met more often."""
        return rng.choice(len(self.middles), p=self.area / self.area.sum())


KINDS = {maker.__name__: maker for maker in (band, box, stroke)}
