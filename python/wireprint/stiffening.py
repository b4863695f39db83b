"""Prints that would give way: made anew with thicker strands, lower slabs, other posts.

Asked for by a forecast alone. What is tried is made and forecast like any print. Thicker strands
come first, for they cost least: a print that gives way everywhere does so in a few places then.
About those, and where what bends is, slabs are made lower; throughout only where nothing less
helps. Posts that are placed by the other rule, and supports that are left out where that leaves no
more of the model bare, are tried with thicker strands. Of what was tried, that which gains most for
its time is gone on with, until something suffices; of all that suffice the quickest is taken, else
the one that gives way least.
"""

from __future__ import annotations

import json
import math
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Any, Final

from wireprint._core import WireprintError
from wireprint.bands import Band, joined
from wireprint.forecast import simulate
from wireprint.pipeline import make
from wireprint.softness import about_fingers, about_misses, share_of, that_bends
from wireprint.threads import workers
from wireprint.wholeness import is_whole

if TYPE_CHECKING:
    from collections.abc import Iterator

    from wireprint._core import Mesh
    from wireprint.forecast import Forecast
    from wireprint.regions import Region
    from wireprint.wire_print import WirePrint

#: Heights of slabs that are tried throughout, as shares of those before, and in a part of them;
#: and the least and the greatest of those that a forecast asks for.
_LOWER: Final = (0.75, 0.5)
_LOWER_IN_PART: Final = (0.6, 0.35)
_LOWEST: Final = 0.35
_HIGHEST: Final = 0.9
#: Bands that hold more of a print's height than this are no part of it.
_PART: Final = 0.8
#: Low slabs from so many heights to others at most.
_MOST_BANDS: Final = 50
#: A strand that is fed x times as much gives way by x⁻², may by √x, and bears x to the 1.5.
_GIVES_WAY: Final = 2.5
_BEARS: Final = 1.5
#: Slabs that are x times as high take 1/x of the time, or less (coils do not mind, posts become
#: fewer by x²), and give way by x to the 2.5.
_TAKES: Final = -1.0
_HIGHER_GIVES_WAY: Final = 2.5
#: No print is taken that takes so many times as long: a thicker nozzle is the better way then.
_LONGEST: Final = 4.0
#: Fed more than that says: prints differ in more than the strand.
_MARGIN: Final = 1.03
#: Where strands make a print that is refused, those that are fed so many times as much are tried.
_THICKER: Final = 1.5
#: What strands may be fed, `Wire.flow`; a slow hot end slows the head for it.
_MOST_FLOW: Final = 3.0
#: How often what was tried is gone on with, and with how many of it; and how often what suffices is
#: made cheaper.
_ROUNDS: Final = 5
_REFINED: Final = 2
_GONE_ON_WITH: Final = 2
#: A print that takes so much longer counts as one that takes no longer: what is gained by it is
#: not measured in less.
_NO_LONGER: Final = 0.02
#: What gives way by more of what it did is not gone on with.
_BETTER: Final = 0.97
#: Giving way by so much of what it was is worth a print of its own if none suffices, and so is
#: feeding by so much of what is fed.
_WORTH: Final = 0.9
#: The rule for posts that is not the default.
_OTHER_PLACEMENT: Final = "paper"
#: A print without supports covers as much if it covers less by no more than this share.
_AS_MUCH: Final = 1e-3
#: What suffices is tried with strands that are fed so many times as much, too: time does not grow
#: with that throughout, for thick strands ask for fewer posts.
_THICKER_YET: Final = 1.3
#: Digits of what is tried, so that `--set` repeats it.
_DIGITS: Final = 2


@dataclass(frozen=True, slots=True)
class Stiffened:
    """What was tried against giving way, and what came of it."""

    #: What was set otherwise, as ``--set`` takes it; empty: the print is as it was.
    overrides: tuple[str, ...]
    #: How far what strands end on is pulled aside at worst, mm, and what it may be.
    meets_before_mm: float | None
    meets_after_mm: float | None
    limit_mm: float
    #: What it bears between two fingers, N; None where that was not asked for.
    bears_before_n: float | None
    bears_after_n: float | None
    print_time_before_s: float
    print_time_after_s: float
    #: Whether that suffices, and how many prints were tried.
    enough: bool
    tried: int


