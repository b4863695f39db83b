"""A window in a browser without a screen."""

import re
import shutil
import subprocess
import sys
import time

import pytest

COMMAND = [sys.executable, "-c", "from wireprint.cli import main; main()", "studio"]
BROWSERS = ("chromium", "chromium-browser", "google-chrome")
#: Draws without a graphics card, and without the sandbox that root has no right to.
FLAGS = (
    "--no-sandbox",
    "--use-gl=angle",
    "--use-angle=swiftshader",
    "--enable-unsafe-swiftshader",
    "--ignore-gpu-blocklist",
)
#: Longest that anything is waited for, s; nothing takes as long unless it is broken.
PATIENCE_S = 120.0


def browser_or_skip():
    found = next(filter(None, map(shutil.which, BROWSERS)), None)
    if found is None:
        pytest.skip(f"needs a browser: {', '.join(BROWSERS)}")
    return found


class Window:
    """A process of the command, and pages on it."""

    def __init__(self, browser, model, *options):
        self.browser = browser
        self.process = subprocess.Popen(
            [*COMMAND, str(model), "--no-browser", *map(str, options)],
            stdout=subprocess.PIPE,
            stderr=subprocess.DEVNULL,
            text=True,
        )
        self.url = self.process.stdout.readline().strip()
        self.port = int(re.search(r":(\d+)/", self.url)[1])
        self.requests, self.faults, self._pages = [], [], []

    def close(self):
        for page in self._pages:
            page.context.close()
        self.process.terminate()
        self.process.wait()
        self.process.stdout.close()

    def clear(self):
        """Take back all that pages did, and close them."""
        for page in self._pages:
            page.evaluate(
                """async () => {
                    while (store.state.value.can_undo) {
                        const { revision } = store.state.value;
                        await studio.edit({ do: "undo" });
                        while (store.state.value.revision === revision)
                            await new Promise((done) => setTimeout(done, 5));
                    }
                }"""
            )
            page.context.close()
        self._pages, self.requests, self.faults = [], [], []

    def page(self, *, width=1000, height=640, **context):
        """Open a page; wait for its first print."""
        page = self.browser.new_context(
            viewport={"width": width, "height": height}, **context
        ).new_page()
        page.set_default_timeout(1000 * PATIENCE_S)
        self._pages.append(page)
        page.on("request", lambda request: self.requests.append(request.url))
        page.on("pageerror", lambda error: self.faults.append(str(error)))
        page.on(
            "console",
            lambda said: said.type in ("error", "warning") and self.faults.append(said.text),
        )
        page.goto(self.url)
        page.goto(page.url + "?debug")
        until(page, "document.querySelector('.wireprint')?.dataset.drawn > 0")
        return page


def until(page, expression):
    """Wait until an expression is true; the page's policy lets no text be run within it."""
    end = time.monotonic() + PATIENCE_S
    while time.monotonic() < end:
        if page.evaluate(expression):
            return
        time.sleep(0.02)
    raise AssertionError(f"never: {expression}")


def settled(page):
    """Wait until the print is that of what is marked, and the picture rests."""
    until(page, "store.printed.value === store.state.value.revision")
    page.evaluate("new Promise((done) => setTimeout(done, 450))")


def on_canvas(page, x_mm, y_mm, z_mm):
    """Return where a place of the scene is on the page, pixels."""
    return page.evaluate(
        """([x, y, z]) => {
            const { camera, controls } = studio.view;
            const seen = controls.target.clone().set(x, y, z).project(camera);
            const box = document.querySelector("canvas").getBoundingClientRect();
            const [u, v] = [(seen.x + 1) / 2, (1 - seen.y) / 2];
            return [box.left + u * box.width, box.top + v * box.height];
        }""",
        [x_mm, y_mm, z_mm],
    )


def drag(page, places, *, release=True):
    """Drag over places of the scene, mm."""
    points = [on_canvas(page, *place) for place in places]
    page.mouse.move(*points[0])
    page.mouse.down()
    for point in points[1:]:
        page.mouse.move(*point, steps=4)
    if release:
        page.mouse.up()


def exported(page, kind="gcode"):
    """Return the bytes of a file that the page downloads."""
    with page.expect_download() as download:
        page.evaluate(f"void studio.export({kind!r})")
    return download.value.path().read_bytes()
