"""A budget in place of settings: what is chosen keeps within it, and nothing tried is better."""

import io
import json
from itertools import combinations
from types import SimpleNamespace

import pytest
from click.testing import CliRunner
from hypothesis import given
from hypothesis import settings as settings_of_hypothesis
from hypothesis import strategies as st
from PIL import Image, ImageDraw

import wireprint
from wireprint import cli, examples
from wireprint.budget import Alternative, Budget, BudgetError, chart, within
from wireprint.budget import search as searching
from wireprint.budget.axis import Axis
from wireprint.budget.search import Search


@pytest.fixture(scope="module")
def sphere(tmp_path_factory):
    path = tmp_path_factory.mktemp("models") / "sphere.stl"
    path.write_bytes(examples.stl("sphere"))
    return wireprint.load_mesh(path, scale=0.5)


@pytest.fixture(scope="module")
def settings():
    return wireprint.Settings.load()


@pytest.fixture(scope="module")
def found(sphere, settings):
    return within(sphere, settings, Budget(time_s=300))


def cost(one):
    return one.deviation_mm * one.give_mm


def test_it_keeps_within_the_budget_and_is_certified(found):
    assert found.chosen.within
    assert found.made.estimate.total_s <= 300
    assert found.made.certificate.ok
    assert found.made.estimate.total_s == pytest.approx(found.chosen.print_time_s)


def test_nothing_on_the_front_that_keeps_within_is_better(found):
    inside = [one for one in found.front if one.within]
    assert min(map(cost, inside)) == pytest.approx(cost(found.chosen))
    assert not any(a.beats(b) for a in found.front for b in found.front)
    assert found.tried <= searching.MOST_TRIED


def test_more_time_is_never_worse(sphere, settings, found):
    more = within(sphere, settings, Budget(time_s=600))
    assert cost(more.chosen) <= cost(found.chosen)
    assert more.chosen.deviation_mm < found.chosen.deviation_mm


def test_the_same_budget_gives_the_same_bytes(sphere, settings, found):
    assert within(sphere, settings, Budget(time_s=300)).made.gcode == found.made.gcode


def test_what_is_printed_is_what_its_settings_print(sphere, settings, found):
    again = wireprint.make(sphere, settings.but(overrides=found.chosen.overrides))
    assert again.gcode == found.made.gcode


def test_filament_is_a_budget_too(sphere, settings):
    found = within(sphere, settings, Budget(filament_g=1.2))
    assert found.chosen.filament_g <= 1.2


def test_too_small_a_budget_is_refused_with_the_least_there_is(sphere, settings):
    with pytest.raises(
        BudgetError, match=r"the least that is certified, of \d+ that were tried"
    ) as refused:
        within(sphere, settings, Budget(time_s=60))
    sets = [word for word in str(refused.value).split() if word.startswith("wire.")]
    made = wireprint.make(sphere, settings.but(overrides=[one.rstrip(");") for one in sets]))
    assert wireprint.make(sphere, settings).estimate.total_s >= made.estimate.total_s > 60


def test_what_is_set_stays_as_it_is(sphere):
    own = wireprint.Settings.load(overrides=["wire.slab_max_mm=5", "wire.cap_spacing_mm=4"])
    found = within(sphere, own, Budget(time_s=600), kept={"wire.pattern"})
    assert found.made.settings.slab_max_mm == 5
    assert found.made.settings.wire.cap_spacing_mm == 4
    assert found.made.settings.wire.pattern == "zigzag"


@pytest.mark.parametrize("wrong", [0, -1, float("nan"), float("inf")])
def test_a_budget_is_positive(wrong):
    with pytest.raises(wireprint.SettingError, match="must be positive"):
        Budget(time_s=wrong)


def run(*arguments):
    return CliRunner().invoke(cli.main, ["slice", *map(str, arguments)])


def test_the_command_tells_table_picture_and_json(cube, tmp_path):
    out, picture = tmp_path / "a.gcode", tmp_path / "a.png"
    arguments = [cube, "-o", out, "--time", "2min30s", "--alternatives"]
    told = run(*arguments, "--alternatives-picture", picture)
    assert told.exit_code == 0, told.output
    assert "→" in told.output
    assert picture.read_bytes().startswith(b"\x89PNG")
    figures = json.loads(run(*arguments, "--json").stdout)
    assert "budget" in figures, figures
    assert figures["budget"]["time_s"] == 150
    (chosen,) = [one for one in figures["budget"]["alternatives"] if one["chosen"]]
    assert chosen["print_time_s"] == figures["print_time_s"] <= 150


