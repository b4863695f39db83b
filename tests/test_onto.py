"""Prints onto what stands already: continued, beside, on top, around an object; judged as one."""

import json

import numpy as np
import pytest
import trimesh
from click.testing import CliRunner

import random_solids
import wireprint
from wireprint import cli, standing
from wireprint.obstacles import as_gcode
from wireprint.stopped import Stopped, stopped_text

SETTINGS = wireprint.Settings.load()


@pytest.fixture(scope="module")
def body():
    """An octagonal cone that narrows upwards, so slabs differ."""
    return wireprint.as_mesh(trimesh.creation.cone(18, 36, sections=8))


@pytest.fixture(scope="module")
def whole(body):
    return wireprint.make(body, SETTINGS)


def stopped(made, **where):
    text = stopped_text(made.gcode, Stopped(**where), SETTINGS)
    return standing.Standing((("a.gcode", text),), settings=SETTINGS)


def count(text):
    return len(wireprint.check(text, SETTINGS).core.strands)


@pytest.mark.parametrize("share", [0.2, 0.5, 0.8])
def test_a_print_is_continued_onto_its_own_lower_part(body, whole, share):
    height = share * body.size_mm[2]
    before = stopped(whole, z_mm=height)
    rest = wireprint.make(body, SETTINGS, standing=before)
    assert rest.certificate.ok
    assert rest.certificate.fidelity.coverage > 0.95
    assert before.top_mm <= height + 0.01
    # Nothing is printed twice, but for the nozzle's priming.
    assert count(before.text) + rest.wireframe.strand_count <= count(whole.gcode) + 2
    together = wireprint.check(before.text + rest.gcode, SETTINGS)
    assert together.ok


@pytest.mark.parametrize("share", [0.3, 0.55, 0.9])
def test_it_may_be_stopped_at_any_line_after_a_slab(body, whole, share):
    lines = whole.gcode.split(b"\n")
    slabs = [number for number, line in enumerate(lines) if line == b";LAYER_CHANGE"]
    line = slabs[int(share * len(slabs))]
    rest = wireprint.make(body, SETTINGS, standing=stopped(whole, line=line))
    assert rest.certificate.ok


def test_what_stands_whole_leaves_nothing_to_print(body, whole):
    before = standing.Standing((("a.gcode", whole.gcode),), settings=SETTINGS)
    with pytest.raises(wireprint.UnprintableError, match="all of it stands already"):
        wireprint.make(body, SETTINGS, standing=before)


def test_beside_the_last_job(body, whole):
    before = standing.Standing((("a.gcode", whole.gcode),), settings=SETTINGS)
    beside = wireprint.make(body, SETTINGS, standing=before, at_mm=(55, 0, 0))
    assert beside.certificate.ok
    assert beside.certificate.fidelity.coverage > 0.95
    laid = wireprint.check(beside.gcode, SETTINGS).core.strands
    assert laid[..., 0].min() > 30
    travels = beside.toolpath.to[beside.toolpath.kind == 0]
    assert travels[:, 2].max() >= before.top_mm


def test_on_top_of_an_earlier_print():
    box = wireprint.as_mesh(trimesh.creation.box((24, 24, 10)))
    below = wireprint.make(box, SETTINGS)
    top_mm = float(below.certificate.core.strands[..., 2].max())
    before = standing.Standing((("a.gcode", below.gcode),), settings=SETTINGS)
    above = wireprint.make(box, SETTINGS, standing=before, at_mm=(0, 0, top_mm))
    assert above.certificate.ok
    assert wireprint.check(above.gcode, SETTINGS).core.strands[..., 2].min() > top_mm


def test_an_object_is_in_the_way_and_judged_by_nobody(body):
    post = trimesh.creation.cylinder(4, 40)
    post.apply_translation((60, 0, 20))
    mesh = wireprint.as_mesh(post)
    beside = standing.Standing((), as_gcode(mesh, SETTINGS, (60, 0, 0)), SETTINGS)
    assert wireprint.make(body, SETTINGS, standing=beside).certificate.ok
    within = standing.Standing((), as_gcode(mesh, SETTINGS, (14, 0, 0)), SETTINGS)
    with pytest.raises(wireprint.UnprintableError):
        wireprint.make(body, SETTINGS, standing=within)


def test_an_objects_strands_lie_all_over_it():
    box = wireprint.as_mesh(trimesh.creation.box((20, 14, 8)))
    text = as_gcode(box, SETTINGS)
    strands = wireprint.check(b"G28\n" + text, SETTINGS).core.strands
    points, _ = trimesh.sample.sample_surface(trimesh.creation.box((20, 14, 8)), 400, seed=1)
    points += (*SETTINGS.printer.bed.centre_mm, 4)
    start, run = strands[:, 0], strands[:, 1] - strands[:, 0]
    along = np.einsum("psk,sk->ps", points[:, None] - start, run) / (run**2).sum(axis=1)
    nearest = start + np.clip(along, 0, 1)[..., None] * run
    off = np.linalg.norm(points[:, None] - nearest, axis=-1).min(axis=1)
    # Its foot stands on the bed, where no head comes from below.
    assert off[points[:, 2] > 0].max() < SETTINGS.printer.head.nozzle_mm / 2


