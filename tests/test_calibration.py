"""Calibration prints: certified, quick, and what they tell makes forecasts true."""

import math

import numpy as np
import pytest

import wireprint
from command import run
from wireprint import Settings, _core, simulate
from wireprint.calibration import bending, sphere
from wireprint.calibration.answers import SAG_WITHIN_MM, Answers, Held, Sag, read
from wireprint.calibration.fit import PRIORS, fitted
from wireprint.calibration.prints import printed
from wireprint.calibration.tents import STRANDS, pauses_s
from wireprint.forecast_terms import air_mm_s


@pytest.mark.parametrize("name", ["ladder", "harp", "mast", "sphere"])
@pytest.mark.parametrize("printer", ["kossel-mini", "prusa-mk4s", "voron-2.4", "printrbot-simple"])
@pytest.mark.parametrize("material", ["abs", "pla", "petg"])
def test_a_print_is_certified_and_takes_less_than_ten_minutes(name, printer, material):
    settings = Settings.load(printer, material)
    made = printed(name, settings)
    assert wireprint.check(made.gcode, settings).ok
    assert wireprint.estimate(made.gcode).total_s < 600
    assert all(word.encode() in made.gcode for word in made.words)


def test_a_ladder_has_twelve_tents_with_the_pauses_that_it_names():
    settings = Settings.load("prusa-mk4s", "pla")
    text = printed("ladder", settings).gcode.decode()
    held = [int(line[4:]) / 1000 for line in text.splitlines() if line.startswith("G4 P")]
    assert held == pytest.approx(pauses_s(settings), abs=1e-3)
    shares = [pause / settings.solidify_s for pause in held]
    assert shares[0] < 0.3
    assert shares[-1] > 3


def test_a_forecast_of_a_ladder_says_which_tents_lean():
    settings = Settings.load("kossel-mini", "abs")
    found = simulate(printed("ladder", settings).gcode).rules["holds"]
    assert found.of == 12
    assert 2 <= found.over <= 9


def test_what_does_not_fit_the_bed_is_refused(tmp_path):
    result = run("calibrate", "harp", "-o", tmp_path / "x.gcode", "--set", "bed.diameter_mm=40")
    assert result.exit_code != 0
    assert "no harp is certified" in result.stderr
    assert not (tmp_path / "x.gcode").exists()


def truth(settings, rng):
    """A machine as the priors say that it may be: what tells its pause and its sags."""
    matter = settings.material.matter(settings.strand_mm)
    air = air_mm_s(settings)
    blown, thick, drawn, hotter = (rng.standard_normal(4) * PRIORS).tolist()
    other = matter | {
        "glass_c": matter["glass_c"] + hotter,
        "melt_viscosity_pa_s": matter["melt_viscosity_pa_s"] * math.exp(thick),
        "draw": max(1.0, matter["draw"] + drawn),
    }
    speed = air * math.exp(blown)
    pause = _core.cooling_time(other, settings.material.holding_c + hotter, speed)
    return pause, lambda lengths, laid: _core.sags(other, speed, laid, list(lengths))


@pytest.mark.parametrize("seed", range(2))
def test_a_ladder_and_a_harp_recover_pause_and_sag(seed):
    rng = np.random.default_rng(seed)
    settings = Settings.load("prusa-mk4s", "pla")
    pause, sags = truth(settings, rng)
    measured = []
    for share, length in STRANDS:
        [sag] = sags([length], share * settings.print_mm_s)
        off = rng.uniform(-SAG_WITHIN_MM, SAG_WITHIN_MM)
        measured.append(Sag(length, share * settings.print_mm_s, max(0.0, sag + off)))
    told = max(0.01, pause + rng.uniform(-0.1, 0.1))
    held = Held("ladder", settings.print_mm_s, told, 0.1 / math.sqrt(3))
    found = fitted(settings, Answers("2026-11-27", (held,), tuple(measured)))
    assert abs(found.pause_s - pause) <= 0.15
    [true] = sags([20.0], settings.print_mm_s)
    assert abs(found.sags_mm[0][1] - true) <= 0.1
    assert found.pause_spread_s < 0.15
    # Before any print, a pause is known to about its own length.
    assert found.sags_mm[0][2] < 0.1


