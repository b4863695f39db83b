"""Strands as the page draws them: a texel of 16 bytes each, with times and slabs."""

from __future__ import annotations

import re
from typing import TYPE_CHECKING, Any, Final

import numpy as np

if TYPE_CHECKING:
    import numpy.typing as npt

    Floats = npt.NDArray[np.float64]
    Integers = npt.NDArray[np.int64]

#: Coordinates are sent as this many steps over the extent of all: 3 µm on 200 mm.
STEPS: Final = 65535
#: Diameters are sent as multiples of this, mm; a byte holds the thickest that is drawn.
DIAMETER_STEP_MM: Final = 0.02
#: The page knows this many kinds of strands; others are shown as the last one.
MOST_KINDS: Final = 64
#: The bit of a strand's kind that says that it breaks a rule.
BREACH_BIT: Final = 0x80
#: Where programs begin a layer: PrusaSlicer and ours; Bambu Studio and OrcaSlicer; Cura.
_LAYER: Final = re.compile(rb"^;(?:LAYER_CHANGE|[ \t]*CHANGE_LAYER|LAYER:-?\d+)[ \t\r]*$", re.M)


def box_of(ends: Floats) -> tuple[Floats, Floats]:
    """Return the lowest corner of strands and their extent, mm, which is nowhere nothing.

    Parameters
    ----------
    ends
        Start and end of each, (N, 2, 3), mm.
    """
    points = ends.reshape(-1, 3)
    low = points.min(axis=0)
    return low, np.maximum(points.max(axis=0) - low, 1e-6)


def packed(
    ends: Floats,
    low: Floats,
    span: Floats,
    kinds: npt.NDArray[np.integer[Any]],
    diameters_mm: Floats,
    slabs: npt.NDArray[np.integer[Any]],
) -> npt.NDArray[np.uint32]:
    """Return the texels.

    Parameters
    ----------
    ends
        Start and end of each strand, (N, 2, 3), mm.
    low, span
        What coordinates are steps of; see `box_of`.
    kinds
        What each is for (N,), with `BREACH_BIT` where it breaks a rule.
    diameters_mm
        Of each, (N,).
    slabs
        Slab of each, from 0, (N,).

    Returns
    -------
    ndarray
        (N, 4) uint32: from and to as six uint16, kind and diameter as bytes, slab as uint16.
    """
    found = np.zeros(
        len(ends), [("ends", "<u2", (2, 3)), ("kind", "u1"), ("diameter", "u1"), ("slab", "<u2")]
    )
    found["ends"] = np.rint((ends - low) / span * STEPS)
    found["kind"] = kinds
    found["diameter"] = np.clip(np.rint(diameters_mm / DIAMETER_STEP_MM), 1, 255)
    found["slab"] = slabs
    return found.view("<u4").reshape(-1, 4)


def times_of(
    rows: npt.NDArray[np.uint64], durations_s: Floats, lines: Integers
) -> tuple[Floats, Floats]:
    """Return when each strand is begun and done, s.

    Parameters
    ----------
    rows, durations_s
        Line and time of each move, as the planner tells them, in order.
    lines
        Line of each strand, in order. Those of one line, the chords of an arc, share its time.
    """
    done = np.cumsum(durations_s)
    numbers = rows.astype(np.int64)
    first = np.minimum(np.searchsorted(numbers, lines), len(numbers) - 1)
    last = np.maximum(np.searchsorted(numbers, lines, side="right") - 1, first)
    begin, end = done[first] - durations_s[first], done[last]
    # Which of the strands of its line each is, and of how many.
    opens = np.searchsorted(lines, lines)
    count = np.searchsorted(lines, lines, side="right") - opens
    which = np.arange(len(lines)) - opens
    each = (end - begin) / np.maximum(count, 1)
    return begin + which * each, begin + (which + 1) * each


def slabs_of(gcode: bytes, lines: Integers) -> npt.NDArray[np.uint16]:
    """Return the slab of each strand, from 0: how many layers begin before its line, less one."""
    breaks = np.flatnonzero(np.frombuffer(gcode, np.uint8) == ord("\n"))
    begins = [match.start() for match in _LAYER.finditer(gcode)]
    numbers = np.searchsorted(breaks, begins) + 1
    found = np.searchsorted(numbers, lines) - 1
    return np.clip(found, 0, STEPS).astype(np.uint16)


def heights_of(ends: Floats, slabs: npt.NDArray[np.uint16]) -> list[float]:
    """Return the height up to which each slab and those below reach, mm."""
    tops = np.full(int(slabs.max(initial=0)) + 1, -np.inf)
    np.maximum.at(tops, slabs, ends[:, :, 2].max(axis=1))
    low = float(ends[:, :, 2].min(initial=np.inf))
    heights: list[float] = np.maximum.accumulate(np.maximum(tops, low)).round(3).tolist()
    return heights
