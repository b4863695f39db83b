"""Wire prints with regions of layers: what is marked is layers, what is not stays wire."""

import re
from types import SimpleNamespace

import numpy as np
import pytest
from hypothesis import HealthCheck, assume, given, settings
from hypothesis import strategies as st
from scipy.spatial import cKDTree

from test_random_models import BALL, blob, tower
from wireprint import examples
from wireprint._core import KINDS, Mesh
from wireprint.certificate import check
from wireprint.hybrid import prove
from wireprint.hybrid.motion import motion
from wireprint.hybrid.plan import Plan
from wireprint.layerwise.areas import areas
from wireprint.layerwise.printing import layered
from wireprint.layerwise.recipe import Recipe
from wireprint.mesh import load_mesh
from wireprint.pipeline import make
from wireprint.regions import Box, HalfSpace, Mask, Predicate, Region, Sphere, ZRange
from wireprint.settings import Settings

LAYERWISE, FILL, CONTOUR, POST, CAP = (
    KINDS.index(kind) for kind in ("layer-wise", "layer-fill", "contour", "post", "cap")
)
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


def away(made, points):
    """Distance of points from the strands' centrelines, mm, by points along these."""
    ends = made.wireframe.strands
    count = np.ceil(np.linalg.norm(ends[:, 1] - ends[:, 0], axis=1) / 0.1).astype(int) + 1
    which = np.repeat(np.arange(len(ends)), count)
    rank = np.arange(len(which)) - np.repeat(np.cumsum(count) - count, count)
    share = (rank / np.maximum(count[which] - 1, 1))[:, None]
    return cKDTree(ends[which, 0] * (1 - share) + ends[which, 1] * share).query(points)[0]


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
    np.testing.assert_allclose(made.wireframe.strands[: len(same)], same, atol=1e-9)


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


def test_all_marked_is_an_ordinary_layer_print(models):
    """Same walls, same fill: what differs is the first layer and the heights rounded to slabs."""
    cube = models("cube")
    chosen = Settings.load(
        overrides=["gcode.thumbnails=[]", "regions.inset=0.5", "layerwise.width_ratio=1"]
    )
    made = make(cube, chosen, Region().add(ZRange()), compare=False)
    assert made.certificate.ok
    assert all(run.whole for run in made.regions.plan.sections)
    recipe = Recipe.of(chosen.layerwise, chosen.printer)
    plain = layered(areas(cube, recipe.layer_mm, recipe.resolution_mm), recipe)
    layers = len(made.regions.plan.cut.z)
    per_layer_mm = plain.figures()["strand_mm"] / 140
    lines = np.concatenate([strands(made, LAYERWISE), strands(made, FILL)])
    above = lines[lines[:, 0, 2] > chosen.first_layer_height_mm]
    length_mm = np.linalg.norm(above[:, 1] - above[:, 0], axis=1).sum()
    assert length_mm / layers == pytest.approx(per_layer_mm, rel=0.01)
    kinds = set(made.wireframe.strand_kinds.tolist())
    assert kinds <= {LAYERWISE, FILL, CONTOUR, CAP}
    assert strands(made, CONTOUR)[..., 2].max() == chosen.first_layer_height_mm


def test_marked_surface_comes_as_near_as_layers_the_rest_stays_as_it_was(models):
    bottle = models("bottle", height_mm=90)
    ball = Sphere(centre_mm=(0, -15, 45), radius_mm=14)
    made, plain = printed(bottle, ball), make(bottle, SETTINGS)
    samples = made.regions.plan.samples
    inside = made.regions.plan.runs.of_sample >= 0
    near, far = (away(print_, samples.middle) for print_ in (made, plain))
    assert np.mean(near[inside]) < SETTINGS.regions.layer_height_mm / 2
    assert np.mean(far[inside]) > 3 * np.mean(near[inside])
    outside = ~inside & (np.abs(samples.middle[:, 2] - 45) > 25)
    assert np.mean(near[outside]) == pytest.approx(np.mean(far[outside]), rel=0.1)


def test_the_runs_are_arrays_that_lie_on_their_contours(models):
    made = printed(models("bottle", height_mm=90), Sphere(centre_mm=(0, -15, 45), radius_mm=14))
    runs = made.regions.runs
    contours = made.wireframe.contours_below
    assert len(runs["slab"]) > 1
    for slab, contour, begin, end in zip(
        runs["slab"], runs["contour"], runs["from_mm"], runs["to_mm"], strict=True
    ):
        number = contours["slice_offsets"][slab + 1] + contour
        points = contours["points"][contours["offsets"][number] : contours["offsets"][number + 1]]
        length = np.hypot(*np.diff(points, axis=0, append=points[:1]).T).sum()
        assert 0 <= begin < length
        assert SETTINGS.regions.shortest_run * 0.7 <= end - begin <= length


