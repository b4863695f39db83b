"""What a strand that is slimmer than the paper's means: strength, stiffness, free ends, pauses."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Final, TypedDict

if TYPE_CHECKING:
    from wireprint.settings import Settings

#: Diameter of the paper's strands, mm, for which its spans and free ends are known.
PAPER_MM: Final = 0.7
#: Nozzles that are sold for any hot end, mm.
_SOLD_MM: Final = (0.4, 0.6, 0.8)
#: A flow that an ordinary hot end feeds at the speed of wire.
_FLOW: Final = 1.5
#: A strand with less of the paper's stiffness than this is called slim.
_SLIM: Final = 0.5


class Strand(TypedDict):
    """A strand, held against the paper's."""

    diameter_mm: float
    #: Force that breaks it, by the paper's: a cross section grows with the square of the diameter.
    strength: float
    #: Force that bends it, by the paper's: a rod's grows with the fourth power.
    stiffness: float
    #: Length that hangs as low, held at one end, as the paper's does at `wire.free_end_limit_mm`.
    free_end_mm: float
    #: At the end of a floating stroke.
    pause_s: float
    #: What would help, in words; empty where it is as sturdy as that.
    help: str


def strand_of(settings: Settings) -> Strand:
    """Hold the strands of a print against the paper's.

    Notes
    -----
    A cantilever under its own weight sags by :math:`w L^4 / 8 E I`, with the weight per length
    :math:`w` in the square and :math:`I` in the fourth power of the diameter: the length that sags
    equally grows with its square root (Gere, Mechanics of Materials, table of cantilevers).
    """
    diameter_mm = settings.strand_mm
    ratio = diameter_mm / PAPER_MM
    return {
        "diameter_mm": diameter_mm,
        "strength": ratio**2,
        "stiffness": ratio**4,
        "free_end_mm": settings.wire.free_end_limit_mm * math.sqrt(ratio),
        "pause_s": settings.pause_s,
        "help": _help(settings) if ratio**4 < _SLIM else "",
    }


def _help(settings: Settings) -> str:
    """Say what would make it stiffer: another nozzle, or more filament through this one."""
    nozzle_mm, diameter_mm = settings.printer.head.nozzle_mm, settings.strand_mm
    ways = []
    if (wider := next((sold for sold in _SOLD_MM if sold > nozzle_mm * 1.2), None)) is not None:
        times = settings.wire.flow**2 * (wider / diameter_mm) ** 4
        ways.append(f"--nozzle {wider:g}, if you have one, makes it {times:.0f} times as stiff")
    if settings.wire.flow < _FLOW:
        times = (_FLOW / settings.wire.flow) ** 2
        ways.append(f"--set wire.flow={_FLOW:g}, more filament through the same, {times:.1f} times")
    return "; ".join(ways)


def told(strand: Strand) -> str:
    """Say what a slim strand means; empty for any other."""
    if strand["stiffness"] >= _SLIM:
        return ""
    return (
        f"{strand['diameter_mm']:.3g} mm has {100 * strand['strength']:.0f} % of the strength and "
        f"{100 * strand['stiffness']:.0f} % of the stiffness of {PAPER_MM:g} mm, pauses for "
        f"{strand['pause_s']:.1f} s, and hangs free as well over {strand['free_end_mm']:.0f} mm"
        + (f": {strand['help']}" if strand["help"] else "")
    )
