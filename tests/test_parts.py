"""Random mechanical parts are printed whole, and certified, on printers that people own."""

import numpy as np
import pytest

import part_rules
import random_parts
from wireprint import Settings

MACHINES = (
    ("kossel-mini", "abs"),
    ("prusa-mk4s", "pla"),
    ("voron-2.4", "abs"),
    ("printrbot-simple", "pla"),
)
#: Parts that fit the smallest of these printers' beds, turned as they are.
FITS_MM = 110.0
PARTS = [part for part in map(random_parts.part, range(80)) if np.ptp(part.mesh()[0]) < FITS_MM]


@pytest.fixture(scope="module")
def settings():
    return {machine: Settings.load(*machine) for machine in MACHINES}


def test_the_sample_has_parts_of_most_kinds():
    assert len(PARTS) > 40
    assert len({part.kind for part in PARTS}) >= 0.8 * len(random_parts.KINDS)


@pytest.mark.parametrize("part", PARTS, ids=lambda part: f"{part.kind}-{part.seed}")
def test_a_part_is_whole_and_certified(part, settings):
    machine = MACHINES[part.seed % len(MACHINES)]
    assert part_rules.shortcomings(part, settings[machine]) == []
