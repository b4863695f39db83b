"""Strands as solid bodies that any slicer reads: closed tubes as thick as what is extruded."""

from __future__ import annotations

import struct
from typing import TYPE_CHECKING, Final

import numpy as np

from wireprint._core import SettingError
from wireprint.fidelity import ASIDE

if TYPE_CHECKING:
    from collections.abc import Sequence

    import numpy.typing as npt

    from wireprint.certificate import Certificate

    Floats = npt.NDArray[np.float64]
    Ints = npt.NDArray[np.int64]

#: Corners of a tube's section, unless said otherwise: an octagon's area is a tenth off a circle's,
#: which its radius makes up for.
SIDES: Final = 8
#: Fewer make no section.
LEAST_SIDES: Final = 3
#: Labels of what is no part of the object; supports are.
LEFT_OUT: Final = ASIDE - {"support"}
#: Shorter strands are dots, whose direction means nothing, in diameters.
_DOT: Final = 1e-3


def tubes(strands: Floats, diameter_mm: float, sides: int = SIDES) -> tuple[Floats, Ints]:
    """Return strands as closed tubes that end in points beyond their strands' ends.

    Tubes that share an end overlap there, each a body of its own: slicers print what any of
    several bodies covers once.

    Parameters
    ----------
    strands
        Ends of the strands, mm, shape (N, 2, 3).
    diameter_mm
        Diameter of a round strand; a tube's section has the same area.
    sides
        Corners of the section.

    Returns
    -------
    vertices : ndarray
        Shape (N · (2 · sides + 2), 3), mm.
    faces : ndarray
        Shape (N · 4 · sides, 3), counter-clockwise from outside.

    Raises
    ------
    SettingError
        There are too few sides.
    """
    if sides < LEAST_SIDES:
        raise SettingError(f"a tube has {LEAST_SIDES} sides at least, not {sides}")
    begin, end = strands[:, 0], strands[:, 1]
    run = end - begin
    length = np.linalg.norm(run, axis=1)
    kept = length > _DOT * diameter_mm
    begin, end, run = begin[kept], end[kept], run[kept] / length[kept, None]
    # The axis that the strand leans against least makes the frame's other two with it.
    least = np.eye(3)[np.abs(run).argmin(axis=1)]
    side = np.cross(run, least)
    side /= np.linalg.norm(side, axis=1)[:, None]
    up = np.cross(run, side)
    turn = 2 * np.pi * np.arange(sides) / sides
    # A polygon of as much area as the circle.
    radius = diameter_mm / 2 * np.sqrt(2 * np.pi / (sides * np.sin(2 * np.pi / sides)))
    ring = radius * (
        np.cos(turn)[:, None] * side[:, None, :] + np.sin(turn)[:, None] * up[:, None, :]
    )
    tip = diameter_mm / 2 * run
    vertices = np.concatenate(
        [
            begin[:, None] + ring,
            end[:, None] + ring,
            (begin - tip)[:, None],
            (end + tip)[:, None],
        ],
        axis=1,
    )
    here = np.arange(sides)
    after = (here + 1) % sides
    first, last = np.full(sides, 2 * sides), np.full(sides, 2 * sides + 1)
    one = np.concatenate(
        [
            np.column_stack(corners)
            for corners in (
                (here, after, sides + after),
                (here, sides + after, sides + here),
                (after, here, first),
                (sides + here, sides + after, last),
            )
        ]
    )
    faces = one[None] + (2 * sides + 2) * np.arange(len(vertices))[:, None, None]
    return vertices.reshape(-1, 3), faces.reshape(-1, 3)


def strands_of(certificate: Certificate, only: Sequence[str] = ()) -> tuple[Floats, list[str]]:
    """Return the strands of a print about the middle of the bed, and what they are labelled.

    Parameters
    ----------
    certificate
        The print, judged.
    only
        Labels (`;TYPE:`) that are wanted; none: all but what is no part of the object.

    Returns
    -------
    strands : ndarray
        Ends, mm, shape (N, 2, 3).
    labels : list of str
        Those of the strands, each once.

    Raises
    ------
    SettingError
        Nothing is labelled so.
    """
    core = certificate.core
    features = [name.lower() for name in core.features]
    wanted = {name.lower() for name in only} or set(features) - LEFT_OUT
    numbers = [number for number, name in enumerate(features) if name in wanted]
    mine = np.isin(core.strand_features, numbers)
    used = sorted({features[number] for number in np.unique(core.strand_features)})
    if not mine.any():
        told = ", ".join(name or "(no label)" for name in used)
        raise SettingError(f"nothing that is wanted is printed; what is printed is {told}")
    centre = np.array([*certificate.judge.settings.printer.bed.centre_mm, 0.0])
    return core.strands[mine] - centre, sorted(set(used) & wanted)


def as_stl(vertices: Floats, faces: Ints) -> bytes:
    """Return a body as binary STL."""
    facets = np.zeros(
        len(faces), [("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("rest", "<u2")]
    )
    facets["corners"] = vertices[faces]
    return b"wireprint body".ljust(80) + struct.pack("<I", len(faces)) + facets.tobytes()
