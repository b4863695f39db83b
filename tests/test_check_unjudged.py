"""What can move head, bed or frame within a print is carried out, or the file is not judged."""

import re
import string

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from own_prints import PRINTERS, first_line, judge, lines_of, strands_of, within

#: They move the head, the bed or the frame of coordinates, change the tool, call what is not known,
#: or are read in one way by some firmwares and in another by others.
MOVING = """
G5 X1 Y1 I1 J1 P1 Q1 | G5.1 X1 Y1 I1 J1 | G6 X1 | G12 | G27 | G29 | G30 X0 Y0 | G33 | G34
G38.2 Z0 | G42 I1 J1 | G61 | G80 | G54 | G59.3 | G68 R45 | G51 X2 | G52 X5 | G92.1
G10 L2 P1 Z5 | G10 L20 P1 Z5 | M206 Z-1 | M290 Z-0.5 | M290 S0.4 | M851 Z2 | M852 I1 | M92 Z800
M218 T1 X5 | M350 Z1 | M665 L100 | M666 X1 | M420 Z2 | M421 X1 Y1 Z1 | M428 | M501 | M502
M569 P0 S0 | M605 S2 | M906 Z1 | M913 Z0 | M915 | M0 | M1 | M25 | M125 | M226 | M600 | M601
M701 | M702 | M6 T1 | T1 | T3 | Tx | T? | Tc | T-1 | SET_GCODE_OFFSET Z=-2
SET_GCODE_OFFSET Z_ADJUST=-0.5 MOVE=1 | SET_KINEMATIC_POSITION Z=50
FORCE_MOVE STEPPER=stepper_z DISTANCE=-5 VELOCITY=5 | RESTORE_GCODE_STATE NAME=a MOVE=1 | PAUSE
MANUAL_STEPPER STEPPER=z MOVE=-5 | BED_MESH_PROFILE LOAD=x | QUAD_GANTRY_LEVEL
SET_SKEW XY=1,2,3 | SET_DUAL_CARRIAGE CARRIAGE=1
SYNC_EXTRUDER_MOTION EXTRUDER=e MOTION_QUEUE=a | EXCLUDE_OBJECT NAME=a
TUNING_TOWER COMMAND=SET_GCODE_OFFSET PARAMETER=Z START=0 FACTOR=1
SDCARD_PRINT_FILE FILENAME=x | SET_STEPPER_ENABLE STEPPER=stepper_z ENABLE=0 | M98 P"x.g"
M808 L3 | M810 | M23 x.g | M32 x.g | M486 C | G1 Z{1} | G1 Z=1 | G1 Z[1] | G1 Z(1) | G1 X
G1 X1.2.3 | G1 X- | G1 U5 | G1 A5 | G0 H1 | G1 X1 S1 | G53 | G2 X0 Y0 | G1 X1 !
G1 X99999999999 | $H | $J=G91 X10 | ~ | ? | :G28 | <html> | {if} | #1=5 | O100 | G90 G1 Z0
G91 G1 Z-5 | M83 G1 Z0 | G21 G0 Z0 | G17 G2 X1 I1 | G4 P1 G1 Z0 | T0 G1 Z0 | G28 X G1 Z0
M104 S200 G1 Z0 | M220 S100 G1 Z0 | G28 R0 | G28 H | G28 C
M208 Z-5 S1 | M303 E0 S200 | M118 A1 P0 action:pause | RESPOND TYPE=command MSG="action:cancel"
%G1 Z0 | %G28 | /G1 Z0 | (a) G1 Z{2} | N10 G1 Z{0}*99 | G65 P100 | M37 P"x.g" | G92.2
var z = 0 | while iterations < 5 | {% set z = 0 %} | SKEW_PROFILE LOAD=a | TESTZ Z=-1
M564 S0 G1 Z0 | BED_MESH_CLEAR | M221 S0 | M220 S0 | M220 S-5 | G1 F0 | G1 X0 Y0 F-600 | G2 I5 F0
M111 S8 | M111 S32 | M916 X | M917 Z F5 | M918 Y | G28 O | if state.status == "processing" | else
while true | abort "x" | break
""".replace("\n", "|")
COMMANDS = [command.strip() for command in MOVING.split("|") if command.strip()]
#: They move nothing, wherever they stand.
HARMLESS = """
M104 S240 | M105 | M106 S255 | M107 | M114 | M117 G1 Z0 is only a text | M118 G28 | M73 P50 R1
M300 S440 | M140 S60 | M155 S1 | M204 P1000 | M205 X8 | M201 X1000 | M203 X200 | M900 K0.04
M400 | G4 P5 | G4 S0 | M862.3 P "MK4S" | M115 U6.1.2 | M555 X1 Y1 W9 H9 | M593 F40 | M486 S1
M111 S6 | M302 S160 | M220 S100 | M221 S100 | SET_PRESSURE_ADVANCE ADVANCE=0.04
SET_VELOCITY_LIMIT ACCEL=3000 | SET_FAN_SPEED FAN=a SPEED=1 | EXCLUDE_OBJECT_START NAME=a
EXCLUDE_OBJECT_END NAME=a | SET_PIN PIN=air VALUE=1 | RESPOND MSG="G1 Z0"
SET_DISPLAY_TEXT MSG=hot | SET_PRINT_STATS_INFO CURRENT_LAYER=1 | G21 | G92 E0 | T0 | (G28)
; G28 | % | M208 S0.2 F300 | G94 | M118 A1 action:notification Layer | G60 S0 | m105 | g4 p5
RESPOND TYPE=command MSG="action:prompt_begin Pause" | M211 S0 | M564 H0 | SAVE_GCODE_STATE NAME=a
""".replace("\n", "|")
few, some = settings(max_examples=5), settings(max_examples=25)
printers = st.sampled_from(PRINTERS)
shares = st.floats(0, 1)


