"""Print time from the library."""

import dataclasses
import subprocess
import sys

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from wireprint import catalogue, limits
from wireprint._core import GcodeError, SettingError
from wireprint.duration import duration
from wireprint.gcode.document import footer
from wireprint.gcode.origin import stated_time_s
from wireprint.settings import Settings
from wireprint.timed_machine import Choice
from wireprint.timing import Allowances, estimate, estimate_files

MACHINE = {
    "kinematics": "cartesian",
    "max_velocity": 300,
    "max_accel": 1500,
    "max_z_velocity": 12,
    "max_z_accel": 100,
    "max_extrude_only_velocity": 120,
    "max_extrude_only_accel": 1500,
}

PRINT = b"""M83
G28
G1 X10 F6000
;LAYER_CHANGE
;Z:3.5
;TYPE:CONTOUR
G1 X60 E2
;TYPE:POST
G1 X60 Z3.5 E.1
G4 P500
;LAYER_CHANGE
;TYPE:CONTOUR
G1 X10 Z4 E2
G1 E-1
"""


def test_the_parts_add_up_to_the_whole():
    found = estimate(PRINT, MACHINE)
    assert found.total_s == pytest.approx(found.moving_s + found.dwell_s)
    assert found.total_s == pytest.approx(sum(found.by_feature.values()))
    assert found.total_s == pytest.approx(sum(layer.time_s for layer in found.by_layer))
    assert found.dwell_s == 0.5
    assert found.travel_s == found.by_feature["travel"]


def test_features_are_named_by_labels_and_by_what_moves():
    found = estimate(PRINT, MACHINE)
    assert list(found.by_feature) == ["travel", "retract", "dwell", "contour", "post"]


def test_layers_have_the_height_of_their_comment_or_of_their_first_strand():
    found = estimate(PRINT, MACHINE)
    assert [layer.z_mm for layer in found.by_layer] == [None, 3.5, 4.0]


def test_filament_is_what_was_fed_at_most():
    found = estimate(PRINT, MACHINE, material="pla")
    assert found.filament_mm == pytest.approx(4.1)
    material = Settings.load(material="pla").material
    grams = np.pi / 4 * 1.75**2 * 4.1 / 1000 * material.density_g_cm3
    assert found.filament_g == pytest.approx(grams)
    assert found.filament_cost == pytest.approx(grams / 1000 * material.price_per_kg)


def test_rows_follow_the_file_and_add_up():
    rows = estimate(PRINT, MACHINE, per_move=True).per_move
    assert rows.line.tolist() == [3, 7, 9, 10, 13, 14]
    names = [rows.types[kind] for kind in rows.kind]
    assert names == ["travel", "contour", "post", "dwell", "contour", "retract"]
    assert rows.duration_s.sum() == pytest.approx(estimate(PRINT, MACHINE).total_s)
    assert not rows.duration_s.flags.writeable
    assert estimate(PRINT, MACHINE).per_move is None


def test_homing_and_heating_count_only_what_is_allowed_for_them():
    text = b"M190 S60\nG28\nM109 S200\nM109 S180\nM109 S200\nG1 X10 F6000\n"
    plain = estimate(text, MACHINE)
    assert (plain.homing_s, plain.heating_s) == (0, 0)
    allowed = estimate(text, MACHINE, allowances=Allowances(20, 60, 120))
    assert allowed.homing_s == 20
    assert allowed.heating_s == 120 + 60 + 60
    assert allowed.total_s == pytest.approx(plain.total_s + 260)


def test_an_estimate_is_frozen_and_becomes_plain_values():
    found = estimate(PRINT, MACHINE)
    with pytest.raises(dataclasses.FrozenInstanceError):
        found.total_s = 0
    values = found.to_dict()
    assert values["by_layer"][1] == {"z_mm": 3.5, "time_s": found.by_layer[1].time_s}
    assert "per_move" not in values


def test_a_file_and_its_text_take_the_same_time(tmp_path):
    path = tmp_path / "print.gcode"
    path.write_bytes(PRINT)
    assert estimate(path, MACHINE) == estimate(PRINT, MACHINE)


@pytest.mark.parametrize("printer", catalogue.names("printers"))
@pytest.mark.parametrize("firmware", limits.FIRMWARES)
def test_every_printer_can_be_timed_under_every_firmware(printer, firmware):
    found = estimate(PRINT, printer=printer, firmware=firmware)
    assert 50 / 100 + 0.5 < found.total_s < 60


def test_a_printer_is_timed_by_its_own_firmware():
    own = estimate(PRINT, printer="voron-2.4")
    assert own == estimate(PRINT, printer="voron-2.4", firmware="klipper")
    assert own != estimate(PRINT, printer="voron-2.4", firmware="marlin")


def test_a_file_of_ours_is_timed_on_the_machine_that_it_was_made_for(tmp_path):
    settings = Settings.load(printer="voron-2.4", material="petg")
    text = PRINT + footer(settings, 4.1, 3.0, 1)
    path = tmp_path / "print.gcode"
    path.write_bytes(text)
    expected = estimate(PRINT, printer="voron-2.4", material="petg")
    assert estimate(text) == estimate(path) == expected
    assert estimate(text, printer="kossel-mini", material="abs") == estimate(PRINT)
    other = tmp_path / "other.gcode"
    other.write_bytes(PRINT)
    assert estimate_files([path, other, path], Choice()) == [expected, estimate(PRINT), expected]


