"""Public objects: they say in a line what they are, show themselves in notebooks, and travel."""

import copy
import inspect
import multiprocessing
import pickle

import numpy as np
import pytest

import wireprint
from wireprint import budget, examples, standing, struts, view
from wireprint.regions import Predicate, Region, Sphere
from wireprint.stopped import Stopped

PNG = b"\x89PNG\r\n\x1a\n"


@pytest.fixture(scope="module")
def mesh(tmp_path_factory):
    path = tmp_path_factory.mktemp("models") / "cube.stl"
    path.write_bytes(examples.stl("cube"))
    return wireprint.load_mesh(path)


@pytest.fixture(scope="module")
def made(mesh):
    region = Region().add(Sphere(centre_mm=(14, 0, 14), radius_mm=6))
    return wireprint.make(mesh, wireprint.Settings.load(), region, orient=True, weak=True)


def tripod():
    turns = np.radians([0, 120, 240])
    feet = np.column_stack([14 * np.cos(turns), 14 * np.sin(turns), np.zeros(3)])
    return struts.Graph([*feet, [0, 0, 6]], [[0, 3], [1, 3], [2, 3]])


@pytest.fixture(scope="module")
def objects(mesh, made):
    timed = wireprint.estimate(made.gcode, per_move=True)
    compared = wireprint.compare(mesh, made.settings, ["wireprint", "vase"])
    ordered = struts.order(tripod(), made.settings)
    budgeted = budget.within(mesh, made.settings, budget.Budget(time_s=3600))
    found = [
        mesh,
        made,
        made.wireframe,
        made.toolpath,
        made.certificate,
        made.certificate.core,
        made.estimate,
        made.settings,
        made.orientation,
        made.regions,
        timed,
        wireprint.Model(
            mesh, Region().add(Sphere(centre_mm=(0, 0, 9), radius_mm=4)), made.settings
        ),
        Region().add(Sphere(centre_mm=(0, 0, 9), radius_mm=4)),
        compared,
        compared.conditions[0],
        wireprint.simulate(made.gcode),
        ordered,
        ordered.graph,
        budgeted,
        budgeted.budget,
        budgeted.front[0],
        standing.Standing((("cube.gcode", made.gcode),), settings=made.settings),
        Stopped(z_mm=9.0),
        view.load(made),
        wireprint.settings.describe()[0],
    ]
    return {type(one).__module__ + "." + type(one).__name__: one for one in found}


def state(found):
    """What an object says of itself, in values that compare."""
    if isinstance(found, np.ndarray):
        return found.tobytes()
    if isinstance(found, str | bytes | int | float | None):
        return found
    if isinstance(found, dict):
        return {key: state(value) for key, value in found.items()}
    if type(found).__module__.startswith("wireprint.hybrid"):
        # Its parts are made when they are asked for; what it amounts to is in the figures.
        return type(found).__name__
    if not type(found).__module__.startswith(("wireprint", "builtins")):
        return pickle.dumps(found)
    if isinstance(found, list | tuple):
        return [state(value) for value in found]
    names = [name for name in dir(found) if not name.startswith("_") and name != "model_fields"]
    plain = {}
    for name in names:
        value = getattr(type(found), name, None)
        if callable(value) or name.startswith("model_"):
            continue
        plain[name] = state(getattr(found, name))
    return plain


def test_each_says_what_it_is_in_one_short_line(objects):
    for name, one in objects.items():
        if name.partition(".")[0] == "wireprint" and "hybrid" not in name:
            assert "\n" not in repr(one), name
    for name in ("wire_print.WirePrint", "_core.Mesh", "_core.Wireframe", "_core.Toolpath"):
        assert len(repr(objects[f"wireprint.{name}"])) < 120
    assert "certified" in repr(objects["wireprint.wire_print.WirePrint"])
    assert repr(objects["wireprint.settings.Settings"]) == "<Settings kossel-mini with abs>"


def test_every_class_that_the_library_offers_is_looked_at(objects):
    offered = [getattr(wireprint, name) for name in wireprint.__all__]
    offered += [vars(struts)[name] for name in struts.__all__]
    offered += [vars(budget)[name] for name in budget.__all__]
    offered += [standing.Standing, Stopped]
    for one in offered:
        if inspect.isclass(one) and not issubclass(one, Exception):
            # A region's shapes are classes of their own, which it holds.
            names = {f"{kind.__module__}.{kind.__name__}" for kind in one.__mro__}
            assert names & objects.keys(), one


