"""Hostile and unlucky inputs end as a clear refusal or a right result, with one or two lines."""

import base64
import io
import json
import os
import re
import subprocess
import sys
import zipfile
import zlib

import pytest

from command import run
from wireprint import Settings, examples, load_mesh, write_project
from wireprint.gcode import document, own_settings, sequence
from wireprint.regions import Region
from wireprint.text import one_line

#: The key of the start or end sequence, and what a spiteful or careless author wrote there.
SEQUENCES = [
    ("start", "M104 S{nozzle_c:>3000000000}"),
    ("start", "M104 S{nozzle_c[0]}"),
    ("start", "M104 S{nozzle_c.real}"),
    ("start", "M104 S{nozzle_c!r:>9}"),
    ("start", "M104 S{nozzle_c:{nozzle_c}}"),
    ("start", "M104 S{nozzle_c:.99f}"),
    ("start", "M104 S{park_z_mm}"),
    ("start", "M104 S{}"),
    ("start", "{ M104"),
    ("end", "G1 Z{park_z_mm:n} }"),
    ("end", "G1 Z\x1b[2J"),
    ("end", "G1\x00"),
]


@pytest.fixture(scope="module")
def gcode(tmp_path_factory):
    """A file of ours, which tests damage."""
    folder = tmp_path_factory.mktemp("gcode")
    (folder / "cube.stl").write_bytes(examples.stl("cube"))
    assert run("slice", folder / "cube.stl", "-o", folder / "cube.gcode", "-q").exit_code == 0
    return (folder / "cube.gcode").read_bytes()


def refused(done, exit_code, *words):
    """Check that a command refused in one or two lines that hold certain words."""
    assert done.exit_code == exit_code, (done.output, done.exception)
    assert done.stderr.startswith("wireprint: error: ")
    assert len(done.stderr.splitlines()) <= 2
    assert "unexpected" not in done.stderr
    for word in words:
        assert word in done.stderr, done.stderr


def project(path, cube, **changes):
    """Write a project, with other texts in its settings: ``printer.name`` → text."""
    write_project(path, load_mesh(cube), Settings.load(), Region())
    out = io.BytesIO()
    with zipfile.ZipFile(path) as old, zipfile.ZipFile(out, "w") as new:
        for name in old.namelist():
            content = old.read(name)
            if name.endswith("wireprint.json"):
                saved = json.loads(content)
                for key, value in changes.items():
                    *groups, last = key.split("__")
                    table = saved["settings"]
                    for group in groups:
                        table = table[group]
                    table[last] = value
                content = json.dumps(saved).encode()
            new.writestr(name, content)
    path.write_bytes(out.getvalue())
    return path


@pytest.mark.parametrize(("key", "text"), SEQUENCES)
def test_a_sequence_knows_names_and_a_plain_number_format_only(key, text, cube, tmp_path, gcode):
    toml = tmp_path / "mine.toml"
    toml.write_text(f"[gcode]\n\n{key} = {json.dumps(text)}\n")
    target = tmp_path / "a.gcode"
    done = run("slice", cube, "--load", toml, "-o", target)
    refused(done, 4, "mine.toml:3: " if "\0" not in text else "", f"gcode.{key}: ")
    bad = project(tmp_path / "bad.3mf", cube, **{f"printer__gcode__{key}": text})
    for words in (["slice", bad, "-o", target], ["info", bad]):
        refused(run(*words), 4, f"{bad}: gcode.{key}: ")
    footer = tmp_path / "footer.gcode"
    footer.write_bytes(
        re.sub(
            rf"; printer.gcode.{key} = .*".encode(),
            lambda _: f"; printer.gcode.{key} = {json.dumps(text)}".encode(),
            gcode,
        )
    )
    for words in (["check", footer], ["estimate", footer]):
        refused(run(*words), 3, f"{footer}: ", f"gcode.{key}: ", "--printer")
    assert run("check", footer, "--printer", "kossel-mini").exit_code == 0
    assert not target.exists()


def test_a_sequence_is_filled_in_with_as_many_digits_as_it_says():
    names = {"park_z_mm": 12.3456, "nozzle_c": 240}
    text = "{park_z_mm} {park_z_mm:.1f} {park_z_mm:d} {nozzle_c} {nozzle_c:.1f} {{nozzle_c}} }}{{"
    sequence.check(text, names)
    assert sequence.filled(text, names) == "12.346 12.3 12 240 240.0 {nozzle_c} }{"


