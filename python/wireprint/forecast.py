"""The forecast of a G-code file: what its strands would do when they are hot, heavy and pulled at.

A model throughout, no part of the certificate, and never more than it says of itself:
``docs/forecast.md``. Computed by the core, ``rust/core/src/physics``.
"""

from __future__ import annotations

import math
from dataclasses import asdict, dataclass
from functools import cached_property
from typing import TYPE_CHECKING, Any, Final, Literal

from wireprint import _core
from wireprint import limits as motion_limits
from wireprint._core import GcodeError
from wireprint.forecast_terms import SPREAD, calibrated_spread, stiffer, terms_of
from wireprint.frames import NoSolverError
from wireprint.gcode.source import NO_GCODE, read
from wireprint.grip import grip
from wireprint.rules import Judge, judge_of, rules_of
from wireprint.verdict import Point

if TYPE_CHECKING:
    import os

    import numpy as np
    import numpy.typing as npt

    from wireprint.grip import Grip
    from wireprint.settings import Settings

    Array = npt.NDArray[np.float64]

Name = Literal["holds", "sags", "meets", "flows", "knots", "welds", "grips"]
Verdict = Literal["passes", "unsure", "fails", "ranking", "not judged"]

#: A stroke may get so much more or less than its material, as a share: the core's.
FLOW_SHARE: Final = 0.2
_UNITS: Final[dict[str, str]] = {
    "holds": "mm",
    "sags": "mm",
    "meets": "mm",
    "flows": "",
    "knots": "mm",
    "welds": "",
    "grips": "mm",
}


@dataclass(frozen=True, slots=True)
class Rule:
    """What the forecast says by one rule."""

    name: Name
    #: What the worst may be; None where places are ranked only.
    limit: float | None
    #: Unit of `limit` and `worst`: mm, or none for shares.
    unit: str
    #: The worst figure; None where there is nothing that it is about, or where it was not judged.
    worst: float | None
    #: What it may be as well, the least and the most.
    bounds: tuple[float, float] | None
    #: Whether `bounds` are those of a calibration.
    calibrated: bool
    #: Line of the worst place, and where that is, mm, in the machine's coordinates.
    line: int | None
    place_mm: Point | None
    #: Length of the post or stretch there, mm; 0 where it is about none.
    length_mm: float
    #: One more figure of that place; `wireprint.forecast_words` says what.
    detail: float
    #: Number of places beyond the limit, and of all.
    over: int
    of: int

    @property
    def verdict(self) -> Verdict:
        """Whether the worst keeps the limit, as surely as its bounds allow."""
        if self.bounds is None:
            return "not judged"
        if self.limit is None:
            return "ranking"
        least, most = self.bounds
        if most <= self.limit:
            return "passes"
        return "fails" if least > self.limit else "unsure"

    def to_dict(self) -> dict[str, Any]:
        """Everything as values that JSON knows."""
        return {
            "limit": self.limit,
            "unit": self.unit,
            "worst": self.worst,
            "bounds": self.bounds,
            "trust": "calibrated" if self.calibrated else "uncalibrated",
            "verdict": self.verdict,
            "line": self.line,
            "place_mm": self.place_mm,
            "length_mm": self.length_mm,
            "over": self.over,
            "of": self.of,
        }


@dataclass(frozen=True, repr=False)
class Forecast:
    """What a file would do, by a model; arrays have an entry for each strand, NaN without one."""

    #: The settings that it was made with, and why with these.
    judge: Judge
    #: What each rule comes to, by name.
    rules: dict[str, Rule]
    #: Median share of a whole weld of the strands that are joined to others; None without such.
    weld_median: float | None
    #: What it does between two fingers; None where that was not asked for, or not judged.
    grip: Grip | None
    #: Why it was not judged, where that was asked for.
    ungripped: str
    #: The core's forecast, with all arrays.
    core: _core.Forecast

    def __repr__(self) -> str:
        """Say what the rules come to."""
        told = ", ".join(f"{name} {rule.verdict}" for name, rule in self.rules.items())
        return f"<Forecast {self.judge.settings.printer.name}: {told}; {self.trust}>"

    @property
    def calibrated(self) -> bool:
        """Whether pause and sags rest on what was measured."""
        return self.judge.settings.calibrated_by() is not None

    @property
    def trust(self) -> Literal["calibrated", "uncalibrated"]:
        """How far it is to be trusted."""
        return "calibrated" if self.calibrated else "uncalibrated"

    @cached_property
    def line(self) -> npt.NDArray[np.uint64]:
        """Line of each strand, read-only, of shape (N,)."""
        return self.core.lines

    @cached_property
    def ends_mm(self) -> Array:
        """Ends of each strand, mm, read-only, of shape (N, 2, 3)."""
        return self.core.ends

    @cached_property
    def age_s(self) -> Array:
        """Age of what a strand is joined to at its weaker end, when it comes there, s; (N,)."""
        return self.core.age_s

    @cached_property
    def temperature_c(self) -> Array:
        """Temperature of that then, °C; (N,)."""
        return self.core.temperature_c

    @cached_property
    def sag_mm(self) -> Array:
        """Sag of the stretch that a strand lies in, mm; (N,)."""
        return self.core.sag_mm

    @cached_property
    def compliance_mm_n(self) -> Array:
        """How far a strand's end, or what it meets there, gives way when it is laid, mm/N; (N,)."""
        return self.core.compliance_mm_n

    @cached_property
    def flow_share(self) -> Array:
        """Share of what a strand is fed that comes out along it; (N,)."""
        return self.core.flow_share

    @cached_property
    def weld(self) -> Array:
        """Share of a whole weld at a strand's weaker end, 0-1; (N,)."""
        return self.core.weld

    def to_dict(self) -> dict[str, Any]:
        """Everything but the arrays as values that JSON knows.

        Returns
        -------
        dict
            What ``wireprint simulate --json`` prints.
        """
        settings = self.judge.settings
        return {
            "trust": self.trust,
            "part_of_certificate": False,
            "printer": settings.printer.name,
            "material": settings.material.name,
            "rules": {name: rule.to_dict() for name, rule in self.rules.items()},
            "weld_median": self.weld_median,
            "grip": None if self.grip is None else asdict(self.grip),
        }