@dataclass(frozen=True)
class _Way:
    """What is set otherwise."""

    #: What strands are fed, by what they would be; slabs throughout, mm; and slabs in parts, mm.
    flow: float | None = None
    slab_max_mm: float | None = None
    low_slabs_mm: tuple[tuple[float, float, float], ...] = ()
    #: The rule by which posts are placed, and what carries parts that would hang.
    placement: str | None = None
    supports: str | None = None

    def overrides(self) -> tuple[str, ...]:
        """Return it as ``--set`` takes it."""
        told = {
            "slab_max_mm": self.slab_max_mm,
            "low_slabs_mm": self.low_slabs_mm,
            "flow": self.flow,
            "placement": self.placement,
            "supports": self.supports,
        }
        return tuple(f"wire.{key}={json.dumps(value)}" for key, value in told.items() if value)


@dataclass(frozen=True)
class _Print:
    """A print that was tried."""

    way: _Way
    made: WirePrint
    forecast: Forecast
    grip_n: float | None

    @property
    def bears_n(self) -> float | None:
        return None if self.forecast.grip is None else self.forecast.grip.bears_n

    @property
    def takes_s(self) -> float:
        return self.made.estimate.total_s

    @property
    def lacks(self) -> float:
        """By what factor it falls short; up to 1: it suffices, as far as it was judged."""
        return max(self._lacks())

    @property
    def wanted_flow(self) -> float:
        """What its strands would have to be fed to suffice."""
        meets, bears = self._lacks()
        times: float = max(meets ** (1 / _GIVES_WAY), bears ** (1 / _BEARS))
        return _MARGIN * times * self.made.settings.wire.flow

    def _lacks(self) -> tuple[float, float]:
        if not self.forecast.core.frame_judged:
            return math.inf, math.inf
        meets = self.forecast.rules["meets"]
        lacks = (meets.worst or 0.0) / (meets.limit or 1.0)
        if self.grip_n is None or self.bears_n is None:
            return lacks, 0.0
        return lacks, self.grip_n / max(self.bears_n, 1e-9)


def stiffened(
    mesh: Mesh,
    plain: WirePrint,
    region: Region | None,
    options: dict[str, Any],
    *,
    grip_n: float | None = None,
    kept: frozenset[str] = frozenset(),
) -> tuple[WirePrint, Forecast, Stiffened | None]:
    """Make a print anew where its forecast says that it gives way.

    Parameters
    ----------
    mesh
        The placed model.
    plain
        Its print.
    region, options
        What that was made with besides: see `wireprint.make`.
    grip_n
        What it is to bear between two fingers, N; None: that does not matter.
    kept
        Keys of settings that stay as they are.

    Returns
    -------
    tuple of WirePrint, Forecast, and Stiffened or None
        The print to take, its forecast, and what was tried; None where nothing was amiss.
    """
    # Bands that the plain print has already are told, too: planned with other strands it might get
    # others.
    way = _Way(low_slabs_mm=plain.settings.wire.low_slabs_mm)
    first = _Print(way, plain, simulate(plain.gcode, plain.settings, grip_n), grip_n)
    if not first.forecast.core.frame_judged or first.lacks <= 1:
        return plain, first.forecast, None

    def made_of(way: _Way) -> _Print | None:
        try:
            settings = plain.settings.but(overrides=way.overrides())
            made = make(mesh, settings, region, **options | {"clock": None})
        except WireprintError:
            return None
        certificate = made.certificate
        if certificate is None or not certificate.ok or not is_whole(certificate, settings):
            return None
        if way.supports is not None and _covered(made) < _covered(plain) - _AS_MUCH:
            return None
        found = _Print(way, made, simulate(made.gcode, settings, grip_n), grip_n)
        # What no finger meets any more bears nothing that was asked for.
        return None if first.bears_n is not None and found.bears_n is None else found

    known: dict[_Way, _Print | None] = {first.way: first}
    with ThreadPoolExecutor(workers()) as pool:

        def tried(ways: list[_Way]) -> list[_Print]:
            fresh = [way for way in dict.fromkeys(ways) if way not in known]
            known.update(zip(fresh, pool.map(made_of, fresh), strict=True))
            return [one for way in fresh if (one := known[way]) is not None]

        bases = [first]
        for _ in range(_ROUNDS):
            longest_s = _longest_s(first, known)
            found = tried([way for base in bases for way in _ways(base, kept, longest_s)])
            found += tried([way for base in bases for way in _thicker_yet(base, known)])
            found += tried([way for base in bases for way in _otherwise(base, first, kept)])
            if not found:
                found = tried([way for base in bases for way in _lower(base, kept, longest_s)])
            bases = _promising(first, bases, found, _longest_s(first, known))
            if not bases:
                break
        for _ in range(_REFINED):
            tried(list(_cheaper(_best(first, known), first, kept)))
    best = _best(first, known)
    told = Stiffened(
        () if best is first else best.way.overrides(),
        first.forecast.rules["meets"].worst,
        best.forecast.rules["meets"].worst,
        best.forecast.rules["meets"].limit or 0.0,
        first.bears_n,
        best.bears_n,
        first.takes_s,
        best.takes_s,
        best.lacks <= 1 and (grip_n is None or best.bears_n is not None),
        len(known) - 1,
    )
    return best.made, best.forecast, told


