"""What was measured on calibration prints, as a TOML file says it."""

from __future__ import annotations

import datetime as dt
import math
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Final

from wireprint import toml
from wireprint._core import SettingError
from wireprint.calibration import bending, sphere
from wireprint.calibration.tents import LENGTHS_MM, RATIO, STRANDS, TENTS, pauses_s

if TYPE_CHECKING:
    from collections.abc import Sequence
    from pathlib import Path

    from wireprint.settings import Settings

#: A sag is measured within so much, mm: calipers, or a ruler on a photo.
SAG_WITHIN_MM: Final = 0.15
#: How well a mast's length and drop are measured, mm: with a ruler.
RULER_MM: Final = 0.5
#: How well a coin's weight is known, as a share.
_WEIGHT: Final = 0.02
#: A pause between two that are evenly likely has this deviation, in shares of their distance.
_EVENLY: Final = 1 / math.sqrt(12)
#: So has a sag.
SAG_SPREAD_MM: Final = 2 * SAG_WITHIN_MM * _EVENLY
#: A strand whose length is off by more of it is none of the harp.
_OTHER: Final = 0.25
#: Strands of harps, and rows of spheres, that are taken.
_MOST: Final = 40
#: What a print has is told to three digits.
_SAME: Final = 0.02
#: A strand that is so many times as stiff as its diameter and modulus say, or as soft, is none.
_OTHER_STRAND: Final = 8.0
#: Of what is no number so many characters are told.
_LONGEST_TOLD: Final = 40
#: A coin that drops by more of its length than this hangs from its strand rather than bends it.
_HANGS: Final = 0.9
_KEYS: Final = {"date", "ladder", "harp", "mast", "sphere"}
_FORM: Final = (
    "it has date, [ladder] first_standing, [[harp]] length_mm, speed_mm_s, sag_mm, "
    "[mast] weight_g, length_mm, drop_mm, and [[sphere]] speed_mm_s, pause_s"
)


@dataclass(frozen=True)
class Sag:
    """One strand of a harp."""

    length_mm: float
    speed_mm_s: float
    sag_mm: float


@dataclass(frozen=True)
class Held:
    """A pause after which what was drawn at a speed held."""

    #: Of what: ladder or sphere.
    print: str
    speed_mm_s: float
    pause_s: float
    #: Its deviation, s.
    spread_s: float


@dataclass(frozen=True)
class Stiff:
    """A strand that was bent."""

    bending_n_mm2: float
    #: Its deviation.
    spread_n_mm2: float


@dataclass(frozen=True)
class Answers:
    """All that was measured."""

    date: str
    pauses: tuple[Held, ...]
    sags: tuple[Sag, ...]
    stiff: Stiff | None = None

    def named(self, number: int) -> str:
        """Say which answer that is: of the pauses, then of the sags."""
        if number < len(self.pauses):
            held = self.pauses[number]
            return f"the pause of the {held.print} at {held.speed_mm_s:.3g} mm/s"
        sag = self.sags[number - len(self.pauses)]
        return f"the sag of {sag.length_mm:g} mm at {sag.speed_mm_s:.3g} mm/s"

    def words(self) -> tuple[str, ...]:
        """Say what was measured."""
        said = [
            f"{held.print}: {held.pause_s:.2f} s at {held.speed_mm_s:.3g} mm/s"
            for held in self.pauses
        ]
        if self.sags:
            lengths = sorted({sag.length_mm for sag in self.sags})
            said.append(f"harp: {len(self.sags)} strands, {lengths[0]:g} to {lengths[-1]:g} mm")
        if self.stiff is not None:
            said.append(f"mast: {self.stiff.bending_n_mm2:.3g} N·mm²")
        return tuple(said)


def read(path: Path, settings: Settings) -> Answers:
    """Read answers.

    Raises
    ------
    SettingError
        It cannot be read, says something else, or nothing.
    """
    _, values = toml.read(path)
    if stray := set(values) - _KEYS:
        raise SettingError(f"{path}: {sorted(stray)[0]} is no answer; {_FORM}")
    date = values.get("date")
    says = isinstance(date, str | dt.date) and 0 < len(str(date).strip()) <= 100
    if not says or not str(date).isprintable():
        raise SettingError(f"{path}: date is missing, such as date = 2026-11-27; {_FORM}")
    ladder = values.get("ladder")
    pauses = [] if ladder is None else [_ladder(path, ladder, settings)]
    rows, strands = _several(path, values, "sphere"), _several(path, values, "harp")
    pauses += [_sphere(path, row, settings, place) for place, row in enumerate(rows, 1)]
    sags = tuple(_sag(path, one, settings, place) for place, one in enumerate(strands, 1))
    stiff = None if values.get("mast") is None else _mast(path, values["mast"], settings)
    if not pauses and not sags and stiff is None:
        raise SettingError(f"{path}: nothing was measured; {_FORM}")
    return Answers(str(date), tuple(pauses), sags, stiff)


def _several(path: Path, values: dict[str, Any], name: str) -> list[Any]:
    found = values.get(name, [])
    if not isinstance(found, list):
        raise SettingError(f"{path}: [[{name}]] is written with two brackets, once for each")
    if len(found) > _MOST:
        raise SettingError(f"{path}: {len(found)} of [[{name}]]; {_MOST} are enough, say the best")
    return found