def simulate(
    gcode: str | os.PathLike[str] | bytes,
    settings: str | Settings | None = None,
    grip_n: float | None = None,
) -> Forecast:
    r"""Forecast what the strands of a G-code file do.

    Parameters
    ----------
    gcode
        Path of a file of any program, or the text itself as bytes.
    settings
        Printer and material: settings, or name or path of a printer's profile. Default: what the
        file says that it was made with, else ``kossel-mini``.
    grip_n
        What two fingers press with, N, for the rule ``grips``; None: that is not judged. It takes
        scipy (``pip install 'wireprint[grip]'``).

    Returns
    -------
    Forecast

    Raises
    ------
    GcodeError
        Nothing in the file is G-code.
    OSError
        The file cannot be read.
    SettingError
        The profile is wrong.

    Examples
    --------
    >>> text = b"M83\nG1 X0 Z0.35 F1800\nG1 X9 E1\nG1 Z5 E1\nG4 P5000\nG1 Z9"
    >>> simulate(text).rules["holds"].verdict
    'passes'
    """
    text, name = read(gcode)
    judge = judge_of(text, settings, name)
    settings = judge.settings
    printer = settings.printer
    estimate = _core.estimate(
        text,
        motion_limits.of_printer(printer),
        motion_limits.firmware_of(printer),
        allowances_s=(0.0, 0.0, 0.0, 0.0),
        per_move=True,
    )
    if estimate.moves == 0:
        raise GcodeError(f"{name}: it moves nothing: if it was cut off, write it again; {NO_GCODE}")
    core = _core.forecast(text, rules_of(settings), estimate, terms_of(settings))
    slowest, likely, fastest, *others = core.found
    rules = {"holds": _holds(slowest[1], likely[1], fastest[1], settings)}
    rules |= {name: _rule(name, found, settings) for name, found in others}
    if not core.frame_judged:
        rules["meets"] = _rule("meets", (None, 0, 0), settings)
    gripped, why = _gripped(text, settings, grip_n)
    rules["grips"] = _grips(gripped, settings)
    median = core.weld_median
    return Forecast(judge, rules, None if math.isnan(median) else median, gripped, why, core)


def _gripped(text: bytes, settings: Settings, force_n: float | None) -> tuple[Grip | None, str]:
    """Return what two fingers do to a print, or why that is not told."""
    if force_n is None:
        return None, "asked for by --grip N, such as --grip 10"
    try:
        found = grip(text, settings, force_n, stiffer(settings))
    except NoSolverError:
        return None, "it takes scipy: pip install 'wireprint[grip]'"
    return found, "" if found else "nothing is between the fingers, or too large a frame"


def _grips(found: Grip | None, settings: Settings) -> Rule:
    if found is None:
        return _rule("grips", (None, 0, 0), settings)
    worst = (found.squeeze_mm, found.line, found.place_mm, 0.0, found.bears_n)
    return _rule("grips", (worst, found.over, found.of), settings)


def _rule(name: Name, found: _core._Found, settings: Settings) -> Rule:
    spread = calibrated_spread(name, settings)
    factor = SPREAD if spread is None else spread
    worst = found[0]
    bounds = None if worst is None else (worst[0] / factor, worst[0] * factor)
    return _with_bounds(name, found, bounds, spread is not None, settings)


def _holds(
    slowest: _core._Found, likely: _core._Found, fastest: _core._Found, settings: Settings
) -> Rule:
    """Bound a lean by how fast posts set: it changes with that by far more than in proportion."""
    bounds = None
    if slowest[0] is not None and fastest[0] is not None:
        bounds = (fastest[0][0], slowest[0][0])
    return _with_bounds("holds", likely, bounds, settings.calibrated_by() is not None, settings)


def _with_bounds(
    name: Name,
    found: _core._Found,
    bounds: tuple[float, float] | None,
    calibrated: bool,
    settings: Settings,
) -> Rule:
    worst, over, of = found
    value, line, place, length, detail = worst or (None, None, None, 0.0, 0.0)
    limit = _limit(name, settings)
    return Rule(
        name,
        limit,
        _UNITS[name],
        value,
        bounds,
        calibrated,
        line,
        place,
        length,
        detail,
        over,
        of,
    )


def _limit(name: Name, settings: Settings) -> float | None:
    strand = settings.strand_mm
    limits = {"holds": strand / 2, "sags": strand, "meets": strand / 2, "knots": strand / 2}
    return FLOW_SHARE if name == "flows" else limits.get(name)
