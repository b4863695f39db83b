"""Whole or not written: what a print leaves bare is named, and too much of it is refused."""

import json
import re

import numpy as np
import pytest
import trimesh

import wireprint
from command import run
from wireprint import IncompleteError, Mesh, Settings, wholeness
from wireprint.remedies import Remedy, remedies
from wireprint.report import unprinted

#: Strands of a cap lie 6 mm apart: no cap is covered.
NEAR = "wire.coverage_within_mm=1.2"


def solid(*boxes):
    """A mesh of boxes, each given by two corners."""
    parts = [trimesh.creation.box(bounds=corners) for corners in boxes]
    whole = trimesh.util.concatenate(parts)
    return Mesh.from_arrays(np.asarray(whole.vertices, float), np.asarray(whole.faces, np.int64))


@pytest.fixture(scope="module")
def block():
    return solid(([0, 0, 0], [28, 28, 28]))


@pytest.fixture
def no_remedy(monkeypatch):
    """Let no other way be tried."""
    monkeypatch.setattr(wholeness, "remedies", lambda _: iter(()))


@pytest.fixture
def bodies(tmp_path):
    """Two bodies that touch, one on the other, as a file."""
    path = tmp_path / "bodies.stl"
    mesh = solid(([0, 0, 0], [40, 40, 10]), ([5, 5, 10], [35, 35, 20]))
    trimesh.Trimesh(mesh.vertices, mesh.faces, process=False).export(path)
    return path


def test_bodies_that_touch_are_covered_whole(bodies, tmp_path):
    result = run("slice", bodies, "-o", tmp_path / "b.gcode", "--json")
    figures = json.loads(result.stdout)
    assert result.exit_code == 0
    assert figures["whole"]
    assert figures["coverage"] == 1.0
    assert figures["unprinted"] == []


def test_what_is_not_whole_is_refused_and_its_parts_are_named(cube, tmp_path, no_remedy):
    target = tmp_path / "cube.gcode"
    result = run("slice", cube, "-o", target, "--set", NEAR)
    assert result.exit_code == 5
    assert not target.exists()
    assert f"{cube}: only " in result.stderr
    assert "% of the outer surface would be covered (wire.coverage_min: 95 %)" in result.stderr
    assert result.stderr.count("\nbare: ") == 4
    assert re.search(r"bare: \d+ mm², [\d.]+ × [\d.]+ × [\d.]+ mm about \(", result.stderr)
    assert "more, " in result.stderr
    assert "--force writes it all the same" in result.stderr


def test_quiet_runs_are_judged_alike(cube, tmp_path, no_remedy):
    result = run("slice", cube, "-o", tmp_path / "cube.gcode", "-q", "--set", NEAR)
    assert result.exit_code == 5


def test_force_writes_it_and_says_so(cube, tmp_path):
    target = tmp_path / "cube.gcode"
    result = run("slice", cube, "-o", target, "--set", NEAR, "--force", "--json")
    figures = json.loads(result.stdout)
    assert result.exit_code == 0
    assert target.exists()
    assert not figures["whole"]
    assert figures["coverage"] < 0.95
    assert any(text.startswith("written although only ") for text in figures["warnings"])


def test_how_much_is_asked_for_is_a_setting(block):
    lenient = Settings.load(overrides=[NEAR, "wire.coverage_min=0.5"])
    assert wireprint.make(block, lenient).figures()["whole"]


def test_the_library_refuses_alike_unless_it_is_told_otherwise(block, tmp_path, no_remedy):
    settings = Settings.load(overrides=[NEAR])
    with pytest.raises(IncompleteError, match=r"only .* would be covered") as caught:
        wireprint.make(block, settings)
    assert caught.value.exit_code == 5
    assert len(caught.value.unprinted) > 4
    made = wireprint.make(block, settings, partial=True)
    assert made.certificate.fidelity.coverage < 0.95
    target = tmp_path / "block.gcode"
    path = wireprint.toolpath(wireprint.wireframe(block, settings), settings)
    with pytest.raises(IncompleteError, match=r"only .* would be covered"):
        wireprint.write_gcode(target, path, settings)
    assert not target.exists()
    wireprint.write_gcode(target, path, settings, partial=True)
    assert target.read_bytes() == wireprint.to_gcode(path, settings)


def test_a_remedy_is_named_when_a_trial_shows_that_it_works(block, monkeypatch):
    def planted(settings):
        yield Remedy("--useless", "", settings)
        yield Remedy("--refused", "", settings.but(overrides=["bed.diameter_mm=20"]))
        yield Remedy("--useful", "if you like", settings.but(overrides=["wire.cap_spacing_mm=1"]))
        pytest.fail("what works ends the search")

    settings = Settings.load(overrides=["wire.coverage_within_mm=1.8"])
    monkeypatch.setattr(wholeness, "remedies", planted)
    with pytest.raises(IncompleteError) as caught:
        wireprint.make(block, settings)
    assert caught.value.remedy == "--useful"
    assert "% covered when tried): --useful, if you like" in str(caught.value)
    again = settings.but(overrides=["wire.cap_spacing_mm=1"])
    assert wireprint.make(block, again).figures()["whole"]


