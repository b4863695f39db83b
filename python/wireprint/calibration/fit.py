"""The fit of calibration prints: least squares with priors, and what it predicts.

Fitted are the logarithms of air speed and viscosity, the draw, and the glass transition. Many of
them fit as well: predictions are calibrated, parameters are not. So what is kept is the pause and
the sags that follow, with their spread, and never a parameter.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Final

import numpy as np

from wireprint import _core, toml_text
from wireprint._core import SettingError
from wireprint.calibration.answers import SAG_SPREAD_MM
from wireprint.calibration.tents import LENGTHS_MM
from wireprint.forecast_terms import air_mm_s
from wireprint.settings.calibration import Calibration

if TYPE_CHECKING:
    from collections.abc import Callable

    import numpy.typing as npt

    from wireprint.calibration.answers import Answers
    from wireprint.settings import Settings

    Array = npt.NDArray[np.float64]

#: How well parameters are known before: logarithms of air speed and viscosity, draw, and K.
PRIORS: Final = (0.5, 0.7, 0.05, 8.0)
#: Steps of the finite differences, in priors.
_STEP: Final = 0.2
#: Steps at most, and how small one is the last, in priors.
_STEPS: Final = 16
_SMALL: Final = 0.03
#: How often a step that makes the fit worse is halved: sags of soft strands are far from straight.
_HALVED: Final = 3
#: Answers that are off by more deviations than this say nothing of any machine.
_ABSURD: Final = 30.0
#: No parameter is taken farther off than this, in priors.
_FARTHEST: Final = 3.0
#: Height of the posts by which pauses at several speeds are compared, mm, and the longest, s.
_POST_MM: Final = 5.0
_LONGEST_S: Final = 60.0
#: Nothing is told nearer than this, mm and s: what can be seen on a print.
_LEAST_MM: Final = 0.02


@dataclass(frozen=True)
class Fitted:
    """What follows from a fit."""

    pause_s: float
    pause_spread_s: float
    #: Length, sag and its spread, mm, at the speed of printing.
    sags_mm: tuple[tuple[float, float, float], ...]
    #: By how many deviations the answers are off what was fitted, root mean square.
    misfit: float


def fitted(settings: Settings, answers: Answers) -> Fitted:
    """Fit answers, and predict the pause and the sags that follow.

    Raises
    ------
    SettingError
        They are far from what any machine does; it names the one that is farthest off.

    Notes
    -----
    Gauss and Newton's method on parameters in units of their priors' deviations. Slopes are finite
    differences at the beginning and where it ends; in between each step tells them by what it came
    to (Broyden 1965), for a model is dear. Spreads are those of the posterior, linearised there.
    """
    keys = [(sag.length_mm, sag.speed_mm_s) for sag in answers.sags]
    told = [(length, settings.print_mm_s) for length in LENGTHS_MM]
    model = _model(settings, [held.speed_mm_s for held in answers.pauses], [*keys, *told])
    measured = [held.pause_s for held in answers.pauses] + [sag.sag_mm for sag in answers.sags]
    deviations = [held.spread_s for held in answers.pauses] + [SAG_SPREAD_MM] * len(answers.sags)
    # The pause at the speed of printing comes first, and was not measured as such.
    rows = list(range(1, 1 + len(measured)))
    weights = 1 / np.array(deviations)
    unit: Array = np.eye(len(PRIORS))
    place: Array = np.zeros(len(PRIORS))
    values = model(place)

    def misses(place: Array, values: Array) -> float:
        return float(place @ place + np.sum(((np.array(measured) - values[rows]) * weights) ** 2))

    slopes, known = _slopes(model, place, values), True
    for _ in range(_STEPS):
        scaled = slopes[rows] * weights[:, None]
        off = (np.array(measured) - values[rows]) * weights + scaled @ place
        found = np.linalg.solve(unit + scaled.T @ scaled, scaled.T @ off)
        move = np.clip(found, -_FARTHEST, _FARTHEST) - place
        nearer = None
        if float(np.abs(move).max()) >= _SMALL:
            for halved in range(_HALVED + 1):
                tried = place + move / 2**halved
                foretold = model(tried)
                if misses(tried, foretold) < misses(place, values):
                    nearer = tried, foretold
                    break
        if nearer is not None:
            move = nearer[0] - place
            wrong = nearer[1] - values - slopes @ move
            slopes = slopes + np.outer(wrong, move) / (move @ move)
            (place, values), known = nearer, False
        elif known:
            break
        else:
            slopes, known = _slopes(model, place, values), True
    scaled = slopes[rows] * weights[:, None]
    spread = np.linalg.inv(unit + scaled.T @ scaled)
    deviation = np.sqrt(np.einsum("ij,jk,ik->i", slopes, spread, slopes))
    off = (np.array(measured) - values[rows]) * weights
    misfit = math.sqrt(float(np.mean(off**2))) if len(off) else 0.0
    if misfit > _ABSURD:
        worst = int(np.argmax(np.abs(off)))
        raise SettingError(
            f"{answers.named(worst)} cannot be: with the others a machine would show "
            f"{float(values[rows][worst]):.2g}, not {measured[worst]:.2g}; measure it again, in "
            "millimetres and seconds, or leave it out"
        )
    # Answers that contradict each other tell less than each by itself (Birge's ratio, 1932).
    deviation *= max(1.0, misfit)
    sags = [
        (length, max(float(value), _LEAST_MM), float(one))
        for (length, _), value, one in zip(
            told, values[-len(told) :], deviation[-len(told) :], strict=True
        )
    ]
    return Fitted(float(values[0]), float(deviation[0]), tuple(sags), misfit)


def _model(
    settings: Settings, drawn: list[float], strands: list[tuple[float, float]]
) -> Callable[[Array], Array]:
    """Return what tells pauses and sags by parameters in units of their priors' deviations.

    First the pause at the speed of printing, then those at the speeds of `drawn`, mm/s, then sags
    of strands by length and speed.
    """
    shorter = [_shorter(settings, speed) for speed in drawn]
    matter = settings.material.matter(settings.strand_mm)
    air, hold_c = air_mm_s(settings), settings.material.holding_c
    speeds = sorted({speed for _, speed in strands})

    def predicted(place: Array) -> Array:
        blown, thick, drawn, hotter = (place * PRIORS).tolist()
        other = matter | {
            "glass_c": matter["glass_c"] + hotter,
            "melt_viscosity_pa_s": matter["melt_viscosity_pa_s"] * math.exp(thick),
            "draw": max(matter["draw"] + drawn, 1.0),
        }
        speed = air * math.exp(blown)
        pause = _core.cooling_time(other, hold_c + hotter, speed)
        found = [pause, *(share * pause for share in shorter)]
        sags: dict[tuple[float, float], float] = {}
        for laid in speeds:
            lengths = sorted({length for length, one in strands if one == laid})
            tell = _core.sags(other, speed, laid, lengths)
            sags |= {(length, laid): sag for length, sag in zip(lengths, tell, strict=True)}
        return np.array([*found, *(sags[strand] for strand in strands)])

    return predicted


def _shorter(settings: Settings, speed_mm_s: float) -> float:
    """Return the pause of a post that is drawn at a speed, to that at the speed of printing."""
    if speed_mm_s == settings.print_mm_s:
        return 1.0
    matter, air = settings.material.matter(settings.strand_mm), air_mm_s(settings)
    height, pull = min(_POST_MM, settings.slab_max_mm), settings.wire.pull_n
    own, other = (
        _core.holding_pause(matter, air, height, speed, pull, _LONGEST_S)
        for speed in (settings.print_mm_s, speed_mm_s)
    )
    return other / own if own > 0 else 1.0


def _slopes(model: Callable[[Array], Array], place: Array, values: Array) -> Array:
    """Return slopes at a place where the values are known, of shape (values, parameters)."""
    steps = np.eye(len(place)) * _STEP
    return np.array([(model(place + step) - values) / _STEP for step in steps]).T


def written(settings: Settings, answers: Answers, found: Fitted) -> str:
    """Return a TOML file with the calibration: for ``--load``, or ``--calibration``.

    Raises
    ------
    SettingError
        What was found is no calibration: answers are off what any machine does.
    """
    stiff = answers.stiff
    told: dict[str, Any] = {
        "date": answers.date,
        "measured": answers.words(),
        "strand_mm": round(settings.strand_mm, 9),
        "nozzle_c": settings.material.nozzle_c,
        "method": settings.printer.cooling.method,
        "print_mm_s": round(settings.print_mm_s, 4),
        "pause_s": round(found.pause_s, 3),
        "pause_spread_s": round(found.pause_spread_s, 3),
        "bending_n_mm2": None if stiff is None else stiff.bending_n_mm2,
        "bending_spread_n_mm2": 0.0 if stiff is None else stiff.spread_n_mm2,
        "sags": [
            {"length_mm": length, "sag_mm": round(sag, 3), "spread_mm": round(spread, 3)}
            for length, sag, spread in (found.sags_mm if answers.sags else ())
        ],
    }
    try:
        Calibration.model_validate(told)
    except ValueError as error:
        raise SettingError(
            f"what follows from the answers is no calibration: a pause of {found.pause_s:.3g} ± "
            f"{found.pause_spread_s:.2g} s, sags that are off by {found.misfit:.3g} times what can "
            "be measured; measure again"
        ) from error
    head = [
        f"Pause and sags of {settings.printer.name} with {settings.material.name}, as prints told.",
        "Of a model's parameters it holds none: many of them fit as well.",
    ]
    return toml_text.written({"calibration": told}, {}, head)
