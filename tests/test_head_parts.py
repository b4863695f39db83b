"""Fan ducts, probes and shrouds: parts of the head that are not round about its nozzle."""

import json
import random
import re

import numpy as np
import pytest

import random_heads
import random_parts
import wireprint
from command import run
from wireprint import SettingError
from wireprint._core import Mesh
from wireprint.gcode.own_settings import settings_in
from wireprint.mesh import load_mesh
from wireprint.pipeline import make
from wireprint.settings import Settings

#: A duct at the right, 3 mm up, and a probe behind the nozzle, 2 mm up.
DUCT = {"shape": "box", "x_mm": [12, 30], "y_mm": [-8, 8], "bottom_mm": 3}
PROBE = {"shape": "cylinder", "centre_mm": [0, 25], "radius_mm": 4, "bottom_mm": 2}
PROFILE = """
[[head.parts]]
shape = "box"
x_mm = [12, 30]
y_mm = [-8, 8]
bottom_mm = 3

[[head.parts]]
shape = "cylinder"
centre_mm = [0, 25]
radius_mm = 4
bottom_mm = {bottom}
"""


def settings_with(*parts):
    words = ", ".join(
        "{" + ", ".join(f"{key} = {json.dumps(value)}" for key, value in part.items()) + "}"
        for part in parts
    )
    return Settings.load(overrides=[f"head.parts=[{words}]"])


@pytest.fixture
def profile(tmp_path):
    def write(bottom):
        path = tmp_path / "ducts.toml"
        path.write_text(PROFILE.format(bottom=bottom))
        return path

    return write


# As settings.


def test_parts_are_tables_of_a_profile_with_defaults(profile):
    loaded = Settings.load(load=[profile(2)])
    assert loaded == settings_with(DUCT, PROBE)
    box, cylinder = loaded.printer.head.parts
    assert (box.turn_deg, cylinder.radius_mm) == (0, 4)
    assert str(box) == "box x 12 to 30, y -8 to 8, 3 mm up"
    assert str(cylinder) == "cylinder of 4 mm at x 0, y 25, 2 mm up"


def test_a_fault_in_a_part_is_named_with_its_line(profile):
    with pytest.raises(
        SettingError, match=r"ducts\.toml:\d+: head\.parts\.1\.cylinder\.bottom_mm: "
    ):
        Settings.load(load=[profile(-2)])


@pytest.mark.parametrize(
    ("change", "fault"),
    [
        ({"x_mm": [30, 12]}, "x_mm ends at 12, where it must lie beyond 30"),
        ({"y_mm": [4, 4]}, "y_mm ends at 4"),
        ({"shape": "ball"}, "shape"),
        ({"radius_mm": 4}, "unknown key"),
        ({"bottom_mm": 0}, "greater than or equal to 0.1"),
        ({"turn_deg": 1e9}, "less than or equal to 360"),
    ],
)
def test_no_part_that_none_can_be_is_taken(change, fault):
    with pytest.raises(SettingError, match=fault):
        settings_with(DUCT | change)


def test_no_more_parts_than_a_head_can_have():
    with pytest.raises(SettingError, match=r"head\.parts"):
        settings_with(*[DUCT] * 17)


# As the proof sees them.

#: A post 5 mm high at x = y = 0, then the tip at its foot's height somewhere beside it.
POST = """G28
M83
G1 X0 Y0 Z0.3 F1200
G1 Z5.3 E2 F600
G4 P2000
G0 Z20
G0 X{x} Y{y}
G0 Z{z}
G0 Z20
"""


@pytest.mark.parametrize(
    ("x", "y", "hits"),
    [(-20, 0, True), (20, 0, False), (-20, 9, False), (0, -25, True), (0, 25, False)],
)
def test_a_duct_hits_where_it_is_and_not_all_around(x, y, hits):
    judged = settings_with(DUCT, PROBE)
    found = wireprint.check(POST.format(x=x, y=y, z=1.3).encode(), judged)
    plain = wireprint.check(POST.format(x=x, y=y, z=1.3).encode(), Settings.load())
    assert not plain.collisions
    assert [hit.line for hit in found.collisions] == ([8, 9] if hits else [])
    if hits:
        bottom = 3 if x else 2
        assert found.collisions[0].depth_mm == pytest.approx(5.3 - 1.3 - bottom)


