"""The search for an order, with supports: of all struts, or of what can be printed."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Final

import numpy as np

from wireprint import _core
from wireprint._core import UnprintableError
from wireprint.struts.knees import forms
from wireprint.struts.supports import supported
from wireprint.struts.words import LOOSE, refusal

if TYPE_CHECKING:
    import numpy.typing as npt

    from wireprint.settings import Settings
    from wireprint.struts.graph import Graph
    from wireprint.struts.knees import Forms

    Ints = npt.NDArray[np.int64]
    #: A form, whether it is reversed, and whether it ends in the air.
    Stroke = tuple[int, bool, bool]
    #: A strut, and why it is not printed.
    Left = tuple[int, str]

#: Struts that are printed on trial at most, by their number; those taken back count again.
_MOST_STEPS: Final = 20
#: In place of a strut's number.
SUPPORT: Final = -1
#: Reasons that a support may help against.
_SUPPORTED: Final = ("floats", "from_above")


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


def search(graph: Graph, settings: Settings, *, supports: bool, partial: bool) -> Found:
    """Search for an order of a graph that stands on the bed.

    Parameters
    ----------
    graph
        The struts.
    settings
        Printer and material.
    supports
        Whether parts that nothing leads to get one.
    partial
        Whether struts that cannot be printed are left out.

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
    out: list[Left] = []
    while True:
        shapes, strokes, left = _ordered(graph, settings, partial)
        left = left or _loose(graph, shapes, strokes)
        if not left:
            return Found(graph, numbers, shapes, strokes, tuple(sorted(out)))
        hopeless = np.array([strut for strut, why in left if why in _SUPPORTED], np.int64)
        # What is supported may lead on to what is not yet: again, as long as it helps.
        if supports and len(hopeless) and (partial or len(hopeless) == len(left)):
            more = supported(graph, hopeless, settings.wire.free_end_limit_mm)
            if len(more) > len(graph):
                added = np.full(len(more) - len(graph), SUPPORT)
                graph, numbers = more, np.append(numbers, added)
                continue
        told = [(int(numbers[strut]), why) for strut, why in left]
        out += [one for one in told if one[0] != SUPPORT]
        if not partial:
            raise UnprintableError(refusal(graph, left))
        if len(left) == len(graph):
            raise UnprintableError(refusal(given, sorted(out)))
        # What a support was in vain for would ask for it again.
        supports = supports and len(told) == sum(number != SUPPORT for number, _ in told)
        kept = np.delete(np.arange(len(graph)), [strut for strut, _ in left])
        graph, numbers = graph.chosen(kept), numbers[kept]


def bed_mm(settings: Settings) -> float:
    """Return the height up to which a node lies on the bed, mm."""
    return settings.first_layer_height_mm + 0.25 * settings.strand_mm


def _ordered(
    graph: Graph, settings: Settings, partial: bool
) -> tuple[Forms, list[Stroke], list[Left]]:
    """Return the forms, what is found, and what is left with why."""
    shapes = forms(graph, settings)
    wire = settings.wire
    found, left = _core.order_lattice(
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
            "most_steps": _MOST_STEPS * max(len(graph), 100),
            "partial": partial,
        },
    )
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
