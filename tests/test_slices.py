"""Slices against trimesh and shapely, on random and on real solids."""

import csv

import numpy as np
import pytest
import shapely
import trimesh
from hypothesis import given, settings
from hypothesis import strategies as st

from wireprint._core import Mesh, ModelError, SettingError, slice_mesh
from wireprint.mesh import load_mesh


def as_mesh(solid):
    return Mesh.from_arrays(
        np.ascontiguousarray(solid.vertices, dtype=np.float64),
        np.ascontiguousarray(solid.faces, dtype=np.int64),
    )


def as_trimesh(mesh):
    return trimesh.Trimesh(mesh.vertices, mesh.faces.astype(np.int64), process=False)


def rings(slices, k):
    """Points and indices of the contours of slice k."""
    first, last = slices.slice_offsets[k : k + 2]
    return {i: slices.points[slices.offsets[i] : slices.offsets[i + 1]] for i in range(first, last)}


def perimeter(ring):
    return np.linalg.norm(ring - np.roll(ring, -1, axis=0), axis=1).sum()


SOLIDS = {
    "icosphere": trimesh.creation.icosphere(subdivisions=3, radius=20),
    "torus": trimesh.creation.torus(20, 7, major_sections=48, minor_sections=24),
    "annulus": trimesh.creation.annulus(5, 10, 20, sections=32),
    "capsule": trimesh.creation.capsule(15, 6),
    "box": trimesh.creation.box((28, 28, 28)),
}


@pytest.mark.parametrize("name", SOLIDS)
def test_areas_and_perimeters_agree_with_trimesh_and_shapely(name):
    random = np.random.default_rng(1)
    for _ in range(5):
        solid = SOLIDS[name].copy()
        solid.apply_transform(trimesh.transformations.random_rotation_matrix(random.random(3)))
        mesh = as_mesh(solid)
        low, high = mesh.bounds[:, 2]
        heights = random.uniform(low + 0.01, high - 0.01, 20)
        slices = slice_mesh(mesh, heights)
        peer = as_trimesh(mesh).section_multiplane([0, 0, 0], [0, 0, 1], heights)
        for k, section in enumerate(peer):
            contours = rings(slices, k)
            area = sum(slices.area[i] for i in contours)
            around = sum(map(perimeter, contours.values()))
            assert area == pytest.approx(section.area, rel=1e-6)
            assert around == pytest.approx(section.length, rel=1e-6)
            filled = shapely.union_all([shapely.Polygon(p) for p in section.polygons_full])
            assert area == pytest.approx(filled.area, rel=1e-6)


@settings(max_examples=30, deadline=None)
@given(st.integers(0, 2**32 - 1), st.sampled_from(sorted(SOLIDS)))
def test_closed_meshes_give_closed_loops_at_any_height_rotation_and_side(seed, name):
    random = np.random.default_rng(seed)
    solid = SOLIDS[name].copy()
    if seed % 3:
        solid.apply_transform(trimesh.transformations.random_rotation_matrix(random.random(3)))
    mesh = as_mesh(solid)
    own = random.permutation(mesh.vertices[:, 2])[:300]
    heights = np.concatenate([random.uniform(*mesh.bounds[:, 2], 700), own])
    for side in ("below", "above"):
        slices = slice_mesh(mesh, heights, side)
        assert slices.closed.all()
        assert len(slices.slice_offsets) == len(heights) + 1


def overlapping(random, count):
    """Boxes that overlap at random, as one mesh."""
    boxes = []
    for _ in range(count):
        box = trimesh.creation.box(random.uniform(4, 12, 3))
        turn = trimesh.transformations.random_rotation_matrix(random.random(3))
        box.apply_transform(turn)
        box.apply_translation(random.uniform(-8, 8, 3))
        boxes.append(box)
    return boxes


def test_overlapping_shells_have_the_area_of_shapelys_union():
    random = np.random.default_rng(2)
    for _ in range(30):
        boxes = overlapping(random, 6)
        solid = trimesh.util.concatenate(boxes)
        mesh = as_mesh(solid)
        lifted = mesh.bounds[0, 2] - solid.bounds[0, 2]
        for z in random.uniform(*mesh.bounds[:, 2], 10):
            sections = [hull_of(box, z - lifted) for box in boxes]
            union = shapely.union_all([p for section in sections for p in section])
            slices = slice_mesh(mesh, np.array([z]))
            assert slices.area.sum() == pytest.approx(union.area, rel=1e-6, abs=1e-6)
            around = sum(map(perimeter, rings(slices, 0).values()))
            assert around == pytest.approx(union.length, rel=1e-6, abs=1e-6)


