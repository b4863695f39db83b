"""What brush strokes and masks promise, and regions as JSON."""

import json
import math
from pathlib import Path

import numpy as np
import pytest
import trimesh
from hypothesis import given
from hypothesis import strategies as st

from test_regions import cloud, lengths, marks, points3, region_of, shapes
from wireprint._core import SettingError
from wireprint.regions import Mask, Predicate, Region, Sphere, Stroke, ZRange, document

UP = np.array([0.0, 0, 1])


@st.composite
def strokes(draw):
    points = draw(st.lists(points3, min_size=1, max_size=5))
    count = draw(st.sampled_from([1, len(points)]))
    normals = draw(st.lists(points3.filter(any), min_size=count, max_size=count))
    spread = draw(st.integers(1, 180))
    return Stroke(
        points_mm=points, normals=normals, radius_mm=draw(lengths), spread_deg=float(spread)
    )


def solid_mask(solid, marked):
    return Mask(vertices=np.array(solid.vertices), faces=np.array(solid.faces), marked=marked)


masks = st.builds(
    lambda size, seed: solid_mask(
        trimesh.creation.box((size, size, size)),
        np.random.default_rng(seed).random(12) < 0.5,
    ),
    lengths,
    st.integers(0, 99),
)


@given(stroke=strokes(), seed=st.integers(0, 99))
def test_a_stroke_is_the_union_of_its_capsules_where_normals_agree(stroke, seed):
    points, normals = cloud(seed, 60)
    facing = np.array(stroke.normals) / np.linalg.norm(stroke.normals, axis=1, keepdims=True)
    facing = np.broadcast_to(facing, (len(stroke.points_mm), 3))
    ends = [*stroke.points_mm, stroke.points_mm[-1]]
    expected = []
    for point, normal in zip(points, normals, strict=True):
        touched = False
        for i in range(len(stroke.points_mm)):
            a, run = np.array(ends[i]), np.subtract(ends[i + 1], ends[i])
            along = np.clip((point - a) @ run / (run @ run or 1), 0, 1)
            wanted = facing[i] + along * (facing[min(i + 1, len(facing) - 1)] - facing[i])
            angle = wanted @ normal / (np.linalg.norm(wanted) or 1)
            near = np.linalg.norm(point - a - along * run) <= stroke.radius_mm
            touched |= bool(near and angle >= math.cos(math.radians(stroke.spread_deg)))
        expected.append(touched)
    assert stroke.covers(points, normals).tolist() == expected


def test_paint_does_not_bleed_through_a_thin_wall():
    front = np.array([[x, 0.0, z] for x in (0.0, 3.0) for z in (0.0, 4.0)])
    back = np.add(front, (0, 0.4, 0))
    stroke = Stroke(points_mm=[(0, 0, 0), (3, 0, 4)], normals=[(0, -1, 0)], radius_mm=5)
    out = np.tile([0.0, -1, 0], (4, 1))
    assert stroke.covers(front, out).all()
    assert not stroke.covers(back, -out).any()


def test_a_stroke_around_a_bend_turns_its_normal():
    stroke = Stroke(points_mm=[(0, 0, 0), (10, 0, 0)], normals=[(0, 0, 1), (1, 0, 0)], radius_mm=1)
    points = np.array([[0.0, 0, 0], [10, 0, 0], [10, 0, 0]])
    normals = np.array([UP, [1.0, 0, 0], UP])
    assert stroke.covers(points, normals).tolist() == [True, True, False]


@pytest.mark.parametrize("high", [-20, 0, 13])
def test_a_mask_of_triangles_is_the_shape_that_they_were_marked_by(high):
    ball = trimesh.creation.icosphere(4, 30)
    fine, coarse = ZRange(high_mm=high), 30 * np.pi / 2 / 2**4
    mask = solid_mask(ball, fine.covers(ball.triangles_center, ball.face_normals))
    points, _ = trimesh.sample.sample_surface(ball, 2000, seed=1)
    normals = np.zeros_like(points)
    sure = np.abs(points[:, 2] - high) > coarse
    assert sure.sum() > 1500
    expected = fine.covers(points, normals)
    assert np.array_equal(mask.covers(points, normals)[sure], expected[sure])


def test_a_mask_outlives_a_mesh_that_is_cut_up_and_shaken():
    box = trimesh.creation.box((10, 10, 10))
    marked = box.face_normals[:, 2] > 0.5
    mask = solid_mask(box, marked)
    other = box.subdivide().subdivide()
    shaken = other.triangles_center + np.random.default_rng(1).normal(0, 0.01, (192, 3))
    expected = other.face_normals[:, 2] > 0.5
    assert np.array_equal(mask.covers(shaken, np.array(other.face_normals)), expected)


@given(marks=st.lists(st.tuples(st.booleans(), st.one_of(shapes, strokes(), masks)), max_size=5))
def test_a_region_comes_back_from_json_unchanged(marks):
    matrix = np.array([[0, -2.0, 0, 1 / 3], [2, 0, 0, 0.1], [0, 0, 2, 7], [0, 0, 0, 1]])
    for region in (region_of(marks), region_of(marks).transformed(matrix)):
        text = document.to_json(region)
        assert document.from_json(text, "x") == region
        assert document.to_json(document.from_json(text, "x")) == text


def test_regions_are_equal_when_they_say_the_same():
    one, other = (Region().add(Sphere(centre_mm=(0, 0, z), radius_mm=1)) for z in (1, 2))
    assert one == Region().add(Sphere(centre_mm=(0, 0, 1), radius_mm=1))
    assert one != other
    assert one != Region().erase(Sphere(centre_mm=(0, 0, 1), radius_mm=1))
    assert hash(one) == hash(other) or one != other


