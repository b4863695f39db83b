"""What a G-code file is judged by: the head, the limits and the firmware of a printer."""

from __future__ import annotations

import math
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any, Final

from wireprint import limits
from wireprint.claims import allowed
from wireprint.gcode.source import TEXT
from wireprint.naming import named

if TYPE_CHECKING:
    from wireprint import _core
    from wireprint.settings import Settings
    from wireprint.settings.head import Head
    from wireprint.settings.printer import Printer

#: Most filament that one command may move in place, mm: Klipper's default
#: max_extrude_only_distance, and Marlin's EXTRUDE_MAXLENGTH.
FILAMENT_ONLY_MM: Final = {"klipper": 50.0, "marlin": 200.0}
#: Filament that slicers leave pulled back by purpose ("extra length on restart" below zero), mm;
#: besides, a slower stroke gives back what a faster one squeezed.
RESTART_MM: Final = 1.0
#: Below this nothing is extruded, °C: Klipper's default min_extrude_temp, Marlin's EXTRUDE_MINTEMP.
EXTRUDES_C: Final = 170.0
#: Share of the time in which a strand sets that the head stays at a free end, at least. Up to half
#: of it a dwell does as good as nothing: a rod of ABS, 0.7 mm, in the air of a jet is pulled over
#: by 0.6 mm with 0 s and with 0.6 s alike, by 0.2 mm with 1 s and by 0.1 mm with 1.1 s (Maxwell
#: body, WLF viscosity). Air speed and draw, from which the time is computed, are known within a
#: factor of two.
SETTLED: Final = 0.25
#: So slow a stroke needs no dwell, mm/s. CuraEngine prints its wires at 5 mm/s, and the paper found
#: 5 mm/s without a pause as good as 30 mm/s with one; what that says of another material and air is
#: known within the same factor of two.
SLOW_MM_S: Final = 10.0


@dataclass(frozen=True)
class Judge:
    """The settings that a text is judged by, and why these."""

    settings: Settings
    #: Why: ``as named``, ``as the file says``, ``by default``.
    why: str
    #: What was changed in them, in sentences.
    remarks: tuple[str, ...] = field(default=())


def judge_of(text: bytes, printer: str | Settings | None, name: str = TEXT) -> Judge:
    """Return what to judge a text by: the settings given, those in the text, or the default.

    What a text may say of a printer that is known, `allowed` tells.

    Raises
    ------
    GcodeError
        The settings in the text are damaged; `name` stands for it.
    SettingError
        There is no such profile.
    """
    if printer is not None and not isinstance(printer, str):
        # Settings recalled from the cache do without pydantic.
        return Judge(printer, "as named")
    from wireprint.gcode.own_settings import settings_in
    from wireprint.settings import Settings

    if printer is not None:
        return Judge(Settings.load(printer), "as named")
    with named(None if name == TEXT else name):
        own = settings_in(text)
    if own is None:
        return Judge(Settings.load(), "by default: the file does not say for which it is")
    judged, remarks = allowed(own)
    return Judge(judged, "as the file says", remarks)


def settings_for(text: bytes, printer: str | Settings | None) -> Settings:
    """Return the settings to judge a text by; see `judge_of`."""
    return judge_of(text, printer).settings


def faults_of(head: Head) -> tuple[str, ...]:
    """Return what no head can be, in sentences."""
    flank_mm = _flank_mm(head)
    if head.block_radius_mm >= flank_mm:
        return ()
    return (
        f"head.block_radius_mm ({head.block_radius_mm:g}) ends inside the flank, which reaches "
        f"{flank_mm:.2f} mm where the block begins; judged as if the block reached so far",
    )


def _flank_mm(head: Head) -> float:
    """Radius of the flank at the height at which the block begins, mm."""
    slope = math.tan(math.radians(head.slant_deg))
    return head.tip_radius_mm + head.cone_height_mm / slope


