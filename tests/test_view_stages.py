"""Each stage can be drawn: its strokes are those of the stage, slab by slab."""

from __future__ import annotations

import numpy as np
import pytest
import trimesh
from click.testing import CliRunner

from wireprint import cli, examples, stages, view_stages
from wireprint._core import KINDS, Mesh, SettingError
from wireprint.settings import Settings
from wireprint.view_styles import STYLES

SETTINGS = Settings.load()


@pytest.fixture(scope="module")
def tube():
    """A tube of 40 mm around a hole of 24 mm, 20 mm high."""
    ring = trimesh.creation.annulus(12.0, 20.0, 20.0, sections=64)
    ring.apply_translation((0, 0, 10))
    return Mesh.from_arrays(ring.vertices, ring.faces)


def _length_mm(strands, label):
    return dict(zip(strands.labels, strands.lengths, strict=True)).get(label, 0.0)


def _total_mm(strands):
    return sum(strands.lengths)


def test_slices_are_the_contours_of_all_levels(tube):
    shown = view_stages.stage("slices", tube, SETTINGS)
    count = stages.wireframe(tube, SETTINGS).slice_count
    around_mm = 2 * np.pi * (12 + 20)
    assert _length_mm(shown, "slice") == pytest.approx(count * around_mm, rel=0.01)


def test_contours_tell_holes_from_what_is_outside(tube):
    shown = view_stages.stage("contours", tube, SETTINGS)
    ratio = _length_mm(shown, "hole") / _length_mm(shown, "outside")
    assert ratio == pytest.approx(12 / 20, rel=0.01)


def test_strips_of_a_slab_join_the_contours_below_and_above(tube):
    shown = view_stages.stage("strips", tube, SETTINGS, range(1, 2))
    assert [label for label in shown.labels if label.startswith("strip")] == ["strip 1", "strip 2"]
    assert _total_mm(shown) == pytest.approx(2 * 2 * np.pi * (12 + 20), rel=0.01)


def test_posts_are_those_of_the_slabs_asked_for(tube):
    wireframe = stages.wireframe(tube, SETTINGS)
    posts = wireframe.posts[wireframe.post_places[:, 0] == 2]
    shown = view_stages.stage("posts", tube, SETTINGS, range(2, 3))
    expected_mm = np.linalg.norm(posts[:, 1] - posts[:, 0], axis=1).sum()
    assert expected_mm > 0
    assert _length_mm(shown, "post") == pytest.approx(expected_mm, rel=1e-5)


@pytest.mark.parametrize("name", ["strands", "toolpath"])
def test_slabs_one_by_one_make_up_the_whole(tube, name):
    count = stages.wireframe(tube, SETTINGS).slice_count - 1
    whole = view_stages.stage(name, tube, SETTINGS)
    parts = [view_stages.stage(name, tube, SETTINGS, range(i, i + 1)) for i in range(count)]
    for kind in KINDS:
        summed_mm = sum(_length_mm(part, kind) for part in parts)
        assert summed_mm == pytest.approx(_length_mm(whole, kind), rel=1e-4, abs=0.01)


def test_slabs_that_are_not_there_are_refused(tube):
    with pytest.raises(SettingError, match="slabs: 500 to 500; there are 0 to"):
        view_stages.stage("strands", tube, SETTINGS, range(500, 501))


@pytest.mark.parametrize("name", view_stages.STAGES)
def test_the_command_draws_every_stage(name, tmp_path):
    model, picture = tmp_path / "torus.stl", tmp_path / "torus.png"
    model.write_bytes(examples.stl("torus"))
    run = CliRunner().invoke(
        cli.main,
        ["view", str(model), "--stage", name, "--slabs", "1..2", "-o", str(picture)],
    )
    assert run.exit_code == 0, run.output
    assert picture.read_bytes().startswith(b"\x89PNG")


def test_gcode_has_no_stages(tmp_path):
    file = tmp_path / "a.gcode"
    file.write_text("G28\nG1 X1 Y1 E1 F600\n")
    run = CliRunner().invoke(cli.main, ["view", str(file), "--stage", "slices"])
    assert run.exit_code == 2
    assert "name its model" in run.output


def test_every_label_of_a_stage_has_a_style_of_its_own(tube):
    for name in view_stages.STAGES:
        shown = view_stages.stage(name, tube, SETTINGS)
        drawn = [label for label in shown.labels if _length_mm(shown, label) > 0]
        assert drawn
        assert set(drawn) <= STYLES.keys()
