"""Stages 2 to 5: a mesh becomes slices, contours and strands, and these become moves.

The core takes what it knows of a section's settings by their own names; here stands only what is
resolved from several.
"""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

from wireprint import _core
from wireprint.gcode.flavors import FLAVORS

if TYPE_CHECKING:
    from wireprint._core import Mesh, Toolpath, Wireframe, _Layered
    from wireprint.settings import Settings
    from wireprint.settings.printer import Printer
    from wireprint.standing import Standing
    from wireprint.verdict import Point


def wireframe(
    mesh: Mesh,
    settings: Settings,
    layered: _Layered | None = None,
    standing: Standing | None = None,
    at_mm: Point = (0.0, 0.0, 0.0),
    plain: Wireframe | None = None,
    *,
    bearing: bool = False,
) -> Wireframe:
    """Slice a mesh and lay its strands.

    Parameters
    ----------
    mesh
        The model, placed: its lowest point at z = 0.
    settings
        Printer, material and way of wiring.
    layered
        What of it is printed as layers, see `hybrid.plan`.
    standing, at_mm
        What stands on the bed already, which the head keeps clear of, and where the model does,
        from the middle of the bed, mm.
    plain
        The same without layers, where it is at hand: with it the print is made sooner, and is the
        same.
    bearing
        Whether what looks down is to bear layers of the model: what closes it is supports, at the
        height where those layers begin.

    Returns
    -------
    Wireframe
        Slices, contours, strips, posts and strands, all reachable as numpy arrays.

    Raises
    ------
    ModelError
        Where no slice has a contour.
    """
    head = settings.printer.head.model_dump()
    wire = settings.wire.model_dump() | _of_wire(settings) | {"bearing": bearing}
    strands = None if standing is None else standing.about(origin_mm(settings, at_mm))
    return _core.wireframe(mesh, head, wire, layered, strands, plain)


def origin_mm(settings: Settings, at_mm: Point) -> Point:
    """Return where a model's x = y = z = 0 lies in the machine's coordinates, mm."""
    x, y = settings.printer.bed.centre_mm
    return x + at_mm[0], y + at_mm[1], at_mm[2]


def _of_wire(settings: Settings) -> dict[str, object]:
    """Return what the wireframe depends on besides the settings of `[wire]` as they stand."""
    times = _times(settings)
    return {
        "strand_mm": settings.strand_mm,
        "slab_min_mm": settings.slab_min_mm,
        "slab_max_mm": settings.slab_max_mm,
        "first_layer_height_mm": settings.first_layer_height_mm,
        "print_mm_s": settings.print_mm_s,
        "pause_s": settings.pause_s,
        "hop_s": times["hop_s"],
        "climb": times["climb"],
        "times": times,
        "supports": settings.wire.supports == "wire",
    }


def toolpath(
    wireframe: Wireframe,
    settings: Settings,
    standing: Standing | None = None,
    at_mm: Point = (0.0, 0.0, 0.0),
) -> Toolpath:
    """Plan every move of the head.

    Parameters
    ----------
    wireframe
        Strands in printing order.
    settings
        The settings that the wireframe was made with.
    standing, at_mm
        See `wireframe`.

    Returns
    -------
    Toolpath
        Moves as parallel numpy arrays, in the machine's coordinates.
    """
    top_mm = 0.0 if standing is None else standing.top_mm
    params = path_params(settings) | {"standing_mm": top_mm - at_mm[2]}
    if standing is not None:
        # A skirt would run into what stands; the nozzle was primed for that.
        params["skirt_rings"] = 0
    path = _core.toolpath(wireframe, params)
    return path if at_mm == (0.0, 0.0, 0.0) else path.moved(at_mm)


def path_params(settings: Settings) -> dict[str, object]:
    """Return what moves depend on, on an empty bed."""
    own = (settings.wire, settings.printer.speeds, settings.printer.extruder)
    given = {name: value for section in own for name, value in section.model_dump().items()}
    return given | _of_path(settings) | {"standing_mm": 0.0}


def _of_path(settings: Settings) -> dict[str, object]:
    """Return what moves depend on besides the settings of the wire, the speeds, the extruder."""
    printer, regions = settings.printer, settings.regions
    flavor, cooling = FLAVORS[printer.gcode.flavor], printer.cooling.method
    half = tuple(size / 2 for size in printer.bed.size_mm)
    halts = cooling == "valve" and flavor.valve_halts
    return {
        "centre_mm": printer.bed.centre_mm,
        "plate": {"round": half[0]} if printer.bed.shape == "round" else {"rectangle": half},
        "strand_mm": settings.strand_mm,
        "first_layer_height_mm": settings.first_layer_height_mm,
        "print_mm_s": settings.print_mm_s,
        "first_layer_mm_s": settings.first_layer_mm_s,
        "layer_mm_s": min(regions.print_mm_s, _melting_mm_s(settings)),
        "cooling": "halting_valve" if halts else cooling,
        "pause_s": settings.pause_s,
        # A pause that was asked for is kept.
        "climb": _climb(printer) if settings.wire.pause_s is None else None,
        "brim_rings": None if settings.wire.brim_rings == "auto" else settings.wire.brim_rings,
        "pressure_advance": flavor.pressure_advance(printer.gcode),
        "layer_retract_over_mm": regions.retract_over_mm,
    }


def _climb(printer: Printer) -> dict[str, float]:
    """Return how fast the head rises, as the firmware has it."""
    motion = printer.motion
    if printer.gcode.flavor == "klipper" or motion.marlin is None:
        return {"mm_s": motion.max_z_velocity, "mm_s2": motion.max_z_accel}
    return {"mm_s": motion.marlin.max_velocity[2], "mm_s2": motion.marlin.max_accel[2]}


def _times(settings: Settings) -> dict[str, object]:
    """Return how long the head takes, so that orders of printing can be compared."""
    extruder, travel_mm_s = settings.printer.extruder, settings.printer.speeds.travel_mm_s
    filament_s = extruder.retract_mm / extruder.retract_speed_mm_s
    filament_s += extruder.retract_mm / extruder.unretract_speed_mm_s
    climb = _climb(settings.printer)
    lifts_mm_s = min(travel_mm_s, climb["mm_s"])
    return {
        "print_mm_s": settings.print_mm_s,
        "travel_mm_s": travel_mm_s,
        "pause_s": settings.pause_s,
        "hop_s": filament_s + 2 * settings.wire.travel_lift_mm / lifts_mm_s,
        "climb": climb,
    }


def _melting_mm_s(settings: Settings) -> float:
    """Speed at which the lines of regions take all that the hot end melts, mm/s."""
    regions, printer = settings.regions, settings.printer
    width = regions.width_ratio * settings.strand_mm
    melts = regions.max_flow_mm3_s or printer.extruder.max_flow_mm3_s
    return melts / line_section_mm2(width, regions.layer_height_mm)


def line_section_mm2(width_mm: float, layer_mm: float) -> float:
    """Cross-section of a layer's line: a rectangle between two half circles.

    Notes
    -----
    manual.slic3r.org, "Flow math".
    """
    return layer_mm * (width_mm - layer_mm * (1 - math.pi / 4))
