"""Damaged and hostile files of other programs: an error that names file, line and key."""

import json

import pytest

import printer_files as files
from command import run
from wireprint import examples
from wireprint._core import SettingError
from wireprint.importing import imported
from wireprint.importing.expressions import Missing, Ours, Unknown, evaluated
from wireprint.importing.placeholders import resolved


def written(folder, name, content):
    path = folder / name
    path.write_bytes(content if isinstance(content, bytes) else content.encode())
    return path


BROKEN = {
    "a.cfg": (
        "[printer]\nkinematics: corexy\nmax_velocity: fast\n",
        r"a\.cfg:3, max_velocity: 'fast'",
    ),
    "b.cfg": ("[printer]\nkinematics: polar\n", r"b\.cfg:2, kinematics: 'polar' is none of cart"),
    "c.cfg": (
        "[printer]\nkinematics: delta\nmax_velocity: 1\n",
        r"\[printer\] has no delta_radius",
    ),
    "d.cfg": ("[include d.cfg]\n", r"d\.cfg:1: files include each other .*: d\.cfg → d\.cfg"),
    "e.cfg": ("[printer]\nwhat is this\n", r"e\.cfg:2: 'what is this' is no section"),
    "f.cfg": ("[mcu]\nserial: x\n", r"f\.cfg: no \[printer\] with kinematics"),
    "g.cfg": (b"[printer]\n\0\0\0", r"g\.cfg:2: it holds zeros"),
    "h.cfg": ("", r"h\.cfg: no \[printer\]"),
    "i.cfg": (
        "[printer]\nkinematics: cartesian\n[stepper_x]\nposition_max: nan\n",
        r"i\.cfg:4, position_max: 'nan' is no number",
    ),
    "a.ini": (
        files.ini(files.SLIC3R, bed_shape="0x0,a"),
        r"a\.ini:\d+, bed_shape: '0x0,a' is no out",
    ),
    "b.ini": (
        files.ini(files.SLIC3R, gcode_flavor="mach3"),
        r"gcode_flavor: 'mach3' is no firmware",
    ),
    "c.ini": ("no entry at all\n", r"c\.ini:1: 'no entry at all' is no entry"),
    "d.ini": ("layer_height = 0.2\n", r"d\.ini: nothing in it describes a printer"),
    "e.ini": (
        "[presets]\nprinter = A\n[printer:A]\ninherits = B\n[printer:B]\ninherits = A\nx = 0\n",
        r"e\.ini:\d, inherits: presets inherit in a circle: A → B → A",
    ),
    "f.ini": ("[printer:A]\ninherits = *x*\nbed_shape = 1\n", r"f\.ini:2, inherits: no printer is"),
    "g.ini": (
        files.ini(files.SLIC3R, nozzle_diameter="1e999"),
        r"nozzle_diameter: '1e999' is no num",
    ),
    "a.json": ("{", r"a\.json:1: not JSON"),
    "b.json": ("[" * 100_000, r"b\.json: not settings: nested too deep"),
    "c.json": (
        '{\n"inherits": "c"}',
        r"c\.json:2, inherits: profiles inherit in a circle: c\.json →",
    ),
    "d.json": ('{\n\n"inherits": "x"}', r"d\.json:3, inherits: 'x' is not in the folder"),
    "e.json": ('{"inherits": "../../etc/passwd"}', r"is not in the folder"),
    "f.json": ("[1]", r"f\.json: not settings: no object, but a list"),
    "g.json": ('{"name": ' + "9" * 10_000 + "}", r"g\.json: not settings"),
    "a.def.json": ('{"inherits": "a"}', r"a\.def\.json, inherits: definitions inherit in a circle"),
    "b.def.json": ('{"inherits": "../b"}', r"b\.def\.json, inherits: .*put it there"),
    "c.def.json": ('{"overrides": {}}', r"nothing in it describes a machine"),
    "a.inst.cfg": ("nothing\n", r"a\.inst\.cfg:1: no settings of Cura"),
    "a.gcode": ("G28\nG1 X1\n", r"a\.gcode: no slicer left its settings"),
    "b.gcode": ("; x = 1\n" * 3, r"b\.gcode: no slicer left its settings"),
    "a.3mf": (b"PK\x03\x04nonsense", r"a\.3mf: a damaged zip archive"),
    "a.txt": ("hello", r"a\.txt: no slicer left its settings"),
}


@pytest.mark.parametrize("name", BROKEN)
def test_what_is_wrong_is_told_with_its_place(tmp_path, name):
    content, message = BROKEN[name]
    with pytest.raises(SettingError, match=message):
        imported([written(tmp_path, name, content)], hotend="v6")


def test_a_file_that_is_not_there_is_told():
    with pytest.raises(SettingError, match=r"nowhere\.cfg: No such file"):
        imported(["nowhere.cfg"], hotend="v6")


@pytest.mark.parametrize("name", ["big.cfg", "big.ini", "big.json"])
def test_a_file_that_is_too_large_is_not_read(tmp_path, name):
    path = tmp_path / name
    with path.open("wb") as file:
        file.truncate(40 << 20)
    with pytest.raises(SettingError, match="more than 16 MB"):
        imported([path], hotend="v6")


def test_includes_that_multiply_are_stopped(tmp_path):
    for level in range(12):
        text = (
            f"[include {level + 1}.cfg]\n" * 4 if level < 11 else "[printer]\nkinematics: corexy\n"
        )
        written(tmp_path, f"{level}.cfg", text)
    with pytest.raises(SettingError, match="more than 200 files"):
        imported([tmp_path / "0.cfg"], hotend="v6")


