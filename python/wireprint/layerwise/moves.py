"""A route becomes moves: travels, retractions, strands."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from wireprint import _core
from wireprint._core import KINDS

if TYPE_CHECKING:
    import numpy.typing as npt

    from wireprint._core import Toolpath
    from wireprint.layerwise.route import Route

_TRAVEL, _LAYERWISE = KINDS.index("travel"), KINDS.index("layer-wise")
_RETRACT, _UNRETRACT = KINDS.index("retract"), KINDS.index("unretract")
#: Moves that lead to a line: retract, lift, travel, unretract.
_APPROACH = (_RETRACT, _TRAVEL, _TRAVEL, _UNRETRACT)


@dataclass(frozen=True)
class Rates:
    """How the machine prints layers."""

    layer_mm: float
    #: Filament for each mm of a line, mm.
    filament_per_mm: float
    print_mm_s: float
    first_layer_mm_s: float
    travel_mm_s: float
    retract_mm: float
    retract_mm_s: float
    unretract_mm_s: float
    #: Shorter travels are made without pulling back, mm.
    retract_over_mm: float
    centre_mm: tuple[float, float]


def toolpath(route: Route, rates: Rates) -> Toolpath:
    """Return the moves that print the lines of a route.

    Parameters
    ----------
    route
        Lines in printing order.
    rates
        How the machine prints.
    """
    sizes = np.diff(route.offsets)
    line = np.repeat(np.arange(len(sizes)), sizes + len(_APPROACH) - 1)
    begins = np.cumsum(sizes + len(_APPROACH) - 1) - (sizes + len(_APPROACH) - 1)
    step = np.arange(len(line)) - begins[line]
    point = route.offsets[line] + np.maximum(step - len(_APPROACH) + 1, 0)
    kind = np.array([*_APPROACH, _LAYERWISE])[np.minimum(step, len(_APPROACH))]
    points = route.points + np.array([*rates.centre_mm, 0.0])
    to = points[point]
    firsts = points[route.offsets[:-1]]
    lasts = np.vstack([firsts[:1], points[route.offsets[1:-1] - 1]])
    # The tip is drawn up where it stands, and only then travels.
    to[step == 0] = lasts
    to[step == 1, :2] = lasts[:, :2]
    keep = _needed(step, firsts - lasts, rates.retract_over_mm)
    layer = route.layer[point]
    return _core.Toolpath.from_arrays(
        start=(*firsts[0].tolist(),),
        to=np.ascontiguousarray(to[keep]),
        kind=kind[keep].astype(np.uint8),
        speed=_speeds(kind, layer, rates)[keep],
        filament=_filament(kind, to, rates)[keep],
        pause=np.zeros(np.count_nonzero(keep)),
        air=np.zeros(np.count_nonzero(keep), dtype=bool),
        slab=layer[keep].astype(np.uint32),
    )


def _needed(
    step: npt.NDArray[np.int64], ways: npt.NDArray[np.float64], retract_over_mm: float
) -> npt.NDArray[np.bool_]:
    """Tell which moves are made: short travels do without some, the first without most."""
    travels, rises = np.hypot(ways[:, 0], ways[:, 1]), ways[:, 2] > 0
    pulls = (travels > retract_over_mm) | rises
    begins = np.arange(len(ways)) == 0
    keep = np.ones(len(step), dtype=bool)
    keep[step == 0] = keep[step == 3] = pulls
    keep[step == 1] = rises
    keep[step == 2] = (travels > 0) | begins
    return keep


def _speeds(
    kind: npt.NDArray[np.int64], layer: npt.NDArray[np.int64], rates: Rates
) -> npt.NDArray[np.float64]:
    by_kind = np.zeros(len(KINDS))
    by_kind[_TRAVEL], by_kind[_LAYERWISE] = rates.travel_mm_s, rates.print_mm_s
    by_kind[_RETRACT], by_kind[_UNRETRACT] = rates.retract_mm_s, rates.unretract_mm_s
    on_bed = (kind == _LAYERWISE) & (layer == 0)
    return np.where(on_bed, rates.first_layer_mm_s, by_kind[kind])


def _filament(
    kind: npt.NDArray[np.int64], to: npt.NDArray[np.float64], rates: Rates
) -> npt.NDArray[np.float64]:
    lengths = np.linalg.norm(np.diff(to, axis=0, prepend=to[:1]), axis=1)
    by_kind = np.zeros(len(KINDS))
    by_kind[_RETRACT], by_kind[_UNRETRACT] = -rates.retract_mm, rates.retract_mm
    return by_kind[kind] + np.where(kind == _LAYERWISE, lengths * rates.filament_per_mm, 0.0)
