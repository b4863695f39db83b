"""What the command promises of marks: ``--fill``, painted files, projects."""

import json
import subprocess
import sys

import pytest

from command import run
from threemf_files import cube_object, write_3mf
from wireprint.model import load_model
from wireprint.regions import Box, HalfSpace, Mark, Region, Sphere, ZRange, document, grammar
from wireprint.settings import Settings


@pytest.mark.parametrize(
    ("text", "mark"),
    [
        ("z:20..35", Mark(ZRange(low_mm=20, high_mm=35))),
        ("z:20..", Mark(ZRange(low_mm=20))),
        ("z:..-1.5", Mark(ZRange(high_mm=-1.5))),
        ("z:..", Mark(ZRange())),
        ("erase:z:1e1..20", Mark(ZRange(low_mm=10, high_mm=20), erase=True)),
        ("box:0,0,0,1,2,3", Mark(Box(low_mm=(0, 0, 0), high_mm=(1, 2, 3)))),
        ("box:1,0,3,0,2,0", Mark(Box(low_mm=(0, 0, 0), high_mm=(1, 2, 3)))),
        ("sphere: 1, 2, -3, 4", Mark(Sphere(centre_mm=(1, 2, -3), radius_mm=4))),
        ("half:0,0,-2,5", Mark(HalfSpace(normal=(0, 0, -2), offset_mm=5))),
    ],
)
def test_a_mark_is_written_in_a_few_words(text, mark):
    assert grammar.parse(text) == mark


@pytest.mark.parametrize(
    ("text", "complaint"),
    [
        ("cone:1,2,3", "a mark is one of box:X0,Y0,Z0,X1,Y1,Z1, sphere:"),
        ("", "a mark is one of"),
        ("z:20", "write z:LOW..HIGH"),
        ("z:35..20", "low_mm exceeds high_mm"),
        ("z:a..b", "could not convert"),
        ("sphere:1,2,3", "has 3 numbers, not 4; write sphere:X,Y,Z,RADIUS"),
        ("sphere:1,2,3,-4", "greater than 0"),
        ("sphere:1,2,3,inf", "finite"),
        ("box:0,0,0,nan,1,1", "finite"),
        ("half:0,0,0,1", "no direction"),
        ("erase:erase:z:..", "a mark is one of"),
    ],
)
def test_a_mark_that_makes_no_sense_is_a_usage_error(text, complaint, cube_stl, tmp_path):
    result = run("slice", cube_stl, "-o", tmp_path / "x.gcode", "--fill", text)
    assert result.exit_code == 2
    assert f"'--fill': {text}" in result.stderr
    assert complaint in result.stderr
    assert list(tmp_path.iterdir()) == []


def test_a_project_holds_what_the_options_say(cube_stl, tmp_path):
    path, strokes = tmp_path / "x.3mf", tmp_path / "strokes.json"
    region = Region().add(Sphere(centre_mm=(0, 0, 28), radius_mm=9))
    strokes.write_bytes(document.to_json(region))
    options = ["--fill-file", strokes, "--fill", "z:..9", "--fill", "erase:z:..3"]
    result = run("project", cube_stl, "-o", path, *options, "--slab-max", 4, "--material", "pla")
    assert result.exit_code == 0, result.stderr
    assert result.stdout == f"{path}: cube.stl with 3 marks\n"
    model = load_model(path)
    assert model.region == region.add(ZRange(high_mm=9)).erase(ZRange(high_mm=3))
    assert model.settings == Settings.load(material="pla", overrides=["wire.slab_max_mm=4"])
    again = tmp_path / "again.3mf"
    assert run("project", path, "-o", again).exit_code == 0
    assert again.read_bytes() == path.read_bytes()
    assert run("project", path, "-o", again, "--fill", "z:20..", "--slab-max", 5).exit_code == 0
    more = load_model(again)
    assert more.region == model.region.add(ZRange(low_mm=20))
    assert more.settings == model.settings.but(overrides=["wire.slab_max_mm=5"])


