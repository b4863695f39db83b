"""What regions promise: marks in order, last one wins, wherever the model is moved to."""

import math

import numpy as np
import pytest
import shapely
from hypothesis import given
from hypothesis import strategies as st

from wireprint._core import SettingError
from wireprint.regions import Box, HalfSpace, Predicate, Region, Sphere, Stroke, ZRange
from wireprint.regions.inside import sections

#: Coordinates on a grid that no sphere's surface or turned plane meets by accident.
coordinates = st.integers(-200, 200).map(lambda n: n / 7)
points3 = st.tuples(coordinates, coordinates, coordinates)
lengths = st.integers(1, 100).map(lambda n: n / 9)


@st.composite
def boxes(draw):
    low, size = draw(points3), draw(st.tuples(lengths, lengths, lengths))
    return Box(low_mm=low, high_mm=tuple(np.add(low, size).tolist()))


spheres = st.builds(Sphere, centre_mm=points3, radius_mm=lengths)
ranges = st.builds(lambda low, size: ZRange(low_mm=low, high_mm=low + size), coordinates, lengths)
halves = st.builds(
    HalfSpace, normal=points3.filter(lambda n: any(n)), offset_mm=st.integers(-90, 90)
)
shapes = st.one_of(boxes(), spheres, ranges, halves)
marks = st.lists(st.tuples(st.booleans(), shapes), max_size=6)


def region_of(marks):
    region = Region()
    for erase, shape in marks:
        region = region.erase(shape) if erase else region.add(shape)
    return region


def cloud(seed, count=200):
    """Points where shapes are, with unit normals of all directions."""
    random = np.random.default_rng(seed)
    points, normals = random.uniform(-30, 30, (count, 3)), random.normal(size=(count, 3))
    return points, normals / np.linalg.norm(normals, axis=1, keepdims=True)


def rigid(seed):
    """A turn, a uniform scale and a shift."""
    random = np.random.default_rng(seed)
    turn, _ = np.linalg.qr(random.normal(size=(3, 3)))
    matrix = np.eye(4)
    matrix[:3, :3] = turn * random.uniform(0.5, 2)
    matrix[:3, 3] = random.uniform(-20, 20, 3)
    return matrix


@given(marks=marks, seed=st.integers(0, 99))
def test_the_last_mark_that_covers_a_point_decides(marks, seed):
    points, normals = cloud(seed)
    expected = np.zeros(len(points), bool)
    for erase, shape in marks:
        expected[shape.covers(points, normals)] = not erase
    assert np.array_equal(region_of(marks).covers(points, normals), expected)


@given(marks=marks, shape=shapes, seed=st.integers(0, 99))
def test_nothing_is_left_where_something_was_erased_last(marks, shape, seed):
    points, normals = cloud(seed)
    left = region_of(marks).erase(shape).covers(points, normals)
    assert not left[shape.covers(points, normals)].any()


@given(marks=marks, matrix=st.integers(0, 99), seed=st.integers(0, 99))
def test_a_region_moves_with_the_model(marks, matrix, seed):
    points, normals = cloud(seed)
    region, matrix = region_of(marks), rigid(matrix)
    moved = points @ matrix[:3, :3].T + matrix[:3, 3]
    turned = normals @ np.linalg.inv(matrix[:3, :3])
    turned /= np.linalg.norm(turned, axis=1, keepdims=True)
    at_home = region.covers(points, normals)
    assert np.array_equal(region.transformed(matrix).covers(moved, turned), at_home)
    there_and_back = region.transformed(matrix).transformed(np.linalg.inv(matrix))
    assert np.array_equal(there_and_back.covers(points, normals), at_home)


@given(marks=marks, seed=st.integers(0, 99))
def test_a_region_answers_each_point_by_itself(marks, seed):
    points, normals = cloud(seed)
    region = region_of(marks)
    order = np.random.default_rng(seed).permutation(len(points))
    whole = region.covers(points, normals)
    assert np.array_equal(region.covers(points[order], normals[order]), whole[order])


