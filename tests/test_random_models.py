"""What is made of models that nobody thought of is certified; few are refused, and as a whole."""

import numpy as np
import pytest
import shapely
import trimesh
from click.testing import CliRunner
from hypothesis import HealthCheck, assume, given, settings
from hypothesis import strategies as st

from wireprint import _implicit
from wireprint._core import Mesh
from wireprint.cli import main
from wireprint.pipeline import make
from wireprint.settings import Settings
from wireprint.wholeness import IncompleteError

#: Ways to print, as arguments of ``wireprint slice``.
WAYS = st.sampled_from(
    [
        (),
        ("--pattern", "peaks"),
        ("--printer", "prusa-mk4s", "--pattern", "peaks"),
        ("--printer", "voron-2.4"),
        ("--supports", "none", "--no-caps"),
    ]
)
random = settings(
    max_examples=25,
    suppress_health_check=[HealthCheck.too_slow, HealthCheck.function_scoped_fixture],
)


#: Least share of random models that are certified.
CERTIFIED = 0.9


@pytest.fixture
def certified_or_refused(tmp_path):
    """Judge random models; of all of a test's, the most must be certified."""
    folder, verdicts = tmp_path, []

    def judge(vertices, faces, way):
        mesh = Mesh.from_arrays(vertices, faces)
        try:
            certificate = make(mesh, chosen(way), compare=False, partial=True).certificate
        except IncompleteError:
            verdicts.append(False)
            return
        verdicts.append(certificate.ok)
        assert not certificate.collisions
        if not certificate.ok:
            model, target = folder / "model.stl", folder / "model.gcode"
            trimesh.Trimesh(vertices, faces, process=False).export(model)
            done = CliRunner().invoke(main, ["slice", str(model), "-o", str(target), *way])
            assert done.exit_code == 5
            assert not target.exists()

    yield judge
    assert len(verdicts) >= 10
    assert sum(verdicts) >= CERTIFIED * len(verdicts)


def chosen(way):
    options = dict(zip(way[::2], way[1::2], strict=False))
    overrides = ["wire.supports=none", "wire.caps=false"] if "--no-caps" in way else []
    overrides += [f"wire.pattern={options['--pattern']}"] if "--pattern" in options else []
    return Settings.load(options.get("--printer", "kossel-mini"), overrides=overrides)


def tower(radii, heights, lobes, depth):
    """A stack of star-shaped rings, closed at both ends."""
    corners = 8 * max(lobes, 2)
    turn = np.linspace(0, 2 * np.pi, corners, endpoint=False)
    star = 1 + depth * np.cos(lobes * turn)
    rings = [
        np.column_stack([r * star * np.cos(turn), r * star * np.sin(turn), np.full(corners, z)])
        for r, z in zip(radii, np.cumsum([0, *heights]), strict=True)
    ]
    bottom, top = rings[0].mean(axis=0), rings[-1].mean(axis=0)
    vertices = np.vstack([*rings, bottom, top])
    here = np.arange(corners)
    ahead = (here + 1) % corners
    faces = []
    for k in range(len(rings) - 1):
        a, b = k * corners, (k + 1) * corners
        faces += [np.column_stack([a + here, a + ahead, b + ahead])]
        faces += [np.column_stack([a + here, b + ahead, b + here])]
    last = (len(rings) - 1) * corners
    faces += [np.column_stack([ahead, here, np.full(corners, len(vertices) - 2)])]
    faces += [np.column_stack([last + here, last + ahead, np.full(corners, len(vertices) - 1)])]
    return vertices, np.vstack(faces).astype(np.int64)


@random
@given(
    st.lists(st.floats(6, 40), min_size=2, max_size=6),
    st.data(),
    st.integers(2, 7),
    st.floats(0, 0.4),
    WAYS,
)
def test_towers(certified_or_refused, radii, data, lobes, depth, way):
    steps = len(radii) - 1
    heights = data.draw(st.lists(st.floats(1, 25), min_size=steps, max_size=steps))
    certified_or_refused(*tower(radii, heights, lobes, depth), way)


def disc(rim_mm):
    """A disc around a stem, whose rim is so thick where it begins and ends in an edge."""
    half = rim_mm / 2
    return Mesh.from_arrays(*tower([10, 10, 30, 10, 10], [20, half, half, 20], 2, 0.0))


def test_a_rim_between_two_slices_is_printed():
    # Half as thick as the lowest slab.
    figures = make(disc(1.2), Settings.load()).figures()
    assert figures["certified"]
    assert figures["coverage"] > 0.99


