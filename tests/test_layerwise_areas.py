"""What of many areas is near to something."""

import numpy as np
import pytest
import shapely

from wireprint.layerwise.areas import pieces_in


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
