"""Fuzz the settings: ``python tests/fuzz/settings.py --seconds 600 --seed 1``.

Small models are sliced with settings that hypothesis draws (`strategies`), each in a process of its
own; what must hold is what `commands` asks of every command. What fails is shown as small as
hypothesis can make it, with the command line that shows it.
"""

from __future__ import annotations

import argparse
import importlib
import os
import sys
import tempfile
import time
from collections import Counter
from pathlib import Path

import hypothesis
from commands import MODULES, run
from hypothesis import HealthCheck, Phase, given
from hypothesis import strategies as st
from inputs import Case
from strategies import Drawn, drawn

#: Cases of one round; a round that fails is shrunk, and the next one has another seed.
ROUND = 200
MODELS = ["cube", "sphere", "arch"]


def case_of(settings: Drawn, model: str) -> Case:
    """The command that slices a model with these settings."""
    words = ["slice", f"{model}.stl", "--height", "15", "-o", "out.gcode"]
    words += ["--printer", settings.printer, "--material", settings.material]
    for override in settings.overrides:
        words += ["--set", override]
    names = [key.rpartition(".")[2] for key in settings.keys]
    return Case("settings", words, ["--set", f"{model}.stl", *names])


def main() -> int:
    """Run rounds until the time is over."""
    options = argparse.ArgumentParser(description=__doc__)
    options.add_argument("--seconds", type=float, default=60)
    options.add_argument("--seed", type=int, default=1)
    asked = options.parse_args()
    for name in MODULES:
        importlib.import_module(f"wireprint.{name}")
    from wireprint import examples

    counts: Counter[str] = Counter()
    most = [0.0, 0.0]
    failed = 0
    with tempfile.TemporaryDirectory() as scratch:
        os.environ["XDG_CACHE_HOME"] = os.environ["XDG_CONFIG_HOME"] = scratch
        folder = Path(scratch)
        for model in MODELS:
            (folder / f"{model}.stl").write_bytes(examples.stl(model))
        end = time.monotonic() + asked.seconds

        number = 0
        while time.monotonic() < end:
            # One for each round: hypothesis decorates a function once.
            @given(drawn(), st.sampled_from(MODELS))
            def holds(settings: Drawn, model: str) -> None:
                out = folder / "out.gcode"
                out.unlink(missing_ok=True)
                if time.monotonic() > end:
                    return
                case = case_of(settings, model)
                wrong, seconds, most_mb = run(case, folder)
                counts["printed" if out.exists() else "refused"] += 1
                most[:] = max(most[0], seconds), max(most[1], most_mb)
                assert not wrong, f"{case.words}: {wrong}"

            seeded = hypothesis.seed(f"{asked.seed} {number}")(holds)
            try:
                hypothesis.settings(
                    max_examples=ROUND,
                    deadline=None,
                    database=None,
                    phases=[Phase.generate, Phase.shrink],
                    suppress_health_check=list(HealthCheck),
                )(seeded)()
            except AssertionError as error:
                failed += 1
                print(f"seed {asked.seed} round {number}: {error}", flush=True)
            number += 1
    told = ", ".join(f"{kind} {count}" for kind, count in sorted(counts.items()))
    print(f"{sum(counts.values())} settings ({told}), {failed} failed; ", end="")
    print(f"at most {most[0]:.1f} s, {most[1]:.0f} MB")
    return min(failed, 1)


if __name__ == "__main__":
    sys.exit(main())
