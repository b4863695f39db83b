"""What the mesh stage promises on files of its own making."""

import math
import struct
import sys
import zipfile

import numpy as np
import pytest
import trimesh
from hypothesis import given, settings
from hypothesis import strategies as st

from threemf_files import CUBE_OBJECT, item, write_3mf
from wireprint._core import Mesh, ModelError, SettingError
from wireprint.mesh import load_mesh

NO_FACE = 2**32 - 1


def exported(mesh, tmp_path, suffix):
    path = tmp_path / f"model.{suffix}"
    mesh.export(path)
    return path


def facets(mesh):
    """The facets as an ordered set of corners, whatever their order in the mesh."""
    corners = np.asarray(mesh.vertices)[np.asarray(mesh.faces, np.int64)].round(9) + 0.0
    triangles = []
    for triangle in corners.tolist():
        first = triangle.index(min(triangle))
        triangles.append(tuple(map(tuple, triangle[first:] + triangle[:first])))
    return sorted(triangles)


def is_closed(mesh):
    return NO_FACE not in mesh.neighbours


SOLIDS = {
    "cube": (trimesh.creation.box((28, 28, 28)), 28**3, 6 * 28**2),
    "cone": (trimesh.creation.cone(10, 30, sections=512), math.pi * 100 * 10, None),
    "sphere": (trimesh.creation.icosphere(5, 39), 4 / 3 * math.pi * 39**3, 4 * math.pi * 39**2),
    "torus": (
        trimesh.creation.torus(28, 10, 256, 128),
        2 * math.pi**2 * 28 * 100,
        4 * math.pi**2 * 280,
    ),
}


@pytest.mark.parametrize("name", SOLIDS)
def test_volume_and_area_come_close_to_the_formulas_and_equal_trimeshs(name):
    solid, volume, area = SOLIDS[name]
    mesh = Mesh.from_arrays(solid.vertices, solid.faces)
    assert mesh.volume == pytest.approx(solid.volume, rel=1e-9)
    assert mesh.area == pytest.approx(solid.area, rel=1e-9)
    assert mesh.volume == pytest.approx(volume, rel=2e-3)
    if area is not None:
        assert mesh.area == pytest.approx(area, rel=2e-3)
    assert is_closed(mesh)


@pytest.mark.parametrize("suffix", ["stl", "obj", "ply", "off", "3mf"])
def test_every_format_gives_the_same_solid(tmp_path, suffix):
    solid = trimesh.creation.icosphere(3, 20)
    mesh = load_mesh(exported(solid, tmp_path, suffix))
    assert is_closed(mesh)
    assert len(mesh.faces) == len(solid.faces)
    assert mesh.volume == pytest.approx(solid.volume, rel=1e-5)
    assert mesh.bounds[0][2] == pytest.approx(0, abs=1e-9)
    assert mesh.bounds.sum(axis=0)[:2] == pytest.approx([0, 0], abs=1e-9)


def test_arrays_are_read_only_and_typed():
    solid = trimesh.creation.box((10, 10, 10))
    mesh = Mesh.from_arrays(solid.vertices, solid.faces)
    for array, dtype, shape in [
        (mesh.vertices, np.float64, (8, 3)),
        (mesh.faces, np.uint32, (12, 3)),
        (mesh.neighbours, np.uint32, (12, 3)),
        (mesh.bounds, np.float64, (2, 3)),
    ]:
        assert (array.dtype, array.shape, array.flags.writeable) == (dtype, shape, False)


def test_neighbours_share_the_edge_from_corner_i_to_the_next():
    solid = trimesh.creation.icosphere(2, 20)
    mesh = Mesh.from_arrays(solid.vertices, solid.faces)
    for face, across in zip(mesh.faces.tolist(), mesh.neighbours.tolist(), strict=True):
        for i, other in enumerate(across):
            edge = {face[i], face[(i + 1) % 3]}
            assert edge <= set(mesh.faces[other].tolist())


