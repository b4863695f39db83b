"""Rings too small for three posts are coiled: rods, fingers, columns; whatever is larger is not."""

from __future__ import annotations

import math

import numpy as np
import pytest
import trimesh

from wireprint import KINDS, Mesh
from wireprint.pipeline import make
from wireprint.settings import Settings

PRINTERS = (("kossel-mini", "abs"), ("prusa-mk4s", "pla"), ("printrbot-simple", "pla"))


@pytest.fixture(params=PRINTERS, ids=lambda names: names[0])
def settings(request):
    return Settings.load(*request.param)


def printed(solid, settings):
    """The print of a solid that stands on the bed."""
    solid.apply_translation(-solid.bounds[0])
    return make(Mesh.from_arrays(solid.vertices, solid.faces), settings)


def length_mm(made, kind):
    """Length of all strands of a kind."""
    ends = made.wireframe.strands.reshape(-1, 2, 3)
    own = ends[made.wireframe.strand_kinds == KINDS.index(kind)]
    return float(np.linalg.norm(own[:, 1] - own[:, 0], axis=1).sum())


def rod(radius_mm, height_mm, lean=0.0):
    """A rod that leans so far along x for each step up."""
    solid = trimesh.creation.cylinder(radius_mm, height_mm, sections=48)
    shear = np.eye(4)
    shear[0, 2] = lean
    return solid.apply_transform(shear)


def test_a_rod_is_one_coil_without_posts_or_pauses(settings):
    radius_mm = 5 * settings.printer.head.nozzle_mm
    made = printed(rod(radius_mm, 30.0), settings)
    assert made.certificate.ok
    assert made.figures()["coverage"] > 0.99
    assert made.wireframe.post_count == 0
    assert length_mm(made, "diagonal") == 0
    # Turns lie three quarters of a strand from each other at most.
    turns = 30.0 / (0.75 * settings.printer.head.nozzle_mm)
    assert length_mm(made, "contour") > 0.9 * turns * math.tau * radius_mm


@pytest.mark.parametrize("lean", [0.4, 0.9])
def test_a_rod_that_leans_is_coiled_but_where_slabs_are_low_enough_for_posts(settings, lean):
    radius_mm = 3 * settings.printer.head.nozzle_mm
    made = printed(rod(radius_mm, 30.0, lean), settings)
    assert made.certificate.ok
    assert made.figures()["coverage"] > 0.99
    turns = 30.0 / (0.75 * settings.printer.head.nozzle_mm)
    assert length_mm(made, "contour") > 0.5 * turns * math.tau * radius_mm


def test_a_coil_rises_turn_by_turn_on_itself(settings):
    nozzle_mm = settings.printer.head.nozzle_mm
    made = printed(rod(5 * nozzle_mm, 20.0), settings)
    ends = made.wireframe.strands.reshape(-1, 2, 3)
    own = ends[made.wireframe.strand_kinds == KINDS.index("contour")]
    heights = own[:, 1, 2]
    assert np.all(np.diff(heights) >= -1e-9)
    assert np.max(np.diff(heights)) < 0.75 * nozzle_mm


def test_a_wall_that_lies_more_than_it_stands_is_not_coiled(settings):
    made = printed(rod(5 * settings.printer.head.nozzle_mm, 20.0, lean=2.5), settings)
    assert made.certificate.ok
    assert made.wireframe.post_count > 0


def test_what_has_room_for_a_zigzag_gets_one(settings):
    made = printed(rod(25.0, 20.0), settings)
    assert made.wireframe.post_count > 10
    assert length_mm(made, "diagonal") > 0


def row(settings, gap_nozzles, lean=0.0, count=4):
    """Rods in a row along y, so many diameters of the nozzle apart."""
    nozzle_mm = settings.printer.head.nozzle_mm
    rods = [rod(3 * nozzle_mm, 20.0, lean) for _ in range(count)]
    for number, one in enumerate(rods):
        one.apply_translation([0.0, number * (6 + gap_nozzles) * nozzle_mm, 0.0])
    return trimesh.util.concatenate(rods)


@pytest.mark.parametrize("lean", [0.0, 0.8])
@pytest.mark.parametrize("gap_nozzles", [3.0, 6.0, 11.0])
def test_rods_in_a_row_are_coiled_in_lifts(settings, gap_nozzles, lean):
    nozzle_mm = settings.printer.head.nozzle_mm
    made = printed(row(settings, gap_nozzles, lean), settings)
    assert made.certificate.ok
    assert made.figures()["coverage"] > 0.99
    assert lean or made.wireframe.post_count == 0
    around_mm = 4 * math.tau * 3 * nozzle_mm
    assert length_mm(made, "contour") > 0.5 * 20.0 / (0.75 * nozzle_mm) * around_mm


def test_rods_that_stand_closer_than_a_turn_is_high_get_posts(settings):
    made = printed(row(settings, 1.0), settings)
    assert made.certificate.ok
    assert made.wireframe.post_count > 0


def test_a_rod_beside_a_wall_gets_posts_like_the_wall(settings):
    nozzle_mm = settings.printer.head.nozzle_mm
    wall = trimesh.creation.box((60.0, 20.0, 20.0))
    wall.apply_translation([0.0, 10.0 + 8 * nozzle_mm, 10.0])
    made = printed(trimesh.util.concatenate([rod(5 * nozzle_mm, 20.0), wall]), settings)
    assert made.certificate.ok
    assert made.figures()["coverage"] > 0.95


def test_a_column_is_a_coil(settings):
    # A table's top far from its one foot.
    foot = trimesh.creation.box((20.0, 20.0, 30.0))
    top = trimesh.creation.box((140.0, 60.0, 4.0))
    top.apply_translation([0.0, 0.0, 17.0])
    made = printed(trimesh.util.concatenate([foot, top]), settings)
    assert made.certificate.ok
    own = made.wireframe.strand_kinds == KINDS.index("support")
    rises = np.ptp(made.wireframe.strands.reshape(-1, 2, 3)[own][:, :, 2], axis=1)
    assert len(rises) > 100
    assert np.median(rises) < settings.printer.head.nozzle_mm
