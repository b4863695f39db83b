"""Measuring a head: four measures, a drawing, and a gauge that shows where a profile is wrong."""

import math
from pathlib import Path

import pytest

import wireprint
from command import run
from wireprint import SettingError, catalogue, cli
from wireprint.heads import drawing, profile
from wireprint.heads.gauge import Gauge, answered
from wireprint.heads.gauge_path import DIRECTIONS
from wireprint.heads.gauge_print import printed
from wireprint.heads.measures import MEASURES, measured
from wireprint.settings import Settings

ROOT = Path(__file__).parents[1]
PRINTERS = ["kossel-mini", "prusa-mk4s", "voron-2.4", "printrbot-simple"]


@pytest.fixture(scope="module")
def gauges():
    """The gauge of each printer, made once."""
    made = {}

    def of(printer):
        if printer not in made:
            settings = Settings.load(printer)
            made[printer] = settings, printed(settings)
        return made[printer]

    return of


def touched(settings, made, **figures):
    """Teeth and roofs beside which a head with other figures collides, by number."""
    head = settings.printer.head.model_copy(update=figures)
    wide = max(head.block_radius_mm, 60.0)
    head = head.model_copy(update={"block_radius_mm": wide, "carriage_radius_mm": wide})
    printer = settings.printer.model_copy(update={"head": head})
    found = wireprint.check(made.gcode, settings.model_copy(update={"printer": printer}))
    low = settings.first_layer_height_mm + head.nozzle_mm / 2 + 1e-3
    assert all(hit.tip_mm[2] < low for hit in found.collisions), "hit beside no tooth, no roof"
    gauge, teeth, roofs = made.gauge, set(), set()
    for hit in found.collisions:
        rise = hit.material_mm[2] - hit.tip_mm[2]
        apart = math.dist(hit.material_mm[:2], hit.tip_mm[:2])
        if rise < gauge.tooth_mm + 1e-3:
            beside = [abs(apart - gauge.beside_tooth_mm(angle)) for angle in gauge.teeth_deg]
            teeth.add(beside.index(min(beside)) + 1)
        else:
            over = [abs(rise - height) for height in gauge.roofs_mm]
            roofs.add(over.index(min(over)) + 1)
    return teeth, roofs


@pytest.mark.parametrize("printer", PRINTERS)
def test_a_gauge_is_certified_for_the_head_that_it_supposes_and_no_other(gauges, printer):
    settings, made = gauges(printer)
    own = wireprint.check(made.gcode)
    assert own.ok
    assert own.remarks == ()
    named = wireprint.check(made.gcode, settings)
    assert len(named.collisions) == made.beyond > 0
    assert [rule for rule, found in named.breaches().items() if found] == ["collisions"]


@pytest.mark.parametrize("printer", PRINTERS)
def test_all_that_the_profile_s_own_head_touches_is_said_to_go_beyond_it(gauges, printer):
    settings, made = gauges(printer)
    head, gauge = settings.printer.head, made.gauge
    teeth, roofs = touched(settings, made)
    assert all(gauge.teeth_deg[number - 1] > head.slant_deg for number in teeth)
    assert all(gauge.roofs_mm[number - 1] > head.cone_height_mm for number in roofs)
    assert teeth
    assert roofs


@pytest.mark.parametrize("printer", PRINTERS)
def test_the_last_free_tooth_and_roof_tell_the_true_head(gauges, printer):
    settings, made = gauges(printer)
    gauge = made.gauge
    for number, angle in enumerate(gauge.teeth_deg[1:], start=2):
        teeth, _ = touched(settings, made, slant_deg=angle)
        assert all(one > number for one in teeth)
        # Half a strand may reach into a head of the proof; so far behind comes the first collision.
        flank = gauge.tooth_mm - math.tan(math.radians(angle)) * (
            gauge.beside_tooth_mm(gauge.teeth_deg[-1]) - settings.printer.head.tip_radius_mm
        )
        assert bool(teeth) == (flank > settings.printer.head.nozzle_mm / 2), angle
    strand = settings.printer.head.nozzle_mm
    for height in gauge.roofs_mm:
        _, roofs = touched(settings, made, cone_height_mm=height + 1e-3)
        beyond = [one for one in gauge.roofs_mm if one > height + strand / 2]
        assert roofs == {gauge.roofs_mm.index(one) + 1 for one in beyond}


@pytest.mark.parametrize("printer", PRINTERS)
def test_a_head_a_step_flatter_than_all_teeth_touches_nothing_but_in_descents(gauges, printer):
    settings, made = gauges(printer)
    teeth, _ = touched(settings, made, slant_deg=made.gauge.wary.slant_deg)
    assert teeth >= set(range(3, len(made.gauge.teeth_deg) + 1))


