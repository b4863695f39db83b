"""What is marked on a model, cut out of its surface: how large it is, and where it is drawn."""

import io
import json
import math
import re

import numpy as np
import pytest
import trimesh
from hypothesis import given, settings
from hypothesis import strategies as st
from PIL import Image

from command import run
from test_regions import region_of, shapes
from test_view import hue_share
from view_pages import held, told_by
from wireprint import view, view_styles
from wireprint._core import Mesh
from wireprint.model import Model
from wireprint.regions import Box, Region, Sphere, ZRange
from wireprint.regions import surface as cutting
from wireprint.regions.surface import marked_area, marked_surface

LAYERS = view_styles.STYLES["layer-wise"].colour


def mesh_of(solid):
    return Mesh.from_arrays(np.array(solid.vertices), np.array(solid.faces))


BALL = mesh_of(trimesh.creation.icosphere(2, 20))
#: 20 × 20 × 30 mm.
BLOCK = mesh_of(trimesh.creation.box((20, 20, 30)))


@settings(max_examples=15)
@given(marks=st.lists(st.tuples(st.booleans(), shapes), max_size=4))
def test_the_pieces_are_the_surface_and_the_region_says_which_are_marked(marks):
    region = region_of(marks)
    surface = marked_surface(BALL, region)
    a, b, c = surface.corners.transpose(1, 0, 2)
    normals = np.cross(b - a, c - a)
    areas = np.linalg.norm(normals, axis=1) / 2
    assert areas.sum() == pytest.approx(BALL.area)
    assert surface.area_mm2 == pytest.approx(BALL.area)
    assert surface.marked_mm2 == pytest.approx(areas[surface.marked].sum())
    assert (normals * (surface.corners.mean(axis=1) - (0, 0, 20))).sum(axis=1).min() > 0
    # Pieces with one state all over; those at a region's end are short.
    short = np.ptp(surface.corners, axis=1).max(axis=1) < 0.05
    middles = surface.corners.mean(axis=1)
    found = region.covers(middles, normals / (2 * areas[:, None]))
    assert np.array_equal(found[short], surface.marked[short])


@pytest.mark.parametrize("batch", [7, 100, 1 << 14])
def test_areas_are_the_same_however_many_triangles_are_cut_at_a_time(batch, monkeypatch):
    wire = Sphere(centre_mm=(0, 20, 15), radius_mm=6)
    region = Region().add(ZRange(low_mm=10, high_mm=20)).erase(wire)
    surface = marked_surface(BALL, region)
    monkeypatch.setattr(cutting, "BATCH", batch)
    assert marked_area(BALL, region) == pytest.approx((surface.marked_mm2, surface.area_mm2))
    assert 0 < surface.marked_mm2 < surface.area_mm2


def test_what_is_not_cut_by_a_mark_stays_whole():
    for region in (Region().add(ZRange(low_mm=50)), Region().add(ZRange())):
        surface = marked_surface(BALL, region)
        assert len(surface.corners) == len(BALL.faces)
        assert surface.marked.all() or not surface.marked.any()


@pytest.mark.parametrize(
    ("region", "area_mm2"),
    [
        (Region().add(ZRange(low_mm=7, high_mm=11.3)), 4 * 20 * 4.3),
        (Region().add(Sphere(centre_mm=(10, 0, 15), radius_mm=6)), math.pi * 36),
        (Region().add(ZRange(low_mm=25)).erase(Box(low_mm=(-5, -5, 29), high_mm=(5, 5, 31))), 700),
    ],
)
def test_the_marked_area_of_a_block_is_that_of_geometry(region, area_mm2):
    assert marked_surface(BLOCK, region).marked_mm2 == pytest.approx(area_mm2, rel=0.005)


MARKED = Model(BLOCK, Region().add(ZRange(low_mm=10, high_mm=20)), None)


def test_a_picture_shows_what_is_marked_in_the_colour_of_layers():
    options = {"size": (240, 160), "camera": "front", "with_legend": False}
    with Image.open(io.BytesIO(view.render_png(MARKED, **options))) as image:
        pixels = np.asarray(image.convert("RGBA"), np.int64)
    assert hue_share(pixels[60:100], LAYERS) > 0.1
    assert hue_share(pixels[:45], LAYERS) == hue_share(pixels[115:], LAYERS) == 0
    assert hue_share(pixels, view_styles.MODEL) > 0.1


