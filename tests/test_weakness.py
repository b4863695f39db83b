"""No reed: what gives way too easily while it is printed is named."""

import json
import math

import pytest

import wireprint
from command import run
from wireprint import Settings, weakness
from wireprint._core import growth
from wireprint.rules import rules_of
from wireprint.weakness import find_weak, limit_mm_n

DIAMETER_MM, MODULUS_MPA = 0.7, 2200.0
BEAM = 3 * MODULUS_MPA * math.pi * DIAMETER_MM**4 / 64


def posts(*heights_mm, apart_mm=5.0):
    """G-code of upright posts in a row, each on a strand that lies on the bed."""
    lines = ["M83", "G1 X0 Y0 Z0.35 F1200"]
    for number, height in enumerate(heights_mm):
        x = number * apart_mm
        lines += [
            f"G1 X{x} Y-5 Z0.35",
            f"G1 X{x} Y0 E1",
            f"G1 Z{0.35 + height} E1",
            f"G1 Z{10 + max(heights_mm)}",
        ]
    return "\n".join(lines).encode()


def compliances(text, settings=None):
    found = growth(text, rules_of(settings or Settings.load()), MODULUS_MPA, 1e12)
    return [compliance for _, _, compliance in found]


def test_a_lone_post_gives_way_as_a_cantilever():
    found = compliances(posts(4, 6, 8))
    assert found == pytest.approx([height**3 / BEAM for height in (4, 6, 8)], rel=1e-9)


def test_a_strand_that_leans_on_another_is_stiffer_for_it():
    lone = posts(6).decode()
    # A second post leans against the first one's peak, and carries what follows.
    braced = lone + "\nG1 X5 Y-5 Z20\nG1 Z0.35\nG1 Y0 E1\nG1 X0 Z6.35 E1\nG1 Z12.35 E1"
    soft = compliances(f"{lone}\nG1 X0 Y0 Z12\nG1 Z6.35\nG1 Z12.35 E1".encode())
    assert compliances(braced.encode())[-1] < soft[-1]


def test_the_limit_follows_from_the_pull_and_the_strand():
    assert limit_mm_n(Settings.load()) == pytest.approx(0.35 / 0.01)
    other = Settings.load(printer="prusa-mk4s", overrides=["wire.pull_n=0.02"])
    assert limit_mm_n(other) == pytest.approx(0.2 / 0.02)


def test_weak_posts_are_told_as_places_the_weakest_first():
    limit = limit_mm_n(Settings.load())
    weak_mm = (limit * BEAM) ** (1 / 3)
    text = posts(0.9 * weak_mm, 1.1 * weak_mm, 1.2 * weak_mm, 0.9 * weak_mm, 1.05 * weak_mm)
    [place] = find_weak(text, Settings.load())
    assert place.posts == 3
    assert place.compliance_mm_n == pytest.approx(limit * 1.2**3)
    assert place.place_mm[:2] == (10.0, 0.0)
    assert "with 2 posts about it" in str(place)
    apart = posts(1.1 * weak_mm, 1.2 * weak_mm, apart_mm=30.0)
    assert [place.place_mm[0] for place in find_weak(apart, Settings.load())] == [30.0, 0.0]


def test_a_stiffer_material_is_less_weak():
    weak_mm = (limit_mm_n(Settings.load()) * BEAM) ** (1 / 3)
    text = posts(1.1 * weak_mm)
    assert find_weak(text, Settings.load())
    assert not find_weak(text, Settings.load(material="pla"))


def test_what_is_too_much_work_is_not_judged(cube, tmp_path, monkeypatch):
    monkeypatch.setattr(weakness, "MOST_WORK", 10.0)
    result = run("slice", cube, "-o", tmp_path / "cube.gcode", "--json")
    figures = json.loads(result.stdout)
    assert figures["weak"] is None
    assert any("was not judged" in text for text in figures["warnings"])


def test_it_is_found_out_where_it_is_asked_for(cube, tmp_path):
    soft = ["--set", "wire.pull_n=0.2"]
    target = tmp_path / "cube.gcode"
    assert "\n  weak " not in run("slice", cube, "-o", target, *soft).stdout
    told = run("slice", cube, "-o", target, "--weak", *soft).stdout
    assert "\n  weak " in told
    figures = json.loads(run("slice", cube, "-o", target, "--json", *soft).stdout)
    worst = figures["weak"][0]
    assert worst["compliance_mm_n"] > worst["limit_mm_n"] == pytest.approx(0.35 / 0.2)
    picture = tmp_path / "cube.png"
    shown = run("view", target, "-o", picture, "--weak", "--size", "320x240")
    assert f"line {worst['line']}" in shown.stdout
    assert picture.read_bytes() != run_plain(target, tmp_path)


def run_plain(target, folder):
    run("view", target, "-o", folder / "plain.png", "--size", "320x240")
    return (folder / "plain.png").read_bytes()


def test_the_library_leaves_it_out_unless_it_is_asked(cube):
    mesh, settings = wireprint.load_mesh(cube), Settings.load()
    assert wireprint.make(mesh, settings).weak is None
    made = wireprint.make(mesh, settings, weak=True)
    assert made.weak == find_weak(made.gcode, settings)
