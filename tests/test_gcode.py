"""Toolpath to G-code: what is written, in which dialect, and how hosts read it."""

import base64
import math
import re
from datetime import UTC, datetime
from typing import get_args

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from hypothesis.extra import numpy as hnp

from wireprint._core import KINDS, GcodeError, SettingError, Toolpath
from wireprint.choices import Flavor
from wireprint.gcode import document, own_settings
from wireprint.gcode.flavors import FLAVORS
from wireprint.settings import Settings

DATE = datetime(2026, 11, 21, 23, 5, 9, tzinfo=UTC)
POST = KINDS.index("post")


def path(to, kind=1, *, speed=30.0, filament=0.0, pause=0.0, air=False, slab=0):
    """Make a toolpath of moves to the rows of `to`; every other figure may be one for all."""
    to = np.asarray(to, np.float64).reshape(-1, 3)

    def column(values, dtype):
        return np.ascontiguousarray(np.broadcast_to(np.asarray(values, dtype), len(to)))

    return Toolpath.from_arrays(
        start=(0, 0, 0),
        to=to,
        kind=column(kind, np.uint8),
        speed=column(speed, np.float64),
        filament=column(filament, np.float64),
        pause=column(pause, np.float64),
        air=column(air, bool),
        slab=column(slab, np.uint32),
    )


#: A travel, a contour, a post with air and a pause, a diagonal.
SMALL = {
    "to": [[0, 0, 0.35], [10, 0, 0.35], [10, 0, 5], [15, 0, 0.35]],
    "kind": [0, 1, 2, 3],
    "filament": [0, 1.6, 0.8, 1.1],
    "pause": [0, 0, 1, 0],
    "air": [False, False, True, False],
}


def lines_of(text):
    return text.decode().splitlines()


def commands(text):
    return [line for line in lines_of(text) if line and not line.startswith(";")]


def settings_for(flavor, *overrides):
    return Settings.load(overrides=[f"gcode.flavor={flavor}", "cooling.method=valve", *overrides])


def replay(text, relative):
    """Positions and feeds that a firmware would see, from absolute G0 and G1."""
    at, fed, rows = [0.0, 0.0, 0.0], 0.0, []
    for line in commands(text):
        words = {word[0]: float(word[1:]) for word in line.split()[1:]}
        if not line.startswith(("G0", "G1")):
            continue
        at = [words.get(axis, old) for axis, old in zip("XYZ", at, strict=True)]
        if "E" in words:
            fed = fed + words["E"] if relative else words["E"]
        rows.append((*at, fed))
    return np.array(rows)


@given(
    to=hnp.arrays(np.float64, (20, 3), elements=st.floats(-500, 500)),
    filament=hnp.arrays(np.float64, 20, elements=st.floats(-5, 5)),
    relative=st.booleans(),
)
def test_the_text_replays_to_the_toolpath(to, filament, relative):
    settings = Settings.load(overrides=[f"gcode.relative_extrusion={str(relative).lower()}"])
    rows = replay(document.moves(path(to, filament=filament), settings), relative)
    fed = np.cumsum(filament)
    assert rows[-1, :3] == pytest.approx(to[-1], abs=0.0005 + 1e-9)
    assert rows[-1, 3] == pytest.approx(fed[-1], abs=1e-5)
    for row in rows:  # each row is one of the moves; moves that round to nothing are left out
        near = np.abs(to - row[:3]).max(axis=1) < 0.0005 + 1e-9
        assert (np.abs(fed[near] - row[3]) < 1e-5).any()


@pytest.mark.parametrize("flavor", FLAVORS)
def test_every_flavour_dwells_in_milliseconds_by_p_alone(flavor):
    text = commands(document.moves(path(**SMALL), settings_for(flavor)))
    dwells = [line for line in text if line.startswith("G4")]
    assert dwells == ["G4 P1000"]


def test_every_flavour_that_can_be_chosen_is_spoken():
    assert tuple(FLAVORS) == get_args(Flavor)


