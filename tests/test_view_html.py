"""The page that turns in a browser: it holds everything, and it draws."""

import base64
import hashlib
import io
import re
import sys
from html.parser import HTMLParser
from pathlib import Path

import numpy as np
import pytest
from PIL import Image

from view_pages import held, told_by
from wireprint import examples, view
from wireprint._core import Strands
from wireprint.mesh import load_mesh
from wireprint.view_texels import STEPS, slabs_of, times_of

sys.path.insert(0, str(Path(__file__).parent / "studio"))

from studio_page import FLAGS, browser_or_skip, on_canvas, until

TEXT = b"""G90
M83
;TYPE:CONTOUR
G1 X40 Y0 Z5 E6.4 F1200
G0 X0 Y20 Z5
;TYPE:POST
G1 X40 Y20 Z30 E6.4
"""


@pytest.fixture
def strands():
    return Strands.from_gcode(TEXT)


def ends_of(head, arrays):
    """Return start and end of each strand as the page knows them, mm."""
    steps = arrays["strands"].view("<u2").reshape(-1, 8)[:, :6].reshape(-1, 2, 3)
    return np.array(head["low"]) + steps / STEPS * head["span"]


class Links(HTMLParser):
    """Everything that a browser would load."""

    def __init__(self):
        super().__init__()
        self.found = []

    def handle_starttag(self, tag, attrs):
        self.found += [value for name, value in attrs if name in {"src", "href", "data", "action"}]


def test_a_page_loads_nothing(strands):
    links = Links()
    links.feed(view.render_html(strands))
    assert links.found
    assert all(link.startswith("data:") for link in links.found)


def test_the_policy_lets_nothing_be_loaded_and_runs_the_pages_own_program_alone(strands):
    page = view.render_html(strands)
    policy = re.search(r'Content-Security-Policy" content="(.*?)"', page)[1]
    rules = dict(rule.strip().split(" ", 1) for rule in policy.split(";"))
    assert rules["default-src"] == "'none'"
    assert rules["img-src"] == "data: blob:"
    loader = re.search(r"<script type=module>(.*?)</script>", page, re.S)[1].encode()
    hashes = [
        f"'sha256-{base64.b64encode(hashlib.sha256(text).digest()).decode()}'"
        for text in (loader, held(page, "program"))
    ]
    assert rules["script-src"].split() == hashes
    assert rules.keys() == {
        "default-src",
        "script-src",
        "style-src",
        "img-src",
        "base-uri",
        "form-action",
    }


def test_coordinates_arrive_within_a_step(strands):
    head, arrays = told_by(view.render_html(strands))["print"]
    # From the middle of a bed of whole centimetres that has room for both.
    sent = ends_of(head, arrays) + np.array([20, 10, 0])
    assert len(sent) == 2
    wanted = strands.segments
    assert np.abs(sent - wanted).max() <= np.array(head["span"]).max() / STEPS


def test_diameters_arrive_within_a_step(strands):
    head, arrays = told_by(view.render_html(strands))["print"]
    sent = arrays["strands"].view("u1").reshape(-1, 16)[:, 13] * head["diameter_step_mm"]
    assert np.abs(sent - strands.diameters).max() <= head["diameter_step_mm"]


def test_the_legend_has_a_line_for_each_kind_and_travels_come_where_asked_for(strands):
    head, arrays = told_by(view.render_html(strands, travels=True))["print"]
    assert [row["name"] for row in head["labels"]] == ["contour", "post"]
    kinds = arrays["strands"].view("u1").reshape(-1, 16)[:, 12]
    assert kinds.tolist() == [0, 1]
    assert (arrays["travels"].reshape(-1, 6) + [20, 10, 0] * 2).tolist() == [[40, 0, 5, 0, 20, 5]]
    assert arrays["after"].tolist() == [1]
    assert "travels" not in told_by(view.render_html(strands))["print"][1]


def test_only_the_kinds_asked_for_are_sent(strands):
    head, arrays = told_by(view.render_html(strands, kinds=["post"]))["print"]
    assert len(arrays["strands"]) == 1
    assert [row["name"] for row in head["labels"]] == ["post"]


def test_a_file_tells_its_times_and_totals(tmp_path):
    from wireprint import estimate

    path = tmp_path / "x.gcode"
    path.write_bytes(TEXT)
    head, arrays = told_by(view.render_html(path))["print"]
    planned = estimate(path, per_move=True)
    assert head["timed"]
    assert head["total_s"] == planned.total_s == head["figures"]["print_time_s"]
    assert head["figures"]["filament_g"] == planned.filament_g
    moves = planned.per_move
    done = dict(zip(moves.line.tolist(), np.cumsum(moves.duration_s), strict=True))
    assert arrays["when"][:, 1].tolist() == pytest.approx([done[4], done[7]])
    assert arrays["speed"][0] == pytest.approx(40.3 / done[4], rel=0.01)


