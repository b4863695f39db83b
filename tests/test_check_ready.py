"""Homing, heat, dwells, filament and first layers: breaches that no strand's geometry shows."""

import re

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import wireprint
from command import run
from own_prints import PRINTERS, first_line, judge, lines_of, strands_of, within
from wireprint import SettingError, Settings

some = settings(max_examples=25)
printers = st.sampled_from(PRINTERS)
shares = st.floats(0, 1)


def fed(line, factor):
    """A line with so much times its filament."""
    return re.sub(r"E([\d.]+)", lambda found: f"E{float(found[1]) * factor:.5f}", line)


def with_heat(lines, *heat):
    """A print with other commands in the place of those that heat the nozzle."""
    kept = [line for line in lines if not line.startswith(("M104", "M109"))]
    return [*heat, *kept]


# Homing.


def over_the_print(printer):
    """Settings of a printer that homes z where the print stands: in the middle of its bed."""
    x, y = Settings.load(printer).printer.bed.centre_mm
    return Settings.load(printer, overrides=[f"homing.z_place_mm=[{x + 14}, {y + 14}]"])


@pytest.mark.parametrize("printer", [name for name in PRINTERS if name != "kossel-mini"])
@pytest.mark.parametrize("home", ["G28", "G28 Z", "g28z", "N9 G28 Z0", "G28 W", "G28 X Y Z"])
def test_homing_z_down_through_the_print_is_a_collision(printer, home):
    text = lines_of(printer)
    last = strands_of(printer)[-1]
    lines = [*text[: last + 1], home, *text[last + 1 :]]
    found = judge(lines, over_the_print(printer))
    assert last + 2 in [hit.line for hit in found.collisions]


@pytest.mark.parametrize("printer", PRINTERS)
def test_homing_where_the_print_does_not_stand_is_right(printer):
    """A delta climbs; the others, as shipped, home beside the print and above what it is high."""
    text = [line for line in lines_of(printer) if not line.startswith(("M84", "PRINT_END"))]
    last = strands_of(printer)[-1]
    up = [*text[: last + 1], "G91", "G1 Z5 F600", "G90"]
    found = judge([*up, "G28 X Y"], printer)
    assert not [hit for hit in found.collisions if hit.line > last], found.breaches()


@pytest.mark.parametrize("printer", ["printrbot-simple", "prusa-mk4s"])
def test_an_end_sequence_that_homes_through_the_print_is_refused(printer, cube, tmp_path):
    x, y = Settings.load(printer).printer.bed.centre_mm
    mine = tmp_path / "mine.toml"
    mine.write_text(
        '[gcode]\nend = "M104 S0\\nG28\\nM84\\n"\n'
        f"[homing]\nz_place_mm = [{x + 14}, {y + 14}]\nlift_mm = 0\n"
    )
    done = run("slice", cube, "--printer", printer, "--load", mine, "-o", tmp_path / "a.gcode")
    assert done.exit_code == 5
    assert "collisions" in done.stderr
    assert not (tmp_path / "a.gcode").exists()


@some
@given(printer=printers)
def test_a_print_without_homing_is_unhomed_at_its_first_move(printer):
    lines = [line for line in lines_of(printer) if not re.match(r"G28|PRINT_START|G29", line)]
    found = judge(lines, printer)
    first = next(i for i, line in enumerate(lines, 1) if re.match(r"G[01] .*[XYZ]", line))
    assert [breach.line for breach in found.unhomed] == [first]
    assert found.unhomed[0].axes == (True, True, True)


@some
@given(printer=printers, share=shares, off=st.sampled_from(["M84", "M18", "M18 X Y Z", "M81"]))
def test_motors_that_are_off_lose_their_place(printer, share, off):
    index, text = within(printer, share), lines_of(printer)
    found = judge([*text[:index], off, *text[index:]], printer)
    assert not found.ok
    assert found.unhomed[0].line > index


