"""Bands above wire begin with a floor that holds: bridged, closed step by step, or left open."""

from __future__ import annotations

import numpy as np
import pytest
import trimesh

from wireprint._core import Mesh
from wireprint.hybrid.prove import proved
from wireprint.hybrid.sketch import Sketch
from wireprint.regions import Box, Region, Stroke, ZRange
from wireprint.settings import Settings

SETTINGS = Settings.load(overrides=["gcode.thumbnails=[]"])
SPAN_MM = SETTINGS.wire.span_limit_mm


def _sketch(solid, settings=SETTINGS):
    solid.apply_translation((0, 0, -solid.bounds[0, 2]))
    return Sketch.of(Mesh.from_arrays(solid.vertices, solid.faces), settings)


def _band(sketch, low_mm, high_mm):
    found = proved(sketch, Region().add(ZRange(low_mm=low_mm, high_mm=high_mm)))
    kept = sum(run.area_mm2 for run in found.plan.sections)
    lost = sum(run.area_mm2 for run, _ in found.plan.runs.dropped)
    return found, kept / (kept + lost)


@pytest.mark.parametrize("low_mm", [7.0, 21.0])
@pytest.mark.parametrize("wide_mm", [0.5 * SPAN_MM, 1.4 * SPAN_MM])
def test_a_band_keeps_its_runs_however_wide_the_hollow_below(wide_mm, low_mm):
    sketch = _sketch(trimesh.creation.cylinder(wide_mm / 2, 30.0, sections=96))
    found, share = _band(sketch, low_mm, 28.0)
    assert found.rounds == 1
    assert share > 0.99


#: A strand of 0.4 mm touches 0.35 mm aside of one that lies 0.2 mm lower: flat slopes lead farther.
SLIM = Settings.load("prusa-mk4s", "pla", overrides=["gcode.thumbnails=[]"])


@pytest.mark.parametrize(("flat_deg", "least"), [(15, 0.7), (20, 0.98), (30, 0.75), (45, 0.98)])
@pytest.mark.parametrize("turn_deg", [0, 180], ids=["closing", "opening"])
def test_slim_strands_climb_slopes(flat_deg, least, turn_deg):
    rise_mm = 30.0 * np.tan(np.radians(flat_deg))
    profile = [(0, 0), (40, 0), (40, 2), (10, 2 + rise_mm), (10, 6 + rise_mm), (0, 6 + rise_mm)]
    solid = trimesh.creation.revolve(np.array([*profile, profile[0]], float), sections=64)
    solid.apply_transform(trimesh.transformations.rotation_matrix(np.radians(turn_deg), (1, 0, 0)))
    sketch = _sketch(solid, SLIM)
    low_mm = 2.0 if turn_deg == 0 else 4.0
    mark = Box(low_mm=(2.0, -8.0, low_mm), high_mm=(45.0, 8.0, low_mm + rise_mm))
    found = proved(sketch, Region().add(mark))
    kept = sum(run.area_mm2 for run in found.plan.sections)
    lost = sum(run.area_mm2 for run, _ in found.plan.runs.dropped)
    assert kept > least * (kept + lost)


def test_a_narrow_floor_is_closed_in_its_first_layer():
    sketch = _sketch(trimesh.creation.box((0.6 * SPAN_MM, 0.5 * SPAN_MM, 30.0)))
    found, _ = _band(sketch, 12.0, 24.0)
    assert not found.plan.laid.floors.is_open.any()
    first = np.flatnonzero(~np.isnan(found.plan.laid.floors.turn_rad))
    assert len(first) == 1
    # The shorter way across.
    assert np.cos(found.plan.laid.floors.turn_rad[first[0]]) == pytest.approx(0, abs=0.1)


def test_what_is_too_wide_to_bridge_stays_open_and_is_told():
    sketch = _sketch(trimesh.creation.cylinder(0.8 * SPAN_MM, 30.0, sections=96))
    found, share = _band(sketch, 12.0, 24.0)
    assert share > 0.99
    (hollow,) = found.plan.left_hollow()
    assert hollow.reason == "over_hollow"
    assert hollow.low_mm >= 11.0
    open_mm2 = found.plan.laid.open_mm2()
    layers = np.flatnonzero(open_mm2)
    # Each layer leans inwards over the one below.
    assert open_mm2[layers[-1]] < open_mm2[layers[0]]


@pytest.mark.parametrize(("printer", "material"), [("voron-2.4", "abs"), ("prusa-mk4s", "pla")])
@pytest.mark.parametrize("from_the_pole_deg", [14, 18])
def test_a_stroke_on_a_shallow_underside_is_layers(printer, material, from_the_pole_deg):
    """Walls lie several strands aside of those below: all between lean on each other."""
    radius_mm, slant = 35.0, np.radians(from_the_pole_deg)
    ball = trimesh.creation.icosphere(subdivisions=4, radius=radius_mm)
    sketch = _sketch(ball, Settings.load(printer, material, overrides=["gcode.thumbnails=[]"]))
    around = np.radians(np.linspace(0, 60, 6))
    normals = np.column_stack(
        [
            np.sin(slant) * np.cos(around),
            np.sin(slant) * np.sin(around),
            np.full(6, -np.cos(slant)),
        ]
    )
    points = (0, 0, radius_mm) + radius_mm * normals
    mark = Stroke(
        points_mm=tuple(map(tuple, points.tolist())),
        normals=tuple(map(tuple, normals.tolist())),
        radius_mm=6.0,
    )
    found = proved(sketch, Region().add(mark))
    assert found.verdict.ok
    assert found.plan.runs.dropped == ()
    assert found.trimmed_mm <= 0.02 * found.layer_wise_mm