def test_what_is_too_flat_to_be_followed_is_named():
    # Half as thick as a strand.
    mesh = disc(0.3)
    figures = make(mesh, Settings.load(), partial=True).figures()
    assert figures["certified"]
    assert not figures["whole"]
    assert figures["coverage"] < 0.95
    [part] = figures["unprinted"]
    assert part["reason"] == "not_covered"
    assert part["low_mm"] > 15
    assert part["high_mm"] < 25
    assert part["area_mm2"] > 0.05 * mesh.area


BALL = st.tuples(*[st.floats(-22, 22)] * 3, st.floats(5, 15))


def blob(balls):
    """Balls that flow into each other where they come close: islands, branches, hollows."""
    centres, radii = np.array(balls)[:, :3], np.array(balls)[:, 3]

    def outside(x, y, z):
        field = [
            np.exp(1 - ((x - a) ** 2 + (y - b) ** 2 + (z - c) ** 2) / r**2)
            for (a, b, c), r in zip(centres, radii, strict=True)
        ]
        return 1 - sum(field)

    low, high = centres.min(axis=0) - 28, centres.max(axis=0) + 28
    corners = _implicit.surface(outside, tuple(low), tuple(high), 2.5)
    return corners.reshape(-1, 3), np.arange(3 * len(corners)).reshape(-1, 3)


@random
@given(st.lists(BALL, min_size=1, max_size=6), WAYS)
def test_blobs(certified_or_refused, balls, way):
    certified_or_refused(*blob(balls), way)


PLACE = st.tuples(st.floats(-25, 25), st.floats(-25, 25))
STAR = st.lists(st.floats(0.5, 1), min_size=3, max_size=8)
HOLE = st.tuples(STAR, st.floats(2, 18), PLACE)
#: Outlines, holes in them, the wall that is left of their inside (0: all of it), height.
STOREY = st.tuples(
    st.lists(st.tuples(STAR, st.floats(8, 40), PLACE), min_size=1, max_size=3),
    st.lists(HOLE, max_size=3),
    st.sampled_from([0.0, 0.0, 1.5, 5.0]),
    st.floats(1.5, 20),
)


def star(reaches, radius, place):
    angles = np.linspace(0, 2 * np.pi, len(reaches), endpoint=False)
    points = radius * np.array(reaches) * (np.cos(angles), np.sin(angles))
    return shapely.Polygon(points.T + place)


def extruded(polygon, low, high):
    """A prism: walls along every ring, and both ends."""
    facets = []
    rings = [polygon.exterior, *polygon.interiors]
    for ring in rings:
        points = np.array(ring.coords)
        here, ahead = points[:-1], points[1:]

        def at(plan, z):
            return np.column_stack([plan, np.full(len(plan), z)])

        facets.append(np.stack([at(here, low), at(ahead, low), at(ahead, high)], axis=1))
        facets.append(np.stack([at(here, low), at(ahead, high), at(here, high)], axis=1))
    for triangle in shapely.constrained_delaunay_triangles(polygon).geoms:
        plan = np.array(shapely.geometry.polygon.orient(triangle).exterior.coords)[:3]
        facets.append(np.column_stack([plan, np.full(3, high)])[None])
        facets.append(np.column_stack([plan[::-1], np.full(3, low)])[None])
    return np.concatenate(facets)


def prisms(storeys):
    """Storeys one upon the other, each with islands, holes and nested walls of its own."""
    facets, low = [], 0.0
    for outlines, holes, wall, height in storeys:
        plan = shapely.union_all([star(*outline) for outline in outlines])
        if wall:
            plan = plan.difference(plan.buffer(-wall))
        plan = plan.difference(shapely.union_all([star(*hole) for hole in holes]))
        for part in getattr(plan, "geoms", [plan]):
            if part.area > 8:
                oriented = shapely.geometry.polygon.orient(part)
                facets.append(extruded(oriented, low, low + height))
        low += height
    corners = np.concatenate(facets) if facets else np.empty((0, 3, 3))
    return corners.reshape(-1, 3), np.arange(3 * len(corners)).reshape(-1, 3)


@random
@given(st.lists(STOREY, min_size=1, max_size=4), WAYS)
def test_prisms_with_holes(certified_or_refused, storeys, way):
    vertices, faces = prisms(storeys)
    assume(len(faces) > 0)
    certified_or_refused(vertices, faces, way)
