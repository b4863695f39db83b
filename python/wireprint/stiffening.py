"""Prints that would give way: made anew with lower slabs or thicker strands, where that pays.

Asked for by a forecast alone. What is tried is made and forecast like any print: lower slabs about
the places that give way, or below them, or throughout; and each of these, or the print as it was,
with strands that are fed as much more as its forecast says is missing. Of those that suffice the
quickest is taken, else the one that gives way least.
"""

from __future__ import annotations

import json
import math
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Final

import numpy as np

from wireprint._core import WireprintError
from wireprint.forecast import simulate
from wireprint.pipeline import make
from wireprint.threads import workers
from wireprint.wholeness import is_whole

if TYPE_CHECKING:
    from collections.abc import Iterator

    from wireprint._core import Mesh
    from wireprint.forecast import Forecast
    from wireprint.regions import Region
    from wireprint.wire_print import WirePrint

#: Heights of slabs that are tried throughout, as shares of the greatest, and in a part of them.
_LOWER: Final = (0.75, 0.5, 0.35)
_LOWER_IN_PART: Final = (0.5, 0.35)
#: A strand that is fed x times as much gives way by x⁻², may by √x, and bears x to the 1.5.
_GIVES_WAY: Final = 2.5
_BEARS: Final = 1.5
#: Fed more than that says: prints differ in more than the strand.
_MARGIN: Final = 1.03
#: What strands may be fed, `Wire.flow`; a slow hot end slows the head for it.
_MOST_FLOW: Final = 3.0
#: How often what is fed is told anew by the forecast of the print before.
_ROUNDS: Final = 2
#: Lower slabs reach so many of the greatest slabs below and above a place.
_REACH: Final = 1.5
#: Giving way by so much of what it was is worth a print of its own if none suffices, and so is
#: feeding by so much of what is fed.
_WORTH: Final = 0.9
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
class _Print:
    """A print that was tried."""

    overrides: tuple[str, ...]
    made: WirePrint
    forecast: Forecast

    @property
    def meets_mm(self) -> float:
        return self.forecast.rules["meets"].worst or 0.0

    @property
    def bears_n(self) -> float | None:
        return None if self.forecast.grip is None else self.forecast.grip.bears_n

    @property
    def takes_s(self) -> float:
        return self.made.estimate.total_s

    def lacks(self, grip_n: float | None) -> float:
        """Return by what factor it falls short; up to 1: it suffices, as far as it was judged."""
        return max(self._lacks(grip_n))

    def wants_flow(self, grip_n: float | None) -> float:
        """Return how many times as much its strands would have to be fed to suffice."""
        meets, bears = self._lacks(grip_n)
        times: float = max(meets ** (1 / _GIVES_WAY), bears ** (1 / _BEARS))
        return _MARGIN * times

    def _lacks(self, grip_n: float | None) -> tuple[float, float]:
        if not self.forecast.core.frame_judged:
            return math.inf, math.inf
        meets = self.meets_mm / (self.forecast.rules["meets"].limit or 1.0)
        if grip_n is None or self.bears_n is None:
            return meets, 0.0
        return meets, grip_n / max(self.bears_n, 1e-9)


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
    first = _Print((), plain, simulate(plain.gcode, plain.settings, grip_n))
    if not first.forecast.core.frame_judged or first.lacks(grip_n) <= 1:
        return plain, first.forecast, None

    def tried(overrides: tuple[str, ...]) -> _Print | None:
        try:
            settings = plain.settings.but(overrides=overrides)
            made = make(mesh, settings, region, **options | {"clock": None})
        except WireprintError:
            return None
        certificate = made.certificate
        if certificate is None or not certificate.ok or not is_whole(certificate, settings):
            return None
        return _Print(overrides, made, simulate(made.gcode, settings, grip_n))

    slabs = [way for way in _slabs(first, grip_n) if _key(way) not in kept]
    with ThreadPoolExecutor(workers()) as pool:

        def made_of(ways: list[tuple[str, ...]]) -> list[_Print]:
            return [one for one in pool.map(tried, ways) if one is not None]

        ways: list[tuple[str, ...]] = [(way,) for way in slabs]
        found = made_of(ways)
        bases = [first, *found]
        for _ in range(0 if "wire.flow" in kept else _ROUNDS):
            bases = _worth_thickening(bases, found, grip_n)
            thicker = [_thicker(base, grip_n) for base in bases]
            bases = made_of(thicker)
            found += bases
            ways += thicker
        best = _best(first, found, grip_n)
        thinner = [] if "wire.flow" in kept else _thinner(best, grip_n)
        found += made_of(thinner)
        ways += thinner
    best = _best(first, found, grip_n)
    told = Stiffened(
        best.overrides,
        first.forecast.rules["meets"].worst,
        best.forecast.rules["meets"].worst,
        best.forecast.rules["meets"].limit or 0.0,
        first.bears_n,
        best.bears_n,
        first.takes_s,
        best.takes_s,
        best.lacks(grip_n) <= 1,
        len(ways),
    )
    return best.made, best.forecast, told


