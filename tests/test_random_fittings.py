"""The generator of random fittings: what it makes is closed, and always the same."""

import numpy as np
import pytest

import random_fittings
from layered_solids import is_closed

SEEDS = range(120)


@pytest.mark.parametrize("seed", SEEDS)
def test_a_fitting_is_made_of_closed_bodies(seed):
    fitting = random_fittings.fitting(seed)
    vertices, faces = fitting.mesh()
    assert is_closed(faces)
    assert all(body.volume > 0 for body in fitting.bodies)
    assert vertices[:, 2].min() == 0
    assert np.ptp(vertices, axis=0).max() < 2 * random_fittings.LARGEST


def test_all_kinds_are_made_and_a_seed_is_always_the_same_fitting():
    fittings = [random_fittings.fitting(seed) for seed in SEEDS]
    assert {fitting.kind for fitting in fittings} == set(random_fittings.KINDS)
    for fitting in fittings[:10]:
        again = random_fittings.fitting(fitting.seed).mesh()
        assert all(np.array_equal(a, b) for a, b in zip(fitting.mesh(), again, strict=True))
