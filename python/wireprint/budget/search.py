"""The search for a print within a budget: what is tried, in which order, and what is best."""

from __future__ import annotations

import math
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Final, get_args

from wireprint import _core
from wireprint._core import UnprintableError, WireprintError
from wireprint.budget.figures import Alternative, Budget, BudgetError
from wireprint.choices import Pattern
from wireprint.duration import duration
from wireprint.filament import Filament
from wireprint.pipeline import make
from wireprint.rules import rules_of
from wireprint.threads import workers
from wireprint.wholeness import is_whole

if TYPE_CHECKING:
    from collections.abc import Iterable, Iterator

    from wireprint._core import Mesh
    from wireprint.regions import Region
    from wireprint.settings import Settings
    from wireprint.wire_print import WirePrint

#: Rungs of the ladder of slab heights, from the lowest slab to what the cone allows.
RUNGS: Final = 7
#: Prints that are tried at most.
MOST_TRIED: Final = 64
#: Floating-point operations that finding how far one print gives way may take: a second or so.
MOST_WORK: Final = 3e9
#: Of all posts this share gives way by no more than what is told: a single one tells of chance.
SHARE: Final = 0.95
#: Deviations below this are none, as a share of a strand's diameter: coordinates of slices are no
#: better.
_EXACT: Final = 0.05
#: What a knob's neighbours are, as factors on its value.
_STEPS: Final = {
    "wire.slab_max_mm": (0.85, 0.93, 1.08, 1.18),
    "wire.deviation_target_mm": (0.3, 3.0),
    "wire.cap_spacing_mm": (0.75, 1.33),
}
#: Digits of what is tried, so that `--set` repeats it.
_DIGITS: Final = 3

#: What is set otherwise than in the settings, by key.
Knobs = dict[str, Any]


@dataclass(frozen=True, slots=True)
class Tried:
    """A print that was timed, and judged where `good` is not None."""

    knobs: Knobs
    settings: Settings
    print_time_s: float
    filament_g: float
    #: Whether it is whole and keeps the rules.
    good: bool | None = None
    deviation_mm: float = 0.0
    coverage: float = 0.0
    #: How far `SHARE` of its posts give way, mm: in the frame as it grows (None: too much work),
    #: and each by itself.
    grown_mm: float | None = None
    single_mm: float = 0.0