def _best(first: _Print, found: list[_Print], grip_n: float | None) -> _Print:
    """Return the quickest that suffices, else what falls short least, if that is worth it."""
    enough = [one for one in found if one.lacks(grip_n) <= 1]
    if enough:
        return min(enough, key=lambda one: one.takes_s)
    least = min(found, key=lambda one: (one.lacks(grip_n), one.takes_s), default=first)
    return least if least.lacks(grip_n) < _WORTH * first.lacks(grip_n) else first


def _slabs(first: _Print, grip_n: float | None) -> Iterator[str]:
    """Return lower slabs that are tried, as ``--set`` takes them."""
    settings = first.made.settings
    high, low = settings.slab_max_mm, settings.slab_min_mm

    def lower(shares: tuple[float, ...]) -> list[float]:
        heights = [max(share * high, low) for share in shares]
        return [height for height in dict.fromkeys(heights) if height < high]

    yield from (_set("slab_max_mm", most) for most in lower(_LOWER))
    for band in _bands(first, grip_n):
        yield from (_set("low_slabs_mm", [*band, most]) for most in lower(_LOWER_IN_PART))


def _worth_thickening(
    bases: list[_Print], found: list[_Print], grip_n: float | None
) -> list[_Print]:
    """Return those that fall short and may become the quickest that suffices."""
    enough = [one.takes_s for one in found if one.lacks(grip_n) <= 1]
    quickest = min(enough, default=math.inf)
    short = [base for base in bases if 1 < base.lacks(grip_n) < math.inf]
    short = [base for base in short if base.made.settings.wire.flow < _MOST_FLOW]
    if enough:
        short = [
            base
            for base in short
            if base.takes_s < quickest
            and base.wants_flow(grip_n) * base.made.settings.wire.flow <= _MOST_FLOW
        ]
    return short


def _thinner(best: _Print, grip_n: float | None) -> list[tuple[str, ...]]:
    """Return the changes of a print that suffices with strands that are fed more than it takes."""
    is_fed_more = any(_key(one) == "wire.flow" for one in best.overrides)
    if is_fed_more and best.wants_flow(grip_n) < _WORTH:
        return [_thicker(best, grip_n)]
    return []


def _thicker(base: _Print, grip_n: float | None) -> tuple[str, ...]:
    """Return its changes, with strands that are fed as much as its forecast asks for."""
    wanted = base.wants_flow(grip_n) * base.made.settings.wire.flow
    rounded = math.ceil(wanted * 10**_DIGITS) / 10**_DIGITS
    others = [one for one in base.overrides if _key(one) != "wire.flow"]
    return (*others, _set("flow", min(rounded, _MOST_FLOW)))


def _bands(first: _Print, grip_n: float | None) -> Iterator[tuple[float, float]]:
    """Return heights, mm, between which lower slabs may help: of what gives way, and below."""
    forecast, settings = first.forecast, first.made.settings
    reach = _REACH * settings.slab_max_mm
    limit = forecast.rules["meets"].limit or 0.0
    misses = settings.wire.pull_n * np.nan_to_num(forecast.compliance_mm_n) > limit
    ends = forecast.ends_mm[:, 1, 2]
    top = float(ends.max(initial=0.0))
    if misses.any():
        low, high = float(ends[misses].min()), float(ends[misses].max())
        yield max(0.0, low - reach), high + reach
        if low - reach > reach:
            yield 0.0, low
    if grip_n is not None and (first.bears_n or 0.0) < grip_n:
        yield max(0.0, top / 2 - 2 * reach), top / 2 + 2 * reach


def _set(name: str, value: float | list[float]) -> str:
    rounded = [round(one, _DIGITS) for one in value] if isinstance(value, list) else None
    told = json.dumps(round(value, _DIGITS) if isinstance(value, float) else rounded)
    return f"wire.{name}={told}"


def _key(override: str) -> str:
    return override.partition("=")[0]