@pytest.mark.parametrize("group", ["printer", "material"])
@pytest.mark.parametrize("name", ["a\nM104 S999 ; ", "a\x1b[2Jb", "a\u202eb", "", "a" * 101, "\r"])
def test_a_name_is_one_printable_line_wherever_it_comes_from(group, name, cube, tmp_path, gcode):
    bad = project(tmp_path / "bad.3mf", cube, **{f"{group}__name": name})
    target = tmp_path / "a.gcode"
    refused(run("slice", bad, "-o", target), 4, f"{bad}: {group}.name: ")
    footer = tmp_path / "footer.gcode"
    footer.write_bytes(
        re.sub(
            rf"; {group}.name = .*".encode(),
            lambda _: f"; {group}.name = {json.dumps(name)}".encode(),
            gcode,
        )
    )
    refused(run("check", footer), 3, f"{group}.name: ")
    profile = tmp_path / "mine.toml"
    shown = run("profiles", {"printer": "kossel-mini", "material": "abs"}[group]).stdout
    profile.write_text(re.sub(r"(?m)^name = .*$", lambda _: f"name = {json.dumps(name)}", shown))
    refused(run("slice", cube, f"--{group}", profile, "-o", target), 4, "mine.toml:")
    assert not target.exists()


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("a = " + "[" * 5000, "nested too deep"),
        ("[wire]\npause_s = " + "9" * 5000, "too many digits"),
        ("[wire]\npause_s = 1e999", "wire.pause_s"),
        ("[wire]\npause_s = " + "9" * 400, "wire.pause_s"),
        ("# " + "x" * (1 << 20), "1 MB"),
        ("[wire", "not TOML"),
    ],
)
@pytest.mark.parametrize("option", ["--load", "--printer", "--material"])
def test_a_file_of_settings_that_is_none_is_named(option, text, words, cube, tmp_path):
    toml = tmp_path / "mine.toml"
    toml.write_text(text)
    done = run("slice", cube, option, toml, "-o", tmp_path / "a.gcode")
    refused(done, 4, "mine.toml")
    if option == "--load" or "wire." not in words:
        assert words in done.stderr
    if option == "--load":
        gcode = tmp_path / "b.gcode"
        gcode.write_text("G28\nG1 X1 Y1 Z1 F600\n")
        refused(run("estimate", gcode, "--limits", toml), 4, str(toml))


def test_settings_in_another_encoding_are_refused_by_line_and_a_mark_is_passed_over(cube, tmp_path):
    toml = tmp_path / "mine.toml"
    toml.write_bytes("# a\n# für\n[wire]\n".encode("latin-1"))
    target = tmp_path / "a.gcode"
    refused(run("slice", cube, "--load", toml, "-o", target), 4, f"{toml}:2: not UTF-8")
    toml.write_bytes("\ufeff[wire]\npause_s = 1\n".encode())
    assert run("slice", cube, "--load", toml, "-o", target, "-q").exit_code == 0
    assert own_settings.settings_in(target.read_bytes()).wire.pause_s == 1


@pytest.mark.parametrize(
    "line",
    [
        "; a = " + "[" * 5000,
        "; a = 1\n; a.b = 2",
        "; a = " + "9" * 5000,
        "; a",
        "; wire = 1",
        "\xff",
    ],
)
def test_a_damaged_footer_is_named_by_line_with_a_way_out(line, tmp_path):
    path = tmp_path / "damaged.gcode"
    begin, end = "; wireprint_settings = begin", "; wireprint_settings = end"
    moves = "G28\nG1 X1 Y1 Z.3 F600\nG1 X9 E1"
    path.write_bytes(f"{moves}\n{begin}\n{line}\n{end}\n".encode("latin-1"))
    for command in ("check", "estimate"):
        refused(run(command, path), 3, str(path), "--printer")
        if "wire" not in line:
            assert re.search(r": line [456]: ", run(command, path).stderr)
    # What is neither a comment nor a command is not judged, whoever the printer is.
    judged = run("check", path, "--printer", "kossel-mini")
    assert judged.exit_code == (0 if line.startswith(";") else 1), judged.output
    way_out = ["--printer", "kossel-mini", "--material", "abs"]
    assert run("estimate", path, *way_out).exit_code == 0


