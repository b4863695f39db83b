"""Random marks are layers nearly all over, with slim strands and with thick ones."""

import numpy as np
import pytest
import trimesh

import random_marks
from wireprint._core import Mesh
from wireprint.hybrid.prove import proved
from wireprint.hybrid.sketch import Sketch
from wireprint.settings import Settings

MACHINES = (("kossel-mini", "abs"), ("prusa-mk4s", "pla"))
SEEDS = range(12)
#: Of the marked area, in the median and in all but the worst of so many marks.
MEDIAN, MOST = 0.98, 0.9


def ball():
    return trimesh.creation.icosphere(4, 22.5)


def top():
    """A cone that turns twice, the lower part shallow."""
    outline = [(0, 0), (25, 0), (25, 3), (8, 12), (14, 30), (0, 30), (0, 0)]
    return trimesh.creation.revolve(np.array(outline, float), sections=48)


@pytest.mark.parametrize("machine", MACHINES, ids=lambda machine: machine[0])
@pytest.mark.parametrize("solid", [ball, top])
def test_marks_are_layers_but_for_little(solid, machine):
    settings = Settings.load(*machine, overrides=["gcode.thumbnails=[]"])
    made = solid()
    made.apply_translation((0, 0, -made.bounds[0, 2]))
    sketch = Sketch.of(Mesh.from_arrays(made.vertices, made.faces), settings)
    shares = []
    for seed in SEEDS:
        found = proved(sketch, random_marks.mark(sketch.mesh, seed).region)
        assert found.verdict.ok
        assert found.rounds <= 3
        lost = sum(run.area_mm2 for run, _ in found.plan.runs.dropped)
        marked = lost + sum(run.area_mm2 for run in found.plan.sections)
        # Pieces of lines that it does without are a hair of them.
        assert found.trimmed_mm <= 0.02 * found.layer_wise_mm
        shares.append(1 - lost / max(marked, 1e-9))
    assert np.median(shares) >= MEDIAN
    assert np.quantile(shares, 0.2) >= MOST


def test_a_seed_is_always_the_same_mark():
    mesh = Mesh.from_arrays(ball().vertices, ball().faces)
    marks = [random_marks.mark(mesh, seed) for seed in SEEDS]
    assert {mark.kind for mark in marks} == set(random_marks.KINDS)
    assert [random_marks.mark(mesh, seed).told for seed in SEEDS] == [mark.told for mark in marks]
