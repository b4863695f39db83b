"""Slabs are made lower where few diagonals brace posts, if that suffices and is quick enough."""

import numpy as np
import pytest
import shapely

import random_solids
from wireprint import Settings, bracing
from wireprint._core import Mesh
from wireprint.pipeline import make

NEVER = "wire.braced_goal=0"


def perforated(size, hole, pitch, high):
    """Return a plate with round holes, on whose short rims a high diagonal finds no room."""
    middles = np.arange(-size / 2 + pitch, size / 2 - pitch / 2, pitch)
    holes = [shapely.Point(x, y).buffer(hole / 2) for x in middles for y in middles]
    area = shapely.box(-size / 2, -size / 2, size / 2, size / 2)
    body = random_solids.prism(area.difference(shapely.union_all(holes)), high)
    return Mesh.from_arrays(body.vertices, body.faces.astype(np.int64))


def share(made):
    return made.wireframe.diagonal_count / made.wireframe.post_count


@pytest.fixture(scope="module")
def plate():
    return perforated(40, 5, 10, 6)


@pytest.fixture(scope="module")
def settings():
    return Settings.load("prusa-mk4s", "pla")


@pytest.fixture(scope="module")
def plain(plate, settings):
    return make(plate, settings.but(overrides=[NEVER]))


def test_short_rims_are_braced(plate, settings, plain):
    assert share(plain) < settings.wire.braced_goal
    made = make(plate, settings)
    assert share(made) >= settings.wire.braced_goal
    assert made.certificate.ok
    assert made.certificate.fidelity.coverage >= settings.wire.coverage_goal
    assert made.estimate.total_s <= 1.3 * plain.estimate.total_s
    assert len(made.settings.wire.low_slabs_mm) == 1


def test_a_print_that_would_take_much_longer_stays_as_it_is(plate, settings, plain, monkeypatch):
    monkeypatch.setattr(bracing, "_LONGEST", 0.5)
    assert make(plate, settings).wireframe.strands.tolist() == plain.wireframe.strands.tolist()


def test_what_is_braced_is_planned_once(settings, monkeypatch):
    monkeypatch.setattr(bracing, "_weakest", None)
    assert share(make(perforated(60, 6, 20, 10), settings)) > 0.9


def test_what_is_hardly_braced_at_all_is_planned_once(settings, monkeypatch):
    monkeypatch.setattr(bracing, "_weakest", None)
    # Bars beside each other on which a diagonal would end in the way of the head.
    bars = [random_solids.at(random_solids.block(6, 6, 30), x) for x in range(-24, 25, 12)]
    vertices, faces = random_solids.Solid(0, "bars", tuple(bars)).mesh()
    assert share(make(Mesh.from_arrays(vertices, faces.astype(np.int64)), settings)) < 0.3