def test_strands_without_a_text_count_by_their_order(strands):
    head, arrays = told_by(view.render_html(strands))["print"]
    assert not head["timed"]
    assert head["figures"] == {}
    assert arrays["when"].tolist() == [[0, 1], [1, 2]]
    assert head["total_s"] == 2


def test_a_print_of_ours_has_the_bed_and_the_head_of_its_printer(cube_gcode):
    from wireprint import Settings

    head, _ = told_by(view.render_html(cube_gcode))["state"]
    printer = Settings.load().printer
    assert head["printer"] == printer.name
    assert head["bed"]["size_mm"] == list(printer.bed.size_mm)
    assert head["head"]["slant_deg"] == printer.head.slant_deg


def test_a_file_that_names_no_printer_stands_on_a_bed_that_fits(tmp_path):
    path = tmp_path / "x.gcode"
    path.write_bytes(TEXT)
    head, _ = told_by(view.render_html(path))["state"]
    assert head["head"] is None
    assert head["bed"] == {"round": False, "size_mm": [60, 40], "high": 0}


@pytest.mark.parametrize("word", [b";LAYER_CHANGE", b"; CHANGE_LAYER", b";LAYER:7"])
def test_layers_of_every_program_are_slabs(word):
    text = b"\n".join([b"G28", word, b"G1 X1 E1", b"G1 X2 E1", word, b"G1 X3 E1", b""])
    assert slabs_of(text, np.array([3, 4, 6])).tolist() == [0, 0, 1]


def test_chords_of_an_arc_share_the_time_of_its_line():
    rows, durations = np.array([1, 2, 2, 3], np.uint64), np.array([1.0, 2.0, 4.0, 1.0])
    begin, end = times_of(rows, durations, np.array([2, 2, 2, 3]))
    assert begin.tolist() == [1, 3, 5, 7]
    assert end.tolist() == [3, 5, 7, 8]


def test_a_mark_is_told_where_it_is(strands):
    head, _ = told_by(view.render_html(strands, breaches=[(1, 2, 3)], weak=[(4, 5, 6)]))["print"]
    assert [one["at_mm"] for one in head["breaches"]] == [[-19, -8, 3]]
    assert head["weak"] == [[-16, -5, 6]]


def test_a_hostile_title_stays_text(strands):
    title = "</script><script>alert(1)</script><!-- $DATA $PROGRAM"
    page = view.render_html(strands, title=title)
    plain = view.render_html(strands, title="")
    assert page.count("</script>") == plain.count("</script>")
    assert page.count("<!--") == plain.count("<!--")
    assert told_by(page)["welcome"][0]["name"] == title
    assert "<title>&lt;/script&gt;" in page


def test_fifty_thousand_strands_make_a_page_of_about_a_megabyte():
    angles = np.arange(50_001) * 0.1
    points = np.stack([30 * np.cos(angles), 30 * np.sin(angles), angles / 50], axis=1)
    segments = np.stack([points[:-1], points[1:]], axis=1)
    strands = Strands.from_arrays(segments, np.zeros(50_000, np.uint16), ["contour"], 0.7)
    assert len(view.render_html(strands)) < 1.7e6


def test_the_page_of_a_picture_holds_it_for_browsers_that_cannot_draw(strands):
    page = view.render_html(strands)
    still = re.search(r'id="still" alt=".*?" src="data:image/png;base64,(.*?)"', page)[1]
    picture = Image.open(io.BytesIO(base64.b64decode(still)))
    assert picture.size == (960, 720)
    assert len(picture.getcolors(1 << 20)) > 20


# --- in a browser


@pytest.fixture(scope="module")
def launch():
    playwright = pytest.importorskip("playwright.sync_api")
    path = browser_or_skip()
    with playwright.sync_playwright() as player:
        yield lambda *flags: player.chromium.launch(executable_path=path, args=list(flags))


@pytest.fixture(scope="module")
def browser(launch):
    launched = launch(*FLAGS)
    yield launched
    launched.close()


