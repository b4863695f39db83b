"""Why struts cannot be printed, in words."""

from __future__ import annotations

from collections import Counter
from typing import TYPE_CHECKING, Final

if TYPE_CHECKING:
    from collections.abc import Sequence

    from wireprint.struts.graph import Graph

#: Struts that are named of those that cannot be printed; of more, their number.
_NAMED: Final = 8
#: What nothing meets at its free end.
LOOSE: Final = "loose"
#: Where more might be found.
SPENT: Final = "the search's effort was spent before all was tried; --effort 4 looks longer"
#: By the core's reason.
WHY: Final = {
    "floats": "nothing leads to it from the bed",
    "too_long": "it is longer than what may hang (wire.span_limit_mm)",
    "too_steep": "it can only be drawn downwards, more steeply than the head allows",
    "from_above": "only what falls more steeply than the head can draw leads there; support their "
    "lower ends",
    "locked": "no order has them all: whichever came last, the head would run into the others",
    "hangs": "too much would hang from a free end in any order that was tried "
    "(wire.free_end_limit_mm); make it smaller with --scale, or support it",
    "barred": "the head would run into others in any order that was tried",
    "waits": "what they begin at is not printed",
    LOOSE: "they end in the air, and nothing meets them; join their ends, or leave them out",
}


def refusal(graph: Graph, left: Sequence[tuple[int, str]]) -> str:
    """Name struts that cannot be printed, by reason.

    Parameters
    ----------
    graph
        All struts.
    left
        Numbers of those that cannot be printed, and why: keys of `WHY`.

    Returns
    -------
    str
        Lines.
    """
    counts = Counter(why for _, why in left)
    lines = [f"{len(left)} of {len(graph)} struts cannot be printed"]
    for why in (why for why in WHY if counts[why]):
        numbers = [number for number, reason in left if reason == why]
        lines.append(f"{counts[why]}: {WHY[why]}: {_told(graph, numbers)}")
    if counts["barred"]:
        lines.append("a slimmer head reaches deeper: head.slant_deg, head.cone_height_mm")
    return "\n".join(lines)


def _told(graph: Graph, numbers: list[int]) -> str:
    def one(number: int) -> str:
        (a, b), (low, high) = graph.edges[number], graph.ends[number]
        ends = " to ".join(f"({x:.1f}, {y:.1f}, {z:.1f})" for x, y, z in (low, high))
        return f"{a}-{b} {ends}"

    more = f", and {len(numbers) - _NAMED} more" if len(numbers) > _NAMED else ""
    return ", ".join(one(number) for number in numbers[:_NAMED]) + more