@settings(max_examples=40, deadline=None)
@given(seed=st.integers(0, 2**32 - 1), name=st.sampled_from(["sphere", "torus", "box"]))
def test_shuffled_reversed_and_loose_facets_give_the_same_solid(seed, name):
    solid = {
        "sphere": trimesh.creation.icosphere(2, 20),
        "torus": trimesh.creation.torus(20, 6, 16, 8),
        "box": trimesh.creation.box((10, 20, 30)),
    }[name]
    random = np.random.default_rng(seed)
    corners = solid.vertices[solid.faces[random.permutation(len(solid.faces))]]
    reverse = random.random(len(corners)) < 0.3
    reverse[0] = False
    corners[reverse] = corners[reverse][:, ::-1]
    loose = corners.reshape(-1, 3)
    mesh = Mesh.from_arrays(loose, np.arange(len(loose)).reshape(-1, 3))
    assert facets(mesh) == facets(Mesh.from_arrays(solid.vertices, solid.faces))
    assert is_closed(mesh)


@settings(max_examples=40, deadline=None)
@given(angles=st.tuples(*[st.floats(-360, 360)] * 3), up=st.sampled_from("xyz"))
def test_turning_keeps_volume_and_area(angles, up):
    solid = trimesh.creation.torus(28, 10, 48, 24)
    mesh = Mesh.from_arrays(solid.vertices, solid.faces, rotate=angles, up=up)
    assert mesh.volume == pytest.approx(solid.volume, rel=1e-9)
    assert mesh.area == pytest.approx(solid.area, rel=1e-9)


@settings(max_examples=40)
@given(
    angles=st.tuples(*[st.floats(-360, 360)] * 3),
    up=st.sampled_from("xyz"),
    height=st.none() | st.floats(5, 50),
)
def test_the_placement_is_what_took_the_files_points_to_the_bed(angles, up, height):
    solid = trimesh.creation.torus(28, 10, 16, 8)
    corners = solid.triangles.reshape(-1, 3)
    options = {"rotate": angles, "up": up, "height_mm": height, "scale": 1.3}
    mesh = Mesh.from_arrays(np.array(solid.vertices), np.array(solid.faces), **options)
    for placed in (mesh, mesh.centred_in_circle()):
        moved = corners @ placed.placement[:3, :3].T + placed.placement[:3, 3]
        assert placed.vertices[placed.faces.ravel()] == pytest.approx(moved, abs=1e-9)


def test_a_mesh_is_restored_as_it_was():
    solid = trimesh.creation.torus(28, 10, 16, 8)
    faces = np.array(solid.faces)[:-5]
    mesh = Mesh.from_arrays(np.array(solid.vertices), faces, hole_perimeter=0, rotate=(1, 2, 3))
    again = Mesh.restored(mesh.vertices, mesh.faces)
    for name in ("vertices", "faces", "neighbours"):
        assert np.array_equal(getattr(mesh, name), getattr(again, name))
    assert np.array_equal(again.placement, np.eye(4))
    for vertices, wrong, complaint in (
        (mesh.vertices, [[0, 1, 1]], "no area"),
        (mesh.vertices, [[0, 1, 9999]], "vertex 9999"),
        (np.full((3, 3), np.nan), [[0, 1, 2]], "vertex 0"),
    ):
        with pytest.raises(ModelError, match=complaint):
            Mesh.restored(vertices, np.array(wrong))
    for paired, complaint in (
        ([(9999, 0, 0)], "does not exist"),
        ([(0, 3, 0)], "does not exist"),
        ([(0, 0, 9999)], "share no edge"),
        ([(0, 0, NO_FACE)], "only one knows the other"),
        ([(0, 0, 0)], "share no edge"),
        ([(0, 0, 100), (100, 0, 0)], "share no edge"),
    ):
        with pytest.raises(ModelError, match=complaint):
            Mesh.restored(mesh.vertices, mesh.faces, paired)


