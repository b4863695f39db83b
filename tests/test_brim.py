"""A foot that is small for its height gets as much of a brim as it wants, unless told otherwise."""

import json

import numpy as np
import pytest
import trimesh

from command import run
from wireprint import KINDS, Settings
from wireprint._core import Mesh
from wireprint.pipeline import make


def column(width_mm, height_mm):
    solid = trimesh.creation.box((width_mm, 2 * width_mm, height_mm))
    solid.apply_translation((0, 0, height_mm / 2))
    return Mesh.from_arrays(np.array(solid.vertices), np.array(solid.faces, dtype=np.int64))


def made_of(mesh, rings="auto"):
    settings = Settings.load(overrides=[f"wire.brim_rings={rings}"])
    return make(mesh, settings, partial=True)


def foot_mm(made):
    """Extent along x of all on the bed but the skirt."""
    path = made.toolpath
    on_bed = path.to[:, 2] <= made.settings.first_layer_height_mm + 1e-9
    counts = np.isin(path.kind, [KINDS.index("contour"), KINDS.index("brim")])
    return float(np.ptp(path.to[on_bed & counts][:, 0]))


@pytest.mark.parametrize("height_mm", [45, 60])
def test_a_small_foot_is_widened_to_a_quarter_of_the_height(height_mm):
    made = made_of(column(8, height_mm))
    strand_mm = made.settings.printer.head.nozzle_mm
    assert made.toolpath.brim_rings > 0
    assert made.certificate.ok
    assert height_mm / 4 - 0.5 <= foot_mm(made) < height_mm / 4 + 2 * strand_mm
    assert not made_of(column(8, height_mm), 0).toolpath.brim_rings


def test_a_foot_that_is_wide_enough_gets_none():
    made = made_of(column(20, 60))
    assert made.toolpath.brim_rings == 0
    assert foot_mm(made) == pytest.approx(20, abs=0.1)


def test_a_needle_gets_no_endless_brim():
    assert made_of(column(4, 200)).toolpath.brim_rings == 10


def test_it_is_told(tmp_path):
    model, target = tmp_path / "mast.stl", tmp_path / "mast.gcode"
    trimesh.creation.box((8, 16, 60)).export(model)
    told = run("slice", model, "-o", target).stdout
    assert "rings about the foot" in told
    figures = json.loads(run("slice", model, "-o", target, "--json").stdout)
    assert figures["brim_rings"] > 0
    assert (
        "rings about the foot"
        not in run("slice", model, "-o", target, "--set", "wire.brim_rings=0").stdout
    )