class Search:
    """One search; what was tried is kept by its knobs, so nothing is made twice."""

    def __init__(
        self,
        mesh: Mesh,
        settings: Settings,
        budget: Budget,
        region: Region | None,
        fixed: frozenset[str],
    ) -> None:
        self.mesh, self.settings, self.budget, self.region = mesh, settings, budget, region
        self.fixed = fixed
        self.tried: dict[tuple[Any, ...], Tried | WireprintError] = {}

    def best_of_all(self) -> Tried:
        """Climb the ladder, then walk downhill in each pattern, where no neighbour is better."""
        self._try(self._ladder())
        patterns = list(dict.fromkeys(one.settings.wire.pattern for one in self._timed()))
        for pattern in patterns:
            self._approach(pattern)
        self._judge_the_next()
        # The best first: there may be prints left to try for one alone.
        patterns.sort(key=lambda pattern: self._rank(self._best(pattern)))
        for pattern in patterns:
            self._walk(pattern)
        best = self._best()
        if best is None:
            raise self._refusal()
        return best

    def _walk(self, pattern: Pattern) -> None:
        """Try the neighbours of a pattern's best print, as long as one of them is better."""
        best = self._best(pattern)
        while best is not None:
            self._try(self._neighbours(best.knobs))
            better = self._best(pattern)
            best = None if better is best else better

    def _approach(self, pattern: Pattern) -> None:
        """Walk towards a pattern's least where nothing of it yet keeps within the budget."""
        while self._best(pattern) is None:
            least = min(self._timed(pattern), key=self._excess)
            self._try(self._neighbours(least.knobs))
            if min(self._timed(pattern), key=self._excess) is least:
                return

    @property
    def give_by(self) -> str:
        """What stiffness is told by: the same for all prints, lest they be compared unlike."""
        grown = all(one.grown_mm is not None for one in self._good())
        return "growth" if grown else "single posts"

    def front(self, best: Tried) -> tuple[Alternative, ...]:
        """Return what no other print beats, and the best."""
        every = [
            Alternative(
                _overrides(one.knobs),
                one.print_time_s,
                one.filament_g,
                one.deviation_mm,
                self._give_mm(one),
                one.coverage,
                self._allows(one),
                one is best,
            )
            for one in self._good()
        ]
        kept = [one for one in every if one.chosen or not any(o.beats(one) for o in every)]
        kept.sort(key=lambda one: (one.print_time_s, one.deviation_mm, one.overrides))
        return tuple(kept)

    def _ladder(self) -> Iterator[Knobs]:
        high, low = self.settings.slab_max_mm, self.settings.slab_min_mm
        ratio = (low / high) ** (1 / (RUNGS - 1))
        for pattern in get_args(Pattern):
            for rung in range(RUNGS):
                height = high * ratio**rung
                yield self._knobs({"wire.pattern": pattern, "wire.slab_max_mm": height})

    def _neighbours(self, knobs: Knobs) -> Iterator[Knobs]:
        own = {"wire.slab_max_mm": self.settings.slab_max_mm}
        for key, factors in _STEPS.items():
            name = key.removeprefix("wire.")
            value = knobs.get(key, own.get(key, getattr(self.settings.wire, name)))
            for factor in factors:
                yield self._knobs(knobs | {key: value * factor})

    def _knobs(self, changes: Knobs) -> Knobs:
        """Return what is set otherwise, within its bounds and rounded as it is written."""
        wire = self.settings.wire
        found = {key: value for key, value in changes.items() if key not in self.fixed}
        if not wire.caps:
            found.pop("wire.cap_spacing_mm", None)
        highest = found.get("wire.slab_max_mm")
        if highest is not None:
            least = wire.slab_min_mm or self.settings.printer.head.nozzle_mm
            highest = max(least, min(self.settings.printer.head.cone_height_mm, highest))
            found["wire.slab_max_mm"] = highest
            # A slab is two nozzles high at least, unless lower ones are asked for.
            found.pop("wire.slab_min_mm", None)
            if highest < self.settings.slab_min_mm:
                found["wire.slab_min_mm"] = highest
        return {
            key: round(value, _DIGITS) if isinstance(value, float) else value
            for key, value in found.items()
        }

    def _try(self, several: Iterable[Knobs]) -> None:
        """Make what is new, and judge what keeps within the budget."""
        new = {_name(knobs): knobs for knobs in several if _name(knobs) not in self.tried}
        names = list(new)[: max(0, MOST_TRIED - len(self.tried))]
        with ThreadPoolExecutor(workers()) as pool:
            found = pool.map(lambda name: self._made(new[name]), names)
            self.tried.update(zip(names, found, strict=True))

    def _judge_the_next(self) -> None:
        """Judge, of each pattern, the least that is over the budget: the front shows it, too."""
        over = [one for one in self._timed() if one.good is None]
        over.sort(key=self._excess)
        patterns = {one.settings.wire.pattern: one for one in reversed(over)}
        for one in patterns.values():
            self.tried[_name(one.knobs)] = self._made(one.knobs, judge=True)

    def _made(self, knobs: Knobs, *, judge: bool = False) -> Tried | WireprintError:
        try:
            settings = self.settings.but(overrides=_overrides(knobs)) if knobs else self.settings
            made = make(self.mesh, settings, self.region, certify=False, partial=True)
            timed = Tried(knobs, settings, *_takes(made))
            if not judge and not self._allows(timed):
                return timed
            # The plan is taken on; mending may take strands away, and lower slabs take longer.
            made = make(self.mesh, settings, self.region, partial=True, kept=made.sketch)
        except WireprintError as error:
            return error
        return _judged(knobs, settings, made)

    def _timed(self, pattern: Pattern | None = None) -> list[Tried]:
        timed = (one for one in self.tried.values() if isinstance(one, Tried))
        return [one for one in timed if pattern in (None, one.settings.wire.pattern)]

    def _good(self) -> list[Tried]:
        return [one for one in self._timed() if one.good]

    def _give_mm(self, one: Tried) -> float:
        grown_mm = one.grown_mm if self.give_by == "growth" else None
        return one.single_mm if grown_mm is None else grown_mm

    def _best(self, pattern: Pattern | None = None) -> Tried | None:
        good = (one for one in self._timed(pattern) if one.good and self._allows(one))
        return min(good, key=self._rank, default=None)

    def _rank(self, one: Tried | None) -> tuple[float, float]:
        """Return what tells the better of two: the less."""
        if one is None:
            return math.inf, math.inf
        least_mm = _EXACT * self.settings.strand_mm
        return max(one.deviation_mm, least_mm) * self._give_mm(one), one.print_time_s

    def _allows(self, one: Tried) -> bool:
        return self._excess(one) <= 1.0

    def _excess(self, one: Tried) -> float:
        return self.budget.excess(one.print_time_s, one.filament_g)

    def _refusal(self) -> WireprintError:
        """Say what the least is that was found, or why nothing is printed at all."""
        for one in sorted(self._timed(), key=self._excess):
            found = one if one.good is not None else self._made(one.knobs, judge=True)
            if isinstance(found, Tried) and found.good:
                sets = "".join(f" --set {override}" for override in _overrides(found.knobs))
                return BudgetError(
                    f"no print keeps within {self.budget}: the least that is certified, of "
                    f"{len(self.tried)} that were tried, takes {duration(found.print_time_s)} and "
                    f"{found.filament_g:.1f} g (with{sets or ' the settings as they are'}); a "
                    "smaller --scale takes less"
                )
        errors = [one for one in self.tried.values() if isinstance(one, WireprintError)]
        if errors and len(errors) == len(self.tried):
            return errors[0]
        return UnprintableError(
            f"none of {len(self.tried)} prints that were tried is whole and keeps the rules; "
            "without a budget it is told what is wrong"
        )


