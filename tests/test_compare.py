"""`wireprint compare`: the same model in every way."""

import json

import pytest
from click.testing import CliRunner

import wireprint
from wireprint.cli import main
from wireprint.comparison import CONDITIONS


@pytest.fixture(scope="module")
def cube(cube_stl):
    return wireprint.compare(wireprint.load_mesh(cube_stl), wireprint.Settings.load())


def test_every_condition_is_there_in_order(cube):
    assert tuple(row.condition for row in cube.conditions) == CONDITIONS


def test_speedups_count_from_the_first_condition(cube):
    first = cube.conditions[0]
    for row in cube.conditions:
        assert row.speedup == pytest.approx(first.print_time_s / row.print_time_s)


def test_the_papers_solid_cube_takes_its_24_59(cube):
    assert cube.conditions[0].print_time_s == pytest.approx(24 * 60 + 59, rel=0.1)


def test_the_papers_cube_as_a_frame_takes_its_10_23(cube):
    frame = next(row for row in cube.conditions if row.condition == "layerwise-wireframe")
    assert frame.print_time_s == pytest.approx(10 * 60 + 23, rel=0.1)


def test_a_wire_print_is_the_fastest_and_the_lightest(cube):
    wire = next(row for row in cube.conditions if row.condition == "wireprint")
    others = [row for row in cube.conditions if row is not wire]
    assert all(wire.print_time_s < row.print_time_s for row in others)
    assert all(wire.filament_g < row.filament_g for row in others)


def test_the_same_model_compares_the_same(cube, cube_stl):
    again = wireprint.compare(wireprint.load_mesh(cube_stl), wireprint.Settings.load())
    for one, other in zip(cube.conditions, again.conditions, strict=True):
        assert (one.print_time_s, one.filament_mm) == (other.print_time_s, other.filament_mm)


def test_an_unknown_condition_is_refused_by_name(cube_stl):
    with pytest.raises(wireprint.SettingError, match=r"'fused'.*layerwise-solid"):
        wireprint.compare(wireprint.load_mesh(cube_stl), wireprint.Settings.load(), ["fused"])


def test_json_tells_every_condition(cube_stl):
    result = CliRunner().invoke(main, ["compare", str(cube_stl), "--json"], standalone_mode=False)
    assert result.exit_code == 0, result.output
    rows = json.loads(result.output)["conditions"]
    assert [row["condition"] for row in rows] == list(CONDITIONS)
    keys = {"print_time_s", "filament_mm", "filament_g", "speedup", "compute_s"}
    assert all(keys <= row.keys() and row["print_time_s"] > 0 for row in rows)


def test_the_table_and_the_chart_show_what_was_asked_for(cube_stl, tmp_path):
    chart = tmp_path / "chart.png"
    arguments = ["compare", str(cube_stl), "-o", str(chart), "--condition", "wireprint"]
    result = CliRunner().invoke(main, arguments, standalone_mode=False)
    assert result.exit_code == 0, result.output
    assert "wireprint" in result.output
    assert "layerwise" not in result.output
    assert chart.read_bytes().startswith(b"\x89PNG")
