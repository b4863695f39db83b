"""A print as a frame of straight beams, solved as a whole: for what a growing one does not tell.

Beams are cold, of one section, and rigidly joined where strands touch; see ``docs/forecast.md``.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from importlib.util import find_spec
from typing import TYPE_CHECKING, Any, Final

import numpy as np

from wireprint import _core
from wireprint.rules import rules_of

if TYPE_CHECKING:
    import numpy.typing as npt

    from wireprint.settings import Settings

    Array = npt.NDArray[np.float64]
    Whole = npt.NDArray[np.int64]

#: Poisson's ratio of the usual plastics; it matters to twist alone.
_POISSON: Final = 0.38


class NoSolverError(RuntimeError):
    """There is no scipy."""


def can_solve() -> bool:
    """Whether there is scipy."""
    return find_spec("scipy") is not None


@dataclass(frozen=True)
class Frame:
    """Beams between nodes, in the order of printing."""

    #: Nodes, mm, (N, 3), and whether each lies on the bed.
    places: Array
    on_bed: npt.NDArray[np.bool_]
    #: Nodes at the ends of each beam, (M, 2), and strand and line that it is a piece of.
    ends: Whole
    strands: Whole
    lines: npt.NDArray[np.uint64]

    @classmethod
    def of(cls, gcode: bytes, settings: Settings) -> Frame:
        """Read the frame that a text leaves."""
        places, on_bed, ends, strands, lines = _core.frame(gcode, rules_of(settings))
        return cls(places, on_bed, ends.astype(np.int64), strands.astype(np.int64), lines)

    def only(self, kept: npt.NDArray[np.bool_]) -> Frame:
        """Return the frame of some beams, its nodes renumbered."""
        nodes, numbered = np.unique(self.ends[kept], return_inverse=True)
        ends = numbered.reshape(-1, 2)
        strands, lines = self.strands[kept], self.lines[kept]
        return Frame(self.places[nodes], self.on_bed[nodes], ends, strands, lines)

    def largest(self) -> Frame:
        """Return the piece of which most strand hangs together.

        Raises
        ------
        NoSolverError
            There is no scipy.
        """
        if not len(self.ends):
            return self
        of_beam = self._pieces()[self.ends[:, 0]]
        lengths = np.linalg.norm(self.runs(), axis=1)
        return self.only(of_beam == np.argmax(np.bincount(of_beam, lengths)))

    def about(self, place_mm: Array) -> Frame:
        """Return the piece that hangs together with the node nearest to a place.

        Raises
        ------
        NoSolverError
            There is no scipy.
        """
        if not len(self.ends):
            return self
        piece = self._pieces()
        nearest = np.argmin(np.linalg.norm(self.places - place_mm, axis=1))
        return self.only(piece[self.ends[:, 0]] == piece[nearest])

    def _pieces(self) -> Whole:
        """Return the number of the piece that each node is in."""
        try:
            from scipy.sparse import coo_matrix
            from scipy.sparse.csgraph import connected_components
        except ImportError as error:
            raise NoSolverError from error
        size = (len(self.places), len(self.places))
        graph = coo_matrix((np.ones(len(self.ends)), self.ends.T), shape=size)
        piece: Whole = connected_components(graph, directed=False)[1].astype(np.int64)
        return piece

    def runs(self) -> Array:
        """Return from where to where each beam goes, mm, (M, 3)."""
        runs: Array = self.places[self.ends[:, 1]] - self.places[self.ends[:, 0]]
        return runs


def flexibility(frame: Frame, strand_mm: float, modulus_mpa: float) -> tuple[Array, Array]:
    """Return for each beam what its end gives under loads there, and how its start carries it.

    Shapes (M, 6, 6): three shifts, mm, then three turns, under forces, N, and moments, N·mm.
    """
    run = frame.runs()
    length = np.linalg.norm(run, axis=1)[:, None, None]
    along = run / length[:, 0]
    axial = along[:, :, None] * along[:, None, :]
    lateral = np.eye(3) - axial
    area, inertia = math.pi * strand_mm**2 / 4, math.pi * strand_mm**4 / 64
    bend = 1 / (modulus_mpa * inertia)
    twist = (1 + _POISSON) * bend
    flexible = np.zeros((len(run), 6, 6))
    flexible[:, :3, :3] = length / (modulus_mpa * area) * axial + length**3 / 3 * bend * lateral
    flexible[:, 3:, 3:] = length * twist * axial + length * bend * lateral
    coupled = length**2 / 2 * bend * skew(along)
    flexible[:, :3, 3:], flexible[:, 3:, :3] = -coupled, coupled
    carried = np.tile(np.eye(6), (len(run), 1, 1))
    carried[:, :3, 3:] = -skew(run)
    return flexible, carried


def skew(vectors: Array) -> Array:
    """Return the matrices of cross products with vectors, of shape (N, 3, 3)."""
    found = np.zeros((len(vectors), 3, 3))
    for i, j, k in ((0, 1, 2), (1, 2, 0), (2, 0, 1)):
        found[:, i, j], found[:, j, i] = -vectors[:, k], vectors[:, k]
    return found


def shifts_under(
    frame: Frame, flexible: tuple[Array, Array], held: npt.NDArray[np.bool_], loads: list[Array]
) -> list[Array]:
    """Return shifts (mm) and turns of all nodes, (N, 6), under forces on nodes, N, (N, 3).

    Parameters
    ----------
    frame, flexible
        The frame, and its `flexibility`.
    held
        Nodes that do not move, (N,): enough that nothing is loose.
    loads
        One case after the other.
    """
    from scipy.sparse import coo_matrix
    from scipy.sparse.linalg import splu

    gives, carried = flexible
    strain = np.concatenate([-carried, np.tile(np.eye(6), (len(gives), 1, 1))], axis=2)
    stiff = strain.transpose(0, 2, 1) @ np.linalg.inv(gives) @ strain
    degrees = (6 * frame.ends[:, :, None] + np.arange(6)).reshape(-1, 12)
    rows, columns = np.repeat(degrees, 12, axis=1), np.tile(degrees, (1, 12))
    size = 6 * len(frame.places)
    whole = coo_matrix((stiff.ravel(), (rows.ravel(), columns.ravel())), shape=(size, size)).tocsc()
    free = np.flatnonzero(np.repeat(~held, 6))
    solver = splu(
        whole[free][:, free].tocsc(),
        permc_spec="MMD_AT_PLUS_A",
        diag_pivot_thresh=0.0,
        options={"SymmetricMode": True},
    )
    found = []
    for load in loads:
        forces = np.zeros((len(frame.places), 6))
        forces[:, :3] = load
        shifts: Array = np.zeros(size)
        shifts[free] = solver.solve(forces.ravel()[free])
        found.append(shifts.reshape(-1, 6))
    return found


def strain_energies(frame: Frame, flexible: tuple[Array, Array], shifts: Array) -> Array:
    """Return the energy that each beam holds, N·mm, (M,), by shifts and turns of all nodes."""
    strain, loads = _strained(frame, flexible, shifts)
    energies: Array = np.einsum("ni,ni->n", strain, loads) / 2
    return energies


def stresses(
    frame: Frame, flexible: tuple[Array, Array], shifts: Array, strand_mm: float
) -> tuple[Array, Array]:
    """Return the greatest stress in each strand, and in each beam, MPa (von Mises, at an end)."""
    _, loads = _strained(frame, flexible, shifts)
    run = frame.runs()
    along = run / np.linalg.norm(run, axis=1)[:, None]
    force, moment = loads[:, :3], loads[:, 3:]
    other = moment + np.cross(run, force)
    pull = abs(np.einsum("ni,ni->n", force, along))
    twist = abs(np.einsum("ni,ni->n", moment, along))
    bends = [np.linalg.norm(np.cross(one, along), axis=1) for one in (moment, other)]
    area, module = math.pi * strand_mm**2 / 4, math.pi * strand_mm**3 / 32
    drawn = pull / area + np.maximum(*bends) / module
    by_beam = np.sqrt(drawn**2 + 3 * (twist / (2 * module)) ** 2)
    by_strand = np.zeros(int(frame.strands.max()) + 1)
    np.maximum.at(by_strand, frame.strands, by_beam)
    return by_strand[np.unique(frame.strands)], by_beam


def _strained(frame: Frame, flexible: tuple[Array, Array], shifts: Array) -> tuple[Array, Array]:
    """Return by how much each beam is strained, and the loads at its end: (M, 6) each."""
    gives, carried = flexible
    start, end = shifts[frame.ends[:, 0]], shifts[frame.ends[:, 1]]
    strain = end - np.einsum("nij,nj->ni", carried, start)
    loads: Any = np.linalg.solve(gives, strain[:, :, None])[:, :, 0]
    return strain, loads
