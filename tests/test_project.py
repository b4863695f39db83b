"""What projects promise: mesh, settings and marks come back as they were saved."""

import json
import zipfile

import numpy as np
import pytest
import trimesh
from hypothesis import given, settings
from hypothesis import strategies as st

from test_region_strokes import masks, strokes
from test_regions import region_of, shapes
from threemf_files import MODEL, cube_object, write_3mf, write_zip
from wireprint._core import Mesh, ModelError, SettingError
from wireprint.mesh import load_mesh
from wireprint.model import load_model
from wireprint.project import PART, write_project
from wireprint.regions import Box, Predicate, Region, ZRange
from wireprint.settings import Settings

OVERRIDES = [
    "head.slant_deg=40.125",
    "wire.pause_s=0.1",
    "wire.slab_min_mm=1.7",
    "wire.supports=none",
    'gcode.start=a ; {nozzle_c} & <b> "c" é',
    "wire.caps=false",
]


def same_mesh(one, other):
    return all(
        np.array_equal(getattr(one, name), getattr(other, name))
        for name in ("vertices", "faces", "neighbours")
    )


def broken_torus(seed):
    """A torus with holes, facets twice and reversed, cracks, and no tidy numbers."""
    random = np.random.default_rng(seed)
    solid = trimesh.creation.torus(17 / 3, 7 / 3, 12, 8)
    faces = solid.faces[random.random(len(solid.faces)) > 0.05]
    if seed % 2:
        faces = np.concatenate([faces, faces[:3], faces[5:7, ::-1]])
    faces[:9:2] = faces[:9:2, ::-1]
    corners = solid.vertices[faces].reshape(-1, 3) + random.normal(0, 1e-7, (3 * len(faces), 3))
    return corners, np.arange(len(corners)).reshape(-1, 3)


@settings(max_examples=25)
@given(
    seed=st.integers(0, 99),
    turn=st.tuples(*[st.floats(-180, 180)] * 3),
    marks=st.lists(st.tuples(st.booleans(), st.one_of(shapes, strokes(), masks)), max_size=4),
    overrides=st.sets(st.sampled_from(OVERRIDES)),
    material=st.sampled_from(["abs", "pla"]),
)
def test_all_comes_back_as_it_was_saved(seed, turn, marks, overrides, material, tmp_path_factory):
    path = tmp_path_factory.mktemp("project") / "x.3mf"
    mesh = Mesh.from_arrays(*broken_torus(seed), rotate=turn, scale=1.7)
    chosen = Settings.load(material=material, overrides=sorted(overrides))
    region = region_of(marks)
    write_project(path, mesh, chosen, region)
    model = load_model(path)
    assert same_mesh(mesh, model.mesh)
    assert same_mesh(mesh, load_mesh(path))
    assert model.settings == chosen
    assert model.region == region
    content = path.read_bytes()
    write_project(path, model.mesh, model.settings, model.region)
    assert path.read_bytes() == content


@pytest.fixture
def box():
    solid = trimesh.creation.box((10, 20, 30))
    return Mesh.from_arrays(np.array(solid.vertices), np.array(solid.faces))


UPPER = Region().add(ZRange(low_mm=20))


def test_marks_move_with_a_project_that_is_placed_otherwise(box, tmp_path):
    write_project(tmp_path / "x.3mf", box, Settings.load(), UPPER)
    model = load_model(tmp_path / "x.3mf", scale=2, up="x")
    assert model.mesh.size_mm == pytest.approx([40, 60, 20])
    # What was up is now along y, and its end at +30 mm.
    points = np.array([[0.0, 9, 10], [0, 11, 10]])
    assert model.region.covers(points, np.zeros((2, 3))).tolist() == [False, True]


def test_a_project_whose_mesh_another_program_changed_is_repaired_as_any_model(box, tmp_path):
    path = tmp_path / "x.3mf"
    write_project(path, box, Settings.load(), UPPER)
    with zipfile.ZipFile(path) as archive:
        parts = {name: archive.read(name).decode() for name in archive.namelist()}
    lines = [line for line in parts[MODEL].splitlines() if "<triangle " in line]
    parts[MODEL] = parts[MODEL].replace(lines[0], "", 1).replace('y="10.0"', 'y="30.0"')
    write_zip(path, parts)
    model = load_model(path)
    assert model.mesh.size_mm == pytest.approx([10, 40, 30])
    assert model.mesh.report["closed_holes"] == 1
    assert model.region
    assert model.settings == Settings.load()


def test_a_project_is_a_plain_model_to_other_programs(box, tmp_path):
    path = tmp_path / "x.3mf"
    write_project(path, box, Settings.load(), UPPER)
    with zipfile.ZipFile(path) as archive:
        assert archive.testzip() is None
        assert archive.namelist()[:3] == ["[Content_Types].xml", "_rels/.rels", MODEL]
        types, model = archive.read("[Content_Types].xml"), archive.read(MODEL)
        assert {entry.date_time for entry in archive.infolist()} == {(1980, 1, 1, 0, 0, 0)}
    assert f'PartName="/{PART}"'.encode() in types
    assert b"wireprint" not in model
    trimesh_model = trimesh.load_mesh(path)
    assert trimesh_model.volume == pytest.approx(6000)


def test_settings_that_are_wrong_are_named_with_the_file(box, tmp_path):
    path = tmp_path / "x.3mf"
    write_project(path, box, Settings.load(), UPPER)
    with zipfile.ZipFile(path) as archive:
        parts = {name: archive.read(name).decode() for name in archive.namelist()}
    saved = json.loads(parts[PART])
    saved["settings"]["printer"]["head"]["slant_deg"] = 400
    write_zip(path, parts | {PART: json.dumps(saved)})
    with pytest.raises(SettingError, match=rf"{path}: head.slant_deg: .*85"):
        load_model(path)
    saved["strokes"]["marks"][0]["shape"]["low_mm"] = 1e9
    write_zip(path, parts | {PART: json.dumps(saved)})
    with pytest.raises(ModelError, match=rf"{path}: .*strokes.marks.0.shape.z.low_mm"):
        load_model(path)


def test_nothing_is_written_where_something_cannot_be(box, tmp_path):
    path = tmp_path / "x.3mf"
    with pytest.raises(SettingError, match="predicate"):
        write_project(path, box, Settings.load(), Region().add(Predicate(function=len)))
    assert list(tmp_path.iterdir()) == []


def test_paint_becomes_a_mark_of_the_project(tmp_path):
    painted = write_3mf(
        tmp_path / "a.3mf", cube_object(9, attributes={2: 'paint_color="4"'}), unit="centimeter"
    )
    model = load_model(painted)
    region = model.region.erase(Box(low_mm=(-1, -1, -1), high_mm=(1, 1, 1)))
    write_project(tmp_path / "b.3mf", model.mesh, Settings.load(), region)
    again = load_model(tmp_path / "b.3mf")
    assert again.region == region
    points, normals = np.random.default_rng(1).uniform(-45, 45, (99, 3)), np.zeros((99, 3))
    assert np.array_equal(again.region.covers(points, normals), region.covers(points, normals))


def test_settings_are_laid_over_others():
    base = Settings.load(material="pla", overrides=["head.slant_deg=40", "wire.caps=false"])
    assert base.but() == base
    assert base.but(overrides=["wire.caps=true"]).printer.head.slant_deg == 40
    other = base.but(printer="prusa-mk4s")
    assert other.printer == Settings.load(printer="prusa-mk4s").printer
    assert other.material == base.material
    assert not other.wire.caps
    with pytest.raises(SettingError, match="slant_deg"):
        base.but(overrides=["head.slant_deg=400"])
