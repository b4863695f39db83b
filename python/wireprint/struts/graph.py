"""A strut graph: nodes, and straight struts between two of them each."""

from __future__ import annotations

import itertools
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Final

import numpy as np

from wireprint._core import ModelError
from wireprint.records import Record, sealed

if TYPE_CHECKING:
    import numpy.typing as npt

    Floats = npt.NDArray[np.float64]
    Ints = npt.NDArray[np.int64]

#: Nodes nearer than this are one, mm: files have six digits or so.
SAME_MM: Final = 1e-3
#: No coordinate is as large, mm; and cells from there on, so that no number of one is negative.
_FARTHEST_MM: Final = 1e9
_MIDDLE: Final = 1 << 50


def _none() -> Floats:
    return np.empty(0)


@dataclass(frozen=True, eq=False, repr=False)
class Graph(Record):
    """Struts between nodes, and what is known of each; read-only arrays."""

    #: Positions, mm, (N, 3).
    nodes: Floats
    #: Two node numbers each, (M, 2), from where it is printed to where.
    edges: Ints
    #: Radius of each strut, mm, (M,); empty: not told.
    radius_mm: Floats = field(default_factory=_none)
    #: When each is begun, s from the print's begin, (M,), in printing order; empty: not told.
    time_s: Floats = field(default_factory=_none)
    #: Where the tool points from, at each strut, unit vectors (M, 3); empty: not told.
    normals: Floats = field(default_factory=lambda: np.empty((0, 3)))

    if TYPE_CHECKING:

        def __init__(
            self,
            nodes: npt.ArrayLike,
            edges: npt.ArrayLike,
            radius_mm: npt.ArrayLike = ...,
            time_s: npt.ArrayLike = ...,
            normals: npt.ArrayLike = ...,
        ) -> None: ...

    def __post_init__(self) -> None:
        """Take over arrays of any real and whole type, and refuse what is no graph."""
        own = {
            "nodes": _matrix("nodes", self.nodes, 3, np.float64),
            "edges": _matrix("edges", self.edges, 2, np.int64),
            "radius_mm": np.array(self.radius_mm, np.float64).reshape(-1),
            "time_s": np.array(self.time_s, np.float64).reshape(-1),
            "normals": np.array(self.normals, np.float64).reshape(-1, 3),
        }
        nodes, edges = own["nodes"], own["edges"]
        if not np.isfinite(nodes).all():
            number = int((~np.isfinite(nodes).all(axis=1)).argmax())
            raise ModelError(f"node {number}: a coordinate must be finite")
        wrong = ((edges < 0) | (edges >= len(nodes))).any(axis=1)
        if wrong.any():
            number = int(wrong.argmax())
            msg = f"strut {number} is {edges[number].tolist()}: there are {len(nodes)} nodes"
            raise ModelError(msg)
        for name in ("radius_mm", "time_s", "normals"):
            if len(own[name]) not in (0, len(edges)):
                msg = f"{name} tells of {len(own[name])} struts; there are {len(edges)}"
                raise ModelError(msg)
            if not np.isfinite(own[name]).all():
                raise ModelError(f"{name}: every number must be finite")
        for name, values in own.items():
            object.__setattr__(self, name, sealed(values))

    def __len__(self) -> int:
        """Count the struts."""
        return len(self.edges)

    def __repr__(self) -> str:
        """Say how large it is."""
        size = np.ptp(self.nodes, axis=0) if len(self.nodes) else np.zeros(3)
        x, y, z = size
        return (
            f"<Graph {len(self)} struts, {len(self.nodes)} nodes, {x:.1f} x {y:.1f} x {z:.1f} mm>"
        )

    @property
    def ends(self) -> Floats:
        """Both ends of each strut, mm, (M, 2, 3)."""
        return sealed(np.asarray(self.nodes[self.edges], np.float64).reshape(-1, 2, 3))

    @classmethod
    def of_segments(cls, segments: npt.ArrayLike, **known: npt.ArrayLike) -> Graph:
        """Weld segments at their ends; those without length are left out.

        Parameters
        ----------
        segments
            Both ends of each, mm, (M, 2, 3).
        **known
            What is known of each: ``radius_mm``, ``time_s``, ``normals``.

        Returns
        -------
        Graph
            Struts in the order of the segments.
        """
        ends = np.asarray(segments, np.float64).reshape(-1, 3)
        edges, nodes = _welded(ends)
        pairs = edges.reshape(-1, 2)
        kept = pairs[:, 0] != pairs[:, 1]
        rest = {name: np.asarray(value)[kept] for name, value in known.items() if np.size(value)}
        return cls(nodes, pairs[kept], **rest)

    def tidied(self) -> Graph:
        """Weld near nodes, and keep each strut once: the first that is named.

        Returns
        -------
        Graph
            In the same order.
        """
        welded = Graph.of_segments(
            self.ends, radius_mm=self.radius_mm, time_s=self.time_s, normals=self.normals
        )
        _, first = np.unique(np.sort(welded.edges, axis=1), axis=0, return_index=True)
        return welded.chosen(np.sort(first))

    def chosen(self, numbers: npt.ArrayLike, reversed_: npt.ArrayLike | None = None) -> Graph:
        """Choose struts in some order.

        Parameters
        ----------
        numbers
            Of the struts, in the order wanted.
        reversed_
            Which of these are turned round, bool; None: none.

        Returns
        -------
        Graph
            Of the same nodes; with radii, times and normals where they are told.
        """
        which = np.asarray(numbers, np.int64)
        edges = self.edges[which]
        if reversed_ is not None:
            turned = np.asarray(reversed_, np.bool_)
            edges = np.where(turned[:, None], edges[:, ::-1], edges)
        known = {
            name: values[which] if len(values) else values
            for name in ("radius_mm", "time_s", "normals")
            for values in [getattr(self, name)]
        }
        return Graph(self.nodes, edges, **known)

    def moved(self, by_mm: npt.ArrayLike, scale: float = 1.0) -> Graph:
        """Scale it about the origin, then move it.

        Parameters
        ----------
        by_mm
            Way, mm, (3,).
        scale
            Factor, of radii, too.

        Returns
        -------
        Graph
            With the same struts.
        """
        nodes = self.nodes * scale + np.asarray(by_mm, np.float64)
        return Graph(nodes, self.edges, self.radius_mm * scale, self.time_s, self.normals)

    def turned(self, rotate_deg: tuple[float, float, float]) -> Graph:
        """Turn it about the origin: about x, then y, then z.

        Parameters
        ----------
        rotate_deg
            Angles, degrees.

        Returns
        -------
        Graph
            With the same struts; normals are turned, too.
        """
        if not any(rotate_deg):
            return self
        turn = np.eye(3)
        for axis, angle in enumerate(np.radians(rotate_deg)):
            one = np.eye(3)
            a, b = (axis + 1) % 3, (axis + 2) % 3
            one[[a, b], [a, b]] = np.cos(angle)
            one[b, a], one[a, b] = np.sin(angle), -np.sin(angle)
            turn = one @ turn
        nodes, normals = self.nodes @ turn.T, self.normals @ turn.T
        return Graph(nodes, self.edges, self.radius_mm, self.time_s, normals)

    def degrees(self) -> Ints:
        """Count the struts at each node.

        Returns
        -------
        ndarray
            (N,) int64.
        """
        return np.bincount(self.edges.ravel(), minlength=len(self.nodes))


