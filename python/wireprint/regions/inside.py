"""What lies inside a region: its sections at given heights.

Shapes that are solids have an inside; paint (strokes, masks) lies on the surface alone, and neither
adds to it nor takes from it.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, TypeAlias

import numpy as np
import shapely

from wireprint.regions.shapes import Box, HalfSpace, Predicate, Sphere, ZRange

if TYPE_CHECKING:
    import numpy.typing as npt

    from wireprint.regions.region import Mark, Region

    Floats = npt.NDArray[np.float64]
    #: Lowest and highest x and y, mm, shape (2, 2).
    Bounds: TypeAlias = Floats

#: Geometries of shapely, dtype object.
Geometries: TypeAlias = "np.ndarray[Any, np.dtype[np.object_]]"

_EMPTY = shapely.MultiPolygon()
#: Corners that stand for an ellipse: on a radius of 50 mm, 0.06 mm are lost.
_CORNERS = 64
#: Planes that lean less than this, the tangent, are level.
_LEVEL = 1e-12
#: Points asked for at once.
_CHUNK = 1 << 20


def sections(region: Region, heights_mm: Floats, bounds: Bounds, pitch_mm: float) -> Geometries:
    """Cut the inside of a region.

    Parameters
    ----------
    region
        What is marked.
    heights_mm
        Where to cut, shape (K,).
    bounds
        Rectangle that holds all that is asked for; beyond it, nothing is told.
    pitch_mm
        Distance of the points at which a predicate is asked, mm; all other shapes are cut exactly.

    Returns
    -------
    numpy.ndarray
        Areas, possibly empty, shape (K,).
    """
    found: Geometries = np.full(len(heights_mm), _EMPTY, dtype=object)
    for mark in region.marks:
        cut = _cut(mark, heights_mm, bounds, pitch_mm)
        if cut is not None:
            found = shapely.difference(found, cut) if mark.erase else shapely.union(found, cut)
    return found


def _cut(mark: Mark, heights_mm: Floats, bounds: Bounds, pitch_mm: float) -> Geometries | None:
    """Return the sections of one mark; None for what has no inside."""
    match mark.shape:
        case Box() | HalfSpace() | ZRange() as shape:
            return _between_planes(_planes(shape), mark, heights_mm, bounds)
        case Sphere() as ball:
            return _ellipses(ball, mark, heights_mm)
        case Predicate():
            return _asked(mark, heights_mm, bounds, pitch_mm)
        case _:
            return None


def _planes(shape: Box | HalfSpace | ZRange) -> Floats:
    """Return rows (n, d): the shape is all points p with n · p ≥ d for each of them."""
    low: tuple[float | None, ...]
    high: tuple[float | None, ...]
    match shape:
        case HalfSpace():
            normal = np.asarray(shape.normal)
            return np.append(normal / np.linalg.norm(normal), shape.offset_mm)[None]
        case Box():
            low, high = shape.low_mm, shape.high_mm
        case ZRange():
            low, high = (None, None, shape.low_mm), (None, None, shape.high_mm)
    axes = np.eye(3)
    rows = [np.append(axis, end) for axis, end in zip(axes, low, strict=True) if end is not None]
    rows += [-np.append(axis, end) for axis, end in zip(axes, high, strict=True) if end is not None]
    return np.array(rows).reshape(-1, 4)


def _ellipses(ball: Sphere, mark: Mark, heights_mm: Floats) -> Geometries:
    """Solve |A·xy + b| ≤ r at each height."""
    inverse, shift = _own_frame(mark)
    plan, rise = inverse[:, :2], inverse[:, 2:]
    away = rise * heights_mm - (inverse @ shift + ball.centre_mm)[:, None]
    squares = plan.T @ plan
    centre = -np.linalg.solve(squares, plan.T @ away)
    left = ball.radius_mm**2 - np.sum((plan @ centre + away) ** 2, axis=0)
    turn = np.linspace(0.0, 2 * np.pi, _CORNERS, endpoint=False)
    # Where squares = L·Lᵀ and xy = L⁻ᵀ·u, A·xy is as long as u.
    circle = np.linalg.solve(np.linalg.cholesky(squares).T, [np.cos(turn), np.sin(turn)])
    found: Geometries = np.full(len(heights_mm), _EMPTY, dtype=object)
    met = np.flatnonzero(left > 0)
    if len(met):
        corners = centre.T[met, None] + np.sqrt(left[met])[:, None, None] * circle.T
        found[met] = shapely.polygons(corners)
    return found


def _asked(mark: Mark, heights_mm: Floats, bounds: Bounds, pitch_mm: float) -> Geometries:
    """Ask point by point, and join the squares around those that are covered."""
    columns, rows = (np.arange(low + pitch_mm / 2, high, pitch_mm) for low, high in bounds.T)
    plan = np.stack(np.meshgrid(columns, rows), axis=-1).reshape(-1, 2)
    found: Geometries = np.full(len(heights_mm), _EMPTY, dtype=object)
    if not len(plan):
        return found
    at_once = max(_CHUNK // len(plan), 1)
    for first in range(0, len(heights_mm), at_once):
        heights = heights_mm[first : first + at_once]
        points = np.column_stack([np.tile(plan, (len(heights), 1)), heights.repeat(len(plan))])
        covered = mark.covers(points, np.tile([0.0, 0.0, 1.0], (len(points), 1)))
        layers = covered.reshape(len(heights), len(rows), len(columns))
        for number, layer in enumerate(layers, first):
            found[number] = _squares(layer, columns, rows, pitch_mm)
    return found


def _squares(layer: npt.NDArray[np.bool_], x: Floats, y: Floats, pitch_mm: float) -> Any:
    """Return the area of the squares around the points that are covered, without their stairs."""
    edges = np.diff(np.pad(layer, ((0, 0), (1, 1))).astype(np.int8), axis=1)
    row, begin = np.nonzero(edges == 1)
    _, end = np.nonzero(edges == -1)
    half = pitch_mm / 2
    # By a hair wider, so that rows share more than their edges.
    hair = 1e-3 * half
    strips = shapely.box(x[begin] - half, y[row] - half - hair, x[end - 1] + half, y[row] + half)
    return shapely.simplify(shapely.union_all(strips), pitch_mm)


def _own_frame(mark: Mark) -> tuple[Floats, Floats]:
    """Return the inverse of the map from a shape's own frame, and the map's shift."""
    if mark.frame is None:
        return np.eye(3), np.zeros(3)
    frame = np.asarray(mark.frame)
    return np.linalg.inv(frame[:, :3]), frame[:, 3]


def _between_planes(planes: Floats, mark: Mark, heights_mm: Floats, bounds: Bounds) -> Geometries:
    """Cut what lies on the positive side of all planes of the mark's own frame."""
    inverse, shift = _own_frame(mark)
    turned = planes[:, :3] @ inverse
    moved = planes[:, 3] + turned @ shift
    found: Geometries = np.full(len(heights_mm), shapely.box(*bounds.reshape(-1)), dtype=object)
    for normal, offset in zip(turned, moved, strict=True):
        found = shapely.intersection(found, _half_planes(normal, offset, heights_mm, bounds))
    return found


def _half_planes(normal: Floats, offset: float, heights_mm: Floats, bounds: Bounds) -> Geometries:
    """Return, at each height, the part of the rectangle, and more, on a plane's positive side."""
    behind = offset - normal[2] * heights_mm
    steep = float(np.hypot(*normal[:2]))
    if steep <= _LEVEL * abs(normal[2]):
        level: Geometries = np.where(behind <= 0, shapely.box(*bounds.reshape(-1)), _EMPTY)
        return level
    ahead = normal[:2] / steep
    aside = np.array([-ahead[1], ahead[0]])
    centre, size = bounds.mean(axis=0), float(np.linalg.norm(bounds[1] - bounds[0]))
    # A rectangle on the line's far side that holds the bounds wherever the line is.
    far = behind / steep - ahead @ centre
    first = centre + far[:, None] * ahead
    deep = (size + np.abs(far))[:, None] * ahead
    corners = [first - size * aside, first - size * aside + deep]
    corners += [first + size * aside + deep, first + size * aside]
    found: Geometries = shapely.polygons(np.stack(corners, axis=1))
    return found