@pytest.mark.parametrize("flavor", ["marlin", "repetier"])
def test_the_valve_is_switched_only_when_earlier_moves_are_done(flavor):
    text = commands(document.moves(path(**SMALL), settings_for(flavor)))
    switches = [i for i, line in enumerate(text) if line.startswith("M42 P6 S")]
    assert len(switches) == 2
    assert [text[i - 1] for i in switches] == ["M400", "M400"]


def test_reprapfirmware_queues_m42_with_its_moves():
    text = commands(document.moves(path(**SMALL), settings_for("reprapfirmware")))
    assert [line for line in text if line.startswith("M4")] == ["M42 P6 S1", "M42 P6 S0"]


def test_klipper_switches_an_output_pin_and_knows_no_m42():
    text = commands(document.moves(path(**SMALL), settings_for("klipper")))
    assert "SET_PIN PIN=wire_air VALUE=1" in text
    assert "SET_PIN PIN=wire_air VALUE=0" in text
    assert not [line for line in text if line.startswith(("M42", "M400"))]


@pytest.mark.parametrize("flavor", FLAVORS)
def test_the_air_blows_exactly_where_the_toolpath_says(flavor):
    rng = np.random.default_rng(7)
    air = rng.random(50) < 0.5
    to = np.column_stack([np.arange(1, 51), np.zeros(50), np.ones(50)])
    blows, seen = False, []
    for line in commands(document.moves(path(to, air=air), settings_for(flavor))):
        if line.startswith(("M42", "SET_PIN")):
            blows = line.rpartition("S")[2] not in ("0",) and not line.endswith("VALUE=0")
        elif line.startswith("G1"):
            seen.append(blows)
    assert seen == air.tolist()
    assert not blows, "the air is off at the end"


def test_a_part_fan_is_switched_by_m106_and_m107():
    settings = Settings.load(overrides=["cooling.method=fan"])
    text = commands(document.moves(path(**SMALL), settings))
    assert [line for line in text if line.startswith("M10")] == ["M106 S255", "M107"]


def test_without_cooling_no_air_command_is_written():
    settings = Settings.load(overrides=["cooling.method=none"])
    text = document.moves(path(**SMALL), settings)
    assert b"M42" not in text
    assert b"M106" not in text


def test_a_valve_without_a_pin_is_refused():
    with pytest.raises(SettingError, match=r"marlin needs cooling\.valve_pin"):
        Settings.load(printer="prusa-mk4s", overrides=["cooling.method=valve"])


def test_types_and_layers_are_announced_in_prusaslicers_form():
    text = document.moves(path(**SMALL, slab=[0, 0, 1, 1]), Settings.load()).decode()
    assert re.findall(r"^;TYPE:(.+)$", text, re.M) == ["CONTOUR", "POST", "DIAGONAL"]
    assert text.count(";LAYER_CHANGE\n;Z:") == 2
    assert ";LAYER_CHANGE\n;Z:5.000\n;HEIGHT:4.650\n" in text


def test_firmware_retraction_is_a_choice():
    retraction = {"to": [[1, 1, 1]] * 3, "kind": [1, 9, 10], "filament": [1, -4, 4]}
    settings = Settings.load(overrides=["gcode.firmware_retraction=true"])
    assert commands(document.moves(path(**retraction), settings))[1:] == ["G10", "G11"]
    assert b"E-4.00000" in document.moves(path(**retraction), Settings.load())


@pytest.mark.parametrize(
    ("name", "values", "message"),
    [
        ("kind", np.array([12], np.uint8), "kind holds 12; the codes are 0 to 11"),
        ("speed", np.ones(2), r"speed has shape \(2,\); it must be \(1,\)"),
        ("to", np.ones((1, 2)), r"to has shape \[1, 2\]; it must be \(N, 3\)"),
    ],
)
def test_arrays_that_do_not_fit_are_refused_by_name(name, values, message):
    arrays = {
        "start": (0, 0, 0),
        "to": np.zeros((1, 3)),
        "kind": np.zeros(1, np.uint8),
        "speed": np.ones(1),
        "filament": np.zeros(1),
        "pause": np.zeros(1),
        "air": np.zeros(1, bool),
        "slab": np.zeros(1, np.uint32),
    }
    with pytest.raises(SettingError, match=message):
        Toolpath.from_arrays(**arrays | {name: values})


