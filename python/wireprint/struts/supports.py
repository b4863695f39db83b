"""Struts that are added: to what nothing leads from the bed, or only what falls too steeply."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from wireprint.struts.graph import Graph

if TYPE_CHECKING:
    import numpy.typing as npt

    Ints = npt.NDArray[np.int64]


def supported(graph: Graph, hopeless: Ints, limit_mm: float) -> Graph:
    """Return a graph with a support to the lowest node of each part that cannot be begun.

    An upright from the bed where it is short enough, else the shortest strut from a node that can
    be reached and is no higher.

    Parameters
    ----------
    graph
        The struts, the lowest node on the bed.
    hopeless
        Numbers of those that cannot be begun.
    limit_mm
        How long a support may be: it ends in the air.

    Returns
    -------
    Graph
        Supports are the last of its struts; none where none is short enough.
    """
    part = parts(len(graph.nodes), graph.edges[hopeless])
    lost = np.unique(graph.edges[hopeless])
    others = np.delete(graph.edges, hopeless, axis=0)
    held = np.unique(others)
    lowest: dict[int, int] = {}
    for node in lost[np.argsort(graph.nodes[lost, 2], kind="stable")]:
        # A part's node that others lead to is no place to support it: what leaves it is the matter.
        if node not in held:
            lowest.setdefault(int(part[node]), int(node))
    feet: list[list[float]] = []
    pairs: list[tuple[int, int]] = []
    bed_mm = graph.nodes[:, 2].min()
    for node in lowest.values():
        place = graph.nodes[node]
        if place[2] - bed_mm <= limit_mm:
            pairs.append((len(graph.nodes) + len(feet), node))
            feet.append([place[0], place[1], bed_mm])
            continue
        below = held[graph.nodes[held, 2] <= place[2]]
        away = np.linalg.norm(graph.nodes[below] - place, axis=1)
        if len(below) and away.min() <= limit_mm:
            pairs.append((int(below[away.argmin()]), node))
    return _with(graph, feet, pairs)


def parts(nodes: int, edges: Ints) -> Ints:
    """Return the number of the connected part of each node, (N,)."""
    part = np.arange(nodes)
    while True:
        low = np.minimum(part[edges[:, 0]], part[edges[:, 1]])
        before = part.copy()
        np.minimum.at(part, edges[:, 0], low)
        np.minimum.at(part, edges[:, 1], low)
        part = part[part]
        if np.array_equal(part, before):
            return part


def _with(graph: Graph, feet: list[list[float]], pairs: list[tuple[int, int]]) -> Graph:
    radius = graph.radius_mm
    if len(radius):
        radius = np.concatenate([radius, np.full(len(pairs), np.median(radius))])
    return Graph(
        np.concatenate([graph.nodes, np.array(feet).reshape(-1, 3)]),
        np.concatenate([graph.edges, np.array(pairs, np.int64).reshape(-1, 2)]),
        radius,
    )