@some
@given(axes=st.sets(st.sampled_from("XYZ"), max_size=2))
def test_each_axis_is_homed_by_its_own(axes):
    printer = "printrbot-simple"
    home = ["G28 " + " ".join(sorted(axes))] if axes else []
    text = [line for line in lines_of(printer) if not line.startswith("G28")]
    begin = next(i for i, line in enumerate(text) if line.startswith(";LAYER_CHANGE"))
    found = judge([*text[:begin], *home, *text[begin:]], printer)
    unhomed = tuple(axis not in axes for axis in "XYZ")
    assert found.unhomed[0].axes == unhomed


# Heat.


@some
@given(
    printer=printers,
    heat=st.sampled_from(
        [
            ["M104 S0"],
            ["M104 S240"],
            ["M109 S100"],
            ["M109 R169"],
            ["M109 S240", "M104 S0"],
            ["M109 S240", "M104 S150"],
            ["M109 S240", "G10 P0 S0 R0"],
            ["M109 S240", "M568 P0 S20"],
            ["M109 S240", "TURN_OFF_HEATERS"],
            ["M109 S240", 'SET_HEATER_TEMPERATURE HEATER="extruder" TARGET=0'],
            ["SET_HEATER_TEMPERATURE HEATER=extruder TARGET=240"],
        ]
    ),
)
def test_a_nozzle_that_is_cold_or_not_waited_for_is_named_at_the_first_filament(printer, heat):
    text = [line for line in lines_of(printer) if not line.startswith("PRINT_START")]
    lines = with_heat(["G28", *text], *heat)
    found = judge(lines, printer)
    assert not found.ok
    [cold] = found.cold
    first = next(i for i, line in enumerate(lines, 1) if re.match(r"G1 .*E\d", line))
    assert cold.line == first


@some
@given(printer=printers, share=shares, off=st.sampled_from(["M104 S0", "M109 R60", "M104 T0 S0"]))
def test_a_nozzle_that_is_switched_off_within_the_print_is_named(printer, share, off):
    index, text = within(printer, share), lines_of(printer)
    found = judge([*text[:index], off, *text[index:]], printer)
    assert index < found.cold[0].line <= index + 4


# Dwells.


@some
@given(printer=printers, ms=st.sampled_from(["0", "1", "10"]))
def test_dwells_of_nothing_on_floating_ends_are_hurried(printer, ms):
    lines = [re.sub(r"^G4 P\d+", f"G4 P{ms}", line) for line in lines_of(printer)]
    found = judge(lines, printer)
    assert not found.ok
    assert len(found.hurried) >= sum(line.startswith("G4 P") for line in lines) / 2
    ends = {index + 1 for index in strands_of(printer)}
    assert {breach.line for breach in found.hurried} <= ends


@some
@given(printer=printers, share=shares)
def test_one_dwell_that_is_forgotten_is_found_at_its_post(printer, share):
    text, posts = lines_of(printer), strands_of(printer, "POST")
    dwells = {
        index: next((i for i in range(index, index + 4) if text[i].startswith("G4")), None)
        for index in posts
    }
    dwelling = [index for index in posts if dwells[index] is not None]
    index = dwelling[int(share * (len(dwelling) - 1))]
    lines = list(text)
    lines[dwells[index]] = "; forgotten"
    found = judge(lines, printer)
    assert [breach.line for breach in found.hurried] == [index + 1]


def test_a_pause_of_nothing_is_refused_where_it_is_asked_for(cube, tmp_path):
    done = run("slice", cube, "--set", "wire.pause_s=0", "-o", tmp_path / "a.gcode")
    assert done.exit_code == 5
    assert "hurried" in done.stderr


# Filament.


