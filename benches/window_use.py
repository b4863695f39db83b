"""Uses a window for ten minutes, and tells how its memory and its answers change.

python benches/window_use.py [--seconds 600] [--seed 1]

Paints, erases, undoes, changes printers and settings, and saves the model anew, each as fast as the
print of it comes. Ten times meanwhile it makes the same strokes on the same model, and compares
what they take. Fails where memory grows by more than it may, or strokes are slower at the end.
"""

import argparse
import sys
import tempfile
import time
from pathlib import Path

from wireprint import examples

sys.path.insert(0, str(Path(__file__).resolve().parent.parent / "tests/studio"))

from studio_talk import Talk, source_of
from studio_use import MOST_MB, WARMING, Use

#: A line is written so often.
LINES = 10
#: Strokes that take so many times as long at the end are slower: others use the machine, too.
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
    """Use a window for so long; return the most that it grew by, MB, and how much slower it became.

    What it holds depends on the model and on what is marked, so the same strokes on the same cube
    are compared, from the first line to the last.
    """
    for _ in range(WARMING):
        use.deed()
    first, begin, deeds, grown = use.probe(), time.monotonic(), 0, []
    print(f"{first.resident_mb:.1f} MB, a stroke {first.stroke_s:.3f} s of the processor")
    for line in range(1, LINES + 1):
        while time.monotonic() - begin < seconds * line / LINES:
            use.deed()
            deeds += 1
        last = use.probe()
        grown.append(last.resident_mb - first.resident_mb)
        print(f"{deeds:5} deeds: {grown[-1]:+.1f} MB, a stroke {last.stroke_s:.3f} s", flush=True)
    return max(grown), last.stroke_s / first.stroke_s


if __name__ == "__main__":
    sys.exit(main())
