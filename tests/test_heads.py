"""Prints follow the head: what a slimmer one gains, and what stays when all of it is scaled."""

from random import Random

import numpy as np
import pytest
import trimesh

import random_parts
import random_solids
from scaled_machines import scaled
from wireprint.mesh import Mesh, load_mesh
from wireprint.pipeline import make
from wireprint.settings import Settings
from wireprint.stages import wireframe

POST, DIAGONAL = 2, 3


def tube():
    return trimesh.creation.annulus(9, 13, 20, sections=64)


def bracket():
    """An upright plate on a foot, with a boss; lopsided, so that rounding decides nothing."""
    foot = trimesh.creation.box(bounds=[(-20, -12, 0), (21, 11.3, 7.7)])
    plate = trimesh.creation.box(bounds=[(-20, -12, 7.7), (-12, 11.3, 25.6)])
    boss = trimesh.creation.cylinder(5, 9.4, sections=48)
    boss.apply_translation((8, -1.2, 12.4))
    return trimesh.util.concatenate([foot, plate, boss])


SHAPES = {
    "box": lambda: trimesh.creation.box((24, 18, 20)),
    "cylinder": lambda: trimesh.creation.cylinder(12, 22, sections=64),
    "cone": lambda: trimesh.creation.cone(14, 26, sections=48),
    "ball": lambda: trimesh.creation.icosphere(3, 13),
    "tube": tube,
    "bracket": bracket,
}
#: From bulky to slim. Slabs are as high as the bulkiest head allows.
HEADS = {
    "head.slant_deg": (22, 27, 32, 44, 60),
    "head.tip_radius_mm": (0.9, 0.7, 0.5, 0.36),
    "head.cone_height_mm": (5, 6, 9),
    "head.block_radius_mm": (32, 20, 12),
}
MACHINES = [("kossel-mini", "abs"), ("prusa-mk4s", "pla"), ("printrbot-simple", "pla")]
#: Random parts are no larger.
LARGEST_MM = 60
#: A travel more or less is rounding in prints of a few seconds.
HOP_S = 1.2
#: So many diagonals more or less are rounding: those of one ring that is too small for its slab.
ROUNDING = 2.5


@pytest.fixture(scope="module")
def stl(tmp_path_factory):
    """Files of the shapes, made once."""
    folder = tmp_path_factory.mktemp("shapes")
    for name, shape in SHAPES.items():
        shape().export(folder / f"{name}.stl")
    return lambda name: folder / f"{name}.stl"


def printed(model, machine, *overrides):
    """Posts, diagonals and print time, s, of a file."""
    return of_mesh(load_mesh(model), machine, "wire.slab_max_mm=5", *overrides)


def of_mesh(mesh, machine, *overrides):
    """Posts, diagonals and print time, s."""
    made = make(mesh, Settings.load(*machine, overrides=overrides), partial=True)
    kinds = made.wireframe.strand_kinds
    assert made.certificate.ok
    return np.sum(kinds == POST), np.sum(kinds == DIAGONAL), made.estimate.total_s


@pytest.mark.parametrize("shape", SHAPES)
@pytest.mark.parametrize("machine", MACHINES[:2])
def test_a_slimmer_head_takes_no_longer_for_as_many_posts(stl, shape, machine):
    for key, values in HEADS.items():
        last = None
        for value in values:
            posts, _, time_s = now = printed(stl(shape), machine, f"{key}={value}")
            if last is not None:
                # More posts, for finer meshes, are worth their time.
                longest_s = 1.02 * last[2] * max(1, posts / last[0])
                assert time_s <= longest_s, f"{shape}, {key} {value}: {now} after {last}"
            last = now


def least(now, last):
    """The fewest diagonals that a slimmer head may print: as many, or as large a share."""
    return 0.98 * last[1] * min(1, now[0] / max(1, last[0])) - ROUNDING


@pytest.mark.parametrize("shape", SHAPES)
@pytest.mark.parametrize("machine", MACHINES)
def test_a_slimmer_head_braces_no_fewer_of_its_posts(stl, shape, machine):
    for key, values in HEADS.items():
        last = None
        for value in values:
            _, diagonals, _ = now = printed(stl(shape), machine, f"{key}={value}")
            if last is not None:
                assert diagonals >= least(now, last), f"{shape}, {key} {value}: {now} after {last}"
            last = now


@pytest.mark.parametrize("seed", range(24))
def test_a_slimmer_head_prints_random_parts_no_worse(seed):
    draw = Random(seed)
    vertices, faces = draw.choice((random_solids.solid, random_parts.part))(seed).mesh()
    mesh = Mesh.from_arrays(vertices * min(1, LARGEST_MM / np.ptp(vertices, axis=0).max()), faces)
    machine = draw.choice([*MACHINES, ("voron-2.4", "abs"), ("ender-3", "pla")])
    head = Settings.load(*machine).printer.head
    key, value = draw.choice(
        [
            ("slant_deg", head.slant_deg - draw.uniform(2, 10)),
            ("tip_radius_mm", head.tip_radius_mm * draw.uniform(1.1, 1.6)),
            ("cone_height_mm", head.cone_height_mm * draw.uniform(0.7, 0.95)),
            ("block_radius_mm", head.block_radius_mm * draw.uniform(1.1, 1.6)),
        ]
    )
    low = "wire.slab_max_mm=3.5"
    bulky, slim = (of_mesh(mesh, machine, low, *more) for more in ([f"head.{key}={value}"], []))
    assert slim[1] >= least(slim, bulky), (slim, bulky)
    finer = max(1, slim[0] / max(1, bulky[0]))
    assert slim[2] <= 1.02 * bulky[2] * finer + HOP_S, (slim, bulky)


def posts_at(model, machine, factor, scale=1.0):
    mesh = load_mesh(model, scale=scale * factor)
    return wireframe(mesh, scaled(machine, factor)).post_count


@pytest.mark.parametrize("shape", ["bracket", "tube"])
@pytest.mark.parametrize("machine", [("kossel-mini", "abs"), ("ender-3", "pla")])
def test_a_larger_machine_prints_a_larger_part_alike(stl, shape, machine):
    posts = posts_at(stl(shape), machine, 1.0)
    for factor in (0.5, 0.8, 1.3, 2.0):
        now = posts_at(stl(shape), machine, factor)
        assert now == pytest.approx(posts, rel=0.02, abs=1), factor


def test_a_larger_machine_prints_a_larger_bunny_alike(shared):
    bunny = shared / "models" / "bunny.stl"
    posts = posts_at(bunny, ("kossel-mini", "abs"), 1.0, 792.372)
    for factor in (0.5, 0.8, 1.3, 2.0):
        now = posts_at(bunny, ("kossel-mini", "abs"), factor, 792.372)
        assert now == pytest.approx(posts, rel=0.02), factor
