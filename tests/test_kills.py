"""Programs that are killed while they write leave nothing behind."""

import sys
from pathlib import Path

sys.path.append(str(Path(__file__).parent / "fuzz"))

import kills


def test_what_is_killed_while_it_writes_leaves_nothing_and_tears_nothing(tmp_path):
    assert kills.kill_writers(tmp_path, 20, seed=7) == []
