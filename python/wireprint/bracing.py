"""Slabs made lower where few diagonals stand: on short contours a low diagonal finds room."""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

import numpy as np

from wireprint._core import KINDS
from wireprint.wholeness import is_as_wished, is_braced

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator

    import numpy.typing as npt

    from wireprint._core import Wireframe
    from wireprint.wire_plan import Plan

    Ints = npt.NDArray[np.int64]

#: How much lower a slab is made: so that one more is needed, about there or elsewhere.
_LOWER: Final = (0.8, 0.65)
#: Slabs that are tried, those with the most posts that no diagonal braces first.
_TRIED: Final = 5
#: Slabs with more diagonals per post than this are left as they are.
_ENOUGH: Final = 0.7
#: How often the best of what was tried is gone on with.
_ROUNDS: Final = 2
#: Less than this of the way to the goal is no gain.
_GAINED: Final = 0.1
#: After so many prints that gained nothing no more are tried.
_IN_VAIN: Final = 3
#: What leaves more of the way to the goal than this is not gone on with.
_HALF_WAY: Final = 0.5
#: Prints that are braced less than this part of what is wished need more than a lower slab or two.
_HOPELESS: Final = 0.5
#: No print is taken that takes so many times as long: sturdy enough is what it was, then.
_LONGEST: Final = 1.3


def braced(first: Plan, on_step: Callable[[str], None]) -> Plan:
    """Plan a print anew where fewer than `wire.braced_goal` diagonals brace a post.

    Parameters
    ----------
    first
        The plan.
    on_step
        Called before each print that is tried; it may raise to give up.

    Returns
    -------
    Plan
        The quickest of those tried that reaches the goal, covers what is wished and takes at most
        three tenths longer; else the first.
    """
    goal = first.settings.wire.braced_goal
    if is_braced(first.wireframe, first.settings) or first.braced < _HOPELESS * goal:
        return first
    base = first
    for _ in range(_ROUNDS):
        tried: list[Plan] = []
        for number, band in enumerate(_weakest(base)):
            if number == _IN_VAIN and not tried:
                return first
            on_step("lower slabs")
            other = base.lower([band])
            lacks = goal - base.braced
            if other is not None and other.braced > base.braced + _GAINED * lacks:
                tried.append(other)
        enough = [one for one in tried if one.braced >= goal]
        for one in sorted(enough, key=lambda one: one.time_s):
            if one.time_s > _LONGEST * first.time_s:
                break
            if _is_as_good(one, first):
                return one
        most = max((one.braced for one in tried), default=0.0)
        if enough or goal - most > _HALF_WAY * (goal - first.braced):
            break
        base = next(one for one in tried if one.braced == most)
    return first


def _is_as_good(tried: Plan, first: Plan) -> bool:
    """Whether a print keeps the rules, and covers what is wished or as much as the first."""
    if tried.fidelity is None:
        return False
    if is_as_wished(tried.fidelity, first.settings):
        return True
    if first.fidelity is None or is_as_wished(first.fidelity, first.settings):
        return False
    return tried.fidelity.coverage >= first.fidelity.coverage


def _by_slab(strands: Wireframe, kind: str) -> Ints:
    """Count the strands of a kind in each slab."""
    count = len(strands.levels) - 1
    slabs = strands.strand_slabs[strands.strand_kinds == KINDS.index(kind)]
    return np.bincount(slabs, minlength=count)[:count]


def _weakest(plan: Plan) -> Iterator[tuple[float, float, float]]:
    """Return the slabs with the most lone posts, and how high they may be instead, mm."""
    strands = plan.wireframe
    heights = strands.levels[:, 0]
    posts, diagonals = (_by_slab(strands, kind) for kind in ("post", "diagonal"))
    order = np.argsort(diagonals - posts, kind="stable")
    weak = [slab for slab in order.tolist() if diagonals[slab] < _ENOUGH * posts[slab]]
    for slab in weak[:_TRIED]:
        low, high = heights[slab : slab + 2].tolist()
        for share in _LOWER:
            lower = max(share * (high - low), plan.settings.slab_min_mm)
            if lower < high - low:
                yield low, high, lower