def with_line(printer, share, *lines):
    """A print with more lines before one of its strands, and the number of the first of them."""
    index, text = within(printer, share), lines_of(printer)
    return [*text[:index], *lines, *text[index:]], index + 1


@pytest.mark.parametrize("printer", PRINTERS)
def test_our_own_prints_are_judged_whole_and_right(printer):
    found = judge(lines_of(printer), printer)
    assert found.ok, found.breaches()
    assert found.to_dict()["not_judged_from_line"] is None


@pytest.mark.parametrize("command", COMMANDS)
@few
@given(printer=printers, share=shares)
def test_what_may_move_something_within_a_print_is_named_by_its_line(command, printer, share):
    lines, number = with_line(printer, share, command)
    found = judge(lines, printer)
    assert not found.ok
    assert found.unjudged[0].line == number
    assert found.unjudged[0].why
    assert found.to_dict()["not_judged_from_line"] == number


@pytest.mark.parametrize("command", [c.strip() for c in HARMLESS.split("|") if c.strip()])
@few
@given(printer=printers, share=shares)
def test_what_moves_nothing_changes_no_verdict(command, printer, share):
    lines, _ = with_line(printer, share, command)
    found = judge(lines, printer)
    assert found.ok, found.breaches()


@some
@given(
    printer=printers,
    share=shares,
    number=st.integers(1000, 999_999),
    letter=st.sampled_from("GMT"),
    words=st.text(string.ascii_uppercase + string.digits + " .-", max_size=12),
)
def test_a_code_that_nobody_knows_is_not_passed_over(printer, share, number, letter, words):
    lines, line = with_line(printer, share, f"{letter}{number} {words}")
    found = judge(lines, printer)
    assert not found.ok
    assert first_line(found) == line


@some
@given(printer=printers, share=shares, name=st.text(string.ascii_letters + "_", min_size=2))
def test_a_macro_that_the_profile_does_not_state_is_not_passed_over(printer, share, name):
    lines, line = with_line(printer, share, f"ZZ_{name} Z=0")
    assert judge(lines, printer).unjudged[0].line == line


@some
@given(
    printer=printers,
    share=shares,
    first=st.sampled_from("!\"#$&'+,-./:<=>?@[\\]^_`{|}~\x00\x01\x7f"),
    rest=st.text(max_size=40),
)
def test_garbage_within_a_print_is_not_passed_over(printer, share, first, rest):
    one_line = re.sub(r"[\r\n]", " ", rest)
    lines, line = with_line(printer, share, first + one_line)
    assert judge(lines, printer).unjudged[0].line == line


@some
@given(
    printer=st.sampled_from([name for name in PRINTERS if name != "voron-2.4"]),
    share=st.floats(0.3, 1),
    down=st.floats(1, 10),
    word=st.sampled_from(["G53 G0", "G53 G1", "g53G0", "N7 G53 G1"]),
)
def test_a_move_in_the_machines_own_coordinates_is_a_move(printer, share, down, word):
    """The head stands on the strand laid before, and sinks into it; Klipper knows no G53."""
    text, contours = lines_of(printer), strands_of(printer, "CONTOUR")
    index = contours[int(share * (len(contours) - 1))]
    z = height_at(text, index)
    line = f"{word} Z{max(z - down, 0):.3f}"
    found = judge([*text[: index + 1], line, *text[index + 1 :]], printer)
    if z > 1.5:
        assert index + 2 in [hit.line for hit in found.collisions]
    assert not found.ok


def height_at(lines, index):
    """Height of the tip after the line at `index`."""
    heights = re.findall(r"^G[01] .*?Z([\d.]+)", "\n".join(lines[: index + 1]), re.M)
    return float(heights[-1])


@some
@given(printer=printers, share=st.floats(0.2, 1), mm=st.floats(1, 9), sign=st.sampled_from([-1, 1]))
def test_a_frame_that_is_renamed_moves_all_that_follows(printer, share, mm, sign):
    """Behind it strands hang in the air, or the head runs into what is there."""
    lines, line = with_line(printer, share / 2, f"G92 Z{40 + sign * mm:.3f}")
    found = judge(lines, printer)
    assert not found.ok
    assert first_line(found) >= line


@pytest.mark.parametrize(
    "command", ["SET_GCODE_OFFSET Z=-1", "M206 Z-1", "G54", "M851 Z3", "G10 L2 Z1"]
)
@pytest.mark.parametrize("printer", PRINTERS)
def test_a_frame_that_is_moved_before_the_print_is_not_judged_either(printer, command):
    text = lines_of(printer)
    found = judge([command, *text], printer)
    assert found.unjudged[0].line == 1
    assert not found.ok


@pytest.mark.parametrize("printer", PRINTERS)
def test_after_a_macro_the_head_is_where_the_first_whole_place_says(printer):
    """What was done before the print is not known; a print that begins with a place is judged."""
    text = lines_of(printer)
    begin = next(i for i, line in enumerate(text) if line.startswith(";LAYER_CHANGE"))
    assert judge([*text[:begin], "G29", *text[begin:]], printer).ok
    relative = ["G29", "G91", "G1 X1 F600", "G1 X10 E1", "G90"]
    found = judge([*text[:begin], *relative, *text[begin:]], printer)
    assert found.unjudged[0].line == begin + 4
