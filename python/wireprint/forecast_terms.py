"""What a forecast is made from: a strand of a material, its air, and what was calibrated."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Final

from wireprint import _core
from wireprint.calibration.bending import of_strand

if TYPE_CHECKING:
    from wireprint.settings import Settings

#: An uncalibrated figure may be so many times as large, or as small: air speed, viscosity and draw
#: are known within about that.
SPREAD: Final = 2.0
#: Standard deviations of a calibration that a figure is told within.
_DEVIATIONS: Final = 2.0
#: Floating-point operations after which the growing frame is not judged: some 50 s of one core.
MOST_WORK: Final = 1e12


def calibrated_spread(name: str, settings: Settings) -> float | None:
    """Return the spread of a rule's figure as a factor; None for one that was not calibrated."""
    known = settings.calibrated_by()
    if known is None:
        return None
    if name == "holds":
        return 1 + _DEVIATIONS * known.pause_spread_s / known.pause_s
    if name == "grips" and known.bending_n_mm2 is not None:
        return 1 + _DEVIATIONS * known.bending_spread_n_mm2 / known.bending_n_mm2
    if name == "sags" and known.sags:
        return 1 + _DEVIATIONS * max(one.spread_mm / one.sag_mm for one in known.sags)
    return None


def stiffer(settings: Settings) -> float:
    """Return by how much stiffer strands bend than diameter and modulus say, as a mast told."""
    known = settings.calibrated_by()
    if known is None or known.bending_n_mm2 is None:
        return 1.0
    return known.bending_n_mm2 / of_strand(settings.strand_mm, settings.material.modulus_mpa)


def air_mm_s(settings: Settings) -> float:
    """Return the speed of the air where all of it blows, mm/s."""
    cooling = settings.printer.cooling
    speed: float = getattr(cooling.air_mm_s, cooling.method)
    return speed


def terms_of(settings: Settings) -> dict[str, Any]:
    """Return what the core forecasts with."""
    printer, material = settings.printer, settings.material
    matter = material.matter(settings.strand_mm)
    known = settings.calibrated_by()
    spread, faster, farther = calibrated_spread("holds", settings) or SPREAD, 1.0, []
    if known is not None:
        faster = settings.solidify_s / known.pause_s
        lengths = [one.length_mm for one in known.sags]
        modelled = _core.sags(matter, air_mm_s(settings), known.print_mm_s, lengths)
        farther = [
            {"length_mm": one.length_mm, "share": one.sag_mm / sag}
            for one, sag in zip(known.sags, modelled, strict=True)
        ]
    return matter | {
        "air_switch": _switch(settings),
        "air_mm_s": air_mm_s(settings),
        "pull_n": settings.wire.pull_n,
        "pressure_lag_s": printer.extruder.pressure_lag_s,
        "most_work": MOST_WORK,
        "sets_faster": (faster / spread, faster, faster * spread),
        "stiffer": stiffer(settings),
        "sags_farther": farther,
    }


def _switch(settings: Settings) -> str | dict[str, Any]:
    cooling = settings.printer.cooling
    if cooling.method != "valve":
        return cooling.method
    return {"valve": {"pin": cooling.valve_pin, "output": cooling.valve_output}}