def test_a_file_carries_its_head_s_parts_and_is_judged_by_them(cube):
    judged = settings_with(DUCT, PROBE)
    made = make(load_mesh(cube, height_mm=8), judged)
    assert made.certificate.ok
    assert settings_in(made.gcode).printer.head == judged.printer.head
    assert wireprint.check(made.gcode).ok


def test_a_file_cannot_do_without_a_part_of_the_printer_that_it_names(monkeypatch):
    own = Settings.load()
    known = settings_with(DUCT, PROBE)
    told = (POST.format(x=-20, y=0, z=1.3) + _footer(own)).encode()
    assert wireprint.check(told).remarks == ()
    monkeypatch.setattr(Settings, "load", lambda *_, **__: known)
    found = wireprint.check(told)
    assert [hit.line for hit in found.collisions] == [8, 9]
    assert "no box x 12 to 30, y -8 to 8, 3 mm up" in found.remarks[0]
    assert "no cylinder of 4 mm" in found.remarks[0]


def test_a_file_may_bring_more_parts_than_the_printer_that_it_names():
    told = POST.format(x=-20, y=0, z=1.3) + _footer(settings_with(DUCT))
    assert wireprint.check(told.encode()).collisions


def _footer(settings):
    from wireprint.gcode.own_settings import block

    return block(settings) + "\n"


# As prints mind them.


def test_a_duct_beside_all_of_a_model_changes_nothing(cube):
    far = DUCT | {"x_mm": [22, 40]}
    height_mm = 20
    plain = make(load_mesh(cube, height_mm=height_mm), Settings.load())
    ducted = make(load_mesh(cube, height_mm=height_mm), settings_with(far))
    assert _moves(ducted.gcode) == _moves(plain.gcode)


def test_slabs_are_lower_where_a_duct_comes_over_them(cube):
    mesh = load_mesh(cube, height_mm=28)
    made = make(mesh, settings_with(DUCT))
    assert made.certificate.ok
    levels = [float(z) for z in re.findall(rb"^G1 .*Z([\d.]+)", made.gcode, re.M)]
    assert max(levels) == pytest.approx(28, abs=0.5)
    plain = make(mesh, Settings.load())
    assert made.wireframe.post_count > 1.3 * plain.wireframe.post_count
    assert made.figures()["coverage"] > 0.95


@pytest.mark.parametrize("printer", ["kossel-mini", "prusa-mk4s", "voron-2.4", "printrbot-simple"])
@pytest.mark.parametrize("seed", range(4))
def test_no_print_breaks_its_rules_with_parts_at_random(printer, seed):
    draw = random.Random(f"{printer} {seed}")
    parts = []
    while not parts:
        parts = random_heads.parts(draw)
    size_mm = np.inf
    while size_mm > 90:  # so that it fits all beds
        vertices, faces = random_parts.part(draw.randrange(500)).mesh()
        size_mm = np.ptp(vertices, axis=0).max()
    mesh = Mesh.from_arrays(vertices, faces.astype(np.int64))
    settings = Settings.load(printer, overrides=parts)
    made = make(mesh, settings, partial=True, compare=False)
    assert made.certificate.ok, parts


def test_a_head_with_parts_is_recalled_from_the_cache(profile, cube, tmp_path):
    for name in ("a", "b"):
        done = run("slice", cube, "--load", profile(2), "-o", tmp_path / f"{name}.gcode", "-q")
        assert done.exit_code in (0, 5), done.output
    assert (tmp_path / "a.gcode").read_bytes() == (tmp_path / "b.gcode").read_bytes()


def _moves(gcode):
    """Return the lines before the settings at a file's end, without comments."""
    lines = gcode.split(b"; wireprint_settings = begin")[0].splitlines()
    return [line for line in lines if not line.startswith(b";")]
