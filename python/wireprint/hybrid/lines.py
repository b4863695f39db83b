"""The lines of a region's layers: walls along what is painted, fill where they close."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

import numpy as np
import shapely

from wireprint.hybrid.aprons import aprons
from wireprint.hybrid.depth import Depth, Inside, behind, depth
from wireprint.hybrid.floors import Floors, floors
from wireprint.hybrid.fringe import Fringe, fringe
from wireprint.hybrid.group import Group
from wireprint.layerwise.areas import Geometries, buffered, islands, of_contours, offset
from wireprint.layerwise.hatch import hatched
from wireprint.layerwise.lines import Lines
from wireprint.layerwise.route import Route, routed
from wireprint.layerwise.shells import split
from wireprint.layerwise.walls import walls
from wireprint.records import Record

if TYPE_CHECKING:
    from collections.abc import Callable

    import numpy.typing as npt

    from wireprint.hybrid.cut import Cut, Samples
    from wireprint.hybrid.runs import Runs
    from wireprint.hybrid.sketch import Sketch
    from wireprint.layerwise.recipe import Recipe

    Floats = npt.NDArray[np.float64]
    Ints = npt.NDArray[np.int64]
    Bools = npt.NDArray[np.bool_]

#: Sides of the filled area this near to a wall, in line spacings, need none of their own …
_WALLED = 0.5
#: … nor do those shorter than this many line widths.
_SHORTEST = 1.5
#: Walls this part of a line's width beside a strand lie on it …
_ON_IT = 0.12
#: … and what is left of them is at least this many line widths long.
_SHORTEST_WALL = 1.0
_NOTHING = shapely.MultiPolygon(), shapely.MultiLineString()
#: What is closed reaches beyond the outer wall by this part of a line's width.
_BEYOND = 0.1


@dataclass(frozen=True, repr=False)
class Laid(Record):
    """The lines of all runs in printing order, and what of the region's inside they fill."""

    route: Route
    depth: Depth
    #: Islands that are layers all around, shape (K,), and what of them is filled.
    solid: Geometries
    floors: Floors
    #: What the last layer of each slab closes, walls included, shape (K,); empty for the others.
    lids: Geometries
    #: From the contour to the centre of the innermost wall of an island, mm.
    walls_mm: float

    def within_walls(self, layer: int) -> shapely.Geometry:
        """Return what of whole islands is filled on a layer, up to their innermost walls."""
        room = offset(self.solid[[layer]], -self.walls_mm)[0]
        return shapely.intersection(room, self.floors.firm[layer])

    def open_mm2(self) -> Floats:
        """Return the area of whole islands that stays open on each layer, mm², shape (K,)."""
        found = np.zeros(len(self.solid))
        open_ = np.flatnonzero(self.floors.is_open)
        within = offset(self.solid[open_], -self.walls_mm)
        found[open_] = shapely.area(shapely.difference(within, self.floors.firm[open_]))
        return found


def lay(
    sketch: Sketch, runs: Runs, inside: Inside, inset_mm: float, on_step: Callable[[str], None]
) -> Laid:
    """Lay the lines of all runs and bring them into printing order.

    The outer walls are group 0, all that lies behind them is group 1.

    Parameters
    ----------
    sketch
        The layers, and the widths and counts of their lines.
    runs
        What of the layers is painted.
    inside
        What of the region lies behind the surface.
    inset_mm
        From the model's surface to the centre of the outer wall, mm.
    on_step
        Called before each step with its name; it may raise to give up.
    """
    cut, samples, recipe, areas = sketch.cut, sketch.samples, sketch.recipe, sketch.areas
    whole = _whole_contours(cut, samples, runs)
    filled = _in_whole_islands(cut, whole)
    painted = (runs.of_sample >= 0) & ~filled[samples.contour]
    on_step("walls")
    edge = fringe(cut, samples, painted, areas, recipe, inset_mm)
    solid = of_contours(cut, filled, recipe.resolution_mm)
    walls_mm = inset_mm + max(recipe.perimeters - 1, 0) * recipe.spacing_mm
    floor = floors(solid, inside, walls_mm, recipe, on_step)
    deep = _depth(areas, floor.firm, edge, inside, recipe, on_step)
    # What carries the fill of the layers above: where there is none, they begin with a floor.
    filled = shapely.union(deep.filled, floor.firm)
    stack = Stack(areas, filled, recipe)
    outer, inner = (shapely.boundary(offset(solid, -mm)) for mm in (inset_mm, walls_mm))
    outer = shapely.union(outer, edge.outer)
    doubled, inner = shapely.union(outer, inner), shapely.union(inner, edge.innermost)
    groups = aprons(cut, areas, outer, shapely.union(outer, inner), doubled, recipe, on_step)
    behind_walls = _clear_of(groups, edge.groups[1:], recipe)
    on_step("walls and fill")
    groups += [*_islands(solid, floor, stack, inset_mm), *edge.groups[:1], *behind_walls]
    on_step("fill behind walls")
    groups += stack.filled(deep.filled, edge.innermost, deep.turn_rad)
    groups += stack.filled(*_left_open(solid, floor, walls_mm))
    on_step("the order of lines")
    groups = [group for group in groups if len(group.lines)]
    route = _routed(groups, cut.z, recipe) if groups else Route.empty()
    return Laid(route, deep, solid, floor, _lids(cut, deep, edge, recipe), walls_mm)


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