def hull_of(box, z):
    section = box.section([0, 0, 1], [0, 0, z])
    return [] if section is None else [shapely.convex_hull(shapely.MultiPoint(section.vertices))]


def test_contours_nest_as_shapely_says():
    random = np.random.default_rng(3)
    for name in ("torus", "annulus"):
        mesh = as_mesh(SOLIDS[name])
        slices = slice_mesh(mesh, random.uniform(*mesh.bounds[:, 2], 30))
        for k in range(30):
            shapes = {i: shapely.Polygon(ring) for i, ring in rings(slices, k).items()}
            for i, shape in shapes.items():
                around = [j for j in shapes if j != i and shapes[j].contains(shape)]
                assert slices.depth[i] == len(around)
                assert (slices.area[i] > 0) == (len(around) % 2 == 0)
                assert (slices.parent[i] == -1) == (not around)
                assert slices.parent[i] == -1 or slices.parent[i] in around


def test_the_result_is_read_only_and_the_same_every_time():
    mesh = as_mesh(SOLIDS["torus"])
    heights = np.linspace(0, 14, 50)
    one, two = slice_mesh(mesh, heights), slice_mesh(mesh, heights)
    for name in ("points", "offsets", "slice_offsets", "parent", "depth", "area", "closed"):
        assert not getattr(one, name).flags.writeable
        assert np.array_equal(getattr(one, name), getattr(two, name))


def test_wrong_arguments_are_named():
    mesh = as_mesh(SOLIDS["box"])
    with pytest.raises(SettingError, match="side"):
        slice_mesh(mesh, np.array([1.0]), "left")
    with pytest.raises(SettingError, match="heights"):
        slice_mesh(mesh, np.array([np.nan]))
    with pytest.raises(TypeError):
        slice_mesh(mesh, np.array([1]))


def models(shared):
    """Each row of the manifest, and its model."""
    with (shared / "models" / "manifest.csv").open() as file:
        for row in csv.DictReader(file):
            path = shared / "models" / row["name"]
            yield row, load_mesh(path, scale=float(row["scale"]), up=row["up_axis"])


def test_real_models_have_trimeshs_areas_wherever_its_rings_are_simple(shared):
    random = np.random.default_rng(4)
    compared = set()
    for row, mesh in models(shared):
        heights = random.uniform(*mesh.bounds[:, 2], 5)
        slices = slice_mesh(mesh, heights)
        assert slices.closed.all() or row["watertight"] == "no", row["name"]
        sections = as_trimesh(mesh).section_multiplane([0, 0, 0], [0, 0, 1], heights)
        for k, section in enumerate(sections):
            shapes = [shapely.Polygon(ring) for ring in section.discrete if len(ring) > 3]
            simple = all(shape.is_valid for shape in shapes) and section.is_closed
            if simple and row["components"] == "1":
                area = sum(slices.area[i] for i in rings(slices, k))
                assert area == pytest.approx(filled_area(shapes), rel=1e-6), row["name"]
                compared.add(row["name"])
    assert len(compared) > 30


def filled_area(shapes):
    """Area of rings by their depth."""
    shapes = sorted(shapes, key=lambda shape: -shape.area)
    return sum(
        shape.area * (1 - 2 * (sum(other.contains(shape) for other in shapes[:i]) % 2))
        for i, shape in enumerate(shapes)
    )


def test_broken_models_are_sliced_into_contours_that_do_not_cross(shared):
    random = np.random.default_rng(5)
    sliced = 0
    for path in sorted((shared / "models" / "broken").iterdir()):
        try:
            mesh = load_mesh(path)
        except ModelError:
            continue
        low, high = mesh.bounds[:, 2]
        slices = slice_mesh(mesh, random.uniform(low, high, 20))
        for k in range(20):
            closed = [ring for i, ring in rings(slices, k).items() if slices.closed[i]]
            shapes = [shapely.Polygon(ring) for ring in closed if len(ring) > 2]
            for i, one in enumerate(shapes):
                for other in shapes[:i]:
                    shared_area = one.intersection(other).area
                    nested = pytest.approx(min(one.area, other.area), abs=1e-6)
                    assert shared_area < 1e-6 or shared_area == nested, path.name
        sliced += 1
    assert sliced
