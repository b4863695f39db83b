"""A model's edges as beams, with struts, and what each layer sees of them."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
import shapely

from wireprint.layerwise import edges, struts
from wireprint.layerwise.areas import Geometries, layer_count, simplified, sound
from wireprint.layerwise.threads import mapped

if TYPE_CHECKING:
    import numpy.typing as npt

    from wireprint._core import Mesh
    from wireprint.settings.layers import Frame

    Floats = npt.NDArray[np.float64]

#: By how many widths of a beam its simplified sections may stray.
_STRAY = 0.02


def areas(mesh: Mesh, frame: Frame, layer_mm: float) -> Geometries:
    """Return what each layer sees of a model's frame.

    Parameters
    ----------
    mesh
        The model, its lowest point at z = 0.
    frame
        Which edges become beams, and how wide these are.
    layer_mm
        Height of a layer, mm.

    Returns
    -------
    numpy.ndarray
        One area for each layer, from the lowest.
    """
    wires = _inset(edges.of_model(mesh, frame), mesh, frame.beam_mm)
    beams = np.concatenate([wires, struts.under(wires, frame.beam_mm, frame.bridge_mm)])
    return sections(beams, frame.beam_mm, layer_mm, layer_count(mesh.size_mm[2], layer_mm))


@dataclass(frozen=True)
class _Cuts:
    """Where layers cut beams; one row a cut."""

    beam: npt.NDArray[np.int64]
    layer: npt.NDArray[np.int64]


def sections(beams: Floats, beam_mm: float, layer_mm: float, layers: int) -> Geometries:
    """Cut square beams at the middle of each layer.

    Parameters
    ----------
    beams
        Ends of the beams' axes, mm, shape (N, 2, 3).
    beam_mm
        Width of a beam, mm; beams are as much longer than their axes.
    layer_mm, layers
        Height of a layer, mm, and how many there are.
    """
    radius = beam_mm / 2
    low, high = beams[:, :, 2].min(axis=1) - radius, beams[:, :, 2].max(axis=1) + radius
    cuts = _cuts(low, high, layer_mm, layers)
    corners = _corners(beams[cuts.beam], (cuts.layer.astype(np.float64) + 0.5) * layer_mm, radius)
    order = np.argsort(cuts.layer, kind="stable")
    result: Geometries = np.full(layers, shapely.MultiPolygon(), dtype=object)
    filled, group = np.unique(cuts.layer[order], return_inverse=True)
    if len(filled):
        stacks = shapely.multipolygons(shapely.polygons(corners[order]), indices=group)
        result[filled] = sound(simplified(mapped(_united, stacks), _STRAY * beam_mm))
    return result


def _united(stacks: Geometries) -> Geometries:
    united: Geometries = shapely.union_all(stacks[:, np.newaxis], axis=1)
    return united


def _cuts(low: Floats, high: Floats, layer_mm: float, layers: int) -> _Cuts:
    first = np.maximum(np.ceil(low / layer_mm - 0.5).astype(np.int64), 0)
    last = np.minimum(np.ceil(high / layer_mm - 0.5).astype(np.int64), layers)
    counts = np.maximum(last - first, 0)
    beam = np.repeat(np.arange(len(low)), counts)
    layer = np.arange(len(beam)) - (np.cumsum(counts) - counts)[beam] + first[beam]
    return _Cuts(beam, layer)


def _corners(beams: Floats, z: Floats, radius: float) -> Floats:
    """Corners of the rectangle that a plane cuts from each beam, shape (N, 4, 2).

    A beam that rises at α is cut over the length 2·radius / sin α, but no further than its ends.
    """
    begin, end = beams[:, 0], beams[:, 1]
    run = np.hypot(*(end - begin)[:, :2].T)
    rise = end[:, 2] - begin[:, 2]
    reach = radius * np.tan(np.pi / 4 - np.arctan2(np.abs(rise), run) / 2)
    flat = np.abs(rise) < 1e-9
    slope = np.where(flat, 1.0, rise)
    shares = np.stack([z - reach - begin[:, 2], z + reach - begin[:, 2]], axis=1) / slope[:, None]
    shares = np.where(flat[:, None], [0.0, 1.0], np.clip(np.sort(shares, axis=1), 0.0, 1.0))
    points = begin[:, None, :2] + shares[:, :, None] * (end - begin)[:, None, :2]
    upright = run < 1e-9
    along = np.where(upright[:, None], [1.0, 0.0], (end - begin)[:, :2])
    along *= radius / np.linalg.norm(along, axis=1)[:, None]
    aside = np.stack([-along[:, 1], along[:, 0]], axis=1)
    back, front = points[:, 0] - along, points[:, 1] + along
    return np.stack([back - aside, front - aside, front + aside, back + aside], axis=1)


def _inset(wires: Floats, mesh: Mesh, beam_mm: float) -> Floats:
    """Draw the wires in by half a beam on all sides, so that the frame keeps the model's size."""
    low, high = mesh.bounds
    size = np.maximum(high - low, 1e-9)
    centre = (low + high) / 2
    inset: Floats = centre + (wires - centre) * np.maximum(size - beam_mm, 0.0) / size
    return inset