def test_arrays_come_back_as_they_went_in_and_read_only():
    toolpath = path(**SMALL)
    assert len(toolpath) == 4
    assert toolpath.to.tolist() == SMALL["to"]
    assert toolpath.air.tolist() == SMALL["air"]
    assert toolpath.top_mm == 5
    assert toolpath.kind.dtype == np.uint8
    with pytest.raises(ValueError, match="read-only"):
        toolpath.speed[0] = 1


def whole(settings, **extra):
    text = document.body(path(**SMALL), settings, DATE, **extra)
    return text + document.footer(settings, filament_mm=1234.5, print_time_s=3723.4, layers=2)


@pytest.mark.parametrize("flavor", FLAVORS)
def test_the_first_line_names_program_and_date(flavor):
    first = lines_of(whole(settings_for(flavor)))[0]
    assert re.fullmatch(r"; generated by wireprint \S+ on 2026-11-21 at 23:05:09 UTC", first)


def test_the_machine_heats_and_homes_before_it_moves():
    text = commands(whole(Settings.load()))
    first_move = next(i for i, line in enumerate(text) if line.startswith("G0"))
    for line in ("M190 S100", "M109 S240", "G28", "G21", "G90", "M83", "G92 E0"):
        assert text.index(line) < first_move
    assert text.index("M104 S0") > first_move


def test_parking_stays_within_the_machine():
    settings = Settings.load(printer="prusa-mk4s")
    text = document.body(path([[100, 100, 215]]), settings, DATE)
    assert b"G1 Z220.000 F720" in text


def test_braces_that_mean_nothing_are_refused():
    with pytest.raises(SettingError, match=r"gcode\.start: .* there are \{nozzle_c\}, \{bed_c\}"):
        Settings.load(overrides=["gcode.start='M104 S{temperature}'"])
    settings = Settings.load(overrides=["gcode.start='SET A={{1}} T={nozzle_c}'"])
    assert b"SET A={1} T=240\n" in document.body(path(**SMALL), settings, DATE)


@pytest.mark.parametrize(
    ("pattern", "value"),
    [
        (r"PrusaSlicer\s(.*)\son", "2.8"),
        (r"filament\sused\s\[mm\]\s=\s(.*)\n", "1234.50"),
        (r"total\sfilament\sused\s\[g\]\s=\s([0-9]*\.?[0-9]+)", "3.09"),
        (r"; estimated\sprinting\stime.*= (.*)", "1h 2m 3s"),
        (r"; nozzle_diameter\s=\s([0-9]*\.?[0-9]+)", "0.7"),
        (r"; layer_height = ([0-9]*\.?[0-9]+)", "6"),
        (r"; first_layer_height = ([0-9]*\.?[0-9]+)", "0.35"),
        (r"; first_layer_temperature = ([0-9]*\.?[0-9]+)", "240"),
        (r"; first_layer_bed_temperature = ([0-9]*\.?[0-9]+)", "100"),
        (r"; filament_type\s=\s(.*)", "ABS"),
        (r"; total layers count = ([0-9]+)", "2"),
        (r";BEFORE_LAYER_CHANGE\n(?:.*\n)?;(\d+\.?\d*)", "5.000"),
    ],
)
def test_hosts_find_what_they_look_for(pattern, value):
    """The patterns are those that hosts search PrusaSlicer's files with."""
    found = re.search(pattern, whole(Settings.load()).decode())
    assert found is not None
    assert found[1] == value


@given(st.binary(min_size=1, max_size=600))
def test_thumbnails_survive_the_way_through_comments(png):
    text = whole(Settings.load(), thumbnails=[document.Thumbnail(32, 24, png)]).decode()
    block = re.search(r"; thumbnail begin (\d+)x(\d+) (\d+)\n(.*?); thumbnail end", text, re.S)
    assert (block[1], block[2]) == ("32", "24")
    rows = [row.removeprefix("; ") for row in block[4].splitlines()]
    assert max(map(len, rows)) <= 78
    assert len("".join(rows)) == int(block[3])
    assert base64.b64decode("".join(rows)) == png


