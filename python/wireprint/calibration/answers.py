"""What was measured on calibration prints, as a TOML file says it."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Final

from wireprint import toml
from wireprint._core import SettingError
from wireprint.calibration.prints import RATIO, TENTS, pauses_s

if TYPE_CHECKING:
    from pathlib import Path

    from wireprint.settings import Settings

#: How well a sag is measured, mm: calipers, or a ruler on a photo.
SAG_MM: Final = 0.15
#: A pause between two that are evenly likely has this deviation, in shares of their distance.
_EVENLY: Final = 1 / math.sqrt(12)
_KEYS: Final = {"date", "ladder", "harp"}
_FORM: Final = "it has date, [ladder] first_standing, and [[harp]] length_mm, speed_mm_s, sag_mm"


@dataclass(frozen=True)
class Sag:
    """One strand of a harp."""

    length_mm: float
    speed_mm_s: float
    sag_mm: float


@dataclass(frozen=True)
class Answers:
    """All that was measured."""

    date: str
    #: The pause that the ladder tells, s, and its deviation; None where none was printed.
    pause_s: float | None
    pause_spread_s: float
    sags: tuple[Sag, ...]

    def words(self) -> tuple[str, ...]:
        """Say what was measured."""
        said = []
        if self.pause_s is not None:
            said.append(f"ladder: {self.pause_s:.2f} s")
        if self.sags:
            lengths = sorted({sag.length_mm for sag in self.sags})
            said.append(f"harp: {len(self.sags)} strands, {lengths[0]:g} to {lengths[-1]:g} mm")
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
    pause, spread = _ladder(path, values.get("ladder"), settings)
    harp = values.get("harp", [])
    if not isinstance(harp, list):
        raise SettingError(f"{path}: [[harp]] is written with two brackets, once for each strand")
    sags = tuple(_sag(path, one) for one in harp)
    if pause is None and not sags:
        raise SettingError(f"{path}: nothing was measured; {_FORM}")
    return Answers(str(date), pause, spread, sags)


def _ladder(path: Path, table: Any, settings: Settings) -> tuple[float | None, float]:
    if table is None:
        return None, 0.0
    first = table.get("first_standing") if isinstance(table, dict) else None
    if isinstance(first, bool) or not isinstance(first, int) or not 1 <= first <= TENTS:
        raise SettingError(
            f"{path}: [ladder] first_standing is the number of a tent, 1 to {TENTS}; where none "
            "stands, print a ladder with twice the air, or a cooler nozzle"
        )
    stands = pauses_s(settings)[first - 1]
    fallen = stands / RATIO
    return (stands + fallen) / 2, (stands - fallen) * _EVENLY


def _sag(path: Path, table: Any) -> Sag:
    def number(name: str, low: float, high: float) -> float:
        value = table.get(name) if isinstance(table, dict) else None
        counts = isinstance(value, int | float) and not isinstance(value, bool)
        if not counts or not low <= float(value or 0) <= high:
            raise SettingError(
                f"{path}: {name} of a strand of the harp is {value}; it must be a number from "
                f"{low:g} to {high:g}"
            )
        return float(value or 0)

    return Sag(
        number("length_mm", 1, 500), number("speed_mm_s", 0.1, 500), number("sag_mm", 0, 500)
    )
