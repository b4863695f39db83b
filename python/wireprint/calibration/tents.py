"""Tents: what stands of posts and diagonals on strips, in a ladder of pauses and in a harp.

**The ladder** is twelve tents, each a post and a diagonal, whose pauses grow by a quarter from one
to the next. The first that stands tells the pause.

**The harp** is strands of three lengths between pairs of tents, at the speed of printing (the
shortest thrice) and at half of it. How far they sag tells draw and viscosity together.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

from wireprint import _core
from wireprint._core import KINDS
from wireprint.calibration import numbers

if TYPE_CHECKING:
    from wireprint.heads.gauge_path import Path
    from wireprint.settings import Settings

_POST, _DIAGONAL = KINDS.index("post"), KINDS.index("diagonal")
_CONTOUR, _SKIRT = KINDS.index("contour"), KINDS.index("skirt")

#: Tents of a ladder, and what each pause is to the one before it. The first has just over the
#: quarter of the computed pause that a certificate asks for, the last thrice as much as that pause.
TENTS: Final = 12
RATIO: Final = 1.25
FIRST: Final = 0.26
#: Tents in a row.
_IN_A_ROW: Final = 6
#: Height of a tent, mm, or as high as the head allows.
_TENT_MM: Final = 5.0
#: Lengths of a harp's strands, mm, and the strands from the front: shares of the speed of printing,
#: with lengths. The shortest are as long as most stretches of prints, and sag by little more than
#: can be read: so there are three of them.
LENGTHS_MM: Final = (20.0, 40.0, 60.0)
STRANDS: Final = (
    (1.0, 20.0),
    (1.0, 20.0),
    (1.0, 20.0),
    (1.0, 40.0),
    (1.0, 60.0),
    (0.5, 20.0),
    (0.5, 40.0),
    (0.5, 60.0),
)
#: Room between what stands, in strands.
APART: Final = 4.0


def pauses_s(settings: Settings) -> tuple[float, ...]:
    """Return the pauses of a ladder's tents, s, the shortest first."""
    return tuple(FIRST * settings.solidify_s * RATIO**number for number in range(TENTS))


def tent_size(settings: Settings) -> tuple[float, float]:
    """Return how far a tent's diagonal runs, and how high it stands, mm."""
    head = settings.printer.head
    high_mm = min(_TENT_MM, settings.slab_max_mm, head.cone_height_mm)
    run_mm = _core.stroke_run(head.model_dump(), settings.strand_mm, high_mm)
    return run_mm, high_mm


def ladder(path: Path) -> None:
    """Lay a ladder, numbered."""
    settings = path.settings
    strand = settings.strand_mm
    run_mm, high_mm = tent_size(settings)
    base = settings.first_layer_height_mm
    wide, deep = numbers.size_mm(TENTS, strand)
    pitch = max(run_mm + APART * strand, wide + 2 * APART * strand)
    between = run_mm + deep + 2 * APART * strand
    held = pauses_s(settings)
    rows = list(enumerate(range(0, TENTS, _IN_A_ROW)))
    for row, first in rows:
        for number in range(_IN_A_ROW):
            at = (number * pitch, row * between - deep - APART * strand)
            numbers.lay(path, first + number + 1, at, base)
        strip(path, 0.0, _IN_A_ROW * pitch, row * between, base)
    for row, first in rows:
        for number in range(_IN_A_ROW):
            at = (number * pitch, row * between)
            tent(path, at, run_mm, base + high_mm, base, held[first + number])


def harp(path: Path) -> None:
    """Lay a harp, its strands numbered from the front."""
    settings = path.settings
    strand = settings.strand_mm
    run_mm, high_mm = tent_size(settings)
    base = settings.first_layer_height_mm
    wide, deep = numbers.size_mm(1, strand)
    pitch = max(run_mm, deep) + APART * strand
    top = base + high_mm
    # Twice as long as it must, lest a column gives way before its strand is laid.
    held = 2 * settings.pause_s
    for row, (_, length) in enumerate(STRANDS):
        y = row * pitch
        at = (-run_mm - 2 * APART * strand - wide, y - deep / 2)
        numbers.lay(path, row + 1, at, base)
        strip(path, -run_mm, 0.0, y, base)
        strip(path, length, length + run_mm, y, base)
    for row, (share, length) in enumerate(STRANDS):
        y = row * pitch
        tent(path, (length, y), run_mm, top, base, held)
        tent(path, (0.0, y), -run_mm, top, base, held)
        path.go((0.0, y, top))
        path.strand((length, y, top), _CONTOUR, pause_s=held, share=share)


def tent(
    path: Path, at: tuple[float, float], run_mm: float, top: float, base: float, held: float
) -> None:
    """Print a post and its diagonal, along x."""
    x, y = at
    path.go((x, y, base))
    path.strand((x, y, top), _POST, pause_s=held)
    path.strand((x + run_mm, y, base), _DIAGONAL)


def strip(path: Path, begin: float, end: float, y: float, base: float) -> None:
    """Lay what tents stand on: three lines side by side on the bed."""
    wide = path.settings.strand_mm
    beyond = 3 * wide
    ends = [(begin - beyond, end + beyond), (end + beyond, begin - beyond)]
    for number, line in enumerate((-1, 0, 1)):
        low, high = ends[number % 2]
        start = (low, y + line * wide, base)
        if number == 0:
            path.go(start)
        else:
            path.strand(start, _SKIRT)
        path.strand((high, y + line * wide, base), _SKIRT)


def ladder_words(settings: Settings) -> tuple[str, ...]:
    """Say what to measure on a ladder."""
    pauses = pauses_s(settings)
    listed = ", ".join(f"{number + 1}: {pause:.2f} s" for number, pause in enumerate(pauses))
    return (
        f"tents in two rows of {_IN_A_ROW}, their numbers before them; {listed}",
        "measure: with the eye along a row, or calipers from post's foot to peak: the first tent "
        "whose peak stands within 0.2 mm above its foot, as all after it do",
        "answer: [ladder] first_standing = its number, in a file for wireprint calibrate fit",
    )


def harp_words(settings: Settings) -> tuple[str, ...]:
    """Say what to measure on a harp."""
    listed = ", ".join(
        f"{number}: {length:.0f} mm at {share * settings.print_mm_s:.3g} mm/s"
        for number, (share, length) in enumerate(STRANDS, 1)
    )
    return (
        f"strands from front to back, their numbers at the left; {listed}",
        "measure: how far each hangs at mid-span below the line between its ends, with calipers, "
        "or with a ruler on a photo from the side: to 0.15 mm",
        "answer: for each of them one [[harp]] length_mm = …, speed_mm_s = …, sag_mm = …",
    )
