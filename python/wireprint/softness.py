"""Where a print that gives way does so: heights between which lower slabs may help."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Final

import numpy as np

from wireprint.bands import Band, joined
from wireprint.forecast_terms import stiffer
from wireprint.frames import Frame, can_solve, flexibility, shifts_under, strain_energies

if TYPE_CHECKING:
    from collections.abc import Iterable

    import numpy.typing as npt

    from wireprint.forecast import Forecast
    from wireprint.grip import Grip
    from wireprint.settings import Settings
    from wireprint.wire_print import WirePrint

    Array = npt.NDArray[np.float64]

#: What holds a place reaches so far below it and above it, in slabs of the greatest height.
_BELOW: Final = 1.5
_ABOVE: Final = 0.5
#: Heights that hold this share of what bends are told.
_MOST_OF_IT: Final = 0.8
#: Nodes so near to each other are the same one, mm.
_SAME_MM: Final = 1e-6
#: Of the places that a strand meets so many are pulled at: few strands meet more.
_MOST_PLACES: Final = 6
#: Heights are told apart by this share of the greatest slab.
_BIN: Final = 0.5
#: Frames of more nodes are not solved as a whole: some ten seconds of one core.
_MOST_NODES: Final = 60_000


def about_misses(made: WirePrint, forecast: Forecast) -> list[Band]:
    """Return heights about all strands that end on what gives way too far."""
    settings = made.settings
    limit = forecast.rules["meets"].limit or 0.0
    misses = settings.wire.pull_n * np.nan_to_num(forecast.compliance_mm_n) > limit
    heights = forecast.ends_mm[misses, 1, 2].tolist()
    high = settings.slab_max_mm
    return joined((max(0.0, z - _BELOW * high), z + _ABOVE * high) for z in heights)


def that_bends(made: WirePrint, forecast: Forecast) -> list[Band]:
    """Return heights of that which bends where a print gives way farthest.

    Of the energy of the strands that bear a pull at the worst place of ``meets``, as the print
    was when that was met, they hold four fifths. Empty where there is no scipy, or too much to
    solve.
    """
    settings = made.settings
    worst = forecast.rules["meets"]
    if worst.line is None or not can_solve():
        return []
    whole = Frame.of(made.gcode, settings)
    before = whole.only((whole.lines < worst.line) & ~whole.on_bed[whole.ends].all(axis=1))
    touched = whole.places[np.unique(whole.ends[whole.lines == worst.line])]
    if not len(before.ends) or not len(touched):
        return []
    met = _softest(before, touched[:_MOST_PLACES], settings)
    if met is None:
        return []
    middles, energies = met
    return _holding(middles, energies, _BIN * settings.slab_max_mm)


def _softest(before: Frame, touched: Array, settings: Settings) -> tuple[Array, Array] | None:
    """Pull at the softest of some places: heights of beams, and the energy that each holds.

    None where nothing of it was there before, or nothing that stands on the bed.
    """
    found, most = None, 0.0
    for place in touched:
        if np.linalg.norm(before.places - place, axis=1).min() > _SAME_MM:
            continue
        frame = before.about(place)
        if not frame.on_bed.any() or len(frame.places) > _MOST_NODES:
            continue
        modulus_mpa = settings.material.modulus_mpa * stiffer(settings)
        flexible = flexibility(frame, settings.strand_mm, modulus_mpa)
        pulled = int(np.argmin(np.linalg.norm(frame.places - place, axis=1)))
        loads = np.zeros((3, *frame.places.shape))
        loads[:, pulled] = np.eye(3)
        shifts = np.array(shifts_under(frame, flexible, frame.on_bed, list(loads)))
        gives, directions = np.linalg.eigh(shifts[:, pulled, :3])
        if gives[-1] > most:
            most = float(gives[-1])
            energies = strain_energies(frame, flexible, np.tensordot(directions[:, -1], shifts, 1))
            found = frame.places[frame.ends].mean(axis=1)[:, 2], energies
    return found


def about_fingers(made: WirePrint, forecast: Forecast, grip: Grip) -> list[Band]:
    """Return heights about two fingers, and about what is strained most between them."""
    high = made.settings.slab_max_mm
    middle = float(forecast.ends_mm[:, 1, 2].max(initial=0.0)) / 2
    at = [middle, grip.place_mm[2]]
    return joined((max(0.0, z - 2 * _BELOW * high), z + 2 * _BELOW * high) for z in at)


def _holding(heights: Array, energies: Array, step: float) -> list[Band]:
    """Return the heights that hold most of an energy, by steps of a height."""
    steps = np.floor(heights / step).astype(np.int64)
    sums = np.bincount(steps - steps.min(), energies)
    order = np.argsort(-sums, kind="stable")
    count = int(np.searchsorted(np.cumsum(sums[order]), _MOST_OF_IT * sums.sum())) + 1
    lows = (order[:count] + steps.min()) * step
    return joined((max(0.0, low - step), low + 2 * step) for low in lows.tolist())


def share_of(bands: Iterable[Band], top: float) -> float:
    """Return how much of a print of a height lies within bands."""
    covered = math.fsum(max(0.0, min(high, top) - low) for low, high in joined(bands))
    return covered / top if top > 0 else 1.0
