"""A sketch serves all strokes on a model, and gives what a new one would."""

from __future__ import annotations

import numpy as np
import pytest

from wireprint import examples, load_mesh
from wireprint.hybrid.prove import proved
from wireprint.hybrid.sketch import Sketch
from wireprint.regions import Region, Sphere, Stroke, ZRange
from wireprint.settings import Settings

SETTINGS = Settings.load(overrides=["gcode.thumbnails=[]"])
STROKES = 8


@pytest.fixture(scope="module", params=["bottle", "torus"])
def mesh(request, tmp_path_factory):
    path = tmp_path_factory.mktemp("sketch") / f"{request.param}.stl"
    path.write_bytes(examples.stl(request.param))
    return load_mesh(path, scale=0.5)


def _stroke(mesh, rng):
    """A stroke across a few neighbouring faces."""
    corners = mesh.vertices[mesh.faces]
    middles = corners.mean(axis=1)
    normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    normals /= np.linalg.norm(normals, axis=1, keepdims=True)
    start = rng.integers(len(middles))
    near = np.argsort(np.linalg.norm(middles - middles[start], axis=1))[: rng.integers(1, 8)]
    return Stroke(
        points_mm=tuple(map(tuple, middles[near].tolist())),
        normals=tuple(map(tuple, normals[near].tolist())),
        radius_mm=float(rng.uniform(0.5, 4.0)),
    )


def _session(mesh, seed, count):
    """Regions as a user makes them: strokes added, erased, taken back."""
    rng = np.random.default_rng(seed)
    history = [Region()]
    for _ in range(count):
        what = rng.random()
        if what < 0.2 and len(history) > 1:
            history.pop()
        elif what < 0.4:
            history.append(history[-1].erase(_stroke(mesh, rng)))
        else:
            history.append(history[-1].add(_stroke(mesh, rng)))
        yield history[-1]


def _moves(found):
    path = found.toolpath
    return [path.to, path.kind, path.speed, path.filament, path.pause, path.air, path.slab]


def test_kept_parts_change_nothing(mesh):
    kept = Sketch.of(mesh, SETTINGS)
    layered = 0
    for region in _session(mesh, seed=1, count=STROKES):
        found = proved(kept, region)
        fresh = proved(Sketch.of(mesh, SETTINGS), region)
        for a, b in zip(_moves(found), _moves(fresh), strict=True):
            np.testing.assert_array_equal(a, b)
        layered += len(found.plan.sections)
    assert layered > 0


def test_undo_gives_the_print_before(mesh):
    kept = Sketch.of(mesh, SETTINGS)
    rng = np.random.default_rng(3)
    before = Region().add(_stroke(mesh, rng))
    first = proved(kept, before)
    proved(kept, before.add(ZRange(low_mm=0.8 * mesh.size_mm[2])))
    proved(kept, before.erase(Sphere(centre_mm=(0, 0, 0), radius_mm=10)))
    again = proved(kept, before)
    for a, b in zip(_moves(first), _moves(again), strict=True):
        np.testing.assert_array_equal(a, b)
