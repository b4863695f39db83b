"""Stages 2 to 5: a mesh becomes slices, contours and strands, and these become moves."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

from wireprint import _core
from wireprint.gcode.flavors import FLAVORS

if TYPE_CHECKING:
    from wireprint._core import Mesh, Toolpath, Wireframe, _Layered
    from wireprint.settings import Settings


def wireframe(mesh: Mesh, settings: Settings, layered: _Layered | None = None) -> Wireframe:
    """Slice a mesh and lay its strands.

    Parameters
    ----------
    mesh
        The model, placed: its lowest point at z = 0.
    settings
        Printer, material and way of wiring.
    layered
        What of it is printed as layers, see `hybrid.plan`.

    Returns
    -------
    Wireframe
        Slices, contours, strips, posts and strands, all reachable as numpy arrays.

    Raises
    ------
    ModelError
        Where no slice has a contour.
    """
    head, wire = settings.printer.head, settings.wire
    return _core.wireframe(
        mesh,
        {
            "tip_radius_mm": head.tip_radius_mm,
            "slant_deg": head.slant_deg,
            "cone_height_mm": head.cone_height_mm,
            "block_radius_mm": head.block_radius_mm,
            "carriage_height_mm": head.carriage_height_mm,
            "carriage_radius_mm": head.carriage_radius_mm,
        },
        {
            "strand_mm": head.nozzle_mm,
            "slab_min_mm": settings.slab_min_mm,
            "slab_max_mm": settings.slab_max_mm,
            "first_layer_height_mm": settings.first_layer_height_mm,
            "deviation_target_mm": wire.deviation_target_mm,
            "print_mm_s": settings.print_mm_s,
            "pause_s": settings.pause_s,
            "pattern": wire.pattern,
            "placement": wire.placement,
            "caps": wire.caps,
            "supports": wire.supports == "wire",
            "cap_spacing_mm": wire.cap_spacing_mm,
            "span_limit_mm": wire.span_limit_mm,
            "free_end_limit_mm": wire.free_end_limit_mm,
        },
        layered,
    )


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
    printer, wire, regions = settings.printer, settings.wire, settings.regions
    width, depth = printer.bed.size_mm
    flavor = FLAVORS[printer.gcode.flavor]
    return _core.toolpath(
        wireframe,
        {
            "centre_mm": printer.bed.centre_mm,
            "bed_half_mm": (width / 2, depth / 2),
            "bed_round": printer.bed.shape == "round",
            "strand_mm": printer.head.nozzle_mm,
            "filament_diameter_mm": printer.extruder.filament_diameter_mm,
            "first_layer_height_mm": settings.first_layer_height_mm,
            "print_mm_s": settings.print_mm_s,
            "first_layer_mm_s": settings.first_layer_mm_s,
            "layer_mm_s": min(regions.print_mm_s, _melting_mm_s(settings)),
            "slow_mm_s": wire.slow_mm_s,
            "travel_mm_s": printer.speeds.travel_mm_s,
            "strategy": wire.strategy,
            "cooling": printer.cooling.method,
            "valve_halts": flavor.valve_halts,
            "pause_s": settings.pause_s,
            "overshoot_mm": wire.overshoot_mm,
            "pressure_lag_s": printer.extruder.pressure_lag_s,
            "pressure_advance": flavor.pressure_advance(printer.gcode),
            "retract_mm": printer.extruder.retract_mm,
            "layer_retract_over_mm": regions.retract_over_mm,
            "retract_speed_mm_s": printer.extruder.retract_speed_mm_s,
            "unretract_speed_mm_s": printer.extruder.unretract_speed_mm_s,
            "prime_mm": wire.prime_mm,
            "travel_lift_mm": wire.travel_lift_mm,
            "skirt_rings": wire.skirt_rings,
            "skirt_gap_mm": wire.skirt_gap_mm,
            "brim_rings": wire.brim_rings,
        },
    )


def _melting_mm_s(settings: Settings) -> float:
    """Speed at which the lines of regions take all that the hot end melts, mm/s."""
    regions, printer = settings.regions, settings.printer
    width = regions.width_ratio * printer.head.nozzle_mm
    melts = regions.max_flow_mm3_s or printer.extruder.max_flow_mm3_s
    return melts / line_section_mm2(width, regions.layer_height_mm)


def line_section_mm2(width_mm: float, layer_mm: float) -> float:
    """Cross-section of a layer's line: a rectangle between two half circles.

    Notes
    -----
    manual.slic3r.org, "Flow math".
    """
    return layer_mm * (width_mm - layer_mm * (1 - math.pi / 4))
