"""The settings of a layer-wise print, resolved for one machine."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING, Self

from wireprint.layerwise.moves import Rates
from wireprint.layerwise.shells import Shells
from wireprint.records import Record

if TYPE_CHECKING:
    from wireprint.settings import Settings
    from wireprint.settings.layers import LayerProfile
    from wireprint.settings.printer import Printer


@dataclass(frozen=True, repr=False)
class Recipe(Record):
    """What the slicer needs to know, in mm."""

    layer_mm: float
    #: Width of a line.
    width_mm: float
    #: From line to line: a line's width without its two round flanks.
    spacing_mm: float
    overlap_mm: float
    perimeters: int
    shells: Shells
    #: Share, 0 to 1.
    infill_density: float
    #: Ends of neighbouring lines no further apart are joined.
    solid_link_mm: float
    link_mm: float
    seam_gap_mm: float
    resolution_mm: float
    rates: Rates

    @classmethod
    def of(cls, profile: LayerProfile, printer: Printer, strand_mm: float | None = None) -> Self:
        """Resolve a profile for a printer, beside strands of a diameter; None: the nozzle's.

        Notes
        -----
        A line is a rectangle between two half circles: for width w and height h its cross-section
        is ``h·(w − h) + π/4·h²``, and lines ``w − h·(1 − π/4)`` apart fill a layer without gaps
        (manual.slic3r.org, "Flow math").
        """
        nozzle, layer = strand_mm or printer.head.nozzle_mm, profile.layer_height_mm
        width = profile.width_ratio * nozzle
        spacing = width - layer * (1 - math.pi / 4)
        return cls(
            layer_mm=layer,
            width_mm=width,
            spacing_mm=spacing,
            overlap_mm=profile.infill_overlap * width,
            perimeters=profile.perimeters,
            shells=Shells(
                profile.bottom_layers,
                profile.top_layers,
                width,
                profile.solid_anchor * width,
                profile.solid_below_mm2,
            ),
            infill_density=profile.infill_density,
            solid_link_mm=profile.solid_link * spacing,
            link_mm=profile.link_mm,
            seam_gap_mm=profile.seam_gap * nozzle,
            resolution_mm=profile.resolution_mm,
            rates=_rates(profile, printer, layer * spacing),
        )


def _rates(profile: LayerProfile, printer: Printer, section_mm2: float) -> Rates:
    extruder, motion = printer.extruder, printer.motion
    melts = (profile.max_flow_mm3_s or extruder.max_flow_mm3_s) / section_mm2
    return Rates(
        layer_mm=profile.layer_height_mm,
        filament_per_mm=section_mm2 / (math.pi / 4 * extruder.filament_diameter_mm**2),
        print_mm_s=min(profile.print_mm_s, melts),
        first_layer_mm_s=min(profile.first_layer_mm_s, melts),
        travel_mm_s=min(profile.travel_mm_s, motion.max_velocity),
        retract_mm=extruder.retract_mm,
        retract_mm_s=extruder.retract_speed_mm_s,
        unretract_mm_s=extruder.unretract_speed_mm_s,
        retract_over_mm=profile.retract_over_mm,
        centre_mm=printer.bed.centre_mm,
    )


def on_fast_printer(settings: Settings) -> Settings:
    """Return the settings with the machine of ``layerwise.fast`` in place of the printer."""
    fast = settings.layerwise.fast
    printer = type(settings).load(printer=fast.printer).printer
    limits = {"max_velocity": fast.max_velocity_mm_s, "max_accel": fast.max_accel_mm_s2}
    motion = printer.motion.model_copy(update=limits)
    return settings.model_copy(update={"printer": printer.model_copy(update={"motion": motion})})
