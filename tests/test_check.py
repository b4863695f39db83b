"""``wireprint.check``: a hand-made print passes, each planted breach is found."""

import contextlib
import json
import math
import re

import numpy as np
import pytest
import trimesh
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

import wireprint
from command import run
from wireprint import GcodeError, Settings
from wireprint._core import Mesh
from wireprint.certificate import check
from wireprint.mesh import load_mesh
from wireprint.rules import settings_for

FIRST = 0.35
SLAB = 4.0


def outline():
    """Post positions around a square of side 28 mm, three a side."""
    corners = [(-14, -14), (14, -14), (14, 14), (-14, 14)]
    for (x0, y0), (x1, y1) in zip(corners, corners[1:] + corners[:1], strict=True):
        for part in range(3):
            yield x0 + (x1 - x0) * part / 3, y0 + (y1 - y0) * part / 3


def wire_cube():
    """G-code of a wire cube of three slabs: one continuous strand, relative extrusion."""
    points = list(outline())
    lines = ["G28", "G90", "M83", f"G1 X-14 Y-14 Z{FIRST} F3000"]

    def draw(index, z):
        x, y = points[index % len(points)]
        lines.append(f"G1 X{x:.3f} Y{y:.3f} Z{z:.3f} E1 F600")

    first = 0
    for slab in range(4):
        z = FIRST + slab * SLAB
        for i in range(1, len(points) + 1):
            draw(first + i, z)
        if slab == 3:
            break
        for i in range(len(points)):
            if i:
                draw(first + i, z)
            draw(first + i, z + SLAB)
        first += len(points) - 1
    return lines


def judge(lines, **options):
    return wireprint.check("\n".join(lines).encode(), "kossel-mini", **options)


def stroke(lines, rise, number):
    """Index of the `number`-th extruding line whose height changes by `rise`."""
    z, found = None, []
    for index, line in enumerate(lines):
        if match := re.search(r"Z([-\d.]+)", line):
            new = float(match[1])
            if z is not None and "E" in line and math.isclose(new - z, rise, abs_tol=1e-6):
                found.append(index)
            z = new
    return found[number]


def test_a_correct_wire_cube_passes():
    found = judge(wire_cube())
    assert found.ok, found.breaches()
    assert found.strands == 4 * 12 + 3 * 23
    assert 7 < found.max_span_mm < 12
    assert 3 < found.max_free_end_mm < 4


def test_a_lowered_travel_collides():
    lines = [
        *wire_cube(),
        "G1 Z40 F6000",
        "G1 X50 Y0",
        f"G1 Z{FIRST + 3 * SLAB - 2}",
        "G1 X0 ; through the wall",
    ]
    found = judge(lines)
    assert [hit.line for hit in found.collisions] == [len(lines)]
    assert 0.35 < found.collisions[0].depth_mm <= 2
    assert "strand of line" in str(found.collisions[0])


def test_a_steepened_diagonal_collides():
    lines = wire_cube()
    index = stroke(lines, -SLAB, 4)
    post = re.search(r"X([-\d.]+) Y([-\d.]+)", lines[index - 1]).groups()
    foot = re.search(r"X([-\d.]+) Y([-\d.]+)", lines[index]).groups()
    x, y = (float(a) + 0.4 * (float(b) - float(a)) for a, b in zip(post, foot, strict=True))
    lines[index] = f"G1 X{x:.3f} Y{y:.3f} Z{FIRST} E1"
    assert index + 1 in [hit.line for hit in judge(lines).collisions]


def test_a_post_that_is_not_extruded_leaves_a_floating_start():
    lines = wire_cube()
    index = stroke(lines, SLAB, 3)
    lines[index] = lines[index].replace(" E1", "")
    assert [start.line for start in judge(lines).floating_starts] == [index + 2]


def test_a_shifted_start_floats():
    lines = wire_cube()
    lines[3] = "G1 X-14 Y-14 Z1.5 F3000"
    assert [start.line for start in judge(lines).floating_starts] == [5]


def test_an_end_in_the_air_dangles():
    lines = wire_cube()[: stroke(wire_cube(), SLAB, 11) + 1]
    found = judge(lines)
    assert [end.line for end in found.dangling_ends] == [len(lines)]
    assert not found.collisions


