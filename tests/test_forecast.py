"""The forecast: a model of heat, weight and pull on any G-code; no part of the certificate."""

import base64
import html
import json
import math
import re
import subprocess
import sys
import zlib
from itertools import pairwise

import numpy as np
import pytest

import wireprint
from command import run
from wireprint import Settings, _core, examples, forecast_terms, load_mesh, make, simulate
from wireprint.forecast_scales import scale_of
from wireprint.forecast_words import figure, sentences, unknown
from wireprint.regions import Box, Region, ZRange

RULES = ["holds", "sags", "meets", "flows", "knots", "welds", "grips"]


def gcode(*lines):
    return "\n".join(["M83", "G1 X0 Y0 Z0.35 F1800", *lines]).encode()


def post(height_mm=5.0, pause_s=0.0, before=()):
    """One post on a strand that lies on the bed, left after a pause."""
    rise = f"G1 Z{0.35 + height_mm} E{height_mm * 0.16}"
    return gcode("G1 X20 E3.2", *before, rise, f"G4 P{1000 * pause_s:.0f}", "G1 Z20")


def bridge(length_mm, *, before=()):
    """A level strand between two walls of strands, 4 mm up."""
    walls = []
    for x in (0, length_mm):
        for layer in range(8):
            z = 0.35 + 0.5 * layer
            walls += [
                f"G1 X{x} Y-5 F6000",
                f"G1 Z{z}",
                "G1 Y5 E1.6 F1800",
                f"G1 Z{z + 3}",
            ]
    top = 0.35 + 0.5 * 7 + 0.5
    return gcode(
        *walls,
        "G1 X0 Y0 F6000",
        f"G1 Z{top}",
        *before,
        f"G1 X{length_mm} E{length_mm * 0.16} F1800",
        "G1 Z20",
    )


@pytest.fixture(scope="module")
def prints(tmp_path_factory):
    """G-code of some examples for two printers."""
    folder = tmp_path_factory.mktemp("forecast")
    found = {}
    for name in ("cube", "bottle"):
        model = folder / f"{name}.stl"
        model.write_bytes(examples.stl(name))
        for printer, material in (("kossel-mini", "abs"), ("prusa-mk4s", "pla")):
            settings = Settings.load(printer, material)
            found[name, printer] = make(load_mesh(model), settings, compare=False).gcode
    return found


def test_a_longer_pause_holds_a_post_better():
    air = ["M42 P6 S255"]
    leans = [
        simulate(post(pause_s=pause, before=air)).rules["holds"].worst
        for pause in (0.0, 0.5, 1.0, 2.0, 10.0)
    ]
    assert all(a >= b for a, b in pairwise(leans))
    assert leans[0] > 0.35 > leans[-1]


def test_a_verdict_is_sure_only_where_half_or_twice_the_time_does_not_matter():
    air = ["M42 P6 S255"]
    verdicts = [
        simulate(post(pause_s=pause, before=air)).rules["holds"].verdict for pause in (0.1, 1, 5)
    ]
    assert verdicts == ["fails", "unsure", "passes"]


def test_air_that_is_on_holds_and_carries():
    still, blown = (simulate(post(pause_s=1.5, before=air)) for air in ([], ["M42 P6 S255"]))
    assert still.rules["holds"].worst > 2 * blown.rules["holds"].worst
    still, blown = (simulate(bridge(28, before=air)) for air in ([], ["M42 P6 S255"]))
    assert still.rules["sags"].worst > 2 * blown.rules["sags"].worst
    assert "no air blows there" in sentences(still)[1]


def on_a_bridge(height_mm, pause_s):
    """A post in the middle of a strand between two tall, cold posts."""
    up, over = f"G1 Z{height_mm} E{0.16 * height_mm}", f"G0 Z{height_mm + 3}"
    posts = [up, "G4 P20000", over, "G0 X30", "G0 Z0.35", up, "G4 P20000", "G1 X20 E1.6"]
    top = ["G4 P20000", over, "G0 X25", f"G0 Z{height_mm}", f"G1 Z{height_mm + 4} E0.64"]
    return gcode("M42 P6 S255", "G1 X20 E3.2", *posts, *top, f"G4 P{1000 * pause_s:.0f}", "G0 Z40")


