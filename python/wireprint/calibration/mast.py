"""The mast: one strand that bears a coin, which tells how stiff strands are.

It lies on a block at one end and on a tent at the other, from which it is cut: so its free end
need not hold in the air while it is laid, and the block is what it is held by.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

from wireprint._core import KINDS
from wireprint.calibration import bending
from wireprint.calibration.tents import strip, tent, tent_size

if TYPE_CHECKING:
    from wireprint.heads.gauge_path import Path
    from wireprint.settings import Settings

_CONTOUR, _SKIRT = KINDS.index("contour"), KINDS.index("skirt")
#: Length that is free, mm.
LENGTH_MM: Final = 60.0
#: How long, mm, and how wide, in lines, the block is: long enough to be held between two fingers.
_BLOCK_MM: Final = 15.0
_BLOCK_LINES: Final = 4
#: Distance of the block's lines, and height of its layers, in strands: they melt together.
_LINE: Final = 0.9
_LAYER: Final = 0.6
#: What hangs from it, g: a coin of one cent (euro; a dime of the United States weighs 2.27 g).
COIN_G: Final = 2.3
#: A drop by this share of the length is read well, and harms no strand.
_WELL: Final = 0.25


def mast(path: Path) -> None:
    """Lay a mast."""
    settings = path.settings
    strand = settings.strand_mm
    run_mm, high_mm = tent_size(settings)
    base = settings.first_layer_height_mm
    top = base + high_mm
    layers = max(1, round(high_mm / (_LAYER * strand)))
    rise = high_mm / layers
    strip(path, LENGTH_MM, LENGTH_MM + run_mm, 0.0, base)
    for layer in range(layers):
        _layer(path, base + layer * rise)
    held = 2 * settings.pause_s
    tent(path, (LENGTH_MM, 0.0), run_mm, top, base, held)
    path.go((-_BLOCK_MM, 0.0, top))
    path.strand((0.0, 0.0, top), _CONTOUR)
    path.strand((LENGTH_MM, 0.0, top), _CONTOUR, pause_s=held)


def _layer(path: Path, z: float) -> None:
    """Lay a layer of the block, there and back."""
    apart = _LINE * path.settings.strand_mm
    for number in range(_BLOCK_LINES):
        y = (number - (_BLOCK_LINES - 1) / 2) * apart
        ends = (-_BLOCK_MM, 0.0) if number % 2 == 0 else (0.0, -_BLOCK_MM)
        if number == 0:
            path.go((ends[0], y, z))
        else:
            path.strand((ends[0], y, z), _SKIRT)
        path.strand((ends[1], y, z), _SKIRT)


def mast_words(settings: Settings) -> tuple[str, ...]:
    """Say what to measure on a mast, and where the coin hangs best."""
    stiff = bending.of_strand(settings.strand_mm, settings.material.modulus_mpa)
    weight_n = COIN_G / 1000 * bending.GRAVITY_M_S2
    best_mm = min(0.9 * LENGTH_MM, (3 * stiff * _WELL / weight_n) ** 0.5)
    drop_mm = bending.drop_mm(COIN_G, best_mm, stiff)
    return (
        f"one strand of {LENGTH_MM:.0f} mm between a block and a tent",
        "measure: take it off the bed, cut the strand at the tent, and hold the block level; tie "
        f"or tape a coin of {COIN_G:g} g (1 euro cent; a dime has 2.27 g) to the strand "
        f"{best_mm:.0f} mm from the block, and measure with a ruler how far that place drops: "
        f"about {drop_mm:.0f} mm; hang it nearer where it drops by more than half of that length",
        "answer: [mast] weight_g = …, length_mm = from block to coin, drop_mm = …",
    )
