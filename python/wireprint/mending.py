"""Prints that would break their own rules: without the strands that do, which are named."""

from __future__ import annotations

import math
from itertools import pairwise
from typing import TYPE_CHECKING, Final

import numpy as np

from wireprint.cascade import falling, length_mm
from wireprint.certificate import check
from wireprint.gcode import document
from wireprint.stages import origin_mm, toolpath
from wireprint.verdict import Hurried, LooseEnd, Point, Span

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator

    import numpy.typing as npt

    from wireprint._core import Mesh, Wireframe
    from wireprint.certificate import Certificate
    from wireprint.settings import Settings
    from wireprint.standing import Standing

    Floats = npt.NDArray[np.float64]

#: Most prints that are tried: what hangs on something that was dropped falls in the next round.
ROUNDS: Final = 100
#: A print of which more than this share of the strands is to blame breaks the rules throughout, by
#: its settings: leaving strands out is no answer to that.
_MOST: Final = 0.1
#: Places that are told apart, mm: G-code has thousandths, along each axis.
_RESOLVED_MM: Final = 0.01
#: Rules that a print keeps if strands are left out of it.
_MENDED: Final = (
    "collisions",
    "floating_starts",
    "dangling_ends",
    "spans_over",
    "underfed",
    "hurried",
)


def mended(
    strands: Wireframe,
    certificate: Certificate,
    settings: Settings,
    standing: Standing | None = None,
    at_mm: Point = (0.0, 0.0, 0.0),
    rounds: int = ROUNDS,
    most_mm: float = math.inf,
    judge: Callable[[Wireframe], Certificate] | None = None,
    on_round: Callable[[], None] = lambda: None,
) -> Wireframe | None:
    """Leave out of a print the strands that break the rules, and what would hang on them.

    Parameters
    ----------
    strands
        The print.
    certificate
        The verdict on it.
    settings
        What it was made with.
    standing, at_mm
        What stands already, and where the print does; see `wireprint.check`.
    rounds
        Most prints that are tried.
    most_mm
        Length of strands that may be left out, mm.
    judge
        Gives the verdict on a whole print; default: by its moves alone, without a header.
    on_round
        Called before each print that is tried; it may raise to give up.

    Returns
    -------
    Wireframe or None
        A print that keeps the rules; `Wireframe.unprinted` names what was left out of it. None
        where none was found in so many rounds, it breaks them throughout, or other rules are
        broken, too.
    """
    origin, strand_mm = origin_mm(settings, at_mm), settings.strand_mm

    def by_moves(left: Wireframe) -> Certificate:
        return judged(left, settings, standing, at_mm)

    def to_blame(piece: Wireframe) -> dict[int, list[int]]:
        on_round()
        # G-code without a strand is nothing to judge.
        return _blamed(piece, by_moves(piece), origin) if piece.strand_count else {}

    number = 0
    while number < rounds:
        if any(found for name, found in certificate.breaches().items() if name not in _MENDED):
            return None
        blamed = _blamed(strands, certificate, origin)
        dropped = sorted({one for numbers in blamed.values() for one in numbers})
        throughout = number == 0 and len(dropped) > _MOST * strands.strand_count
        if throughout or not 0 < len(dropped) < strands.strand_count:
            return None
        number += 1
        dropped, fell = falling(strands, dropped, strand_mm, to_blame, rounds - number, most_mm)
        number += fell
        most_mm -= length_mm(strands.strands[dropped])
        if most_mm < 0 or len(dropped) == strands.strand_count:
            return None
        strands = strands.without(dropped, strand_mm)
        certificate = (judge or by_moves)(strands)
        if certificate.ok:
            return strands
    return None


def judged(
    strands: Wireframe,
    settings: Settings,
    standing: Standing | None = None,
    at_mm: Point = (0.0, 0.0, 0.0),
    mesh: Mesh | None = None,
) -> Certificate:
    """Judge a print by its moves alone, before it is a whole file, and what of a model it covers.

    Parameters
    ----------
    strands, settings
        The print.
    standing, at_mm
        What stands already, and where the print does; see `wireprint.check`.
    mesh
        What it is compared with.
    """
    path = toolpath(strands, settings, standing, at_mm)
    text = document.body(path, settings, document.dated(None))
    return check(text, settings, mesh, deviation=False, standing=standing, at_mm=at_mm)


