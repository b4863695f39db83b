"""The calibration prints: which there are, and that each is certified and quick."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Final, Literal

import numpy as np

from wireprint import certificate
from wireprint._core import SettingError
from wireprint.calibration import mast, sphere, tents
from wireprint.heads.gauge_path import Path
from wireprint.timing import estimate
from wireprint.whole_file import to_gcode

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator

    from wireprint._core import Toolpath
    from wireprint.settings import Settings

Print = Literal["ladder", "harp", "mast", "sphere"]
#: A print takes no longer than this, s.
LONGEST_S: Final = 600.0


@dataclass(frozen=True)
class Printed:
    """A calibration print, and what to do with it."""

    gcode: bytes
    #: What to measure, with what, and how to answer; a line each.
    words: tuple[str, ...]
    #: How long it takes, s.
    takes_s: float


def printed(name: Print, settings: Settings) -> Printed:
    """Return a calibration print, certified.

    Raises
    ------
    SettingError
        It does not fit the bed, the head cannot print it, or it takes too long.
    """
    words = _WORDS[name](settings)
    refused, way_out = "", _WAYS_OUT[name]
    for path in _drawn(name, settings):
        text = to_gcode(path, settings, remarks=[f"calibration: {name}", *words])
        found = certificate.check(text, settings)
        takes_s = estimate(text).total_s
        if found.ok and takes_s < LONGEST_S:
            return Printed(text, words, takes_s)
        width, depth = np.ptp(np.array(path.to)[:, :2], axis=0).tolist()
        broken = {rule: all_[0] for rule, all_ in found.breaches().items() if all_}
        breach = next(iter(broken.values()), found.remarks)
        if _OUTSIDE in broken:
            way_out = _OTHER_BED
        why = str(breach) if not found.ok else f"it takes {takes_s / 60:.0f} min"
        refused = f"{width:.0f} × {depth:.0f} mm: {why}"
    raise SettingError(f"no {name} is certified for {settings.printer.name}, {refused}; {way_out}")


def _drawn(name: Print, settings: Settings) -> Iterator[Toolpath]:
    """Return the moves, the most telling first."""
    if name == "sphere":
        for slabs in sphere.RADII:
            yield sphere.spheres(settings, slabs)
        return
    path = Path(settings)
    _LAID[name](path)
    path.go((*path.at[:2], path.top + settings.wire.travel_lift_mm), prints=False)
    yield path.toolpath()


_LAID: Final[dict[str, Callable[[Path], None]]] = {
    "ladder": tents.ladder,
    "harp": tents.harp,
    "mast": mast.mast,
}
_WORDS: Final = {
    "ladder": tents.ladder_words,
    "harp": tents.harp_words,
    "mast": mast.mast_words,
    "sphere": sphere.sphere_words,
}
#: The certificate's rule that a print breaks which is wider than its bed, and what helps then.
_OUTSIDE: Final = "out_of_bounds"
_OTHER_BED: Final = "it asks for a larger bed, or a higher one"
_WAYS_OUT: Final = {
    "ladder": "a flatter tent may do: --slab-max 3",
    "harp": "a flatter tent may do: --slab-max 3",
    "mast": "a flatter one may do: --slab-max 3",
    "sphere": "lower ones may do: --slab-max 3; a ladder tells the pause, too",
}
