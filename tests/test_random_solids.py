"""The generator of random solids: what it makes is closed, and always the same."""

import numpy as np
import pytest

import random_solids
from layered_solids import is_closed

SEEDS = range(120)


@pytest.mark.parametrize("seed", SEEDS)
def test_a_solid_is_made_of_closed_bodies(seed):
    solid = random_solids.solid(seed)
    vertices, faces = solid.mesh()
    assert is_closed(faces)
    assert all(body.volume > 0 for body in solid.bodies)
    assert vertices[:, 2].min() == 0
    assert np.ptp(vertices, axis=0).max() < 2 * random_solids.LARGEST


def test_all_kinds_are_made_and_a_seed_is_always_the_same_solid():
    solids = [random_solids.solid(seed) for seed in SEEDS]
    assert {solid.kind for solid in solids} == set(random_solids.KINDS)
    for solid in solids[:10]:
        again = random_solids.solid(solid.seed).mesh()
        assert all(np.array_equal(a, b) for a, b in zip(solid.mesh(), again, strict=True))