def _blamed(strands: Wireframe, certificate: Certificate, origin: Point) -> dict[int, list[int]]:
    """Return the numbers of the strands that are to blame, by the strand that breaks a rule."""
    faulty = _faulty(certificate, origin)
    ends = [strand for stretch in faulty for strand in stretch]
    numbers = strands.holding(np.array(ends).reshape(-1, 2, 3), _RESOLVED_MM)
    found: dict[int, list[int]] = {}
    firsts = np.cumsum([0, *(len(stretch) for stretch in faulty)]).tolist()
    for first, end in pairwise(firsts):
        known = [number for number in numbers[first:end].tolist() if number >= 0]
        if known:
            found.setdefault(known[0], []).extend(known)
    return found


def _faulty(certificate: Certificate, origin: Point) -> list[list[Floats]]:
    """Return the ends of the strands that are to blame for each breach, mm, from the origin.

    A breach is put down to the strand of its line, or to the next one where the head only comes
    to it; of a stretch that hangs too far, or that nothing holds at one end, all strands are to
    blame: without the outermost of them the next would hang as it did.
    """
    laid, lines = certificate.core.strands, certificate.core.strand_lines
    loose = _Loose(certificate)
    found: list[list[int]] = []
    for name in _MENDED:
        for breach in certificate.breaches()[name]:
            number = int(np.searchsorted(lines, breach.line))
            if number == len(laid):
                continue
            stretch = [number]
            if isinstance(breach, Span):
                stretch += _before(laid, number, np.array(breach.from_mm))
            elif name == "floating_starts":
                stretch += loose.behind(number)
            elif isinstance(breach, LooseEnd | Hurried):
                stretch += loose.before(number, np.array(breach.at_mm))
            found.append(stretch)
    centre = np.array(origin)
    return [[laid[number] - centre for number in stretch] for stretch in found]


class _Loose:
    """The strands between an end that nothing holds and what holds the chain next."""

    def __init__(self, certificate: Certificate) -> None:
        core = certificate.core
        #: Strands, and the pieces that chains relax to, each with the strand in which it ends.
        self.laid = core.strands
        self.pieces, self.owners = core.relaxed, core.relaxed_strands

    def before(self, number: int, at_mm: Floats) -> Iterator[int]:
        """Return the strands behind what holds last before a place on a strand, its end."""
        own = self._of(number)
        ending = own[_off(self.pieces[own], at_mm) <= _RESOLVED_MM]
        held = self.pieces[ending[-1], 0] if len(ending) else at_mm
        return _before(self.laid, number, held)

    def behind(self, number: int) -> Iterator[int]:
        """Return the strands before what holds first after the start of a strand."""
        first = int(np.searchsorted(self.owners, number))
        if first == len(self.owners):
            return
        last = int(self.owners[first])
        # A strand that is held from its start on is none of them.
        if np.array_equal(self.pieces[first, 1], self.laid[last, 0]):
            last -= 1
        while number < last and np.array_equal(self.laid[number, 1], self.laid[number + 1, 0]):
            number += 1
            yield number

    def _of(self, number: int) -> npt.NDArray[np.intp]:
        low, high = np.searchsorted(self.owners, [number, number + 1])
        return np.arange(low, high)


def _before(laid: Floats, number: int, held_mm: Floats) -> Iterator[int]:
    """Walk back along a chain as far as where it was held last."""
    while number > 0 and _off(laid[number], held_mm) > _RESOLVED_MM:
        if not np.array_equal(laid[number - 1][1], laid[number][0]):
            return
        number -= 1
        yield number


def _off(strands: Floats, place: Floats) -> Floats:
    """Return how far a place is off each strand of (…, 2, 3), mm."""
    start, run = strands[..., 0, :], strands[..., 1, :] - strands[..., 0, :]
    length2 = np.sum(run**2, axis=-1)
    along = np.sum((place - start) * run, axis=-1) / np.where(length2 > 0, length2, 1.0)
    nearest = start + np.clip(along, 0, 1)[..., None] * run
    return np.asarray(np.linalg.norm(place - nearest, axis=-1))