@given(marks=marks, matrix=st.integers(0, 99), seed=st.integers(0, 99))
def test_sections_hold_the_points_that_the_region_covers(marks, matrix, seed):
    region, z = region_of(marks).transformed(rigid(matrix)), np.linspace(-25, 25, 9)
    plan = np.random.default_rng(seed).uniform(-30, 30, (100, 2))
    cut = sections(region, z, np.array([[-30.0, -30.0], [30.0, 30.0]]), 1.0)
    for height, area in zip(z, cut, strict=True):
        points = np.column_stack([plan, np.full(len(plan), height)])
        covered = region.covers(points, np.tile([0.0, 0.0, 1.0], (len(points), 1)))
        # A ball is cut as a polygon: what is near to its edge may fall on either side.
        clear = shapely.distance(shapely.boundary(area), shapely.points(plan)) > 0.15
        sure = clear | shapely.is_empty(area)
        assert np.array_equal(shapely.contains_xy(area, *plan.T)[sure], covered[sure])


def test_a_predicate_is_cut_to_within_the_pitch_that_it_is_asked_at():
    region = Region().add(Predicate(function=lambda p: np.hypot(p[:, 0], p[:, 1]) < 10))
    disc = shapely.Point(0, 0).buffer(10, quad_segs=64)
    (area,) = sections(region, np.zeros(1), np.array([[-12.0, -12.0], [12.0, 12.0]]), 0.5)
    assert shapely.hausdorff_distance(shapely.boundary(area), shapely.boundary(disc)) < 1.0


def test_paint_has_no_sections():
    stroke = Stroke(points_mm=[(0, 0, 0)], normals=[(0, 0, 1)], radius_mm=9)
    region = Region().add(stroke)
    bounds = np.array([[-9.0, -9.0], [9.0, 9.0]])
    assert shapely.is_empty(sections(region, np.zeros(1), bounds, 1.0)).all()
    kept = sections(region.add(ZRange()).erase(stroke), np.zeros(1), bounds, 1.0)
    assert shapely.area(kept).tolist() == [18 * 18]


def test_a_region_to_which_nothing_was_added_is_false():
    assert not Region()
    assert not Region().erase(ZRange())
    assert Region().add(ZRange())


def test_a_predicate_is_asked_in_its_own_frame():
    region = Region().add(Predicate(function=lambda points: points[:, 0] > 5))
    points, normals = np.array([[4.0, 0, 0], [6.0, 0, 0]]), np.array([[0.0, 0, 1]] * 2)
    assert region.covers(points, normals).tolist() == [False, True]
    shift = np.eye(4)
    shift[0, 3] = 2
    assert region.transformed(shift).covers(points, normals).tolist() == [False, False]
    with pytest.raises(SettingError, match="bool for each"):
        Region().add(Predicate(function=lambda points: points)).covers(points, normals)


@pytest.mark.parametrize(
    ("points", "normals", "complaint"),
    [
        (np.zeros((2, 3), "f4"), np.zeros((2, 3)), "points has dtype float32"),
        (np.zeros((2, 2)), np.zeros((2, 3)), r"points has dtype float64 and shape \(2, 2\)"),
        (np.zeros((2, 3)), np.zeros((1, 3)), r"normals has shape \(1, 3\)"),
        (np.full((1, 3), math.nan), np.zeros((1, 3)), "points holds"),
    ],
)
def test_wrong_arrays_are_refused(points, normals, complaint):
    with pytest.raises(SettingError, match=complaint):
        Region().add(ZRange()).covers(points, normals)


@pytest.mark.parametrize(
    "matrix", [np.eye(3), np.zeros((4, 4)), np.diag([1.0, 1, 0, 1]), np.diag([1.0, 1, math.inf, 1])]
)
def test_a_matrix_that_is_no_affine_map_is_refused(matrix):
    with pytest.raises(SettingError, match="matrix"):
        Region().add(ZRange()).transformed(matrix)
