"""How fast a toolpath becomes text, against formatting it in Python."""

import time

import numpy as np
import pytest

from wireprint._core import Toolpath
from wireprint.gcode import document
from wireprint.settings import Settings

MOVES = 1_000_000


@pytest.fixture(scope="module")
def helix():
    """A million extruding moves of 3 mm."""
    turn = np.arange(MOVES) * 0.05
    to = np.column_stack([60 * np.cos(turn), 60 * np.sin(turn), 0.35 + turn * 0.002])
    return Toolpath.from_arrays(
        start=(60, 0, 0),
        to=to,
        kind=np.ones(MOVES, np.uint8),
        speed=np.full(MOVES, 30.0),
        filament=np.full(MOVES, 0.48),
        pause=np.zeros(MOVES),
        air=np.zeros(MOVES, bool),
        slab=np.zeros(MOVES, np.uint32),
    )


def test_a_million_moves(benchmark, helix):
    settings = Settings.load()
    text = benchmark(document.moves, helix, settings)
    assert text.count(b"\n") > MOVES


def test_writing_is_far_faster_than_in_python(benchmark, helix):
    settings = Settings.load()
    benchmark.pedantic(document.moves, (helix, settings), rounds=5)
    some = helix.to[: MOVES // 20].tolist()
    begin = time.perf_counter()
    "".join(f"G1 X{x:.3f} Y{y:.3f} Z{z:.3f} E{0.48:.5f}\n" for x, y, z in some)
    pythons_s = time.perf_counter() - begin
    assert 4 * benchmark.stats.stats.min / MOVES < pythons_s / len(some)