def test_a_page_shows_what_is_marked_and_tells_its_share():
    told = told_by(view.render_html(MARKED))
    model, arrays = told["model"]
    wire, marked = model["shares"]
    assert [wire["name"], marked["name"]] == ["not marked", "marked"]
    assert marked["amount"] == f"{4 * 20 * 10 / BLOCK.area:.1%}"
    assert len(arrays["faces"]) == len(MARKED.mesh.faces)
    heights = told["paint"][1]["corners"].reshape(-1, 3)[:, 2]
    assert heights.min() == pytest.approx(10, abs=0.2)
    assert heights.max() == pytest.approx(20, abs=0.2)


@pytest.mark.parametrize(
    ("camera", "degrees"), [("iso", (35, 25)), ("top", (0, 90)), ("9,-8", (9, -8))]
)
def test_a_page_is_seen_first_from_where_the_camera_is(camera, degrees):
    told = told_by(view.render_html(BALL, camera=camera))
    assert told["welcome"][0]["camera"] == pytest.approx(degrees)


# --- the command


MARKS = ("--fill", "z:8..16", "--fill", "erase:half:1,0,0,0")


def test_info_tells_what_is_marked(cube_stl, tmp_path):
    project = tmp_path / "x.3mf"
    assert run("project", cube_stl, "-o", project, *MARKS).exit_code == 0
    share = 8 * 28 * 2 / (6 * 28**2)
    for arguments in ((project,), (cube_stl, *MARKS)):
        found = json.loads(run("info", *arguments, "--json").stdout)["marks"]
        assert found["kinds"] == {"z": 1, "half": 1}
        assert found["erase"] == 1
        assert found["share"] == pytest.approx(share, rel=0.005)
        assert found["area_mm2"] == pytest.approx(share * 6 * 28**2, rel=0.005)
    told = re.search(r"marked +([\d.]+) cm², ([\d.]+)% of .*(\(.*\))", run("info", project).stdout)
    assert float(told[1]) == pytest.approx(4.48, rel=0.005)
    assert float(told[2]) == pytest.approx(100 * share, rel=0.005)
    assert told[3] == "(1 × z, 1 × half; 1 of these erase)"


def test_info_of_a_plain_model_tells_of_no_marks(cube_stl):
    assert json.loads(run("info", cube_stl, "--json").stdout)["marks"] is None
    assert "marked" not in run("info", cube_stl).stdout


def shown(path):
    """Return what a picture or a page shows, whatever the model's file is called."""
    content = path.read_bytes()
    if path.suffix == ".html":
        content = held(content.decode(), "data")
    return content.replace(b"m.3mf", b"m.stl")


def test_view_draws_marks_of_a_project_and_of_options_alike(cube_stl, tmp_path):
    project = tmp_path / "x.3mf"
    assert run("project", cube_stl, "-o", project, *MARKS).exit_code == 0
    for name in ("a.png", "b.html"):
        drawn = []
        for arguments in ((project,), (cube_stl, *MARKS)):
            # The title is the model's name, so the project goes by that name, too.
            model = tmp_path / "model" / f"m{arguments[0].suffix}"
            model.parent.mkdir(exist_ok=True)
            model.write_bytes(arguments[0].read_bytes())
            done = run("view", model, *arguments[1:], "-o", tmp_path / name, "--size", "300x200")
            assert done.exit_code == 0, done.stderr
            drawn.append(shown(tmp_path / name))
        assert drawn[0] == drawn[1]
        assert run("view", cube_stl, "-o", tmp_path / name, "--size", "300x200").exit_code == 0
        assert shown(tmp_path / name) != drawn[1]


def test_g_code_cannot_be_marked(tmp_path):
    (tmp_path / "x.gcode").write_text("G1 X1 E1\n")
    for marks in (["--fill", "z:.."], ["--fill-file", "strokes.json"]):
        result = run("view", tmp_path / "x.gcode", *marks)
        assert result.exit_code == 2
        assert "mark its model" in result.stderr
