"""Slabs are made lower about what a print would leave bare, and nowhere else."""

import numpy as np
import pytest
import trimesh

import random_solids
from command import run
from wireprint import Region, Settings, replanning
from wireprint._core import Mesh
from wireprint.pipeline import make
from wireprint.regions import ZRange

#: Solids that slabs of all of a cone's height miss parts of, by printer and material: a body of
#: two slabs, and a pipe that lies on the bed.
BARE = [("printrbot-simple", "pla", 994007), ("kossel-mini", "abs", 995025)]
NEVER = "wire.coverage_goal=0"


def mesh_of(seed):
    vertices, faces = random_solids.solid(seed).mesh()
    return Mesh.from_arrays(vertices, faces.astype(np.int64))


def coverage(made):
    return made.certificate.fidelity.coverage


@pytest.fixture(scope="module", params=BARE, ids=lambda case: case[0])
def case(request):
    printer, material, seed = request.param
    return mesh_of(seed), Settings.load(printer, material)


@pytest.fixture(scope="module")
def made(case):
    mesh, settings = case
    return make(mesh, settings, partial=True)


def test_what_high_slabs_leave_bare_is_covered(case, made):
    mesh, settings = case
    plain = make(mesh, settings.but(overrides=[NEVER]), partial=True)
    assert plain.certificate.ok
    assert coverage(plain) < settings.wire.coverage_goal
    assert plain.unprinted()
    assert made.certificate.ok
    assert coverage(made) >= settings.wire.coverage_goal
    assert not made.unprinted()


def test_slabs_are_lower_about_that_alone(case, made):
    _, settings = case
    bands = np.array(made.settings.wire.low_slabs_mm)
    assert len(bands)
    assert made.figures()["low_slabs_mm"] == bands.tolist()
    levels = made.wireframe.levels[:, 0]
    middles = (levels[:-1] + levels[1:]) / 2
    for low, high, most in bands:
        within = np.diff(levels)[(low < middles) & (middles < high)]
        assert (within <= most + 1e-6).all()
    assert bands[:, 2].max() < settings.slab_max_mm


def test_what_its_own_settings_print_is_the_same(case, made):
    mesh, _ = case
    assert make(mesh, made.settings, partial=True).gcode == made.gcode


def test_a_mark_gives_with_what_was_kept_what_it_gives_without(case, made):
    mesh, settings = case
    mark = Region().add(ZRange(low_mm=0.0, high_mm=mesh.size_mm[2] / 3))
    fresh = make(mesh, settings, mark, partial=True)
    assert fresh.settings == made.settings
    assert make(mesh, settings, mark, partial=True, kept=made.sketch).gcode == fresh.gcode


def test_a_print_that_was_not_judged_is_looked_at_when_it_is(case, made):
    mesh, settings = case
    unjudged = make(mesh, settings, certify=False, partial=True)
    assert unjudged.settings == settings
    assert make(mesh, settings, partial=True, kept=unjudged.sketch).gcode == made.gcode


def test_low_slabs_of_the_user_stay():
    mesh = mesh_of(994007)
    asked = (0.0, 1.5, 1.5)
    settings = Settings.load("printrbot-simple", "pla", overrides=[f"wire.low_slabs_mm={[*asked]}"])
    found = make(mesh, settings, partial=True).settings.wire.low_slabs_mm
    assert found[0] == asked
    assert len(found) > 1


def test_what_is_covered_is_planned_once(cube, monkeypatch):
    def never(*_):
        raise AssertionError

    monkeypatch.setattr(replanning, "replanned", never)
    assert coverage(make(cube)) > 0.99


def test_a_print_that_nothing_helps_stays_as_it_is():
    mesh = mesh_of(995025)
    settings = Settings.load(overrides=["wire.slab_min_mm=6"])
    made = make(mesh, settings, partial=True)
    assert coverage(made) < 0.99
    assert made.settings == settings


def test_the_command_says_where_slabs_are_lower(tmp_path):
    vertices, faces = random_solids.solid(994007).mesh()
    trimesh.Trimesh(vertices, faces).export(tmp_path / "solid.stl")
    words = ("slice", tmp_path / "solid.stl", "-o", tmp_path / "solid.gcode")
    words += ("--printer", "printrbot-simple", "--material", "pla")
    refused = run(*words, "--set", NEVER)
    assert refused.exit_code == 5
    assert "only 91.9 %" in refused.stderr
    done = run(*words)
    assert done.exit_code == 0, done.stderr
    assert "lower slabs" in done.stdout
