"""How long a command takes that has nothing to do."""

import subprocess
import sys
import time


def seconds(*arguments, runs=7):
    """Shortest time of a Python process."""
    times = []
    for _ in range(runs):
        begin = time.perf_counter()
        subprocess.run([sys.executable, *arguments], stdout=subprocess.DEVNULL, check=True)
        times.append(time.perf_counter() - begin)
    return min(times)


def test_help_takes_at_most_twice_as_long_as_importing_numpy():
    help_s = seconds("-c", "from wireprint.cli import main; main()", "--help")
    assert help_s < 2 * seconds("-c", "import numpy")


def test_importing_the_package_takes_at_most_half_as_long_as_importing_numpy():
    empty_s = seconds("-c", "pass")
    numpy_s = seconds("-c", "import numpy") - empty_s
    assert seconds("-c", "import wireprint") - empty_s < numpy_s / 2