def test_units_scale_and_height_multiply(tmp_path):
    path = exported(trimesh.creation.box((1, 2, 4)), tmp_path, "stl")
    size = lambda **options: np.ptp(load_mesh(path, **options).bounds, axis=0)  # noqa: E731
    assert size(units="inch") == pytest.approx([25.4, 50.8, 101.6])
    assert size(units="cm", scale=2) == pytest.approx([20, 40, 80])
    assert size(up="y") == pytest.approx([1, 4, 2])
    assert size(up="x", height_mm=10) == pytest.approx([20, 40, 10])
    assert size(rotate=(90, 0, 0)) == pytest.approx([1, 4, 2])


def test_a_3mf_file_states_its_unit_and_places_copies(tmp_path):
    path = tmp_path / "copies.3mf"
    write_3mf(path, CUBE_OBJECT, '<item objectid="1"/>' + item(1, "2 0 0"), unit="inch")
    mesh = load_mesh(path)
    assert np.ptp(mesh.bounds, axis=0) == pytest.approx([76.2, 25.4, 25.4])
    assert mesh.report["closed_components"] == 2
    with pytest.raises(SettingError, match="states its own unit"):
        load_mesh(path, units="m")


def test_a_mirrored_copy_stays_outward(tmp_path):
    path = tmp_path / "mirrored.3mf"
    write_3mf(path, CUBE_OBJECT, '<item objectid="1" transform="-1 0 0 0 1 0 0 0 1 0 0 0"/>')
    mesh = load_mesh(path, scale=10)
    assert mesh.volume == pytest.approx(1000)
    assert mesh.report["flipped_facets"] == 0


def test_an_archive_that_unpacks_to_gigabytes_is_refused(tmp_path):
    path = tmp_path / "bomb.3mf"
    with (
        zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED) as archive,
        archive.open("3D/3dmodel.model", "w", force_zip64=True) as part,
    ):
        for _ in range(300):
            part.write(bytes(1 << 20))
    assert path.stat().st_size < 1 << 20
    with pytest.raises(ModelError, match="unpacks to"):
        load_mesh(path)


def test_components_that_multiply_without_end_are_refused(tmp_path):
    levels = [
        f'<object id="{level}"><components>'
        + f'<component objectid="{level - 1}"/>' * 10
        + "</components></object>"
        for level in range(2, 12)
    ]
    path = tmp_path / "laughs.3mf"
    write_3mf(path, CUBE_OBJECT + "".join(levels), '<item objectid="11"/>')
    with pytest.raises(ModelError, match="copies"):
        load_mesh(path)
    circle = '<object id="2"><components><component objectid="2"/></components></object>'
    write_3mf(path, circle, '<item objectid="2"/>')
    with pytest.raises(ModelError, match="copies"):
        load_mesh(path)


@pytest.mark.parametrize(
    ("name", "content"),
    [
        ("a.obj", b""),
        ("a.obj", b"v 0 0 0\nv 1 0 0\nv 0 1 0\n"),
        ("a.ply", b"ply\nformat binary_little_endian 1.0\nelement vertex 4000000000\n"),
        ("a.ply", b"not a ply"),
        ("a.off", b"OFF\n4000000000 4000000000 0\n0 0 0\n"),
        ("a.3mf", b"PK\x03\x04 no archive"),
        ("a.stl", b"solid"),
        ("a.amf", b"<amf/>"),
        ("a", b"v 0 0 0"),
    ],
)
def test_a_damaged_file_is_a_model_error_that_names_the_file(tmp_path, name, content):
    path = tmp_path / name
    path.write_bytes(content)
    with pytest.raises(ModelError, match=str(path)):
        load_mesh(path)


def test_a_missing_file_is_a_model_error(tmp_path):
    for suffix in ("stl", "obj", "3mf"):
        with pytest.raises(ModelError, match="missing"):
            load_mesh(tmp_path / f"missing.{suffix}")


