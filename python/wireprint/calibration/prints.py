"""The calibration prints as moves: a ladder of pauses, and a harp of bridges.

**The ladder** is twelve tents, each a post and a diagonal, whose pauses grow by a quarter from one
to the next. The first that stands tells the pause.

**The harp** is strands of three lengths between pairs of tents, at the speed of printing and at
half of it. How far they sag tells draw and viscosity together.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Final, Literal

from wireprint import _core, certificate
from wireprint._core import KINDS, SettingError
from wireprint.heads.gauge_path import Path
from wireprint.pipeline import to_gcode

if TYPE_CHECKING:
    from wireprint.settings import Settings

Print = Literal["ladder", "harp"]

_POST, _DIAGONAL = KINDS.index("post"), KINDS.index("diagonal")
_CONTOUR, _SKIRT = KINDS.index("contour"), KINDS.index("skirt")

#: Tents of a ladder, and what each pause is to the one before it. The first has just over the
#: quarter of the computed pause that a certificate asks for, the last thrice as much as that pause.
TENTS: Final = 12
RATIO: Final = 1.25
_FIRST: Final = 0.26
#: Tents in a row.
_IN_A_ROW: Final = 6
#: Height of a tent, mm, or as high as the head allows.
_TENT_MM: Final = 5.0
#: Lengths of a harp's strands, mm, and shares of the speed of printing.
LENGTHS_MM: Final = (20.0, 40.0, 60.0)
SHARES: Final = (1.0, 0.5)
#: Room between what stands, in strands.
_APART: Final = 4.0


@dataclass(frozen=True)
class Printed:
    """A calibration print, and what to do with it."""

    gcode: bytes
    #: What to measure, with what, and how to answer; a line each.
    words: tuple[str, ...]


def pauses_s(settings: Settings) -> tuple[float, ...]:
    """Return the pauses of a ladder's tents, s, the shortest first."""
    return tuple(_FIRST * settings.solidify_s * RATIO**number for number in range(TENTS))


def printed(name: Print, settings: Settings) -> Printed:
    """Return a calibration print, certified.

    Raises
    ------
    SettingError
        It does not fit the bed, or the head cannot print it.
    """
    path = Path(settings)
    run_mm, high_mm = _tent(settings)
    words = _WORDS[name](settings)
    if name == "ladder":
        _ladder(path, run_mm, high_mm)
    else:
        _harp(path, run_mm, high_mm)
    path.go((*path.at[:2], path.top + settings.wire.travel_lift_mm), prints=False)
    text = to_gcode(path.toolpath(), settings, remarks=[f"calibration: {name}", *words])
    found = certificate.check(text, settings)
    if not found.ok:
        breach = next((all_[0] for all_ in found.breaches().values() if all_), found.remarks)
        width, depth = path.extent_mm
        msg = (
            f"no {name} is certified for {settings.printer.name}, {width:.0f} × {depth:.0f} mm: "
            f"{breach}; a flatter tent may do: --slab-max 3"
        )
        raise SettingError(msg)
    return Printed(text, words)


def _tent(settings: Settings) -> tuple[float, float]:
    """Return how far a tent's diagonal runs, and how high it stands, mm."""
    head = settings.printer.head
    high_mm = min(_TENT_MM, settings.slab_max_mm, head.cone_height_mm)
    run_mm = _core.stroke_run(head.model_dump(), settings.strand_mm, high_mm)
    return run_mm, high_mm


def _ladder(path: Path, run_mm: float, high_mm: float) -> None:
    settings = path.settings
    strand = settings.strand_mm
    base = settings.first_layer_height_mm
    pitch = run_mm + _APART * strand
    held = pauses_s(settings)
    for row, first in enumerate(range(0, TENTS, _IN_A_ROW)):
        _strip(path, 0.0, _IN_A_ROW * pitch, row * pitch, base)
        for number in range(_IN_A_ROW):
            at = (number * pitch, row * pitch)
            tent(path, at, run_mm, base + high_mm, base, held[first + number])


def _harp(path: Path, run_mm: float, high_mm: float) -> None:
    settings = path.settings
    strand = settings.strand_mm
    base = settings.first_layer_height_mm
    pitch = run_mm + _APART * strand
    top = base + high_mm
    # Twice as long as it must, lest a column gives way before its strand is laid.
    held = 2 * settings.pause_s
    rows = [(share, length) for share in SHARES for length in LENGTHS_MM]
    for row, (share, length) in enumerate(rows):
        y = row * pitch
        _strip(path, -run_mm, 0.0, y, base)
        _strip(path, length, length + run_mm, y, base)
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


def _strip(path: Path, begin: float, end: float, y: float, base: float) -> None:
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


def _ladder_words(settings: Settings) -> tuple[str, ...]:
    pauses = pauses_s(settings)
    listed = ", ".join(f"{number + 1}: {pause:.2f} s" for number, pause in enumerate(pauses))
    return (
        f"tents in two rows of {_IN_A_ROW}, from left to right, the front row first; {listed}",
        "measure: with the eye along a row, or calipers from post's foot to peak: the first tent "
        "whose peak stands within 0.2 mm above its foot, as all after it do",
        "answer: [ladder] first_standing = its number, in a file for wireprint calibrate fit",
    )


def _harp_words(settings: Settings) -> tuple[str, ...]:
    speeds = " and ".join(f"{share * settings.print_mm_s:.3g}" for share in SHARES)
    lengths = ", ".join(f"{length:.0f}" for length in LENGTHS_MM)
    return (
        f"strands of {lengths} mm from front to back at {speeds} mm/s, the faster ones in front",
        "measure: how far each hangs at mid-span below the line between its ends, with calipers, "
        "or with a ruler on a photo from the side: to 0.15 mm",
        "answer: for each [[harp]] length_mm = …, speed_mm_s = …, sag_mm = …",
    )


_WORDS: Final = {"ladder": _ladder_words, "harp": _harp_words}
