"""Which part of a model's surface is marked: its triangles, cut where a region ends."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Final

import numpy as np

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator

    import numpy.typing as npt

    from wireprint._core import Mesh
    from wireprint.regions.region import Region

    _Triangles = npt.NDArray[np.float64]
    _States = npt.NDArray[np.uint8]

#: Marks are looked for on pieces that are no longer than this share of the model's diagonal,
COARSE: Final = 1 / 100
#: or than makes about so many of them.
MOST_PIECES: Final = 60_000
#: Where a region ends, pieces are cut until they are no longer than this share.
FINE: Final = 1 / 1500
#: Pieces up to so many times that length are not cut at all: a fine mesh has millions.
SMALL: Final = 4
#: Triangles that are cut at a time: what they take fits a processor's cache.
BATCH: Final = 1 << 14
#: State of a piece: marked (1), not (0), or neither as a whole.
_MIXED: Final = 2
#: How far towards its corners a piece is asked about, so that no point lies on two of them.
_REACH: Final = 0.96


@dataclass(frozen=True)
class MarkedSurface:
    """A surface in pieces that are marked or not, as large as they can be."""

    #: float64 of shape (T, 3, 3): corners, counter-clockwise seen from outside, mm.
    corners: npt.NDArray[np.float64]
    #: bool of shape (T,).
    marked: npt.NDArray[np.bool_]
    marked_mm2: float
    area_mm2: float


def marked_surface(mesh: Mesh, region: Region) -> MarkedSurface:
    """Cut a model's surface where a region ends.

    Parameters
    ----------
    mesh
        The model.
    region
        Marks in its frame.
    """
    found = list(_batches(mesh, region))
    pieces = np.concatenate([corners for corners, _ in found])
    marked = np.concatenate([states for _, states in found])
    areas = _areas(pieces)
    return MarkedSurface(pieces, marked, float(areas[marked].sum()), float(areas.sum()))


def marked_area(mesh: Mesh, region: Region) -> tuple[float, float]:
    """Return how much of a model's surface is marked, and how large all of it is, mm².

    The same as `marked_surface` tells, without keeping the pieces.
    """
    marked_mm2 = area_mm2 = 0.0
    for corners, marked in _batches(mesh, region):
        areas = _areas(corners)
        marked_mm2 += float(areas[marked].sum())
        area_mm2 += float(areas.sum())
    return marked_mm2, area_mm2


def _batches(mesh: Mesh, region: Region) -> Iterator[tuple[_Triangles, npt.NDArray[np.bool_]]]:
    """Yield the pieces and which of them are marked, of some triangles at a time."""
    diagonal_mm = float(np.linalg.norm(mesh.size_mm))
    coarse_mm = max(COARSE * diagonal_mm, float(np.sqrt(4 * mesh.area / MOST_PIECES)))
    fine_mm = FINE * diagonal_mm
    vertices, faces = mesh.vertices, mesh.faces
    for begin in range(0, len(faces), BATCH):
        triangles = vertices[faces[begin : begin + BATCH]]
        corners, states = _cut(triangles, coarse_mm, lambda p: _around(p, region, SMALL * fine_mm))
        mixed = states == _MIXED
        finer, finer_states = _cut(corners[mixed], fine_mm, lambda p: _asked(p, p, region))
        pieces = np.concatenate([corners[~mixed], finer])
        yield pieces, np.concatenate([states[~mixed], finer_states]) == 1


def _areas(triangles: _Triangles) -> npt.NDArray[np.float64]:
    """Return how large triangles are, mm²."""
    areas: npt.NDArray[np.float64] = np.linalg.norm(_normals(triangles), axis=1) / 2
    return areas


def _cut(
    triangles: _Triangles, longest_mm: float, ask: Callable[[_Triangles], _States]
) -> tuple[_Triangles, _States]:
    """Halve triangles until they are short, ask for the states, and join halves that agree."""
    levels, halved = _halved(triangles, longest_mm)
    ends = np.concatenate([level[~cut] for level, cut in zip(levels, halved, strict=True)])
    states = _joined(halved, ask(ends))
    pieces, found, mixed_above = [], [], np.ones(len(triangles), np.bool_)
    for level, state, cut in zip(levels, states, halved, strict=True):
        kept = mixed_above & ((state != _MIXED) | ~cut)
        pieces.append(level[kept])
        found.append(state[kept])
        mixed_above = np.repeat((state == _MIXED)[cut] & mixed_above[cut], 2)
    return np.concatenate(pieces), np.concatenate(found)


def _halved(
    triangles: _Triangles, longest_mm: float
) -> tuple[list[_Triangles], list[npt.NDArray[np.bool_]]]:
    """Halve triangles at their longest edges: the pieces of each level, and which are halved.

    The two halves of a piece follow each other in the next level.
    """
    levels, halved = [triangles], []
    while True:
        level = levels[-1]
        edges = np.linalg.norm(level[:, (1, 2, 0)] - level, axis=2)
        long = edges.max(axis=1, initial=0) > longest_mm
        halved.append(long)
        if not long.any():
            return levels, halved
        # Turned so that the longest edge comes first.
        turn = (edges[long].argmax(axis=1)[:, None] + np.arange(3)) % 3
        a, b, c = np.take_along_axis(level[long], turn[:, :, None], axis=1).transpose(1, 0, 2)
        middle = (a + b) / 2
        halves = np.stack([a, middle, c, middle, b, c], axis=1)
        levels.append(halves.reshape(-1, 3, 3))


def _joined(halved: list[npt.NDArray[np.bool_]], ends: _States) -> list[_States]:
    """Return the states of all pieces of each level, given those that are not halved."""
    states: list[_States] = []
    end = len(ends)
    for cut in reversed(halved):
        state = np.full(len(cut), _MIXED, np.uint8)
        begin = end - int(np.count_nonzero(~cut))
        state[~cut] = ends[begin:end]
        if states:
            first, second = states[-1].reshape(-1, 2).T
            state[cut] = np.where(first == second, first, _MIXED)
        states.append(state)
        end = begin
    return states[::-1]


def _around(pieces: _Triangles, region: Region, least_mm: float) -> _States:
    """Ask about pieces in their middles and, unless they are small, near their corners."""
    states = _asked(pieces, pieces, region)
    large = np.flatnonzero(np.ptp(pieces, axis=1).max(axis=1) > least_mm)
    middles = pieces[large].mean(axis=1, keepdims=True)
    points = middles + _REACH * (pieces[large] - middles)
    asked = _asked(points.reshape(-1, 1, 3), np.repeat(pieces[large], 3, axis=0), region)
    states[large[(asked.reshape(-1, 3) != states[large, None]).any(axis=1)]] = _MIXED
    return states


def _asked(points: _Triangles, pieces: _Triangles, region: Region) -> _States:
    """Ask about the means of points, each on a piece."""
    normals = _normals(pieces)
    length = np.linalg.norm(normals, axis=1, keepdims=True)
    np.divide(normals, length, where=length > 0, out=normals)
    return region.covers(points.mean(axis=1), normals).astype(np.uint8)


def _normals(triangles: _Triangles) -> npt.NDArray[np.float64]:
    """Return normals, twice as long as a triangle is large."""
    a, b, c = triangles.transpose(1, 0, 2)
    return np.cross(b - a, c - a)
