"""Hybrid prints that keep the rules: what breaks them stays wire, and is named."""

from __future__ import annotations

from dataclasses import dataclass
from functools import partial
from typing import TYPE_CHECKING, Any, Final

import numpy as np

from wireprint._core import KINDS
from wireprint.cascade import length_mm
from wireprint.certificate import check
from wireprint.gcode import file
from wireprint.hybrid.plan import Plan
from wireprint.mending import mended
from wireprint.records import Record, sealed
from wireprint.stages import toolpath, wireframe

if TYPE_CHECKING:
    from collections.abc import Callable, Mapping

    import numpy.typing as npt

    from wireprint._core import Toolpath, Wireframe
    from wireprint.certificate import Certificate
    from wireprint.gcode.file import Written
    from wireprint.hybrid.sketch import Sketch
    from wireprint.regions import Region
    from wireprint.settings import Settings

_LAYERS: Final = (KINDS.index("layer-wise"), KINDS.index("layer-fill"))
#: Most prints that are tried; then all stays wire.
_ROUNDS: Final = 8
#: Breaches at ends that other places may hold.
_LOOSE: Final = ("floating_starts", "dangling_ends", "hurried")
#: An end is a line's if it lies this near to it, mm: G-code has thousandths, along each axis.
_RESOLVED_MM: Final = 0.01
#: Lines of layers are mended where breaches are in at most so many prints, one after the other, …
_MENDINGS: Final = 72
#: … and what is left out of them is at most this part of what dropping runs would cost.
_CHEAPER: Final = 0.5
#: Breaches of a rule → why a run is not printed as layers. What breaks others, no run does.
_REASONS: Final = {
    "collisions": "in_the_way",
    "floating_starts": "overhang",
    "dangling_ends": "overhang",
    "spans_over": "wide_bridge",
    "out_of_bounds": "no_room",
    "underfed": "wide_bridge",
    "hurried": "overhang",
}


def _middle(span: Any) -> npt.NDArray[np.float64]:
    """Return the middle of a span: both its ends lie on something else."""
    middle: npt.NDArray[np.float64] = np.mean([span.from_mm, span.to_mm], axis=0)
    return middle


def _at(breach: Any) -> npt.NDArray[np.float64]:
    return np.array(breach.at_mm)


#: Where each kind of breach is.
_PLACES: Final[dict[str, Callable[[Any], npt.NDArray[np.float64]]]] = {
    "collisions": lambda hit: np.array(hit.tip_mm),
    "floating_starts": _at,
    "dangling_ends": _at,
    "spans_over": _middle,
    "out_of_bounds": _at,
    "underfed": _at,
    "hurried": _at,
}


@dataclass(frozen=True, repr=False)
class Proved(Record):
    """A print with layers, as far as it keeps the rules."""

    plan: Plan
    wireframe: Wireframe
    toolpath: Toolpath
    #: How many prints were tried.
    rounds: int
    #: The file, and the verdict on it.
    written: Written
    verdict: Certificate
    #: Length of the pieces of lines that it does without, mm.
    trimmed_mm: float = 0.0

    @property
    def runs(self) -> dict[str, npt.NDArray[Any]]:
        """The runs of zigzag sections that are layers, as arrays of shape (R,).

        ``slab`` and ``contour`` (in the slice at the slab's top, as in
        `Wireframe.contours_below`; −1 where the strip has none, or several), int64; ``from_mm``
        and ``to_mm`` along that contour and ``area_mm2`` of the surface, float64.
        """
        runs = self.plan.sections
        found: dict[str, npt.NDArray[Any]] = {
            "slab": np.array([run.slab for run in runs], np.int64),
            "contour": np.array([run.contour for run in runs], np.int64),
            "from_mm": np.array([run.from_mm for run in runs], np.float64),
            "to_mm": np.array([run.to_mm for run in runs], np.float64),
            "area_mm2": np.array([run.area_mm2 for run in runs], np.float64),
        }
        return sealed(found)

    @property
    def layer_wise_mm(self) -> float:
        """Length of all strands of layers, mm."""
        return _layers_mm(self.wireframe)


