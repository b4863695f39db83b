"""The generator of random parts: what it makes is closed, and always the same."""

import numpy as np
import pytest
import trimesh

import random_parts
from layered_solids import Body, is_closed

SEEDS = range(120)


@pytest.mark.parametrize("seed", SEEDS)
def test_a_part_is_closed_and_holds_what_its_areas_hold(seed):
    part = random_parts.part(seed)
    vertices, faces = part.mesh()
    assert is_closed(faces)
    mesh = trimesh.Trimesh(vertices, faces, process=False)
    assert mesh.area_faces.min() > 0
    assert mesh.volume == pytest.approx(sum(body.volume() for body in part.bodies), rel=1e-3)
    assert vertices[:, 2].min() == 0
    assert np.ptp(vertices, axis=0).max() < 2 * random_parts.LARGEST


def test_all_kinds_are_made_and_a_seed_is_always_the_same_part():
    parts = [random_parts.part(seed) for seed in SEEDS]
    assert {part.kind for part in parts} == set(random_parts.KINDS)
    for part in parts[:10]:
        again = random_parts.part(part.seed).mesh()
        assert all(np.array_equal(a, b) for a, b in zip(part.mesh(), again, strict=True))


def test_a_later_step_wins_over_an_earlier_one():
    square = random_parts.rectangle
    body = Body().add(square(10, 10), 0, 6).cut(square(4, 4), 2, 6).add(square(2, 2), 3, 8)
    vertices, faces = body.mesh()
    assert trimesh.Trimesh(vertices, faces).is_watertight
    assert body.volume() == pytest.approx(600 - 64 + 20)
