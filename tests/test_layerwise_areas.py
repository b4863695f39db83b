"""What of many areas is near to something."""

import numpy as np
import pytest
import shapely

from wireprint.layerwise.areas import grown, pieces_in


def squares(*corners):
    return shapely.MultiPolygon([shapely.box(x, y, x + 1, y + 1) for x, y in corners])


@pytest.mark.parametrize(
    ("box", "corners"),
    [
        ((0.2, 0.2, 0.4, 0.4), [(0, 0)]),
        # What touches meets.
        ((1, 1, 3, 3), [(0, 0), (3, 0)]),
        ((-9, -9, 9, 9), [(0, 0), (3, 0), (0, 5)]),
        ((1.5, 1.5, 2.5, 2.5), []),
        ((np.nan,) * 4, []),
    ],
)
def test_the_pieces_that_meet_a_box_are_kept_whole(box, corners):
    areas = np.array([squares((0, 0), (3, 0), (0, 5)), shapely.MultiPolygon()])
    found = pieces_in(areas, np.array([box, (-9.0, -9.0, 9.0, 9.0)]))
    assert found[0].equals(squares(*corners))
    assert found[1].is_empty


def test_of_nothing_nothing_is_kept():
    assert len(pieces_in(np.zeros(0, object), np.zeros((0, 4)))) == 0


def test_lines_that_lie_on_each_other_grow_to_what_is_near_to_them():
    rng = np.random.default_rng(1)
    along = np.linspace(0, 9, 40)
    walk = np.column_stack([along, np.sin(along)])
    beside = walk + rng.normal(scale=1e-7, size=walk.shape)
    crossing = shapely.LineString([(0, -1), (9, 1)])
    lines = [shapely.union(shapely.LineString(walk), shapely.LineString(beside)), crossing]
    given = np.array([shapely.union(*lines), shapely.MultiLineString(), crossing], dtype=object)
    mm = np.array([0.7, 1.0, 0.2])
    found = grown(given, mm)
    assert found[1].is_empty
    points = shapely.points(rng.uniform((-1, -3), (10, 3), (2000, 2)))
    for lines, area, reach in zip(given[[0, 2]], found[[0, 2]], mm[[0, 2]], strict=True):
        away = shapely.distance(points, lines)
        inside = shapely.contains_xy(area, *shapely.get_coordinates(points).T)
        # Circles are polygons, and lines are simplified by up to a hundredth of what they grow by.
        sure = abs(away - reach) > 0.02 * reach
        assert (inside == (away < reach))[sure].all()