def arrays_in(one, path="", seen=None):
    """Yield all arrays that are reached from an object by public names, with the way there."""
    seen = {} if seen is None else seen
    # Held, so that no other object gets the same identity.
    if id(one) in seen or isinstance(one, str | bytes | int | float | type | None):
        return
    seen[id(one)] = one
    if isinstance(one, np.ndarray):
        yield path, one
    elif isinstance(one, list | tuple):
        for number, value in enumerate(one):
            yield from arrays_in(value, f"{path}[{number}]", seen)
    elif isinstance(one, dict):
        for key, value in one.items():
            yield from arrays_in(value, f"{path}[{key!r}]", seen)
    elif type(one).__module__.startswith("wireprint"):
        for name in dir(one):
            if not name.startswith(("_", "model_")) and not callable(getattr(one, name)):
                yield from arrays_in(getattr(one, name), f"{path}.{name}", seen)


def test_all_arrays_are_read_only_also_of_copies(objects):
    for name, one in objects.items():
        for twin in (one, copy.copy(one), copy.deepcopy(one), pickle.loads(pickle.dumps(one))):
            found = [path for path, array in arrays_in(twin, name) if array.flags.writeable]
            assert not found, found[:5]


def test_arrays_are_found_wherever_they_are(objects):
    paths = [path for path, _ in arrays_in(objects["wireprint.wire_print.WirePrint"], "made")]
    assert any(path.endswith(".strands") for path in paths)
    assert any(path.startswith("made.regions.plan.laid") for path in paths)


def test_a_pickle_gives_back_the_same(objects):
    for name, one in objects.items():
        again = pickle.loads(pickle.dumps(one))
        assert type(again) is type(one), name
        assert state(again) == state(one), name


def test_what_regions_amount_to_travels_along(made):
    again = pickle.loads(pickle.dumps(made))
    assert again.figures() == made.figures()
    assert again.regions.wireframe.strands.tobytes() == made.regions.wireframe.strands.tobytes()


def test_copies_are_the_same(objects):
    for name, one in objects.items():
        for twin in (copy.copy(one), copy.deepcopy(one)):
            assert state(twin) == state(one), name


def test_what_was_pickled_is_worked_with(made):
    mesh, frame, path = pickle.loads(pickle.dumps((made.mesh, made.wireframe, made.toolpath)))
    assert wireprint.to_gcode(path, made.settings) == wireprint.to_gcode(
        made.toolpath, made.settings
    )
    assert path.mesh.size_mm == mesh.size_mm
    plain = wireprint.wireframe(mesh, made.settings)
    assert np.array_equal(plain.strands, wireprint.wireframe(made.mesh, made.settings).strands)
    assert frame.without([0], 0.7).strand_count == frame.strand_count - 1


def test_a_pickle_of_another_version_is_refused_in_words(mesh):
    call, (state_bytes,) = mesh.__reduce__()
    with pytest.raises(wireprint.SettingError, match="pickled by another version"):
        call(state_bytes[: len(state_bytes) // 2])


def _verdict_of(pair):
    mesh, settings = pair
    return wireprint.make(mesh, settings)


def test_prints_are_made_by_spawned_processes(mesh):
    settings = wireprint.Settings.load()
    with multiprocessing.get_context("spawn").Pool(1) as pool:
        (found,) = pool.map(_verdict_of, [(mesh, settings)])
    assert found.gcode == wireprint.make(mesh, settings).gcode
    assert found.certificate.ok


def test_a_region_of_a_named_function_travels():
    region = Region().add(Predicate(function=_high))
    points = np.array([[0.0, 0.0, 9.0], [0, 0, 1]])
    again = pickle.loads(pickle.dumps(region))
    assert again.covers(points, points).tolist() == [True, False]


def _high(points):
    return points[:, 2] > 5


def test_notebooks_are_shown_a_picture_and_the_verdict(made, mesh):
    assert made._repr_png_().startswith(PNG)
    page = made._repr_html_()
    assert "data:image/png;base64," in page
    assert "certified" in page
    assert f"{made.estimate.total_s // 60:.0f}:" in page
    assert mesh._repr_png_().startswith(PNG)
    assert made.certificate._repr_png_().startswith(PNG)


def test_nothing_is_drawn_before_it_is_shown(mesh, monkeypatch):
    drawn = []
    monkeypatch.setattr("wireprint.notebook.render_png", lambda *_, **__: drawn.append(1) or b"")
    made = wireprint.make(mesh)
    repr(made)
    assert not drawn
    made._repr_png_()
    assert drawn


def test_pictures_are_drawn_of_bytes_results_and_paths(made, tmp_path):
    path = tmp_path / "cube.gcode"
    path.write_bytes(made.gcode)
    size = (200, 150)
    drawn = {view.render_png(one, size=size) for one in (made.gcode, made, path, str(path))}
    assert len(drawn) == 1
    assert view.render_html(made.gcode, title="a") == view.render_html(made, title="a")


def test_a_certificate_is_drawn_with_its_breaches():
    bad = wireprint.check(b"G28\nG90\nM83\nG1 X0 Y0 Z5 F900\nG1 X20 E3\nG1 X40 E3\n")
    assert not bad.ok
    page = view.render_html(bad)
    plain = view.render_html(view.load(bad))
    assert len(page) != len(plain)
