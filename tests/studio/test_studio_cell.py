"""The widget's view in a browser, in a page that stands for a notebook."""

import base64
import json

import pytest
from studio_page import FLAGS, browser_or_skip, until
from studio_talk import Talk, source_of

from wireprint import examples
from wireprint.window import telling

playwright = pytest.importorskip("playwright.sync_api")

#: A notebook with two views of one widget, whose kernel tells what it knows to who listens.
NOTEBOOK = """<!DOCTYPE html><meta charset="utf-8"><title>notebook</title>
<style>button { font-size: 40px; } * { color: red; }</style>
<div id="one"></div><div id="two"></div>
<script type="module">
import widget from "/studio.js";
const told = TOLD.map((text) => Uint8Array.from(atob(text), (letter) => letter.charCodeAt(0)));
window.asked = [];
const calls = new Set();
const model = {
  get: () => 420,
  send: (text) => {
    window.asked.push(JSON.parse(text));
    if (JSON.parse(text).do !== "open") return;
    for (const bytes of told) for (const call of calls) call({}, [new DataView(bytes.buffer)]);
  },
  on: (_, call) => calls.add(call),
  off: (_, call) => calls.delete(call),
};
const view = (id) => document.getElementById(id).shadowRoot.querySelector(".wireprint");
window.view = view;
window.ends = ["one", "two"].map((id) => widget.render({ model, el: document.getElementById(id) }));
window.listening = () => calls.size;
</script>"""


@pytest.fixture(scope="module")
def events(tmp_path_factory):
    """What a session on a cube knows once it is printed."""
    cube = tmp_path_factory.mktemp("cell") / "cube.stl"
    cube.write_bytes(examples.stl("cube"))
    with Talk(source_of(cube)) as talk:
        talk.wait("rest")
        known = talk.session.welcome()
    assert len(known) > 4
    return json.dumps([base64.b64encode(one).decode() for one in known])


@pytest.fixture
def notebook(events):
    path = browser_or_skip()
    program = telling.__file__.rpartition("/")[0] + "/static/studio.js"
    with playwright.sync_playwright() as player:
        browser = player.chromium.launch(executable_path=path, args=list(FLAGS))
        page = browser.new_page(viewport={"width": 1100, "height": 900})
        page.faults = []
        page.on("pageerror", lambda error: page.faults.append(str(error)))
        page.route(
            "http://notebook/",
            lambda route: route.fulfill(
                content_type="text/html", body=NOTEBOOK.replace("TOLD", events)
            ),
        )
        page.route(
            "http://notebook/studio.js",
            lambda route: route.fulfill(content_type="text/javascript", path=program),
        )
        page.goto("http://notebook/")
        until(page, "window.view && view('one').dataset.drawn > 0 && view('two').dataset.drawn > 0")
        yield page
        browser.close()


def test_views_of_a_widget_draw_and_do_not_share_what_is_chosen(notebook):
    page = notebook
    # The notebook's styles do not reach them.
    style = "getComputedStyle(view('one').querySelector('.views button')).fontSize"
    assert page.evaluate(style) == "13px"
    for_colours = "view('{}').querySelector('[aria-label=\"colour by\"]').value"
    page.locator("#one").get_by_label("colour by").select_option("time")
    assert page.evaluate(for_colours.format("one")) == "time"
    assert page.evaluate(for_colours.format("two")) == "feature"
    # Keys are those of the view that has the focus.
    pressed = "view('{}').querySelector('[aria-label=\"Print as layers\"]').ariaPressed"
    page.keyboard.press("b")
    assert page.evaluate(pressed.format("one")) == "false"
    page.evaluate("view('one').focus()")
    page.keyboard.press("b")
    assert page.evaluate(pressed.format("one")) == "true"
    assert page.evaluate(pressed.format("two")) == "false"
    # What a user does is asked of the kernel.
    page.locator("#two").get_by_text("heights").click()
    until(page, "window.asked.some((one) => one.do === 'mark' && one.mark.shape.kind === 'z')")
    assert page.evaluate("listening()") == 2
    page.evaluate("ends[0]()")
    assert page.evaluate("listening()") == 1
    assert page.faults == []