@pytest.mark.parametrize(
    ("printed", "blows"),
    [
        (lambda pause_s: post(pause_s=pause_s), False),
        (lambda pause_s: post(pause_s=pause_s, before=["M42 P6 S255"]), True),
        (lambda pause_s: on_a_bridge(9, pause_s), True),
    ],
)
def test_the_pause_that_is_advised_holds(printed, blows):
    """Also where the air is never switched on, and on what gives way itself."""
    told = sentences(simulate(printed(0.2)))[0]
    advised = float(re.search(r"--pause ([0-9.]+)\)", told)[1])
    assert ("never blows" in told) != blows
    assert simulate(printed(0.8 * advised)).rules["holds"].over > 0
    assert simulate(printed(advised)).rules["holds"].over == 0


def test_long_stretches_sag_more_and_the_worst_is_where_it_is():
    sags = [simulate(bridge(length)).rules["sags"] for length in (10, 20, 40)]
    assert sags[0].worst < sags[1].worst < sags[2].worst
    assert sags[2].place_mm[0] == pytest.approx(20, abs=1)
    assert 36 < sags[2].length_mm <= 40


def test_a_dwell_without_pressure_advance_makes_a_knot_and_starves_what_follows():
    lines = ["G1 X20 E3.2", "G1 X40 E3.2", "G4 P1000", "G1 X45 E0.8"]
    bowden = simulate(gcode(*lines))
    assert bowden.rules["knots"].worst > 0.35
    assert bowden.flow_share[-1] < 0.8
    advanced = simulate(gcode("M900 K0.4", *lines))
    assert advanced.rules["knots"].worst is None
    assert advanced.flow_share[-1] == pytest.approx(1)
    unknown = Settings.load(overrides=["extruder.pressure_lag_s=0"])
    silent = simulate(gcode(*lines), unknown)
    assert silent.rules["flows"].verdict == "not judged"
    assert "pressure_lag_s is 0" in sentences(silent)[3]


def test_what_is_laid_on_a_warm_strand_welds_better():
    def of(dwell_ms):
        return simulate(
            gcode("G1 X20 E3.2", "G1 Z2", f"G4 P{dwell_ms}", "G1 X10 Y-5 Z0.8", "G1 Y5 E1.6")
        )

    warm, cold = of(100), of(60000)
    assert warm.weld[-1] > cold.weld[-1]
    assert warm.temperature_c[-1] > cold.temperature_c[-1]
    assert cold.age_s[-1] == pytest.approx(60, abs=2)
    assert np.isnan(cold.weld[0]), "the bed is no strand"


def test_every_strand_has_its_figures_and_nobody_may_change_them(prints):
    for text in prints.values():
        found = simulate(text)
        count = len(found.line)
        for values in (
            found.age_s,
            found.temperature_c,
            found.sag_mm,
            found.compliance_mm_n,
            found.flow_share,
            found.weld,
        ):
            assert values.shape == (count,)
            assert not values.flags.writeable
            assert np.nanmin(values) >= 0
        assert found.ends_mm.shape == (count, 2, 3)
        assert list(found.rules) == RULES


def test_the_same_text_gets_the_same_forecast(prints):
    for text in prints.values():
        one, other = simulate(text), simulate(text)
        assert one.to_dict() == other.to_dict()
        np.testing.assert_array_equal(one.sag_mm, other.sag_mm)


def test_contours_of_the_cube_hardly_sag_in_air_jets(prints):
    """Once 0.84 mm, when no air blew along contours."""
    assert simulate(prints["cube", "kossel-mini"]).rules["sags"].worst <= 0.2


def test_what_we_write_gets_its_material(prints):
    """Pressure advance, or what is pulled back before a dwell, sees to that."""
    for (name, _), text in prints.items():
        found = simulate(text)
        assert found.rules["flows"].over <= 0.1 * found.rules["flows"].of, name
        assert found.rules["knots"].over == 0, name