def gauge_or_fault(name):
    try:
        made = printed(Settings.load(name))
    except SettingError as error:
        return "by hand" if "by hand" in str(error) else str(error)
    return "certified" if wireprint.check(made.gcode).ok else "not certified"


def test_every_shipped_printer_has_a_gauge_or_is_told_to_measure_by_hand():
    for name in catalogue.names("printers"):
        assert gauge_or_fault(name) in ("certified", "by hand"), name


def test_a_tooth_is_tried_from_sides_and_corners_of_a_hexagon():
    seen = sorted({direction % 60 for direction in DIRECTIONS})
    assert seen == [15, 30, 45]


def test_parts_in_the_way_are_named_with_a_way_out():
    duct = 'head.parts=[{shape="box", x_mm=[8, 40], y_mm=[-40, 40], bottom_mm=1.5}]'
    with pytest.raises(SettingError, match=r"--set head\.parts=\[\]"):
        printed(Settings.load(overrides=[duct]))


@pytest.mark.parametrize(
    ("answer", "flank", "cone"), [("6,4", 32.0, 6.0), ("0,0", 44.5, 8.7), ("2,2", 22.0, 4.2)]
)
def test_an_answer_is_what_was_not_touched(answer, flank, cone):
    assert answered(Settings.load(), answer) == {"B": flank, "C": cone}


@pytest.mark.parametrize(
    ("answer", "fault"),
    [
        ("1,4", "even tooth 1"),
        ("4,1", "even roof 1"),
        ("40,1", "no tooth 40"),
        ("-1,2", "no tooth -1"),
        ("4", "TOOTH,ROOF"),
        ("a,b", "TOOTH,ROOF"),
    ],
)
def test_no_other_answer_is_taken(answer, fault):
    with pytest.raises(SettingError, match=fault):
        answered(Settings.load(), answer)


def test_an_angle_at_the_bound_has_teeth_within_the_bounds():
    for slant in (5, 85):
        head = Settings.load(
            overrides=[
                f"head.slant_deg={slant}",
                "head.block_radius_mm=80",
                "head.carriage_radius_mm=90",
            ]
        ).printer.head
        assert all(5 <= angle <= 85 for angle in Gauge.of(head).teeth_deg)


# The command.


def test_measures_are_told_with_what_they_mean_and_written_as_an_heir(tmp_path):
    target = tmp_path / "mine.toml"
    words = ["--tip-mm", "0.8", "--flank-deg", "40", "--cone-height-mm", "5"]
    done = run("profiles", "head", *words, "-o", target)
    assert done.exit_code == 0, done.output
    assert "slabs       up to 5.00 mm high (before: 6.00 mm)" in done.output
    settings = Settings.load(str(target))
    head = settings.printer.head
    assert (head.tip_radius_mm, head.slant_deg, head.cone_height_mm) == (0.4, 40, 5)
    assert head.block_radius_mm == Settings.load().printer.head.block_radius_mm
    assert settings.printer.name == "mine"
    again = run("profiles", "head", "--flank-deg", "41", "-o", target)
    assert again.exit_code == 4
    assert "--update" in again.stderr
    assert Settings.load(str(target)).printer.head.slant_deg == 40


def test_an_update_changes_the_head_and_no_other_line(tmp_path):
    target = tmp_path / "own.toml"
    text = (
        "# mine\ninherits = 'voron-2.4'\nname = \"own\"  # so called\n\n[speeds]\nprint_mm_s = 20\n"
        "[head]\n# by hand\nslant_deg = 33\n"
    )
    target.write_text(text)
    done = run(
        "profiles", "head", "--printer", target, "--flank-deg", "36", "--tip-mm", "0.8",
        "-o", target, "--update",
    )  # fmt: skip
    assert done.exit_code == 0, done.output
    changed = target.read_text().splitlines()
    kept = [line for line in text.splitlines() if line != "slant_deg = 33"]
    assert [line for line in changed if line in kept] == kept
    assert len(changed) == len(kept) + 2
    assert Settings.load(str(target)).printer.head.slant_deg == 36


@pytest.mark.parametrize("text", ["head = { slant_deg = 33 }\n", "[ head ]\nslant_deg = 33\n"])
def test_a_head_that_is_written_otherwise_is_updated_or_left_alone(text, tmp_path):
    target = tmp_path / "own.toml"
    target.write_text("inherits = 'voron-2.4'\n" + text)
    before = target.read_bytes()
    words = ["--printer", target, "--flank-deg", "36", "-o", target, "--update"]
    done = run("profiles", "head", *words)
    if done.exit_code:
        assert "put slant_deg = 36.0 there yourself" in done.stderr
        assert target.read_bytes() == before
    else:
        assert Settings.load(str(target)).printer.head.slant_deg == 36


