"""A window in use for long holds no more than at its beginning; see `benches/window_use.py`."""

from pathlib import Path

import pytest
from studio_use import MOST_MB, WARMING, Use, resident_mb

DEEDS = 20


@pytest.mark.skipif(not Path("/proc/self/statm").exists(), reason="needs /proc")
def test_a_window_in_use_does_not_grow(talk, cube):
    use = Use(talk, cube, seed=3)
    for _ in range(WARMING):
        use.deed()
    before = resident_mb()
    for _ in range(DEEDS):
        use.deed()
    assert resident_mb() - before < MOST_MB
