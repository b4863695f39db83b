"""Areas become a toolpath: walls, solid shells, sparse fill, layer upon layer."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from wireprint._core import ModelError
from wireprint.layerwise.areas import Geometries, islands
from wireprint.layerwise.hatch import hatched
from wireprint.layerwise.moves import toolpath
from wireprint.layerwise.route import routed
from wireprint.layerwise.shells import split
from wireprint.layerwise.walls import walls

if TYPE_CHECKING:
    from wireprint._core import Toolpath
    from wireprint.layerwise.recipe import Recipe


def layered(areas: Geometries, recipe: Recipe) -> Toolpath:
    """Print areas as ordinary layers.

    Parameters
    ----------
    areas
        What each layer covers, from the lowest, shape (K,).
    recipe
        Widths, counts and speeds.

    Raises
    ------
    ModelError
        Nothing is wide enough for a line.
    """
    pieces, layer = islands(areas)
    inset_mm = recipe.width_mm / 2
    laid = walls(pieces, recipe.perimeters, inset_mm, recipe.spacing_mm, recipe.overlap_mm)
    solid, sparse = split(laid.inner, layer, areas, recipe.shells)
    turn = np.where(layer % 2 == 0, np.pi / 4, -np.pi / 4)
    fills = [
        hatched(solid, turn, recipe.spacing_mm, recipe.width_mm, recipe.solid_link_mm),
    ]
    if recipe.infill_density > 0:
        spacing = recipe.spacing_mm / recipe.infill_density
        fills.append(hatched(sparse, turn, spacing, recipe.width_mm, recipe.link_mm))
    groups = [*laid.lines, *fills]
    if not any(len(lines) for lines in groups):
        raise ModelError("no part of the model is as wide as a line")
    heights_mm = np.arange(1.0, len(areas) + 1) * recipe.layer_mm
    return toolpath(routed(groups, layer, heights_mm, recipe.seam_gap_mm), recipe.rates)
