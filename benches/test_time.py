"""Print time of large files: `pytest benches/test_time.py --benchmark-enable -s`.

How fast that is beside a pass that only reads the numbers, `cargo bench --bench planner` tells.
"""

import math
import os
import subprocess
import sys

import pytest

from wireprint.timing import estimate

MOVES = 600_000
FILES = 8


@pytest.fixture(scope="module")
def text():
    """17 MB as a slicer writes them: outlines of short strokes, straight infill."""
    lines = ["G21", "G90", "M83", "G28"]
    for layer in range(MOVES // 500):
        z = 0.2 * (layer + 1)
        lines += [";LAYER_CHANGE", f";Z:{z:.1f}", ";TYPE:Perimeter", f"G1 Z{z:.1f} F9000"]
        for i in range(400):
            angle = math.tau * i / 400
            radius = 40 + 4 * math.sin(5 * angle + z)
            x, y = 125 + radius * math.cos(angle), 105 + radius * math.sin(angle)
            lines.append(f"G1 X{x:.3f} Y{y:.3f} E.0245")
        lines += [";TYPE:Internal infill", "G1 F3600"]
        lines += [f"G1 X{90 + 0.7 * i:.3f} Y{80 + i % 2 * 50:.3f} E1.8663" for i in range(100)]
    return "\n".join(lines).encode()


@pytest.mark.parametrize("firmware", ["klipper", "marlin", "marlin-jerk"])
def test_moves_a_second_on_one_thread(benchmark, text, firmware, capsys):
    options = {"printer": "prusa-mk4s", "firmware": firmware}
    found = benchmark.pedantic(estimate, (text,), options, rounds=20, warmup_rounds=1)
    rate = found.moves / benchmark.stats.stats.min / 1e6
    with capsys.disabled():
        print(f"\n{firmware}: {rate:.1f} M moves/s, {len(text) / 1e6:.1f} MB")


@pytest.mark.skipif((os.cpu_count() or 1) < 4, reason="needs four cores")
def test_four_cores_time_files_two_and_a_half_times_as_fast(benchmark, text, tmp_path, capsys):
    paths = [tmp_path / f"{i}.gcode" for i in range(FILES)]
    for path in paths:
        path.write_bytes(text)
    script = (
        "import sys, time\n"
        "from wireprint.timed_machine import Choice\n"
        "from wireprint.timing import estimate_files\n"
        "choice = Choice(printer='prusa-mk4s', firmware='klipper')\n"
        "times = []\n"
        "for _ in range(5):\n"
        "    begin = time.perf_counter()\n"
        "    estimate_files(sys.argv[1:], choice)\n"
        "    times.append(time.perf_counter() - begin)\n"
        "print(min(times))\n"
    )

    def seconds(threads):
        environment = {**os.environ, "RAYON_NUM_THREADS": str(threads)}
        command = [sys.executable, "-c", script, *paths]
        run = subprocess.run(command, env=environment, capture_output=True, text=True, check=True)
        return float(run.stdout)

    one, four = seconds(1), benchmark.pedantic(seconds, (4,))
    with capsys.disabled():
        print(f"\n{FILES} files: {one:.3f} s on one core, {four:.3f} s on four, {one / four:.1f}×")
    assert one > 2.5 * four