def rules_of(settings: Settings) -> dict[str, Any]:
    """Return what the core judges by: lengths in mm, speeds in mm/s, times in s.

    A strand is as thick as the nozzle is wide. It lies on the bed where the tip is at most one
    strand above it.
    """
    printer, wire, material = settings.printer, settings.wire, settings.material
    head, extruder = printer.head, printer.extruder
    width, depth = printer.bed.size_mm
    area = math.pi / 4 * extruder.filament_diameter_mm**2
    firmware = "klipper" if limits.firmware_of(printer) == "klipper" else "marlin"
    # A little more than the flank, so that rounding does not matter.
    block_mm = max(head.block_radius_mm, _flank_mm(head) * (1 + 1e-9))
    shape = head.model_dump() | {
        "block_radius_mm": block_mm,
        "carriage_radius_mm": max(head.carriage_radius_mm, block_mm),
    }
    return {
        "head": shape,
        "strand_mm": settings.strand_mm,
        "bed_contact_mm": settings.strand_mm,
        "span_limit_mm": wire.span_limit_mm,
        "free_end_limit_mm": wire.free_end_limit_mm,
        "bed": {
            "centre_mm": printer.bed.centre_mm,
            "half_mm": (width / 2, depth / 2),
            "round": printer.bed.shape == "round",
            "height_mm": printer.bed.height_mm,
            "margins_mm": _margins_mm(printer),
        },
        "limits": {
            "feed_mm_s": printer.motion.max_velocity,
            "flow_mm3_s": extruder.max_flow_mm3_s,
            "filament_only_mm": FILAMENT_ONLY_MM[firmware],
            "pulled_back_mm": RESTART_MM + extruder.pressure_lag_s * extruder.max_flow_mm3_s / area,
            "filament_area_mm2": area,
        },
        "settling": {"dwell_s": SETTLED * settings.solidify_s, "slow_mm_s": SLOW_MM_S},
        "coldest_c": min(EXTRUDES_C, material.nozzle_c),
        "klipper": firmware == "klipper",
        "arc_resolution_mm": printer.motion.arc_resolution,
        "homing": _homing(printer),
        "retraction": limits.retraction_of(extruder),
        "macros": [(macro.name, macro.gcode) for macro in printer.gcode.macros],
    }


def _low_mm(printer: Printer) -> list[float]:
    """Return the bed's lowest x and y, mm."""
    bed = printer.bed
    return [middle - size / 2 for middle, size in zip(bed.centre_mm, bed.size_mm, strict=True)]


def _margins_mm(printer: Printer) -> tuple[tuple[float, float], tuple[float, float]]:
    """Return how far beyond the bed the head goes home, mm: towards low and high x and y."""
    homing = printer.homing
    low, size = _low_mm(printer), printer.bed.size_mm
    places = [(homing.x_mm, homing.y_mm), homing.z_place_mm or (None, None)]
    if printer.kinematics == "delta":
        places = []

    def farthest(axis: int, sign: float, edge: float) -> float:
        reached = [place[axis] for place in places]
        return max(0.0, *(sign * (at - edge) for at in reached if at is not None), 0.0)

    return (
        (farthest(0, -1, low[0]), farthest(1, -1, low[1])),
        (farthest(0, 1, low[0] + size[0]), farthest(1, 1, low[1] + size[1])),
    )


def _homing(printer: Printer) -> dict[str, Any]:
    """Return the way home: to the bed's low edge and down to the bed, unless told otherwise."""
    motion, homing, bed = printer.motion, printer.homing, printer.bed
    if printer.kinematics == "delta":
        at_mm = (0.0, 0.0, motion.endstop_height or 0.0)
        return {"at_mm": at_mm, "way": {"delta": motion.model_dump()}}
    low = _low_mm(printer)
    top = homing.z_end == "top"
    at_mm = (
        low[0] if homing.x_mm is None else homing.x_mm,
        low[1] if homing.y_mm is None else homing.y_mm,
        bed.height_mm if top else 0.0,
    )
    return {"at_mm": at_mm, "way": {"axes": homing.model_dump() | {"z_first": top}}}


def terms_of(settings: Settings) -> _core._Terms:
    """Return what coverage counts.

    Notes
    -----
    Contours a slab apart lie ``slab / sin(slope)`` apart along the surface. Where that is more
    than twice the distance that counts as covered, only caps can close it: that is what *level*
    means, up to 45°.
    """
    wire = settings.wire
    return {
        "within_mm": wire.coverage_within_mm,
        "strand_mm": settings.strand_mm,
        "level_sine": min(settings.slab_min_mm / (2 * wire.coverage_within_mm), math.sqrt(0.5)),
        "caps": wire.caps,
        "supports": wire.supports == "wire",
        "span_limit_mm": wire.span_limit_mm,
    }