def test_a_span_over_the_limit_is_named_with_its_length():
    lines = ["G28", "M83", f"G1 X-40 Y0 Z{FIRST} F3000", "G1 X-39 E1 F600"]
    lines += ["G1 Z5 E1", "G1 X40 E9", f"G1 X60 Z{FIRST} E1"]
    (span,) = judge(lines).spans_over
    assert span.limit_mm == 65
    assert 79 < span.length_mm < 101
    assert not span.free_end


@pytest.mark.parametrize(
    ("line", "bound"),
    [
        ("G1 X80 Y80 F600", "volume"),
        ("G1 Z230 F600", "volume"),
        ("G1 X10 F60000", "feed"),
        ("G1 X15 E20 F600", "flow"),
        ("G1 E-250 F600", "filament"),
    ],
)
def test_each_bound_is_named(line, bound):
    found = judge(["G28", "M83", f"G1 X0 Y0 Z{FIRST} F600", line])
    assert [(breach.line, breach.bound) for breach in found.out_of_bounds] == [(4, bound)]


@given(x=st.floats(-50, 50), y=st.floats(-50, 50), turn=st.floats(0, 7), mm=st.floats(0.005, 1))
def test_the_flow_of_a_short_strand_is_told_as_exactly_as_its_words(x, y, turn, mm):
    there = x + mm * math.cos(turn), y + mm * math.sin(turn)
    feed_mm_min = 60 * 14.9 / (math.pi * 0.35**2)
    for factor, breaches in ((0.995, 0), (1.5 if mm > 0.02 else 2.5, 1)):
        fed_mm = factor * mm * (0.35 / 0.875) ** 2
        lines = ["G28", "M83", f"G1 X{x:.3f} Y{y:.3f} Z{FIRST} F600"]
        lines += [f"G1 X{there[0]:.3f} Y{there[1]:.3f} E{fed_mm:.5f} F{feed_mm_min:.0f}"]
        assert len(judge(lines).out_of_bounds) == breaches


def test_klipper_allows_less_filament_in_place():
    text = b"G28\nM83\nG1 Z0.3\nG1 X9 E1 F600\nG1 E-60 F600"
    lenient, strict = Settings.load(), Settings.load(overrides=['gcode.flavor="klipper"'])
    assert wireprint.check(text, lenient).ok
    assert not wireprint.check(text, strict).ok


def test_the_bed_is_not_cut():
    (hit,) = judge(["G28", "G1 X0 Y0 Z-0.2 F600"]).collisions
    assert hit.hit_line is None
    assert hit.depth_mm == pytest.approx(0.2)
    assert "the bed" in str(hit)


def test_the_verdict_in_absolute_words_is_the_same():
    relative, extruded = wire_cube(), 0.0
    absolute = []
    for line in relative:
        if match := re.search(r"E(\d+)", line):
            extruded += float(match[1])
            line = line.replace(match[0], f"E{extruded:.3f}")
        absolute.append(line.replace("M83", "M82"))
    found, other = judge(relative), judge(absolute)
    assert other.ok
    assert other.max_span_mm == pytest.approx(found.max_span_mm)


def test_a_file_of_wireprint_is_judged_by_its_own_settings():
    assert settings_for(b"G28\n", None).printer.name == "kossel-mini"
    assert settings_for(b"G28\n", "printrbot-simple").printer.name == "printrbot-simple"


def test_a_text_that_moves_nothing_is_refused():
    with pytest.raises(GcodeError, match="moves nothing"):
        wireprint.check(b"hello\n")


@settings(max_examples=60, deadline=None, suppress_health_check=[HealthCheck.too_slow])
@given(st.binary(max_size=400))
def test_random_bytes_give_a_verdict_or_an_error(text):
    with contextlib.suppress(GcodeError):
        wireprint.check(text, "kossel-mini").to_dict()


def plate():
    """A box of 60 x 60 x 5 mm."""
    box = trimesh.creation.box((60, 60, 5))
    return Mesh.from_arrays(np.asarray(box.vertices, float), np.asarray(box.faces, np.int64))


