"""Measures the window without a screen: its address, first pictures, strokes and frames.

python benches/window.py [NAME…]
python benches/window.py --picture docs/studio.png    draws the picture in the README

Needs playwright, a browser and the shared models. Wall clocks of a machine that does nothing else.
"""

import argparse
import csv
import subprocess
import sys
import tempfile
import time
from pathlib import Path

from playwright.sync_api import sync_playwright

import shared_models
from wireprint import examples

sys.path.insert(0, str(Path(__file__).resolve().parent.parent / "tests/studio"))

from studio_page import COMMAND, FLAGS, Window, browser_or_skip, drag, settled, until


class Model:
    """A shared model, and the options that place it on a bed with room for it."""

    def __init__(self, row):
        self.path = shared_models.SHARED / "models" / row["name"]
        placed = ["--height", row["suggested_height_mm"], "--up", row["up_axis"]]
        roomy = [word for one in shared_models.ROOMY for word in ("--set", one)]
        self.options = [*placed, *roomy]


def models():
    manifest = shared_models.SHARED / "models" / "manifest.csv"
    with manifest.open(newline="", encoding="utf-8") as file:
        return [Model(row) for row in csv.DictReader(file) if not row["name"].endswith(".amf")]


#: So many strands are a large print.
STRANDS = 178_405
FRAMES = 5


DRAWN = "document.querySelector('.wireprint').dataset.drawn"


def address_s(model):
    """Seconds until the command prints where the window is."""
    begin = time.perf_counter()
    command = [*COMMAND, str(model), "--no-browser"]
    with subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL) as process:
        process.stdout.readline()
        took = time.perf_counter() - begin
        process.terminate()
    return took


def first_picture_s(browser, model):
    """Seconds from the start of the command to the first picture with strands; what went wrong."""
    begin = time.perf_counter()
    window = Window(browser, model.path, *model.options)
    page = browser.new_page(viewport={"width": 1000, "height": 640})
    faults = []
    page.on("pageerror", lambda error: faults.append(str(error)))
    try:
        page.goto(window.url)
        until(page, "document.querySelector('.wireprint')?.dataset.drawn > 0")
        return time.perf_counter() - begin, page.evaluate(DRAWN), faults
    finally:
        page.close()
        window.close()


def stroke_s(browser, model):
    """Seconds from the end of a drag over the front to its print; and of the print alone."""
    window = Window(browser, model.path, *model.options)
    try:
        page = window.page()
        settled(page)
        page.evaluate("new Promise((done) => setTimeout(done, 3000))")
        page.keyboard.press("1")
        page.keyboard.press("b")
        settled(page)
        middle = page.evaluate("studio.view.controls.target.toArray()")
        drag(page, [(middle[0] + x, middle[1], middle[2]) for x in range(-8, 9, 4)])
        begin = time.perf_counter()
        until(page, "store.state.value.items.length > 0")
        until(page, "store.printed.value === store.state.value.revision")
        return time.perf_counter() - begin, page.evaluate("store.print.value.made_s")
    finally:
        window.close()


def frame_ms(browser, model):
    """Milliseconds of a frame with many strands, each awaited by reading a pixel."""
    window = Window(browser, model.path, *model.options)
    try:
        page = window.page()
        settled(page)
        return page.evaluate(
            """([count, frames]) => {
                const { strands, surface, renderer } = studio.view;
                const print = store.print.value, packed = new Uint32Array(4 * count);
                const known = strands.packed, when = new Float32Array(2 * count);
                for (let i = 0; i < count; i++) {
                    const from = 4 * (i % (known.length / 4));
                    packed.set(known.subarray(from, from + 4), 4 * i);
                    when.set([i, i + 1], 2 * i);
                }
                surface.visible = false;
                strands.take(print, packed, when, new Float32Array(count));
                strands.showUntil(Infinity);
                const gl = renderer.getContext(), pixel = new Uint8Array(4);
                const frame = () => {
                    const begin = performance.now();
                    studio.view.draw(1);
                    gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, pixel);
                    return performance.now() - begin;
                };
                frame();
                return Math.min(...Array.from({ length: frames }, frame));
            }""",
            [STRANDS, FRAMES],
        )
    finally:
        window.close()


def draw(path):
    """Draw the window on the example bottle, with a painted belt."""
    with tempfile.TemporaryDirectory() as folder, sync_playwright() as player:
        model = Path(folder) / "bottle.stl"
        model.write_bytes(examples.stl("bottle"))
        browser = player.chromium.launch(executable_path=browser_or_skip(), args=list(FLAGS))
        window = Window(browser, model)
        try:
            page = window.page(width=1280, height=800, color_scheme="light")
            page.evaluate("store.radiusMm.value = 7")
            page.keyboard.press("b")
            settled(page)
            drag(page, [(x, -22, 62 - 0.5 * x) for x in range(-16, 20, 3)])
            until(page, "store.state.value.items.length > 0")
            page.keyboard.press("v")
            until(page, "store.fields.value.length > 0")
            settled(page)
            until(page, "store.rest.value !== null")
            page.mouse.move(5, 400)
            settled(page)
            page.screenshot(path=path)
        finally:
            window.close()
            browser.close()


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("names", nargs="*")
    parser.add_argument("--picture", type=Path)
    options = parser.parse_args()
    if options.picture is not None:
        draw(options.picture)
        return
    names = options.names
    chosen = [one for one in models() if not names or one.path.stem in names]
    with sync_playwright() as player:
        browser = player.chromium.launch(executable_path=browser_or_skip(), args=list(FLAGS))
        print(f"address {address_s(chosen[0].path):.2f} s")
        for model in chosen:
            took, count, faults = first_picture_s(browser, model)
            print(f"{model.path.stem}: first picture {took:.2f} s, {count} strands {faults or ''}")
        for model in chosen[:3]:
            wall, made = stroke_s(browser, model)
            print(f"{model.path.stem}: stroke {wall:.2f} s, of it the print {made:.2f} s")
        print(f"{STRANDS} strands: {frame_ms(browser, chosen[0]):.0f} ms a frame")
        browser.close()


if __name__ == "__main__":
    main()
