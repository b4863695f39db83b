"""An order and directions in which a strut graph can be printed, as a certified file."""

from __future__ import annotations

from collections import Counter
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Any, Final

import numpy as np

from wireprint import _core
from wireprint._core import UnprintableError
from wireprint.certificate import check
from wireprint.gcode import document, file
from wireprint.stages import path_params
from wireprint.struts.graph import Graph
from wireprint.struts.knees import forms
from wireprint.struts.supports import supported

if TYPE_CHECKING:
    from datetime import datetime

    from wireprint._core import Toolpath
    from wireprint.certificate import Certificate
    from wireprint.settings import Settings
    from wireprint.struts.knees import Forms

#: Struts that are printed on trial at most, by their number; those taken back count again.
_MOST_STEPS: Final = 20
#: Struts that are named of those that cannot be printed; of more, their number.
_NAMED: Final = 8
#: Struts that are tested against each other; of more that would take minutes.
MOST_STRUTS: Final = 20_000
#: Other sizes that are tried of what cannot be printed, and of how many struts at most.
_SIZES: Final = (0.9, 1.12, 0.8, 1.25, 0.7, 1.4, 0.6, 0.5)
_MOST_RESIZED: Final = 500
#: Reasons that a support may help against.
_SUPPORTED: Final = ("floats", "from_above")
_WHY: Final = {
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
}


@dataclass(frozen=True)
class OrderedGraph:
    """A strut graph in the order of printing, and the file that prints it."""

    #: Struts in order, each from where it is begun; with times.
    graph: Graph
    #: Which of them end in the air, (M,) bool.
    floating: Any
    #: Supports that were added: numbers in `graph`.
    supports: tuple[int, ...]
    toolpath: Toolpath
    #: The file.
    gcode: bytes
    #: The verdict on the file.
    certificate: Certificate
    print_time_s: float
    settings: Settings

    def __repr__(self) -> str:
        """Say what it comes to."""
        verdict = "certified" if self.certificate.ok else "not certified"
        return f"<OrderedGraph {len(self.graph)} struts, {self.print_time_s:.0f} s, {verdict}>"


def order(
    graph: Graph,
    settings: Settings,
    *,
    supports: bool = True,
    date: datetime | None = None,
) -> OrderedGraph:
    """Find an order and directions in which every strut can be printed, and print them so.

    Parameters
    ----------
    graph
        The struts; the lowest node is put on the bed, the middle of the box in its middle.
    settings
        Printer and material.
    supports
        Whether parts that nothing leads to, or only what falls too steeply, get a strut to their
        lowest node, where it is short enough; else they are refused.
    date
        Written into the file.

    Returns
    -------
    OrderedGraph
        With the certificate of the file, which keeps every rule.

    Raises
    ------
    UnprintableError
        Some struts cannot be printed; they are named, each with why.

    Notes
    -----
    Which strut bars which is decided beforehand by the exact test of the head; the search prints
    low struts first, never one after which others could not be printed any more, and takes back
    where none is left (after Huang et al., *FrameFab*, 2016, and *Choreo*, 2018). Where the head
    can print all struts in no order at all, that is proven before anything is searched for.
    """
    if len(graph) > MOST_STRUTS:
        raise UnprintableError(f"{len(graph)} struts; {MOST_STRUTS} are ordered at most")
    try:
        return _ordered(graph, settings, supports, date)
    except UnprintableError as error:
        said = f"{error}{_way_out(graph, settings, supports)}"
    raise UnprintableError(said)


def _ordered(
    graph: Graph, settings: Settings, supports: bool, date: datetime | None = None
) -> OrderedGraph:
    placed = _placed(graph, settings)
    shapes, found, left = _found(placed, settings)
    # What is supported may lead on to what is not yet: again, as long as it helps.
    while supports and left and all(why in _SUPPORTED for _, why in left):
        hopeless = np.array([number for number, _ in left])
        more = supported(placed, hopeless, settings.wire.free_end_limit_mm)
        if len(more) == len(placed):
            break
        placed = more
        shapes, found, left = _found(placed, settings)
    if left:
        raise UnprintableError(_refusal(placed, left))
    form, reversed_, floating = (np.array(column) for column in zip(*found, strict=True))
    floating.setflags(write=False)
    which = shapes.strut[form]
    ordered = placed.chosen(which, reversed_)
    loose = _loose(ordered, floating)
    if loose:
        raise UnprintableError(
            f"{len(loose)} struts end in the air, and nothing meets them: {_told(ordered, loose)}; "
            "join their ends, or leave them out"
        )
    pieces = shapes.pieces(placed, form, reversed_)
    params = path_params(settings) | {"skirt_rings": 0, "brim_rings": 0}
    # The head dwells at knees, too: a piece that rises to one ends in the air.
    floats = floating.astype(np.bool_)[pieces.stroke] | ~pieces.last()
    path = _core.lattice_toolpath(pieces.ends, floats, params)
    gcode, estimate = file.write(path, settings, date)
    certificate = check(gcode, settings)
    if not certificate.ok:
        raise UnprintableError(f"the order that was found breaks the rules: {_first(certificate)}")
    times = _times(pieces.ends, certificate, gcode, settings)
    return OrderedGraph(
        replace(ordered, time_s=times[pieces.first()]),
        floating,
        tuple(int(place) for place in np.flatnonzero(which >= len(graph))),
        path,
        gcode,
        certificate,
        estimate.total_s,
        settings,
    )