def test_it_is_no_part_of_the_certificate_and_says_so(cube, tmp_path):
    target = tmp_path / "cube.gcode"
    plain = json.loads(run("slice", cube, "-o", target, "--json").stdout)
    assert "forecast" not in plain
    figures = json.loads(run("slice", cube, "-o", target, "--json", "--forecast").stdout)
    told = figures["forecast"]
    assert told["trust"] == "uncalibrated"
    assert told["part_of_certificate"] is False
    assert figures["certified"] is True
    assert list(told["rules"]) == RULES
    assert {"file": str(target), **told} == json.loads(run("simulate", target, "--json").stdout)
    words = run("slice", cube, "-o", target, "--forecast").stdout
    assert "no part of the certificate" in words
    assert "  holds: " not in run("slice", cube, "-o", target).stdout


def test_a_slice_without_a_forecast_loads_nothing_of_it(cube, tmp_path):
    """So it takes as long as before; `benches/forecast_cost.py` measures that."""
    code = (
        "import sys\nfrom wireprint.cli import main\n"
        f"main(['slice', {str(cube)!r}, '-o', {str(tmp_path / 'c.gcode')!r}, '-q'], "
        "standalone_mode=False)\nprint(*sorted(sys.modules))"
    )
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    loaded = set(done.stdout.split())
    assert "wireprint.pipeline" in loaded
    forecasts = {"forecast", "forecast_terms", "stiffening", "softness", "frames", "grip"}
    assert not loaded & {f"wireprint.{name}" for name in forecasts}
    assert not any(name.startswith("scipy.sparse") for name in loaded)


def test_the_command_says_a_sentence_for_each_rule_and_what_it_does_not_know(cube, tmp_path):
    target = tmp_path / "cube.gcode"
    run("slice", cube, "-o", target, "-q")
    result = run("simulate", target)
    assert result.exit_code == 0
    lines = result.stdout.splitlines()
    assert "uncalibrated" in lines[0]
    assert [line.split(":")[0].strip() for line in lines[1:8]] == RULES
    assert lines[8] == "  What this forecast does not know:"
    assert "may be half or twice as large" in lines[9]
    still = run("simulate", target, "--set", "cooling.method=none")
    assert still.exit_code == 0
    assert "would lean" in still.stdout


def test_other_printers_and_materials_can_be_asked_for(cube, tmp_path):
    target = tmp_path / "cube.gcode"
    run("slice", cube, "-o", target, "-q")
    told = json.loads(run("simulate", target, "--json", "--material", "pla").stdout)
    assert (told["printer"], told["material"]) == ("kossel-mini", "pla")
    told = json.loads(run("simulate", target, "--json", "--printer", "voron-2.4").stdout)
    assert told["printer"] == "voron-2.4"


@pytest.mark.parametrize("colour", ["sag", "compliance", "flow", "weld"])
def test_a_page_shows_strands_in_colours(cube, tmp_path, colour):
    target, page = tmp_path / "cube.gcode", tmp_path / "cube.html"
    run("slice", cube, "-o", target, "-q")
    run("simulate", target, "--html", page, "--colour", colour)
    text = page.read_text()
    assert "uncalibrated" in text
    parts = re.findall(r"(?<![\w+/])eN[\w+/]{200,}=*", text)
    told = [zlib.decompress(base64.b64decode(part)) for part in parts]
    assert any(b'"more than' in part and b'"no ' + colour.encode() in part for part in told)
    found = simulate(target)
    scale = scale_of(found, colour)
    assert any(f'"coloured_by":"{scale.name}"'.encode() in part for part in told)
    worst = f"more than {scale.written(scale.edges[-1])} {scale.unit}"
    assert any(worst.encode() in part for part in told)
    assert "What this forecast does not know" in text
    words = [*sentences(found), *unknown(found.judge.settings)]
    assert [html.unescape(one) for one in re.findall("<li>(.*?)</li>", text)] == words