def _matrix(name: str, given: npt.ArrayLike, columns: int, kind: type) -> npt.NDArray[np.float64]:
    try:
        found = np.asarray(given)
    except ValueError:
        raise ModelError(f"{name} are rows of different lengths") from None
    if not found.size:
        return np.empty((0, columns), kind)
    if found.dtype.kind not in ("iu" if kind is np.int64 else "fiu"):
        raise ModelError(f"{name} are of {found.dtype}; they must be {np.dtype(kind).name}")
    if found.ndim != 2 or found.shape[1] != columns:
        raise ModelError(f"{name} have shape {found.shape}; it must be (N, {columns})")
    return np.array(found, kind)


def _welded(points: Floats) -> tuple[Ints, Floats]:
    """Return the number of the node of each point, and the nodes, in the order of the points.

    Points in one cell of `SAME_MM` are one, and so are those of neighbouring cells that are near:
    the work grows with the points, however many coincide.
    """
    if not len(points):
        return np.empty(0, np.int64), points
    if not (np.abs(points) < _FARTHEST_MM).all():
        raise ModelError(f"a coordinate must be finite, and less than {_FARTHEST_MM:g} mm")
    cells = np.floor(points / SAME_MM).astype(np.int64) + _MIDDLE
    known, first, cell_of = np.unique(_keys(cells), return_index=True, return_inverse=True)
    some = cells[first]
    # Half of the cells around each: the other half finds it.
    around = [step for step in itertools.product((-1, 0, 1), repeat=3) if step > (0, 0, 0)]
    links = []
    for step in around:
        there = _keys(some + step)
        at = np.minimum(np.searchsorted(known, there), len(known) - 1)
        here = np.flatnonzero(known[at] == there)
        apart = points[first[here]] - points[first[at[here]]]
        near = here[np.linalg.norm(apart, axis=1) <= SAME_MM]
        links.append(np.column_stack([near, at[near]]))
    a, b = np.concatenate(links).T
    # The first point of a cluster stands for it.
    stands = first.copy()
    while True:
        before = stands.copy()
        np.minimum.at(stands, a, stands[b])
        np.minimum.at(stands, b, stands[a])
        stands = stands[cell_of[stands]]
        if np.array_equal(stands, before):
            break
    kept, numbers = np.unique(stands[cell_of], return_inverse=True)
    return numbers, points[kept]


def _keys(cells: Ints) -> npt.NDArray[np.void]:
    """Return cells as bytes that sort as their numbers do."""
    wide = np.ascontiguousarray(cells.astype(">i8"))
    return wide.view(np.dtype((np.void, wide.dtype.itemsize * 3))).reshape(-1)
