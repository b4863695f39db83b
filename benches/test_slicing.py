"""Slicing against trimesh and CuraEngine: `pytest benches/test_slicing.py --benchmark-enable -s`.

CuraEngine is found on PATH; CURA_DEFS_HOME names the folder with `cura_wire.sh` and its
definitions, or WIREPRINT_SHARED the folder whose `peers` holds the script.
"""

import os
import re
import subprocess
import time

import numpy as np
import pytest
import trimesh

from peers import cura_wire
from wireprint._core import Mesh, slice_mesh

PLANES = 1000
RADIUS_MM = 39.0


@pytest.fixture(scope="module")
def ball():
    """A sphere of 1.3 million triangles."""
    return trimesh.creation.icosphere(subdivisions=8, radius=RADIUS_MM)


@pytest.fixture(scope="module")
def mesh(ball):
    return Mesh.from_arrays(np.array(ball.vertices), np.array(ball.faces, dtype=np.int64))


@pytest.fixture(autouse=True)
def measured(benchmark):
    if not benchmark.enabled:
        pytest.skip("a measurement: run with --benchmark-enable")


def heights():
    """Heights of the planes, as CuraEngine lays them: in the middle of equal layers."""
    return (np.arange(PLANES) + 0.5) * (2 * RADIUS_MM / PLANES)


def report(capsys, peer, theirs_s, ours_s):
    with capsys.disabled():
        print(f"\n{peer}: {theirs_s:.3f} s, wireprint: {ours_s:.3f} s, {theirs_s / ours_s:.1f}×")


def test_a_thousand_planes_through_a_million_triangles_beat_trimesh(benchmark, mesh, ball, capsys):
    benchmark.pedantic(slice_mesh, (mesh, heights()), rounds=10, warmup_rounds=1)
    begin = time.perf_counter()
    trimesh.intersections.mesh_multiplane(ball, [0, 0, -RADIUS_MM], [0, 0, 1], heights())
    peer_s = time.perf_counter() - begin
    ours_s = benchmark.stats.stats.min
    report(capsys, "trimesh, segments only", peer_s, ours_s)
    assert peer_s > 100 * ours_s


def test_a_thousand_planes_through_a_million_triangles_beat_curaengine(
    benchmark, mesh, ball, tmp_path, capsys
):
    path = tmp_path / "ball.stl"
    ball.export(path)
    peer_s = min(cura_slicing_s(path, tmp_path) for _ in range(3))
    benchmark.pedantic(slice_mesh, (mesh, heights()), rounds=10, warmup_rounds=1)
    ours_s = benchmark.stats.stats.min
    report(capsys, "CuraEngine, slice and polygons", peer_s, ours_s)
    assert peer_s > 5 * ours_s


def cura_slicing_s(model, folder):
    """Seconds that CuraEngine says its slicing stage takes."""
    layer = f"{2 * RADIUS_MM / PLANES}"
    settings = ["-s", f"layer_height={layer}", "-s", f"layer_height_0={layer}"]
    command = [*cura_wire(), model, folder / "out.gcode", *settings]
    # What follows slicing is not measured, and is stopped by the script's time limit.
    environment = os.environ | {"H": layer, "TLIM": "20"}
    run = subprocess.run(command, env=environment, capture_output=True, text=True, check=False)
    log = run.stdout + run.stderr
    assert f"Layer count: {PLANES}" in log
    stages = [r"slice of mesh took ([\d.]+)", r"slice make polygons took ([\d.]+)"]
    return sum(float(re.search(stage, log)[1]) for stage in stages)


def test_small_models_take_no_time(benchmark):
    ball = trimesh.creation.icosphere(subdivisions=4, radius=RADIUS_MM)
    mesh = Mesh.from_arrays(np.array(ball.vertices), np.array(ball.faces, dtype=np.int64))
    few = np.linspace(1, 2 * RADIUS_MM - 1, 30)
    benchmark(slice_mesh, mesh, few)
    assert benchmark.stats.stats.min < 2e-3