def _ladder(path: Path, table: Any, settings: Settings) -> Held:
    _no_others(path, table, "the ladder", "first_standing")
    first = table.get("first_standing") if isinstance(table, dict) else None
    if isinstance(first, bool) or not isinstance(first, int) or not 1 <= first <= TENTS:
        raise SettingError(
            f"{path}: [ladder] first_standing is the number of a tent, 1 to {TENTS}; where none "
            "stands, print a ladder with twice the air, or a cooler nozzle"
        )
    stands = pauses_s(settings)[first - 1]
    return _between("ladder", settings.print_mm_s, stands / RATIO, stands)


def _sphere(path: Path, table: Any, settings: Settings, place: int) -> Held:
    of = f"[[sphere]] number {place}"
    _no_others(path, table, of, "speed_mm_s", "pause_s")
    speed = _one_of(path, table, of, "speed_mm_s", sphere.speeds_mm_s(settings))
    stands = _one_of(path, table, of, "pause_s", sphere.pauses_s(settings))
    shorter = [pause for pause in sphere.pauses_s(settings) if pause < stands]
    return _between("sphere", speed, max(shorter, default=0.0), stands)


def _between(print_: str, speed_mm_s: float, fallen_s: float, stands_s: float) -> Held:
    """Take the middle of the last pause that failed and the first that did not."""
    middle, spread = (stands_s + fallen_s) / 2, (stands_s - fallen_s) * _EVENLY
    return Held(print_, speed_mm_s, middle, spread)


def _mast(path: Path, table: Any, settings: Settings) -> Stiff:
    _no_others(path, table, "the mast", "weight_g", "length_mm", "drop_mm")
    weight = _number(path, table, "the mast", "weight_g", 0.01, 1000)
    length = _number(path, table, "the mast", "length_mm", 1, 500)
    drop = _number(path, table, "the mast", "drop_mm", 0.1, 500)
    if drop > _HANGS * length:
        raise SettingError(
            f"{path}: a drop of {drop:g} mm says nothing about a strand of {length:g} mm, which "
            "hangs; hang the coin nearer to the block"
        )
    found = bending.stiffness_n_mm2(weight, length, drop)
    own = bending.of_strand(settings.strand_mm, settings.material.modulus_mpa)
    if not own / _OTHER_STRAND < found < own * _OTHER_STRAND:
        raise SettingError(
            f"{path}: a strand that {weight:g} g at {length:g} mm bend by {drop:g} mm is "
            f"{found / own:.2g} times as stiff as one of {settings.strand_mm:g} mm of "
            f"{settings.material.name}: was that in grams and millimetres?"
        )
    # Drop and length by a ruler, each by itself.
    lower = bending.stiffness_n_mm2(weight, length, max(drop - RULER_MM, drop / 2))
    longer = bending.stiffness_n_mm2(weight, length + RULER_MM, drop)
    spread = math.hypot(lower - found, longer - found, _WEIGHT * found)
    return Stiff(found, spread)


def _sag(path: Path, table: Any, settings: Settings, place: int) -> Sag:
    of = f"[[harp]] number {place}"
    _no_others(path, table, of, "length_mm", "speed_mm_s", "sag_mm")
    length = _number(path, table, of, "length_mm", 1, 500)
    if not any(abs(length - own) < _OTHER * own for own in LENGTHS_MM):
        own = " ".join(f"{one:g}" for one in LENGTHS_MM)
        raise SettingError(
            f"{path}: length_mm of {of} is {length:g}, and a harp has strands of {own} mm: which "
            "of them was it, in millimetres?"
        )
    speeds = {share * settings.print_mm_s for share, _ in STRANDS}
    speed = _one_of(path, table, of, "speed_mm_s", sorted(speeds))
    return Sag(length, speed, _number(path, table, of, "sag_mm", 0, length / 2))


def _no_others(path: Path, table: Any, of: str, *names: str) -> None:
    """Refuse keys that are no answer: a name that is spelt wrongly is none that is missing."""
    if isinstance(table, dict) and (stray := sorted(set(table) - set(names))):
        raise SettingError(f"{path}: {stray[0]} of {of} is no answer; it has {', '.join(names)}")


def _one_of(path: Path, table: Any, of: str, name: str, own: Sequence[float]) -> float:
    """Read a figure that the print has, written as exactly as its words tell it."""
    value = _number(path, table, of, name, 0.0, 1e6)
    nearest = min(own, key=lambda one: abs(one - value))
    if abs(nearest - value) > _SAME * nearest:
        listed = ", ".join(f"{one:.3g}" for one in own)
        raise SettingError(
            f"{path}: {name} of {of} is {value:g}, and the print has {listed}; are printer, "
            "material and options those that it was written with?"
        )
    return nearest


def _number(path: Path, table: Any, of: str, name: str, low: float, high: float) -> float:
    value = table.get(name) if isinstance(table, dict) else None
    counts = isinstance(value, int | float) and not isinstance(value, bool)
    # Compared as it is: an integer of TOML may be too long for a float.
    if not counts or value is None or not low <= value <= high:
        told = "missing" if value is None else str(value)
        told = told if len(told) <= _LONGEST_TOLD else f"{told[:_LONGEST_TOLD]}…"
        raise SettingError(
            f"{path}: {name} of {of} is {told}; it must be a number from {low:g} to {high:g}"
        )
    return float(value)
