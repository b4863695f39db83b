"""What would take more memory than a run may is refused before it is taken."""

import os
import subprocess
import sys

import numpy as np
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
    assert "sphere.stl: a mesh of 20480 triangles would take about 3 MB" in done.stderr
    assert "WIREPRINT_MEMORY=1G" in done.stderr
    assert not sphere.with_suffix(".gcode").exists()


def test_the_way_out_works(sphere):
    target = sphere.with_suffix(".gcode")
    done = wireprint("slice", sphere, "-o", target, "-q", memory="1G")
    assert done.returncode == 0, done.stderr
    assert target.exists()


#: Prints by how many bytes the memory of a process grew at most, whether a model was read or not.
GROWTH = """
import resource, sys
from wireprint import ModelError, load_mesh
import wireprint.file3mf, wireprint.fileamf
peak = lambda: 1024 * resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
before = peak()
try:
    load_mesh(sys.argv[1])
except ModelError:
    pass
print(peak() - before)
"""
#: What the process itself may take meanwhile: stacks of threads, buffers of files.
ASIDE = 8 << 20


def growth(path):
    done = subprocess.run(
        [sys.executable, "-c", GROWTH, str(path)], capture_output=True, text=True, check=True
    )
    return int(done.stdout)


@pytest.fixture(scope="module")
def fine():
    """A sphere of 327 680 triangles."""
    return trimesh.creation.icosphere(subdivisions=7, radius=30)


@pytest.mark.parametrize(("suffix", "each"), [("stl", 120), ("ply", 120), ("3mf", 160)])
def test_a_mesh_takes_no_more_than_was_claimed_for_it(suffix, each, fine, tmp_path):
    path = tmp_path / f"fine.{suffix}"
    fine.export(path)
    count = len(fine.faces)
    assert growth(path) < each * count + ASIDE
    # Nor is much more claimed: a budget of a little above that is enough, unless the file is read
    # as a whole besides.
    refused = wireprint("info", path, memory=f"{each * count - (1 << 20)}")
    assert str(path) in refused.stderr
    if suffix != "ply":
        assert f"a mesh of {count} triangles" in refused.stderr
        enough = wireprint("info", path, memory=f"{each * count + (1 << 20)}")
        assert enough.returncode == 0, enough.stderr


def test_open_edges_are_claimed_before_they_are_mended(fine, tmp_path):
    """Facets that share no vertex take four times as much as others."""
    path = tmp_path / "apart.stl"
    random = np.random.default_rng(1)
    corners = fine.triangles + random.normal(0, 0.3, (len(fine.faces), 1, 3))
    trimesh.Trimesh(corners.reshape(-1, 3), np.arange(corners.size // 3).reshape(-1, 3)).export(
        path
    )
    count = len(fine.faces)
    assert growth(path) < (120 + 3 * 170) * count + ASIDE
    refused = wireprint("info", path, memory=f"{300 * count}")
    assert refused.returncode == 3
    assert f"a mesh of {count} triangles with {3 * count} open edges" in refused.stderr


def test_a_print_that_does_not_fit_is_refused_before_it_is_planned(cube):
    target = cube.with_suffix(".gcode")
    done = wireprint("slice", cube, "-o", target, "--scale", 4, memory="1M")
    assert done.returncode == 3
    assert f"{cube}: a wire print of about" in done.stderr
    assert not target.exists()


@pytest.mark.parametrize("command", ["check", "simulate"])
def test_a_file_that_is_too_much_to_judge_is_named(command, cube):
    target = cube.with_suffix(".gcode")
    assert wireprint("slice", cube, "-o", target, "-q", memory="1G").returncode == 0
    done = wireprint(command, target, memory="100K")
    assert done.returncode == 3
    assert done.stderr.startswith(f"wireprint: error: {target}: ")


@pytest.mark.parametrize("memory", ["much", "-4G", "4X", "0"])
def test_a_budget_that_is_no_amount_is_refused(memory, cube):
    done = wireprint("info", cube, memory=memory)
    assert done.returncode == 3
    assert f'WIREPRINT_MEMORY is "{memory}"' in done.stderr
    assert "WIREPRINT_MEMORY=4G" in done.stderr
    assert wireprint("info", cube, memory="").returncode == 0


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


def laid_into_each_other(path, strands):
    """Strands to and fro in one place: each touches all before it."""
    moves = [f"G1 X{100 + 20 * (i % 2)} Y100 E1 F1800" for i in range(strands)]
    path.write_text("\n".join(["M83", "G1 X100 Y100 Z0.35 F1800", *moves, "G1 Z20", ""]))
    return path


def test_a_frame_with_more_contacts_than_there_is_room_for_is_refused(tmp_path):
    """They grow with the square of the strands, of which there is room for many more."""
    text = laid_into_each_other(tmp_path / "knot.gcode", 600)
    done = wireprint("simulate", text, memory="20M")
    assert done.returncode == 3
    assert "knot.gcode" in done.stderr
    assert "a frame whose strands touch at more than 104857 places" in done.stderr
    assert "WIREPRINT_MEMORY=1G" in done.stderr
    assert "Traceback" not in done.stderr
    assert wireprint("simulate", text, memory="1G").returncode == 0
    few = laid_into_each_other(tmp_path / "few.gcode", 300)
    assert wireprint("simulate", few, memory="20M").returncode == 0
