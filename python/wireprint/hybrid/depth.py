"""What lies behind the walls of a region that has depth: where fill finds something to lie on."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np
import shapely

from wireprint.hybrid.bridges import bridged
from wireprint.layerwise.areas import Geometries, buffered, islands, offset
from wireprint.records import Record

if TYPE_CHECKING:
    from collections.abc import Callable

    import numpy.typing as npt
    from shapely import Geometry

    from wireprint.hybrid.fringe import Fringe
    from wireprint.layerwise.recipe import Recipe

    Floats = npt.NDArray[np.float64]

_EMPTY = shapely.MultiPolygon()
#: A layer may reach beyond the one below by this part of a line's width.
LEAN = 0.5
#: What is narrower than this many line spacings has no room for a line beside the wall.
_NARROW = 0.9
#: Corners are left out that stray less than this part of a line's width.
_FINE = 0.05
#: Walls this near to an area, in line widths, bound it.
_TOUCH = 0.1


@dataclass(frozen=True, repr=False)
class Inside(Record):
    """What of a region lies behind the surface, and what bounds its fill, by layer, shape (K,)."""

    #: The region's sections.
    sections: Geometries
    #: What the head must keep clear of, since wire of the same slab stands there.
    wire: Geometries
    #: Where it is filled at all.
    is_had: npt.NDArray[np.bool_]
    #: What is solid on the bed, below the first layer.
    bed: Geometry
    #: Longest stretch between two supports, mm.
    longest_mm: float


@dataclass(frozen=True, repr=False)
class Depth(Record):
    """Areas behind the innermost walls, by layer, shape (K,)."""

    #: What is marked, what of it the head reaches, and what of that is filled, up to the centre
    #: lines of the walls around it.
    marked: Geometries
    clear: Geometries
    filled: Geometries
    #: Direction of the fill where it bridges what is hollow, radians; else not a number.
    turn_rad: Floats


def depth(
    marked: Geometries,
    inside: Inside,
    ground: Geometries,
    walls: Geometries,
    recipe: Recipe,
    on_step: Callable[[str], None],
) -> Depth:
    """Find what of the inside of a region can be printed, from the bed up.

    Parameters
    ----------
    marked
        What is marked behind the innermost walls of each layer, shape (K,); see `behind`.
    inside
        What bounds it.
    ground
        What is solid below each layer apart from what is filled here, shape (K,).
    walls
        Centre lines of the innermost walls, shape (K,).
    recipe
        Widths.
    on_step
        Called before each layer; it may raise to give up.

    Notes
    -----
    A layer may begin beside its wall, lean by half a line over the layer below, or bridge what is
    hollow from one such place to another. What can do neither stays hollow.
    """
    clear = wide(shapely.difference(marked, inside.wire), recipe)
    beside = buffered(walls, recipe.spacing_mm, cap_style="flat")
    filled: Geometries = np.full(len(marked), _EMPTY, dtype=object)
    turn = np.full(len(marked), np.nan)
    for layer in np.flatnonzero(inside.is_had & ~shapely.is_empty(clear)).tolist():
        on_step("fill over fill")
        below = filled[layer - 1] if layer else _EMPTY
        solid = buffered(shapely.union(below, ground[layer]), LEAN * recipe.width_mm)
        held = shapely.intersection(clear[layer], shapely.union(solid, beside[layer]))
        filled[layer], turn[layer] = with_bridges(clear[layer], held, recipe, inside.longest_mm)
    return Depth(marked, clear, filled, turn)


def behind(areas: Geometries, sections: Geometries, walls: Fringe) -> Geometries:
    """Return what is marked behind the innermost walls of each layer.

    Parameters
    ----------
    areas
        What the model covers on each layer, shape (K,).
    sections
        The region's, shape (K,).
    walls
        Walls along what is painted; where a layer's island has none, nothing counts.
    """
    there = np.flatnonzero(~(shapely.is_empty(walls.innermost) | shapely.is_empty(sections)))
    rooms, origin = islands(offset(areas[there], -walls.inward_mm))
    layer = there[origin]
    near = shapely.dwithin(rooms, walls.innermost[layer], _TOUCH)
    found: Geometries = np.full(len(areas), _EMPTY, dtype=object)
    layers, group = np.unique(layer[near], return_inverse=True)
    if len(layers):
        found[layers] = shapely.multipolygons(rooms[near], indices=group)
    marked: Geometries = shapely.intersection(found, sections)
    return marked


def with_bridges(
    area: Geometry, held: Geometry, recipe: Recipe, longest_mm: float
) -> tuple[Any, float]:
    """Add to what is held of an area what bridges cover; return it with their direction."""
    loose = wide(shapely.difference(area, held), recipe)
    if shapely.is_empty(loose):
        return area, np.nan
    found = bridged(area, held, recipe.width_mm, longest_mm)
    if found is None:
        return wide(held, recipe), np.nan
    over, turn = found
    return wide(shapely.union(held, over), recipe), turn


def wide(areas: Any, recipe: Recipe) -> Any:
    """Return areas without what is too narrow for a line."""
    half = _NARROW * recipe.spacing_mm / 2
    fine = shapely.simplify(areas, _FINE * recipe.width_mm)
    opened = buffered(buffered(fine, -half), half, join_style="mitre")
    return shapely.intersection(opened, fine)
