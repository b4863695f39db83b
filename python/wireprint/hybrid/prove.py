"""Hybrid prints that keep the rules: what breaks them stays wire, and is named."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Final

import numpy as np

from wireprint.certificate import check
from wireprint.gcode import document
from wireprint.gcode.flavors import KINDS
from wireprint.hybrid.plan import Plan
from wireprint.stages import toolpath, wireframe

if TYPE_CHECKING:
    from wireprint._core import Mesh, Toolpath, Wireframe
    from wireprint.certificate import Certificate
    from wireprint.regions import Region
    from wireprint.settings import Settings

_LAYERWISE: Final = KINDS.index("layer-wise")
#: Most prints that are tried; then all stays wire.
_ROUNDS: Final = 8
#: Breaches of a rule → why a run is not printed as layers.
_REASONS: Final = {
    "collisions": "in_the_way",
    "floating_starts": "overhang",
    "dangling_ends": "overhang",
    "spans_over": "wide_bridge",
}
#: Where each kind of breach is.
_PLACES: Final = {
    "collisions": "tip_mm",
    "floating_starts": "at_mm",
    "dangling_ends": "at_mm",
    "spans_over": "from_mm",
}


@dataclass(frozen=True)
class Proved:
    """A print with layers, as far as it keeps the rules."""

    plan: Plan
    wireframe: Wireframe
    toolpath: Toolpath
    #: How many prints were tried.
    rounds: int

    @property
    def layer_wise_mm(self) -> float:
        """Length of all strands of layers, mm."""
        own = self.wireframe.strands[self.wireframe.strand_kinds == _LAYERWISE]
        return float(np.sum(np.linalg.norm(own[:, 1] - own[:, 0], axis=1)))


def proved(mesh: Mesh, plain: Wireframe, region: Region, settings: Settings) -> Proved:
    """Print a region as layers, without the runs that break the rules.

    Parameters
    ----------
    mesh
        The model as it stands on the bed.
    plain
        Its plain wire print.
    region
        What is marked, in the mesh's coordinates.
    settings
        Printer, material, way of wiring and of printing regions.

    Notes
    -----
    Each print is judged as `check` judges a file. A breach is put down to the run that is nearest
    to it, which is dropped; after so many rounds, all are.
    """
    plan = Plan.of(mesh, plain, region, settings)
    for rounds in range(1, _ROUNDS + 1):
        layered = plan.layered()
        if layered is None:
            break
        strands = wireframe(mesh, settings, layered)
        path = toolpath(strands, settings)
        verdict = check(document.body(path, settings, document.dated(None)), settings)
        blamed = _blamed(plan, verdict, settings)
        if not blamed:
            return Proved(plan, strands, path, rounds)
        if rounds == _ROUNDS:
            blamed = dict.fromkeys(range(len(plan.sections)), "unproved") | blamed
        plan = plan.without(blamed)
    return Proved(plan, plain, toolpath(plain, settings), rounds)


def _blamed(plan: Plan, verdict: Certificate, settings: Settings) -> dict[int, str]:
    """Return the runs nearest to breaches of the rules, with the reason for each."""
    painted = np.flatnonzero(plan.runs.of_sample >= 0)
    middles = plan.samples.middle[painted]
    centre = np.array([*settings.printer.bed.centre_mm, 0.0])
    blamed: dict[int, str] = {}
    for name, breaches in verdict.breaches().items():
        if name not in _REASONS:
            continue
        for breach in breaches:
            place = np.array(getattr(breach, _PLACES[name])) - centre
            nearest = painted[np.argmin(np.sum((middles - place) ** 2, axis=1))]
            blamed.setdefault(int(plan.runs.of_sample[nearest]), _REASONS[name])
    return blamed
