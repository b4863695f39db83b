"""What a forecast costs, and that a slice without one costs what it would without any physics.

python benches/forecast_cost.py

Processor time of one thread (RAYON_NUM_THREADS=1 is set before the core is loaded), the best of
some runs, in turn. Fails where a bunny of 100 mm takes more than 1 s, 20 000 strands more than 10,
or a slice more than a twentieth longer than one whose pause is a number.
"""

import os
import sys
import time
from functools import partial

os.environ["RAYON_NUM_THREADS"] = "1"

import shared_models
from wireprint import Settings, cooling, load_mesh, make, simulate

BUNNY = shared_models.SHARED / "models" / "bunny.stl"
#: Heights of a bunny, mm, and what its forecast may take, s; the last has some 20 000 strands.
FORECASTS = ((100.0, 1.0), (345.0, 10.0))
RUNS, LONGER = 5, 1.05


def seconds(work):
    """Processor time of some work, s."""
    begin = time.process_time()
    work()
    return time.process_time() - begin


def main():
    """Measure, print, and fail where something is too slow."""
    bad = False
    for height_mm, most_s in FORECASTS:
        settings = shared_models.roomy("kossel-mini/abs")
        text = make(load_mesh(BUNNY, height_mm=height_mm), settings, compare=False).gcode
        count = len(simulate(text, settings).line)
        took = min(seconds(partial(simulate, text, settings)) for _ in range(3))
        print(f"bunny of {height_mm:g} mm, {count} strands: {took:.2f} s, at most {most_s:g}")
        bad |= took > most_s
    mesh = load_mesh(BUNNY, height_mm=100.0)
    fixed = Settings.load(overrides=[f"wire.pause_s={Settings.load().pause_s!r}"])
    runs = {"auto": [], "a number": []}
    for _ in range(RUNS):
        for name, settings in (("auto", Settings.load()), ("a number", fixed)):
            cooling._holds_s.cache_clear()
            runs[name].append(seconds(partial(make, mesh, settings, compare=False)))
    best = {name: min(times) for name, times in runs.items()}
    ratio = best["auto"] / best["a number"]
    print(
        f"slice: {best['auto']:.3f} s, with a pause as a number {best['a number']:.3f}: {ratio:.3f}"
    )
    sys.exit(bad or ratio > LONGER)


if __name__ == "__main__":
    main()
