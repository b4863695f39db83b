"""The edges that stand for a model: its sharp ones; rings and posts where it bends smoothly."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
import shapely

from wireprint import _core
from wireprint.layerwise.areas import Geometries, of_slices
from wireprint.layerwise.chains import chains, thinned

if TYPE_CHECKING:
    import numpy.typing as npt

    from wireprint._core import Mesh
    from wireprint.settings.layers import Frame

    Floats = npt.NDArray[np.float64]

#: Where sharp edges carry less than this share of a model's bending, they do not show its shape.
_MOSTLY = 0.5
#: Stands for the angle at a rim, which has one face, rad: always an edge, but no bend.
_RIM = 2 * np.pi


def of_model(mesh: Mesh, frame: Frame) -> Floats:
    """Return a model's edges as segments, mm, shape (N, 2, 3).

    Parameters
    ----------
    mesh
        The model.
    frame
        What counts as an edge.

    Notes
    -----
    How much a model bends at an edge is the edge's length times the angle between its faces;
    the sum over all edges does not depend on how finely a curved surface is tessellated.
    """
    ends, angles = _edges(mesh)
    bends = np.linalg.norm(np.diff(mesh.vertices[ends], axis=1)[:, 0], axis=1) * angles
    bends[angles == _RIM] = 0.0
    sharp = angles > np.radians(frame.sharp_deg)
    wires = _wires(mesh, ends[sharp], frame)
    if bends[sharp].sum() >= _MOSTLY * bends.sum():
        return wires
    return np.concatenate([wires, *_rings_and_posts(mesh, frame)])


def _edges(mesh: Mesh) -> tuple[npt.NDArray[np.int64], Floats]:
    """Return the ends of each edge, shape (E, 2), and the angle between its faces, rad."""
    vertices, faces = mesh.vertices, mesh.faces.astype(np.int64)
    normals = np.cross(
        vertices[faces[:, 1]] - vertices[faces[:, 0]], vertices[faces[:, 2]] - vertices[faces[:, 0]]
    )
    normals /= np.maximum(np.linalg.norm(normals, axis=1), 1e-30)[:, None]
    sides = np.sort(faces[:, [0, 1, 1, 2, 2, 0]].reshape(-1, 2), axis=1)
    keys = sides[:, 0] * len(vertices) + sides[:, 1]
    order = np.argsort(keys, kind="stable")
    firsts = np.flatnonzero(np.diff(keys[order], prepend=-1))
    counts = np.diff(np.append(firsts, len(order)))
    one, other = order[firsts], order[firsts + np.minimum(counts, 2) - 1]
    cosines = np.einsum("ij,ij->i", normals[one // 3], normals[other // 3])
    angles = np.where(counts == 1, _RIM, np.arccos(np.clip(cosines, -1.0, 1.0)))
    return sides[one], angles


def _wires(mesh: Mesh, ends: npt.NDArray[np.int64], frame: Frame) -> Floats:
    """Join edges to lines, straighten these, and drop what is shorter than a beam is wide."""
    found = [np.zeros((0, 2, 3))]
    for chain in chains(ends):
        points = mesh.vertices[chain]
        if np.linalg.norm(np.diff(points, axis=0), axis=1).sum() > frame.beam_mm:
            corners = thinned(points, frame.simplify_mm)
            found.append(np.stack([corners[:-1], corners[1:]], axis=1))
    return np.concatenate(found)


def _rings_and_posts(mesh: Mesh, frame: Frame) -> list[Floats]:
    """Return contours at a coarse pitch, and posts from each to the one above."""
    height = mesh.size_mm[2]
    count = max(2, round(height / frame.pitch_mm) + 1)
    margin = min(frame.beam_mm, height) / 2
    levels = np.linspace(margin, height - margin, count)
    areas = of_slices(_core.slice_mesh(mesh, levels), frame.simplify_mm)
    rims = shapely.boundary(areas)
    rings = [_ring(rim, z) for rim, z in zip(rims, levels, strict=True)]
    posts = [
        _posts(rims[k], rims[k + 1], levels[k], levels[k + 1], frame.pitch_mm)
        for k in range(count - 1)
    ]
    return rings + posts


def _ring(rim: object, z: float) -> Floats:
    points, line = shapely.get_coordinates(shapely.get_parts(rim), return_index=True)
    points = np.column_stack([points, np.full(len(points), z)])
    joined = np.flatnonzero(line[1:] == line[:-1])
    return np.stack([points[joined], points[joined + 1]], axis=1)


def _posts(lower: object, upper: object, z0: float, z1: float, pitch_mm: float) -> Floats:
    """Lead from evenly spaced points of the lower rim to the nearest of the upper one."""
    lines: Geometries = shapely.get_parts(lower)
    lengths = shapely.length(lines)
    counts = np.maximum(np.round(lengths / pitch_mm).astype(np.int64), 1)
    line = np.repeat(np.arange(len(lines)), counts)
    number = np.arange(len(line)) - (np.cumsum(counts) - counts)[line]
    feet = shapely.line_interpolate_point(lines[line], number / counts[line], normalized=True)
    links = shapely.shortest_line(feet, upper)
    links = links[~shapely.is_missing(links) & (shapely.length(links) <= pitch_mm)]
    ends = shapely.get_coordinates(links).reshape(-1, 2, 2)
    heights = np.broadcast_to([[[z0], [z1]]], (len(ends), 2, 1))
    return np.concatenate([ends, heights], axis=2)
