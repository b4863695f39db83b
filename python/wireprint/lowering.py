"""Slabs made lower about what a print would leave bare: what a high one misses, low ones reach."""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

from wireprint.bands import Band, joined
from wireprint.report import listed_from_mm2
from wireprint.wholeness import is_as_wished

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator

    from wireprint.fidelity import Fidelity, Patch
    from wireprint.settings import Settings
    from wireprint.wire_plan import Plan

#: Heights of slabs that are tried, as shares of the highest: the least trouble first, for lower
#: slabs take longer. The last is the lowest slab of all.
_SHARES: Final = (0.6, 0.35, 0.0)
#: How often they are tried, the second time also about what the best left bare elsewhere.
_ROUNDS: Final = 2
#: Patches are seen to from the largest on, until the rest is less than this share of what may be
#: bare.
_LEFT: Final = 0.25
#: What covers less than this more of the surface is not worth its time.
_WORTH: Final = 0.0005


def lowered(first: Plan, covered: Fidelity, on_step: Callable[[str], None]) -> Plan:
    """Plan a print anew with lower slabs where it would be bare, if that covers more.

    Parameters
    ----------
    first
        The plan.
    covered
        What its print covers, whether it keeps the rules or not.
    on_step
        Called before each print that is tried; it may raise to give up.

    Returns
    -------
    Plan
        The first that covers `wire.coverage_goal` of the surface, and of which no patch is bare
        that would be listed; else that which covers most.
    """
    best, settings = first, first.settings
    if is_as_wished(covered, settings):
        return best
    least, bands = covered.coverage + _WORTH, list[Band]()
    for _ in range(_ROUNDS):
        bands = joined([*bands, *_about(covered, settings)])
        for height_mm in _heights_mm(settings):
            on_step("lower slabs")
            tried = first.lower((*band, height_mm) for band in bands)
            if tried is None or tried.fidelity is None or tried.fidelity.coverage <= least:
                continue
            best, covered = tried, tried.fidelity
            least = covered.coverage
            if is_as_wished(covered, settings):
                return best
    return best


def _heights_mm(settings: Settings) -> Iterator[float]:
    """Return the heights of slabs to try, mm, each once."""
    highest, lowest = settings.slab_max_mm, settings.slab_min_mm
    heights = dict.fromkeys(max(share * highest, lowest) for share in _SHARES)
    return (height for height in heights if height < highest)


def _about(fidelity: Fidelity, settings: Settings) -> Iterator[Band]:
    """Return the heights of the bare patches that are seen to, mm."""
    may_be = (1 - settings.wire.coverage_goal) * fidelity.area_mm2
    rest = sum(patch.area_mm2 for patch in fidelity.uncovered)
    for patch in fidelity.uncovered:
        if rest < _LEFT * may_be and patch.area_mm2 < listed_from_mm2(fidelity):
            return
        rest -= patch.area_mm2
        yield _band(patch, settings.slab_min_mm)


def _band(patch: Patch, lowest_mm: float) -> Band:
    """Return where a patch lies; a level one lies within one slab."""
    low, high = patch.low_mm[2], patch.high_mm[2]
    if high - low < lowest_mm:
        middle = (low + high) / 2
        low, high = middle - lowest_mm / 2, middle + lowest_mm / 2
    return max(low, 0.0), high