def proved(
    sketch: Sketch,
    region: Region,
    on_step: Callable[[str], None] = lambda _: None,
    write: Callable[[Toolpath], Written] | None = None,
    draft: Callable[[Toolpath], Written] | None = None,
) -> Proved:
    """Print a region as layers, without the runs that break the rules.

    Parameters
    ----------
    sketch
        The model and its plain wire print.
    region
        What is marked, in the mesh's coordinates.
    on_step
        Called before each step with its name; it may raise to give up.
    write
        Makes the file that is judged; default: one without pictures.
    draft
        Makes what is judged while lines are mended, where that takes less; default: the file.

    Notes
    -----
    Each print is judged as `check` judges a file. Where pieces of layers' lines break the rules, it
    does without them if they are few. Else lines look for other places to begin and end, once; if
    that does not help, either, a breach within the fill behind walls leaves its slab hollow, and
    any other is put down to the run that is nearest to it, which is dropped; after so many rounds,
    all are.
    """
    mesh, settings = sketch.mesh, sketch.settings
    write = write or partial(file.write, settings=settings)

    def attempt(strands: Wireframe, write: Callable[[Toolpath], Written] = write) -> _Attempt:
        on_step(f"moves, round {rounds}")
        path = toolpath(strands, settings)
        on_step(f"file, round {rounds}")
        written = write(path)
        on_step(f"proof, round {rounds}")
        return _Attempt(strands, path, written, check(written.text, settings))

    on_step("marks")
    plan = Plan.of(sketch, region)
    without: Plan | None = None
    for rounds in range(1, _ROUNDS + 1):
        on_step(f"layers, round {rounds}")
        layered = plan.layered(on_step)
        if layered is None and without is not None:
            plan, without = without, None
            layered = plan.layered(on_step)
        if layered is None:
            break
        on_step(f"wire beside layers, round {rounds}")
        first = attempt(wireframe(mesh, settings, layered, plain=sketch.plain))
        blamed, hollow = _blamed(plan, first.verdict, settings)
        if not (blamed or hollow):
            return first.proved(plan, rounds)
        trimmed = _trimmed(plan, first, blamed, partial(attempt, write=draft or write), on_step)
        if trimmed is not None:
            lost_mm = length_mm(first.strands.strands) - length_mm(trimmed.strands)
            return attempt(trimmed).proved(plan, rounds, lost_mm)
        loose = _loose(first, settings)
        if rounds == 1 and len(loose):
            plan, without = plan.avoiding(loose), plan.without(blamed, hollow)
            continue
        if rounds == _ROUNDS:
            blamed = dict.fromkeys(range(len(plan.sections)), "unproved") | blamed
        plan, without = without or plan.without(blamed, hollow), None
    return attempt(sketch.plain).proved(plan, rounds)


@dataclass(frozen=True)
class _Attempt:
    """A print that was judged."""

    strands: Wireframe
    path: Toolpath
    written: Written
    verdict: Certificate

    def proved(self, plan: Plan, rounds: int, trimmed_mm: float = 0.0) -> Proved:
        """Return it as the answer to a plan."""
        return Proved(plan, self.strands, self.path, rounds, self.written, self.verdict, trimmed_mm)


def _trimmed(
    plan: Plan,
    first: _Attempt,
    blamed: Mapping[int, str],
    attempt: Callable[[Wireframe], _Attempt],
    on_step: Callable[[str], None],
) -> Wireframe | None:
    """Leave out of a print the strands that break the rules, mostly pieces of layers' lines.

    None where that does not help, or costs much of what dropping the runs that are to blame would.
    """
    area_mm2 = np.array([run.area_mm2 for run in plan.sections])
    blamed_mm2 = float(area_mm2[list(blamed)].sum())
    at_stake = blamed_mm2 / max(float(area_mm2.sum()), 1e-9) if blamed else 1.0
    return mended(
        first.strands,
        first.verdict,
        plan.settings,
        rounds=_MENDINGS,
        most_mm=_CHEAPER * at_stake * _layers_mm(first.strands),
        judge=lambda left: attempt(left).verdict,
        on_round=lambda: on_step("what falls with what breaks a rule"),
    )


def _loose(found: _Attempt, settings: Settings) -> npt.NDArray[np.float64]:
    """Return where layers' lines begin or end in the air, shape (P, 3), mm."""
    centre = np.array([*settings.printer.bed.centre_mm, 0.0])
    strands, breaches = found.strands, found.verdict.breaches()
    ends = strands.strands[np.isin(strands.strand_kinds, _LAYERS)].reshape(-1, 3)
    places = np.array([_at(breach) - centre for name in _LOOSE for breach in breaches[name]])
    places = places.reshape(-1, 3)
    off = [np.min(np.sum((ends - place) ** 2, axis=1), initial=np.inf) for place in places]
    return places[np.array(off) <= _RESOLVED_MM**2]


def _layers_mm(strands: Wireframe) -> float:
    return length_mm(strands.strands[np.isin(strands.strand_kinds, _LAYERS)])


def _blamed(
    plan: Plan, verdict: Certificate, settings: Settings
) -> tuple[dict[int, str], dict[int, str]]:
    """Return what is to be done without, with the reason for each: runs, and the inside of slabs.

    A breach is put down to the fill behind the walls if that is there, else to the nearest run.
    """
    painted = np.flatnonzero(plan.runs.of_sample >= 0)
    middles = plan.samples.middle[painted]
    centre = np.array([*settings.printer.bed.centre_mm, 0.0])
    blamed: dict[int, str] = {}
    hollow: dict[int, str] = {}
    for name in _REASONS:
        for breach in verdict.breaches()[name]:
            place = _PLACES[name](breach) - centre
            slab = plan.filled_at(place)
            if slab is not None:
                hollow.setdefault(slab, _REASONS[name])
            elif len(painted):
                nearest = painted[np.argmin(np.sum((middles - place) ** 2, axis=1))]
                blamed.setdefault(int(plan.runs.of_sample[nearest]), _REASONS[name])
    return blamed, hollow
