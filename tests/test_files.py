"""Where output goes: never over what is read, whole or not at all."""

import os
import stat
import subprocess
import sys
import threading

import pytest

from command import run
from wireprint import _aside, examples, files
from wireprint.files import OutputError, output, written_whole


@pytest.fixture
def model(cube):
    return cube


@pytest.fixture
def gcode(cube):
    path = cube.with_suffix(".gcode")
    assert run("slice", cube, "-o", path, "-q").exit_code == 0
    return path


def names_of(path, folder):
    """Other names of a file: a link, a hard link, one through a link to its folder."""
    (folder / "link").symlink_to(path)
    os.link(path, folder / "hard")
    (folder / "way").symlink_to(path.parent)
    return [path, folder / "link", folder / "hard", folder / "way" / path.name]


#: For each command that writes: its words, with what is read and what is written as names.
WRITERS = {
    "slice": ["slice", "{model}", "-o", "{out}"],
    "slice --load": ["slice", "{model}", "--load", "{toml}", "-o", "{out}"],
    "compare": ["compare", "{model}", "-o", "{out}", "--condition", "wireprint"],
    "check --picture": ["check", "{gcode}", "--picture", "{out}"],
    "check --model": ["check", "{gcode}", "--model", "{model}", "--picture", "{out}"],
    "view": ["view", "{gcode}", "-o", "{out}"],
    "project": ["project", "{model}", "-o", "{out}"],
    "bench": ["bench", "{model}", "--no-compare", "-o", "{out}"],
}


@pytest.mark.parametrize("words", WRITERS.values(), ids=WRITERS)
def test_no_command_writes_over_what_it_reads_under_whatever_name(words, gcode, model, tmp_path):
    toml = tmp_path / "mine.toml"
    toml.write_text("[wire]\npause_s = 1\n")
    inputs = {"model": model, "gcode": gcode, "toml": toml}
    read = [inputs[word[1:-1]] for word in words if word[1:-1] in inputs]
    for number, path in enumerate(read):
        before = path.read_bytes()
        folder = tmp_path / f"names{number}"
        folder.mkdir()
        for name in names_of(path, folder):
            # A name that would do as output: only that the file is the same can refuse it.
            for suffix in (".gcode", ".png", ".3mf", ".csv"):
                target = folder / f"out{suffix}"
                target.unlink(missing_ok=True)
                target.symlink_to(name)
                done = run(*(word.format(**inputs, out=target) for word in words))
                assert done.exit_code == 2, done.output
                assert len(done.stderr.splitlines()) == 1
            done = run(*(word.format(**inputs, out=name) for word in words))
            assert done.exit_code == 2
        assert path.read_bytes() == before


def test_a_library_call_does_not_draw_over_what_it_draws(gcode):
    from wireprint.view import render_html, render_png

    before = gcode.read_bytes()
    for render in (render_png, render_html):
        with pytest.raises(OutputError, match="which is read"):
            render(gcode, gcode)
    assert gcode.read_bytes() == before


@pytest.mark.parametrize(
    ("words", "usual"),
    [
        (["slice", "{model}", "-o"], ".gcode, .gco, .g, .nc or .ngc"),
        (["compare", "{model}", "-o"], ".png"),
        (["check", "{gcode}", "--picture"], ".png"),
        (["view", "{gcode}", "-o"], ".png or .html"),
        (["project", "{model}", "-o"], ".3mf"),
        (["bench", "{model}", "-o"], ".csv or .parquet"),
        (["example", "cube", "-o"], ".stl"),
    ],
)
@pytest.mark.parametrize("name", ["precious.py", "precious.obj", "precious"])
def test_a_name_that_does_not_end_as_output_is_refused_with_the_usual_ends(
    words, usual, name, gcode, model, tmp_path
):
    target = tmp_path / name
    target.write_text("precious")
    done = run(*(word.format(model=model, gcode=gcode) for word in words), target)
    assert done.exit_code == 2
    assert f"end the name in {usual}" in done.stderr
    assert target.read_text() == "precious"


def test_a_slash_makes_a_folder_and_the_file_gets_its_usual_name(gcode, model, tmp_path):
    for words, name in [
        (["slice", model], "cube.gcode"),
        (["view", gcode], "cube.png"),
        (["compare", model, "--condition", "wireprint"], "cube.png"),
        (["project", model], "cube.3mf"),
        (["example", "arch"], "arch.stl"),
        (["bench", model, "--no-compare", "--jobs", 1], "results.csv"),
    ]:
        folder = tmp_path / words[0]
        done = run(*words, "-o", f"{folder}/")
        assert done.exit_code == 0, done.output
        assert [path.name for path in folder.iterdir()] == [name]


def test_a_folder_is_not_made_where_nothing_is_written(tmp_path):
    assert run("slice", tmp_path / "none.stl", "-o", f"{tmp_path}/out/").exit_code == 3
    assert list(tmp_path.iterdir()) == []