def test_an_include_that_leads_nowhere_is_told_and_done_without(tmp_path):
    path = written(tmp_path, "printer.cfg", files.KLIPPER)
    found = imported([path], hotend="v6")
    assert any("nothing is called macros.cfg" in remark for remark in found.remarks)


@pytest.mark.parametrize("name", ["a\nM104 S300", "a\x1b[2J", "x" * 1000, '"""\nG1 X9999'])
def test_a_name_adds_nothing_to_gcode_or_profile(tmp_path, name):
    table = files.orca_config() | {"printer_model": name, "filament_type": [name]}
    start = "M117 {filament_type[0]}\nG28\nM140 S[bed_temperature]\n;{filament_type[0]}"
    path = written(tmp_path, "a.json", json.dumps(table | {"machine_start_gcode": start}))
    found = imported([path], hotend="v6")
    assert found.values["name"].isprintable()
    assert len(found.values["name"]) <= 100
    assert "S300" not in found.values["gcode"]["start"]
    assert "X9999" not in found.values["gcode"]["start"]


def test_a_value_of_the_file_cannot_break_out_of_its_line():
    evil = {"kind": "PLA\nG1 Z-10", "ok": "PETG"}
    lines, unknown = resolved("; {kind}\nM117 {kind}\nM117 {ok}", lambda name, _: evil[name], ())
    assert lines == ["M117 PETG"]
    assert len(unknown) == 2


def lookup(name, index):
    values = {"a": 3.0, "text": "PLA", "nozzle": Ours("nozzle_c", 215.0)}
    if name not in values:
        raise Unknown(name)
    return values[name]


@pytest.mark.parametrize(
    ("text", "value"),
    [
        ("1 + 2 * 3", 7),
        ("(1 + 2) * 3", 9),
        ("-a + 10 % 4", -1),
        ('a > 2 and text == "PLA"', True),
        ("a > 2 ? 5 : missing", 5),
        ("is_nil(missing) ? 150 : missing", 150),
        ("!(a == 3) || false", False),
        ("max(1, a, 2) - min(4, 2)", 1),
        ("int(a / 2) + round(2.6)", 4),
        ("text =~ /.*(ABS|PLA).*/", True),
        ("text !~ /PETG/", True),
        ("nozzle[0] - 15", 200),
        ('"" + (a > 2 ? 1 : 0)', "1"),
    ],
)
def test_expressions_are_what_they_are_in_slicers(text, value):
    assert evaluated(text, lookup) == value


@pytest.mark.parametrize(
    "text",
    [
        "",
        "1 +",
        "(" * 5000,
        "a / 0",
        "9" * 400 + " * " + "9" * 400,
        "text - 1",
        "a b",
        "'x'",
        "max()",
        "text =~ /(a+)+$/",
        "__import__(1)",
        "1 ? 2",
        "?" * 100,
        "{",
        "a[1e308 * 10]",
    ],
)
def test_what_is_no_expression_is_unknown(text):
    with pytest.raises(Unknown):
        evaluated(text, lookup)


def test_a_name_that_nobody_knows_is_missed_only_where_it_is_asked_for():
    assert evaluated("missing", lookup) == Missing("missing")
    assert resolved("M104 S{missing}", lookup, ()) == ([], ["M104 S{missing}"])


def test_a_long_sequence_with_open_branches_and_braces_comes_to_its_end():
    text = "{if a > 1}" * 2000 + "G28\n" + "{" * 2000 + "\n" + "G1 X{a}\n" * 20000
    lines, _ = resolved(text, lookup, ())
    assert lines[0] == "G28"


def test_the_command_writes_a_profile_that_slices(tmp_path):
    cfg = written(tmp_path, "printer.cfg", files.KLIPPER)
    mine = tmp_path / "mine.toml"
    told = run("profiles", "import", str(cfg), "-o", str(mine), "--hotend", "v6", "--name", "Mine")
    assert told.exit_code == 0, told.output
    assert "a 28 mm cube is certified" in told.output
    model = written(tmp_path, "cube.stl", examples.stl("cube"))
    out = tmp_path / "cube.gcode"
    done = run("slice", str(model), "-o", str(out), "--printer", str(mine), "--material", "pla")
    assert done.exit_code == 0, done.output
    assert b"printer_settings_id = Mine" in out.read_bytes()


def test_the_command_writes_nothing_where_it_fails(tmp_path):
    cfg = written(tmp_path, "printer.cfg", files.KLIPPER)
    mine = tmp_path / "mine.toml"
    told = run("profiles", "import", str(cfg), "-o", str(mine))
    assert told.exit_code == 4
    assert "--hotend" in told.output
    assert not mine.exists()
    told = run("profiles", "import", str(cfg), "-o", str(cfg), "--hotend", "v6")
    assert told.exit_code == 2
    assert cfg.read_text() == files.KLIPPER


def test_a_file_that_says_what_the_printer_is_is_not_written_over(tmp_path):
    theirs = written(tmp_path, "theirs.gcode", files.block(files.SLIC3R))
    model = written(tmp_path, "cube.stl", examples.stl("cube"))
    before = theirs.read_bytes()
    done = run("slice", str(model), "-o", str(theirs), "--printer", f"{theirs}#v6")
    assert done.exit_code == 2
    assert theirs.read_bytes() == before
    out = tmp_path / "cube.gcode"
    done = run(
        "slice", str(model), "-o", str(out), "--printer", f"{theirs}#v6", "--material", "pla"
    )
    assert done.exit_code == 0, done.output
    assert run("estimate", str(out), "--limits", str(theirs), "--firmware", "marlin").exit_code == 0
