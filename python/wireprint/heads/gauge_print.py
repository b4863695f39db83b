"""A gauge as G-code, with what is certified about it in its header."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING, Final

from wireprint import certificate
from wireprint._core import SettingError
from wireprint.heads.gauge import FEWEST_ROOFS, Gauge
from wireprint.heads.gauge_path import Path, drawn
from wireprint.whole_file import to_gcode

if TYPE_CHECKING:
    from wireprint.settings import Settings
    from wireprint.settings.printer import Bed

#: Added to a printer's name: its head is not the one that the file supposes.
SUPPOSES: Final = "{}, as its gauge supposes"


@dataclass(frozen=True)
class Printed:
    """The G-code of a gauge, and what is to be known of it."""

    gauge: Gauge
    gcode: bytes
    #: Fences and roofs in each.
    fences: int
    roofs: int
    #: Descents that the certificate calls collisions of the head as the profile has it.
    beyond: int


def printed(settings: Settings) -> Printed:
    """Return the gauge of a printer's head.

    It is certified for the slimmest head that it can tell, under a name that is no printer's. For
    the head of the profile all of it is certified but descents beside teeth and roofs that go
    beyond it: that is tested here, too.

    Raises
    ------
    SettingError
        It fits the bed in no form, or something of the head would hit more of it than is tried.
    """
    gauge = Gauge.of(settings.printer.head)
    path, fences, roofs = _fitting(gauge, settings)
    gauge = Gauge(gauge.head, gauge.teeth_deg, gauge.roofs_mm[:roofs] if fences else ())
    supposed = _supposed(settings, gauge)
    remarks = [
        f"gauge of the head of {settings.printer.name}, touched where its profile is wrong",
        f"certified for the slimmest head that it can tell ({gauge.supposed.slant_deg:g} deg, "
        f"{gauge.supposed.cone_height_mm:g} mm)",
        "for the head of the profile the tip's descents beside what is marked 'beyond the profile' "
        "are collisions: with one lone strand each",
        *gauge.words(),
    ]
    text = to_gcode(path.toolpath(), supposed, remarks=remarks)
    _prove(text, supposed)
    found = certificate.check(text, settings)
    low = settings.first_layer_height_mm + settings.printer.head.nozzle_mm / 2 + 1e-3
    stray = [hit for hit in found.collisions if hit.tip_mm[2] > low]
    others = [rule for rule, all_ in found.breaches().items() if rule != "collisions" and all_]
    if stray or others:
        told = str(stray[0]) if stray else others[0]
        raise SettingError(f"the gauge itself breaks the rules of its printer: {told}")
    return Printed(gauge, text, fences, roofs, len(found.collisions))


def _supposed(settings: Settings, gauge: Gauge) -> Settings:
    printer = settings.printer
    supposed = printer.model_copy(
        update={
            "name": SUPPOSES.format(printer.name)[:100],
            "known_as": (),
            "head": gauge.supposed,
        }
    )
    return settings.model_copy(update={"printer": supposed})


def _fitting(gauge: Gauge, settings: Settings) -> tuple[Path, int, int]:
    """Return the largest gauge that the bed holds: its moves, fences, and roofs of each."""
    most = len(gauge.roofs_mm)
    forms = [(f, r) for f in (2, 1) for r in range(most, FEWEST_ROOFS - 1, -1)]
    for fences, roofs in [*forms, (0, 0)]:
        path = drawn(gauge, settings, fences, roofs)
        if _lies_on(settings.printer.bed, path.extent_mm):
            return path, fences, roofs
    width, depth = path.extent_mm
    msg = (
        f"a gauge takes {width:.0f} × {depth:.0f} mm, which the bed of {settings.printer.name} "
        "does not hold; measure by hand: wireprint profiles head"
    )
    raise SettingError(msg)


def _lies_on(bed: Bed, extent_mm: tuple[float, float]) -> bool:
    if bed.diameter_mm is not None:
        return math.hypot(*extent_mm) <= bed.diameter_mm
    return all(size <= most for size, most in zip(extent_mm, bed.size_mm, strict=True))


def _prove(text: bytes, supposed: Settings) -> None:
    found = certificate.check(text, supposed)
    if found.ok:
        return
    rule, breaches = next((rule, all_) for rule, all_ in found.breaches().items() if all_)
    parts = supposed.printer.head.parts
    by_parts = rule == "collisions" and parts
    way_out = (
        "where the head's parts can be taken off, print it with --set head.parts=[]"
        if by_parts
        else "measure by hand: wireprint profiles head"
    )
    raise SettingError(f"no gauge is certified for this printer: {breaches[0]}; {way_out}")