def _found(
    graph: Graph, settings: Settings
) -> tuple[Forms, list[tuple[int, bool, bool]], list[tuple[int, str]]]:
    """Search for an order; return the forms, what is found, and what is left with why."""
    shapes = forms(graph, settings)
    found, left = _core.order_lattice(
        graph.nodes,
        graph.edges.tolist(),
        shapes.strut.tolist(),
        shapes.knees,
        settings.printer.head.model_dump(),
        _rules(settings, len(graph)),
    )
    return shapes, found, left


def _first(certificate: Certificate) -> str:
    counts = {name: len(found) for name, found in certificate.breaches().items() if found}
    first = next(found[0] for found in certificate.breaches().values() if found)
    said = ", ".join(f"{name.replace('_', ' ')}: {count}" for name, count in counts.items())
    return f"{said}; first in line {first.line}: {first}"


def _placed(graph: Graph, settings: Settings) -> Graph:
    """Put a graph into the middle of the bed, its lowest node where a strand lies on it."""
    low, high = graph.nodes[graph.edges].min(axis=(0, 1)), graph.nodes[graph.edges].max(axis=(0, 1))
    middle = (low + high) / 2
    return graph.moved((-middle[0], -middle[1], settings.first_layer_height_mm - low[2]))


def _bed_mm(settings: Settings) -> float:
    """Height up to which a node lies on the bed, mm."""
    return settings.first_layer_height_mm + 0.25 * settings.strand_mm


def _rules(settings: Settings, struts: int) -> dict[str, object]:
    wire = settings.wire
    return {
        "strand_mm": settings.strand_mm,
        "bed_mm": _bed_mm(settings),
        "span_limit_mm": wire.span_limit_mm,
        "free_end_limit_mm": wire.free_end_limit_mm,
        "most_steps": _MOST_STEPS * max(struts, 100),
    }


def _loose(graph: Graph, floating: Any) -> list[int]:
    """Return the struts whose free end nothing meets."""
    degrees = graph.degrees()
    return [
        number
        for number, floats in enumerate(floating)
        if floats and degrees[graph.edges[number, 1]] == 1
    ]


def _way_out(graph: Graph, settings: Settings, supports: bool) -> str:
    """Return the words for a size near its own in which all of it is printed; empty: none is found.

    Smaller, less hangs; larger, a tip of the same size gets in between more.
    """
    if len(graph) > _MOST_RESIZED:
        return ""
    for factor in _SIZES:
        try:
            _ordered(graph.moved((0.0, 0.0, 0.0), factor), settings, supports)
        except UnprintableError:
            continue
        return f"\n{factor:g} times as large, all of it can be printed: --scale, times {factor:g}"
    return ""


def _refusal(graph: Graph, left: list[tuple[int, str]]) -> str:
    counts = Counter(why for _, why in left)
    lines = [f"{len(left)} of {len(graph)} struts cannot be printed"]
    for why in (why for why in _WHY if counts[why]):
        numbers = [number for number, reason in left if reason == why]
        lines.append(f"{counts[why]}: {_WHY[why]}: {_told(graph, numbers)}")
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


def _times(ends: Any, certificate: Certificate, gcode: bytes, settings: Settings) -> Any:
    """Return when each piece is begun, s from the first command on."""
    rows = document.timing(gcode, settings, per_move=True).per_move
    if rows is None:
        return np.empty(0)
    lines, durations = np.asarray(rows[0]), np.asarray(rows[1])
    begun = np.concatenate([[0.0], np.cumsum(durations)])
    places = certificate.core.strands - np.array([*settings.printer.bed.centre_mm, 0.0])
    own = np.searchsorted(lines, certificate.core.strand_lines)
    found = np.zeros(len(ends))
    number = 0
    # A piece may be written in two: it is begun where its first end is met, in order.
    for place, row in zip(places[:, 0], own, strict=True):
        if number < len(ends) and np.abs(place - ends[number, 0]).max() < 0.002:
            found[number] = begun[row]
            number += 1
    return found