ANSWERS = """
date = 2026-11-27
[ladder]
first_standing = 8
[[harp]]
length_mm = 20
speed_mm_s = 30
sag_mm = 0.4
[[harp]]
length_mm = 60
speed_mm_s = 30
sag_mm = 1.8
"""


def test_what_was_fitted_is_used_and_said(cube, tmp_path):
    answers, mine = tmp_path / "answers.toml", tmp_path / "mine.toml"
    answers.write_text(ANSWERS)
    machine = ["--printer", "prusa-mk4s", "--material", "pla"]
    told = run("calibrate", "fit", answers, "-o", mine, *machine)
    assert told.exit_code == 0, told.stderr
    settings = Settings.load("prusa-mk4s", "pla", [mine])
    known = settings.calibrated_by()
    assert known.date == "2026-11-27"
    assert settings.pause_s == known.pause_s
    stands = pauses_s(settings)[7]
    assert stands / 1.25 - 0.1 < known.pause_s < stands + 0.1
    assert "viscosity" not in mine.read_text().replace("parameters", "")
    target = tmp_path / "cube.gcode"
    run("slice", cube, "-o", target, "-q", *machine, "--load", mine)
    found = simulate(target)
    assert found.trust == "calibrated"
    assert found.rules["holds"].calibrated
    assert found.rules["sags"].calibrated
    assert not found.rules["meets"].calibrated
    # Sags follow what the harp told.
    terms = found.judge.settings.calibrated_by().sags
    assert terms[0].length_mm == 20


def test_a_calibration_is_asked_for_by_name(cube, tmp_path):
    answers, mine, target = (tmp_path / name for name in ("a.toml", "mine.toml", "cube.gcode"))
    answers.write_text(ANSWERS)
    machine = ["--printer", "prusa-mk4s", "--material", "pla"]
    run("calibrate", "fit", answers, "-o", mine, *machine)
    run("slice", cube, "-o", target, "-q", *machine)
    assert "uncalibrated" in run("simulate", target).stdout.splitlines()[0]
    said = run("simulate", target, "--calibration", mine).stdout
    assert "; calibrated, " in said.splitlines()[0]
    assert "measured on 2026-11-27" in said


def test_it_holds_for_what_it_was_measured_with_alone(tmp_path):
    answers, mine = tmp_path / "answers.toml", tmp_path / "mine.toml"
    answers.write_text(ANSWERS)
    run("calibrate", "fit", answers, "-o", mine, "--printer", "prusa-mk4s", "--material", "pla")
    for change in ("head.nozzle_mm=0.6", "material.nozzle_c=220", "cooling.method=none"):
        other = Settings.load("prusa-mk4s", "pla", [mine], [change])
        assert other.calibrated_by() is None
        assert other.pause_s == other.solidify_s


