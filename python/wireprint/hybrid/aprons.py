"""Strands beside each other that lead up to a wall which lies aside of what is below it.

A shallow slope carries the next layer's wall further aside than strands touch. The first of these
strands touches the rim below, each leans on the one before, and the wall on the last one: so roofs
are printed in arcs as well.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
import shapely

from wireprint._core import within
from wireprint.hybrid.group import Group
from wireprint.layerwise.areas import Geometries, buffered, grown, pieces_in

if TYPE_CHECKING:
    from collections.abc import Callable

    import numpy.typing as npt

    from wireprint.hybrid.cut import Cut
    from wireprint.layerwise.recipe import Recipe

    Floats = npt.NDArray[np.float64]
    Ints = npt.NDArray[np.int64]
    Bools = npt.NDArray[np.bool_]

_STEP = "what leads up to walls"
#: From strand to strand, as a part of the farthest that still touches.
_TOUCH = 0.9
#: From a rim of wire, which may stray by half its diameter, to the first, as a part of a strand.
_TOUCH_RIM = 0.4
#: Most strands beside each other.
_MOST = 16
#: Strands nearer to a wall than this part of their distance from each other are left to it.
_DOUBLE = 0.15
#: Points along a wall by which it is told whether it is loose are so many steps apart.
_SAMPLED = 0.4
#: Pieces shorter than this many line widths are left out.
_SHORTEST = 1.0


def aprons(
    cut: Cut,
    areas: Geometries,
    outer: Geometries,
    walls: Geometries,
    doubled: Geometries,
    recipe: Recipe,
    on_step: Callable[[str], None],
) -> list[Group]:
    """Lay strands from the rims below towards outer walls that nothing else holds.

    Parameters
    ----------
    cut
        The layers.
    areas
        What the model covers on each layer, shape (K,).
    outer, walls
        The centre lines of the outer walls on each layer, and of all walls, shape (K,).
    doubled
        The centre lines of walls that no strand may lie on, shape (K,).
    recipe
        Widths.
    on_step
        Called before each step, and each row of strands; it may raise to give up.
    """
    on_step(_STEP)
    step_mm = _TOUCH * np.sqrt(np.maximum(recipe.width_mm**2 - cut.thickness**2, 0.0))
    layers = 1 + np.flatnonzero(~shapely.is_empty(outer[1:]) & (step_mm[1:] > 0))
    below, step = areas[layers - 1], step_mm[layers]
    # Below lie the walls of the last layer, and at a slab's foot the rims of the wire.
    on_wire = cut.is_last()[layers - 1]
    first = np.where(on_wire, np.minimum(_TOUCH_RIM * recipe.width_mm, step), step)
    walled = outer[layers - 1]
    rims = np.where(on_wire, shapely.boundary(below), walled)
    unsure = _leaves(outer[layers], (rims, walled), first)
    layers, first, step = layers[unsure], first[unsure], step[unsure]
    below, rims, walled = below[unsure], rims[unsure], walled[unsure]
    on_step(_STEP)
    about = _about(rims, outer[layers], first)
    loose = shapely.difference(outer[layers], grown(about, first))
    loose = shapely.difference(loose, grown(_about(walled, loose, step), step))
    rims = shapely.union(rims, walled)
    # Walls that close in find the fill of the layer below under them, where there is one.
    closing = shapely.intersection(loose, below)
    far = np.flatnonzero(_leaves(closing, (walls[layers - 1],), _MOST * step))
    inner = buffered(walls[layers[far] - 1], _MOST * step[far])
    alone = np.full(len(layers), shapely.MultiLineString(), dtype=object)
    alone[far] = shapely.difference(closing[far], inner)
    loose = shapely.union(shapely.difference(loose, below), alone)
    near = shapely.distance(loose, rims) < _MOST * step
    wanted = near & (shapely.length(loose) > _SHORTEST * recipe.width_mm)
    layers, below, loose, rims = (each[wanted] for each in (layers, below, loose, rims))
    first, step = first[wanted], step[wanted]
    if not len(layers):
        return []
    on_step(_STEP)
    reach = np.array([_reach(*pair) for pair in zip(loose, rims, strict=True)])
    reach = np.minimum(reach + step, _MOST * step)
    # What is far from them costs as much, and changes nothing.
    boxes = _boxes(loose, 2 * (reach + recipe.width_mm))
    here, below = (pieces_in(each, boxes) for each in (areas[layers], below))
    between = shapely.symmetric_difference(here, below)
    room = shapely.intersection(between, buffered(loose, reach))
    room = shapely.intersection(room, grown(_about(rims, loose, 2 * reach), reach))
    about = _about(doubled[layers], loose, reach + step)
    room = shapely.difference(room, grown(about, _DOUBLE * step))
    below = pieces_in(shapely.intersection(below, shapely.box(*boxes.T)), boxes)
    groups = []
    for number in range(1, _MOST + 1):
        on_step(_STEP)
        aside = first + (number - 1) * step
        # No room is farther than this from the edge of what lies below.
        near = np.flatnonzero(aside <= reach + recipe.width_mm)
        sides = [shapely.boundary(buffered(below[near], way * aside[near])) for way in (1, -1)]
        strings: Geometries = np.full(len(layers), shapely.MultiLineString(), dtype=object)
        strings[near] = shapely.intersection(shapely.union(*sides), room[near])
        if shapely.is_empty(strings).all():
            break
        least_mm = _SHORTEST * recipe.width_mm
        groups.append(Group.of_strings(strings, layers, least_mm, is_inside=True))
    return groups


def _about(lines: Geometries, places: Geometries, reach_mm: Floats) -> Geometries:
    """Return what of lines is in the box about some places, grown by a reach on all sides."""
    found: Geometries = shapely.intersection(lines, shapely.box(*_boxes(places, reach_mm).T))
    return found


def _boxes(places: Geometries, reach_mm: Floats) -> Floats:
    """Return the box about each place, grown by a reach on all sides, shape (N, 4)."""
    grown: Floats = shapely.bounds(places) + np.outer(reach_mm, [-1.0, -1.0, 1.0, 1.0])
    return grown


def _leaves(lines: Geometries, rims: tuple[Geometries, ...], step_mm: Floats) -> Bools:
    """Tell which lines may have a part that is farther than a step from the rims of their layer.

    That no part is can be told from points along them, which is much sooner done than to grow the
    rims: nothing of a line is farther away than the nearest point is by half of what parts points.
    """
    apart_mm = _SAMPLED * step_mm
    points, line = shapely.get_coordinates(shapely.segmentize(lines, apart_mm), return_index=True)
    ends, of_line = zip(*map(_segments, rims), strict=True)
    reach_mm = (step_mm - apart_mm / 2)[line]
    near = within(points, line, reach_mm, (np.concatenate(ends), np.concatenate(of_line)))
    found: Bools = np.bincount(line, ~near, len(lines)) > 0
    return found


def _segments(lines: Geometries) -> tuple[Floats, Ints]:
    """Return the segments of all lines, shape (S, 2, 2), and which each is of."""
    parts, line = shapely.get_parts(lines, return_index=True)
    points, part = shapely.get_coordinates(parts, return_index=True)
    begins = np.flatnonzero(part[1:] == part[:-1])
    return np.stack([points[begins], points[begins + 1]], axis=1), line[part[begins]]


def _reach(loose: shapely.Geometry, rims: shapely.Geometry) -> float:
    """Return how far the farthest corner of some lines is from others, mm."""
    corners = shapely.points(shapely.get_coordinates(loose))
    return float(shapely.distance(corners, rims).max())