@pytest.mark.parametrize(
    ("options", "complaint"),
    [
        ({"units": "furlong"}, "furlong"),
        ({"up": "w"}, "up"),
        ({"scale": -1}, "scale"),
        ({"scale": math.nan}, "scale"),
        ({"height_mm": 0}, "height"),
        ({"rotate": (math.inf, 0, 0)}, "rotate"),
        ({"hole_perimeter": 2}, "hole_perimeter"),
        ({"weld_distance": -1e-3}, "weld_distance"),
    ],
)
def test_a_wrong_setting_is_named(tmp_path, options, complaint):
    path = exported(trimesh.creation.box((10, 10, 10)), tmp_path, "stl")
    with pytest.raises(SettingError, match=complaint):
        load_mesh(path, **options)


@pytest.mark.parametrize(
    ("vertices", "faces", "complaint"),
    [
        (np.zeros((4, 2)), np.zeros((1, 3), int), r"vertices has dtype float64 and shape \(4, 2\)"),
        (np.zeros((4, 3), "f4"), np.zeros((1, 3), int), "vertices has dtype float32"),
        (np.zeros((4, 3)), np.zeros((1, 3)), "faces has dtype float64"),
        (np.zeros((4, 3)), [[0, 1, 2]], "faces has dtype"),
        (np.zeros((4, 3)), np.full((1, 3), -1), "index"),
        (np.eye(3), np.array([[0, 1, 7]]), "vertex 7"),
        (np.full((3, 3), np.inf), np.array([[0, 1, 2]]), "vertex 0"),
        (np.zeros((0, 3)), np.zeros((0, 3), int), "no facet"),
    ],
)
def test_wrong_arrays_are_refused_with_dtype_and_shape(vertices, faces, complaint):
    with pytest.raises(ModelError, match=complaint):
        Mesh.from_arrays(vertices, faces)


def test_loading_stl_imports_neither_numpy_nor_trimesh(tmp_path, run_python):
    path = exported(trimesh.creation.box((10, 10, 10)), tmp_path, "stl")
    run_python(
        "import sys; from wireprint.mesh import load_mesh; "
        f"load_mesh({str(path)!r}); assert not {{'numpy', 'trimesh'}} & set(sys.modules)"
    )


@pytest.mark.skipif(sys.platform != "linux", reason="reads the peak from /proc")
def test_the_peak_memory_of_a_large_file_stays_below_six_times_the_arrays(tmp_path, run_python):
    path = tmp_path / "large.stl"
    write_torus(path, 1000, 500)
    out = run_python(
        "from wireprint.mesh import load_mesh; "
        f"mesh = load_mesh({str(path)!r}); "
        "status = dict(line.split(':') for line in open('/proc/self/status')); "
        "print(status['VmHWM'].split()[0], *mesh.report.values())"
    )
    peak, count = (int(word) for word in out.split()[:2])
    arrays = count * 3 * 4 + count / 2 * 3 * 8
    assert count == 1_000_000
    assert peak * 1024 < 6 * arrays


def write_torus(path, n, m):
    """Write a torus of 2·n·m facets."""
    ring, tube = np.meshgrid(np.arange(n), np.arange(m), indexing="ij")

    def points(di, dj):
        a, b = 2 * np.pi * ((ring + di) % n) / n, 2 * np.pi * ((tube + dj) % m) / m
        r = 30 + 10 * np.cos(b)
        return np.stack([r * np.cos(a), r * np.sin(a), 10 * np.sin(b)], -1).reshape(-1, 3)

    a, b, c, d = points(0, 0), points(1, 0), points(1, 1), points(0, 1)
    layout = [("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("attribute", "<u2")]
    facets = np.zeros(2 * n * m, layout)
    facets["corners"] = np.concatenate([np.stack([a, b, c], 1), np.stack([a, c, d], 1)])
    path.write_bytes(bytes(80) + struct.pack("<I", len(facets)) + facets.tobytes())
