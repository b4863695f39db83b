"""Files as other programs write them pass: their start and end, modes, messages and purge lines."""

import pytest

import wireprint

#: Path of the extruder over one layer of a plate with 20 mm sides: walls, then lines across.
SIDE, WIDTH, LAYER = 20.0, 0.45, 0.2


def layers(
    centre, count=6, absolute=False, retract=("G1 E-0.8 F2100", "G1 E0.8 F1500"), iron=False
):
    """Lines of a plain layered plate: perimeters, infill, retractions, wipes, layer comments."""
    x0, y0 = centre[0] - SIDE / 2, centre[1] - SIDE / 2
    per_mm = WIDTH * LAYER / 2.405
    extruded = 0.0

    def draw(x, y, length, share=1.0):
        nonlocal extruded
        feed = share * per_mm * length
        extruded += feed
        return f"G1 X{x:.3f} Y{y:.3f} E{extruded if absolute else feed:.5f}"

    for number in range(count):
        z = LAYER * (number + 1)
        yield from (";LAYER_CHANGE", f";Z:{z:g}", f";HEIGHT:{LAYER}")
        yield from (retract[0], f"G1 Z{z + 0.4:.3f} F5000", f"G1 X{x0:.3f} Y{y0:.3f} F6000")
        yield from (f"G1 Z{z:.3f}", retract[1], ";TYPE:External perimeter", "G1 F1500")
        corners = [(x0 + SIDE, y0), (x0 + SIDE, y0 + SIDE), (x0, y0 + SIDE), (x0, y0)]
        yield from (draw(x, y, SIDE) for x, y in corners)
        yield from (";TYPE:Solid infill", f"G1 X{x0 + 0.5:.3f} Y{y0 + 0.2:.3f} F6000", "G1 F2400")
        for line in range(int(SIDE / WIDTH)):
            y = y0 + 0.2 + line * WIDTH
            ends = (x0 + 0.5, x0 + SIDE - 0.5)
            near, far = ends if line % 2 == 0 else ends[::-1]
            yield from (f"G1 X{near:.3f} Y{y:.3f}", draw(far, y, SIDE - 1))
    if iron:
        yield ";TYPE:Ironing"
        for line in range(50):
            y = y0 + 0.5 + line * 0.1
            yield f"G1 X{x0 + 0.5:.3f} Y{y:.3f}"
            yield draw(x0 + SIDE - 0.5, y, SIDE - 1, share=0.1 / WIDTH * 0.15)


