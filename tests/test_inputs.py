"""What `make` and `as_mesh` take for a model, and how they refuse what is none."""

import numpy as np
import pytest
import trimesh

import wireprint
from wireprint import examples
from wireprint.regions import Region, Sphere

VERTICES = [[0, 0, 0], [30, 0, 0], [0, 30, 0], [0, 0, 30]]
FACES = [[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]]


@pytest.fixture(scope="module")
def settings():
    return wireprint.Settings.load()


@pytest.fixture(scope="module")
def box():
    return trimesh.creation.box((20, 20, 12))


@pytest.mark.parametrize("real", [float, np.float32, np.float64, np.float16, np.int16])
@pytest.mark.parametrize("whole", [int, np.int8, np.uint16, np.uint32, np.uint64, np.int64])
def test_arrays_of_any_real_and_whole_type_are_one_mesh(real, whole):
    mesh = wireprint.as_mesh((np.array(VERTICES, real), np.array(FACES, whole)))
    assert np.array_equal(mesh.vertices, wireprint.as_mesh((VERTICES, FACES)).vertices)
    assert mesh.size_mm == [30, 30, 30]


def test_what_makes_the_same_mesh_makes_the_same_print(box, settings, tmp_path):
    box.export(tmp_path / "box.stl")
    scene = trimesh.Scene([box])
    given = [
        wireprint.as_mesh(box),
        box,
        (box.vertices, box.faces),
        [box.vertices.tolist(), box.faces.tolist()],
        scene,
        wireprint.Model(wireprint.as_mesh(box), Region(), None),
    ]
    texts = {wireprint.make(model, settings).gcode for model in given}
    assert len(texts) == 1
    for path in (tmp_path / "box.stl", str(tmp_path / "box.stl")):
        assert wireprint.make(path, settings).certificate.ok


def test_settings_are_the_default_where_none_are_given(box):
    assert wireprint.make(box).settings == wireprint.Settings.load()


def test_a_projects_settings_and_marks_count(box, tmp_path):
    own = wireprint.Settings.load("prusa-mk4s", "pla")
    region = Region().add(Sphere(centre_mm=(10, 0, 6), radius_mm=5))
    path = tmp_path / "box.3mf"
    wireprint.write_project(path, wireprint.as_mesh(box), own, region)
    made = wireprint.make(path)
    assert made.settings == own
    assert made.regions is not None
    assert wireprint.make(path, wireprint.Settings.load()).settings.printer.name == "kossel-mini"


def test_arrays_are_placed_as_files_are(box):
    mesh = wireprint.as_mesh((box.vertices / 25.4, box.faces), units="inch", up="y")
    assert mesh.size_mm == pytest.approx([20, 12, 20])
    with pytest.raises(wireprint.SettingError, match="scale is for what is not placed yet"):
        wireprint.as_mesh(mesh, scale=2.0)


NAN = np.array(VERTICES, float)
NAN[2, 1] = np.nan


@pytest.mark.parametrize(
    ("given", "said"),
    [
        ((np.zeros((4, 2)), FACES), r"vertices have shape \(4, 2\); it must be \(N, 3\)"),
        ((np.zeros(12), FACES), r"vertices have shape \(12,\)"),
        ((VERTICES, [[0, 1, 2, 3]]), r"faces have shape \(1, 4\).*triangulate"),
        ((NAN, FACES), r"vertex 2 is \[0.0, nan, 0.0\]: a coordinate must be finite \(1 of 4"),
        ((np.full((4, 3), np.inf), FACES), "a coordinate must be finite"),
        (([], FACES), "vertices are empty"),
        ((VERTICES, []), "faces are empty"),
        ((VERTICES, [[0, 1, 4]]), r"face 0 is \[0, 1, 4\]: there are vertices 0 to 3"),
        ((VERTICES, [[0, 1, -1]]), r"face 0 is \[0, 1, -1\]"),
        ((VERTICES, np.array(FACES, float)), "faces are of float64; they must be whole"),
        ((np.array(VERTICES, complex), FACES), "vertices are of complex128"),
        (([["a", "b", "c"]], FACES), "vertices are of <U1"),
        (([[0, 0, 0], [1, 2]], FACES), "vertices are rows of different lengths"),
        (([[0, 0, 0], [1, None, 2]], FACES), "vertices are of object"),
        (42, "int is none of these"),
        ((VERTICES,), "tuple is none of these"),
        (None, "NoneType is none of these"),
        (trimesh.Trimesh(), "vertices are empty"),
    ],
)
def test_what_is_no_model_is_refused_in_words(given, said):
    with pytest.raises(wireprint.ModelError, match=said):
        wireprint.make(given)


def test_a_path_that_is_not_there_is_an_error_that_names_it(tmp_path):
    with pytest.raises((wireprint.ModelError, OSError), match=r"absent\.stl"):
        wireprint.make(tmp_path / "absent.stl")


def test_a_strided_array_is_read_as_it_reads(box):
    wide = np.zeros((len(box.vertices), 6), np.float32)
    wide[:, ::2] = box.vertices
    mesh = wireprint.as_mesh((wide[:, ::2], box.faces[::-1]))
    assert mesh.volume == pytest.approx(20 * 20 * 12)


def test_the_examples_own_names_are_files(tmp_path):
    path = tmp_path / "cube.stl"
    path.write_bytes(examples.stl("cube"))
    assert wireprint.as_mesh(path).size_mm == pytest.approx([28, 28, 28])