@pytest.mark.parametrize(
    ("text", "seconds"),
    [
        ("20min", 1200),
        ("1h30min", 5400),
        ("90s", 90),
        ("1:30:00", 5400),
        ("20:00", 1200),
        ("2m", 120),
    ],
)
def test_times_are_read_as_people_write_them(text, seconds):
    from wireprint.cli.budget import Duration

    assert Duration().convert(text, None, None) == seconds


@pytest.mark.parametrize(
    "arguments",
    [
        ("--time", "20"),
        ("--time", "soon"),
        ("--time", "0s"),
        ("--filament", "5"),
        ("--alternatives",),
    ],
)
def test_what_is_no_budget_is_refused(cube, tmp_path, arguments):
    told = run(cube, "-o", tmp_path / "a.gcode", *arguments)
    assert told.exit_code == 2
    assert not (tmp_path / "a.gcode").exists()


def test_less_than_any_rung_of_the_ladder_is_looked_for(sphere, settings):
    search = Search(sphere, settings, Budget(time_s=1.0), None, frozenset())
    with pytest.raises(BudgetError):
        search.best_of_all()
    rungs = {tuple(sorted(knobs.items())) for knobs in search._ladder()}
    times = {tuple(sorted(one.knobs.items())): one.print_time_s for one in search._timed()}
    least_s = min(time_s for knobs, time_s in times.items() if knobs in rungs)
    less = within(sphere, settings, Budget(time_s=0.97 * least_s))
    assert less.chosen.print_time_s <= 0.97 * least_s
    assert less.made.certificate.ok


figures = st.floats(1e-3, 1e5)


@given(values=st.lists(figures, min_size=1, max_size=9))
def test_an_axis_has_few_round_ticks_about_all_values(values):
    for axis in (Axis.of_numbers(values), Axis.of_times(values)):
        assert axis.low <= min(values) <= max(values) <= axis.high
        assert 2 <= len(axis.ticks) <= 7
        texts = [f"{tick:.{axis.decimals}f}" for tick in axis.ticks]
        assert [float(text) for text in texts] == pytest.approx(axis.ticks, rel=1e-9, abs=1e-9)
        assert len(set(texts)) == len(texts)
        # A good part of the room is used, down to what a tick can tell.
        assert axis.high - axis.low < 4 * max(max(values) - min(values), 0.1 * max(values), 1)
    times = Axis.of_times(values)
    assert all(tick == round(tick) for tick in times.ticks)


one_figure = st.tuples(st.floats(40, 9000), st.floats(0.01, 2), st.floats(0.01, 3))


@given(
    figures=st.lists(one_figure, min_size=1, max_size=7),
    budget_s=st.none() | st.floats(40, 9000),
    title=st.sampled_from(["a.stl", f"{'long/' * 40}a.stl", "a\nb.stl", "杯.stl", ""]),
    data=st.data(),
)
@settings_of_hypothesis(max_examples=60, deadline=None)
def test_nothing_that_is_written_in_the_picture_lies_on_anything_else(
    figures, budget_s, title, data
):
    chosen = data.draw(st.integers(0, len(figures) - 1))
    front = [
        Alternative((), time_s, 1.0, off_mm, give_mm, 1.0, within=True, chosen=number == chosen)
        for number, (time_s, off_mm, give_mm) in enumerate(figures)
    ]
    found = SimpleNamespace(front=front, chosen=front[chosen], budget=Budget(time_s=budget_s))
    boxes = []
    write = ImageDraw.ImageDraw.text

    def noted(draw, at, text, fill, font, anchor):
        boxes.append(draw.textbbox(at, text, font, anchor=anchor))
        write(draw, at, text, fill, font, anchor=anchor)

    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(ImageDraw.ImageDraw, "text", noted)
        picture = Image.open(io.BytesIO(chart.png(found, title)))
    for left, top, right, bottom in boxes:
        assert left >= 0
        assert top >= 0
        assert right <= picture.width
        assert bottom <= picture.height
    for (a, b, c, d), (e, f, g, h) in combinations(boxes, 2):
        assert c <= e or g <= a or d <= f or h <= b