def test_a_line_far_from_the_end_is_counted_from_the_begin(tmp_path):
    path = tmp_path / "long.gcode"
    lines = ["G1 X1 Y1 Z1 F600"] * 9000
    path.write_text(
        "\n".join([*lines, "; wireprint_settings = begin", "; a", "; b = 1"])
        + "\n; wireprint_settings = end\n"
    )
    for command in ("check", "estimate"):
        refused(run(command, path), 3, "line 9002: ")


@pytest.mark.parametrize(
    "label", ["<!--<script>", "</script><script>alert(1)", "\u2028&lt;", "$DATA"]
)
def test_no_label_of_a_file_ends_or_swallows_the_pages_own_script(label, tmp_path):
    path = tmp_path / "blank.gcode"
    path.write_text(f"G28\nG1 X0 Y0 Z0.3 F1000\n;TYPE:{label}\nG1 X10 E1\nG1 X20 E1\n")
    page = tmp_path / "blank.html"
    assert run("view", path, "-o", page).exit_code == 0
    text = page.read_text()
    [data] = re.findall(r'<script type="text/plain" id="data">([A-Za-z0-9+/=]*)</script>', text)
    told = zlib.decompress(base64.b64decode(data))
    name = one_line(label.lower())
    assert any(json.dumps(name, ensure_ascii=ascii_).encode() in told for ascii_ in (True, False))
    assert text.count("<script") == text.count("</script") == 3


#: A name of a file that ends lines, drives terminals, turns the direction of writing, is no UTF-8
#: and means something to rich; and one that means something to spreadsheets.
ODD_NAMES = [b"[red]\x1b[2J\n\r\xe2\x80\xaecaf\xe9\x85[", b"=-@cmd()"]


@pytest.mark.parametrize("name", ODD_NAMES)
def test_an_odd_name_is_one_line_everywhere(name, tmp_path, gcode):
    model = os.path.join(os.fsencode(tmp_path), name + b".stl")
    target = os.path.join(os.fsencode(tmp_path), name + b".gcode")
    absent = os.fsencode(tmp_path / "absent.stl")
    with open(model, "wb") as file:
        file.write(examples.stl("cube"))
    with open(target, "wb") as file:
        file.write(gcode)
    words = [
        ["slice", model, "-o", target],
        ["slice", model, absent, "-o", os.fsencode(tmp_path) + b"/out/"],
        ["info", model],
        ["check", target],
        ["estimate", target],
        ["compare", model, "--condition", "wireprint", "-o", target + b".chart.png"],
        ["view", target],
        ["project", model, "-o", target + b".3mf"],
        ["bench", model, "--no-compare", "--jobs", "1", "-o", target + b".csv"],
    ]
    for command in words:
        done = subprocess.run(
            [sys.executable, "-m", "wireprint", *command],
            capture_output=True,
            check=False,
        )
        assert done.returncode == (3 if absent in command else 0), done
        for text in (done.stdout, done.stderr):
            assert all(line.isprintable() for line in text.decode().split("\n")), text
        assert b"Traceback" not in done.stderr
        most = 2 if command[0] in ("slice", "view", "project", "info") else 12
        assert sum(line.startswith(b" ") is False for line in done.stdout.splitlines()) <= most


def test_closed_streams_are_done_without(cube):
    """Nothing that is said lands in the file that is opened in a closed stream's place."""
    line = f"{sys.executable} -m wireprint slice cube.stl bad.stl -o out/"
    for closed in ("0<&-", ">&-", "2>&-", "0<&- >&- 2>&-"):
        (cube.parent / "bad.stl").write_bytes(b"bad")
        done = subprocess.run(f"{line} {closed}", shell=True, cwd=cube.parent, capture_output=True)
        assert done.returncode == 3, done
        assert b"Traceback" not in done.stderr
        text = (cube.parent / "out" / "cube.gcode").read_bytes()
        assert text.startswith(b"; generated by wireprint")
        assert b"error" not in text


def test_a_reader_that_goes_away_and_a_full_disk_end_the_command_without_a_traceback(cube):
    line = f"{sys.executable} -m wireprint"
    shell = {"shell": True, "cwd": cube.parent, "capture_output": True, "executable": "/bin/bash"}
    for command in ("profiles kossel-mini", "slice cube.stl -o -", "slice cube.stl -o a.gcode"):
        done = subprocess.run(f"{line} {command} | true; exit ${{PIPESTATUS[0]}}", **shell)
        assert done.returncode in (0, 141), done
        assert b"Traceback" not in done.stderr
        assert b"Exception" not in done.stderr
    for command in ("profiles kossel-mini", "slice cube.stl -o -", "slice cube.stl -o /dev/full"):
        done = subprocess.run(f"{line} {command} > /dev/full", **shell)
        assert done.returncode == 2, done
        assert b"No space left on device" in done.stderr
        assert len(done.stderr.splitlines()) <= 8


