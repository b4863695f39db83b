"""Prints planned anew with lower slabs where the first plan falls short."""

from __future__ import annotations

from typing import TYPE_CHECKING

from wireprint.bracing import braced
from wireprint.lowering import lowered
from wireprint.mending import judged
from wireprint.wire_plan import Plan

if TYPE_CHECKING:
    from collections.abc import Callable

    from wireprint._core import Mesh, Wireframe
    from wireprint.certificate import Certificate
    from wireprint.settings import Settings


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
    first = Plan(mesh, settings, strands)
    known = certificate or (judged(strands, settings, mesh=mesh) if strands.strand_count else None)
    if known is None or known.fidelity is None:
        return None
    plan = lowered(first, known.fidelity, on_step)
    plan = braced(plan, on_step)
    return None if plan is first else (plan.settings, plan.wireframe)
