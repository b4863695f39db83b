"""The page that turns in a browser: it holds everything, and it draws."""

import base64
import json
import re
import shutil
import subprocess
from html.parser import HTMLParser

import numpy as np
import pytest

from wireprint import examples, view
from wireprint._core import Strands
from wireprint.mesh import load_mesh
from wireprint.view_html import STEPS

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


def data_of(page):
    found = re.search(r'<script type="application/json" id="data">(.*?)</script>', page, re.S)
    return json.loads(found[1])


def decoded(data, name, dtype, columns):
    return np.frombuffer(base64.b64decode(data[name]), dtype).reshape(-1, columns)


class Links(HTMLParser):
    """Everything that a browser would load."""

    def __init__(self):
        super().__init__()
        self.found = []

    def handle_starttag(self, tag, attrs):
        self.found += [value for name, value in attrs if name in {"src", "href", "data", "action"}]


def test_a_page_loads_nothing(strands):
    page = view.render_html(strands)
    links = Links()
    links.feed(page)
    assert all(link.startswith("data:") for link in links.found)
    assert "http:" not in page
    assert "https:" not in page
    for loader in ("import(", "import ", "fetch(", "XMLHttpRequest", "@import", "url("):
        assert loader not in page


def test_coordinates_arrive_within_a_step(strands):
    data = data_of(view.render_html(strands))
    ends = decoded(data, "strands", "<u2", 8)[:, :6].reshape(-1, 2, 3)
    span = np.array(data["span"])
    positions = data["low"] + ends / STEPS * span
    assert data["strand_count"] == 2
    assert np.abs(positions - strands.segments).max() <= span.max() / STEPS


def test_diameters_arrive_within_a_step(strands):
    data = data_of(view.render_html(strands))
    sent = decoded(data, "strands", "u1", 16)[:, 13] * data["diameter_step"]
    assert np.abs(sent - strands.diameters).max() <= data["diameter_step"]


def test_the_legend_has_a_line_for_each_kind_and_for_travels(strands):
    data = data_of(view.render_html(strands, travels=True))
    assert [row["name"] for row in data["legend"]] == ["contour", "post", "travel"]
    kinds = decoded(data, "strands", "u1", 16)[:, 12]
    assert kinds.tolist() == [0, 1]
    assert decoded(data, "travels", "<f4", 6).tolist() == [[40, 0, 5, 0, 20, 5]]
    assert decoded(data, "travel_after", "<u4", 1).tolist() == [[1]]


def test_only_the_kinds_asked_for_are_sent(strands):
    data = data_of(view.render_html(strands, kinds=["post"]))
    assert data["strand_count"] == 1
    assert [row["name"] for row in data["legend"]] == ["post"]


def test_a_hostile_title_stays_text(strands):
    title = "</script><script>alert(1)</script><!--"
    page = view.render_html(strands, title=title)
    assert page.count("</script>") == view.render_html(strands, title="").count("</script>")
    assert data_of(page)["title"] == title
    assert "<title>&lt;/script&gt;" in page


def test_fifty_thousand_strands_make_a_page_of_about_a_megabyte():
    angles = np.arange(50_001) * 0.1
    points = np.stack([30 * np.cos(angles), 30 * np.sin(angles), angles / 50], axis=1)
    segments = np.stack([points[:-1], points[1:]], axis=1)
    strands = Strands.from_arrays(segments, np.zeros(50_000, np.uint16), ["contour"], 0.7)
    assert len(view.render_html(strands)) < 1.2e6


BROWSER = shutil.which("chromium")
FLAGS = (
    "--headless",
    "--no-sandbox",
    "--disable-quic",
    "--no-first-run",
    "--disable-background-networking",
    "--disable-component-update",
    "--disable-sync",
    "--use-angle=swiftshader",
    "--enable-unsafe-swiftshader",
    "--dump-dom",
)


@pytest.mark.skipif(BROWSER is None, reason="chromium is absent")
@pytest.mark.parametrize("what", ["print", "model"])
def test_a_browser_draws_the_page(tmp_path, strands, what):
    page = tmp_path / "page.html"
    if what == "print":
        view.render_html(strands, page, travels=True, breaches=[(1, 2, 3)])
        drawn = "2 strands, 0 facets, error 0"
    else:
        (tmp_path / "cube.stl").write_bytes(examples.stl("cube"))
        cube = load_mesh(tmp_path / "cube.stl")
        view.render_html(cube, page)
        drawn = f"0 strands, {len(cube.faces)} facets, error 0"
    result = subprocess.run(
        [BROWSER, *FLAGS, f"--user-data-dir={tmp_path / 'browser'}", page.as_uri()],
        capture_output=True,
        text=True,
        timeout=120,
    )
    assert f'data-drawn="{drawn}"' in result.stdout
