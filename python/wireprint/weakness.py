"""No reed: where a print gives way so easily, while it is printed, that strands miss it."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING, Final

from wireprint import _core
from wireprint.rules import rules_of
from wireprint.verdict import Point

if TYPE_CHECKING:
    from wireprint.settings import Settings

#: Floating-point operations after which a print is not judged: some ten seconds of one core.
MOST_WORK: Final = 1.5e11
#: Weak posts this near to a weaker one are told as one place with it, mm: the default of
#: `wire.free_end_limit_mm`, so about the longest post.
_PLACE_MM: Final = 20.0


@dataclass(frozen=True, slots=True)
class Weak:
    """A place where posts bend easily."""

    #: Line of the weakest post.
    line: int
    #: Where its peak is, mm, in the machine's coordinates.
    place_mm: Point
    #: How far a force moves that peak when it has just been laid, mm/N.
    compliance_mm_n: float
    #: What it may be, mm/N.
    limit_mm_n: float
    #: Number of posts about it that exceed the limit.
    posts: int

    def __str__(self) -> str:
        """Say how soft it is and where, in a line."""
        x, y, z = self.place_mm
        others = f", with {self.posts - 1} posts about it" if self.posts > 1 else ""
        return (
            f"{self.compliance_mm_n:.0f} mm/N (limit {self.limit_mm_n:.0f}) "
            f"at ({x:.1f}, {y:.1f}, {z:.1f}), line {self.line}{others}"
        )


def limit_mm_n(settings: Settings) -> float:
    """Return how far a peak may give way, mm/N: the nozzle's pull moves it by half a strand.

    Farther, and the next strand no longer meets it, for a contact is one strand's diameter.
    """
    return settings.strand_mm / 2 / settings.wire.pull_n


def find_weak(gcode: bytes, settings: Settings) -> tuple[Weak, ...] | None:
    """Find the posts that give way too easily when they have just been laid.

    Parameters
    ----------
    gcode
        The text, of any program.
    settings
        Printer and material.

    Returns
    -------
    tuple of Weak or None
        The places, the weakest first. None where that would take too much work; whether it would
        depends on the text alone.

    Notes
    -----
    Strands are straight beams, cold and rigidly joined where they touch: what is told is the
    least that a print gives way, to compare places and prints with.
    """
    peaks = _core.growth(gcode, rules_of(settings), settings.material.modulus_mpa, MOST_WORK)
    if peaks is None:
        return None
    limit = limit_mm_n(settings)
    weak = sorted((peak for peak in peaks if peak[2] > limit), key=lambda peak: (-peak[2], peak[0]))
    places: list[Weak] = []
    while weak:
        line, place, compliance = weak[0]
        far = [peak for peak in weak if math.dist(peak[1], place) > _PLACE_MM]
        places.append(Weak(line, place, compliance, limit, len(weak) - len(far)))
        weak = far
    return tuple(places)