def filling(made):
    """Strands behind the outer walls, and how deep below the surface their ends lie, mm."""
    found = strands(made, FILL)
    return found, distances(made, found.reshape(-1, 3)).reshape(-1, 2)


def test_the_inside_of_a_box_is_filled_from_wall_to_wall(models):
    made = printed(models("cube"), Box(low_mm=(-20, -20, 10), high_mm=(2, 20, 20)))
    assert made.certificate.ok
    report = made.figures()["regions"]
    # 14 + 2 mm deep behind two walls, as high as the box where its runs are, minus its corners.
    low = strands(made, FILL)[..., 2].min()
    whole = 16 * 28 * (20 - low)
    assert 0.85 * whole < report["filled_mm3"] < whole
    assert strands(made, FILL)[..., 0].max() <= 2 + 1e-9 + SETTINGS.printer.head.nozzle_mm
    assert not strands(made, FILL)[strands(made, FILL)[..., 2].max(axis=1) < low].size


def test_fill_that_begins_above_hollow_begins_with_bridges(models):
    made = printed(models("cube"), Box(low_mm=(-20, -20, 10), high_mm=(2, 20, 20)))
    found, depth = filling(made)
    low = found[..., 2].min()
    first = found[(found[..., 2].max(axis=1) == low) & (depth.min(axis=1) > 0)]
    way = first[:, 1] - first[:, 0]
    long = np.linalg.norm(way, axis=1) > 10
    inner = np.abs(first[:, :, 0]).max(axis=1) < 13
    # Straight across, from one painted side to the other; the open side is not leant upon.
    assert (long & inner).sum() >= 3
    np.testing.assert_allclose(way[long & inner, 0], 0.0, atol=1e-6)


def test_what_could_only_hang_stays_hollow_and_is_named(models):
    ball = Sphere(centre_mm=(0, -15, 45), radius_mm=14)
    made = printed(models("bottle", height_mm=90), ball)
    assert made.certificate.ok
    report = made.figures()["regions"]
    assert report["filled_mm3"] > 0
    hollow = {part["reason"]: part for part in report["hollow"]}
    assert hollow["over_hollow"]["high_mm"] < 45
    assert all(part["help"] and part["volume_mm3"] > 0 for part in report["hollow"])


def test_a_lid_is_closed_once_where_layers_lie_below_it(models):
    made = printed(models("cube"), Box(low_mm=(0, -20, 12), high_mm=(20, 0, 40)))
    assert made.certificate.ok
    top = strands(made, CAP)
    middle = top[top[..., 2].min(axis=1) == 28].mean(axis=1)
    assert len(middle) > 4
    assert not ((middle[:, 0] > 1) & (middle[:, 1] < -1)).any()
    closed = strands(made, FILL)
    closed = closed[closed[..., 2].min(axis=1) == 28]
    area = np.linalg.norm(closed[:, 1] - closed[:, 0], axis=1).sum() * 0.7
    assert area == pytest.approx(14 * 14, rel=0.15)


@pytest.fixture
def planted(monkeypatch):
    """Let the first print of a region have one more breach, at a place of its plan, for good."""

    def plant(place_of):
        judge, plan_of, plans, found = prove.check, Plan.of, [], []

        def kept(*arguments):
            plans.append(plan_of(*arguments))
            return plans[0]

        def check(text, settings):
            verdict = judge(text, settings)
            if found:
                return verdict
            place = np.add(place_of(plans[0]), (*settings.printer.bed.centre_mm, 0.0))
            breaches = verdict.breaches()
            breaches["floating_starts"] = [SimpleNamespace(at_mm=tuple(place))]
            found.append(place)
            return SimpleNamespace(breaches=lambda: breaches)

        monkeypatch.setattr(Plan, "of", kept)
        monkeypatch.setattr(prove, "check", check)
        monkeypatch.setattr(prove, "mended", lambda *_, **__: None)
        return plans

    return plant