@pytest.fixture(scope="module")
def cube_gcode(tmp_path_factory):
    import wireprint

    folder = tmp_path_factory.mktemp("view")
    (folder / "cube.stl").write_bytes(examples.stl("cube"))
    settings = wireprint.Settings.load()
    made = wireprint.make(wireprint.load_mesh(folder / "cube.stl"), settings)
    (folder / "cube.gcode").write_bytes(made.gcode)
    return folder / "cube.gcode"


class Opened:
    """A page of a file, what it asked for and what it complained of."""

    def __init__(self, browser, path, **context):
        self.page = browser.new_context(**context).new_page()
        self.requests, self.faults = [], []
        self.page.on("request", lambda request: self.requests.append(request.url))
        self.page.on("pageerror", lambda error: self.faults.append(str(error)))
        self.page.on(
            "console",
            lambda said: said.type in ("error", "warning") and self.faults.append(said.text),
        )
        self.url = path.as_uri() + "?debug"
        self.page.goto(self.url)


@pytest.fixture
def opened(browser, cube_gcode, tmp_path):
    path = tmp_path / "page.html"
    view.render_html(cube_gcode, path, travels=True)
    found = Opened(browser, path, viewport={"width": 1000, "height": 600})
    until(found.page, "document.querySelector('.wireprint')?.dataset.drawn > 0")
    yield found
    found.page.context.close()


def test_a_page_turns_plays_colours_and_cuts_and_asks_nobody(opened):
    page = opened.page
    count = page.evaluate("store.strandCount.value")
    page.evaluate("store.timeS.value = store.totalS.value / 2")
    shown = page.evaluate("store.shownStrands.value")
    assert 0 < shown < count
    assert page.evaluate("studio.view.head.visible")
    page.keyboard.press("Space")
    until(page, f"store.shownStrands.value > {shown}")
    page.keyboard.press("Space")
    page.get_by_label("slabs shown").fill("0")
    assert page.evaluate("store.slab.value") == 0
    for mode in ("time", "speed", "slab", "feature"):
        page.get_by_label("colour by").select_option(mode)
        until(page, f"store.mode.value === '{mode}'")
    before = page.evaluate("studio.view.camera.position.toArray().join()")
    x, y = on_canvas(page, 0, 0, 10)
    page.mouse.move(x, y)
    page.mouse.down()
    page.mouse.move(x + 60, y + 20, steps=4)
    page.mouse.up()
    assert page.evaluate("studio.view.camera.position.toArray().join()") != before
    assert page.evaluate("studio.view.renderer.getContext().getError()") == 0
    assert opened.faults == []
    assert [url for url in opened.requests if not url.startswith(("data:", "blob:"))] == [
        opened.url
    ]
    # Nothing can be changed here.
    assert page.get_by_label("Print as layers").count() == 0
    page.keyboard.press("b")
    assert page.evaluate("store.tool.value") == "turn"


def test_a_page_works_on_a_phone(browser, cube_gcode, tmp_path):
    path = tmp_path / "page.html"
    view.render_html(cube_gcode, path)
    opened = Opened(browser, path, viewport={"width": 390, "height": 780}, has_touch=True)
    page = opened.page
    until(page, "document.querySelector('.wireprint')?.dataset.drawn > 0")
    assert page.evaluate("document.documentElement.scrollWidth") == 390
    colours = page.get_by_label("colour by")
    assert not colours.is_visible()
    page.get_by_role("button", name="colours and figures").click()
    colours.wait_for(state="visible")
    page.context.close()


def test_a_model_with_marks_is_drawn(browser, tmp_path):
    (tmp_path / "cube.stl").write_bytes(examples.stl("cube"))
    cube = load_mesh(tmp_path / "cube.stl")
    path = tmp_path / "page.html"
    view.render_html(cube, path)
    opened = Opened(browser, path)
    until(opened.page, "document.querySelector('.wireprint')?.dataset.faces > 0")
    assert opened.page.evaluate("document.querySelector('.wireprint').dataset.faces") == str(
        len(cube.faces)
    )
    assert opened.faults == []
    opened.page.context.close()


def test_without_webgl_the_picture_stays(launch, cube_gcode, tmp_path):
    path = tmp_path / "page.html"
    view.render_html(cube_gcode, path)
    browser = launch("--no-sandbox", "--disable-3d-apis")
    opened = Opened(browser, path)
    page = opened.page
    until(page, "document.querySelector('.wireprint')?.dataset.drawn > 0")
    still = page.get_by_role("img", name="model and print").and_(page.locator("img"))
    still.wait_for(state="visible")
    assert still.evaluate("(img) => img.naturalWidth") == 960
    page.get_by_text("has no WebGL 2").wait_for()
    browser.close()
