"""Where islands that are layers all around begin over what is hollow: how they are closed."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
import shapely

from wireprint.hybrid.depth import LEAN, wide, with_bridges
from wireprint.layerwise.areas import Geometries, buffered, offset
from wireprint.records import Record

if TYPE_CHECKING:
    from collections.abc import Callable

    import numpy.typing as npt

    from wireprint.hybrid.depth import Inside
    from wireprint.layerwise.recipe import Recipe

    Floats = npt.NDArray[np.float64]
    Bools = npt.NDArray[np.bool_]

_EMPTY = shapely.MultiPolygon()
#: What is left open is told from this part of a line's width squared on.
_SPECK = 1.0


@dataclass(frozen=True, repr=False)
class Floors(Record):
    """What of whole islands is filled, by layer, shape (K,)."""

    #: The area, walls included.
    firm: Geometries
    #: Direction of the fill where it bridges what is hollow, radians; else not a number.
    turn_rad: Floats
    #: Layers on which some of an island stays open.
    is_open: Bools


def floors(
    solid: Geometries,
    inside: Inside,
    walls_mm: float,
    recipe: Recipe,
    on_step: Callable[[str], None],
) -> Floors:
    """Find what of islands can be filled, from the bed up.

    Parameters
    ----------
    solid
        Islands whose contours are layers all around, shape (K,).
    inside
        What is filled at all, what is solid on the bed, and the longest bridge.
    walls_mm
        From the contour to the centre of the innermost wall, mm. Walls stand on wire.
    recipe
        Widths.
    on_step
        Called before each layer; it may raise to give up.

    Notes
    -----
    A layer may lie on the one below and lean over it by half a line, or bridge what is hollow from
    one such place, or a wall, to another. What can do neither stays open, and the layers above it
    close it step by step.
    """
    firm, turn = solid.copy(), np.full(len(solid), np.nan)
    there = ~shapely.is_empty(solid)
    is_open = there & ~inside.is_had
    firm[is_open] = _EMPTY
    wants = is_open | _begins_in_the_air(solid, there, inside, recipe)
    for layer in np.flatnonzero(there & inside.is_had).tolist():
        if not (wants[layer] or (layer and is_open[layer - 1])):
            continue
        on_step("floors")
        below = firm[layer - 1] if layer else inside.bed
        room = offset(solid[[layer]], -walls_mm - recipe.spacing_mm)[0]
        walls = shapely.difference(solid[layer], room)
        lying = buffered(below, LEAN * recipe.width_mm)
        held = shapely.intersection(solid[layer], shapely.union(lying, walls))
        firm[layer], turn[layer] = with_bridges(solid[layer], held, recipe, inside.longest_mm)
        left = shapely.area(wide(shapely.difference(solid[layer], firm[layer]), recipe))
        is_open[layer] = left > _SPECK * recipe.width_mm**2
        if not is_open[layer]:
            firm[layer] = solid[layer]
    return Floors(firm, turn, is_open)


def _begins_in_the_air(solid: Geometries, there: Bools, inside: Inside, recipe: Recipe) -> Bools:
    """Tell which layers reach further beyond the one below than a line may lean."""
    found = np.zeros(len(solid), np.bool_)
    layers = np.flatnonzero(there)
    below = np.append(np.array([inside.bed], dtype=object), solid[:-1])[layers]
    loose = shapely.difference(solid[layers], buffered(below, LEAN * recipe.width_mm))
    found[layers] = ~shapely.is_empty(wide(loose, recipe))
    return found
