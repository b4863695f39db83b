"""The lines of a region's layers: walls along what is painted, fill where they close."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

import numpy as np
import shapely

from wireprint.hybrid.depth import Depth, Inside, behind, depth
from wireprint.hybrid.fringe import Fringe, fringe
from wireprint.hybrid.group import Group
from wireprint.layerwise.areas import Geometries, buffered, islands, of_contours, offset
from wireprint.layerwise.hatch import hatched
from wireprint.layerwise.lines import Lines
from wireprint.layerwise.route import Route, routed
from wireprint.layerwise.shells import split
from wireprint.layerwise.walls import walls

if TYPE_CHECKING:
    import numpy.typing as npt

    from wireprint.hybrid.cut import Cut, Samples
    from wireprint.hybrid.runs import Runs
    from wireprint.layerwise.recipe import Recipe

    Floats = npt.NDArray[np.float64]
    Ints = npt.NDArray[np.int64]
    Bools = npt.NDArray[np.bool_]

#: Sides of the filled area this near to a wall, in line spacings, need none of their own …
_WALLED = 0.5
#: … nor do those shorter than this many line widths.
_SHORTEST = 1.5
#: What is closed reaches beyond the outer wall by this part of a line's width.
_BEYOND = 0.1


@dataclass(frozen=True)
class Laid:
    """The lines of all runs in printing order, and what of the region's inside they fill."""

    route: Route
    depth: Depth
    #: What the last layer of each slab closes, walls included, shape (K,); empty for the others.
    lids: Geometries


def lay(
    cut: Cut, samples: Samples, runs: Runs, inside: Inside, recipe: Recipe, inset_mm: float
) -> Laid:
    """Lay the lines of all runs and bring them into printing order.

    The outer walls are group 0, all that lies behind them is group 1.

    Parameters
    ----------
    cut, samples, runs
        The layers, and what of them is painted.
    inside
        What of the region lies behind the surface.
    recipe
        Widths and counts.
    inset_mm
        From the model's surface to the centre of the outer wall, mm.
    """
    whole = _whole_contours(cut, samples, runs)
    areas = of_contours(cut, cut.closed, recipe.resolution_mm)
    filled = _in_whole_islands(cut, whole)
    painted = (runs.of_sample >= 0) & ~filled[samples.contour]
    edge = fringe(cut, samples, painted, areas, recipe, inset_mm)
    solid = of_contours(cut, filled, recipe.resolution_mm)
    deep = _depth(areas, solid, edge, inside, recipe)
    groups = [
        *_islands(solid, areas, recipe, inset_mm),
        *edge.groups,
        *_behind(deep, edge, areas, recipe),
    ]
    groups = [group for group in groups if len(group.lines)]
    route = _routed(groups, cut.z, recipe) if groups else Route.empty()
    return Laid(route, deep, _lids(cut, deep, edge, recipe))


def _routed(groups: list[Group], z: Floats, recipe: Recipe) -> Route:
    """Order lines by layer, and on each by place and group."""
    keys = [np.column_stack([group.layer, group.place]) for group in groups]
    places, owners = np.unique(np.concatenate(keys), axis=0, return_inverse=True)
    parts = np.split(owners.reshape(-1), np.cumsum([len(key) for key in keys])[:-1])
    lines = [
        Lines(group.lines.points, group.lines.offsets, owner, group.lines.closed)
        for group, owner in zip(groups, parts, strict=True)
    ]
    found = routed(lines, places[:, 0], z, recipe.seam_gap_mm)
    inside = np.array([group.is_inside for group in groups])
    return replace(found, group=inside[found.group].astype(np.int64))


def _whole_contours(cut: Cut, samples: Samples, runs: Runs) -> Bools:
    """Tell which contours are painted all around."""
    missing = np.bincount(samples.contour, runs.of_sample < 0, len(cut.closed))
    there = np.bincount(samples.contour, minlength=len(cut.closed))
    whole: Bools = cut.closed & (there > 0) & (missing == 0)
    return whole