def _longest_s(first: _Print, known: dict[_Way, _Print | None]) -> float:
    """Return what a print may take to be taken, s: less than any that suffices."""
    enough = (one.takes_s for one in known.values() if one and one.lacks <= 1)
    return min(enough, default=_LONGEST * first.takes_s)


def _best(first: _Print, known: dict[_Way, _Print | None]) -> _Print:
    """Return the quickest that suffices, else what falls short least, if that is worth it."""
    longest_s = _LONGEST * first.takes_s
    found = [one for one in known.values() if one is not None and one.takes_s <= longest_s]
    enough = [one for one in found if one.lacks <= 1]
    if enough:
        return min(enough, key=lambda one: one.takes_s)
    least = min(found, key=lambda one: (one.lacks, one.takes_s))
    return least if least.lacks < _WORTH * first.lacks else first


def _promising(
    first: _Print, bases: list[_Print], found: list[_Print], longest_s: float
) -> list[_Print]:
    """Return what is gone on with: that which gains most for its time, and what lacks least."""
    before = min(bases, key=lambda one: one.lacks)
    short = [one for one in found if one.lacks > 1 and one.takes_s < longest_s]
    better = [one for one in short if one.lacks < _BETTER * before.lacks]

    def gain(one: _Print) -> float:
        longer = max(math.log(one.takes_s / before.takes_s), _NO_LONGER)
        return math.log(before.lacks / one.lacks) / longer

    if not better:
        # Slabs may be worth it with thicker strands only.
        least = sorted(short, key=lambda one: one.lacks)[:_GONE_ON_WITH]
        return least if before is first else []
    ordered = [max(better, key=gain), *sorted(better, key=lambda one: one.lacks)]
    return list({one.way: one for one in ordered}.values())[:_GONE_ON_WITH]


def _ways(base: _Print, kept: frozenset[str], longest_s: float) -> Iterator[_Way]:
    """Return what to try next where a print gives way."""
    lower = list(_lower(base, kept, longest_s))
    if "wire.flow" in kept or base.made.settings.wire.flow >= _MOST_FLOW:
        yield from lower
        return
    flow = _rounded_up(min(base.wanted_flow, _MOST_FLOW))
    yield replace(base.way, flow=flow)
    yield from (way for way in lower if base.wanted_flow <= _MOST_FLOW)


def _thicker_yet(base: _Print, known: dict[_Way, _Print | None]) -> Iterator[_Way]:
    """Return the way on from strands that made a print which was refused: thicker ones may not."""
    for way, made in list(known.items()):
        was_refused = made is None and way == replace(base.way, flow=way.flow)
        if was_refused and way.flow is not None and way.flow < _MOST_FLOW:
            yield replace(way, flow=min(_rounded_up(_THICKER * way.flow), _MOST_FLOW))


