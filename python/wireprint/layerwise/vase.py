"""A vase: a solid bottom, and one wall that climbs without a seam."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
import shapely

from wireprint.layerwise.areas import Geometries, islands, offset
from wireprint.layerwise.hatch import hatched
from wireprint.layerwise.lines import Lines
from wireprint.layerwise.moves import toolpath
from wireprint.layerwise.route import Route, routed

if TYPE_CHECKING:
    from wireprint._core import Toolpath
    from wireprint.layerwise.recipe import Recipe


def spiral(areas: Geometries, recipe: Recipe) -> Toolpath:
    """Print the outer contours alone.

    Parameters
    ----------
    areas
        What each layer covers, from the lowest, shape (K,).
    recipe
        Widths and speeds; its counts of walls and layers do not matter.

    Notes
    -----
    Above the bottom layer, a wall that is alone on its layer rises by a layer along its length, as
    does the next, so that it needs neither travel nor seam; where there are several, each stays
    flat.
    """
    pieces, layer = islands(areas)
    filled = offset(shapely.polygons(shapely.get_exterior_ring(pieces)), -recipe.width_mm / 2)
    walls = Lines.rims(filled, holes=False)
    bottom = offset(filled[layer == 0], recipe.overlap_mm - recipe.spacing_mm)
    turn = np.full(len(bottom), np.pi / 4)
    solid = hatched(bottom, turn, recipe.spacing_mm, recipe.width_mm, recipe.solid_link_mm)
    heights_mm = np.arange(1.0, len(areas) + 1) * recipe.layer_mm
    return toolpath(_climbing(routed([solid, walls], layer, heights_mm, 0.0)), recipe.rates)


def _climbing(route: Route) -> Route:
    """Join walls that are alone on their layers to one line that rises all along."""
    layers = route.layer[route.offsets[:-1]]
    lines = np.bincount(layers)
    above = lines[np.maximum(layers - 1, 0)] == 1
    climbs = (layers > 0) & (lines[layers] == 1) & ((layers == 1) | above)
    points = route.points.copy()
    for line in np.flatnonzero(climbs):
        turn = points[route.offsets[line] : route.offsets[line + 1]]
        way = np.cumsum(np.hypot(*np.diff(turn[:, :2], axis=0, prepend=turn[:1, :2]).T))
        turn[:, 2] -= (turn[0, 2] / (layers[line] + 1)) * (1 - way / way[-1])
    joins = climbs[1:] & climbs[:-1]
    kept = np.concatenate([[True], ~joins, [True]])
    return Route(points, route.layer, route.offsets[kept], route.group[kept[:-1]])
