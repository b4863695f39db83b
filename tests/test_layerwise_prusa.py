"""The layer slicer against PrusaSlicer with equal settings, both timed by one estimator."""

import shutil
import struct
import subprocess

import numpy as np
import pytest

import wireprint
from wireprint.gcode import document
from wireprint.layerwise.areas import areas
from wireprint.layerwise.printing import layered
from wireprint.layerwise.recipe import Recipe

#: Models, and what brings them to their suggested size.
MODELS = {
    "bottle_fuze.ply": (511.323, "z"),
    "bunny.stl": (792.372, "z"),
    "cube_plain.obj": (30.0, "z"),
    "duck.stl": (937.142, "z"),
    "hand.stl": (870.09, "z"),
    "koala.obj": (14.9843, "y"),
    "pyramid.stl": (899.386, "z"),
    "sphere.obj": (35.0, "z"),
    "spot_cow.obj": (51.2515, "y"),
    "torus.3mf": (5.05141, "z"),
}
#: The limits that `prusa.sh` gives to PrusaSlicer.
MACHINE = {
    "kinematics": "cartesian",
    "max_velocity": 300,
    "max_accel": 3000,
    "max_z_velocity": 300,
    "max_z_accel": 3000,
    "max_extrude_only_velocity": 100,
    "max_extrude_only_accel": 3000,
    "marlin": {
        "max_velocity": [300, 300, 300, 100],
        "max_accel": [3000, 3000, 3000, 3000],
        "print_accel": 3000,
        "travel_accel": 3000,
        "retract_accel": 3000,
        "jerk": [20, 20, 20, 20],
    },
}


def timed(text):
    return wireprint.estimate(text, limits=MACHINE, firmware="marlin-jerk")


def write_stl(mesh, path):
    facets = np.zeros(
        len(mesh.faces), dtype=[("normal", "<f4", 3), ("v", "<f4", (3, 3)), ("", "<u2")]
    )
    facets["v"] = mesh.vertices[mesh.faces]
    path.write_bytes(bytes(80) + struct.pack("<I", len(facets)) + facets.tobytes())


@pytest.mark.parametrize("name", MODELS)
def test_time_and_filament_are_those_of_prusaslicer_within_a_tenth(name, shared, tmp_path):
    if shutil.which("prusa-slicer") is None:
        pytest.skip("prusa-slicer is not installed")
    scale, up = MODELS[name]
    mesh = wireprint.load_mesh(shared / "models" / name, scale=scale, up=up)
    stl, gcode = tmp_path / "model.stl", tmp_path / "model.gcode"
    write_stl(mesh, stl)
    script = shared / "peers" / "prusa.sh"
    subprocess.run(
        ["bash", script, stl, gcode, "0.7", "0.2", "40"], check=True, capture_output=True
    )
    theirs = timed(gcode.read_bytes())
    settings = wireprint.Settings.load()
    recipe = Recipe.of(settings.layerwise, settings.printer)
    path = layered(areas(mesh, recipe.layer_mm, recipe.resolution_mm), recipe)
    ours = timed(document.body(path, settings, document.dated(None)))
    assert ours.total_s == pytest.approx(theirs.total_s, rel=0.1)
    assert ours.filament_mm == pytest.approx(theirs.filament_mm, rel=0.1)
