"""Slabs made lower about what a print would leave bare: what a high one misses, low ones reach."""

from __future__ import annotations

import json
from typing import TYPE_CHECKING, Final

from wireprint._core import WireprintError
from wireprint.bands import joined
from wireprint.mending import judged
from wireprint.report import listed_from_mm2
from wireprint.stages import wireframe
from wireprint.wholeness import is_as_wished

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator

    from wireprint._core import Mesh, Wireframe
    from wireprint.bands import Band
    from wireprint.certificate import Certificate
    from wireprint.fidelity import Fidelity, Patch
    from wireprint.settings import Settings

#: Heights of slabs that are tried, as shares of the highest: the least trouble first, for lower
#: slabs take longer. The last is the lowest slab of all.
_SHARES: Final = (0.6, 0.35, 0.0)
#: Patches are seen to from the largest on, until the rest is less than this share of what may be
#: bare.
_LEFT: Final = 0.25
#: What covers less than this more of the surface is not worth its time.
_WORTH: Final = 0.0005
#: Bands that `wire.low_slabs_mm` takes.
_MOST_BANDS: Final = 50


def lowered(
    mesh: Mesh,
    settings: Settings,
    planned: Wireframe,
    certificate: Certificate | None,
    on_step: Callable[[str], None] = lambda _: None,
) -> tuple[Settings, Wireframe] | None:
    """Plan a print anew with lower slabs where it would be bare, if that covers more.

    Parameters
    ----------
    mesh
        The model as it stands on the bed.
    settings, planned
        Its print.
    certificate
        The verdict on that, with what it covers; None: it is judged here.
    on_step
        Called before each print that is tried; it may raise to give up.

    Returns
    -------
    tuple of Settings and Wireframe, or None
        The first that covers `wire.coverage_goal` of the surface, and of which no patch is bare
        that would be listed; else that which covers most. None where nothing is amiss, or helps.
    """
    if not planned.strand_count:
        return None
    fidelity = (certificate or judged(planned, settings, mesh=mesh)).fidelity
    if fidelity is None or is_as_wished(fidelity, settings):
        return None
    most, best = fidelity.coverage + _WORTH, None
    bands: list[Band] = []
    for height_mm in _heights_mm(settings):
        # What lower slabs leave bare elsewhere is seen to, too.
        bands = joined([*bands, *_about(fidelity, settings)])
        on_step("lower slabs")
        tried = _with(settings, bands, height_mm)
        try:
            plan = wireframe(mesh, tried)
            verdict = judged(plan, tried, mesh=mesh) if plan.strand_count else None
        except WireprintError:
            continue
        if verdict is None or not verdict.ok or verdict.fidelity is None:
            continue
        fidelity = verdict.fidelity
        if fidelity.coverage > most:
            most, best = fidelity.coverage, (tried, plan)
            if is_as_wished(fidelity, settings):
                break
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


def _with(settings: Settings, bands: list[Band], height_mm: float) -> Settings:
    """Return settings with lower slabs between some heights, besides those that they have."""
    own = settings.wire.low_slabs_mm
    added = [[round(low, 3), round(high, 3), round(height_mm, 3)] for low, high in bands]
    bands_mm = [*map(list, own), *added][:_MOST_BANDS]
    return settings.but(overrides=[f"wire.low_slabs_mm={json.dumps(bands_mm)}"])
