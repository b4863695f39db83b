"""A model is turned so that it prints best, and ties leave it as it is given."""

import json

import numpy as np
import pytest
import trimesh
from click.testing import CliRunner

from wireprint import cli, examples, orient
from wireprint._core import Mesh
from wireprint.mesh import load_mesh
from wireprint.settings import Settings

SETTINGS = Settings.load()


def run(*arguments):
    done = CliRunner().invoke(cli.main, [str(argument) for argument in arguments])
    assert done.exit_code == 0, done.output
    return done.stdout


@pytest.fixture(scope="module")
def table(tmp_path_factory):
    """A plate on one leg, the right way up: its rim hangs in the air."""
    plate, leg = trimesh.creation.box((50, 50, 4)), trimesh.creation.box((16, 16, 30.5))
    plate.apply_translation((0, 0, 32))
    leg.apply_translation((0, 0, 15.25))
    path = tmp_path_factory.mktemp("table") / "table.stl"
    trimesh.util.concatenate([plate, leg]).export(path)
    return path


def example(folder, name, **placement):
    path = folder / f"{name}.stl"
    path.write_bytes(examples.stl(name))
    return load_mesh(path, **placement)


def test_a_tipped_bottle_is_stood_up_again(tmp_path):
    standing = example(tmp_path, "bottle", scale=0.8)
    lying = standing.turned((90, 0, 0))
    assert lying.size_mm[2] < standing.size_mm[2] / 2
    found = orient(lying, SETTINGS)
    assert found.mesh.size_mm == pytest.approx(standing.size_mm, abs=0.01)
    z = found.mesh.vertices[:, 2]
    radius = np.hypot(*found.mesh.vertices[:, :2].T)
    assert radius[z < 1].max() > radius[z > z.max() - 1].max(), "the neck is at the top"


@pytest.mark.parametrize("name", ["cube", "sphere"])
def test_a_tie_leaves_the_pose_that_is_given(tmp_path, name):
    found = orient(example(tmp_path, name), SETTINGS)
    assert found.chosen is found.poses[0]
    assert found.rotate_deg == (0, 0, 0)


def test_a_table_is_put_on_its_head(table):
    found = orient(load_mesh(table), SETTINGS)
    assert found.poses[0].support_mm > 100
    assert found.chosen.support_mm < found.poses[0].support_mm / 2
    top = found.mesh.vertices[:, 2] < 1e-3
    assert np.ptp(found.mesh.vertices[top], axis=0)[:2] == pytest.approx((50, 50))


def test_what_does_not_fit_the_bed_is_passed_over():
    rod = trimesh.creation.box((10, 10, 190))
    lying = Mesh.from_arrays(rod.vertices, rod.faces, rotate=(90, 0, 0))
    assert lying.reach_mm > SETTINGS.printer.bed.diameter_mm / 2
    found = orient(lying, SETTINGS)
    assert found.mesh.size_mm[2] == pytest.approx(190)
    assert "does not fit the bed" in found.why


def test_any_number_of_threads_chooses_the_same(table, run_python):
    code = """
import os
os.environ["RAYON_NUM_THREADS"] = "{}"
from wireprint import Settings, load_mesh, orient
print(orient(load_mesh({!r}), Settings.load()).to_dict())
"""
    assert run_python(code.format(1, str(table))) == run_python(code.format(4, str(table)))


def test_summary_json_and_header_say_what_was_chosen_and_rotate_repeats_it(table, tmp_path):
    turned, again = tmp_path / "turned.gcode", tmp_path / "again.gcode"
    told = json.loads(run("slice", table, "-o", turned, "--orient", "auto", "--json"))
    chosen = told["orientation"]
    assert "support" in chosen["why"]
    assert chosen["poses"][0]["support_mm"] > 100
    header = turned.read_bytes().splitlines()[:1000]
    assert any(chosen["why"].encode() in line for line in header)
    assert chosen["why"] in run("slice", table, "-o", turned, "--orient", "auto")
    run("slice", table, "-o", again, "--rotate", *chosen["rotate_deg"])
    moves = [
        [line for line in path.read_bytes().splitlines() if line.startswith(b"G1")]
        for path in (turned, again)
    ]
    assert moves[0] == moves[1]


def test_info_lists_the_poses_with_their_figures(table):
    told = run("info", table, "--orient", "auto")
    assert told.count("support") > len(orient(load_mesh(table), SETTINGS).poses) / 2
    found = json.loads(run("info", table, "--orient", "auto", "--json"))
    assert found["orientation"]["poses"][0]["rotate_deg"] == [0, 0, 0]
    assert found["size_mm"][2] == pytest.approx(34)


def test_bench_tells_how_each_model_was_turned(table, tmp_path):
    results = tmp_path / "results.csv"
    run("bench", table, "-o", results, "--no-compare", "--orient", "auto", "--jobs", 1)
    header, row = results.read_text().splitlines()
    cells = dict(zip(header.split(","), row.split(","), strict=True))
    assert cells["turned_deg"] not in ("", "0 0 0")
    assert float(cells["support_mm"]) < 100