def test_a_project_is_sliced_as_model_marks_and_settings_are(cube_stl, tmp_path, monkeypatch):
    monkeypatch.setenv("SOURCE_DATE_EPOCH", "0")
    options = ["--fill", "z:8..16", "--slab-max", 4]
    project, one, other = (tmp_path / name for name in ("x.3mf", "one.gcode", "other.gcode"))
    assert run("project", cube_stl, "-o", project, *options).exit_code == 0
    assert run("slice", cube_stl, "-o", one, *options).exit_code == 0
    result = run("slice", project, "-o", other, "--json")
    assert result.exit_code == 0, result.stderr
    assert other.read_bytes() == one.read_bytes()
    assert json.loads(result.stdout)["regions"]
    options = ["--fill", "erase:z:..", "--slab-max", 6]
    assert run("slice", project, "-o", other, *options).exit_code == 0
    assert run("slice", cube_stl, "-o", one, "--slab-max", 6).exit_code == 0
    assert other.read_bytes() == one.read_bytes()


def test_a_painted_model_is_marked_by_itself_and_marks_others(tmp_path):
    attributes = dict.fromkeys(range(4, 6), 'paint_color="8"')
    painted = write_3mf(tmp_path / "painted.3mf", cube_object(28, attributes=attributes))
    plain = write_3mf(tmp_path / "plain.3mf", cube_object(28))
    one, other = tmp_path / "one.3mf", tmp_path / "other.3mf"
    assert run("project", painted, "-o", one, "--scale", 2, "--up", "x").exit_code == 0
    options = ["--scale", 2, "--up", "x", "--fill-file", painted]
    assert run("project", plain, "-o", other, *options).exit_code == 0
    assert one.read_bytes() == other.read_bytes()
    assert load_model(one).region
    for options in (["--fill-state", 1], ["--fill-file", plain], ["--fill-set", "eyes"]):
        result = run("project", plain, "-o", other, "--fill-file", painted, *options)
        assert result.exit_code == 3, options
        assert str(tmp_path) in result.stderr


def test_a_file_of_marks_that_cannot_be_read_is_named(cube_stl, tmp_path):
    (tmp_path / "strokes.json").write_text('{"marks": [{"shape": {"kind": "cone"}}]}')
    for name, code in (("strokes.json", 4), ("missing.json", 4), ("missing.3mf", 3)):
        result = run("slice", cube_stl, "-o", tmp_path / "x.gcode", "--fill-file", tmp_path / name)
        assert result.exit_code == code
        assert f"wireprint: error: {tmp_path / name}" in result.stderr
    assert not (tmp_path / "x.gcode").exists()


@pytest.mark.parametrize("option", ["--fill-state", "--fill-set"])
def test_paint_is_not_chosen_where_there_can_be_none(option, cube_stl, tmp_path):
    result = run("slice", cube_stl, "-o", tmp_path / "x.gcode", option, "1", "--fill", "z:..")
    assert result.exit_code == 2
    assert f"{option} needs a 3MF file" in result.stderr


def test_a_projects_name_must_say_what_it_is(cube_stl, tmp_path):
    result = run("project", cube_stl, "-o", tmp_path / "x.stl")
    assert result.exit_code == 2
    assert "end the name in .3mf" in result.stderr


def test_nothing_of_marks_is_imported_where_nothing_is_marked(cube_stl, tmp_path):
    code = (
        "import sys\nfrom wireprint.cli import main\n"
        f"try:\n    main(['slice', {str(cube_stl)!r}, '-o', {str(tmp_path / 'x.gcode')!r}, '-q'])\n"
        "except SystemExit as end:\n    assert not end.code\n"
        "names = {'regions', 'threemf', 'model', 'project', 'hybrid'}\n"
        "found = {name.split('.')[1] for name in sys.modules if name.startswith('wireprint.')}\n"
        "sys.exit(repr(sorted(found & names)))"
    )
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=False)
    assert done.stderr.strip() == "[]"