def test_a_folder_that_is_not_there_is_named_before_any_work(model, tmp_path):
    done = run("slice", model, "-o", tmp_path / "none" / "a.gcode")
    assert done.exit_code == 2
    assert f"there is no folder {tmp_path / 'none'}" in done.stderr


def test_a_link_is_followed_and_stays_a_link(tmp_path):
    (tmp_path / "far").mkdir()
    real, link = tmp_path / "far" / "real.gcode", tmp_path / "link.gcode"
    link.symlink_to(real)
    written_whole(link, b"first")
    written_whole(link, b"second")
    assert link.is_symlink()
    assert real.read_bytes() == b"second"
    assert [path.name for path in real.parent.iterdir()] == ["real.gcode"]


def test_a_link_to_what_is_no_output_is_refused(model, tmp_path):
    other, link = tmp_path / "other.stl", tmp_path / "link.gcode"
    other.write_bytes(b"a model")
    link.symlink_to(other)
    done = run("slice", model, "-o", link)
    assert done.exit_code == 2
    assert f"it leads to {other}, and .stl is not what is written here" in done.stderr
    assert other.read_bytes() == b"a model"


def test_links_that_lead_in_a_circle_are_refused(tmp_path):
    (tmp_path / "a").symlink_to(tmp_path / "b")
    (tmp_path / "b").symlink_to(tmp_path / "a")
    with pytest.raises(OutputError, match="symbolic links"):
        written_whole(tmp_path / "a", b"x")
    assert (tmp_path / "a").is_symlink()


def test_a_pipe_is_written_to_and_stays_a_pipe(model, tmp_path):
    pipe = tmp_path / "pipe"
    os.mkfifo(pipe)
    got = []
    reader = threading.Thread(target=lambda: got.append(pipe.read_bytes()))
    reader.start()
    assert run("slice", model, "-q", "-o", pipe).exit_code == 0
    reader.join()
    assert got[0].startswith(b"; generated by wireprint")
    assert stat.S_ISFIFO(pipe.stat().st_mode)


@pytest.mark.skipif(os.geteuid() != 0, reason="only root makes devices")
def test_a_device_is_written_to_and_stays_a_device(model, tmp_path):
    device = tmp_path / "null"
    try:
        os.mknod(device, 0o666 | stat.S_IFCHR, os.makedev(1, 3))
        device.write_bytes(b"")
    except PermissionError:
        pytest.skip("devices are forbidden here")
    assert run("slice", model, "-q", "-o", device).exit_code == 0
    assert stat.S_ISCHR(device.stat().st_mode)


def shell(command, folder, **options):
    """Run a shell's command line, in which $W is the command."""
    environment = os.environ | {"W": f"{sys.executable} -m wireprint", "SOURCE_DATE_EPOCH": "0"}
    how = {"cwd": folder, "env": environment, "capture_output": True, **options}
    return subprocess.run(command, shell=True, check=False, **how)


def test_descriptors_are_written_to_where_they_stand(model):
    done = shell("(echo before; $W slice cube.stl -q -o /dev/stdout) >> all.txt", model.parent)
    assert done.returncode == 0, done.stderr
    text = (model.parent / "all.txt").read_bytes()
    assert text.startswith(b"before\n; generated by wireprint")


def test_stdin_and_stdout_take_the_place_of_files(gcode, model):
    folder = model.parent
    plain = shell("$W slice cube.stl -o - -q", folder).stdout
    assert plain.startswith(b"; generated by wireprint")
    for line in (
        "cat cube.stl | $W slice - --format stl -o - -q",
        "$W slice - --format STL -o - -q < cube.stl",
        "$W slice /dev/stdin --format stl -o /dev/stdout -q < cube.stl",
    ):
        assert shell(line, folder).stdout == plain
    for line, begin in [
        ("cat cube.gcode | $W view - -o -", b"\x89PNG"),
        ("cat cube.stl | $W view - --format stl -o -", b"\x89PNG"),
        ("cat cube.gcode | $W check - --picture -", b"\x89PNG"),
        ("cat cube.gcode | $W check -", b"/dev/stdin: printable"),
        ("cat cube.gcode | $W estimate -", b"/dev/stdin: "),
        ("cat cube.stl | $W info - --format stl", b"/dev/stdin\n  size"),
        ("cat cube.stl | $W compare - --format stl --condition wireprint -o -", b"\x89PNG"),
        ("cat cube.stl | $W project - --format stl -o -", b"PK"),
        ("cat cube.stl | $W project - --format stl -o - | $W info - --format 3mf", b"/dev/stdin"),
        ("$W example cube -o -", b"wireprint example cube"),
        ("(echo name; ls cube.stl) | $W bench - --no-compare -o -", b"model,model_sha256"),
    ]:
        done = shell(line, folder)
        assert done.returncode == 0, (line, done.stderr)
        assert done.stdout.startswith(begin), (line, done.stdout[:100], done.stderr)
        assert b"Traceback" not in done.stderr


def test_stdin_without_its_format_is_refused_with_the_way_out(model):
    done = shell("cat cube.stl | $W slice - -o a.gcode", model.parent)
    assert done.returncode == 3
    assert b"--format" in done.stderr


