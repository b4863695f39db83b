"""A million-triangle STL against admesh: ``pytest benches --benchmark-enable``."""

import shutil
import subprocess
import time

import pytest

from wireprint.mesh import load_mesh


def test_a_million_triangles_load_three_times_faster_than_in_admesh(benchmark, million):
    if not benchmark.enabled:
        pytest.skip("a ratio of times: needs --benchmark-enable")
    admesh = shutil.which("admesh")
    if admesh is None:
        pytest.skip("admesh is not installed")
    benchmark.pedantic(load_mesh, [million], rounds=10, warmup_rounds=1)

    def peer():
        start = time.perf_counter()
        subprocess.run([admesh, million], stdout=subprocess.DEVNULL, check=True)
        return time.perf_counter() - start

    ratio = min(peer() for _ in range(5)) / benchmark.stats["min"]
    benchmark.extra_info["times faster than admesh"] = round(ratio, 2)
    assert ratio >= 3
