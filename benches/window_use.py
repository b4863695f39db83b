"""Uses a window for ten minutes, and tells how its memory and its answers change.

python benches/window_use.py [--seconds 600] [--seed 1]

Paints, erases, undoes, changes printers and settings, and saves the model anew, each as fast as the
print of it comes. Fails where memory grows by more than it may, or strokes are slower at the end.
"""

import argparse
import statistics
import sys
import tempfile
import time
from pathlib import Path

from wireprint import examples

sys.path.insert(0, str(Path(__file__).resolve().parent.parent / "tests/studio"))

from studio_talk import Talk, source_of
from studio_use import MOST_MB, WARMING, Use, resident_mb

#: A line is written so often.
LINES = 10
#: The first and the last so many strokes are compared.
STROKES = 20
#: Where the last ones take so many times as long, they are slower: printers differ by less.
SLOWER = 1.5


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--seconds", type=float, default=600.0)
    parser.add_argument("--seed", type=int, default=1)
    options = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        model = Path(folder) / "cube.stl"
        model.write_bytes(examples.stl("cube"))
        with Talk(source_of(model)) as talk:
            grown_mb, slower = used(Use(talk, model, options.seed), options.seconds)
    return 0 if grown_mb < MOST_MB and slower < SLOWER else 1


def used(use, seconds):
    """Use a window for so long; return what it grew by, MB, and how much slower strokes became."""
    for _ in range(WARMING):
        use.deed()
    before, begin, deeds = resident_mb(), time.monotonic(), 0
    use.strokes_s.clear()
    for line in range(1, LINES + 1):
        while time.monotonic() - begin < seconds * line / LINES:
            use.deed()
            deeds += 1
        grown = resident_mb() - before
        print(f"{deeds:5} deeds: {grown:+.1f} MB", flush=True)
    parts = use.strokes_s[:STROKES], use.strokes_s[-STROKES:]
    first_s, last_s = (statistics.median(part) for part in parts)
    print(f"strokes: {first_s:.3f} s of the processor at the beginning, {last_s:.3f} s at the end")
    return grown, last_s / first_s


if __name__ == "__main__":
    sys.exit(main())