def test_a_slab_whose_fill_breaks_a_rule_stays_hollow_and_keeps_its_runs(models, planted):
    def deep_inside(plan):
        low = plan.cut.z[plan.cut.slab == plan.sections[0].slab][-1]
        return np.array([-6.0, 0.0, low])

    plans = planted(deep_inside)
    made = printed(models("cube"), Box(low_mm=(-20, -20, 10), high_mm=(2, 20, 20)))
    plan, left = plans[0], made.regions.plan
    assert made.certificate.ok
    assert made.regions.rounds == 2
    assert left.sections == plan.sections
    slab = plan.sections[0].slab
    here = [left.filled_at(np.array([-6.0, 0.0, z])) for z in plan.cut.z[plan.cut.slab == slab]]
    assert here == [None] * len(here)
    (named,) = (part for part in left.left_hollow() if part.reason == "overhang")
    assert named.volume_mm3 == pytest.approx(plan.filled_mm3 - left.filled_mm3, rel=0.2)
    assert 0 < left.filled_mm3 < plan.filled_mm3


def test_a_run_that_breaks_a_rule_stays_wire_and_is_named(models, planted):
    plans = planted(lambda plan: plan.samples.middle[np.flatnonzero(plan.runs.of_sample == 0)[0]])
    made = printed(
        models("bottle", height_mm=90), Box(low_mm=(-40, -40, 20), high_mm=(40, -10, 60))
    )
    assert made.certificate.ok
    assert made.regions.rounds == 2
    lost = plans[0].sections[0]
    assert lost not in made.regions.plan.sections
    assert len(made.regions.plan.sections) == len(plans[0].sections) - 1
    dropped = made.figures()["regions"]["dropped"]
    assert [(run["slab"], run["reason"]) for run in dropped] == [(lost.slab, "overhang")]


def test_what_was_mended_is_a_whole_file_with_its_pictures_and_judged_as_such(
    models, planted, monkeypatch
):
    planted(lambda plan: plan.samples.middle[np.flatnonzero(plan.runs.of_sample == 0)[0]])
    judged = []

    def mended(strands, *_, judge, **__):
        judged.append(judge(strands))
        return strands

    monkeypatch.setattr(prove, "mended", mended)
    region = Region().add(Box(low_mm=(-20, -20, 10), high_mm=(2, 20, 12)))
    made = make(models("cube"), Settings.load("prusa-mk4s", "pla"), region)
    sizes = made.settings.printer.gcode.thumbnails
    assert len(re.findall(rb"; thumbnail\w* begin", made.gcode)) == len(sizes) > 0
    own, anew = made.certificate.core, check(made.gcode, made.settings).core
    np.testing.assert_array_equal(own.strand_lines, anew.strand_lines)
    # The draft that was judged in between has none, and so fewer lines.
    assert judged[0].core.strand_lines[0] < own.strand_lines[0]


def test_paint_has_no_inside(models):
    import trimesh

    bottle = models("bottle", height_mm=90)
    ball = Sphere(centre_mm=(0, -15, 45), radius_mm=14)
    mesh = trimesh.Trimesh(bottle.vertices, bottle.faces)
    middles = np.asarray(mesh.triangles_center)
    paint = Mask(
        vertices=np.asarray(mesh.vertices, np.float64),
        faces=np.asarray(mesh.faces, np.uint32),
        marked=ball.covers(middles, middles),
    )
    made = printed(bottle, paint)
    assert made.regions.plan.sections
    assert made.figures()["regions"]["filled_mm3"] == 0
    assert filling(made)[1].max() < 2 * SETTINGS.printer.head.nozzle_mm


def test_wire_is_the_same_whether_the_inside_is_filled_or_not(models):
    ball = Sphere(centre_mm=(0, -18, 18), radius_mm=12)
    sphere = models("sphere", height_mm=45)
    hollow = Settings.load(overrides=["gcode.thumbnails=[]", "regions.infill_density=0"])
    made = printed(sphere, ball)
    without = make(sphere, hollow, Region().add(ball))
    assert made.figures()["regions"]["filled_mm3"] > 500
    assert without.figures()["regions"]["filled_mm3"] == 0
    np.testing.assert_array_equal(strands(made, POST), strands(without, POST))


