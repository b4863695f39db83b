"""What is asked of the machine beside its moves: pressure, air and the bed's acceleration."""

import re

import pytest

from wireprint import check, compare, examples, load_mesh, make
from wireprint.gcode import own_settings
from wireprint.gcode.flavors import FLAVORS
from wireprint.settings import Settings


@pytest.fixture(scope="module")
def cube(tmp_path_factory):
    model = tmp_path_factory.mktemp("models") / "cube.stl"
    model.write_bytes(examples.stl("cube"))
    return load_mesh(model)


def settings_for(flavor, *overrides, printer="kossel-mini"):
    return Settings.load(printer, overrides=[f"gcode.flavor={flavor}", *overrides])


def lines_of(print_):
    """Return its lines; those that only tell the progress may stand anywhere."""
    return [line for line in print_.gcode.decode().splitlines() if not line.startswith("M73")]


def before_first_move(lines):
    return lines[: next(i for i, line in enumerate(lines) if line.startswith("G0"))]


@pytest.mark.parametrize(
    ("flavor", "line"),
    [
        ("marlin", "M900 K0.25"),
        ("reprapfirmware", "M572 D0 S0.25"),
        ("klipper", "SET_PRESSURE_ADVANCE ADVANCE=0.25"),
        ("repetier", None),
    ],
)
def test_the_lag_is_told_to_firmware_that_minds_it(cube, flavor, line):
    told = re.compile(r"M900|M572|SET_PRESSURE_ADVANCE")
    settings = settings_for(flavor, "extruder.pressure_lag_s=0.25")
    start = before_first_move(lines_of(make(cube, settings)))
    assert [line for line in start if told.match(line)] == ([line] if line else [])
    unknown = settings_for(flavor, "extruder.pressure_lag_s=0")
    assert not [line for line in lines_of(make(cube, unknown)) if told.match(line)]


def fed_in_place(lines):
    """Filament of the moves that move nothing else, retractions of 4 mm aside."""
    fed = [float(m[1]) for line in lines if (m := re.match(r"G1 E(-?[\d.]+)", line))]
    return [e for e in fed if abs(e) < 3.9]


@pytest.mark.parametrize("flavor", FLAVORS)
@pytest.mark.parametrize("advance", ["true", "false"])
def test_filament_is_pulled_back_before_dwells_where_firmware_minds_no_pressure(
    cube, flavor, advance
):
    settings = settings_for(
        flavor, "extruder.pressure_lag_s=0.3", f"gcode.pressure_advance={advance}"
    )
    made = make(cube, settings)
    lines = lines_of(made)
    eased = 0.3 * 30 * (0.7 / 1.75) ** 2
    back = [e for e in fed_in_place(lines) if abs(e + eased) < 1e-3]
    dwells = [i for i, line in enumerate(lines) if line.startswith("G4")]
    by_itself = advance == "true" and flavor in ("marlin", "reprapfirmware")
    eases = [lines[i - 1].startswith("G1 E-") for i in dwells]
    assert len(dwells) == made.wireframe.post_count
    assert len(back) == sum(eases)
    if advance == "true" and flavor == "klipper":
        # It advances no stroke that moves along z alone.
        upright = [i for i in dwells if re.match(r"G1 Z\S+ E", lines[i - 2])]
        assert sum(eases) == len(upright) > 0
    else:
        assert not any(eases) if by_itself else all(eases)
    assert made.certificate.ok
    # What is pulled back is given again: the print takes what its strands are made of.
    plain = make(cube, settings_for(flavor, "extruder.pressure_lag_s=0"))
    more = made.estimate.filament_mm - plain.estimate.filament_mm
    assert -1e-3 <= more <= eased + 1e-3


def test_the_firmwares_own_retraction_is_kept_for_travels(cube):
    overrides = ["extruder.pressure_lag_s=0.3", "gcode.firmware_retraction=true"]
    made = make(cube, settings_for("repetier", *overrides))
    lines = lines_of(made)
    dwells = [i for i, line in enumerate(lines) if line.startswith("G4")]
    assert all(lines[i - 1].startswith("G1 E-") for i in dwells)
    assert lines.count("G10") == lines.count("G11") > 1
    assert not [line for line in lines if line.startswith("G1 E-4")]
    assert made.certificate.ok


