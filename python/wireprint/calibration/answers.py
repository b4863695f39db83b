"""What was measured on calibration prints, as a TOML file says it."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Final

from wireprint import toml
from wireprint._core import SettingError
from wireprint.calibration import bending, sphere
from wireprint.calibration.tents import LENGTHS_MM, RATIO, TENTS, pauses_s

if TYPE_CHECKING:
    from pathlib import Path

    from wireprint.settings import Settings

#: How well a sag is measured, mm: calipers, or a ruler on a photo.
SAG_MM: Final = 0.15
#: How well a mast's length and drop are measured, mm: with a ruler.
RULER_MM: Final = 0.5
#: How well a coin's weight is known, as a share.
_WEIGHT: Final = 0.02
#: A pause between two that are evenly likely has this deviation, in shares of their distance.
_EVENLY: Final = 1 / math.sqrt(12)
#: A strand whose length is off by more of it is none of the harp.
_OTHER: Final = 0.25
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
    if date is None or not str(date).isprintable() or len(str(date)) > 100:
        raise SettingError(f"{path}: date is missing, such as date = 2026-11-27; {_FORM}")
    ladder = values.get("ladder")
    pauses = [] if ladder is None else [_ladder(path, ladder, settings)]
    pauses += [_sphere(path, one, settings) for one in _several(path, values, "sphere")]
    sags = tuple(_sag(path, one) for one in _several(path, values, "harp"))
    stiff = None if values.get("mast") is None else _mast(path, values["mast"])
    if not pauses and not sags and stiff is None:
        raise SettingError(f"{path}: nothing was measured; {_FORM}")
    return Answers(str(date), tuple(pauses), sags, stiff)


def _several(path: Path, values: dict[str, Any], name: str) -> list[Any]:
    found = values.get(name, [])
    if not isinstance(found, list):
        raise SettingError(f"{path}: [[{name}]] is written with two brackets, once for each")
    return found


def _ladder(path: Path, table: Any, settings: Settings) -> Held:
    first = table.get("first_standing") if isinstance(table, dict) else None
    if isinstance(first, bool) or not isinstance(first, int) or not 1 <= first <= TENTS:
        raise SettingError(
            f"{path}: [ladder] first_standing is the number of a tent, 1 to {TENTS}; where none "
            "stands, print a ladder with twice the air, or a cooler nozzle"
        )
    stands = pauses_s(settings)[first - 1]
    return _between("ladder", settings.print_mm_s, stands / RATIO, stands)


def _sphere(path: Path, table: Any, settings: Settings) -> Held:
    speed = _number(path, table, "a row of [[sphere]]", "speed_mm_s", 0.1, 500)
    stands = _number(path, table, "a row of [[sphere]]", "pause_s", 0.001, 500)
    shorter = [pause for pause in sphere.pauses_s(settings) if pause < 0.99 * stands]
    return _between("sphere", speed, max(shorter, default=0.0), stands)


def _between(print_: str, speed_mm_s: float, fallen_s: float, stands_s: float) -> Held:
    """Take the middle of the last pause that failed and the first that did not."""
    middle, spread = (stands_s + fallen_s) / 2, (stands_s - fallen_s) * _EVENLY
    return Held(print_, speed_mm_s, middle, spread)


def _mast(path: Path, table: Any) -> Stiff:
    weight = _number(path, table, "the mast", "weight_g", 0.01, 1000)
    length = _number(path, table, "the mast", "length_mm", 1, 500)
    drop = _number(path, table, "the mast", "drop_mm", 0.1, 500)
    if drop > _HANGS * length:
        raise SettingError(
            f"{path}: a drop of {drop:g} mm says nothing about a strand of {length:g} mm, which "
            "hangs; hang the coin nearer to the block"
        )
    found = bending.stiffness_n_mm2(weight, length, drop)
    # Drop and length by a ruler, each by itself.
    lower = bending.stiffness_n_mm2(weight, length, max(drop - RULER_MM, drop / 2))
    longer = bending.stiffness_n_mm2(weight, length + RULER_MM, drop)
    spread = math.hypot(lower - found, longer - found, _WEIGHT * found)
    return Stiff(found, spread)


def _sag(path: Path, table: Any) -> Sag:
    of = "a strand of the harp"
    length = _number(path, table, of, "length_mm", 1, 500)
    if not any(abs(length - own) < _OTHER * own for own in LENGTHS_MM):
        own = " ".join(f"{one:g}" for one in LENGTHS_MM)
        raise SettingError(
            f"{path}: length_mm of {of} is {length:g}, and a harp has strands of {own} mm: which "
            "of them was it, in millimetres?"
        )
    speed = _number(path, table, of, "speed_mm_s", 0.1, 500)
    return Sag(length, speed, _number(path, table, of, "sag_mm", 0, length / 2))


def _number(path: Path, table: Any, of: str, name: str, low: float, high: float) -> float:
    value = table.get(name) if isinstance(table, dict) else None
    counts = isinstance(value, int | float) and not isinstance(value, bool)
    if not counts or not low <= float(value or 0) <= high:
        raise SettingError(
            f"{path}: {name} of {of} is {value}; it must be a number from {low:g} to {high:g}"
        )
    return float(value or 0)
