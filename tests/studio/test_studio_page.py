"""The window in a browser: it paints, plays, sets, exports, and can be used by all."""

import io
import itertools
import os
from pathlib import Path

import numpy as np
import pytest
from PIL import Image
from studio_page import Window, drag, exported, on_canvas, settled, until

from command import run
from wireprint import examples

ROOT = Path(__file__).parents[2]
FRONT = -14.0


@pytest.fixture(scope="module")
def one_window(browser, cube_stl):
    opened = Window(browser, cube_stl)
    yield opened
    opened.close()


@pytest.fixture
def window(one_window):
    """A window on a cube in which nothing was done; one process serves all tests."""
    yield one_window
    one_window.clear()


@pytest.fixture
def page(window):
    return window.page()


@pytest.fixture
def own_window(browser, cube):
    """A window of the test's own, whose model it may change."""
    opened = Window(browser, cube)
    yield opened
    opened.close()


def pixels(page):
    return Image.open(io.BytesIO(page.screenshot())).convert("RGB")


def hue(page, place_mm):
    """Hue (0–255) and saturation of the median pixel about a place of the scene."""
    x, y = on_canvas(page, *place_mm)
    patch = pixels(page).crop((int(x) - 4, int(y) - 4, int(x) + 5, int(y) + 5))
    values = sorted(hsv(patch), key=lambda one: one[1])
    return values[len(values) // 2][:2]


def hsv(picture):
    """Return hue, saturation and value of each pixel, 0–255."""
    return np.asarray(picture.convert("HSV")).reshape(-1, 3).astype(int).tolist()


def along_the_front(z_mm):
    return [(x, FRONT, z_mm) for x in range(-8, 9, 4)]


def test_the_page_asks_this_machine_alone_and_says_no_fault(window):
    page = window.page()
    settled(page)
    assert window.requests
    assert all(
        url.startswith((f"http://127.0.0.1:{window.port}/", "data:", "blob:"))
        for url in window.requests
    )
    assert window.faults == []
    assert page.evaluate("location.search + location.hash") == "?debug"
    assert page.evaluate("document.referrer") == ""


def test_the_pages_files_are_small():
    files = (ROOT / "python/wireprint/window/static").iterdir()
    assert sum(file.stat().st_size for file in files) <= 900_000


def test_paint_is_seen_at_once_and_its_layers_after_the_answer(page):
    page.keyboard.press("1")
    settled(page)
    page.keyboard.press("w")
    page.keyboard.press("b")
    bare = hue(page, (0, FRONT, 14))
    drag(page, along_the_front(14), release=False)
    page.mouse.move(*on_canvas(page, 8, FRONT, 14))
    page.evaluate("new Promise((done) => setTimeout(done, 300))")
    paint = hue(page, (0, FRONT, 14))
    assert bare[1] < 40 < paint[1]
    assert 175 <= paint[0] <= 205  # violet
    page.mouse.up()
    until(page, "store.state.value.items.length === 1")
    settled(page)
    page.keyboard.press("w")
    settled(page)
    layers = hue(page, (0, FRONT, 14))
    assert layers[1] > 40
    assert 175 <= layers[0] <= 205
    names = page.evaluate("store.print.value.labels.map((one) => one.label)")
    assert "layer-wise" in names


def test_the_file_is_that_of_slice_and_undo_and_redo_give_its_bytes(page, cube_stl, tmp_path):
    page.keyboard.press("1")
    page.keyboard.press("b")
    settled(page)
    plain = exported(page)
    drag(page, along_the_front(12))
    until(page, "store.state.value.items.length === 1")
    settled(page)
    painted = exported(page)
    strokes = tmp_path / "strokes.json"
    strokes.write_bytes(exported(page, "strokes"))
    page.keyboard.press("Control+z")
    until(page, "store.state.value.items.length === 0")
    settled(page)
    assert exported(page) == plain
    page.keyboard.press("Control+Shift+z")
    until(page, "store.state.value.items.length === 1")
    settled(page)
    assert exported(page) == painted
    out = tmp_path / "out.gcode"
    assert run("slice", cube_stl, "--fill-file", strokes, "-o", out).exit_code == 0
    assert out.read_bytes() == painted
    assert b";TYPE:LAYER-WISE" in painted


def test_an_eraser_takes_paint_away(page):
    page.keyboard.press("1")
    page.keyboard.press("b")
    settled(page)
    drag(page, along_the_front(14))
    until(page, "store.state.value.items.length === 1")
    settled(page)
    page.keyboard.press("e")
    for _ in range(4):
        page.keyboard.press("]")
    drag(page, along_the_front(14))
    until(page, "store.state.value.items.length === 2")
    settled(page)
    names = page.evaluate("store.print.value.labels.map((one) => one.label)")
    assert "layer-wise" not in names
    assert page.evaluate("store.state.value.items[1].erase")


def test_beside_the_model_and_with_alt_a_drag_turns(page):
    page.keyboard.press("1")
    page.keyboard.press("b")
    settled(page)
    where = "studio.view.camera.position.toArray().map((mm) => Math.round(mm)).join()"
    before = page.evaluate(where)
    drag(page, [(-25, FRONT, 14), (-40, FRONT, 14)])
    beside = page.evaluate(where)
    assert beside != before
    page.keyboard.press("1")
    settled(page)
    page.keyboard.down("Alt")
    drag(page, along_the_front(14))
    page.keyboard.up("Alt")
    assert page.evaluate(where) != before
    assert page.evaluate("store.state.value.items.length") == 0


def test_the_timeline_shows_what_lies_there_by_then_and_the_slabs_hide_what_is_above(page):
    page.keyboard.press("1")
    page.keyboard.press("m")
    settled(page)
    half = page.evaluate("store.timeS.value = store.totalS.value / 2")
    shown = page.evaluate("store.shownStrands.value")
    begun = page.evaluate(
        f"Array.from(studio.view.strands.when).filter((s, i) => i % 2 === 0 && s < {half}).length"
    )
    assert 0 < shown == begun < page.evaluate("store.strandCount.value")
    assert page.evaluate("studio.view.strands.geometry.drawRange.count") == 6 * begun
    page.evaluate("store.timeS.value = Infinity")
    top = (0, FRONT, 26.0)
    settled(page)

    def inked(place_mm):
        x, y = on_canvas(page, *place_mm)
        patch = pixels(page).crop((int(x) - 60, int(y) - 12, int(x) + 60, int(y) + 12))
        return sum(one[1] > 60 for one in hsv(patch))

    assert inked(top) > 50
    page.evaluate("store.slab.value = 1")
    settled(page)
    assert inked(top) == 0
    low = page.evaluate("store.print.value.slabs_mm[1]")
    assert inked((0, FRONT, low / 2)) > 50


def test_strands_are_drawn_as_they_relax_and_as_commanded_again(page):
    until(page, "store.rest.value !== null")
    drawn = "studio.view.strands.geometry.drawRange.count / 6"
    kept = "studio.view.strands.material.uniforms.strands.value.image.data.slice(0, 4000).join()"
    commanded = page.evaluate(drawn), page.evaluate(kept)
    assert commanded[0] == page.evaluate("store.strandCount.value")
    page.get_by_label("strands relaxed to chords").check()
    relaxed = page.evaluate(drawn), page.evaluate(kept)
    assert relaxed[0] == page.evaluate("studio.view.strands.relaxed.of.length")
    assert relaxed[1] != commanded[1]
    # The timeline goes by strands: of those that are not laid, nothing is drawn.
    page.evaluate("store.timeS.value = store.totalS.value / 2")
    shown = page.evaluate("store.shownStrands.value")
    assert page.evaluate(drawn) == page.evaluate(
        f"studio.view.strands.relaxed.of.filter((strand) => strand < {shown}).length"
    )
    page.evaluate("store.timeS.value = Infinity")
    page.get_by_label("strands relaxed to chords").uncheck()
    assert (page.evaluate(drawn), page.evaluate(kept)) == commanded


def test_it_plays_to_the_end_and_shows_the_head_meanwhile(page):
    page.evaluate("store.rate.value = 300; store.timeS.value = store.totalS.value / 2")
    settled(page)
    assert page.evaluate("studio.view.head.visible")
    page.keyboard.press("Space")
    until(page, "!store.playing.value && store.timeS.value === Infinity")
    assert not page.evaluate("studio.view.head.visible")


def test_arrows_go_by_strands_and_by_slabs(page):
    count = page.evaluate("store.strandCount.value")
    page.keyboard.press("ArrowLeft")
    assert page.evaluate("store.shownStrands.value") == count - 1
    page.keyboard.press("ArrowRight")
    assert page.evaluate("store.shownStrands.value") == count
    page.keyboard.press("Shift+ArrowLeft")
    shown = page.evaluate("store.shownStrands.value")
    slab = "studio.view.strands.slabOf"
    assert page.evaluate(f"{slab}({shown} - 1) < {slab}({count} - 1)")


#: Key → what is true after it, and not before; Escape after each.
KEYS = {
    "b": "store.tool.value === 'fill'",
    "e": "store.tool.value === 'erase'",
    "v": "store.tool.value === 'turn'",
    "m": "!studio.view.surface.visible",
    "w": "!studio.view.strands.visible",
    "[": "store.radiusMm.value < 5",
    "]": "store.radiusMm.value === 5",
    "?": "document.querySelector('dialog[open]') !== null",
    "n": "store.toast.value?.words === 'nothing is wrong or missing'",
    "Space": "store.playing.value",
}
#: Key → direction that the view is from.
VIEWS = {"1": (0, -1, 0), "3": (1, 0, 0), "7": (0, 0, 1), "5": (0.52, -0.74, 0.42)}
#: Keys of the list that other tests press.
ELSEWHERE = {"Alt drag", "← →", "Ctrl Z", "Ctrl E", "Ctrl S", "Delete", "Esc"}


def test_keys_do_what_the_list_says(page):
    for key, expression in KEYS.items():
        assert not page.evaluate(expression), key
        page.keyboard.press(key)
        until(page, expression)
        page.keyboard.press("Escape")
    for key, direction in VIEWS.items():
        page.keyboard.press(key)
        until(
            page,
            "studio.view.camera.position.clone().sub(studio.view.controls.target).normalize()"
            f".distanceTo({{ x: {direction[0]}, y: {direction[1]}, z: {direction[2]} }}) < 0.02",
        )


def test_every_key_of_the_list_is_pressed_in_a_test(page):
    page.keyboard.press("?")
    page.get_by_role("dialog").wait_for()
    told = set(page.locator("dl.keys kbd").all_inner_texts())
    pressed = {key if key == "Space" else key.upper() for key in [*KEYS, *VIEWS]}
    assert told >= ELSEWHERE
    assert {key for line in told - ELSEWHERE for key in line.split()} == pressed


def test_delete_deletes_the_chosen_mark_and_escape_lets_it_go(page):
    for count in (1, 2):
        page.evaluate("void studio.shape('box')")
        until(page, f"store.state.value.items.length === {count}")
    until(page, "store.selected.value === store.state.value.items[1].number")
    kept = page.evaluate("store.state.value.items[0].number")
    page.keyboard.press("Delete")
    until(page, "store.state.value.items.length === 1")
    assert page.evaluate("store.state.value.items[0].number") == kept
    page.evaluate(f"store.selected.value = {kept}")
    page.keyboard.press("Escape")
    assert page.evaluate("store.selected.value") is None
    page.keyboard.press("Delete")
    settled(page)
    assert page.evaluate("store.state.value.items.length") == 1


def test_a_mark_is_made_and_a_file_exported_by_keyboard_alone(page):
    for _ in range(60):
        page.keyboard.press("Tab")
        if page.evaluate("document.activeElement.textContent.trim()") == "heights":
            break
    page.keyboard.press("Enter")
    until(page, "store.state.value.items.length === 1")
    settled(page)
    with page.expect_download() as download:
        page.keyboard.press("Control+e")
    assert b";TYPE:LAYER-WISE" in download.value.path().read_bytes()
    with page.expect_download() as download:
        page.keyboard.press("Control+s")
    assert download.value.suggested_filename == "cube.3mf"


def test_escape_closes_the_menu_of_exports(page):
    page.get_by_label("more to export").press("Enter")
    entry = page.get_by_role("menuitem", name="Strokes (JSON)")
    entry.wait_for()
    entry.focus()
    page.keyboard.press("Escape")
    entry.wait_for(state="hidden")
    assert page.evaluate("document.activeElement.tagName") == "SUMMARY"


def test_handles_move_a_shape(page):
    page.keyboard.press("1")
    settled(page)
    page.evaluate("void studio.shape('z')")
    until(page, "store.selected.value !== null")
    settled(page)
    high = page.evaluate("store.state.value.items[0].shape.high_mm")
    drag(page, [(0, 0, high), (0, 0, high + 5)])
    until(page, f"store.state.value.items[0].shape.high_mm > {high} + 4")
    assert page.evaluate("store.state.value.items[0].shape.high_mm") == pytest.approx(
        high + 5, abs=0.5
    )


def test_a_setting_is_found_set_refused_and_taken_back(page):
    until(page, "store.fields.value.length > 0")
    page.get_by_label("search settings").fill("skirt rings")
    page.get_by_label("skirt rings", exact=True).fill("3")
    page.keyboard.press("Enter")
    until(page, "store.state.value.settings['wire.skirt_rings'] === 3")
    settled(page)
    page.get_by_label("skirt rings", exact=True).fill("99")
    page.keyboard.press("Enter")
    page.get_by_text("less than or equal to 20").wait_for()
    assert page.evaluate("store.state.value.settings['wire.skirt_rings']") == 3
    page.get_by_label("take the profile's skirt rings").click()
    until(page, "store.state.value.settings['wire.skirt_rings'] === 1")


def test_a_printer_and_a_material_are_chosen(page):
    page.get_by_label("printer").select_option("voron-2.4")
    until(page, "store.state.value.printer === 'voron-2.4'")
    page.get_by_label("material").select_option("pla")
    until(page, "store.state.value.material === 'pla'")
    settled(page)
    assert b"voron-2.4, pla" in exported(page)


def test_a_model_that_is_saved_anew_is_shown_and_marks_stay(own_window, cube):
    page = own_window.page()
    page.evaluate("void studio.shape('box')")
    until(page, "store.state.value.items.length === 1")
    cube.write_bytes(examples.stl("sphere"))
    until(page, "store.model.value.size_mm[0] > 70")
    settled(page)
    assert page.evaluate("store.state.value.items.length") == 1
    cube.write_bytes(b"solid nothing")
    page.get_by_text("the old one is shown").wait_for()
    assert page.evaluate("store.strandCount.value") > 0
    cube.unlink()
    page.get_by_text("cube.stl is gone").wait_for()


def test_half_a_million_strands_are_taken(window):
    page = window.page()
    settled(page)
    error = page.evaluate(
        """() => {
            const { strands } = studio.view, count = 500_000;
            const print = store.print.value;
            const packed = new Uint32Array(4 * count), when = new Float32Array(2 * count);
            for (let i = 0; i < count; i++) {
                const [x, y, z] = [7919, 104729, 611953].map((prime) => (i * prime) % 65000);
                packed.set([x | y << 16, z | x + 500 << 16, y | z << 16, 0x0a02], 4 * i);
                when.set([i, i + 1], 2 * i);
            }
            strands.take(print, packed, when, new Float32Array(count));
            strands.showUntil(Infinity);
            studio.view.draw(1);
            return studio.view.renderer.getContext().getError();
        }"""
    )
    assert error == 0
    assert window.faults == []


def axe_or_skip():
    found = os.environ.get("WIREPRINT_AXE") or ROOT / "web/node_modules/axe-core/axe.min.js"
    if not Path(found).is_file():
        pytest.skip("needs axe-core: npm ci in web/, or WIREPRINT_AXE")
    return Path(found).read_text(encoding="utf-8")


@pytest.mark.parametrize("scheme", ["light", "dark"])
def test_axe_finds_nothing_serious(window, scheme):
    axe = axe_or_skip()
    page = window.page(color_scheme=scheme)
    until(page, "store.fields.value.length > 0")
    page.evaluate("void studio.shape('box')")
    until(page, "store.state.value.items.length === 1")
    settled(page)
    page.evaluate(axe)
    found = page.evaluate("axe.run().then((found) => found.violations)")
    serious = [
        (one["id"], [node["html"][:120] for node in one["nodes"]])
        for one in found
        if one["impact"] in ("serious", "critical")
    ]
    assert serious == []


@pytest.mark.parametrize(("width", "height"), [(390, 780), (780, 390)])
def test_all_of_the_model_and_the_tools_stay_in_view_when_a_window_is_made_small(
    page, width, height
):
    page.set_viewport_size({"width": width, "height": height})
    canvas = "document.querySelector('canvas')"
    aspect = f"{canvas}.clientWidth / {canvas}.clientHeight"
    until(page, f"innerWidth === {width} && studio.view.camera.aspect === {aspect}")
    settled(page)
    stage = page.locator("canvas").bounding_box()
    for corner in itertools.product((-14, 14), (-14, 14), (0, 28)):
        x, y = on_canvas(page, *corner)
        assert stage["x"] < x < stage["x"] + stage["width"]
        assert stage["y"] < y < stage["y"] + stage["height"]
    for tool in page.locator(".tool").all():
        tool.scroll_into_view_if_needed()
        assert tool.is_visible()
    assert page.evaluate("document.documentElement.scrollWidth") == width


def test_on_a_phone_the_panel_is_a_drawer(window):
    page = window.page(width=390, height=780, has_touch=True)
    settled(page)
    assert page.evaluate("document.documentElement.scrollWidth") == 390
    panel = page.get_by_label("colour by")
    assert not panel.is_visible()
    page.get_by_role("button", name="settings and marks").click()
    panel.wait_for(state="visible")
    page.keyboard.press("Escape")
    panel.wait_for(state="hidden")