def test_what_is_pulled_back_takes_no_longer_than_the_pause(cube):
    """The head stands as long as before: only the filament's own ramps are added."""
    times = [
        make(cube, settings_for("repetier", f"extruder.pressure_lag_s={lag}")).estimate.total_s
        for lag in (0, 0.4)
    ]
    assert times[1] <= 1.03 * times[0]


@pytest.mark.parametrize("flavor", FLAVORS)
def test_an_open_valve_halts_no_head_in_the_air(cube, flavor):
    lines = lines_of(make(cube, settings_for(flavor)))
    switched = [line for line in lines if re.match(r"M42|SET_PIN", line)]
    if FLAVORS[flavor].valve_halts:
        assert len(switched) == 2, "open above the bed, closed at the end"
    else:
        assert "M400" not in lines
        assert len(switched) > 20, "closed before each joint"


@pytest.mark.parametrize("flavor", FLAVORS)
def test_contours_and_caps_get_the_air_too(cube, flavor):
    """Metres printed in the air without air are joints alone: two diameters each."""
    path = make(cube, settings_for(flavor)).toolpath
    from_ = [path.start, *path.to[:-1].tolist()]
    bare = 0.0
    for a, b, air, kind in zip(from_, path.to.tolist(), path.air, path.kind, strict=True):
        length = sum((x - y) ** 2 for x, y in zip(a, b, strict=True)) ** 0.5
        if kind in (1, 3, 4) and max(a[2], b[2]) > 0.36 and not air and length > 1e-6:
            assert length == pytest.approx(1.4, abs=1e-6)
            bare += length
    assert (bare == 0) is FLAVORS[flavor].valve_halts


@pytest.mark.parametrize(
    ("flavor", "gentle", "usual"),
    [
        ("marlin", ["M201 Y500"], ["M201 Y4000"]),
        ("reprapfirmware", ["M201 Y500"], ["M201 Y4000"]),
        ("repetier", ["M201 Y500", "M202 Y500"], ["M201 Y4000", "M202 Y4000"]),
        ("klipper", ["SET_VELOCITY_LIMIT ACCEL=500"], ["SET_VELOCITY_LIMIT ACCEL=4000"]),
    ],
)
def test_a_bed_that_moves_is_moved_gently_and_is_quick_again_afterwards(
    cube, flavor, gentle, usual
):
    limit = re.compile(r"M20[12]|SET_VELOCITY_LIMIT")
    settings = settings_for(flavor, printer="prusa-mk4s")
    made = make(cube, settings)
    lines = lines_of(made)
    last = max(i for i, line in enumerate(lines) if line.startswith("G1") and "E" in line)
    assert [line for line in before_first_move(lines) if limit.match(line)] == gentle
    assert [line for line in lines[last:] if limit.match(line)] == usual
    stiff = settings.but(overrides=["motion.bed_moves_y=false"])
    other = make(cube, stiff)
    assert not [line for line in lines_of(other) if limit.match(line)]
    assert made.estimate.total_s > other.estimate.total_s, "the estimate reads the file"


def test_a_bed_that_is_slower_by_itself_is_left_alone(cube):
    settings = settings_for("marlin", "wire.bed_accel_mm_s2=9000", printer="prusa-mk4s")
    assert not [line for line in lines_of(make(cube, settings)) if line.startswith("M201")]


def test_stacked_layers_are_compared_at_the_machines_own_acceleration(cube):
    gentle = Settings.load("prusa-mk4s", "pla")
    stiff = gentle.but(overrides=["motion.bed_moves_y=false"])
    solid, wire = "layerwise-solid", "wireprint"
    slow, fast = (compare(cube, s, (solid, wire)).conditions for s in (gentle, stiff))
    assert slow[0].print_time_s == fast[0].print_time_s
    assert slow[1].print_time_s > fast[1].print_time_s


def test_every_flavours_print_is_certified_from_its_text(cube):
    for flavor in FLAVORS:
        made = make(cube, settings_for(flavor), certify=False)
        assert check(made.gcode).ok
        assert own_settings.settings_in(made.gcode) == made.settings