def test_fidelity_counts_strands_of_the_object_only():
    mesh = plate()
    lines = [
        "; generated by wireprint",
        "M83",
        ";TYPE:Support",
        "G1 X-30 Y-30 Z0 F3000",
        "G1 X30 Y30 E1 F600",
    ]
    aside = judge(lines, model=mesh).fidelity
    assert aside.coverage == pytest.approx(0, abs=1e-9)
    assert judge(lines[1:], model=mesh).fidelity.coverage > 0.08, "another program's label"
    lines[2] = ";TYPE:Contour"
    counted = judge(lines, model=mesh).fidelity
    assert 0.08 < counted.coverage < 0.1
    assert counted.deviation_mm == pytest.approx(0, abs=1e-6)
    assert counted.uncovered[0].area_mm2 >= counted.uncovered[-1].area_mm2
    missing = sum(patch.area_mm2 for patch in counted.uncovered)
    assert counted.coverage == pytest.approx(1 - missing / mesh.area)
    assert counted.area_mm2 == pytest.approx(mesh.area)


def test_how_far_strands_lie_off_is_measured_where_it_is_asked_for(cube_stl):
    text, mesh = "\n".join(wire_cube()).encode(), load_mesh(cube_stl)
    whole, part = (check(text, model=mesh, deviation=wanted).fidelity for wanted in (True, False))
    assert part.coverage == whole.coverage
    assert part.deviation_mm is None
    assert part.max_chord_deviation_mm is None
    assert whole.max_chord_deviation_mm >= whole.chord_deviation_mm >= 0


def test_a_strand_of_a_thousand_kilometres_takes_no_longer_to_compare(cube_stl):
    lines = [*wire_cube(), "G1 X999999999 Y-999999999 E9", "G1 X0 Y0 Z1 E1"] * 3
    found = check("\n".join(lines).encode(), model=load_mesh(cube_stl)).fidelity
    assert found.max_deviation_mm > 1e8


def test_arrays_of_the_verdict_are_read_only():
    core = judge(wire_cube()).core
    assert core.strands.shape == (core.strand_count, 2, 3)
    assert core.relaxed.shape[1:] == (2, 3)
    for array in (core.strands, core.relaxed, core.strand_lines, core.strand_features):
        assert not array.flags.writeable


def test_the_command_exits_with_0_for_a_printable_file(tmp_path):
    path = tmp_path / "cube.gcode"
    path.write_text("\n".join(wire_cube()))
    done = run("check", path, "--json")
    assert done.exit_code == 0, done.output
    found = json.loads(done.stdout)
    assert found["ok"] is True
    assert found["collisions"] == found["floating_starts"] == found["dangling_ends"] == []
    assert found["spans_over"] == found["out_of_bounds"] == []
    assert found["max_span_mm"] > 0


def test_the_command_exits_with_1_and_names_line_place_and_depth(tmp_path):
    path = tmp_path / "low.gcode"
    path.write_text(f"G28\nM83\nG1 X0 Y0 Z{FIRST} F600\nG1 X10 E1\nG1 X20 Z-1\n")
    done = run("check", path, "--picture", tmp_path / "low.png")
    assert done.exit_code == 1
    assert "line 5: head 1.00 mm into the bed, at (20.00, 0.00, -1.00)" in done.stdout
    assert (tmp_path / "low.png").read_bytes().startswith(b"\x89PNG")


def test_the_command_judges_by_single_settings(tmp_path):
    path = tmp_path / "cube.gcode"
    path.write_text("\n".join(wire_cube()))
    flat = run("check", path, "--set", "head.slant_deg=25")
    assert flat.exit_code == 0, "its diagonals fall by 23 degrees"
    blunt = run("check", path, "--set", "head.slant_deg=15", "--json")
    assert blunt.exit_code == 1
    assert json.loads(blunt.stdout)["collisions"]


def test_other_programs_layers_pass_where_nothing_is_hit(shared):
    path = shared / "timing/gcode/cube28_ps.gcode"
    found = wireprint.check(path, "kossel-mini")
    assert found.strands > 1000
    assert not found.collisions
    assert not found.floating_starts
