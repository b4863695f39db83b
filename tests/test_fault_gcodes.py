"""G-code that firmwares read one way and programs another: each row of the shared table."""

import pytest

import wireprint
from wireprint.timing import estimate

#: Limits of the table: a = 3000 mm/s², the extruder 50 mm/s and 1000 mm/s².
LIMITS = {
    "kinematics": "cartesian",
    "max_velocity": 300,
    "max_accel": 3000,
    "max_z_velocity": 12,
    "max_z_accel": 100,
    "max_extrude_only_velocity": 50,
    "max_extrude_only_accel": 1000,
}
#: File, firmware, figure and what it is to be.
ROWS = [
    ("g10g11.gcode", "klipper", "total_s", 2 * 1.0333 + 2 * 0.1633),
    ("g10_klipper_params.gcode", "klipper", "total_s", 2 * 0.12),
    ("g53.gcode", "klipper", "total_s", 1.0333),
    ("g53.gcode", "marlin", "total_s", 1.0333),
    ("vol.gcode", "marlin", "filament_mm", 1.0),
    ("relative_e_in_macro.gcode", "klipper", "filament_mm", 10.4),
    ("m220_B.gcode", "marlin", "total_s", 1.0333),
    ("cr_only.gcode", "klipper", "total_s", 2 * 1.0333),
]


@pytest.mark.parametrize(("name", "firmware", "figure", "expected"), ROWS)
def test_each_row_of_the_table_comes_out(shared, name, firmware, figure, expected):
    found = estimate(shared / "faults" / name, LIMITS, firmware=firmware)
    assert getattr(found, figure) == pytest.approx(expected, rel=0.02)


def test_e_that_runs_backwards_is_named(shared):
    found = estimate(shared / "faults/relative_e_in_macro.gcode", LIMITS)
    assert found.relative_assumed
    assert "taken as relative" in found.remarks[0]


@pytest.mark.parametrize("name", ["tiny_island.gcode", "larger_island.gcode"])
def test_an_island_that_closes_on_itself_does_not_dangle(shared, name):
    found = wireprint.check(shared / "faults" / name)
    assert found.ok, found.breaches()


@pytest.mark.parametrize("name", ["stored.gcode.3mf", "packed.gcode.3mf"])
def test_a_sliced_plate_is_unpacked(shared, name):
    assert estimate(shared / "faults" / name, LIMITS).moves > 10


def test_what_is_not_judged_is_named_by_its_line(shared):
    found = wireprint.check(shared / "faults/hostile/motion_unjudged.gcode", "kossel-mini")
    assert not found.ok
    assert {one.command.split()[0] for one in found.unjudged} >= {"G5"}
    assert found.to_dict()["not_judged_from_line"] == found.unjudged[0].line


def test_arcs_of_absurd_radius_cost_little(shared):
    assert not wireprint.check(shared / "faults/hostile/arc_many.gcode").ok
