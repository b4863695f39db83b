"""The progress bar: only where something takes long and a terminal shows it."""

import os
import pty
import subprocess
import sys

CODE = """
import sys, time
from wireprint.cli import main, progress
import wireprint.stages
progress.PATIENCE_S = float(sys.argv.pop(1))
real = wireprint.stages.wireframe
def slow(*arguments):
    time.sleep(1.0)
    return real(*arguments)
wireprint.stages.wireframe = slow
main()
"""


def stderr_of_slow_run(model, patience_s):
    """What a run that takes a second writes to a terminal on stderr."""
    reader, terminal = pty.openpty()
    arguments = ["slice", str(model), "-o", str(model.with_suffix(".gcode")), "-q"]
    process = subprocess.Popen(
        [sys.executable, "-c", CODE, str(patience_s), *arguments],
        stderr=terminal,
        env=os.environ | {"TERM": "xterm", "COLUMNS": "100"},
    )
    os.close(terminal)
    shown = b""
    try:
        while chunk := os.read(reader, 4096):
            shown += chunk
    except OSError:  # the other end is closed
        pass
    os.close(reader)
    assert process.wait() == 0
    return shown.decode()


def test_a_long_run_shows_what_it_does_on_a_terminal(cube):
    assert "cube.stl: wireframe" in stderr_of_slow_run(cube, 0.1)


def test_a_run_that_ends_in_time_shows_nothing(cube):
    assert stderr_of_slow_run(cube, 100) == ""


def test_without_a_terminal_nothing_is_shown(cube):
    arguments = ["slice", str(cube), "-o", str(cube.with_suffix(".gcode")), "-q"]
    done = subprocess.run(
        [sys.executable, "-c", CODE, "0.1", *arguments], capture_output=True, check=True
    )
    assert done.stderr == b""
