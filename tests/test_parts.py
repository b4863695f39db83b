"""Random mechanical parts are printed whole, and certified, on printers that people own."""

import numpy as np
import pytest
import shapely
import trimesh
from shapely import affinity

import part_rules
import random_parts
import random_solids
from layered_solids import Body
from random_parts import Part, disc, rectangle
from random_solids import Solid, block, lathed
from wireprint import Settings, make

MACHINES = (
    ("kossel-mini", "abs"),
    ("prusa-mk4s", "pla"),
    ("voron-2.4", "abs"),
    ("printrbot-simple", "pla"),
)
#: Parts that fit the smallest of these printers' beds, turned as they are.
FITS_MM = 110.0
PARTS = [part for part in map(random_parts.part, range(80)) if np.ptp(part.mesh()[0]) < FITS_MM]
#: The same of round, slanted and thin shapes.
SOLIDS = [
    solid for solid in map(random_solids.solid, range(60)) if np.ptp(solid.mesh()[0]) < FITS_MM
]


def bored(diameter_mm):
    """A block with a bore that lies, and one that ends inside."""
    body = Body().add(rectangle(50, 40), 0, 36).cut(disc(diameter_mm), 0, 36)
    return Part(0, "bored", (body.cut(affinity.translate(disc(8), 18), 0, 20),), 1, 20.0)


def shelf():
    """Three wide shelves above each other around a slender tower."""
    body = Body().add(rectangle(12, 12), 0, 60)
    for low in (15, 35, 55):
        body.add(rectangle(90, 70), low, low + 1.5)
    return Part(0, "shelf", (body,), 0, 0.0)


def top():
    """A spinning top: its roof is wider than a span, and all below it leans."""
    outline = (0.0, 0.0), (8.0, 0.0), (55.0, 50.0), (50.0, 60.0), (0.0, 60.0)
    return Solid(0, "top", (lathed(*outline), block(10.0, 10.0, 8.0)))


def lidded():
    """A cup with a lid of its own, flush with its rim and thinner than a strand."""
    cup = Body().add(disc(60), 0, 24).cut(disc(48), 5, 24)
    return Part(0, "lidded", (cup, Body().add(disc(60), 24, 24.6)), 0, 0.0)


def floored():
    """A tube on a floor of its own, flush with its rim and thinner than a strand."""
    tube = Body().add(disc(60), 0.6, 24).cut(disc(48), 0.6, 24)
    return Part(0, "floored", (Body().add(disc(60), 0, 0.6), tube), 0, 0.0)


def rimmed():
    """A tray whose floor reaches into a rim of its own, which covers the floor's sides."""
    rim = Body().add(rectangle(90, 70), 0, 20).cut(rectangle(82, 62), 0, 20)
    return Part(0, "rimmed", (Body().add(rectangle(86, 66), 0, 1.2), rim), 0, 0.0)


def sleeved():
    """A tube in another one with the same outside: they share a wall, each has its own floor."""
    outer, inner = Body().add(disc(90), 0, 40), Body().add(disc(90), 0, 22)
    return Part(0, "sleeved", (outer.cut(disc(76), 0, 40), inner.cut(disc(80), 0, 22)), 1, 20.0)


def flush():
    """Walls that stand on a plate, flush with its sides, around a ring and a rod."""
    plate, rod = Body().add(disc(100), 0, 8), Body().add(disc(9), 0, 60)
    rim = Body().add(disc(100), 0, 30).cut(disc(80), 0, 30)
    ring = Body().add(disc(52), 0, 26).cut(disc(32), 0, 26)
    return Part(0, "flush", (plate, rim, ring, rod), 0, 0.0)


def touching():
    """Two cylinders of different heights that overlap by a hair."""
    tall = random_solids.at(lathed((0.0, 0.0), (10.0, 0.0), (10.0, 20.0), (0.0, 20.0)), x=24.9)
    return Solid(0, "touching", (lathed((0.0, 0.0), (15.0, 0.0), (15.0, 16.0), (0.0, 16.0)), tall))


def leaning():
    """A thin plate that leans back on a foot, and a stop before it, as of a stand."""
    foot, stop = block(70, 80, 4), random_solids.at(block(70, 6, 12), y=-25.0, z=2.0)
    plate = block(70, 4, 80)
    plate.apply_transform(trimesh.transformations.rotation_matrix(np.radians(-20), [1, 0, 0]))
    return Solid(0, "leaning", (foot, stop, random_solids.at(plate, y=10.0, z=2.0)))


def hooked():
    """A hook, 3 mm thick: a thin contour that bends, and hangs over in the end."""
    hook = Body().add(shapely.LineString([(0, 0), (40, 0), (40, 25), (8, 25)]).buffer(1.5), 0, 40)
    return Part(0, "hooked", (hook,), 0, 0.0)


NAMED = {
    "rimmed": rimmed(),
    "sleeved": sleeved(),
    "flush": flush(),
    "touching": touching(),
    "leaning": leaning(),
    "hooked": hooked(),
    "lidded": lidded(),
    "floored": floored(),
    "bored 8": bored(8),
    "bored 24": bored(24),
    "shelf": shelf(),
    "top": top(),
}


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


@pytest.mark.parametrize("solid", SOLIDS, ids=lambda solid: f"{solid.kind}-{solid.seed}")
def test_a_solid_is_whole_and_certified(solid, settings):
    machine = MACHINES[solid.seed % len(MACHINES)]
    assert part_rules.shortcomings(solid, settings[machine]) == []


@pytest.mark.parametrize("machine", MACHINES, ids=lambda machine: machine[0])
@pytest.mark.parametrize("name", NAMED)
def test_what_lies_leans_or_hangs_high_is_whole(name, machine, settings):
    assert part_rules.shortcomings(NAMED[name], settings[machine]) == []


@pytest.mark.parametrize("machine", MACHINES, ids=lambda machine: machine[0])
@pytest.mark.parametrize("name", ["leaning", "hooked"])
def test_thin_contours_are_trusses(name, machine, settings):
    wireframe = make(NAMED[name].mesh(), settings[machine]).wireframe
    assert wireframe.diagonal_count >= 0.85 * wireframe.post_count
