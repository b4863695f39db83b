"""Forms of struts: straight, or with knees, so that a flat tip fits in between others.

A nozzle's tip is flat. Where a strut rises to a node that another one has reached already, the edge
of the tip would push into that one before the middle is there; and where one begins at a node from
which another one rises, the tip would press that down. Knees are short level pieces at the nodes,
as long as the tip reaches: zigzags have them, too. Which form a strut has is for the search to
find: knees make room for what comes later at a node, and take room beside it.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Final

import numpy as np

if TYPE_CHECKING:
    import numpy.typing as npt

    from wireprint.settings import Settings
    from wireprint.struts.graph import Graph

    Floats = npt.NDArray[np.float64]
    Ints = npt.NDArray[np.int64]

#: Of a strand: as much may lie under the tip's edge, somewhat less than a joint is pressed flat.
_SQUASH: Final = 0.45
#: By how much of its radius a knee is farther than the tip's edge, at least.
_CLEAR: Final = 0.05


@dataclass(frozen=True)
class Forms:
    """Forms that struts may have, those of each strut in a row."""

    #: Number of the strut, (F,).
    strut: Ints
    #: Where it bends near either node, (F, 2, 3), mm; at the node itself where it does not.
    knees: Floats

    def pieces(self, graph: Graph, forms: Ints, reversed_: npt.NDArray[np.bool_]) -> Pieces:
        """Return the straight pieces of forms in an order, each in its direction."""
        edges = graph.nodes[graph.edges[self.strut[forms]]]
        points = np.stack(
            [edges[:, 0], self.knees[forms, 0], self.knees[forms, 1], edges[:, 1]], axis=1
        )
        points[reversed_] = points[reversed_][:, ::-1]
        ends = np.stack([points[:, :-1], points[:, 1:]], axis=2)
        real = (ends[:, :, 0] != ends[:, :, 1]).any(axis=2)
        numbers = np.repeat(np.arange(len(forms)), real.sum(axis=1))
        return Pieces(ends[real], numbers)


@dataclass(frozen=True)
class Pieces:
    """Straight pieces in the order of printing."""

    #: Both ends of each, mm, (P, 2, 3).
    ends: Floats
    #: Which of the strokes each is of, ascending, (P,).
    stroke: Ints

    def first(self) -> Ints:
        """Return the first piece of each stroke."""
        return np.unique(self.stroke, return_index=True)[1]

    def last(self) -> npt.NDArray[np.bool_]:
        """Tell which pieces end a stroke, (P,)."""
        return np.append(np.diff(self.stroke) > 0, True)


def forms(graph: Graph, settings: Settings) -> Forms:
    """Return the forms that each strut may have: straight, and with knees where these may help.

    A strut that rises more gently than a joint is pressed flat under the tip is straight; so is an
    upright one, for no direction is its own. Knees are as long as the tip reaches (its radius and
    one strand), or just longer than its radius.
    """
    radius_mm, strand_mm = settings.printer.head.tip_radius_mm, settings.strand_mm
    ends = graph.ends
    rise = np.abs(ends[:, 1, 2] - ends[:, 0, 2])
    run = np.linalg.norm((ends[:, 1] - ends[:, 0])[:, :2], axis=1)
    steep = rise * radius_mm > _SQUASH * strand_mm * run
    shared = graph.degrees()[graph.edges] > 1
    upper = (ends[:, 1, 2] > ends[:, 0, 2]).astype(np.int64)
    struts, knees = [np.arange(len(graph))], [ends.copy()]
    for reach_mm in (radius_mm + strand_mm, (1 + _CLEAR) * radius_mm):
        for at_upper, at_lower in ((True, False), (False, True), (True, True)):
            bends = [np.where(upper == end, at_upper, at_lower) for end in (0, 1)]
            bent_ends = np.stack(bends, axis=1)
            room = run > (bent_ends.sum(axis=1) * reach_mm + strand_mm / 2)
            which = np.flatnonzero(steep & room & (shared | ~bent_ends).all(axis=1))
            bent = ends[which].copy()
            ahead = (ends[which, 1] - ends[which, 0])[:, :2] / run[which, None]
            for end, sign in ((0, 1), (1, -1)):
                moved = sign * reach_mm * ahead * bent_ends[which, end, None]
                bent[:, end, :2] += moved
            struts.append(which)
            knees.append(bent)
    strut, knee = np.concatenate(struts), np.concatenate(knees)
    order = np.argsort(strut, kind="stable")
    return Forms(strut[order], knee[order])
