"""Stage 5: strands become moves, with speeds, filament, pauses and air."""

from __future__ import annotations

from typing import TYPE_CHECKING

from wireprint import _core

if TYPE_CHECKING:
    from wireprint._core import Toolpath, Wireframe
    from wireprint.settings import Settings


def toolpath(wireframe: Wireframe, settings: Settings) -> Toolpath:
    """Plan every move of the head.

    Parameters
    ----------
    wireframe
        Strands in printing order.
    settings
        The settings that the wireframe was made with.

    Returns
    -------
    Toolpath
        Moves as parallel numpy arrays, in the machine's coordinates.
    """
    printer, wire = settings.printer, settings.wire
    return _core.toolpath(
        wireframe,
        {
            "centre_mm": printer.bed.centre_mm,
            "strand_mm": printer.head.nozzle_mm,
            "filament_diameter_mm": printer.extruder.filament_diameter_mm,
            "first_layer_height_mm": settings.first_layer_height_mm,
            "print_mm_s": printer.speeds.print_mm_s,
            "first_layer_mm_s": printer.speeds.first_layer_mm_s,
            "slow_mm_s": wire.slow_mm_s,
            "travel_mm_s": printer.speeds.travel_mm_s,
            "strategy": wire.strategy,
            "cooling": printer.cooling.method,
            "pause_s": settings.pause_s,
            "overshoot_mm": wire.overshoot_mm,
            "retract_mm": printer.extruder.retract_mm,
            "retract_speed_mm_s": printer.extruder.retract_speed_mm_s,
            "unretract_speed_mm_s": printer.extruder.unretract_speed_mm_s,
            "prime_mm": wire.prime_mm,
            "travel_lift_mm": wire.travel_lift_mm,
            "skirt_rings": wire.skirt_rings,
            "skirt_gap_mm": wire.skirt_gap_mm,
            "brim_rings": wire.brim_rings,
        },
    )