@pytest.mark.parametrize(
    ("text", "word"),
    [
        ("", "date is missing"),
        ("date = 2026-11-27", "nothing was measured"),
        ("date = 2026-11-27\n[ladder]\nfirst_standing = 13", "1 to 12"),
        ("date = 2026-11-27\n[ladder]\nfirst_standing = true", "1 to 12"),
        ("date = 2026-11-27\nladder = 3", "1 to 12"),
        ("date = 2026-11-27\n[harp]\nsag_mm = 1", "two brackets"),
        ("date = 2026-11-27\n[[harp]]\nsag_mm = 1", "length_mm"),
        ("date = 2026-11-27\n[[harp]]\nlength_mm = 20\nspeed_mm_s = 30\nsag_mm = nan", "sag_mm"),
        ("date = 2026-11-27\nladdder = 3", "laddder is no answer"),
        ("date = ", "answers.toml"),
        (
            "date = 2026-11-27\n[[harp]]\nlength_mm = 1.57\nspeed_mm_s = 30\nsag_mm = 0.02",
            "in millimetres",
        ),
        (
            "date = 2026-11-27\n[[harp]]\nlength_mm = 20\nspeed_mm_s = 30\nsag_mm = 35",
            "from 0 to 10",
        ),
        ("date = 2026-11-27\n[mast]\nweight_g = 2.3\nlength_mm = 30", "drop_mm"),
        ("date = 2026-11-27\n[mast]\nweight_g = 2.3\nlength_mm = 30\ndrop_mm = 29", "nearer"),
        ("date = 2026-11-27\n[[sphere]]\nspeed_mm_s = 30", "pause_s"),
        ("date = 2026-11-27\n[sphere]\nspeed_mm_s = 30", "two brackets"),
        ("date = ''\n[ladder]\nfirst_standing = 7", "date is missing"),
        ("date = nan\n[ladder]\nfirst_standing = 7", "date is missing"),
        ("date = 2026-11-27\n[ladder]\nfirst_standing = 7\nsecond = 8", "second of the ladder"),
        (
            "date = 2026-11-27\n[[harp]]\nlength_mm = 20\nspeed_mm_s = 1800\nsag_mm = 0.3",
            "the print has 15, 30",
        ),
        (
            "date = 2026-11-27\n[mast]\nweight_g = 2.3\nlength_mm = 3\ndrop_mm = 0.7",
            "grams and millimetres",
        ),
        (
            "date = 2026-11-27\n[[sphere]]\nspeed_mm_s = 30\npause_s = 500",
            "pause_s of [[sphere]] number 1 is 500, and the print has",
        ),
        (
            "date = 2026-11-27\n[[harp]]\nlength_mm = 20\nspeed_mm_s = 30\nsag_mm = 1\n"
            f"[[harp]]\nlength_mm = 20\nspeed_mm_s = 30\nsag_mm = {400 * '9'}",
            "sag_mm of [[harp]] number 2 is 9999999999999999999999999999999999999999…; it must",
        ),
        (
            "date = 2026-11-27\n" + 41 * "[[sphere]]\nspeed_mm_s = 30\npause_s = 1\n",
            "40 are enough",
        ),
        (
            "date = 2026-11-27\n[ladder]\nfirst_standing = 8\n"
            "[[harp]]\nlength_mm = 60\nspeed_mm_s = 30\nsag_mm = 0.3\n"
            "[[harp]]\nlength_mm = 20\nspeed_mm_s = 30\nsag_mm = 9",
            "the sag of 20 mm at 30 mm/s cannot be",
        ),
    ],
)
def test_answers_that_say_nothing_are_refused(tmp_path, text, word):
    path = tmp_path / "answers.toml"
    path.write_text(text)
    result = run("calibrate", "fit", path, "-o", tmp_path / "mine.toml")
    assert result.exit_code != 0
    assert word in result.stderr
    assert "answers.toml" in result.stderr
    assert not (tmp_path / "mine.toml").exists()


def test_a_bed_that_is_too_small_is_what_is_named(tmp_path):
    result = run("calibrate", "harp", "-o", tmp_path / "h.gcode", "--set", "bed.diameter_mm=20")
    assert result.exit_code != 0
    assert "larger bed" in result.stderr
    assert not (tmp_path / "h.gcode").exists()


@pytest.mark.parametrize("date", ['27. 11. "26"', "a\\b", "<i>", "[calibration]", "# no"])
def test_whatever_a_date_says_the_file_can_be_loaded(tmp_path, date):
    answers, mine = tmp_path / "answers.toml", tmp_path / "mine.toml"
    answers.write_text(f"date = '{date}'\n[ladder]\nfirst_standing = 7\n")
    result = run("calibrate", "fit", answers, "-o", mine)
    assert result.exit_code == 0, result.stderr
    assert Settings.load(load=[mine]).calibrated_by().date == date


def test_a_ladders_answer_lies_between_two_tents(tmp_path):
    path = tmp_path / "answers.toml"
    path.write_text("date = '2026-11-27'\n[ladder]\nfirst_standing = 5")
    settings = Settings.load()
    answers = read(path, settings)
    low, high = pauses_s(settings)[3:5]
    assert low < answers.pauses[0].pause_s < high
    assert answers.sags == ()


