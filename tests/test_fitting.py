"""What fits the printer is printed, turned if need be; what does not is refused with what would."""

import json
import math
import os
import subprocess
import sys

import numpy as np
import pytest
from click.testing import CliRunner
from hypothesis import assume, given
from hypothesis import settings as effort
from hypothesis import strategies as st

from wireprint import Settings, UnprintableError, check, cli, load_mesh, make
from wireprint._core import Mesh
from wireprint.fitting import fits, fitted, placed

MK4S = Settings.load("prusa-mk4s", "pla")
KOSSEL = Settings.load("kossel-mini", "abs")
#: Corners of a box's facets, outwards; corner 4x + 2y + z.
FACETS = "013 032 467 475 045 051 237 276 026 064 157 173"
BOX = np.array([list(facet) for facet in FACETS.split()]).astype(np.uint32)


def box(width, depth, height, turn_deg=0.0):
    """A box, turned about z."""
    corners = np.array([[x, y, z] for x in (0, width) for y in (0, depth) for z in (0, height)])
    return Mesh.from_arrays(corners.astype(float), BOX, rotate=(0, 0, turn_deg))


def stl(path, *size):
    """Write a box as an STL file."""
    mesh = box(*size)
    facets = mesh.vertices[mesh.faces]
    record = np.zeros(len(facets), [("n", "<3f4"), ("v", "<9f4"), ("a", "<u2")])
    record["v"] = facets.reshape(-1, 9)
    path.write_bytes(bytes(80) + np.uint32(len(facets)).tobytes() + record.tobytes())
    return path


def run(*arguments):
    return CliRunner().invoke(cli.main, [str(a) for a in arguments])


@given(
    st.floats(5, 400),
    st.floats(5, 400),
    st.floats(-180, 180),
)
def test_a_box_is_turned_if_and_only_if_that_helps(width, depth, turn_deg):
    mesh = box(width, depth, 10, turn_deg)
    place = placed(mesh, MK4S)
    room = np.array(MK4S.printer.bed.size_mm)

    def excess(degrees):
        cosine, sine = abs(math.cos(math.radians(degrees))), abs(math.sin(math.radians(degrees)))
        needs = width * cosine + depth * sine, width * sine + depth * cosine
        return (np.array(needs) - room).max()

    as_it_stands, around = excess(turn_deg), [excess(d) for d in np.arange(0, 180, 0.25)]
    assume(abs(as_it_stands) > 1e-3)
    assume(min(around) < -0.5 or min(around) > 0.5)
    assert fits(place.mesh, MK4S) == (min(around) < 0)
    if as_it_stands < 0 or min(around) > 0:
        assert place.turn_deg == 0
        return
    assert round(place.turn_deg, 4) == place.turn_deg
    assert excess(turn_deg + place.turn_deg) <= 1e-6
    smaller = np.linspace(0, abs(place.turn_deg) - 1e-3, 200) if abs(place.turn_deg) > 1e-3 else []
    assert all(excess(turn_deg + d) > 0 and excess(turn_deg - d) > 0 for d in smaller)


@given(st.floats(20, 900), st.floats(20, 900), st.floats(20, 900), st.floats(-180, 180))
@effort(max_examples=40)
@pytest.mark.parametrize("settings", [MK4S, KOSSEL], ids=["mk4s", "kossel"])
def test_the_size_that_is_proposed_fits_and_is_the_largest(settings, width, depth, height, turn):
    mesh = box(width, depth, height, turn)
    if fits(placed(mesh, settings).mesh, settings):
        return
    with pytest.raises(UnprintableError, match="does not fit the build volume") as refused:
        fitted(mesh, settings)
    proposed = float(str(refused.value).rpartition("--height ")[2])
    assert fits(placed(mesh.scaled_to(proposed), settings).mesh, settings)
    assert not fits(placed(mesh.scaled_to(1.002 * proposed), settings).mesh, settings)