@pytest.mark.parametrize("seconds", [4e11, -1e11, 2**40])
def test_a_date_that_no_calendar_has_is_left_out(seconds, cube, monkeypatch):
    stat = type("Stat", (), {"st_mtime": seconds})()
    fake = type("File", (), {"stat": lambda self: stat})()
    assert document.dated(fake).year >= 1970 or seconds < 0
    document.header(Settings.load(), document.dated(fake))


def test_no_row_of_the_table_of_hostile_inputs_is_a_fault(shared, cube, tmp_path):
    hostile = shared / "faults" / "hostile"
    target = tmp_path / "a.gcode"
    for name in ("bomb_format", "index_format", "deep", "bigint"):
        refused(run("slice", cube, "--load", hostile / f"{name}.toml", "-o", target), 4, name)
    done = run("slice", cube, "--load", hostile / "park_format.toml", "-o", target)
    assert done.exit_code == 0
    for name in ("bomb", "park", "inject"):
        refused(run("slice", hostile / f"{name}_project.3mf", "-o", target), 4, name)
    for name in ("footer_deep", "footer_typeerror", "footer_bigint", "bomb_footer"):
        for command in ("check", "estimate"):
            refused(run(command, hostile / f"{name}.gcode"), 3, name)
    refused(run("bench", hostile / "nul_manifest.csv", "-o", tmp_path / "r.csv"), 3, "csv:2: ")
    short = tmp_path / "short_row.csv"
    short.write_bytes((hostile / "short_row.csv").read_bytes())
    refused(run("bench", cube, "-o", short), 4, "short_row.csv:2: ")
    journal = tmp_path / "X.csv.journal"
    journal.write_bytes((hostile / "bad_journal.txt").read_bytes())
    refused(run("bench", cube, "-o", tmp_path / "X.csv"), 4, "X.csv.journal:1: ")
    assert run("view", hostile / "blank_page.gcode", "-o", tmp_path / "b.html").exit_code == 0


@pytest.mark.parametrize(
    "words",
    [
        ["slice", "", "-o", "a.gcode"],
        ["slice", "CUBE", "-o", ""],
        ["slice", "CUBE", "-o", "a.gcode", "--printer", ""],
        ["slice", "CUBE", "-o", "a.gcode", "--material", ""],
        ["slice", "CUBE", "-o", "a.gcode", "--load", ""],
        ["info", ""],
        ["check", ""],
        ["view", "CUBE", "-o", ""],
    ],
)
def test_an_empty_name_is_no_name(words, cube, monkeypatch):
    """A variable of the shell that is not set must not choose a folder, or a default."""
    monkeypatch.chdir(cube.parent)
    done = run(*[str(cube) if word == "CUBE" else word for word in words])
    refused(done, 2, "empty")
    assert [path.name for path in cube.parent.iterdir()] == [cube.name]


@pytest.mark.skipif(not os.path.isdir("/proc/self"), reason="there is no /proc")
def test_a_folder_that_takes_no_files_is_named_with_the_systems_words(cube):
    refused(run("slice", cube, "-o", "/proc/a.gcode"), 2, "/proc/a.gcode: No such file")


def test_a_folder_in_place_of_a_profile_is_named_as_one(cube, tmp_path):
    (tmp_path / "mine.toml").mkdir()
    done = run("slice", cube, "-o", tmp_path / "a.gcode", "--printer", tmp_path / "mine.toml")
    refused(done, 4, "mine.toml: this is a folder")


def test_a_page_of_gcode_whose_settings_are_damaged_shows_strands_in_their_order(gcode, tmp_path):
    path, page = tmp_path / "damaged.gcode", tmp_path / "damaged.html"
    path.write_bytes(gcode.replace(b"; wire.pause_s = ", b"; wire.pause_s = x"))
    done = run("view", path, "-o", page)
    assert done.exit_code == 0, done.stderr
    assert re.search(r"damaged\.gcode: line \d+: .* without times", done.stderr)
    assert page.read_text().startswith("<!")
