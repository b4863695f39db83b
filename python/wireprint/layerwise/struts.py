"""Struts at 45° under beams that overhang."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

if TYPE_CHECKING:
    import numpy.typing as npt

    Floats = npt.NDArray[np.float64]

#: A pair of struts carries this many bridges' length of a beam.
_BRIDGES_A_PAIR = 3


def under(wires: Floats, beam_mm: float, bridge_mm: float) -> Floats:
    """Return the struts that carry beams flatter than 45°.

    Parameters
    ----------
    wires
        Ends of the beams' axes, mm, shape (N, 2, 3); the lowest beams lie on the bed.
    beam_mm
        Width of a beam, mm.
    bridge_mm
        Shorter beams span their length by themselves, mm.

    Returns
    -------
    numpy.ndarray
        Ends of the struts' axes, from the beam down, shape (M, 2, 3). From points along the beam,
        two struts each lead down and outwards, to the first beam they meet or to the bed.
    """
    along = wires[:, 1] - wires[:, 0]
    run = np.hypot(along[:, 0], along[:, 1])
    lowest = wires[:, :, 2].min(axis=1)
    length = np.linalg.norm(along, axis=1)
    hanging = (np.abs(along[:, 2]) < run) & (length > bridge_mm) & (lowest > beam_mm)
    beams = np.flatnonzero(hanging)
    counts = np.ceil(length[beams] / (_BRIDGES_A_PAIR * bridge_mm)).astype(np.int64)
    beam = np.repeat(beams, counts)
    number = np.arange(len(beam)) - np.repeat(np.cumsum(counts) - counts, counts)
    share = (number + 0.5) / np.repeat(counts, counts)
    tops = np.repeat(wires[beam, 0] + share[:, None] * along[beam], 2, axis=0)
    beam = np.repeat(beam, 2)
    forth = np.where(np.arange(len(beam)) % 2 == 0, 1.0, -1.0)
    down = np.column_stack(
        [forth[:, None] * along[beam, :2] / run[beam, None], -np.ones(len(beam))]
    )
    reach = np.minimum(tops[:, 2] - beam_mm / 2, _first_hits(tops, down, beam, wires, beam_mm))
    return np.stack([tops, tops + reach[:, None] * down], axis=1)


def _first_hits(
    tops: Floats, down: Floats, own: npt.NDArray[np.int64], wires: Floats, beam_mm: float
) -> Floats:
    """Return how far below its top each strut first meets a beam's axis; infinity for none."""
    found = np.full(len(tops), np.inf)
    begin, along = wires[:, 0], wires[:, 1] - wires[:, 0]
    for strut, (top, way) in enumerate(zip(tops, down, strict=True)):
        depth, distance = _approach(top, way, begin, along)
        meets = (distance < beam_mm / 2) & (depth > beam_mm)
        meets[own[strut]] = False
        if meets.any():
            found[strut] = depth[meets].min()
    return found


def _approach(top: Floats, way: Floats, begin: Floats, along: Floats) -> tuple[Floats, Floats]:
    """Return how far along a ray each segment is nearest to it, and how near.

    The two closest points of lines p + s·u and q + t·v solve a 2 × 2 system; t is then clamped to
    the segment, and s follows.
    """
    offset = top - begin
    a, b, c = way @ way, along @ way, np.einsum("ij,ij->i", along, along)
    d, e = offset @ way, np.einsum("ij,ij->i", along, offset)
    determinant = np.maximum(a * c - b * b, 1e-12)
    t = np.clip((a * e - b * d) / determinant, 0.0, 1.0)
    s = np.maximum((t * b - d) / a, 0.0)
    gap = offset + s[:, None] * way - t[:, None] * along
    return s, np.linalg.norm(gap, axis=1)