@pytest.mark.parametrize("colour", ["sag", "compliance", "flow", "weld"])
def test_view_draws_the_same_colours(cube, tmp_path, colour):
    target, picture, page = (tmp_path / name for name in ("c.gcode", "c.png", "c.html"))
    run("slice", cube, "-o", target, "-q")
    result = run("view", target, "-o", picture, "--colour", colour, "--size", "400x300")
    assert result.exit_code == 0, result.stderr
    assert picture.read_bytes().startswith(b"\x89PNG")
    run("view", target, "-o", page, "--colour", colour)
    own = tmp_path / "own.html"
    run("simulate", target, "--html", own, "--colour", colour)
    assert page.read_bytes() == own.read_bytes()


def test_a_model_has_no_forecast_to_be_coloured_by(cube, tmp_path):
    result = run("view", cube, "-o", tmp_path / "c.png", "--colour", "sag")
    assert result.exit_code != 0
    assert "slice the model first" in result.stderr


def test_a_text_that_ends_on_a_post_is_forecast():
    """What is never left is as cold as can be."""
    tower = [f"G1 X{20 * (i % 2)} Z{0.35 + 0.5 * i:.2f} E1" for i in range(40)]
    for text in (gcode("G1 X20 E3.2", "G1 Z5 E1"), gcode(*tower), gcode("G1 Z5 E1 F0.001")):
        found = simulate(text)
        json.dumps(found.to_dict(), allow_nan=False)


def test_what_is_no_gcode_is_refused(tmp_path):
    path = tmp_path / "model.stl"
    path.write_bytes(examples.stl("cube"))
    result = run("simulate", path)
    assert result.exit_code != 0
    assert str(path) in result.stderr
    with pytest.raises(wireprint.GcodeError):
        simulate(b"; nothing\n")


def test_a_frame_that_is_too_much_work_is_not_judged(monkeypatch, prints):
    monkeypatch.setattr(forecast_terms, "MOST_WORK", 10.0)
    found = simulate(prints["cube", "kossel-mini"])
    assert found.rules["meets"].verdict == "not judged"
    assert "too much work" in sentences(found)[2]
    assert np.isnan(found.compliance_mm_n).all()


def test_layers_of_a_large_hybrid_are_taken_as_rigid(monkeypatch, cube):
    """Solids beside which wire is soft: what ends on it gives way nearly as before."""
    settings = Settings.load()
    region = Region().add(ZRange(high_mm=6)).add(Box(low_mm=(-20, -20, 20), high_mm=(20, 20, 22)))
    text = make(cube, settings, region, compare=False).gcode
    whole = simulate(text, settings)
    assert not whole.core.layers_rigid
    rigid, work = whole, 1e10
    while not rigid.core.layers_rigid:
        work /= 2
        monkeypatch.setattr(forecast_terms, "MOST_WORK", work)
        rigid = simulate(text, settings)
    assert rigid.core.frame_judged
    assert "layers taken as rigid" in sentences(rigid)[2]
    both = (rigid.compliance_mm_n > 0) & (whole.compliance_mm_n > 0)
    assert both.sum() > 40
    shares = rigid.compliance_mm_n[both] / whole.compliance_mm_n[both]
    assert 0.7 < np.median(shares) <= 1.001
    monkeypatch.setattr(forecast_terms, "MOST_WORK", 1.0)
    assert simulate(text, settings).rules["meets"].verdict == "not judged"


def infilled(side_mm, layers, posts):
    """Layers of another program: walls, an infill whose lines cross, and posts on the last."""
    lines = ["; generated by PrusaSlicer", "M83", "G1 F1800"]

    def stroke(start, end, z):
        length = math.dist(start, end)
        lines.append(f"G0 X{start[0]:.3f} Y{start[1]:.3f} Z{z:.3f}")
        lines.append(f"G1 X{end[0]:.3f} Y{end[1]:.3f} E{0.03 * length:.5f}")

    corners = [(0, 0), (side_mm, 0), (side_mm, side_mm), (0, side_mm), (0, 0)]
    for layer in range(layers):
        z = 0.2 * (layer + 1)
        for start, end in pairwise(corners):
            stroke(start, end, z)
        for at in np.arange(4.0, side_mm, 4.0):
            ends = [(at, 0), (at, side_mm)]
            stroke(*(ends if layer % 2 else [end[::-1] for end in ends]), z)
    top = 0.2 * layers
    for x, y in corners[:posts]:
        lines += [
            f"G0 Z{top + 9:.3f}",
            f"G0 X{x} Y{y}",
            f"G0 Z{top:.3f}",
            f"G1 Z{top + 8:.3f} E0.5",
        ]
        lines += ["G4 P3000"]
    return "\n".join(lines).encode()


