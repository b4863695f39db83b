"""A print that would break its own rules loses the strands that do, and they are named."""

import json

import numpy as np
import pytest

import wireprint
from command import run
from wireprint import KINDS, Settings, pipeline, stages
from wireprint.cascade import falling
from wireprint.certificate import check
from wireprint.gcode import document
from wireprint.mending import _blamed, _faulty, mended
from wireprint.pipeline import make
from wireprint.regions import Region, ZRange

#: Caps of a cube of 28 mm span 28 mm; its contours go from post to post.
STRICT, LOOSE = ["wire.span_limit_mm=24"], ["wire.span_limit_mm=40"]


@pytest.fixture
def careless(monkeypatch):
    """A planner that believes in longer spans than its certificate."""
    loose = Settings.load(overrides=LOOSE)
    monkeypatch.setattr(pipeline, "wireframe", lambda mesh, _: stages.wireframe(mesh, loose))


def test_what_breaks_the_rules_is_left_out_and_named(cube, careless):
    mesh = wireprint.load_mesh(cube)
    made = make(mesh, Settings.load(overrides=STRICT), partial=True)
    assert made.certificate.ok
    whole = make(mesh, Settings.load(overrides=LOOSE), partial=True)
    assert 0 < whole.wireframe.strand_count - made.wireframe.strand_count < 40
    named = [part for part in made.unprinted() if part["reason"] == "breaks_rules"]
    assert named
    assert all(part["help"] for part in named)


def test_too_much_left_out_is_not_written(cube, careless, tmp_path):
    target = tmp_path / "cube.gcode"
    strict = [word for one in STRICT for word in ("--set", one)]
    done = run("slice", cube, "-o", target, *strict, "--set", "wire.coverage_min=1")
    assert done.exit_code == 5
    assert "breaks rules" in done.stderr
    assert not target.exists()
    told = json.loads(run("slice", cube, "-o", target, *strict, "--force", "--json").stdout)
    assert told["certified"]
    assert any(part["reason"] == "breaks_rules" for part in told["unprinted"])


def test_a_mark_on_a_mended_print_gives_what_it_gives_without_one(cube, careless):
    mesh, settings = wireprint.load_mesh(cube), Settings.load(overrides=STRICT)
    mended_first = make(mesh, settings, partial=True)
    assert mended_first.wireframe.strand_count < mended_first.sketch.plain.strand_count
    mark = Region().add(ZRange(low_mm=8.0, high_mm=16.0))
    fresh = make(mesh, settings, mark, partial=True)
    kept = make(mesh, settings, mark, partial=True, kept=mended_first.sketch)
    assert kept.gcode == fresh.gcode
    again = make(mesh, settings, partial=True, kept=kept.sketch)
    assert again.gcode == mended_first.gcode


def test_what_hangs_on_what_is_left_out_goes_with_it(cube):
    settings = Settings.load()
    strands = stages.wireframe(wireprint.load_mesh(cube), settings)
    # Without its posts a slab has nothing that the ones above could stand on.
    kinds, post = strands.strand_kinds, KINDS.index("post")
    posts = [n for n, slab in enumerate(strands.strand_slabs) if slab == 1 and kinds[n] == post]
    broken = strands.without(posts, settings.printer.head.nozzle_mm)
    certificate = check(written(broken, settings), settings)
    assert certificate.floating_starts
    left = mended(broken, certificate, settings)
    assert check(written(left, settings), settings).ok
    assert left.strand_count < broken.strand_count
    assert left.post_count < broken.post_count


def test_what_falls_is_told_from_the_strands_around_as_from_the_whole_print(cube):
    settings = Settings.load()
    strands = stages.wireframe(wireprint.load_mesh(cube, scale=3), settings)
    posts = np.flatnonzero(strands.strand_kinds == KINDS.index("post"))
    dropped = posts[len(posts) // 2 :][:1].tolist()
    centre = stages.origin_mm(settings, (0.0, 0.0, 0.0))

    def to_blame(piece):
        return _blamed(piece, check(written(piece, settings), settings), centre)

    whole = dropped
    while True:
        left = strands.beyond(whole)
        numbers = np.setdiff1d(np.arange(strands.strand_count), whole)
        fresh = [int(numbers[one]) for found in to_blame(left).values() for one in found]
        if not fresh:
            break
        whole = sorted({*whole, *fresh})
    alone, rounds = falling(strands, dropped, settings.strand_mm, to_blame, 100)
    assert alone == whole
    assert rounds > 0


@pytest.mark.parametrize("away", [True, False])
def test_all_that_nothing_holds_at_one_end_is_to_blame_at_once(away):
    # A line that leaves the wall below it behind at 10 mm, or comes to it from the air.
    steps = list(range(21) if away else range(20, -1, -1))
    lines = ["G28", "M109 S230", "G92 E0", "M83", "G0 X0 Y0 Z0.3 F3000", "G1 X10 E1 F600"]
    lines += [f"G0 X{steps[0]} Z0.8", *(f"G1 X{x} E0.3" for x in steps[1:]), ""]
    certificate = check("\n".join(lines).encode(), "kossel-mini")
    (stretch,) = _faulty(certificate, (0.0, 0.0, 0.0))
    assert sorted(min(ends[:, 0]) for ends in stretch) == list(range(10, 20))


def test_a_print_that_leaves_the_bed_is_not_mended(cube):
    settings = Settings.load()
    mesh = wireprint.load_mesh(cube, scale=8)
    strands = stages.wireframe(mesh, settings)
    certificate = check(written(strands, settings), settings)
    assert certificate.out_of_bounds
    assert mended(strands, certificate, settings) is None


def written(strands, settings):
    path = stages.toolpath(strands, settings)
    return document.body(path, settings, document.dated(None))
