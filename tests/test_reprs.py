"""What a console shows of the library's objects: a line that says what it comes to."""

import numpy as np
import pytest

import wireprint
from wireprint import Settings, budget, standing
from wireprint.struts import Graph


@pytest.fixture(scope="module")
def objects(cube_stl):
    settings = Settings.load()
    mesh = wireprint.load_mesh(cube_stl)
    made = wireprint.make(mesh, settings)
    return {
        "WirePrint": made,
        "Settings": settings,
        "Mesh": mesh,
        "Wireframe": made.wireframe,
        "Toolpath": made.toolpath,
        "Certificate": made.certificate,
        "Estimate": wireprint.estimate(made.gcode),
        "Estimate ": made.estimate,
        "PerMove": wireprint.estimate(made.gcode, per_move=True).per_move,
        "Forecast": wireprint.simulate(made.gcode, settings),
        "Comparison": wireprint.compare(mesh, settings, conditions=["wireprint"]),
        "Standing": standing.Standing((("cube.gcode", made.gcode),), settings=settings),
        "Budgeted": budget.within(mesh, settings, budget.Budget(time_s=400)),
        "Orientation": wireprint.orient(mesh, settings),
        "Graph": Graph(np.eye(3), [[0, 1]]),
    }


def test_each_is_a_short_line_that_names_its_class(objects):
    for name, thing in objects.items():
        assert type(thing).__name__ == name.strip()
        shown = repr(thing)
        assert shown.startswith(f"<{name}")
        assert len(shown) < 200, shown
        assert shown.isprintable()
        assert " at 0x" not in shown


def test_they_say_what_matters(objects):
    assert "holds" in repr(objects["Forecast"])
    assert "uncalibrated" in repr(objects["Forecast"])
    assert "cube.gcode" in repr(objects["Standing"])
    assert "wireprint" in repr(objects["Comparison"])
    assert "certified" in repr(objects["Budgeted"])
    assert "best of" in repr(objects["Orientation"])