def test_stdin_that_is_the_output_is_refused(model):
    done = shell("$W slice - --format stl -o link.gcode < cube.stl", model.parent)
    assert done.returncode == 0
    os.replace(model.parent / "link.gcode", model.parent / "old.gcode")
    (model.parent / "link.gcode").symlink_to("cube.stl")
    done = shell("$W slice - --format stl -o link.gcode < cube.stl", model.parent)
    assert done.returncode == 2
    done = shell("$W slice cube.stl -o - >> cube.stl", model.parent)
    assert done.returncode == 2
    assert model.read_bytes() == examples.stl("cube")


def test_what_does_not_end_is_refused(tmp_path, monkeypatch):
    from wireprint import streams

    monkeypatch.setattr(streams, "MOST_BYTES", 1 << 20)
    with pytest.raises(streams.InputError, match="does not end after 1 MB"):
        streams.regular(streams.Path("/dev/zero"))
    with pytest.raises(streams.InputError, match="this is a folder"):
        streams.regular(tmp_path)


def test_a_replaced_file_hands_on_its_permissions_and_owner(tmp_path):
    path = tmp_path / "a.gcode"
    path.write_bytes(b"older")
    path.chmod(0o640)
    if os.geteuid() == 0:
        os.chown(path, 1234, 5678)
    before = path.stat()
    written_whole(path, b"newer")
    after = path.stat()
    assert path.read_bytes() == b"newer"
    assert stat.S_IMODE(after.st_mode) == 0o640
    assert (after.st_uid, after.st_gid) == (before.st_uid, before.st_gid)


def test_a_new_file_has_the_permissions_that_the_user_wants(tmp_path):
    older = os.umask(0o027)
    try:
        written_whole(tmp_path / "a", b"")
    finally:
        os.umask(older)
    assert stat.S_IMODE((tmp_path / "a").stat().st_mode) == 0o640


@pytest.mark.skipif(os.geteuid() == 0, reason="root may write anywhere")
def test_a_file_that_is_write_protected_is_not_replaced(tmp_path):
    path = tmp_path / "a"
    path.write_bytes(b"older")
    path.chmod(0o444)
    with pytest.raises(OutputError, match="write-protected"):
        written_whole(path, b"newer")


@pytest.mark.parametrize("unnamed", [True, False])
@pytest.mark.parametrize("older", [None, b"older"])
def test_a_failure_leaves_what_was_there(unnamed, older, tmp_path, monkeypatch):
    if not unnamed:
        monkeypatch.setattr(_aside, "_UNNAMED", None)
    path = tmp_path / "a.gcode"
    if older is not None:
        path.write_bytes(older)

    def full(handle, content):
        raise OSError(28, "No space left on device")

    with monkeypatch.context() as patch:
        patch.setattr(_aside, "_write", full)
        with pytest.raises(OutputError, match=r"a\.gcode: No space left on device"):
            written_whole(path, b"newer")
    assert [file.read_bytes() for file in tmp_path.iterdir()] == ([] if older is None else [older])
    written_whole(path, b"newer")
    assert [file.read_bytes() for file in tmp_path.iterdir()] == [b"newer"]


@pytest.mark.parametrize("unnamed", [True, False])
def test_what_a_killed_program_left_is_taken_away_and_what_a_living_one_writes_is_not(
    unnamed, tmp_path, monkeypatch
):
    if not unnamed:
        monkeypatch.setattr(_aside, "_UNNAMED", None)
    path = tmp_path / "a"
    path.write_bytes(b"older")
    name = next(_aside._names_beside(path))
    name.write_bytes(b"left behind")
    written_whole(path, b"newer")
    assert [file.name for file in tmp_path.iterdir()] == ["a"]
    handle = os.open(name, os.O_WRONLY | os.O_CREAT)
    _aside._lock(handle)
    written_whole(path, b"newest")
    assert sorted(file.name for file in tmp_path.iterdir()) == sorted(["a", name.name])
    os.close(handle)


def test_many_may_write_to_one_place(tmp_path):
    path = tmp_path / "a"
    contents = [bytes([65 + i]) * 100_000 for i in range(8)]
    threads = [
        threading.Thread(target=lambda text=text: [written_whole(path, text) for _ in range(20)])
        for text in contents
    ]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert path.read_bytes() in contents
    assert [file.name for file in tmp_path.iterdir()] == ["a"]


def test_a_name_that_is_too_long_is_a_clear_error(tmp_path):
    with pytest.raises(OutputError, match="File name too long"):
        written_whole(tmp_path / ("a" * 300), b"")
    longest = tmp_path / ("a" * 255)
    written_whole(longest, b"1")
    written_whole(longest, b"2")
    assert longest.read_bytes() == b"2"


def test_a_name_with_a_dot_is_a_name_and_not_a_stream(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    assert output("-", "x", files.GCODE_SUFFIXES, ()).path is None
    with pytest.raises(OutputError):
        output("./-", "x", files.GCODE_SUFFIXES, ())