def test_layers_of_other_programs_are_rigid_with_infills_that_cross(monkeypatch):
    settings = Settings.load("prusa-mk4s", "pla")
    text = infilled(12, 8, posts=4)
    whole = simulate(text, settings)
    assert not whole.core.layers_rigid
    monkeypatch.setattr(forecast_terms, "MOST_WORK", 1e5)
    rigid = simulate(text, settings)
    assert rigid.core.frame_judged
    assert rigid.core.layers_rigid
    posts = whole.ends_mm[:, 1, 2] > 0.2 * 8 + 1
    assert posts.sum() == 4
    shares = rigid.compliance_mm_n[posts] / whole.compliance_mm_n[posts]
    assert (shares <= 1 + 1e-9).all()
    assert (shares > 0.8).all()


def test_long_files_of_layers_are_judged_as_blocks_without_being_asked_to():
    found = simulate(infilled(60, 30, posts=0), Settings.load("prusa-mk4s", "pla"))
    assert found.core.layers_rigid
    assert "layers are taken as rigid" in sentences(found)[2]


def test_the_papers_pause_is_advised():
    """30 mm/s, ABS of 0.7 mm, air jets: 1 s; and that beats 5 mm/s without."""
    settings = Settings.load(overrides=["air_mm_s.valve=6000"])
    matter = settings.material.matter(0.7)
    for length_mm in (2.0, 5.0, 11.0):
        assert 0.9 <= _core.holding_pause(matter, 6000, length_mm, 30, 0.01, 60) <= 1.3
    pause_s = _core.holding_pause(matter, 6000, 5.0, 30, 0.01, 60)
    assert 13.5 / 30 + pause_s < 13.5 / 5


@pytest.mark.parametrize("material", ["abs", "pla", "petg"])
@pytest.mark.parametrize("nozzle_mm", [0.4, 0.7])
def test_still_air_asks_for_three_times_the_pause_of_a_fan(material, nozzle_mm):
    matter = Settings.load(material=material).material.matter(nozzle_mm)
    still, fan = (_core.holding_pause(matter, air, 4.0, 30, 0.01, 60) for air in (0, 3000))
    assert still >= 3 * fan


def test_auto_is_the_pause_that_follows_and_a_number_stays():
    own = Settings.load()
    assert Settings.load(overrides=["wire.pause_s=auto"]).pause_s == own.pause_s == own.solidify_s
    assert Settings.load(overrides=["wire.pause_s=0.5"]).pause_s == 0.5
    kept = Settings.load(overrides=["wire.pause_s=0.5"])
    assert kept.but(overrides=["wire.pause_s=auto"]).pause_s == own.pause_s


def test_the_command_takes_a_pause(cube, tmp_path):
    def dwells(*options):
        target = tmp_path / "cube.gcode"
        run("slice", cube, "-o", target, "-q", *options)
        return set(re.findall(r"^G4 P(\d+)", target.read_text(), re.MULTILINE))

    assert dwells("--pause", "auto") == dwells()
    assert dwells("--pause", "2.5") != dwells()
    assert run("slice", cube, "-o", tmp_path / "x.gcode", "--pause", "soon").exit_code != 0


@pytest.mark.parametrize(
    ("value", "text"), [(0.8432, "0.84"), (12.34, "12"), (0.0123, "0.012"), (0, "0"), (1.04, "1.0")]
)
def test_figures_have_the_digits_that_they_are_good_for(value, text):
    assert figure(value) == text
    assert math.isclose(float(text), value, rel_tol=0.05)
