"""What would take more memory than a run may is refused before it is taken."""

import os
import subprocess
import sys

import pytest
import trimesh


def wireprint(*arguments, memory):
    return subprocess.run(
        [sys.executable, "-m", "wireprint", *map(str, arguments)],
        env={**os.environ, "WIREPRINT_MEMORY": memory},
        capture_output=True,
        text=True,
    )


@pytest.fixture(scope="module")
def sphere(tmp_path_factory):
    path = tmp_path_factory.mktemp("memory") / "sphere.stl"
    trimesh.creation.icosphere(subdivisions=5, radius=30).export(path)
    return path


def test_a_mesh_that_does_not_fit_is_named_with_a_way_out(sphere):
    done = wireprint("slice", sphere, "-o", sphere.with_suffix(".gcode"), memory="1M")
    assert done.returncode == 3
    assert "sphere.stl: a mesh of 20480 triangles would take about 5 MB" in done.stderr
    assert "WIREPRINT_MEMORY=1G" in done.stderr
    assert not sphere.with_suffix(".gcode").exists()


def test_the_way_out_works(sphere):
    target = sphere.with_suffix(".gcode")
    done = wireprint("slice", sphere, "-o", target, "-q", memory="1G")
    assert done.returncode == 0, done.stderr
    assert target.exists()


def test_a_print_that_does_not_fit_is_refused_before_it_is_planned(cube):
    target = cube.with_suffix(".gcode")
    done = wireprint("slice", cube, "-o", target, "--scale", 4, memory="1M")
    assert done.returncode == 3
    assert "a wire print of about" in done.stderr
    assert not target.exists()


def test_arrays_are_held_to_the_budget_too():
    code = (
        "import numpy as np, wireprint\n"
        "faces = np.zeros((100000, 3), dtype=np.int64)\n"
        "try:\n"
        "    wireprint.Mesh.from_arrays(np.eye(3), faces)\n"
        "except wireprint.MemoryLimitError as error:\n"
        "    print(error)\n"
    )
    done = subprocess.run(
        [sys.executable, "-c", code],
        env={**os.environ, "WIREPRINT_MEMORY": "10M"},
        capture_output=True,
        text=True,
    )
    assert "a mesh of 100000 triangles" in done.stdout, done.stderr
