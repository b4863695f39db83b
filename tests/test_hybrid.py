"""Wire prints with regions of layers: what is marked is layers, what is not stays wire."""

import numpy as np
import pytest

from wireprint import examples
from wireprint.gcode.flavors import KINDS
from wireprint.hybrid.motion import motion
from wireprint.mesh import load_mesh
from wireprint.pipeline import make
from wireprint.regions import Box, Region, Sphere, ZRange
from wireprint.settings import Settings

LAYERWISE, CONTOUR, POST = (KINDS.index(kind) for kind in ("layer-wise", "contour", "post"))
SETTINGS = Settings.load(overrides=["gcode.thumbnails=[]"])


@pytest.fixture(scope="module")
def models(tmp_path_factory):
    folder = tmp_path_factory.mktemp("hybrid")

    def load(name, **placement):
        path = folder / f"{name}.stl"
        path.write_bytes(examples.stl(name))
        return load_mesh(path, **placement)

    return load


def printed(mesh, *shapes, **options):
    region = Region()
    for shape in shapes:
        region = region.add(shape)
    return make(mesh, SETTINGS, region, **options)


def strands(made, kind):
    return made.wireframe.strands[made.wireframe.strand_kinds == kind]


def distances(made, points):
    """Distance of points from the model's surface, mm."""
    import trimesh

    mesh = trimesh.Trimesh(made.mesh.vertices, made.mesh.faces)
    return trimesh.proximity.closest_point(mesh, points)[1]


def test_where_nothing_is_marked_the_print_is_the_plain_one_byte_for_byte(models):
    cube = models("cube")
    plain = make(cube, SETTINGS).gcode
    assert printed(cube).gcode == plain
    assert printed(cube, ZRange(low_mm=100)).gcode == plain
    assert printed(cube, Sphere(centre_mm=(0, 0, 14), radius_mm=5)).gcode == plain


def test_a_band_around_a_model_is_layers_and_the_rest_is_the_plain_print(models):
    bottle = models("bottle", height_mm=90)
    low = 68.0
    made, plain = printed(bottle, ZRange(low_mm=low)), make(bottle, SETTINGS)
    assert made.certificate.ok
    assert strands(made, LAYERWISE)[..., 2].min() > low - SETTINGS.slab_max_mm / 2
    assert strands(made, POST)[..., 2].max() < low + SETTINGS.slab_max_mm / 2
    same = plain.wireframe.strands[: np.argmax(made.wireframe.strand_kinds == LAYERWISE)]
    np.testing.assert_array_equal(made.wireframe.strands[: len(same)], same)


def test_layers_fill_their_slab_exactly(models):
    made = printed(models("bottle", height_mm=90), ZRange(low_mm=68))
    z = np.unique(strands(made, LAYERWISE)[..., 2])
    tops = made.wireframe.levels[:, 0]
    slabs = np.searchsorted(tops, z - 1e-9)
    for slab in np.unique(slabs):
        heights = np.diff(np.append(tops[slab - 1], z[slabs == slab]))
        np.testing.assert_allclose(heights, heights[0], atol=1e-9)
        assert abs(heights[0] - SETTINGS.regions.layer_height_mm) < 0.1
        assert z[slabs == slab][-1] == tops[slab]


@pytest.mark.parametrize(
    ("name", "shape"),
    [
        ("bottle", Sphere(centre_mm=(0, -15, 45), radius_mm=14)),
        ("bottle", Box(low_mm=(-40, -40, 20), high_mm=(40, 0, 60))),
        ("sphere", Sphere(centre_mm=(0, -30, 30), radius_mm=18)),
    ],
)
def test_a_patch_is_layers_on_the_surface_between_slanted_strokes(models, name, shape):
    made = printed(models(name, height_mm=90), shape)
    assert made.certificate.ok
    assert made.regions.plan.sections
    layers = strands(made, LAYERWISE)
    outer = distances(made, layers.reshape(-1, 3)[::7])
    # The outer walls lie on the surface, the inner ones a line's width behind it.
    assert np.median(outer) < 1.05 * SETTINGS.printer.head.nozzle_mm
    assert np.quantile(outer, 0.2) < SETTINGS.regions.layer_height_mm


def test_a_run_too_short_to_print_is_dropped_and_named(models):
    made = printed(models("cube"), Box(low_mm=(-0.8, -20, -1), high_mm=(0.8, 0, 40)))
    assert made.certificate.ok
    report = made.figures()["regions"]
    assert report["runs"] == []
    (dropped,) = {run["reason"] for run in report["dropped"]}
    assert dropped == "short_run"
    assert all(run["help"] for run in report["dropped"])


def test_a_region_turns_with_its_model(models):
    bottle = models("bottle", height_mm=60)
    turned = bottle.turned((90.0, 0.0, 30.0))
    matrix = motion(bottle, turned, (90.0, 0.0, 30.0))
    there = bottle.vertices @ matrix[:3, :3].T + matrix[:3, 3]
    np.testing.assert_allclose(there, turned.vertices, atol=1e-9)