def test_a_predicate_is_no_data():
    region = Region().add(Predicate(function=lambda points: points[:, 0] > 0))
    with pytest.raises(SettingError, match="predicate"):
        document.to_json(region)


SPHERE = {"kind": "sphere", "centre_mm": [0, 0, 0], "radius_mm": 4}
STROKE = {"kind": "stroke", "points_mm": [[0, 0, 0]], "normals": [[0, 0, 1]], "radius_mm": 1}
MASK = {
    "kind": "mask",
    "vertices": "AAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAA",
    "faces": "AAAAAAAAAAAAAAAA",
    "marked": "AQ==",
}


def strokes_json(shape, **more):
    return {"format": "wireprint-strokes", "version": 1, "marks": [{"shape": shape, **more}]}


def test_the_least_document_is_a_list_of_marks():
    text = json.dumps({"marks": [{"shape": SPHERE}, {"shape": {"kind": "z"}, "erase": True}]})
    region = document.from_json(text.encode(), "x")
    expected = Region().add(Sphere(centre_mm=(0, 0, 0), radius_mm=4)).erase(ZRange())
    assert region == expected


@pytest.mark.parametrize(
    ("content", "complaint"),
    [
        ("", "invalid JSON"),
        ("[" * 9999, "invalid JSON"),
        (strokes_json(SPHERE) | {"version": 2}, "version: input should be 1"),
        (strokes_json(SPHERE) | {"format": "x"}, "format: input should be 'wireprint-strokes'"),
        (strokes_json(SPHERE) | {"more": 1}, "more: extra inputs"),
        (strokes_json({"kind": "cone"}), "marks.0.shape: .*'cone'"),
        (strokes_json(SPHERE | {"radius_mm": 0}), "marks.0.shape.sphere.radius_mm: .*greater"),
        (strokes_json(SPHERE | {"radius_mm": math.inf}), "radius_mm: .*finite"),
        (strokes_json(SPHERE | {"centre_mm": [0, math.nan, 0]}), r"centre_mm.1: .*finite"),
        (strokes_json(SPHERE | {"centre_mm": [0, 1e6, 0]}), "centre_mm.1: .*less than"),
        (strokes_json(SPHERE | {"centre_mm": [0, 0]}), "centre_mm.2: .*required"),
        (strokes_json(SPHERE, frame=[[1, 0, 0, 0]] * 2), "frame.2"),
        (strokes_json(SPHERE, frame=[[1, 0, 0, 0]] * 3), "marks.0: frame flattens"),
        (strokes_json(STROKE | {"points_mm": []}), "points_mm: .*at least 1"),
        (strokes_json(STROKE | {"points_mm": [[0, 0, 0]] * 10001}), "points_mm: .*at most 10000"),
        (strokes_json(STROKE | {"normals": [[0, 0, 1]] * 2}), "as many as points_mm"),
        (strokes_json(STROKE | {"normals": [[0, 0, 0]]}), "no direction"),
        (strokes_json(MASK | {"faces": "AQAAAAAAAAAAAAAA"}), "faces names vertex 1 of 1"),
        (strokes_json(MASK | {"faces": ""}), "1 of 0 faces"),
        (strokes_json(MASK | {"marked": "AQE="}), "2 of 1 faces"),
        (strokes_json(MASK | {"vertices": "AAAA"}), "vertices: .*no 3 float64"),
        (strokes_json(MASK | {"vertices": "!"}), "vertices: no base64"),
        (strokes_json(MASK | {"vertices": "AAAAAAAA+H8AAAAAAAAAAAAAAAAAAAAA"}), "not finite"),
        (strokes_json(MASK | {"marked": [True]}), "marked: must be an array"),
        ({"marks": [{"shape": {"kind": "z"}}] * 10001}, "marks: .*at most 10000"),
    ],
)
def test_a_wrong_document_is_refused_with_its_place(content, complaint, tmp_path):
    path = tmp_path / "strokes.json"
    path.write_text(content if isinstance(content, str) else json.dumps(content))
    with pytest.raises(SettingError, match=complaint) as refused:
        document.read(path)
    assert str(refused.value).startswith(f"{path}: ")


def test_a_document_that_is_missing_or_too_large_is_refused(tmp_path):
    with pytest.raises(SettingError, match="No such file"):
        document.read(tmp_path / "missing.json")
    for content in (b" " * (document.MOST_BYTES + 1), b"," * (document.MOST_COMMAS + 1)):
        (tmp_path / "large.json").write_bytes(content)
        with pytest.raises(SettingError, match=r"large\.json: has more than"):
            document.read(tmp_path / "large.json")


def test_what_could_not_be_read_again_is_not_written():
    long = Stroke(points_mm=[(0, 0, 0)] * 10_000, normals=[(0, 0, 1)], radius_mm=1)
    region = Region()
    for _ in range(40):
        region = region.add(long)
    with pytest.raises(SettingError, match="the region: has more than"):
        document.to_json(region)


@given(marks=marks)
def test_json_of_marks_can_be_read_by_people(marks):
    text = document.to_json(region_of(marks)).decode()
    assert [entry["shape"]["kind"] for entry in json.loads(text)["marks"]] == [
        shape.kind for _, shape in marks
    ]


def test_the_example_in_the_documentation_is_one():
    text = (Path(__file__).parents[1] / "docs/strokes.md").read_text(encoding="utf-8")
    example = text.split("```json")[1].split("```")[0]
    region = document.from_json(example.encode(), "docs")
    assert [mark.erase for mark in region.marks] == [False, True, False]