def test_a_rod_longer_than_the_bed_is_printed_across_it(tmp_path):
    model = stl(tmp_path / "rod.stl", 290, 8, 12)
    target = tmp_path / "rod.gcode"
    told = run(
        "slice", model, "-o", target, "--printer", "prusa-mk4s", "--material", "pla", "--json"
    )
    assert told.exit_code == 0, told.stderr
    found = json.loads(told.stdout)
    assert found["certified"]
    assert found["breaches"]["out_of_bounds"] == 0
    turn_deg = found["turn_to_fit_deg"]
    assert 290 * math.cos(math.radians(turn_deg)) < 250
    assert f"turned by {turn_deg:g} degrees about z to fit the bed" in target.read_text()
    # The same turn asked for by hand gives the same strands, and the file is judged in its place.
    mesh = load_mesh(model, rotate=(0, 0, turn_deg))
    same = make(mesh, MK4S)
    assert same.turn_to_fit_deg == 0
    assert np.array_equal(same.toolpath.to, make(load_mesh(model), MK4S).toolpath.to)
    assert check(target, model=load_mesh(model)).fidelity.coverage == found["coverage"]


def test_what_fits_is_left_as_it_stands_and_nothing_is_said(tmp_path):
    model = stl(tmp_path / "plate.stl", 200, 150, 6)
    told = run("slice", model, "-o", tmp_path / "a.gcode", "--printer", "prusa-mk4s")
    assert told.exit_code == 0
    assert "turned" not in told.stdout


def test_a_model_that_is_too_large_is_refused_with_a_size_that_is_printed(tmp_path):
    model = stl(tmp_path / "slab.stl", 400, 300, 20)
    target = tmp_path / "slab.gcode"
    refused = run("slice", model, "-o", target)
    assert refused.exit_code == 5
    assert len(refused.stderr.splitlines()) == 1
    assert f"{model}: the model (400.0 × 300.0 × 20.0 mm) does not fit" in refused.stderr
    assert "kossel-mini (170 mm across, 220 mm high); 34 % of its size does" in refused.stderr
    assert not target.exists()
    height_mm = refused.stderr.split("--height ")[1].strip()
    done = run("slice", model, "-o", target, "--height", height_mm)
    assert done.exit_code == 0, done.stderr
    assert check(target).ok


def test_a_tower_leaves_room_for_the_travels_above_it(tmp_path):
    model = stl(tmp_path / "tower.stl", 20, 20, 219.5)
    refused = run("slice", model, "-o", tmp_path / "x.gcode")
    assert refused.exit_code == 5
    assert "less the 1 mm by which travels clear it; 99." in refused.stderr
    assert "--height 219\n" in refused.stderr
    assert fits(placed(box(20, 20, 219), KOSSEL).mesh, KOSSEL)


def test_force_prints_beyond_the_bed_all_the_same(tmp_path):
    model = stl(tmp_path / "wide.stl", 180, 180, 20)
    target = tmp_path / "wide.gcode"
    told = run("slice", model, "-o", target, "--force")
    assert told.exit_code == 0
    assert "leaves the build volume" in told.stdout
    assert target.exists()


def test_sizes_are_held_against_the_printer_before_anything_is_planned(tmp_path):
    """A cube of 2 m would take a gigabyte to plan."""
    model = stl(tmp_path / "huge.stl", 2000, 2000, 2000)
    limit = 700 * 2**20
    code = (
        f"import resource; resource.setrlimit(resource.RLIMIT_AS, ({limit}, {limit}))\n"
        "from wireprint.cli import main\n"
        f"main(['slice', {str(model)!r}, '-o', {str(tmp_path / 'x.gcode')!r}])"
    )
    environment = {"RAYON_NUM_THREADS": "1", "XDG_CACHE_HOME": str(tmp_path)}
    done = subprocess.run(
        [sys.executable, "-c", code],
        capture_output=True,
        text=True,
        env=os.environ | environment,
        check=False,
    )
    assert done.returncode == 5, done.stderr
    # The square in a circle of 170 mm.
    assert done.stderr.endswith("--height 120.2\n")
