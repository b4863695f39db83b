"""Closed meshes of areas that are extruded between heights, without a boolean library.

All outlines are cut at each other into cells of the plane. A cell is in the body or not, layer by
layer; where that changes from cell to cell there is a wall, and from layer to layer a level face.
All faces share the same corners, so the mesh is closed whatever the outlines are.
"""

from collections import defaultdict
from itertools import pairwise

import numpy as np
import shapely

#: Corners lie on a grid so fine, mm: a power of two, exact in every format.
GRID = 1 / 1024


class Body:
    """A body of layers; where steps overlap the later one wins."""

    def __init__(self):
        self.steps = []

    def add(self, area, low, high):
        """Fill an area between two heights, mm."""
        self.steps.append((shapely.set_precision(area, GRID), snapped(low), snapped(high), True))
        return self

    def cut(self, area, low, high):
        """Hollow an area out between two heights, mm."""
        self.steps.append((shapely.set_precision(area, GRID), snapped(low), snapped(high), False))
        return self

    def heights(self):
        """Heights at which anything begins or ends, mm."""
        return sorted({z for _, low, high, _ in self.steps for z in (low, high)})

    def mesh(self):
        """Vertices (V, 3) in mm, and faces (F, 3), counter-clockwise from outside."""
        heights = self.heights()
        cells = self._cells()
        filled = np.array([self._filled(cell, heights) for cell in cells])
        filled = np.pad(filled, ((0, 1), (1, 1)))  # outside: no cell, below and above the body
        nodes, faces = {}, []

        def corner(xy, level):
            return nodes.setdefault(tuple(xy), len(nodes)) * len(heights) + level

        for (a, b), left, right in _edges(cells):
            for layer in np.flatnonzero(filled[left, 1:-1] & ~filled[right, 1:-1]):
                low = corner(a, layer), corner(b, layer)
                high = corner(a, layer + 1), corner(b, layer + 1)
                faces += [(low[0], low[1], high[1]), (low[0], high[1], high[0])]
        for cell, inside in zip(cells, filled, strict=False):
            triangles = _triangles(cell)
            for level in range(len(heights)):
                if inside[level] != inside[level + 1]:
                    turn = 1 if inside[level] else -1
                    faces += [tuple(corner(p, level) for p in t[::turn]) for t in triangles]
        vertices = np.array([(*xy, z) for xy in nodes for z in heights])
        used, faces = np.unique(np.array(faces), return_inverse=True)
        return vertices[used], faces.reshape(-1, 3)

    def volume(self):
        """Volume by plane areas, mm³: what a mesh of the body must enclose."""
        heights = self.heights()
        return sum(self._area((low + high) / 2) * (high - low) for low, high in pairwise(heights))

    def _area(self, z):
        whole = shapely.Polygon()
        for area, low, high, fills in self.steps:
            if low < z < high:
                whole = whole.union(area) if fills else whole.difference(area)
        return whole.area

    def _cells(self):
        lines = [area.boundary for area, *_ in self.steps]
        noded = shapely.unary_union(lines, grid_size=GRID)
        cells = shapely.polygonize([*shapely.get_parts(noded)])
        return [shapely.orient_polygons(cell) for cell in shapely.get_parts(cells)]

    def _filled(self, cell, heights):
        place = cell.representative_point()
        inside = np.zeros(len(heights) - 1, dtype=bool)
        for area, low, high, fills in self.steps:
            if area.contains(place):
                inside[heights.index(low) : heights.index(high)] = fills
        return inside


def snapped(value):
    """A coordinate on the grid, mm."""
    return round(value / GRID) * GRID


def _edges(cells):
    """Edges of all cells: its ends, the cell on its left, and that on its right or the last + 1."""
    left = {}
    for index, cell in enumerate(cells):
        for ring in (cell.exterior, *cell.interiors):
            left |= dict.fromkeys(pairwise(map(tuple, ring.coords)), index)
    return [((a, b), index, left.get((b, a), len(cells))) for (a, b), index in left.items()]


def _triangles(cell):
    """A cell as triangles with its own corners alone, counter-clockwise."""
    triangles = shapely.get_parts(shapely.constrained_delaunay_triangles(cell))
    return [triangle.exterior.coords[:3] for triangle in shapely.orient_polygons(triangles)]


def is_closed(faces):
    """Tell whether each edge is passed as often in one direction as in the other."""
    passed = defaultdict(int)
    for a, b, c in faces:
        for edge in ((a, b), (b, c), (c, a)):
            passed[edge] += 1
    return all(passed[b, a] == count for (a, b), count in passed.items())
