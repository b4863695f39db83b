"""Struts with knees: short level pieces at their ends, so that a flat tip fits in.

A nozzle's tip is flat. Where a strut rises to a node that another one has reached already, the edge
of the tip would push into that one before the middle is there; where one begins at a node from
which another one rises, the tip would press that down; and a strut that falls would have its own
beginning under the tip. Pieces as long as the tip reaches, level with the nodes, are what zigzags
have, too: level, then fall.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from wireprint.struts.graph import Graph

if TYPE_CHECKING:
    import numpy.typing as npt

    from wireprint.settings import Settings

    Ints = npt.NDArray[np.int64]


@dataclass(frozen=True)
class Kneed:
    """A graph whose struts may be of two pieces, and which strut each piece is of."""

    graph: Graph
    #: Number of the strut, (M,).
    strut: Ints
    #: At which end of it the piece is, 0 or 1; -1: in between, or all of it.
    side: Ints

    def whole(self, numbers: Ints) -> tuple[Ints, Ints]:
        """Return where in an order of pieces each strut begins and ends, by places in it.

        Parameters
        ----------
        numbers
            The pieces in the order of printing.

        Returns
        -------
        first, last : ndarray
            Of each strut, in the order in which struts are begun, (S,).
        """
        of = self.strut[numbers]
        _, first = np.unique(of, return_index=True)
        _, last = np.unique(of[::-1], return_index=True)
        order = np.argsort(first)
        return first[order], (len(of) - 1 - last)[order]

    def turned(self, numbers: Ints, reversed_: npt.NDArray[np.bool_]) -> npt.NDArray[np.bool_]:
        """Tell of which struts the first pieces begin at the second end.

        Parameters
        ----------
        numbers, reversed_
            The first piece of each strut, and whether it is turned, (S,).
        """
        side = self.side[numbers]
        found: npt.NDArray[np.bool_] = np.where(side < 0, reversed_, side == 1)
        return found


def kneed(graph: Graph, settings: Settings) -> Kneed:
    """Give every strut that rises a level piece at each end that it shares with others.

    Upright struts have none, for no direction is theirs; nor have those that are too short.
    """
    reach_mm = settings.printer.head.tip_radius_mm + settings.strand_mm
    ends = graph.ends
    run = np.linalg.norm((ends[:, 1] - ends[:, 0])[:, :2], axis=1)
    rises = np.abs(ends[:, 1, 2] - ends[:, 0, 2]) > settings.strand_mm / 2
    wide = run > 2 * reach_mm + settings.strand_mm
    shared = graph.degrees()[graph.edges] > 1
    nodes, edges = [graph.nodes], graph.edges.copy()
    stubs, struts, sides = [], [np.arange(len(graph))], [np.full(len(graph), -1)]
    for end in (0, 1):
        bent = np.flatnonzero(rises & wide & shared[:, end])
        ahead = (ends[bent, 1 - end] - ends[bent, end])[:, :2] / run[bent, None]
        knees = ends[bent, end].copy()
        knees[:, :2] += ahead * reach_mm
        places = sum(map(len, nodes)) + np.arange(len(bent))
        stubs.append(np.column_stack([places, graph.edges[bent, end]]))
        struts.append(bent)
        sides.append(np.full(len(bent), end))
        edges[bent, end] = places
        nodes.append(knees)
    strut = np.concatenate(struts)
    radius = graph.radius_mm[strut] if len(graph.radius_mm) else graph.radius_mm
    pieces = Graph(np.concatenate(nodes), np.concatenate([edges, *stubs]), radius)
    return Kneed(pieces, strut, np.concatenate(sides))


def straight(graph: Graph) -> Kneed:
    """Return it as it is, each strut one piece."""
    count = len(graph)
    return Kneed(graph, np.arange(count), np.full(count, -1))
