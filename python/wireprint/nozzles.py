"""What another nozzle changes about a printer."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any, Final

from wireprint._core import SettingError

if TYPE_CHECKING:
    from wireprint.toml import Key

#: Sizes that are made, mm: from watchmakers' to concrete-like ones.
SMALLEST_MM: Final = 0.1
LARGEST_MM: Final = 2.0
#: Power of the opening with which the flow lags less. PrusaSlicer tells the MK4's M572 0.036 s for
#: 0.4 mm, 0.020 s for 0.6 mm and 0.014 s for 0.8 mm: 1.4.
_LAG_POWER: Final = 1.4


def changed(printer: Any, nozzle_mm: float) -> dict[Key, float]:
    """Return the figures of a printer that differ with another nozzle in the same hot end.

    Parameters
    ----------
    printer
        The printer's tables, before they are validated.
    nozzle_mm
        Diameter of the opening, mm.

    Raises
    ------
    SettingError
        No nozzle is that wide.

    Notes
    -----
    The land around the opening keeps its width, so the tip grows with it; the flank's angle stays
    (E3D's drawings of the V6's nozzles). What the hot end melts stays, too: PrusaSlicer allows PLA
    15 mm³/s at 0.4, 0.6 and 0.8 mm. A narrower opening lets less of it through; that it does so in
    proportion is an estimate.
    """
    if not (math.isfinite(nozzle_mm) and SMALLEST_MM <= nozzle_mm <= LARGEST_MM):
        msg = f"--nozzle {nozzle_mm:g}: it must lie within {SMALLEST_MM:g}–{LARGEST_MM:g} mm"
        raise SettingError(msg)
    head, extruder = _table(printer, "head"), _table(printer, "extruder")
    old_mm = _number(head, "nozzle_mm")
    if old_mm is None:
        return {("head", "nozzle_mm"): nozzle_mm}
    found: dict[Key, float] = {("head", "nozzle_mm"): nozzle_mm}
    if (tip_mm := _number(head, "tip_radius_mm")) is not None:
        found["head", "tip_radius_mm"] = _rounded(tip_mm + (nozzle_mm - old_mm) / 2)
    if (flow := _number(extruder, "max_flow_mm3_s")) is not None:
        found["extruder", "max_flow_mm3_s"] = _rounded(flow * min(1.0, nozzle_mm / old_mm))
    if lag_s := _number(extruder, "pressure_lag_s"):
        found["extruder", "pressure_lag_s"] = _rounded(lag_s * (old_mm / nozzle_mm) ** _LAG_POWER)
    return found


def _table(printer: Any, name: str) -> Any:
    return printer.get(name) if isinstance(printer, dict) else None


def _number(table: Any, key: str) -> float | None:
    """Return a figure that is one; anything else is left for validation to refuse."""
    value = table.get(key) if isinstance(table, dict) else None
    if not isinstance(value, int | float) or isinstance(value, bool):
        return None
    return float(value) if 0 < value < math.inf else None


def _rounded(value: float) -> float:
    return round(value, 4)