def test_settings_name_printer_and_material():
    text = b"G1 X100 Y90 E40 F6000\nG1 X0"
    chosen = Settings.load("printrbot-simple", "petg")
    found = estimate(text, printer=chosen)
    assert found == estimate(text, printer="printrbot-simple", material="petg")
    assert found.total_s != estimate(text, printer="prusa-mk4s").total_s
    assert found.filament_g != estimate(text, printer="printrbot-simple", material="abs").filament_g
    with pytest.raises(SettingError, match="settings and material exclude each other"):
        estimate(text, printer=chosen, material="pla")


def test_limits_come_from_a_table_of_a_file(tmp_path):
    path = tmp_path / "machines.toml"
    lines = [f"{key} = {value!r}" for key, value in MACHINE.items()]
    path.write_text("[farm.left]\n" + "\n".join(lines))
    assert estimate(PRINT, f"{path}#farm.left") == estimate(PRINT, MACHINE)
    with pytest.raises(SettingError, match="no table is called 'right'; there are farm"):
        estimate(PRINT, f"{path}#right")


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"kinematics": "polar"}, "kinematics is 'polar'"),
        ({"max_accel": -1}, "max_accel"),
        ({"max_accel": float("nan")}, "max_accel"),
        ({"max_acel": 1}, "max_acel: unknown key"),
        ({"minimum_cruise_ratio": 1}, "minimum_cruise_ratio"),
        ({"kinematics": "delta"}, "delta_radius"),
    ],
)
def test_a_wrong_limit_is_named(change, message):
    with pytest.raises(SettingError, match=message):
        estimate(PRINT, {**MACHINE, **change})


def test_limits_and_printer_exclude_each_other():
    with pytest.raises(SettingError, match="exclude"):
        estimate(PRINT, MACHINE, printer="kossel-mini")


def test_what_is_no_gcode_is_refused():
    with pytest.raises(GcodeError, match="nothing in it is G-code"):
        estimate(b"\x00\x01\x02\x03\n" * 10, MACHINE)


@given(st.binary(max_size=300))
def test_random_bytes_are_timed_or_refused(text):
    try:
        found = estimate(text, MACHINE)
    except GcodeError:
        return
    assert 0 <= found.total_s < float("inf")


@pytest.mark.skipif(not sys.platform.startswith("linux"), reason="reads /proc")
def test_memory_does_not_grow_with_the_file(tmp_path):
    lines = b"".join(f"G1 X{i % 97}.25 Y{i % 89} E.5\n".encode() for i in range(50_000))
    peaks = []
    for name, times in (("short", 1), ("long", 60)):
        path = tmp_path / f"{name}.gcode"
        path.write_bytes(b"M83\nG1 F6000\n" + lines * times)
        script = (
            "import re, sys\n"
            "from wireprint.timing import estimate\n"
            "estimate(sys.argv[1], printer='kossel-mini')\n"
            "print(re.search(r'VmHWM:\\s+(\\d+)', open('/proc/self/status').read())[1])\n"
        )
        run = subprocess.run(
            [sys.executable, "-c", script, path], capture_output=True, text=True, check=True
        )
        peaks.append(int(run.stdout))
    assert path.stat().st_size > 40e6
    assert peaks[1] - peaks[0] < 4_000


def test_a_delta_and_a_cartesian_machine_can_be_compared():
    zigzag = b"M83\n" + b"".join(
        f"G1 X{4 * i} Z{4 * (i % 2)} E.2 F1800\n".encode() for i in range(40)
    )
    delta = estimate(zigzag, printer="kossel-mini", firmware="klipper")
    cartesian = estimate(zigzag, printer="printrbot-simple", firmware="klipper")
    assert cartesian.total_s > 1.5 * delta.total_s


@pytest.mark.parametrize(
    ("seconds", "text"),
    [(0, "0:00"), (59.6, "1:00"), (146.2, "2:26"), (3600, "1:00:00"), (7147, "1:59:07")],
)
def test_a_clock_is_read_as_people_read_it(seconds, text):
    assert duration(seconds) == text


@pytest.mark.parametrize("told", ["9" * 400 + "d", "9" * 400, " ", "h", "99999999999999d 1s"])
def test_a_time_that_no_print_takes_is_not_told(told):
    text = f"G28\nG1 X1 F600\n; estimated printing time (normal mode) = {told}\n"
    assert stated_time_s(text.encode()) is None


@pytest.mark.parametrize("printer", ["prusa-mk4s", "voron-2.4"])
def test_e_that_must_be_relative_is_so_behind_g90_too(printer):
    lines = [f"G1 X{10 + 50 * (i % 2)} Y{10 + i} E1.5" for i in range(40)]
    text = "\n".join(["G28", "START_PRINT", "G90", "G1 F1800", *lines]).encode()
    found = estimate(text, printer=printer)
    assert found.filament_mm == pytest.approx(60.0)