@pytest.mark.parametrize(("length_mm", "weight_g"), [(60, 1.0), (30, 2.3), (20, 0.2)])
def test_a_masts_drop_tells_how_stiff_its_strand_is(length_mm, weight_g):
    """A coin of 1 g pulls the end of 60 mm of ABS of 0.7 mm down by 27 mm, less as it bends on."""
    stiff = bending.of_strand(0.7, 2200)
    drop_mm = bending.drop_mm(weight_g, length_mm, stiff)
    assert bending.stiffness_n_mm2(weight_g, length_mm, drop_mm) == pytest.approx(stiff, rel=1e-9)
    small = weight_g / 1000 * bending.GRAVITY_M_S2 * length_mm**3 / (3 * stiff)
    assert 0.8 * small < drop_mm < small


def test_a_far_bent_strand_is_the_elastica():
    """Bisshopp & Drucker 1945, table: a load of W·L²/EI = 1 drops the end by 0.302 lengths."""
    stiff = 1.0
    weight_g = 1000 / bending.GRAVITY_M_S2
    assert bending.drop_mm(weight_g, 1.0, stiff) == pytest.approx(0.3017, abs=2e-4)
    assert bending.drop_mm(10 * weight_g, 1.0, stiff) == pytest.approx(0.8106, abs=2e-4)


def test_a_mast_makes_the_frame_as_stiff_as_it_was(cube, tmp_path):
    answers, mine, target = (tmp_path / name for name in ("a.toml", "mine.toml", "cube.gcode"))
    settings = Settings.load()
    half = bending.of_strand(settings.strand_mm, settings.material.modulus_mpa) / 2
    drop_mm = bending.drop_mm(2.3, 25, half)
    answers.write_text(
        f"date = 2026-11-27\n[mast]\nweight_g = 2.3\nlength_mm = 25\ndrop_mm = {drop_mm:.6f}\n"
    )
    told = run("calibrate", "fit", answers, "-o", mine)
    assert "N·mm²" in told.stdout, told.stderr
    run("slice", cube, "-o", target, "-q")
    plain, soft = (simulate(target, one) for one in (settings, settings.but(load=[mine])))
    both = ~np.isnan(plain.compliance_mm_n) & (plain.compliance_mm_n > 0)
    shares = soft.compliance_mm_n[both] / plain.compliance_mm_n[both]
    assert shares == pytest.approx(np.full(len(shares), 2.0), rel=1e-3)
    # The pull stays unknown.
    assert not soft.rules["meets"].calibrated


def test_each_sphere_has_its_speed_and_its_pause():
    settings = Settings.load("prusa-mk4s", "pla")
    text = printed("sphere", settings).gcode.decode()
    held = {round(int(line[4:]) / 1000, 2) for line in text.splitlines() if line.startswith("G4 P")}
    assert {round(pause, 2) for pause in sphere.pauses_s(settings)} <= held
    feeds = {word for line in text.splitlines() for word in line.split() if word.startswith("F")}
    assert {f"F{60 * speed:.0f}" for speed in sphere.speeds_mm_s(settings)} <= feeds


def test_spheres_tell_the_pause_as_a_ladder_does(tmp_path):
    path = tmp_path / "answers.toml"
    settings = Settings.load()
    short, long = sphere.pauses_s(settings)[1:]
    path.write_text(
        "date = 2026-11-27\n"
        f"[[sphere]]\nspeed_mm_s = 30\npause_s = {long:.2f}\n"
        f"[[sphere]]\nspeed_mm_s = 5\npause_s = {sphere.pauses_s(settings)[0]:.2f}\n"
    )
    answers = read(path, settings)
    assert short < answers.pauses[0].pause_s < long
    assert answers.pauses[1].pause_s < answers.pauses[0].pause_s
    found = fitted(settings, answers)
    assert 0.7 * short < found.pause_s < 1.2 * long


def test_answers_that_contradict_each_other_tell_less():
    settings = Settings.load("prusa-mk4s", "pla")
    speed = settings.print_mm_s

    def told(*pauses):
        held = tuple(Held("ladder", speed, pause, 0.05) for pause in pauses)
        return fitted(settings, Answers("2026-11-27", held, ()))

    alike, unlike = told(1.2, 1.2), told(0.5, 1.9)
    assert alike.misfit < 1 < 2.5 < unlike.misfit
    assert unlike.pause_spread_s > 2.5 * alike.pause_spread_s
