"""A print in the hand: how far two fingers squeeze it, and what its strands bear of that.

The whole print as a frame of straight beams, rigidly joined, loose from the bed, between two pads
at half its height: once along x, once along y. Joints are ideal, so a print gives way at least so
far and bears at most so much: a way to compare prints, no promise.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING, Final

import numpy as np

from wireprint.frames import Frame, flexibility, shifts_under, skew, stresses

if TYPE_CHECKING:
    import numpy.typing as npt

    from wireprint.settings import Settings
    from wireprint.verdict import Point

    Array = npt.NDArray[np.float64]
    Whole = npt.NDArray[np.int64]

#: What two fingers press with where nothing else is said, N.
USUAL_N: Final = 10.0
#: Half of a pad's width and height, and how deep a finger gives, mm.
_PAD_MM: Final = 9.0
_DEEP_MM: Final = 6.0
#: Of all strands this share is strained no more than what is told: the worst one tells of a joint.
_SHARE: Final = 0.99
#: Frames of more nodes are not judged: some ten seconds of one core.
MOST_NODES: Final = 60_000


@dataclass(frozen=True, slots=True)
class Grip:
    """A print between two fingers, along that axis in which it gives way farther."""

    force_n: float
    #: Along what: ``x`` or ``y``.
    along: str
    #: How far the pads come closer, mm.
    squeeze_mm: float
    #: Force at which the strand that is worse off than 99 of 100 is strained to its strength, N.
    bears_n: float
    #: Line and place of the strand that is strained most, and its stress, MPa.
    line: int
    place_mm: Point
    stress_mpa: float
    #: Strands that are strained beyond their strength, and all.
    over: int
    of: int


def grip(gcode: bytes, settings: Settings, force_n: float, stiffer: float = 1.0) -> Grip | None:
    """Press a print between two fingers.

    Parameters
    ----------
    gcode
        The text, of any program.
    settings
        Printer and material.
    force_n
        What each finger presses with, N.
    stiffer
        By how much strands bend less than diameter and modulus say.

    Returns
    -------
    Grip or None
        None where there is nothing between the fingers, or too much.

    Raises
    ------
    NoSolverError
        There is no scipy to solve it with.
    """
    frame = Frame.of(gcode, settings).largest()
    if not 0 < len(frame.places) <= MOST_NODES:
        return None
    modulus = settings.material.modulus_mpa * stiffer
    flexible = flexibility(frame, settings.strand_mm, modulus)
    loads = {axis: _pads(frame.places, number) for number, axis in enumerate("xy")}
    pressed = {axis: load for axis, load in loads.items() if load is not None}
    if not pressed:
        return None
    # One node is held: loads are balanced, so it bears nothing.
    held = np.arange(len(frame.places)) == 0
    shifts = shifts_under(frame, flexible, held, [load for load, _ in pressed.values()])
    found = [
        _grip(frame, flexible, shift, axis, sides, settings, force_n)
        for shift, (axis, (_, sides)) in zip(shifts, pressed.items(), strict=True)
    ]
    return max(found, key=lambda one: one.squeeze_mm)


def _pads(places: Array, axis: int) -> tuple[Array, list[Whole]] | None:
    """Return forces on nodes under two fingers that press with 1 N, (N, 3), and each one's nodes.

    Without a remainder that would push or turn the print as a whole.
    """
    low, high = places.min(axis=0), places.max(axis=0)
    off = places - (low + high) / 2
    near = (abs(off[:, 2]) < _PAD_MM) & (abs(off[:, 1 - axis]) < _PAD_MM)
    sides = []
    for sign in (1, -1):
        side = np.flatnonzero(near & (sign * off[:, axis] > 0))
        if not len(side):
            return None
        depth = sign * off[side, axis]
        sides.append(side[depth > depth.max() - _DEEP_MM])
    forces = np.zeros_like(places)
    for sign, side in zip((1, -1), sides, strict=True):
        forces[side, axis] -= sign / len(side)
    nodes = np.concatenate(sides)
    rigid = np.zeros((len(nodes), 3, 6))
    rigid[:, :, :3] = np.eye(3)
    rigid[:, :, 3:] = -skew(places[nodes] - places[nodes].mean(axis=0))
    flat, own = rigid.reshape(-1, 6), forces[nodes].ravel()
    own = own - flat @ np.linalg.lstsq(flat, own, rcond=None)[0]
    forces[nodes] = own.reshape(-1, 3)
    return forces, sides


def _grip(
    frame: Frame,
    flexible: tuple[Array, Array],
    shifts: Array,
    along: str,
    sides: list[Whole],
    settings: Settings,
    force_n: float,
) -> Grip:
    """Return what shifts under 1 N come to under a force."""
    axis = "xy".index(along)
    near, far = (float(shifts[side, axis].mean()) for side in sides)
    stress, by_beam = stresses(frame, flexible, shifts, settings.strand_mm)
    strength = settings.material.strength_mpa
    told = float(np.quantile(stress, _SHARE)) if len(stress) else 0.0
    worst = int(np.argmax(by_beam))
    middle = frame.places[frame.ends[worst]].mean(axis=0)
    x, y, z = middle.tolist()
    return Grip(
        force_n,
        along,
        force_n * max(0.0, far - near),
        strength / told if told > 0 else math.inf,
        int(frame.lines[worst]),
        (x, y, z),
        force_n * float(by_beam[worst]),
        int(np.count_nonzero(force_n * stress > strength)),
        len(stress),
    )