def _otherwise(base: _Print, first: _Print, kept: frozenset[str]) -> Iterator[_Way]:
    """Return ways with other posts, and without supports: once strands are as thick as need be."""
    if base is first:
        return
    wire = base.made.settings.wire
    if wire.placement != _OTHER_PLACEMENT and "wire.placement" not in kept:
        yield replace(base.way, placement=_OTHER_PLACEMENT)
    if base.made.wireframe.support_mm > 0 and "wire.supports" not in kept:
        yield replace(base.way, supports="none")


def _covered(made: WirePrint) -> float:
    """Return how much of the model a print covers, as a share; 1 where that is not told."""
    certificate = made.certificate
    if certificate is None or certificate.fidelity is None:
        return 1.0
    return certificate.fidelity.coverage


def _lower(base: _Print, kept: frozenset[str], longest_s: float) -> Iterator[_Way]:
    """Return ways with lower slabs: about what gives way, and throughout."""
    settings = base.made.settings
    high, low = settings.slab_max_mm, settings.slab_min_mm
    top = float(base.forecast.ends_mm[:, 1, 2].max(initial=0.0))
    if "wire.low_slabs_mm" not in kept:
        for bands in _bands(base):
            if share_of(bands, top) > _PART:
                continue
            for share in _LOWER_IN_PART:
                slabs = _with(base.way.low_slabs_mm, bands, max(share * high, low))
                if len(slabs) <= _MOST_BANDS:
                    yield replace(base.way, low_slabs_mm=slabs)
    if "wire.slab_max_mm" not in kept:
        asked = base.lacks ** (-1 / _HIGHER_GIVES_WAY) / _MARGIN
        for share in (min(max(asked, _LOWEST), _HIGHEST), *_LOWER):
            height = round(max(share * high, low), _DIGITS)
            takes_s = base.takes_s * (height / high) ** _TAKES
            if height < high and takes_s < longest_s:
                yield replace(base.way, slab_max_mm=height)


def _bands(base: _Print) -> list[list[Band]]:
    """Return sets of heights between which lower slabs may help, each once."""
    misses = about_misses(base.made, base.forecast)
    bends = that_bends(base.made, base.forecast) if misses else []
    sets = [misses, bends, joined([*misses, *bends])]
    if base.forecast.grip is not None and (base.bears_n or 0.0) < (base.grip_n or 0.0):
        sets.append(about_fingers(base.made, base.forecast, base.forecast.grip))
    return [list(one) for one in dict.fromkeys(tuple(one) for one in sets) if one]


def _with(
    before: tuple[tuple[float, float, float], ...], bands: list[Band], most: float
) -> tuple[tuple[float, float, float], ...]:
    """Return low slabs with some more; those of one height that overlap are one."""
    by_height: dict[float, list[Band]] = {}
    for low, high, height in [*before, *((*band, round(most, _DIGITS)) for band in bands)]:
        by_height.setdefault(height, []).append((round(low, _DIGITS), round(high, _DIGITS)))
    return tuple(
        (*band, height) for height in sorted(by_height) for band in joined(by_height[height])
    )


def _cheaper(best: _Print, first: _Print, kept: frozenset[str]) -> Iterator[_Way]:
    """Return ways of a print that suffices with no more than it takes, or in less time."""
    if best.lacks <= 1 and best.way.flow is not None and "wire.flow" not in kept:
        thicker = min(_rounded_up(_THICKER_YET * best.way.flow), _MOST_FLOW)
        yield replace(best.way, flow=thicker)
        yield replace(first.way, flow=thicker)
        yield from _otherwise(best, first, kept)
    if best.lacks > _WORTH:
        return
    flow = _rounded_up(best.wanted_flow)
    if best.way.flow is not None and flow < _WORTH * best.way.flow and "wire.flow" not in kept:
        yield replace(best.way, flow=flow)
        yield replace(best.way, flow=_rounded_up(math.sqrt(flow * best.way.flow)))
    if best.way.slab_max_mm is not None:
        higher = best.lacks ** (-1 / _HIGHER_GIVES_WAY) / _MARGIN
        yield replace(best.way, slab_max_mm=round(higher * best.way.slab_max_mm, _DIGITS))


def _rounded_up(value: float) -> float:
    return math.ceil(value * 10**_DIGITS) / 10**_DIGITS
