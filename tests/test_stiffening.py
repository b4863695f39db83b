"""Prints that would give way are made anew, where a forecast is asked for, and only there."""

import json
import math

import numpy as np
import pytest

from command import run
from wireprint import Mesh, Settings, forecast_terms, make, simulate
from wireprint.stiffening import stiffened


def revolved(profile, around=24):
    """A solid of revolution from radii and heights, mm."""
    turns = np.arange(around) * 2 * math.pi / around
    points = [
        (radius * math.cos(a), radius * math.sin(a), z) for radius, z in profile for a in turns
    ]
    points += [(0, 0, profile[0][1]), (0, 0, profile[-1][1])]
    bottom, top = len(points) - 2, len(points) - 1
    faces = []
    for n in range(around):
        after = (n + 1) % around
        last = (len(profile) - 1) * around
        faces += [(bottom, after, n), (top, last + n, last + after)]
        for ring in range(0, last, around):
            a, b = ring + n, ring + after
            faces += [(a, b, b + around), (a, b + around, a + around)]
    return Mesh.from_arrays(np.array(points, float), np.array(faces, np.int64))


@pytest.fixture(scope="module")
def reed():
    """A disc on a slim stem, which gives way as its rim is printed."""
    return revolved([(12, 0), (4, 8), (4, 90), (20, 104), (20, 112)])


@pytest.fixture(scope="module")
def plain(reed):
    return make(reed, Settings.load(), compare=False)


def test_a_print_that_gives_way_is_made_stiffer(reed, plain):
    before = simulate(plain.gcode).rules["meets"]
    assert before.over > 0
    made, forecast, told = stiffened(reed, plain, None, {"compare": False})
    assert told.overrides
    assert told.meets_before_mm == before.worst
    assert told.meets_after_mm == forecast.rules["meets"].worst < 0.9 * before.worst
    assert told.print_time_after_s == made.estimate.total_s
    assert told.enough == (forecast.rules["meets"].over == 0)
    assert made.certificate.ok
    again = make(reed, Settings.load(overrides=told.overrides), compare=False)
    assert again.gcode == made.gcode, "what is told repeats it"


def test_strands_are_fed_as_much_as_is_missing_and_little_more(reed, plain):
    before = simulate(plain.gcode).rules["meets"]
    kept = frozenset({"wire.slab_max_mm", "wire.low_slabs_mm"})
    _, _, told = stiffened(reed, plain, None, {"compare": False}, kept=kept)
    assert [one.partition("=")[0] for one in told.overrides] == ["wire.flow"]
    assert told.enough
    assert told.tried <= 4
    assert before.worst > told.limit_mm >= told.meets_after_mm > 0.7 * told.limit_mm


def test_a_print_that_cannot_be_judged_is_never_taken(reed, plain, monkeypatch):
    first = simulate(plain.gcode)

    monkeypatch.setattr(forecast_terms, "MOST_WORK", 1.0)
    known = {plain.gcode: first}
    monkeypatch.setattr(
        "wireprint.stiffening.simulate",
        lambda gcode, settings, grip_n: known.get(gcode) or simulate(gcode, settings, grip_n),
    )
    made, forecast, told = stiffened(reed, plain, None, {"compare": False})
    assert (made, forecast, told.overrides, told.enough) == (plain, first, (), False)


def test_a_print_that_holds_stays_as_it_is(cube):
    settings = Settings.load()
    made = make(cube, settings, compare=False)
    same, forecast, told = stiffened(made.mesh, made, None, {"compare": False})
    assert same is made
    assert told is None
    assert forecast.rules["meets"].over == 0


