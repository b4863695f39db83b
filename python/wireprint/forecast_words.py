"""A forecast in words: a sentence for each rule, with the worst place and what can be done."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any, Final

from wireprint import _core
from wireprint.forecast_terms import air_mm_s

if TYPE_CHECKING:
    from wireprint.forecast import Forecast, Rule
    from wireprint.settings import Settings

#: No pause is advised that is longer, s.
_LONGEST_PAUSE_S: Final = 20.0

#: A squeeze beyond this is none of a small deformation, mm.
_SMALL_MM: Final = 1.0

_WHAT: Final = {
    "holds": ("posts", "lean by {} when the nozzle leaves them"),
    "sags": ("stretches", "sag by {}"),
    "meets": ("places that strands end on", "be pulled aside by {}"),
    "flows": ("strokes", "get {} more or less than their material"),
    "knots": ("knots", "stand out of their strand by {}"),
}


_NONE: Final = {
    "holds": "no post ends in the air",
    "sags": "no stretch hangs in the air",
    "meets": "no strand ends on another above the bed",
    "flows": "no stroke is long enough to tell",
    "knots": "nothing gathers where the head stands",
    "welds": "no strand is joined to another",
}


def told(forecast: Forecast) -> dict[str, Any]:
    """Return figures and words as values that JSON knows."""
    return forecast.to_dict() | {
        "sentences": sentences(forecast),
        "unknown": unknown(forecast.judge.settings),
    }


def sentences(forecast: Forecast) -> list[str]:
    """Return a sentence for each rule."""
    settings = forecast.judge.settings
    return [
        f"{name}: {_sentence(rule, forecast, settings)}" for name, rule in forecast.rules.items()
    ]


def unknown(settings: Settings) -> list[str]:
    """Return what a forecast does not know, in sentences."""
    known = settings.calibrated_by()
    if known is None:
        trust = (
            "Nothing of it was measured on this printer: each figure may be half or twice as large "
            "(wireprint calibrate)."
        )
        if settings.calibration is not None:
            then = settings.calibration
            trust += (
                f" The calibration of {then.date} was measured with a {then.strand_mm:g} mm strand "
                f"at {then.nozzle_c:g} °C and cooling by {then.method}; what differs from that "
                "asks for a new ladder."
            )
    else:
        trust = (
            f"What was measured on {known.date} ({'; '.join(known.measured)}) tells pause, sags "
            "and stiffness within the spread of its fit; all other figures may be half or twice "
            "as large."
        )
    return [
        trust,
        "Joints are taken as rigid, strands as straight and of one thickness: a print gives way at "
        "least as far as is told.",
        "Welds are a ranking of places, not a strength; what a hand may press with is a bound for "
        "ideal joints and small squeezes, no promise, and for fingers at half of the height alone: "
        "a handle or a rim may bear less.",
        "Left out: what the nozzle pushes when it meets a knot, curling and warping, vibration, "
        "draughts between strands, humidity, crystallisation, strings over travels.",
        "It is no part of the certificate, and no promise that a print succeeds.",
    ]


def figure(value: float) -> str:
    """Write a number with the two digits that it is good for."""
    if value == 0 or not math.isfinite(value):
        return f"{value:g}"
    rounded = float(f"{value:.1e}")
    decimals = max(0, 1 - math.floor(math.log10(abs(rounded))))
    told = f"{rounded:.{min(decimals, 4)}f}"
    return told if float(told) else "0"


def _amount(value: float, unit: str) -> str:
    return f"{figure(value)} {unit}" if unit else f"{figure(100 * value)} %"


def _sentence(rule: Rule, forecast: Forecast, settings: Settings) -> str:
    if rule.worst is None:
        return _why_not(rule, forecast, settings)
    x, y, z = rule.place_mm or (0.0, 0.0, 0.0)
    where = f"at ({x:.1f}, {y:.1f}, {z:.1f}), line {rule.line}"
    if rule.name == "welds":
        return _of_welds(rule, forecast, where)
    if rule.name == "grips":
        return _of_grip(rule, forecast, where)
    things, verb = _WHAT[rule.name]
    limit = rule.limit or 0.0
    low, high = (_amount(bound, rule.unit) for bound in rule.bounds or (0.0, 0.0))
    between = f" ({low} to {high})" if low != high else ""
    worst = f"{_amount(rule.worst, rule.unit)}{between} {where}"
    too_much = verb.format(f"more than {_amount(limit, rule.unit)}")
    if rule.name == "meets" and forecast.core.layers_rigid:
        worst += ", layers taken as rigid"
    if rule.verdict == "passes":
        return f"none of {rule.of} {things} would {too_much}: at most {worst}"
    if rule.over == 0:
        return (
            f"{things} may {too_much}, which is not sure: at most {worst}; "
            f"{_remedy(rule, forecast, settings)}"
        )
    surely = "would" if rule.verdict == "fails" else "might"
    return (
        f"{rule.over} of {rule.of} {things} {surely} {too_much}: the worst {worst}; "
        f"{_remedy(rule, forecast, settings)}"
    )


def _of_welds(rule: Rule, forecast: Forecast, where: str) -> str:
    share = 1 - (rule.worst or 0.0)
    return (
        f"half of {rule.of} strands weld to at least {100 * (forecast.weld_median or 0):.0f} % "
        f"where they are weaker (a ranking); the weakest to {100 * share:.0f} %, on a strand that "
        f"has cooled to {rule.detail:.0f} °C, {where}; hotter: material.nozzle_c, a warm chamber"
    )


def _of_grip(rule: Rule, forecast: Forecast, where: str) -> str:
    found = forecast.grip
    if found is None:
        return _why_not(rule, forecast, forecast.judge.settings)
    low, high = (_amount(bound, rule.unit) for bound in rule.bounds or (0.0, 0.0))
    strength = forecast.judge.settings.material.strength_mpa
    return (
        f"two fingers that press with {figure(found.force_n)} N along {found.along} at half its "
        f"height come {_amount(found.squeeze_mm, 'mm')} closer ({low} to {high}, with ideal "
        f"joints); one strand in a hundred is at its strength of {strength:g} MPa with "
        f"{figure(found.bears_n)} N, the most strained {where}"
        + ("" if found.squeeze_mm <= _SMALL_MM else "; so far, it is a ranking only")
    )


def _why_not(rule: Rule, forecast: Forecast, settings: Settings) -> str:
    if rule.name in ("flows", "knots") and settings.printer.extruder.pressure_lag_s <= 0:
        return (
            "not judged: extruder.pressure_lag_s is 0; the firmware's own test of pressure or "
            "linear advance tells it"
        )
    if rule.name == "grips":
        return f"not judged: {forecast.ungripped}"
    if rule.name == "meets" and not forecast.core.frame_judged:
        return (
            "not judged: so large a frame would take too much work, and all else is forecast; "
            "higher slabs (--slab-max), a thicker nozzle, or a part of the model by itself do not"
        )
    if rule.name == "meets" and forecast.core.layers_rigid:
        return "nothing ends on wire in this file: layers are taken as rigid"
    return f"{_NONE[rule.name]} in this file"


def _remedy(rule: Rule, forecast: Forecast, settings: Settings) -> str:
    """Say what can be done about a rule that fails."""
    cooling = settings.printer.cooling
    if rule.name == "holds":
        return _longer_pause(rule, forecast, settings)
    if rule.name == "sags":
        if rule.detail == 0 and cooling.method != "none":
            return f"no air blows there: switch it on (cooling.method is {cooling.method})"
        if cooling.method == "none":
            return "let air blow (cooling.method), or keep stretches short"
        return "keep stretches short (--slab-max lower, wire.cap_spacing_mm), or print slower"
    if rule.name == "meets":
        return "print lower slabs (--slab-max), a thicker strand, or a wider foot"
    lag = settings.printer.extruder.pressure_lag_s
    return (
        f"let the firmware make up for a lag of {lag:g} s (gcode.pressure_advance), or measure it "
        "anew (extruder.pressure_lag_s)"
    )


def _longer_pause(rule: Rule, forecast: Forecast, settings: Settings) -> str:
    limit, base = rule.limit or 0.0, rule.detail
    if base >= limit:
        return "what they stand on gives way, and no pause helps: print lower slabs (--slab-max)"
    cooling = settings.printer.cooling
    blows = forecast.core.air_blows
    # What they stand on gives way by `base`: the less the post itself may, as by a greater pull.
    pause_s = _core.holding_pause(
        settings.material.matter(settings.strand_mm),
        air_mm_s(settings) if blows else 0.0,
        rule.length_mm,
        settings.print_mm_s,
        settings.wire.pull_n * limit / (limit - base),
        _LONGEST_PAUSE_S,
    )
    if pause_s >= _LONGEST_PAUSE_S:
        return (
            f"a post of {rule.length_mm:.1f} mm is too soft even when it is cold: print lower "
            "slabs (--slab-max)"
        )
    known = settings.calibrated_by()
    pause_s *= 1.0 if known is None or not blows else known.pause_s / settings.solidify_s
    if blows or cooling.method == "none":
        more_air = "or let more air blow"
    else:
        more_air = f"or switch the air on, which never blows (cooling.method is {cooling.method})"
    # Up, lest the tenth that is told be a little short.
    pause_s = math.ceil(10 * pause_s) / 10
    if rule.over == 0:
        return (
            f"a pause of {2 * pause_s:.1f} s would be on the safe side, and wireprint calibrate "
            "ladder tells the true one"
        )
    return f"pause for {pause_s:.1f} s (--pause {pause_s:.1f}), {more_air}"