def _clear_of(laid: list[Group], walls: list[Group], recipe: Recipe) -> list[Group]:
    """Leave out of inner walls what would lie on strands that lead up to the outer ones.

    These come first, and one that was missing among them would leave all that lean on it in the
    air; a wall behind the outer one can be missing.
    """
    if not laid:
        return walls
    apart_mm, least_mm = _ON_IT * recipe.width_mm, _SHORTEST_WALL * recipe.width_mm
    strands = np.concatenate([group.strings for group in laid])
    below, place = np.unique(np.concatenate([group.layer for group in laid]), return_inverse=True)
    order = np.argsort(place, kind="stable")
    near = buffered(shapely.multilinestrings(strands[order], indices=place[order]), apart_mm)
    cleared = []
    for group in walls:
        there = np.searchsorted(below, group.layer)
        met = np.flatnonzero(np.isin(group.layer, below))
        left = group.strings.copy()
        left[met] = shapely.difference(left[met], near[there[met]])
        cleared.append(Group.of_strings(left, group.layer, least_mm, is_inside=True))
    return cleared


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


def _islands(solid: Geometries, floor: Floors, stack: Stack, inset_mm: float) -> list[Group]:
    """Walls, solid and sparse fill of whole islands."""
    pieces, layer = islands(solid)
    if not len(pieces):
        return []
    recipe = stack.recipe
    laid = walls(pieces, recipe.perimeters, inset_mm, recipe.spacing_mm, recipe.overlap_mm)
    inner = laid.inner.copy()
    inner[floor.is_open[layer]] = shapely.MultiPolygon()
    # From the outside in: the outer wall stands on a contour, the others lean on it.
    lines = [*reversed(laid.lines), *stack.fill(inner, layer, floor.turn_rad)]
    outer = bool(laid.lines)
    return [
        Group(each, layer[each.owner], each.owner, is_inside=not (outer and number == 0))
        for number, each in enumerate(lines)
    ]


def _left_open(
    solid: Geometries, floor: Floors, walls_mm: float
) -> tuple[Geometries, Geometries, Floats]:
    """Return what islands that stay open in part fill, their innermost walls, and the turn."""
    open_ = np.flatnonzero(floor.is_open)
    within, walled = (np.full(len(solid), empty, dtype=object) for empty in _NOTHING)
    rooms = offset(solid[open_], -walls_mm) if walls_mm else solid[open_]
    within[open_] = shapely.intersection(floor.firm[open_], rooms)
    walled[open_] = shapely.boundary(rooms)
    return within, walled, floor.turn_rad


def _turns(layer: Ints) -> Floats:
    """Return the direction of the fill of each island, which takes turns from layer to layer."""
    return np.where(layer % 2 == 0, np.pi / 4, -np.pi / 4)


def _depth(
    areas: Geometries,
    solid: Geometries,
    edge: Fringe,
    inside: Inside,
    recipe: Recipe,
    on_step: Callable[[str], None],
) -> Depth:
    """Find what of the inside can be filled; nothing where fill has no density."""
    marked = behind(areas, inside.sections, edge)
    if not recipe.infill_density:
        marked[:] = shapely.MultiPolygon()
    ground: Geometries = np.full(len(areas), inside.bed, dtype=object)
    ground[1:] = solid[:-1]
    return depth(marked, inside, ground, edge.innermost, recipe, on_step)


def _lids(cut: Cut, deep: Depth, edge: Fringe, recipe: Recipe) -> Geometries:
    """Return what the last layers of slabs close: what they fill, and the walls before it."""
    found: Geometries = np.full(len(cut.z), shapely.MultiPolygon(), dtype=object)
    last = np.flatnonzero(cut.is_last() & ~shapely.is_empty(deep.filled))
    filled, walled = deep.filled[last], edge.innermost[last]
    reach_mm = edge.inward_mm + _BEYOND * recipe.width_mm
    walled = shapely.intersection(buffered(filled, reach_mm), buffered(walled, reach_mm))
    found[last] = shapely.union(filled, walled)
    return found


@dataclass(frozen=True)
class Stack:
    """What the layers cover and fill, by which fill is solid or sparse."""

    #: What the model covers, and what of it is filled, shape (K,).
    areas: Geometries
    firm: Geometries
    recipe: Recipe

    def filled(self, areas: Geometries, innermost: Geometries, turn_rad: Floats) -> list[Group]:
        """Fill areas that reach up to walls, with a wall along each side that has none yet."""
        recipe = self.recipe
        pieces, layer = islands(areas)
        if not len(pieces):
            return []
        walled = buffered(innermost[layer], _WALLED * recipe.spacing_mm)
        sides = shapely.difference(shapely.boundary(pieces), walled)
        inner = offset(pieces, recipe.overlap_mm - recipe.spacing_mm)
        least_mm = _SHORTEST * recipe.width_mm
        return [
            Group.of_strings(sides, layer, least_mm, is_inside=True),
            *(
                Group(lines, layer[lines.owner], np.full(len(lines), -1), is_inside=True)
                for lines in self.fill(inner, layer, turn_rad)
            ),
        ]

    def fill(self, inner: Geometries, layer: Ints, turn_rad: Floats) -> list[Lines]:
        """Fill what walls leave: solid near tops, bottoms and what is hollow below, else sparse.

        The direction of each layer is given where it matters, else not a number.
        """
        recipe = self.recipe
        turn = np.where(np.isnan(turn_rad[layer]), _turns(layer), turn_rad[layer])
        solid, sparse = split(inner, layer, self.areas, recipe.shells, self.firm)
        width, spacing = recipe.width_mm, recipe.spacing_mm
        lines = [hatched(solid, turn, spacing, width, recipe.solid_link_mm)]
        if recipe.infill_density > 0:
            wide = spacing / recipe.infill_density
            lines.append(hatched(sparse, turn, wide, width, recipe.link_mm))
        return lines
