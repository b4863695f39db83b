"""Strands as solid bodies for other slicers: closed, as thick as printed, in their place."""

import io
import zipfile

import numpy as np
import pytest
import trimesh
from click.testing import CliRunner

import wireprint
from wireprint import cli, examples
from wireprint.tubes import as_stl, tubes

DIAMETER = 0.7


@pytest.mark.parametrize("sides", [3, 8, 20])
@pytest.mark.parametrize(
    "run", [(0, 0, 9), (0, 0, -9), (7, 0, 0), (0, -3, 0), (1, 1, 1), (-2, 5, 0.1)]
)
def test_a_tube_is_closed_and_has_the_strands_volume(run, sides):
    start = np.array((4.0, -2.0, 3.0))
    vertices, faces = tubes(np.array([[start, start + run]]), DIAMETER, sides)
    body = trimesh.Trimesh(vertices, faces)
    assert body.is_watertight
    assert body.is_winding_consistent
    # The section is the circle's; a point at either end adds a third of a radius.
    length = np.linalg.norm(run) + 2 * DIAMETER / 2 / 3
    assert body.volume == pytest.approx(length * np.pi / 4 * DIAMETER**2, rel=1e-6)
    assert body.bounds[0] == pytest.approx(np.minimum(start, start + run), abs=DIAMETER)


def test_random_strands_are_bodies_of_their_own_and_dots_are_none():
    random = np.random.default_rng(3)
    strands = random.uniform(-50, 50, (40, 2, 3))
    strands[7, 1] = strands[7, 0]
    vertices, faces = tubes(strands, DIAMETER)
    body = trimesh.Trimesh(vertices, faces)
    assert body.is_watertight
    assert len(body.split()) == 39
    again = trimesh.load(io.BytesIO(as_stl(vertices, faces)), file_type="stl")
    assert again.volume == pytest.approx(body.volume, rel=1e-5)


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    made = tmp_path_factory.mktemp("body")
    (made / "arch.stl").write_bytes(examples.stl("arch"))
    run = CliRunner().invoke(cli.main, ["slice", f"{made}/arch.stl", "-o", f"{made}/arch.gcode"])
    assert run.exit_code == 0, run.output
    return made


def called(folder, *words):
    return CliRunner().invoke(
        cli.main, ["body", f"{folder}/arch.gcode", *(word.format(folder) for word in words)]
    )


def test_a_body_lies_where_its_model_does(folder):
    run = called(folder, "-o", "{}/body.stl")
    assert run.exit_code == 0, run.output
    body, model = (wireprint.load_mesh(folder / name) for name in ("body.stl", "arch.stl"))
    assert body.size_mm == pytest.approx(model.size_mm, abs=1.5 * DIAMETER)


def test_a_model_beside_it_is_a_part_of_its_own(folder):
    run = called(folder, "-o", "{}/both.3mf", "--model", "{}/arch.stl", "--only", "post")
    assert run.exit_code == 0, run.output
    with zipfile.ZipFile(folder / "both.3mf") as archive:
        parts = archive.read("Metadata/Slic3r_PE_model.config").decode()
    model = wireprint.load_mesh(folder / "arch.stl")
    assert f'firstid="0" lastid="{len(model.faces) - 1}"' in parts
    assert 'value="arch"' in parts
    assert 'value="wire"' in parts
    # Read as a plain model it is all of it.
    whole = wireprint.load_mesh(folder / "both.3mf")
    assert len(whole.faces) > 2 * len(model.faces)


@pytest.mark.parametrize(
    ("words", "code", "told"),
    [
        (["-o", "{}/x.3mf", "--only", "nonsense"], 4, "what is printed is cap, contour"),
        (["-o", "{}/x.stl", "--model", "{}/arch.stl"], 2, "holds one body"),
        (["-o", "{}/arch.gcode"], 2, "arch.gcode"),
        (["-o", "{}/x.obj"], 2, ".3mf"),
    ],
)
def test_what_cannot_be_is_told_and_nothing_written(folder, words, code, told):
    before = sorted(folder.iterdir())
    run = called(folder, *words)
    assert run.exit_code == code, run.output
    assert told in run.output
    assert sorted(folder.iterdir()) == before