def test_a_print_is_continued_from_wherever_it_was_stopped(whole):
    """Also where the last strand had come to nothing that holds it."""
    lines = whole.gcode.count(b"\n")
    for line in range(lines // 2, lines // 2 + 40, 3):
        stopped = Stopped(line=line)
        text = stopped_text(whole.gcode, stopped, SETTINGS)
        stands = standing.Standing((("first.gcode", text),), settings=SETTINGS)
        again = wireprint.make(whole.mesh, SETTINGS, standing=stands)
        assert again.certificate.ok, line


@pytest.mark.parametrize(
    ("text", "said"),
    [("soon", "no height"), ("line:1.5", "no height"), ("-3", "no height"), ("", "no height")],
)
def test_where_it_was_stopped_is_a_height_or_a_line(text, said):
    with pytest.raises(wireprint.SettingError, match=said):
        Stopped.read(text)


@pytest.mark.parametrize(
    ("where", "said"), [({"line": 10**6}, "no line"), ({"z_mm": 0.1}, "below")]
)
def test_it_was_not_stopped_where_it_never_was(whole, where, said):
    with pytest.raises(wireprint.SettingError, match=said):
        stopped(whole, **where)


def test_marks_are_not_printed_onto_what_stands(body, whole):
    from wireprint.regions import Region, ZRange

    with pytest.raises(wireprint.SettingError, match="marks cannot"):
        wireprint.make(
            body, SETTINGS, Region().add(ZRange(low_mm=9)), standing=stopped(whole, z_mm=9)
        )


def run(*arguments):
    return CliRunner().invoke(cli.main, [str(argument) for argument in arguments])


def test_the_command_continues_and_checks_both_as_one(cube, tmp_path):
    whole, rest = tmp_path / "whole.gcode", tmp_path / "rest.gcode"
    assert run("slice", cube, "-o", whole).exit_code == 0
    told = run("slice", cube, "-o", rest, "--onto", whole, "--stopped", "15")
    assert told.exit_code == 0, told.output
    judged = run("check", whole, rest, "--stopped", "15")
    assert judged.exit_code == 0, judged.output
    assert "printable as one" in judged.output
    wrong = run("check", whole, rest)
    assert wrong.exit_code == 1
    assert f"{rest}, line " in wrong.output
    figures = json.loads(run("check", whole, rest, "--json").stdout)
    assert figures["onto"] == [str(whole)]


@pytest.mark.parametrize(
    "arguments", [("--stopped", "9"), ("--onto", "{cube}", "--time", "9min", "--at", "3", "3")]
)
def test_what_makes_no_sense_is_a_usage_error(cube, tmp_path, arguments):
    given = [one.format(cube=cube) for one in arguments]
    assert run("slice", cube, "-o", tmp_path / "a.gcode", *given).exit_code == 2


def test_a_start_over_what_stands_neither_probes_nor_homes_into_it(body):
    settings = wireprint.Settings.load("bambu-x1c").but(overrides=["gcode.thumbnails=[]"])
    first = wireprint.make(body, settings)
    before = standing.Standing((("a.gcode", first.gcode),), settings=settings)
    made = wireprint.make(body, settings, standing=before, at_mm=(0.0, 0.0, before.top_mm))
    text = made.gcode.decode()
    start = text[: text.index(";LAYER_CHANGE")]
    assert "\nG28 X Y\n" in start
    assert "\nG29" not in start
    assert "; started without G29, for something stands on the bed" in text
    assert f"G1 Z{before.top_mm + 1:.3f} " in start
    # With the motors off z is lost, and the way home leads into the print.
    off = first.gcode.replace(b"M17 X0.8 Y0.8 Z0.5", b"M84")
    lost = standing.Standing((("a.gcode", off),), settings=settings)
    with pytest.raises(wireprint.UnprintableError, match=r"homes z at \(128, 128\)"):
        wireprint.make(body, settings, standing=lost, at_mm=(0.0, 0.0, before.top_mm))


@pytest.mark.parametrize("share", [0.3, 0.7])
def test_what_was_planned_anew_is_continued_as_it_was(share):
    """A pipe that lies on the bed: slabs that are made lower about what would be bare."""
    vertices, faces = random_solids.solid(995025).mesh()
    pipe = wireprint.as_mesh((vertices, faces))
    whole = wireprint.make(pipe, SETTINGS)
    assert whole.settings.wire.low_slabs_mm
    before = stopped(whole, z_mm=share * pipe.size_mm[2])
    rest = wireprint.make(pipe, SETTINGS, standing=before)
    assert rest.certificate.ok
    assert rest.settings.wire.low_slabs_mm == whole.settings.wire.low_slabs_mm
    assert count(before.text) + rest.wireframe.strand_count <= count(whole.gcode) + 2
