"""Arrays of the core's objects are read-only: what several hold, none may change."""

import ast
import inspect
from pathlib import Path

import numpy as np
import pytest

import wireprint
from model_files import amf
from threemf_files import cube_object, encoded, model
from wireprint import Settings, _core, check, estimate, load_mesh, make, simulate

CORNERS = np.eye(3)
FACES = np.array([[0, 1, 2]] * 6)


def arrays(value, name):
    """All arrays in a value, with their names."""
    if isinstance(value, np.ndarray):
        yield name, value
    elif isinstance(value, dict):
        for key, held in value.items():
            yield from arrays(held, f"{name}[{key!r}]")
    elif isinstance(value, list | tuple):
        for i, held in enumerate(value):
            yield from arrays(held, f"{name}[{i}]")


def attributes(thing):
    """All arrays among the attributes of an object."""
    for name, member in inspect.getmembers(type(thing)):
        if inspect.isdatadescriptor(member) and not name.startswith("__"):
            yield from arrays(getattr(thing, name), f"{type(thing).__name__}.{name}")


@pytest.fixture(scope="module")
def made(cube_stl):
    settings = Settings.load(printer="kossel-mini", material="abs")
    return make(load_mesh(cube_stl), settings)


@pytest.fixture(scope="module")
def objects(made):
    """One object of each class of the core that has arrays."""
    return [
        made.mesh,
        made.wireframe,
        made.toolpath,
        check(made.gcode).core,
        _core.slice_mesh(made.mesh, np.array([5.0, 9.0])),
        _core.Strands.from_gcode(made.gcode),
        estimate(made.gcode, per_move=True).per_move,
        simulate(made.gcode).core,
    ]


def returned(made):
    """Yield what the core's functions and methods return."""
    vertices, faces = made.mesh.vertices, made.mesh.faces
    part = model(
        cube_object(attributes={5: f'paint_color="{encoded([0, 0, 2])}"', 2: 'paint_color="8"'})
    )
    _, objects, places = _core.read_model_part([part.encode()])
    yield "read_amf", _core.read_amf([amf().encode()])
    yield "read_model_part", (objects, places)
    [(_, (_, _, painting, *_))] = objects
    yield "Painting.leaves", painting.leaves(CORNERS, FACES)
    yield "Facets.nearest", _core.Facets(vertices, faces).nearest(CORNERS)
    yield "nearest", _core.nearest(np.zeros((3, 4)), np.zeros((2, 4)))
    yield "carve", _core.carve((vertices, faces), [(vertices + 3.0, faces)])
    yield "Wireframe.layers", made.wireframe.layers(made.mesh, 0.35, 0.7)


def test_no_array_can_be_written_to(made, objects):
    found = dict(held for thing in objects for held in attributes(thing))
    for name, value in returned(made):
        own = dict(arrays(value, name))
        assert own, name
        found |= own
    assert [name for name, array in found.items() if array.flags.writeable] == []


def test_every_class_with_arrays_is_looked_at(objects):
    stub = (Path(wireprint.__file__).parent / "_core.pyi").read_text()
    classes = [node for node in ast.parse(stub).body if isinstance(node, ast.ClassDef)]

    def has_arrays(node):
        members = [m for m in node.body if isinstance(m, ast.FunctionDef) and m.decorator_list]
        told = [
            ast.unparse(m.returns)
            for m in members
            if ast.unparse(m.decorator_list[0]) == "property"
        ]
        return any("NDArray" in words or "_Contours" in words for words in told)

    wanted = {node.name for node in classes if has_arrays(node)}
    assert wanted - {"Estimate"} <= {type(thing).__name__ for thing in objects}