def _judged(knobs: Knobs, settings: Settings, made: WirePrint) -> Tried:
    certificate = made.certificate
    fidelity = None if certificate is None else certificate.fidelity
    if certificate is None or fidelity is None or not certificate.ok:
        return Tried(knobs, settings, *_takes(made), good=False)
    pull_n = settings.wire.pull_n
    peaks = _core.growth(made.gcode, rules_of(settings), settings.material.modulus_mpa, MOST_WORK)
    return Tried(
        knobs,
        settings,
        *_takes(made),
        good=is_whole(certificate, settings),
        deviation_mm=fidelity.chord_deviation_mm or 0.0,
        coverage=fidelity.coverage,
        grown_mm=None if peaks is None else pull_n * _share(peak[2] for peak in peaks),
        single_mm=pull_n * _single(made),
    )


def _takes(made: WirePrint) -> tuple[float, float]:
    """Return time, s, and filament, g, of a print."""
    grams = Filament.of(made.settings).grams(made.estimate.filament_mm)
    return made.estimate.total_s, grams


def fixed_knobs(settings: Settings) -> frozenset[str]:
    """Return the knobs that the user turned already."""
    fields = type(settings.wire).model_fields
    names = ("pattern", *(key.removeprefix("wire.") for key in _STEPS))
    turned = {name for name in names if getattr(settings.wire, name) != fields[name].default}
    return frozenset(f"wire.{name}" for name in turned)


def _overrides(knobs: Knobs) -> tuple[str, ...]:
    return tuple(f"{key}={value}" for key, value in sorted(knobs.items()))


def _name(knobs: Knobs) -> tuple[Any, ...]:
    return tuple(sorted(knobs.items()))


def _share(values: Iterable[float]) -> float:
    """Return what `SHARE` of the values do not exceed; 0 without any."""
    ordered = sorted(values)
    return ordered[math.ceil(SHARE * len(ordered)) - 1] if ordered else 0.0


def _single(made: WirePrint) -> float:
    """Return how far `SHARE` of the posts give way each by itself, mm/N.

    Notes
    -----
    A round cantilever: L³ / (3 E I), with I = π d⁴ / 64 (Gere, *Mechanics of Materials*).
    """
    settings = made.settings
    inertia_mm4 = math.pi / 64 * settings.strand_mm**4
    bending = 3 * settings.material.modulus_mpa * inertia_mm4
    return _share(math.dist(*ends) ** 3 / bending for ends in made.wireframe.posts.tolist())
