"""What a G-code text tells of its strands: when they are laid, in which layer, on which printer."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from wireprint.timing import estimate
from wireprint.view_texels import slabs_of, times_of

if TYPE_CHECKING:
    import numpy.typing as npt

    from wireprint.settings import Settings
    from wireprint.view_texels import Floats


@dataclass(frozen=True)
class Replay:
    """Strands in time; arrays have one entry for each."""

    #: When each is begun and done, s.
    begin_s: Floats
    end_s: Floats
    #: Slab of each, from 0.
    slabs: npt.NDArray[np.uint16]
    #: How long all takes, s, without heating and homing.
    total_s: float
    #: Whether these are times; else each strand counts as a second.
    timed: bool
    #: Time, filament, weight and cost, as the page calls them.
    figures: dict[str, float]
    #: Of the printer, if it is known.
    settings: Settings | None


def replay(gcode: bytes, lines: npt.NDArray[np.uint64]) -> Replay:
    """Time the strands of a text by the planner of the printer that it is for.

    Parameters
    ----------
    gcode
        Any program's.
    lines
        Line of each strand, from 1, in order.
    """
    planned = estimate(gcode, per_move=True)
    rows = planned.per_move
    assert rows is not None, "rows were asked for"  # noqa: S101
    at = lines.astype(np.int64)
    begin_s, end_s = times_of(rows.line, rows.duration_s, at)
    figures = {
        "print_time_s": planned.total_s,
        "filament_mm": planned.filament_mm,
        "filament_g": planned.filament_g,
        "filament_cost": planned.filament_cost,
    }
    slabs = slabs_of(gcode, at)
    return Replay(begin_s, end_s, slabs, planned.total_s, True, figures, _settings_of(gcode))


def untimed(count: int) -> Replay:
    """Return strands of which nothing but their order is known."""
    order = np.arange(count, dtype=np.float64)
    slabs = np.zeros(count, np.uint16)
    return Replay(order, order + 1, slabs, float(count), False, {}, None)


def told_of(settings: Settings) -> dict[str, Any]:
    """Return bed and head of a printer as the page is told them."""
    bed, head = settings.printer.bed, settings.printer.head
    return {
        "bed": {"round": bed.shape == "round", "size_mm": bed.size_mm, "high": bed.height_mm},
        "head": head.model_dump(mode="json"),
    }


def _settings_of(gcode: bytes) -> Settings | None:
    """Return the settings of a text, or of the printer that it names; None if it names none."""
    from wireprint.claims import allowed
    from wireprint.gcode.origin import known_printer
    from wireprint.gcode.own_settings import settings_in
    from wireprint.settings import Settings

    own = settings_in(gcode)
    if own is not None:
        return allowed(own)[0]
    known = known_printer(gcode)
    return None if known is None else Settings.load(known[0])
