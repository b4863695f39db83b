"""Hold ``wireprint.check`` against a judge by brute force on random G-codes.

``python tests/fuzz/check_brute.py [FILES] [SEED]``: nothing is printed but what one of both finds
and the other does not, and a count in the end. A file that differs is kept beside the script's
working folder, with the seed in its name.
"""

from __future__ import annotations

import random
import sys
import tempfile
from pathlib import Path

sys.path.append(str(Path(__file__).parents[1]))

from brute import Judge, Verdict
from random_gcode import gcode

import random_heads
import wireprint
from wireprint import Settings, catalogue, examples
from wireprint.rules import rules_of

#: Heads and limits that files are judged by, beside those of the profiles.
OTHERS = [
    [],
    [],
    ["head.slant_deg=20", "head.block_radius_mm=40", "head.carriage_radius_mm=50"],
    ["head.slant_deg=60", "head.block_radius_mm=12"],
    ["wire.span_limit_mm=15", "wire.free_end_limit_mm=6"],
]


def own_lines(settings: Settings, folder: Path) -> list[str]:
    """Lines of a print of our own: no more than a machine of brute force can judge."""
    path = folder / "cube.stl"
    path.write_bytes(examples.stl("cube"))
    made = wireprint.make(wireprint.load_mesh(path, height_mm=12), settings, compare=False)
    text = made.gcode.decode().split("\n")
    known = ("G0", "G1", "G4", "G28", "G9", "M82", "M83", "M104", "M109", "M84", "M220", "M221")
    return [line for line in text if line.startswith(known)]


def case(seed: int, folder: Path) -> tuple[list[str], Settings]:
    """Return the lines of a random file, and what to judge it by."""
    draw = random.Random(seed)
    printer = draw.choice(catalogue.names("printers"))
    overrides = [*draw.choice(OTHERS), *random_heads.parts(random.Random(f"head {seed}"))]
    settings = Settings.load(printer, overrides=overrides)
    return gcode(draw, settings, own_lines(Settings.load(printer), folder)), settings


def differences(lines: list[str], settings: Settings) -> list[str]:
    """Say what one judge finds and the other does not."""
    found = wireprint.check("\n".join(lines).encode(), settings)
    rules = rules_of(settings)
    brute: Verdict = Judge(lines, settings, rules).judge()
    wrong = []
    if found.unjudged:
        wrong.append(f"unjudged: {found.unjudged[0]}")
    for rule, breaches in found.breaches().items():
        if rule == "unjudged":
            continue
        told = {breach.line for breach in breaches}
        certain = brute.found.get(rule, set())
        possible = certain | brute.grazes.get(rule, set())
        if missed := certain - told:
            wrong.append(f"missed {rule}: lines {sorted(missed)[:5]}")
        if extra := told - possible:
            wrong.append(f"only check finds {rule}: lines {sorted(extra)[:5]}")
    return wrong


def main() -> None:
    """Judge files until one has seen them all."""
    count = int(sys.argv[1]) if len(sys.argv) > 1 else 500
    first = int(sys.argv[2]) if len(sys.argv) > 2 else 0
    differ = bad = 0
    with tempfile.TemporaryDirectory() as folder:
        for seed in range(first, first + count):
            lines, settings = case(seed, Path(folder))
            wrong = differences(lines, settings)
            bad += not wireprint.check("\n".join(lines).encode(), settings).ok
            differ += bool(wrong)
            for sentence in wrong:
                print(f"seed {seed}: {sentence}", flush=True)
    print(f"{count} files, {bad} of them not printable, {differ} judged differently")
    sys.exit(differ > 0)


if __name__ == "__main__":
    main()
