"""``wireprint estimate``, and the times that Klipper's own planner gives."""

import json

import pytest
from click.testing import CliRunner

from wireprint import SettingError
from wireprint.cli import main
from wireprint.timing import Allowances


def run(*arguments):
    result = CliRunner().invoke(main, ["estimate", *map(str, arguments)])
    return result.exit_code, result.stdout


@pytest.fixture
def files(tmp_path):
    paths = [tmp_path / "a.gcode", tmp_path / "b.gcode"]
    paths[0].write_text("G1 X100 F6000 E1\n")
    paths[1].write_text("G1 X100 F6000\nG4 P1500\n")
    return paths


def test_one_file_gives_one_object(files):
    code, text = run(files[0], "--json")
    assert code == 0
    keys = {"total_s", "moving_s", "dwell_s", "travel_s", "by_feature", "by_layer"}
    assert keys | {"filament_mm", "filament_g"} <= json.loads(text).keys()


def test_several_files_give_a_list_in_their_order(files):
    _, text = run(*files, "--json", "--firmware", "klipper")
    objects = json.loads(text)
    assert [one["file"] for one in objects] == [str(path) for path in files]
    assert [one["dwell_s"] for one in objects] == [0, 1.5]


def test_the_report_names_time_features_and_filament(files):
    code, text = run(*files, "--printer", "printrbot-simple")
    assert code == 0
    for word in ("other", "travel", "dwell", "filament: 1 mm", "all: "):
        assert word in text


def test_a_missing_file_cannot_be_read(tmp_path):
    assert run(tmp_path / "none.gcode")[0] == 3


def test_a_wrong_profile_exits_with_4(files):
    assert run(files[0], "--printer", "no-such")[0] == 4
    assert run(files[0], "--limits", "no-such.toml#a")[0] == 4


def test_klippers_golden_times_are_met(shared):
    timing = shared / "timing"
    rows = [line.split("\t") for line in (timing / "golden.tsv").read_text().splitlines()[1:]]
    for name, machine, *figures in rows:
        arguments = ["--limits", f"{timing / 'machines.toml'}#{machine}", "--json"]
        _, text = run(timing / "gcode" / name, *arguments)
        found = json.loads(text)
        for key, figure in zip(("total_s", "moving_s", "dwell_s"), figures, strict=True):
            assert found[key] == pytest.approx(float(figure), rel=1e-5), (name, key)


@pytest.mark.parametrize("option", ["homing", "nozzle-heating", "bed-heating", "tool-change"])
@pytest.mark.parametrize("value", ["nan", "inf", "-1", "1e999"])
def test_an_allowance_that_is_no_time_is_refused(files, option, value):
    code, _ = run(files[0], f"--{option}-s", value)
    assert code == 2
    with pytest.raises(SettingError, match="finite"):
        Allowances(**{f"{option.replace('-', '_')}_s": float(value)})
