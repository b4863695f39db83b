"""Struts that are added: to what nothing leads to, what hangs too far, what ends in the air."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from wireprint.struts.graph import Graph

if TYPE_CHECKING:
    from collections.abc import Collection, Sequence

    import numpy.typing as npt

    Floats = npt.NDArray[np.float64]
    Ints = npt.NDArray[np.int64]
    #: Where a node is, mm.
    Place = tuple[float, ...]


def supported(
    graph: Graph, hopeless: Ints, limit_mm: float, tried: Collection[Place] = frozenset()
) -> Graph:
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
    tried
        Places that have had one.

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
    hang_mm = np.full(len(graph.nodes), np.nan)
    hang_mm[held] = 0.0
    return propped(graph, list(lowest.values()), hang_mm, limit_mm, tried)


def propped(
    graph: Graph,
    nodes: Sequence[int],
    hang_mm: Floats,
    limit_mm: float,
    tried: Collection[Place] = frozenset(),
) -> Graph:
    """Return a graph with a support to each of some nodes, where one is short enough.

    Parameters
    ----------
    graph
        The struts, the lowest node on the bed.
    nodes
        Nodes that want one.
    hang_mm
        How far each node hangs from what is held otherwise; NaN where nothing may begin.
    limit_mm
        How far a support may hang: it ends in the air.
    tried
        Places that have had one.
    """
    feet: list[list[float]] = []
    pairs: list[tuple[int, int]] = []
    bed_mm = graph.nodes[:, 2].min()
    for node in nodes:
        place = graph.nodes[node]
        if place_of(graph, node) in tried:
            continue
        if place[2] - bed_mm <= limit_mm:
            pairs.append((len(graph.nodes) + len(feet), node))
            feet.append([place[0], place[1], bed_mm])
            continue
        below = np.flatnonzero((graph.nodes[:, 2] <= place[2]) & ~np.isnan(hang_mm))
        below = below[below != node]
        away = np.linalg.norm(graph.nodes[below] - place, axis=1) + hang_mm[below]
        if len(below) and away.min() <= limit_mm:
            pairs.append((int(below[away.argmin()]), node))
    return _with(graph, feet, pairs) if pairs else graph


def place_of(graph: Graph, node: int) -> Place:
    """Return a node's place as a key, mm."""
    return tuple(graph.nodes[node].round(6).tolist())


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