def test_the_settings_can_be_read_back_from_the_file():
    settings = Settings.load(overrides=["head.slant_deg=41", "wire.pause_s=0.3"])
    assert own_settings.settings_in(whole(settings)) == settings


def test_another_programs_file_has_no_settings():
    assert own_settings.settings_in(b"G1 X1\n; nozzle_diameter = 0.4\n") is None


def test_damaged_settings_are_refused():
    text = whole(Settings.load()).replace(b"slant_deg = 32.0", b"slant_deg = steep")
    with pytest.raises(GcodeError, match="damaged"):
        own_settings.settings_in(text)


def test_the_date_is_the_models_unless_the_environment_gives_one(tmp_path, monkeypatch):
    model = tmp_path / "model.stl"
    model.write_bytes(b"")
    monkeypatch.delenv("SOURCE_DATE_EPOCH", raising=False)
    assert document.dated(model).timestamp() == int(model.stat().st_mtime)
    assert document.dated(None).timestamp() == 0
    monkeypatch.setenv("SOURCE_DATE_EPOCH", "86400")
    assert document.dated(model) == datetime(1970, 1, 2, tzinfo=UTC)
    monkeypatch.setenv("SOURCE_DATE_EPOCH", "soon")
    with pytest.raises(SettingError, match="SOURCE_DATE_EPOCH"):
        document.dated(model)


@pytest.mark.parametrize(
    ("seconds", "text"),
    [(0, "0s"), (59.6, "1m 0s"), (3600, "1h 0m 0s"), (90061, "1d 1h 1m 1s"), (146, "2m 26s")],
)
def test_durations_are_written_from_the_first_unit_that_counts(seconds, text):
    assert document.duration(seconds) == text


def test_progress_runs_from_the_whole_time_to_nothing():
    settings = Settings.load(overrides=["wire.pause_s=30"])
    text = document.body(path(**SMALL | {"pause": [0, 0, 90, 30]}), settings, DATE)
    timed, estimate = document.timed(text, settings)
    progress = re.findall(rb"^M73 P(\d+) R(\d+)$", timed, re.M)
    percents, minutes = zip(*[(int(p), int(m)) for p, m in progress], strict=True)
    assert percents == tuple(sorted(percents))
    assert minutes == tuple(sorted(minutes, reverse=True))
    assert (percents[0], percents[-1]) == (0, 100)
    assert (minutes[0], minutes[-1]) == (math.ceil(estimate.total_s / 60), 0)
    assert re.sub(rb"M73 .*\n", b"", timed) == text


def test_progress_changes_no_time():
    settings = Settings.load()
    timed, before = document.timed(document.body(path(**SMALL), settings, DATE), settings)
    assert document.timed(timed, settings)[1].total_s == before.total_s


#: Roles as PrusaSlicer writes them; its viewer shows all others as unknown.
PRUSA_ROLES = {
    "Perimeter",
    "External perimeter",
    "Overhang perimeter",
    "Internal infill",
    "Solid infill",
    "Top solid infill",
    "Ironing",
    "Bridge infill",
    "Gap fill",
    "Skirt/Brim",
    "Support material",
    "Support material interface",
    "Wipe tower",
    "Custom",
}


def test_prusas_viewer_knows_the_words_and_ours_are_read_all_the_same():
    from wireprint._core import Strands

    every = [number for number, name in enumerate(KINDS) if "retract" not in name]
    toolpath = path([[i, 0, 0.35] for i in range(len(every))], every, filament=1.0)
    ours, theirs = (
        document.moves(toolpath, Settings.load(overrides=[f"gcode.type_words={words}"]))
        for words in ("own", "prusa")
    )
    roles = {line.removeprefix(";TYPE:") for line in lines_of(theirs) if line.startswith(";TYPE:")}
    assert len(roles) > 5
    assert roles <= PRUSA_ROLES
    assert commands(theirs) == commands(ours)

    def kinds(text):
        strands = Strands.from_gcode(text)
        return [strands.labels[number] for number in strands.features.tolist()]

    assert kinds(theirs) == kinds(ours)
