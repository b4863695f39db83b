"""What is marked is one more way to print, for `wireprint compare` and `wireprint bench`."""

import csv
import json

import pyarrow.parquet
import pytest
from click.testing import CliRunner

from threemf_files import cube_object, write_3mf
from wireprint import examples
from wireprint.bench.table import COLUMNS, MARKED_COLUMNS
from wireprint.cli import main
from wireprint.comparison import CONDITIONS, HYBRID

MARK = ("--fill", "z:8..16")
#: Settings that a project brings, and one that is laid over them.
OWN, OVER = ("--slab-max", "3"), ("--set", "wire.pause_s=2.5")


def run(*arguments):
    result = CliRunner().invoke(main, [str(argument) for argument in arguments])
    assert result.exit_code == 0, result.stderr
    return result


def conditions(*arguments):
    found = json.loads(run("compare", *arguments, "--json").stdout)["conditions"]
    return {row["condition"]: row for row in found}


@pytest.fixture(scope="module")
def models(tmp_path_factory):
    folder = tmp_path_factory.mktemp("models")
    (folder / "cube.stl").write_bytes(examples.stl("cube"))
    run("project", folder / "cube.stl", "-o", folder / "marked.3mf", *MARK, *OWN)
    run("project", folder / "cube.stl", "-o", folder / "plain.3mf", *OWN)
    return folder


def test_a_marked_model_is_compared_as_a_hybrid_too(models, tmp_path):
    names = [name for wanted in ("wireprint", HYBRID) for name in ("--condition", wanted)]
    found = conditions(models / "marked.3mf", *names)
    assert list(found) == ["wireprint", HYBRID]
    wire, hybrid = found.values()
    assert wire.keys() == hybrid.keys()
    assert hybrid["speedup"] == pytest.approx(wire["print_time_s"] / hybrid["print_time_s"])
    options = ("-o", tmp_path / "x.gcode", "--json", "--fill")
    for row, mark in ((wire, "erase:z:.."), (hybrid, "erase:z:100..")):
        printed = json.loads(run("slice", models / "marked.3mf", *options, mark).stdout)
        assert bool(printed["regions"]["runs"]) == (row is hybrid)
        assert row["print_time_s"] == pytest.approx(printed["print_time_s"], rel=1e-3)
        assert row["filament_mm"] == pytest.approx(printed["filament_mm"], rel=1e-3)


def test_options_mark_and_set_as_they_do_for_slice(models):
    names = ("--condition", HYBRID)
    project = conditions(models / "marked.3mf", *OVER, *names)[HYBRID]
    options = conditions(models / "cube.stl", *MARK, *OWN, *OVER, *names)[HYBRID]
    assert project["print_time_s"] == options["print_time_s"]
    assert project["filament_mm"] == options["filament_mm"]
    assert conditions(models / "marked.3mf", *names)[HYBRID]["print_time_s"] != pytest.approx(
        project["print_time_s"], rel=1e-3
    )


def test_there_is_no_hybrid_where_nothing_is_marked(models):
    arguments = ["compare", str(models / "plain.3mf"), "--condition", HYBRID]
    result = CliRunner().invoke(main, arguments)
    assert result.exit_code == 4
    assert "'hybrid': nothing is marked; there are layerwise-solid" in result.stderr


@pytest.fixture(scope="module")
def results(models):
    """Rows of the three models, in Parquet."""
    target = models / "out" / "results.parquet"
    target.parent.mkdir()
    told = run("bench", models, "-o", target, "--jobs", 1, "--json")
    return target, json.loads(told.stdout)


def rows_of(path):
    return {
        row["model"].rpartition("/")[2]: row for row in pyarrow.parquet.read_table(path).to_pylist()
    }


def test_bench_adds_the_hybrid_of_marked_models_to_their_rows(models, results):
    path, told = results
    rows = rows_of(path)
    assert [row["error"] for row in rows.values()] == [None] * 3
    compared = conditions(models / "marked.3mf")
    assert list(compared) == [*CONDITIONS, HYBRID]
    for name, row in compared.items():
        cell = f"{name.replace('-', '_')}_time_s"
        assert rows["marked.3mf"][cell] == pytest.approx(row["print_time_s"])
    assert all(rows["marked.3mf"][name] is not None for name in MARKED_COLUMNS)
    for plain in ("plain.3mf", "cube.stl"):
        assert all(rows[plain][name] is None for name in MARKED_COLUMNS)
    assert told["speedup"][HYBRID]["max"] == rows["marked.3mf"]["hybrid_speedup"]


def test_a_project_is_evaluated_with_its_own_settings(results):
    rows = rows_of(results[0])
    assert rows["plain.3mf"]["print_time_s"] == rows["marked.3mf"]["print_time_s"]
    assert rows["plain.3mf"]["print_time_s"] != rows["cube.stl"]["print_time_s"]
    assert len({row["settings_sha256"] for row in rows.values()}) == 2


def test_a_run_with_marked_models_goes_on_where_it_was(models, results):
    path, told = results
    content = path.read_bytes()
    assert json.loads(run("bench", models, "-o", path, "--jobs", 1, "--json").stdout) == told
    assert path.read_bytes() == content


def test_a_table_of_plain_models_has_the_columns_that_it_always_had(models, tmp_path):
    target = tmp_path / "plain.csv"
    run(
        "bench",
        models / "cube.stl",
        models / "marked.3mf",
        "-o",
        target,
        "--no-compare",
        "--jobs",
        1,
    )
    with target.open(newline="") as file:
        assert csv.DictReader(file).fieldnames == list(COLUMNS)


def test_a_project_that_is_damaged_costs_its_own_row_alone(models, tmp_path):
    broken = write_3mf(
        tmp_path / "broken.3mf",
        cube_object(9),
        parts={"_rels/.rels": '<Relationships xmlns="x"><Relationship/></Relationships>'[:40]},
    )
    target = tmp_path / "rows.csv"
    run("bench", broken, models / "cube.stl", "-o", target, "--no-compare", "--jobs", 1)
    with target.open(newline="") as file:
        first, second = csv.DictReader(file)
    assert "its XML is damaged" in first["error"]
    assert second["certified"] == "True"
