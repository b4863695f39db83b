"""Kill programs while they write, and see that nothing is left and nothing torn.

``python tests/fuzz/kills.py [KILLS] [SEED]``: a program that writes one file again and again, some
new and some in place of an older one, is killed after a random time; half of the kills are Ctrl-C.
After each the files hold what was written once as a whole. In the end one more program writes, and
no name is left that is not a file's.
"""

from __future__ import annotations

import random
import signal
import subprocess
import sys
import tempfile
import time
from pathlib import Path

WRITER = """
import signal
import sys
from pathlib import Path
from wireprint.files import written_whole
folder, rounds = Path(sys.argv[1]), int(sys.argv[2])
# A shell's background jobs inherit that it is ignored.
signal.signal(signal.SIGINT, signal.default_int_handler)
print("begin", flush=True)
for number in range(rounds):
    name = folder / ("same.gcode" if number % 2 else f"new{number % 50}.gcode")
    if number % 2 == 0:
        name.unlink(missing_ok=True)
    written_whole(name, bytes([65 + number % 26]) * 200_000)
"""
#: A program is killed within this time of its first write, s.
WITHIN_S = 0.05


def kill_writers(folder: Path, kills: int, seed: int) -> list[str]:
    """Return what is wrong: files that are torn, and names that are left in the end."""
    draw = random.Random(seed)
    wrong = []
    for number in range(kills):
        writer = start(folder, 1_000_000)
        time.sleep(draw.uniform(0, WITHIN_S))
        writer.send_signal(draw.choice([signal.SIGKILL, signal.SIGINT]))
        writer.wait()
        wrong += [f"{number}: {path.name} is torn" for path in folder.glob("*.gcode") if torn(path)]
    start(folder, 4).wait()
    wrong += [f"left: {path.name}" for path in folder.iterdir() if path.suffix != ".gcode"]
    return wrong


def start(folder: Path, rounds: int) -> subprocess.Popen[str]:
    """Start a program that writes; return it when it is about to."""
    command = [sys.executable, "-c", WRITER, str(folder), str(rounds)]
    pipes = {"stdout": subprocess.PIPE, "stderr": subprocess.DEVNULL, "text": True}
    writer = subprocess.Popen(command, **pipes)
    assert writer.stdout is not None
    with writer.stdout as told:
        told.readline()
    return writer


def torn(path: Path) -> bool:
    """Whether a file is not one letter, as often as it shall be."""
    content = path.read_bytes()
    return content != content[:1] * 200_000


if __name__ == "__main__":
    given = [int(word) for word in sys.argv[1:]]
    count, begin = [*given, *(500, 1)[len(given) :]]
    with tempfile.TemporaryDirectory() as scratch:
        found = kill_writers(Path(scratch), count, begin)
    print("\n".join(found) or f"{count} kills: nothing torn, nothing left")
    sys.exit(bool(found))
