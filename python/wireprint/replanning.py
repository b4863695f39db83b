"""Prints planned anew with lower slabs where the first plan falls short."""

from __future__ import annotations

import json
from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING, Final

from wireprint._core import WireprintError
from wireprint.gcode import document
from wireprint.mending import judged
from wireprint.stages import toolpath, wireframe

if TYPE_CHECKING:
    from collections.abc import Callable, Iterable

    from wireprint._core import Mesh, Wireframe
    from wireprint.certificate import Certificate
    from wireprint.fidelity import Fidelity
    from wireprint.settings import Settings

#: Bands that `wire.low_slabs_mm` takes.
_MOST_BANDS: Final = 50


@dataclass(frozen=True)
class Plan:
    """A plan; what is known of its print is found out when it is first asked for."""

    mesh: Mesh
    settings: Settings
    wireframe: Wireframe

    @cached_property
    def fidelity(self) -> Fidelity | None:
        """What its print covers; None if it breaks the rules."""
        if not self.wireframe.strand_count:
            return None
        try:
            verdict = judged(self.wireframe, self.settings, mesh=self.mesh)
        except WireprintError:
            return None
        return verdict.fidelity if verdict.ok else None

    @cached_property
    def time_s(self) -> float:
        """What its print takes, s, but for heating and homing."""
        path = toolpath(self.wireframe, self.settings)
        return document.timing(document.commands(path, self.settings), self.settings).total_s

    @property
    def braced(self) -> float:
        """Diagonals per post."""
        return self.wireframe.diagonal_count / max(1, self.wireframe.post_count)

    def lower(self, bands: Iterable[tuple[float, float, float]]) -> Plan | None:
        """Plan anew with lower slabs besides those that it has; None where there is no plan.

        Parameters
        ----------
        bands
            From which height to which slabs are lower, and their greatest height, mm.
        """
        added = [[round(value, 3) for value in band] for band in bands]
        bands_mm = [*map(list, self.settings.wire.low_slabs_mm), *added][:_MOST_BANDS]
        try:
            settings = self.settings.but(overrides=[f"wire.low_slabs_mm={json.dumps(bands_mm)}"])
            return Plan(self.mesh, settings, wireframe(self.mesh, settings))
        except WireprintError:
            return None


def replanned(
    mesh: Mesh,
    settings: Settings,
    strands: Wireframe,
    certificate: Certificate | None,
    on_step: Callable[[str], None] = lambda _: None,
) -> tuple[Settings, Wireframe] | None:
    """Plan a print anew where it would be bare, or where few diagonals brace it.

    Parameters
    ----------
    mesh
        The model as it stands on the bed.
    settings, strands
        Its first plan.
    certificate
        The verdict on that, with what it covers; None: it is judged here.
    on_step
        Called before each print that is tried; it may raise to give up.

    Returns
    -------
    tuple of Settings and Wireframe, or None
        The plan to print, and what it was made with; None: the first one.
    """
    from wireprint.bracing import braced
    from wireprint.lowering import lowered

    first = Plan(mesh, settings, strands)
    known = certificate or (judged(strands, settings, mesh=mesh) if strands.strand_count else None)
    if known is None or known.fidelity is None:
        return None
    plan = lowered(first, known.fidelity, on_step)
    plan = braced(plan, on_step)
    return None if plan is first else (plan.settings, plan.wireframe)
