"""Holds the growing frame against sparse solves of its parts: all shared models, 30, 60 and 90 %.

python benches/frames.py [--most STRANDS] [--only NAME] [--machine PRINTER/MATERIAL]

For each model of `../shared/models` on a roomy bed: the compliance that a free end had when its
strand was laid, by the forecast, and the worst that the rule `meets` tells, against those of the
frame up to there, solved as a whole by scipy. Fails where one is off by more than 1e-8, or none is
found; where a print is softest, by mm under the nozzle's pull, a solve as a whole keeps seven
digits, and so much may be off there.
"""

import argparse
import sys
from dataclasses import asdict

import numpy as np

import shared_models
from wireprint.bench.plan import Placement, plan
from wireprint.forecast import simulate
from wireprint.frames import Frame, flexibility, shifts_under
from wireprint.model import load_model
from wireprint.pipeline import make

SHARES = (0.3, 0.6, 0.9)
ALLOWED, ALLOWED_WHERE_SOFTEST = 1e-8, 1e-7


def free_end(frame, first):
    """The first strand from `first` on that ends freely when it is laid, and the node there."""
    for strand in range(first, int(frame.strands.max()) + 1):
        own = frame.ends[frame.strands == strand]
        if len(own):
            node = own[-1][1]
            laid = frame.ends[frame.strands <= strand]
            if not frame.on_bed[node] and np.count_nonzero(laid == node) == 1:
                return strand, node
    return None


def gives(laid, place, settings):
    """How far the place of a frame gives way under a force, whatever its direction, mm/N."""
    at = int(np.argmin(np.linalg.norm(laid.places - place, axis=1)))
    units = [np.zeros((len(laid.places), 3)) for _ in range(3)]
    for axis, unit in enumerate(units):
        unit[at, axis] = 1.0
    flexible = flexibility(laid, settings.strand_mm, settings.material.modulus_mpa)
    shifts = shifts_under(laid, flexible, laid.on_bed, units)
    block = np.array([shift[at, :3] for shift in shifts])
    return np.linalg.eigvalsh((block + block.T) / 2)[-1]


def met(frame, line):
    """The strand of a line that meets what was there: at which nodes, and what was laid before.

    A beam is laid from what holds it; what nothing holds is left out.
    """
    held, kept = frame.on_bed.copy(), np.zeros(len(frame.ends), bool)
    for beam, (start, end) in enumerate(frame.ends):
        if not held[[start, end]].any():
            continue
        node = end if held[start] else start
        if frame.lines[beam] == line and held[[start, end]].all() and not frame.on_bed[node]:
            yield node, kept.copy()
        held[[start, end]] = kept[beam] = True


def off(gcode, settings):
    """Places, how far each is off and may be: at shares of a print, and where it is softest."""
    forecast = simulate(gcode, settings)
    compliance, worst = forecast.compliance_mm_n, forecast.rules["meets"]
    frame = Frame.of(gcode, settings)
    frame = frame.only(~frame.on_bed[frame.ends].all(axis=1))
    for share in SHARES:
        found = free_end(frame, round(share * int(frame.strands.max())))
        if found is None or np.isnan(compliance[found[0]]):
            continue
        strand, node = found
        expected = gives(frame.only(frame.strands <= strand), frame.places[node], settings)
        yield f"strand {strand}", abs(compliance[strand] / expected - 1), ALLOWED
    softest = [
        gives(frame.only(laid), frame.places[node], settings)
        for node, laid in met(frame, worst.line)
    ]
    if softest:
        wrong = abs(worst.detail / max(softest) - 1)
        yield f"{worst.worst:.2g} mm at worst", wrong, ALLOWED_WHERE_SOFTEST


def main():
    """Compare all, and say what is off."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--most", type=int, default=10**9, help="skip prints of more strands")
    parser.add_argument("--only", default="", help="models whose file's name has this text")
    parser.add_argument("--machine", default="kossel-mini/abs", help="printer and material")
    options = parser.parse_args()
    settings = shared_models.roomy(options.machine)
    manifest = str(shared_models.SHARED / "models" / "manifest.csv")
    worst, compared, failed = 0.0, 0, 0
    for task in plan([manifest], Placement(), {}):
        if options.only not in task.model:
            continue
        try:
            mesh = load_model(task.model, **asdict(task.placement)).mesh
            made = make(mesh, settings, partial=True, compare=False)
        except ValueError as error:
            print(task.model, error, flush=True)
            continue
        if made.wireframe.strand_count > options.most:
            continue
        for place, wrong, allowed in off(made.gcode, settings):
            worst, compared, failed = max(worst, wrong), compared + 1, failed + (wrong > allowed)
            print(f"{task.model} {place}: {wrong:.1e}", flush=True)
    print(f"{compared} places compared, off by {worst:.1e} at worst")
    sys.exit(failed > 0 or compared == 0)


if __name__ == "__main__":
    main()