@some
@given(printer=printers, factor=st.floats(0, 0.049))
def test_a_print_with_a_hundredth_of_its_filament_is_underfed_from_the_start(printer, factor):
    lines = list(lines_of(printer))
    strands = strands_of(printer)
    for index in strands:
        lines[index] = fed(lines[index], factor)
    found = judge(lines, printer)
    assert not found.ok
    if found.strands == 0:
        assert "nothing is printed" in found.remarks[0]
    elif factor > 0.001:
        assert found.underfed[0].line == strands[0] + 1
        assert found.underfed[0].share < 0.06


@some
@given(printer=printers, share=shares, factor=st.floats(0.01, 0.2))
def test_one_post_that_is_underfed_is_found(printer, share, factor):
    lines, posts = list(lines_of(printer)), strands_of(printer, "POST")
    index = posts[int(share * (len(posts) - 1))]
    lines[index] = fed(lines[index], factor)
    found = judge(lines, printer)
    assert index + 1 in [run.line for run in found.underfed]


@some
@given(printer=printers, factor=st.floats(0.3, 1.2))
def test_a_flow_that_is_adjusted_is_no_breach(printer, factor):
    lines = list(lines_of(printer))
    for index in strands_of(printer):
        lines[index] = fed(lines[index], factor)
    assert not judge(lines, printer).underfed


@pytest.mark.parametrize("command", ["M221 S1", "M200 D1.75\nM221 S5"])
def test_filament_that_is_scaled_down_is_seen_where_the_firmware_scales(command):
    text = lines_of("kossel-mini")
    index = strands_of("kossel-mini")[0]
    found = judge([*text[:index], *command.split("\n"), *text[index:]], "kossel-mini")
    assert found.underfed


# The first layer.


@some
@given(printer=printers, strands=st.floats(0.6, 5))
def test_a_print_that_begins_above_the_bed_floats_at_its_first_strand(printer, strands):
    up = strands * Settings.load(printer).printer.head.nozzle_mm
    lines = [
        re.sub(r"^(G[01] .*?)Z([\d.]+)", lambda m: f"{m[1]}Z{float(m[2]) + up:.3f}", line)
        for line in lines_of(printer)
    ]
    found = judge(lines, printer)
    assert not found.ok
    assert found.floating_starts[0].line == strands_of(printer)[0] + 1


@pytest.mark.parametrize("height_mm", [0.75, 1.4, 3.5, 5])
def test_a_first_layer_that_does_not_reach_the_bed_is_refused(height_mm, cube, tmp_path):
    setting = f"wire.first_layer_height_mm={height_mm}"
    done = run("slice", cube, "--set", setting, "-o", tmp_path / "a.gcode")
    assert done.exit_code == 5
    assert "floating starts" in done.stderr
    assert not (tmp_path / "a.gcode").exists()


# The head, and what a footer says of it.


@pytest.mark.parametrize("radius_mm", [6, 10, 27.9])
def test_a_block_that_ends_inside_its_own_flank_is_no_head(radius_mm, cube, tmp_path):
    narrow = {"slant_deg": 20, "cone_height_mm": 10, "block_radius_mm": radius_mm}
    words = [word for key, value in narrow.items() for word in ("--set", f"head.{key}={value}")]
    target = tmp_path / "a.gcode"
    done = run("slice", cube, "-o", target, *words)
    assert done.exit_code == 4
    assert "head.block_radius_mm" in done.stderr
    wide = re.search(r"give ([\d.]+) or more", done.stderr)[1]
    words[-1] = f"head.block_radius_mm={wide}"
    assert run("slice", cube, "-o", target, *words, "-q").exit_code in (0, 5)
    plain = tmp_path / "plain.gcode"
    plain.write_text("\n".join(lines_of("kossel-mini")))
    words[-1] = f"head.block_radius_mm={radius_mm}"
    done = run("check", plain, *words)
    assert done.exit_code == 1
    assert "ends inside the flank" in done.stdout