def test_a_file_s_printer_is_written_whole(tmp_path):
    source, target = tmp_path / "a.toml", tmp_path / "b.toml"
    source.write_bytes(catalogue.find("printers", "prusa-mk4s").read_bytes())
    done = run("profiles", "head", "--printer", source, "--flank-deg", "36", "-o", target)
    assert done.exit_code == 0, done.output
    source.unlink()
    assert Settings.load(str(target)).printer.head.slant_deg == 36


def test_a_head_that_is_none_is_refused(tmp_path):
    target = tmp_path / "mine.toml"
    done = run("profiles", "head", "--flank-deg", "6", "--cone-height-mm", "30", "-o", target)
    assert done.exit_code == 4
    assert "measure B, C and D again" in done.stderr
    assert not target.exists()


def test_the_gauge_is_written_with_its_list(tmp_path):
    target = tmp_path / "gauge.gcode"
    done = run("profiles", "gauge", "--printer", "voron-2.4", "-o", target)
    assert done.exit_code == 0, done.output
    header = target.read_text().split("\n\n\n")[0]
    for line in ("; tooth 6: 32.5 deg, beyond the profile", "; roof 1: 3.5 mm"):
        assert line in header.splitlines()
    assert run("check", target).exit_code == 0
    told = run("check", target, "--printer", "voron-2.4")
    assert told.exit_code == 1


def test_an_update_of_nothing_is_refused(tmp_path):
    done = run("profiles", "head", "-o", tmp_path / "mine.toml")
    assert done.exit_code == 4
    assert "nothing was measured" in done.stderr


# The drawing.


def test_the_drawing_of_the_page_is_the_one_that_is_drawn():
    committed = (ROOT / "docs" / "pictures" / "head.svg").read_text(encoding="utf-8")
    assert committed == drawing.svg(Settings.load().printer.head)


@pytest.mark.parametrize("shape", ["svg", "text"])
def test_a_drawing_names_every_measure_with_its_figure(shape):
    head = Settings.load("prusa-mk4s").printer.head
    drawn = getattr(drawing, shape)(head)
    text = drawn if isinstance(drawn, str) else "\n".join(drawn)
    for one in MEASURES:
        assert one.words in text
        assert f"{one.of(head):g} {one.unit}" in text


def test_parts_are_drawn_where_they_are():
    part = '{shape="box", x_mm=[5, 15], y_mm=[-5, 5], bottom_mm=3, turn_deg=180}'
    head = Settings.load(overrides=[f"head.parts=[{part}]"]).printer.head
    (seen,) = [line for line in drawing.svg(head).splitlines() if "fill-opacity" in line]
    scale = 250 / head.block_radius_mm
    assert f'x="{330 - 15 * scale:.1f}"' in seen
    assert f'width="{10 * scale:.1f}"' in seen


def test_a_carriage_grows_with_what_it_must_hold():
    _, figures = measured(Settings.load(), {"block_radius_mm": 50.0})
    assert figures["carriage_radius_mm"] >= 50
    assert profile.new("kossel-mini", "mine", figures, "measured").count("# measured") == 2


def test_an_answer_that_no_head_can_have_is_asked_for_again(tmp_path, monkeypatch):
    answers = iter(["abc", "-1", "0.3", "nan", "1,1", "95", "31", "", "25"])
    monkeypatch.setattr("click.termui.visible_prompt_func", lambda _: next(answers))
    monkeypatch.setattr("sys.stdin", type("Terminal", (), {"isatty": lambda _: True})())
    monkeypatch.setattr("sys.stdout.isatty", lambda: True, raising=False)
    target = tmp_path / "mine.toml"
    cli.main(
        ["profiles", "head", "--printer", "prusa-mk4s", "-o", str(target)], standalone_mode=False
    )
    head = Settings.load(str(target)).printer.head
    assert (head.tip_radius_mm, head.slant_deg, head.block_radius_mm) == (0.55, 31, 25)
    assert head.cone_height_mm == Settings.load("prusa-mk4s").printer.head.cone_height_mm


@pytest.mark.parametrize("option", ["--tip-mm=-1", "--flank-deg=95", "--tip-mm=nan"])
def test_an_option_that_no_head_can_have_is_named_by_its_letter(option):
    result = run("profiles", "head", "--printer", "prusa-mk4s", option)
    assert result.exit_code == 4
    assert "but must lie within" in result.stderr
