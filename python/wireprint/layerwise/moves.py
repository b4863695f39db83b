"""A route becomes moves: travels, retractions, strands."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from wireprint import _core
from wireprint.gcode.flavors import KINDS

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
    """Return the moves that print the lines of a route, one layer upon the other."""
    sizes = np.diff(route.offsets)
    line = np.repeat(np.arange(len(sizes)), sizes + len(_APPROACH) - 1)
    starts = np.concatenate([[0], np.cumsum(sizes + len(_APPROACH) - 1)])
    step = np.arange(len(line)) - starts[line]
    point = route.offsets[line] + np.maximum(step - len(_APPROACH) + 1, 0)
    kind = np.array([*_APPROACH, _LAYERWISE])[np.minimum(step, len(_APPROACH))]
    z = (route.layer + 1) * rates.layer_mm
    to = np.column_stack([route.points[point] + rates.centre_mm, z[line]])
    lifts = step < 2
    to[lifts, :2] = _last_points(route, rates)[line[lifts]]
    to[step == 0, 2] = np.concatenate([z[:1], z[:-1]])
    lengths = np.linalg.norm(to - np.vstack([to[:1], to[:-1]]), axis=1)
    travels = np.hypot(*(to[step == 2, :2] - to[step == 1, :2]).T)
    rises = np.diff(z, prepend=z[0]) > 0
    pulls = ((travels > rates.retract_over_mm) | rises) & (np.arange(len(sizes)) > 0)
    keep = np.ones(len(line), dtype=bool)
    keep[np.isin(step, (0, 3))] = np.repeat(pulls, 2)
    keep[step == 1] = rises
    keep[step == 2] = (travels > 0) | (np.arange(len(sizes)) == 0)
    return _core.Toolpath.from_arrays(
        start=(*to[0, :2].tolist(), float(to[0, 2])),
        to=np.ascontiguousarray(to[keep]),
        kind=kind[keep].astype(np.uint8),
        speed=_speeds(kind, route.layer[line], rates)[keep],
        filament=_filament(kind, lengths, rates)[keep],
        pause=np.zeros(np.count_nonzero(keep)),
        air=np.zeros(np.count_nonzero(keep), dtype=bool),
        slab=route.layer[line][keep].astype(np.uint32),
    )


def _last_points(route: Route, rates: Rates) -> npt.NDArray[np.float64]:
    """Return where the tip is before each line: at the end of the last one."""
    ends = route.points[route.offsets[1:] - 1] + rates.centre_mm
    return np.vstack([route.points[:1] + rates.centre_mm, ends[:-1]])


def _speeds(
    kind: npt.NDArray[np.int64], layer: npt.NDArray[np.int64], rates: Rates
) -> npt.NDArray[np.float64]:
    by_kind = np.zeros(len(KINDS))
    by_kind[_TRAVEL], by_kind[_LAYERWISE] = rates.travel_mm_s, rates.print_mm_s
    by_kind[_RETRACT], by_kind[_UNRETRACT] = rates.retract_mm_s, rates.unretract_mm_s
    on_bed = (kind == _LAYERWISE) & (layer == 0)
    return np.where(on_bed, rates.first_layer_mm_s, by_kind[kind])


def _filament(
    kind: npt.NDArray[np.int64], lengths: npt.NDArray[np.float64], rates: Rates
) -> npt.NDArray[np.float64]:
    by_kind = np.zeros(len(KINDS))
    by_kind[_RETRACT], by_kind[_UNRETRACT] = -rates.retract_mm, rates.retract_mm
    return by_kind[kind] + np.where(kind == _LAYERWISE, lengths * rates.filament_per_mm, 0.0)