@pytest.mark.parametrize(
    ("name", "shape"),
    [
        ("sphere", Sphere(centre_mm=(0, -45, 45), radius_mm=15)),
        ("bottle", Box(low_mm=(-40, -40, 20), high_mm=(40, -10, 60))),
    ],
)
def test_outside_a_region_posts_and_contours_are_those_of_the_plain_print(models, name, shape):
    mesh = models(name, height_mm=90)
    made, plain = printed(mesh, shape, certify=False), make(mesh, SETTINGS, certify=False)
    lines = np.concatenate([strands(made, LAYERWISE), strands(made, FILL)])
    near = cKDTree(lines[:, 0, :2])
    # Slanted ends reach this far at most, and may lead up to the next post but one.
    reach = 2 * (SETTINGS.slab_max_mm / np.tan(np.radians(32)) + 0.5)
    for kind in (POST, CONTOUR):
        wanted, found = (np.sort(strands(p, kind), axis=1).reshape(-1, 6) for p in (plain, made))
        far = near.query(wanted[:, :2])[0] > reach
        missing = cKDTree(found).query(wanted[far])[0] > 1e-6
        assert far.sum() > 25
        assert not missing.any()


SHAPE = st.tuples(
    st.sampled_from(["box", "sphere", "z", "half", "predicate"]),
    *[st.floats(0, 1)] * 3,
    st.floats(0.1, 0.6),
)


def shape_on(mesh, kind, x, y, z, size):
    low, high = mesh.bounds
    centre = low + np.array([x, y, z]) * (high - low)
    reach = size * float(np.max(high - low)) / 2
    if kind == "sphere":
        return Sphere(centre_mm=centre.tolist(), radius_mm=reach)
    if kind == "box":
        return Box(low_mm=(centre - reach).tolist(), high_mm=(centre + reach).tolist())
    if kind == "half":
        normal = np.array([x - 0.5, y - 0.5, 0.6 * z - 0.29])
        ahead = float(centre @ normal / np.linalg.norm(normal))
        return HalfSpace(normal=normal.tolist(), offset_mm=ahead)
    if kind == "predicate":
        return Predicate(function=lambda points: np.abs(points - centre).sum(axis=1) < 2 * reach)
    return ZRange(low_mm=centre[2] - reach, high_mm=centre[2] + reach)


#: Least share of random regions of which something is printed as layers.
LAYERED = 0.6


@pytest.fixture
def certified_or_refused_by_name():
    """Judge random regions; of all of a test's, the most must come to layers."""
    layered = []

    def judge(vertices, faces, marks):
        mesh = Mesh.from_arrays(vertices, faces)
        region = Region()
        for erase, mark in marks:
            shape = shape_on(mesh, *mark)
            region = region.erase(shape) if erase else region.add(shape)
        made = make(mesh, SETTINGS, region, compare=False)
        if not made.certificate.ok:
            # Only where the wire alone breaks the rules, and then all of it stays wire.
            assert not make(mesh, SETTINGS, compare=False).certificate.ok
        if region:
            report = made.figures()["regions"]
            named = report["dropped"] + report["hollow"]
            assert all(part["reason"] and part["help"] for part in named)
            if report["runs"] or report["dropped"]:
                layered.append(report["layer_wise_mm"] > 0)

    yield judge
    assert sum(layered) >= LAYERED * len(layered) > 0


few = settings(
    max_examples=8,
    suppress_health_check=[HealthCheck.too_slow, HealthCheck.function_scoped_fixture],
)
MARKS = st.lists(st.tuples(st.booleans(), SHAPE), min_size=1, max_size=3)


@few
@given(st.lists(st.floats(6, 30), min_size=2, max_size=4), st.integers(2, 7), MARKS, st.data())
def test_random_regions_on_random_towers(certified_or_refused_by_name, radii, lobes, marks, data):
    steps = len(radii) - 1
    heights = data.draw(st.lists(st.floats(2, 15), min_size=steps, max_size=steps))
    certified_or_refused_by_name(*tower(radii, heights, lobes, 0.25), marks)


@few
@given(st.lists(BALL, min_size=1, max_size=5), MARKS)
def test_random_regions_on_random_blobs(certified_or_refused_by_name, balls, marks):
    try:
        vertices, faces = blob(balls)
    except ValueError:
        assume(False)
    certified_or_refused_by_name(vertices, faces, marks)


def test_a_marked_lid_is_closed_side_by_side_though_its_walls_are_wire(models):
    made = printed(models("cube"), ZRange(low_mm=27.9))
    assert made.certificate.ok
    lid = strands(made, LAYERWISE)
    assert set(lid[..., 2].ravel()) == {28.0}
    area = np.linalg.norm(lid[:, 1] - lid[:, 0], axis=1).sum() * SETTINGS.printer.head.nozzle_mm
    assert area == pytest.approx(28 * 28, rel=0.1)
    assert len(strands(made, POST)) == len(strands(make(models("cube"), SETTINGS), POST))