def _in_whole_islands(cut: Cut, whole: Bools) -> Bools:
    """Tell which contours bound an island whose contours are all painted all around."""
    number = np.arange(len(whole))
    shell = np.where(cut.depth % 2 == 0, number, cut.parent)
    shell = np.where(shell < 0, number, shell)
    broken = np.bincount(shell, ~whole, len(whole)) > 0
    return whole & ~broken[shell]


def _islands(solid: Geometries, areas: Geometries, recipe: Recipe, inset_mm: float) -> list[Group]:
    """Walls, solid and sparse fill of whole islands."""
    pieces, layer = islands(solid)
    if not len(pieces):
        return []
    laid = walls(pieces, recipe.perimeters, inset_mm, recipe.spacing_mm, recipe.overlap_mm)
    # From the outside in: the outer wall stands on a contour, the others lean on it.
    lines = [*reversed(laid.lines), *_fill(laid.inner, layer, areas, _turns(layer), recipe)]
    outer = bool(laid.lines)
    return [
        Group(each, layer[each.owner], each.owner, is_inside=not (outer and number == 0))
        for number, each in enumerate(lines)
    ]


def _turns(layer: Ints) -> Floats:
    """Return the direction of the fill of each island, which takes turns from layer to layer."""
    return np.where(layer % 2 == 0, np.pi / 4, -np.pi / 4)


def _fill(
    inner: Geometries, layer: Ints, areas: Geometries, turn_rad: Floats, recipe: Recipe
) -> list[Lines]:
    """Fill what walls leave: solid below tops and above bottoms of the model, else sparse."""
    solid, sparse = split(inner, layer, areas, recipe.shells)
    width, spacing = recipe.width_mm, recipe.spacing_mm
    lines = [hatched(solid, turn_rad, spacing, width, recipe.solid_link_mm)]
    if recipe.infill_density > 0:
        wide = spacing / recipe.infill_density
        lines.append(hatched(sparse, turn_rad, wide, width, recipe.link_mm))
    return lines


def _depth(
    areas: Geometries, solid: Geometries, edge: Fringe, inside: Inside, recipe: Recipe
) -> Depth:
    """Find what of the inside can be filled; nothing where fill has no density."""
    marked = behind(areas, inside.sections, edge)
    if not recipe.infill_density:
        marked[:] = shapely.MultiPolygon()
    ground: Geometries = np.full(len(areas), inside.bed, dtype=object)
    ground[1:] = solid[:-1]
    return depth(marked, inside, ground, edge.innermost, recipe)


def _lids(cut: Cut, deep: Depth, edge: Fringe, recipe: Recipe) -> Geometries:
    """Return what the last layers of slabs close: what they fill, and the walls before it."""
    found: Geometries = np.full(len(cut.z), shapely.MultiPolygon(), dtype=object)
    last = np.flatnonzero(cut.is_last() & ~shapely.is_empty(deep.filled))
    filled, walled = deep.filled[last], edge.innermost[last]
    reach_mm = edge.inward_mm + _BEYOND * recipe.width_mm
    walled = shapely.intersection(buffered(filled, reach_mm), buffered(walled, reach_mm))
    found[last] = shapely.union(filled, walled)
    return found


def _behind(deep: Depth, edge: Fringe, areas: Geometries, recipe: Recipe) -> list[Group]:
    """Lay a wall along each side that no wall bounds yet, then the fill."""
    pieces, layer = islands(deep.filled)
    if not len(pieces):
        return []
    walled = buffered(edge.innermost[layer], _WALLED * recipe.spacing_mm)
    sides = shapely.difference(shapely.boundary(pieces), walled)
    inner = offset(pieces, recipe.overlap_mm - recipe.spacing_mm)
    usual = _turns(layer)
    turn = np.where(np.isnan(deep.turn_rad[layer]), usual, deep.turn_rad[layer])
    least_mm = _SHORTEST * recipe.width_mm
    return [
        Group.of_strings(sides, layer, least_mm, is_inside=True),
        *(
            Group(lines, layer[lines.owner], np.full(len(lines), -1), is_inside=True)
            for lines in _fill(inner, layer, areas, turn, recipe)
        ),
    ]
