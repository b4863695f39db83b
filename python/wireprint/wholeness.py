"""Whole or not written: a print that leaves too much bare is refused, with what would help."""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

from wireprint._core import UnprintableError, WireprintError
from wireprint.remedies import remedies
from wireprint.report import breaches, listed_from_mm2

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator, Sequence

    from wireprint._core import Wireframe
    from wireprint.certificate import Certificate
    from wireprint.fidelity import Fidelity
    from wireprint.remedies import Remedy
    from wireprint.report import Unprinted
    from wireprint.settings import Settings

#: Fewer posts than so are no frame that could sway.
_FEW: Final = 12
#: Parts that are named; of more, their number is told.
_NAMED: Final = 4


class IncompleteError(UnprintableError):
    """The print would leave more of the model bare than `wire.coverage_min` allows."""

    #: What would be bare, as `WirePrint.figures` lists it.
    unprinted: Sequence[Unprinted]
    #: What was found to help, by the command's options; None: nothing that was tried.
    remedy: str | None
    #: Whether some use is left in it: something is printed, and fits the printer.
    usable: bool

    def __init__(
        self, message: str, unprinted: Sequence[Unprinted], remedy: str | None, *, usable: bool
    ) -> None:
        """Say what is wrong, with what would be bare and what helps."""
        super().__init__(message)
        self.unprinted, self.remedy, self.usable = unprinted, remedy, usable


def is_whole(certificate: Certificate, settings: Settings) -> bool:
    """Whether enough of the model that was compared is covered."""
    fidelity = certificate.fidelity
    return fidelity is None or fidelity.coverage >= settings.wire.coverage_min


def is_as_wished(fidelity: Fidelity, settings: Settings) -> bool:
    """Whether `wire.coverage_goal` is covered, and no bare patch is so large that it is listed."""
    if not settings.wire.coverage_goal:
        return True
    largest = max((patch.area_mm2 for patch in fidelity.uncovered), default=0.0)
    is_small = largest < listed_from_mm2(fidelity)
    return fidelity.coverage >= settings.wire.coverage_goal and is_small


def is_braced(strands: Wireframe, settings: Settings) -> bool:
    """Whether `wire.braced_goal` diagonals stand per post, or too few posts to sway."""
    posts = strands.post_count
    return posts < _FEW or strands.diagonal_count >= settings.wire.braced_goal * posts


def shortfall(certificate: Certificate | None, settings: Settings) -> str:
    """Say how little is covered; without a certificate nothing is."""
    fidelity = None if certificate is None else certificate.fidelity
    if fidelity is None:
        return "nothing of the model would be printed"
    return (
        f"only {100 * fidelity.coverage:.1f} % of the outer surface would be covered "
        f"(wire.coverage_min: {100 * settings.wire.coverage_min:g} %)"
    )


def refusal(
    certificate: Certificate | None,
    unprinted: Sequence[Unprinted],
    settings: Settings,
    attempt: Callable[[Remedy], Certificate | None] | None,
) -> IncompleteError:
    """Return the error about a print that leaves too much bare.

    Parameters
    ----------
    certificate
        The verdict; None where there is not one strand to judge.
    unprinted
        What would be bare.
    settings
        What it was made with.
    attempt
        Makes the print in another way, and judges it. A remedy is named only if that was whole and
        kept the rules. None: nothing is tried.
    """
    lines = [shortfall(certificate, settings), *_parts(unprinted)]
    helps = None
    if certificate is not None and not certificate.ok:
        broken = breaches(certificate, settings)
        if any(breach.bound == "volume" for breach in certificate.out_of_bounds):
            return IncompleteError(broken, unprinted, None, usable=False)
        lines.insert(0, broken)
    if attempt is not None:
        tried: list[str] = []
        for remedy in remedies(settings):
            tried.append(remedy.options)
            share = _coverage(remedy, attempt)
            if share is not None:
                helps = remedy.options
                lines.append(f"this helps ({100 * share:.1f} % covered when tried): {remedy}")
                break
        else:
            lines.append(f"none of these helps, all were tried: {', '.join(tried)}")
    return IncompleteError("\n".join(lines), unprinted, helps, usable=certificate is not None)


def _coverage(remedy: Remedy, attempt: Callable[[Remedy], Certificate | None]) -> float | None:
    """Return how much a remedy covers; None where that is no print either."""
    try:
        certificate = attempt(remedy)
    except WireprintError:
        return None
    if certificate is None or certificate.fidelity is None:
        return None
    whole = certificate.ok and is_whole(certificate, remedy.settings)
    return certificate.fidelity.coverage if whole else None


def _parts(unprinted: Sequence[Unprinted]) -> Iterator[str]:
    largest = sorted(unprinted, key=lambda part: -part["area_mm2"])
    for part in largest[:_NAMED]:
        yield f"bare: {told(part)}"
    if len(largest) > _NAMED:
        area = sum(part["area_mm2"] for part in largest[_NAMED:])
        yield f"and {len(largest) - _NAMED} more, {area:.0f} mm²"


def told(part: Unprinted) -> str:
    """Say how large a part is, where, and why it is bare."""
    x, y, z = part["place_mm"]
    where = f"about ({x:.1f}, {y:.1f}, {z:.1f})"
    if part["size_mm"] is not None:
        size = " × ".join(f"{extent:.1f}" for extent in part["size_mm"])
        where = f"{size} mm {where}"
    return f"{part['area_mm2']:.0f} mm², {where} ({part['reason'].replace('_', ' ')})"
