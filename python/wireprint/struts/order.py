"""An order and directions in which a strut graph can be printed, as a certified file."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Any, Final

import numpy as np

from wireprint import _core
from wireprint._core import UnprintableError
from wireprint.certificate import check
from wireprint.gcode import document, file
from wireprint.records import Record
from wireprint.stages import path_params
from wireprint.struts.effort import Effort
from wireprint.struts.graph import Graph
from wireprint.struts.search import SUPPORT, search

if TYPE_CHECKING:
    from collections.abc import Callable
    from datetime import datetime

    from wireprint._core import Toolpath
    from wireprint.certificate import Certificate
    from wireprint.settings import Settings

Angles = tuple[float, float, float]

_GIVEN: Final[Angles] = (0.0, 0.0, 0.0)
#: The sides on which a graph may lie, as turns about x, then y, then z, degrees.
_SIDES: Final[tuple[Angles, ...]] = (
    _GIVEN,
    (180.0, 0.0, 0.0),
    (90.0, 0.0, 0.0),
    (-90.0, 0.0, 0.0),
    (0.0, 90.0, 0.0),
    (0.0, -90.0, 0.0),
)
#: Struts that are tested against each other; of more that would take minutes.
MOST_STRUTS: Final = 20_000
#: Other sizes that are tried of what cannot be printed, and of how many struts at most.
_SIZES: Final = (0.9, 1.12, 0.8, 1.25, 0.7, 1.4, 0.6, 0.5)
_MOST_RESIZED: Final = 500


@dataclass(frozen=True)
class OrderedGraph(Record):
    """A strut graph in the order of printing, and the file that prints it."""

    #: Struts in order, each from where it is begun; with times.
    graph: Graph
    #: Which of them end in the air, (M,) bool.
    floating: Any
    #: Supports that were added: numbers in `graph`.
    supports: tuple[int, ...]
    #: Struts of the given graph that are not printed, each with why: keys of `words.WHY`.
    unprinted: tuple[tuple[int, str], ...]
    #: By how much the given graph was turned about x, then y, then z, degrees.
    rotate_deg: Angles
    #: Whether the search's effort was spent before all was tried: more might be found.
    effort_spent: bool
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
        verdict += f", {len(self.unprinted)} not printed" if self.unprinted else ""
        return f"<OrderedGraph {len(self.graph)} struts, {self.print_time_s:.0f} s, {verdict}>"


def order(
    graph: Graph,
    settings: Settings,
    *,
    supports: bool = True,
    partial: bool = False,
    orient: bool = False,
    effort: float = 1.0,
    told: Callable[[int], object] | None = None,
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
    partial
        Whether struts that cannot be printed are left out; as few as are found.
    orient
        Whether it is also put on each of its other five sides: the one counts on which the most is
        printed, then with the fewest supports, then with the fewest free ends, then soonest.
    effort
        Of the usual effort, about half a minute of a processor a side; a search that has tried all
        ends sooner. It is counted, not timed: the result is the same everywhere.
    told
        Is called now and then with how many struts could be printed at most so far.
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
    sides = _SIDES if orient else (_GIVEN,)
    done, refused = [], None
    for side in sides:
        try:
            work = Effort(effort, told)
            done.append(_ordered(graph, settings, supports, work, partial, side, date))
        except UnprintableError as error:
            refused = refused or error
    if done:
        return min(done, key=_merit)
    ways = "" if partial else _way_out(graph, settings, supports, effort)
    raise UnprintableError(f"{refused}{ways}{_hint(partial, orient)}")


def _merit(found: OrderedGraph) -> tuple[float, ...]:
    """Return what tells the better of two: the less."""
    floating = int(found.floating.sum())
    return (len(found.unprinted), len(found.supports), floating, found.print_time_s)


def _hint(partial: bool, orient: bool) -> str:
    hints = ["--orient auto also tries its other sides"] * (not orient)
    hints += ["--partial prints what can be, and names the rest"] * (not partial)
    return f"\n{'; '.join(hints)}" if hints else ""


def _ordered(
    graph: Graph,
    settings: Settings,
    supports: bool,
    effort: Effort,
    partial: bool = False,
    rotate_deg: Angles = _GIVEN,
    date: datetime | None = None,
) -> OrderedGraph:
    placed = _placed(graph.turned(rotate_deg), settings)
    found = search(placed, settings, supports=supports, partial=partial, effort=effort)
    placed, shapes = found.graph, found.shapes
    form, reversed_, floating = (np.array(column) for column in zip(*found.strokes, strict=True))
    which = shapes.strut[form]
    ordered = placed.chosen(which, reversed_)
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
        tuple(int(place) for place in np.flatnonzero(found.numbers[which] == SUPPORT)),
        found.left,
        rotate_deg,
        found.is_spent,
        path,
        gcode,
        certificate,
        estimate.total_s,
        settings,
    )


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


def _way_out(graph: Graph, settings: Settings, supports: bool, effort: float) -> str:
    """Return the words for a size near its own in which all of it is printed; empty: none is found.

    Smaller, less hangs; larger, a tip of the same size gets in between more.
    """
    if len(graph) > _MOST_RESIZED:
        return ""
    for factor in _SIZES:
        try:
            work = Effort(effort / len(_SIZES))
            _ordered(graph.moved((0.0, 0.0, 0.0), factor), settings, supports, work)
        except UnprintableError:
            continue
        return f"\n{factor:g} times as large, all of it can be printed: --scale, times {factor:g}"
    return ""


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