def test_where_nothing_helps_it_is_told_what_was_tried(block):
    with pytest.raises(IncompleteError) as caught:
        wireprint.make(block, Settings.load(overrides=["wire.coverage_within_mm=0.3"]))
    assert caught.value.remedy is None
    assert "none of these helps, all were tried: --slab-min 0.7, " in str(caught.value)


def test_remedies_differ_from_the_settings():
    plain = [remedy.options for remedy in remedies(Settings.load())]
    assert plain[0] == "--slab-min 0.7"
    assert plain[-1] == "--orient auto"
    bare = Settings.load(overrides=["wire.supports=none", "wire.caps=false", "wire.pattern=peaks"])
    first = list(remedies(bare))[:3]
    assert [remedy.options for remedy in first] == ["--supports wire", "--caps", "--pattern zigzag"]
    assert [remedy.settings.wire.caps for remedy in first] == [False, True, False]
    fine = Settings.load(printer="prusa-mk4s", overrides=["wire.slab_min_mm=0.4"])
    assert not any("nozzle" in remedy.options for remedy in remedies(fine))
    assert not any("slab-min" in remedy.options for remedy in remedies(fine))


def test_a_print_without_a_strand_is_never_written(tmp_path):
    # A needle that stands askew on its tip: all of it hangs.
    corners = np.array([[0.0, 0, 0], [30, 0, 30], [34, 0, 30], [32, 3, 30]])
    faces = np.array([[0, 2, 1], [0, 3, 2], [0, 1, 3], [1, 2, 3]])
    model, target = tmp_path / "needle.stl", tmp_path / "needle.gcode"
    trimesh.Trimesh(corners, faces, process=False).export(model)
    result = run("slice", model, "-o", target, "--supports", "none", "--force")
    assert result.exit_code == 5
    assert "nothing of the model would be printed" in result.stderr
    assert "--force" not in result.stderr
    assert not target.exists()
    with pytest.raises(IncompleteError, match="--supports wire"):
        wireprint.make(wireprint.load_mesh(model), Settings.load(overrides=["wire.supports=none"]))


def test_level_faces_left_open_on_purpose_are_not_missed(cube, tmp_path):
    result = run("slice", cube, "-o", tmp_path / "cube.gcode", "--no-caps", "--json")
    figures = json.loads(result.stdout)
    assert result.exit_code == 0
    assert figures["whole"]
    assert figures["coverage"] > 0.99
    assert figures["unprinted"] == []


def test_a_hybrid_is_judged_alike(block, no_remedy):
    from wireprint.regions import Region, ZRange

    region = Region().add(ZRange(low_mm=10, high_mm=20))
    with pytest.raises(IncompleteError):
        wireprint.make(block, Settings.load(overrides=[NEAR]), region)
    assert wireprint.make(block, Settings.load(), region).figures()["whole"]


class Found:
    """What a certificate measured."""

    within_mm = 4.0
    area_mm2 = 20_000.0

    def __init__(self, *patches):
        self.uncovered = patches


class Bare:
    """A square patch about a place, of so many mm²."""

    def __init__(self, area_mm2, place_mm):
        half = np.sqrt(area_mm2) / 2
        self.area_mm2, self.centroid_mm = area_mm2, place_mm
        self.low_mm = (place_mm[0] - half, place_mm[1] - half, place_mm[2])
        self.high_mm = (place_mm[0] + half, place_mm[1] + half, place_mm[2] + 1)


def test_every_bare_patch_is_listed_whatever_planning_knew():
    planned = [
        ("mid_air", 10.0, 14.0, 480.0, (20.0, 0.0, 14.0)),
        ("wide_roof", 11.0, 12.0, 300.0, (18.0, 2.0, 11.0)),
        ("no_foothold", 50.0, 60.0, 30.0, (0.0, 0.0, 60.0)),
    ]
    found = Found(
        Bare(900.0, (20.0, 0.0, 11.0)), Bare(100.0, (-30.0, 0.0, 5.0)), Bare(99.0, (0, 0, 0))
    )
    listed = unprinted(planned, found, Settings.load())
    assert [(part["reason"], part["area_mm2"]) for part in listed] == [
        ("not_covered", 100.0),
        ("mid_air", 900.0),
        ("no_foothold", 30.0),
    ]
    assert listed[1]["size_mm"] == pytest.approx((30, 30, 1))
    assert listed[2]["size_mm"] is None
    assert all(part["help"] for part in listed)


def test_on_a_small_model_a_hundredth_of_the_surface_is_listed():
    found = Found(Bare(12.0, (0.0, 0.0, 5.0)))
    found.area_mm2 = 1000.0
    assert len(unprinted([], found, Settings.load())) == 1
    found.area_mm2 = 1300.0
    assert unprinted([], found, Settings.load()) == []


def test_supports_are_advised_where_they_are_off():
    [part] = unprinted([("mid_air", 0, 1, 5.0, (0, 0, 1))], None, Settings.load())
    assert "--supports" not in part["help"]
    off = Settings.load(overrides=["wire.supports=none"])
    [part] = unprinted([("mid_air", 0, 1, 5.0, (0, 0, 1))], None, off)
    assert "--supports wire" in part["help"]
