"""Fits synthetic ladders and harps: how often pause and sag come out as they were.

python benches/recovery.py [--seeds N] [--from SEED] [--printer NAME] [--material NAME]
    [--errors even|normal|heavy|biased]

Each machine is drawn from the priors; its pause is read within ±0.1 s, its sags within ±0.15 mm,
all of that as likely. Fails where the predicted pause is within 0.15 s, and the sag of a strand of
20 mm within 0.1 mm, for fewer than 95 of 100. Other errors are none that the fit assumes, and tell
how it degrades: `normal` has these as its deviations (13 of 100 are beyond 0.15 s by themselves),
`heavy` are Student's with two degrees of freedom and half of these as their scale, `biased` are
even ones about what is read too high throughout, by as much as they may be off.
"""

import argparse
import functools
import json
import math
import sys

import numpy as np

from wireprint import Settings, _core
from wireprint.calibration.answers import SAG_WITHIN_MM, Answers, Held, Sag
from wireprint.calibration.fit import PRIORS, fitted
from wireprint.calibration.tents import LENGTHS_MM, STRANDS
from wireprint.forecast_terms import air_mm_s

PAUSE_S, WITHIN_S, WITHIN_MM, OFTEN = 0.1, 0.15, 0.1, 0.95


def truth(settings, rng):
    """A machine as the priors say that it may be: its pause, and what tells its sags."""
    matter = settings.material.matter(settings.strand_mm)
    blown, thick, drawn, hotter = (rng.standard_normal(4) * PRIORS).tolist()
    other = matter | {
        "glass_c": matter["glass_c"] + hotter,
        "melt_viscosity_pa_s": matter["melt_viscosity_pa_s"] * math.exp(thick),
        "draw": max(1.0, matter["draw"] + drawn),
    }
    speed = air_mm_s(settings) * math.exp(blown)
    pause = _core.cooling_time(other, settings.material.holding_c + hotter, speed)
    return pause, lambda laid: _core.sags(other, speed, laid, list(LENGTHS_MM))


#: Errors of what is read, by how far it may be off.
ERRORS = {
    "even": lambda rng, within: rng.uniform(-within, within),
    "normal": lambda rng, within: rng.normal(0, within),
    "heavy": lambda rng, within: rng.standard_t(2) * within / 2,
    "biased": lambda rng, within: within + rng.uniform(-within, within),
}


def remembering(sags):
    """Rods that were laid already are told again: all fits begin at the same place."""

    @functools.cache
    def known(matter, *rest):
        return sags(json.loads(matter), *rest[:-1], list(rest[-1]))

    return lambda matter, air, speed, lengths: known(json.dumps(matter), air, speed, tuple(lengths))


def recovered(settings, seed, error):
    """How far pause (s) and the sag of the shortest strand (mm) are off for one machine."""
    rng = np.random.default_rng(seed)
    pause, sags = truth(settings, rng)
    laid = {
        (share, length): sag
        for share in dict(STRANDS)
        for length, sag in zip(LENGTHS_MM, sags(share * settings.print_mm_s), strict=True)
    }
    measured = tuple(
        Sag(
            length,
            share * settings.print_mm_s,
            max(0.0, laid[share, length] + error(rng, SAG_WITHIN_MM)),
        )
        for share, length in STRANDS
    )
    told = max(0.01, pause + error(rng, PAUSE_S))
    held = Held("ladder", settings.print_mm_s, told, PAUSE_S / math.sqrt(3))
    found = fitted(settings, Answers("2026-11-27", (held,), measured))
    return found.pause_s - pause, found.sags_mm[0][1] - laid[STRANDS[0]]


def main():
    """Fit them all, and say how often each came out."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--seeds", type=int, default=100)
    parser.add_argument("--from", dest="first", type=int, default=0, help="the first seed")
    parser.add_argument("--printer", default="prusa-mk4s")
    parser.add_argument("--material", default="pla")
    parser.add_argument("--errors", choices=ERRORS, default="even", help="of what is read")
    options = parser.parse_args()
    settings = Settings.load(options.printer, options.material)
    _core.sags = remembering(_core.sags)
    seeds = range(options.first, options.first + options.seeds)
    off = []
    for seed in seeds:
        off.append(np.abs(recovered(settings, seed, ERRORS[options.errors])))
        print(f"{seed}: pause {off[-1][0]:.3f} s, sag {off[-1][1]:.3f} mm", file=sys.stderr)
    shares = np.mean(np.array(off) <= (WITHIN_S, WITHIN_MM), axis=0)
    for name, share, at in zip(
        ("pause", "sag"), shares, np.quantile(off, 0.95, axis=0), strict=True
    ):
        print(f"{name}: {share:.0%} within the limit; 95 % within {at:.3f}")
    sys.exit(bool((shares < OFTEN).any()))


if __name__ == "__main__":
    main()