def test_what_a_hand_asks_for_is_printed_as_cheaply_as_was_found(cube):
    settings = Settings.load()
    made = make(cube, settings, compare=False)
    bears = simulate(made.gcode, settings, 1.0).grip.bears_n
    weak = stiffened(made.mesh, made, None, {"compare": False}, grip_n=0.9 * bears)
    assert weak[2] is None, "it bears that already"
    strong, forecast, told = stiffened(
        made.mesh, made, None, {"compare": False}, grip_n=1.2 * bears
    )
    assert told.bears_before_n == pytest.approx(bears)
    assert told.bears_after_n > bears
    assert forecast.grip.bears_n == told.bears_after_n
    assert strong.estimate.total_s == told.print_time_after_s


def test_what_no_finger_presses_is_not_said_to_suffice(reed, plain, monkeypatch):
    monkeypatch.setattr(
        "wireprint.stiffening.simulate", lambda gcode, settings, _: simulate(gcode, settings)
    )
    kept = frozenset({"wire.slab_max_mm", "wire.low_slabs_mm"})
    _, forecast, told = stiffened(reed, plain, None, {"compare": False}, grip_n=5, kept=kept)
    assert forecast.rules["meets"].over == 0
    assert told.bears_after_n is None
    assert not told.enough


def test_settings_that_were_named_stay(reed, plain):
    kept = frozenset({"wire.slab_max_mm", "wire.low_slabs_mm", "wire.flow"})
    made, _, told = stiffened(reed, plain, None, {"compare": False}, kept=kept)
    assert made is plain
    assert (told.overrides, told.tried) == ((), 0)


def test_slabs_are_lower_where_that_is_asked_for(reed):
    settings = Settings.load(overrides=["wire.low_slabs_mm=[20, 50, 2]"])
    levels = np.array(make(reed, settings, compare=False).wireframe.levels)
    heights = levels.reshape(len(levels), -1)[:, 0]
    slabs = np.diff(heights)
    inside = (heights[:-1] >= 20) & (heights[1:] <= 50)
    assert inside.sum() >= 14
    assert slabs[inside].max() <= 2 + 1e-6
    assert slabs[~inside].max() > 4


def test_slabs_that_were_low_already_are_told_with_the_rest(reed):
    """A plain print may have got bands of its own; with other strands it would get others."""
    settings = Settings.load(overrides=["wire.low_slabs_mm=[0, 8, 3]"])
    lowered = make(reed, settings, compare=False)
    kept = frozenset({"wire.slab_max_mm", "wire.low_slabs_mm"})
    made, _, told = stiffened(reed, lowered, None, {"compare": False}, kept=kept)
    assert {one.partition("=")[0] for one in told.overrides} >= {"wire.flow", "wire.low_slabs_mm"}
    again = make(reed, Settings.load(overrides=told.overrides), compare=False)
    assert again.gcode == made.gcode


def test_a_plain_slice_is_not_stiffened(tmp_path, cube):
    """Nor does a forecast change a print that holds."""
    paths = [tmp_path / name for name in ("a.gcode", "b.gcode")]
    run("slice", cube, "-o", paths[0], "-q")
    told = json.loads(run("slice", cube, "-o", paths[1], "--json", "--forecast").stdout)
    assert told["stiffened"] is None
    assert paths[0].read_bytes() == paths[1].read_bytes()


def test_a_grip_is_not_promised_without_what_tells_it(monkeypatch, tmp_path, cube):
    monkeypatch.setattr("wireprint.frames.find_spec", lambda name: None)
    result = run("slice", cube, "-o", tmp_path / "c.gcode", "--grip", 5)
    assert result.exit_code != 0
    assert "pip install 'wireprint[grip]'" in result.stderr
    assert not (tmp_path / "c.gcode").exists()


def test_the_command_says_what_was_set_and_what_came_of_it(tmp_path, cube):
    target = tmp_path / "c.gcode"
    words = run("slice", cube, "-o", target, "--grip", 1000).stdout
    assert "prints that were tried" in words or "nothing helps" in words
    told = json.loads(run("slice", cube, "-o", target, "--grip", 1000, "--json").stdout)
    assert not told["stiffened"]["enough"]
    assert told["certified"]
    assert told["stiffened"]["bears_after_n"] >= told["stiffened"]["bears_before_n"]
