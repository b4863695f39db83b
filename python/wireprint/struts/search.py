"""The search for an order, with supports: of all struts, or of what can be printed."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Final

import numpy as np

from wireprint import _core
from wireprint._core import UnprintableError
from wireprint.struts.effort import Effort
from wireprint.struts.knees import forms
from wireprint.struts.supports import place_of, propped, supported
from wireprint.struts.words import LOOSE, SPENT, refusal

if TYPE_CHECKING:
    import numpy.typing as npt

    from wireprint.settings import Settings
    from wireprint.struts.graph import Graph
    from wireprint.struts.knees import Forms
    from wireprint.struts.supports import Place

    Floats = npt.NDArray[np.float64]
    Ints = npt.NDArray[np.int64]
    #: A form, whether it is reversed, and whether it ends in the air.
    Stroke = tuple[int, bool, bool]
    #: A strut, and why it is not printed.
    Left = tuple[int, str]

#: In place of a strut's number.
SUPPORT: Final = -1
#: Reasons that a support may help against.
_SUPPORTED: Final = ("floats", "from_above")
#: The same, where a part is wanted: a support to where they end.
_PROPPED: Final = ("hangs", LOOSE)


@dataclass(frozen=True)
class Found:
    """An order of struts."""

    #: The struts that are printed, and supports.
    graph: Graph
    #: The number of each in the given graph, or `SUPPORT`.
    numbers: Ints
    shapes: Forms
    #: In order: forms of `shapes`.
    strokes: list[Stroke]
    #: Given struts that are not printed, ascending, each with why.
    left: tuple[Left, ...]
    #: Whether the search's effort was spent before all was tried.
    is_spent: bool


def search(
    graph: Graph, settings: Settings, *, supports: bool, partial: bool, effort: Effort | None = None
) -> Found:
    """Search for an order of a graph that stands on the bed.

    Parameters
    ----------
    graph
        The struts.
    settings
        Printer and material.
    supports
        Whether parts that nothing leads to get one; of a part also what hangs too far, or ends in
        the air.
    partial
        Whether struts that cannot be printed are left out.
    effort
        How long it may search, and who is told.

    Returns
    -------
    Found
        The order.

    Raises
    ------
    UnprintableError
        Some struts cannot be printed or, where they may be left out, none can.
    """
    given, numbers = graph, np.arange(len(graph))
    effort = effort or Effort()
    out: list[Left] = []
    # Where a support was in vain, another would be, too.
    tried: set[Place] = set()
    while True:
        shapes, strokes, left = _ordered(graph, settings, partial, effort)
        if partial and effort.is_spent and strokes:
            return _as_it_is(
                Found(graph, numbers, shapes, strokes, tuple(out), is_spent=True), left
            )
        left = left or _loose(graph, shapes, strokes)
        if not left:
            spent = effort.is_spent
            return Found(graph, numbers, shapes, strokes, tuple(sorted(out)), is_spent=spent)
        # What is supported may lead on to what is not yet: again, as long as it helps.
        if supports and (
            more := _supported(graph, settings, shapes, strokes, left, partial, tried)
        ):
            added = np.full(len(more) - len(graph), SUPPORT)
            tried |= {place_of(more, end) for end in more.edges[len(graph) :, 1]}
            graph, numbers = more, np.append(numbers, added)
            continue
        out += [(int(numbers[strut]), why) for strut, why in left if numbers[strut] != SUPPORT]
        more_words = f"\n{SPENT}" if effort.is_spent else ""
        if not partial:
            raise UnprintableError(refusal(graph, left) + more_words)
        if len(left) == len(graph):
            raise UnprintableError(refusal(given, sorted(out)) + more_words)
        kept = np.delete(np.arange(len(graph)), [strut for strut, _ in left])
        graph, numbers = graph.chosen(kept), numbers[kept]


def _supported(
    graph: Graph,
    settings: Settings,
    shapes: Forms,
    strokes: list[Stroke],
    left: list[Left],
    partial: bool,
    tried: set[Place],
) -> Graph | None:
    """Return the graph with supports to what cannot be printed without; None if none helps."""
    limit_mm = settings.wire.free_end_limit_mm
    hopeless = np.array([strut for strut, why in left if why in _SUPPORTED], np.int64)
    more = graph
    if len(hopeless) and (partial or len(hopeless) == len(left)):
        more = supported(graph, hopeless, limit_mm, tried)
    hung = [strut for strut, why in left if why in _PROPPED]
    if partial and hung and len(more) == len(graph):
        hang_mm = _hanging(graph, shapes, strokes)
        # What nothing meets ends at a node that stands, as it were, by that strut alone.
        free = [graph.edges[strut][np.isnan(hang_mm[graph.edges[strut]])] for strut in hung]
        loose = [node for node in np.unique(graph.edges[hung]) if hang_mm[node] > 0]
        ends = np.unique(np.concatenate([*free, np.array(loose, np.int64)]))
        ends = ends[graph.nodes[ends, 2] > bed_mm(settings)]
        more = propped(graph, ends.tolist(), hang_mm, limit_mm, tried)
    return more if len(more) > len(graph) else None


def _hanging(graph: Graph, shapes: Forms, strokes: list[Stroke]) -> Floats:
    """Return how far each node hangs when all strokes are printed, mm; NaN where none ends."""
    hang_mm = np.full(len(graph.nodes), np.nan)
    lengths_mm = np.linalg.norm(graph.ends[:, 1] - graph.ends[:, 0], axis=1)
    for form, reversed_, floats in strokes:
        strut = shapes.strut[form]
        ends = graph.edges[strut, ::-1] if reversed_ else graph.edges[strut]
        if floats:
            hang_mm[ends[0]] = np.nan_to_num(hang_mm[ends[0]])
            hang_mm[ends[1]] = hang_mm[ends[0]] + lengths_mm[strut]
        else:
            hang_mm[ends] = 0.0
    return hang_mm


def _as_it_is(found: Found, left: list[Left]) -> Found:
    """Return what was printed when a search ended, without what nothing meets."""
    edges, strokes, out = found.graph.edges, found.strokes, list(left)
    while True:
        stands = np.array([found.shapes.strut[form] for form, _, _ in strokes], np.int64)
        printed = edges[stands]
        degrees = np.bincount(printed.ravel(), minlength=len(found.graph.nodes))
        kept = []
        for form, reversed_, floats in strokes:
            strut = int(found.shapes.strut[form])
            if floats and degrees[edges[strut, 0 if reversed_ else 1]] == 1:
                out.append((strut, LOOSE))
            else:
                kept.append((form, reversed_, floats))
        if len(kept) == len(strokes):
            break
        strokes = kept
    numbers = found.numbers
    named = [(int(numbers[strut]), why) for strut, why in out if numbers[strut] != SUPPORT]
    if not strokes:
        raise UnprintableError(f"{refusal(found.graph, out)}\n{SPENT}")
    return replace(found, strokes=strokes, left=tuple(sorted([*found.left, *named])))


def bed_mm(settings: Settings) -> float:
    """Return the height up to which a node lies on the bed, mm."""
    return settings.first_layer_height_mm + 0.25 * settings.strand_mm


def _ordered(
    graph: Graph, settings: Settings, partial: bool, effort: Effort
) -> tuple[Forms, list[Stroke], list[Left]]:
    """Return the forms, what is found, and what is left with why."""
    shapes = forms(graph, settings)
    wire = settings.wire
    found, left, work_left = _core.order_lattice(
        graph.nodes,
        graph.edges.tolist(),
        shapes.strut.tolist(),
        shapes.knees,
        settings.printer.head.model_dump(),
        {
            "strand_mm": settings.strand_mm,
            "bed_mm": bed_mm(settings),
            "span_limit_mm": wire.span_limit_mm,
            "free_end_limit_mm": wire.free_end_limit_mm,
            "most_work": effort.work,
            "partial": partial,
        },
        effort.watch,
    )
    effort.spend(work_left)
    if effort.watch is not None:
        effort.watch(len(found))
    return shapes, found, left


def _loose(graph: Graph, shapes: Forms, strokes: list[Stroke]) -> list[Left]:
    """Return the struts whose free end nothing meets."""
    degrees = graph.degrees()
    found = []
    for form, reversed_, floats in strokes:
        strut = int(shapes.strut[form])
        end = graph.edges[strut, 0 if reversed_ else 1]
        if floats and degrees[end] == 1:
            found.append((strut, LOOSE))
    return sorted(found)