PRUSA_START = """
M73 P0 R12
M201 X4000 Y4000 Z200 E2500 ; sets maximum accelerations, mm/sec^2
M203 X300 Y300 Z40 E100
M204 P4000 R1200 T4000
M205 X8.00 Y8.00 Z2.00 E10.00
M486 S0
M486 Aplate.stl
M486 S-1
;TYPE:Custom
M17 ; enable steppers
M862.1 P0.4 A0 F1 ; nozzle check
M862.3 P "MK4S" ; printer model check
M862.5 P2
M862.6 P"Input shaper"
M115 U6.1.3+7898
M555 X99 Y94 W52 H22
G90 ; use absolute coordinates
M83 ; extruder relative mode
M140 S60 ; set bed temp
M104 T0 S170
M109 T0 R170
M84 E ; turn off E motor
G28 ; home all without mesh bed level
G1 X42 Y-4 Z5 F4800
M302 S160
G1 E-2 F2400
M84 E
G29 P9 X10 Y-4 W32 H4
M106 S100
G0 Z40 F10000
M190 S60
M107
G29 P1 ; invalidate mbl & probe print area
G29 P1 X0 Y0 W50 H20 C
G29 P3.2
G29 A
M104 S215
G0 X0 Y-4 Z15 F4800
M109 S215
G92 E0
M569 S0 E
G92 E0
G1 Z0.2 F720
G0 X25 E4 F500
G0 X35 E4 F650
G0 X45 E4 F800
G0 X48 Z0.05 F8000
G0 X51 Z0.2 F8000
G92 E0
M221 S100
G21
M572 S0.036
M107
"""
PRUSA_END = """
;TYPE:Custom
G1 Z11 F720 ; Move print head up
M104 S0
M140 S0
M107
G1 X241 Y170 F3600 ; park
G4 ; wait
M572 S0
M593 X T2 F0
M84 X Y E ; disable motors
M73 P100 R0
; estimated printing time (normal mode) = 12m 3s
"""
VORON_START = """
SET_PRINT_STATS_INFO TOTAL_LAYER=6
EXCLUDE_OBJECT_DEFINE NAME=plate CENTER=150,150 POLYGON=[[140,140],[160,140],[160,160],[140,160]]
M140 S105
M104 S150
PRINT_START BED=105 HOTEND=245 CHAMBER=45 MATERIAL=ABS
M190 S105
M109 S245
G21
G90
M83
SET_VELOCITY_LIMIT ACCEL=3000
SET_PRESSURE_ADVANCE ADVANCE=0.04
M117 Printing G1 Z0
RESPOND TYPE=echo MSG="layer 1"
SET_FAN_SPEED FAN=chamber SPEED=0.5
EXCLUDE_OBJECT_START NAME=plate
M106 S76
"""
CURA_START = """
;FLAVOR:Marlin
;TIME:613
;Generated with Cura_SteamEngine 5.6.0
M140 S60
M105
M190 S60
M104 S210
M105
M109 S210
M82 ;absolute extrusion mode
G28 ;Home
G1 Z15.0 F300 ;Move the platform down 15mm
G92 E0
G1 F200 E3
G92 E0
M83
M107
"""


def prusa():
    """PrusaSlicer for an MK4S: objects, mesh levelling, a purge line beside the bed, ironing."""
    body = layers((125, 105), iron=True)
    return [*PRUSA_START.split("\n"), *body, *PRUSA_END.split("\n")]


def voron():
    """OrcaSlicer for a Voron: macros that heat and home, messages, fans, excluded objects."""
    body = list(layers((150, 150), retract=("G10", "G11")))
    end = ["EXCLUDE_OBJECT_END NAME=plate", "M107", "G1 Z20 F600", "PRINT_END"]
    return [*VORON_START.split("\n"), *body, *end]


def cura():
    """Cura for a Printrbot: absolute filament, temperatures in its own order, homing of x and y."""
    start = [line for line in CURA_START.split("\n") if line != "M83"]
    retract = ("M400", "M114")
    body = layers((75, 75), absolute=True, retract=retract)
    end = ["M140 S0", "M107", "G91", "G1 E-1 F300", "G1 Z5 E-2 F300", "G28 X0 Y0", "M84", "G90"]
    return [*start, *body, *end, "M104 S0", ";End of Gcode"]


@pytest.mark.parametrize(
    ("lines", "printer"),
    [(prusa, "prusa-mk4s"), (voron, "voron-2.4"), (cura, "printrbot-simple")],
)
def test_a_layered_print_of_another_program_is_printable(lines, printer):
    found = wireprint.check("\n".join(lines()).encode(), printer)
    assert found.ok, found.breaches()
    assert found.strands > 200
    assert found.harmless


def test_a_purge_line_beside_the_bed_ends_where_the_axes_do():
    lines = prusa()
    lines[lines.index("G0 X25 E4 F500")] = "G0 X25 Y-5 E4 F500"
    found = wireprint.check("\n".join(lines).encode(), "prusa-mk4s")
    assert {breach.bound for breach in found.out_of_bounds} == {"volume"}


def test_only_what_lies_on_the_bed_may_be_printed_beside_it():
    lines = [*prusa()[:-14], "G1 Y-3 Z5 E2 F600"]
    found = wireprint.check("\n".join(lines).encode(), "prusa-mk4s")
    assert [breach.line for breach in found.out_of_bounds] == [len(lines)]
