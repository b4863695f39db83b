"""A window in use for long holds no more than at its beginning; see `benches/window_use.py`."""

import platform
from pathlib import Path

import numpy as np
import pytest
from studio_use import MOST_MB, WARMING, Use, resident_mb

from wireprint.window import heap

DEEDS = 20


@pytest.mark.skipif(not Path("/proc/self/statm").exists(), reason="needs /proc")
def test_a_window_in_use_does_not_grow(talk, cube):
    use = Use(talk, cube, seed=3)
    for _ in range(WARMING):
        use.deed()
    before = use.probe()
    for _ in range(DEEDS):
        use.deed()
    assert use.probe().resident_mb - before.resident_mb < MOST_MB


@pytest.mark.skipif(platform.libc_ver()[0] != "glibc", reason="needs glibc's malloc_trim")
def test_memory_that_is_free_goes_back_to_the_system():
    # So small that they come from the heap, which the last of them keeps from shrinking by itself.
    parts = [np.ones(8_000) for _ in range(1_000)]
    last = parts.pop()
    parts.clear()
    held = resident_mb()
    heap.give_back()
    assert resident_mb() < held - 32
    assert last.all()