HEAD = {
    "tip_radius_mm": st.floats(0.36, 2),
    "slant_deg": st.floats(5, 85),
    "cone_height_mm": st.floats(1, 30),
    "block_radius_mm": st.floats(1, 60),
    "carriage_height_mm": st.floats(10, 100),
    "carriage_radius_mm": st.floats(5, 100),
}


def with_footer(lines, **values):
    """A print with other values in the settings at its end."""
    told = {f"; printer.{key.replace('__', '.')} = ": value for key, value in values.items()}
    return [
        next((f"{key}{value}" for key, value in told.items() if line.startswith(key)), line)
        for line in lines
    ]


@some
@given(head=st.fixed_dictionaries(HEAD), share=st.floats(0.1, 1), low=st.floats(1, 4))
def test_no_footer_makes_a_head_that_collides_pass(head, share, low):
    text, posts = list(lines_of("kossel-mini")), strands_of("kossel-mini", "POST")
    index = posts[int(share * (len(posts) - 1))]
    z = float(re.search(r"Z([\d.]+)", text[index])[1])
    text[index + 1 : index + 1] = [f"G0 Z{z - low:.3f}", f"G0 Z{z:.3f}"]
    told = {f"head__{key}": f"{value:.3f}" for key, value in head.items()}
    try:
        found = wireprint.check("\n".join(with_footer(text, **told)).encode())
    except (wireprint.GcodeError, SettingError):
        return
    assert index + 2 in [hit.line for hit in found.collisions]


@pytest.mark.parametrize(
    ("told", "line", "kind"),
    [
        ({"bed__diameter_mm": "900.0"}, "G0 X100 Y0", "volume"),
        ({"bed__height_mm": "900.0"}, "G0 Z300", "volume"),
        ({"motion__max_velocity": "900.0"}, "G0 X0 Y0 F40000", "feed"),
        ({"extruder__max_flow_mm3_s": "150.0"}, "G1 X1 Y1 E90 F3000", "flow"),
    ],
)
def test_no_footer_makes_a_known_machine_larger_or_faster(told, line, kind):
    text = list(lines_of("kossel-mini"))
    last = strands_of("kossel-mini")[-1]
    lines = with_footer([*text[: last + 1], "G0 Z60", line, *text[last + 1 :]], **told)
    found = wireprint.check("\n".join(lines).encode())
    assert (last + 3, kind) in [(breach.line, breach.bound) for breach in found.out_of_bounds]
    assert "--printer names another" in found.remarks[0]


def test_a_footer_may_say_that_the_machine_is_less_than_it_is():
    text = list(lines_of("kossel-mini"))
    lines = with_footer(text, bed__diameter_mm="60.0", bed__height_mm="40.0")
    found = wireprint.check("\n".join(lines).encode())
    assert not found.remarks
    assert first_line(found) > 0 if not found.ok else found.ok


@some
@given(printer=printers, share=st.floats(0.1, 0.8), mm=st.floats(4, 20))
def test_filament_that_is_pulled_back_and_stays_so_is_missed_at_the_next_strand(printer, share, mm):
    lines, strands = list(lines_of(printer)), strands_of(printer)
    index = strands[int(share * len(strands))]
    found = judge([*lines[:index], "M83", f"G1 E-{mm:.3f} F1800", *lines[index:]], printer)
    assert not found.ok
    assert found.underfed
    assert min(run.line for run in found.underfed) > index
    back = [*lines[:index], "M83", f"G1 E-{mm:.3f} F1800", f"G1 E{mm:.3f}", *lines[index:]]
    assert not judge(back, printer).underfed


def test_g10_without_g11_is_missed():
    lines, strands = list(lines_of("kossel-mini")), strands_of("kossel-mini")
    index = strands[len(strands) // 2]
    found = judge([*lines[:index], "M207 S4", "G10", *lines[index:]], "kossel-mini")
    assert not found.ok
    assert found.underfed[0].line > index
    both = [*lines[:index], "M207 S4", "G10", "G11", *lines[index:]]
    assert judge(both, "kossel-mini").ok
