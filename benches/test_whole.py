"""From model to G-code against CuraEngine: `pytest benches/test_whole.py --benchmark-enable -s`.

CuraEngine is found on PATH; CURA_DEFS_HOME names the folder with its definitions, as
`../shared/peers/setup.sh` lays them. It and we take turns, and medians are compared.
"""

import subprocess
import sys
import time
from statistics import median

import pytest
import trimesh

from peers import cura_wire
from shared_models import SHARED
from wireprint.mesh import load_mesh
from wireprint.pipeline import make
from wireprint.settings import Settings

BUNNY_SCALE = 792.372
TURNS = 11
#: Runs the command as its entry point does, and tells the process's greatest memory, kB.
COMMAND = """
import sys
from wireprint.cli import main
try:
    main()
finally:
    status = dict(line.split(":") for line in open("/proc/self/status"))
    print(status["VmHWM"].split()[0], file=sys.stderr)
"""


@pytest.fixture(scope="module")
def bunny(tmp_path_factory):
    """The Stanford bunny, 100 mm high, as a file in mm."""
    source = SHARED / "models" / "bunny.stl"
    if not source.exists():
        pytest.skip("the shared models are absent")
    path = tmp_path_factory.mktemp("bench") / "bunny.stl"
    trimesh.load(source).apply_scale(BUNNY_SCALE).export(path)
    return path


def seconds(call):
    begin = time.perf_counter()
    call()
    return time.perf_counter() - begin


def curaengine(model, folder):
    """Let CuraEngine make a wire print: read the model, slice it, write G-code."""
    command = [*cura_wire(), model, folder / "cura.gcode"]
    subprocess.run(command, capture_output=True, check=True)


def wireprint(model, folder):
    """Let the command do the same; return its greatest memory, bytes."""
    options = ["slice", model, "-q", "-o", folder / "ours.gcode"]
    done = subprocess.run(
        [sys.executable, "-c", COMMAND, *options], capture_output=True, text=True, check=True
    )
    return int(done.stderr.split()[-1]) * 1024


def ratio(ours, theirs, capsys, turns=TURNS):
    """Return our median over theirs, taking turns after a round to warm up."""
    ours(), theirs()
    times = [(seconds(ours), seconds(theirs)) for _ in range(turns)]
    ours_s, theirs_s = (median(column) for column in zip(*times, strict=True))
    with capsys.disabled():
        print(f"\nCuraEngine {theirs_s:.3f} s, wireprint {ours_s:.4f} s: {ours_s / theirs_s:.3f}")
    return ours_s / theirs_s


@pytest.mark.parametrize(
    ("options", "goal"),
    [({"certify": False}, 0.2), ({"compare": False}, 0.5)],
    ids=["written", "certified"],
)
def test_arrays_become_g_code_in_a_part_of_curaengines_run(
    benchmark, bunny, tmp_path, capsys, options, goal
):
    mesh, settings = load_mesh(bunny), Settings.load()
    found = ratio(
        lambda: make(mesh, settings, **options), lambda: curaengine(bunny, tmp_path), capsys
    )
    benchmark(make, mesh, settings, **options)
    assert found <= goal


def test_the_command_takes_three_times_curaengines_run_at_most(benchmark, bunny, tmp_path, capsys):
    found = ratio(lambda: wireprint(bunny, tmp_path), lambda: curaengine(bunny, tmp_path), capsys)
    benchmark.pedantic(wireprint, (bunny, tmp_path), rounds=3)
    assert found <= 3


def test_a_million_triangles_take_half_of_curaengines_run(benchmark, million, tmp_path, capsys):
    found = ratio(
        lambda: wireprint(million, tmp_path), lambda: curaengine(million, tmp_path), capsys, 5
    )
    peak = benchmark.pedantic(wireprint, (million, tmp_path), rounds=1)
    mesh = load_mesh(million)
    assert found <= 0.5
    assert peak <= 6 * (mesh.vertices.nbytes + mesh.faces.nbytes)
