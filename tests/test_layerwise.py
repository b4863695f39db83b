"""The layer slicer, held to solids whose answer is known."""

import numpy as np
import pytest
import shapely

import wireprint
from wireprint import examples
from wireprint._core import KINDS
from wireprint.layerwise import areas, chains, edges, frame, struts, threads
from wireprint.layerwise.hatch import hatched
from wireprint.layerwise.lines import Lines
from wireprint.layerwise.printing import layered
from wireprint.layerwise.recipe import Recipe
from wireprint.layerwise.shells import Shells, split
from wireprint.layerwise.vase import spiral
from wireprint.layerwise.walls import walls

LAYERWISE, TRAVEL = KINDS.index("layer-wise"), KINDS.index("travel")
RETRACT = KINDS.index("retract")


def settings(*overrides):
    return wireprint.Settings.load(overrides=overrides)


def recipe(*overrides):
    chosen = settings(*overrides)
    return Recipe.of(chosen.layerwise, chosen.printer)


def squares(*sides):
    return np.array([shapely.box(-side / 2, -side / 2, side / 2, side / 2) for side in sides])


@pytest.fixture(scope="module")
def cube(tmp_path_factory):
    path = tmp_path_factory.mktemp("layerwise") / "cube.stl"
    path.write_bytes(examples.stl("cube"))
    return wireprint.load_mesh(path)


@pytest.fixture(scope="module")
def sphere(tmp_path_factory):
    path = tmp_path_factory.mktemp("layerwise") / "sphere.stl"
    path.write_bytes(examples.stl("sphere"))
    return wireprint.load_mesh(path)


def volume(path, chosen):
    radius = chosen.printer.extruder.filament_diameter_mm / 2
    return path.filament[path.kind == LAYERWISE].sum() * np.pi * radius**2


def test_a_layer_covers_what_the_model_does_at_its_middle(sphere):
    found = shapely.area(areas.areas(sphere, 0.5, 0.0))
    z = (np.arange(len(found)) + 0.5) * 0.5 - 39
    exact = np.pi * (39**2 - z**2)
    assert found == pytest.approx(exact, rel=0.01, abs=6.0)


def test_walls_run_half_a_line_and_then_a_spacing_inside_the_contour():
    inner, outer = walls(squares(20.0), 2, inset_mm=0.4, spacing_mm=0.75, overlap_mm=0.2).lines
    assert outer.lengths_mm() == pytest.approx([4 * (20 - 0.8)])
    assert inner.lengths_mm() == pytest.approx([4 * (20 - 0.8 - 2 * 0.75)])


def test_a_wall_that_does_not_fit_is_left_out():
    inner, outer = walls(squares(2.0), 2, inset_mm=0.4, spacing_mm=0.75, overlap_mm=0.2).lines
    assert len(outer) == 1
    assert len(inner) == 0


@pytest.mark.parametrize("turn", [0.0, 0.3, np.pi / 4, -np.pi / 4])
@pytest.mark.parametrize("spacing", [0.75, 7.5])
def test_hatching_is_as_dense_as_its_spacing_says(turn, spacing):
    areas_ = squares(100.0, 60.0)
    lines = hatched(areas_, np.full(2, turn), spacing, line_mm=0.1, link_mm=0.0)
    found = np.bincount(lines.owner, lines.lengths_mm())
    assert found == pytest.approx(shapely.area(areas_) / spacing, rel=0.08)


def test_hatching_stays_inside_and_leaves_holes_open():
    ring = shapely.Point(0, 0).buffer(20).difference(shapely.Point(3, 0).buffer(8))
    lines = hatched(np.array([ring]), np.array([0.7]), 2.0, line_mm=0.4, link_mm=10.0)
    drawn = shapely.linestrings(
        lines.points, indices=np.repeat(np.arange(len(lines)), np.diff(lines.offsets))
    )
    # Links may stray by half a line where the rim is hollow.
    assert shapely.covers(ring.buffer(0.3), drawn).all()


def test_the_lines_of_a_square_join_to_one():
    lines = hatched(squares(30.0), np.array([np.pi / 4]), 3.0, line_mm=0.5, link_mm=50.0)
    assert len(lines) == 1


def test_a_box_is_solid_only_near_its_bottom_and_top():
    layers = np.repeat(squares(30.0), 20)
    shells = Shells(bottom=3, top=2, line_mm=0.8, anchor_mm=0.0, smallest_mm2=0.0)
    solid, sparse = split(np.repeat(squares(27.0), 20), np.arange(20), layers, shells)
    assert np.flatnonzero(~shapely.is_empty(solid)).tolist() == [0, 1, 2, 18, 19]
    assert shapely.area(solid) + shapely.area(sparse) == pytest.approx(27.0**2)


def test_under_a_step_the_ledge_alone_is_solid():
    layers = np.concatenate([np.repeat(squares(30.0), 10), np.repeat(squares(15.0), 10)])
    shells = Shells(bottom=0, top=1, line_mm=0.8, anchor_mm=0.0, smallest_mm2=0.0)
    solid, _ = split(layers.copy(), np.arange(20), layers, shells)
    assert shapely.area(solid[9]) == pytest.approx(30.0**2 - 15.0**2)
    assert shapely.is_empty(solid[8])


def test_a_ledge_reaches_over_the_sparse_fill_beside_it():
    layers = np.concatenate([np.repeat(squares(30.0), 10), np.repeat(squares(15.0), 10)])
    shells = Shells(bottom=0, top=1, line_mm=0.8, anchor_mm=2.0, smallest_mm2=0.0)
    solid, sparse = split(layers.copy(), np.arange(20), layers, shells)
    assert sparse[9].area == pytest.approx((15.0 - 2 * 2.0) ** 2)
    assert solid[9].area == pytest.approx(30.0**2 - sparse[9].area)


def test_full_infill_extrudes_the_volume_of_the_model(cube):
    chosen = settings("layerwise.infill_density=1")
    made = recipe("layerwise.infill_density=1")
    path = layered(areas.areas(cube, made.layer_mm, made.resolution_mm), made)
    assert volume(path, chosen) == pytest.approx(28.0**3, rel=0.03)


def test_a_print_stays_inside_its_model_and_climbs(cube):
    made = recipe()
    path = layered(areas.areas(cube, made.layer_mm, made.resolution_mm), made)
    reach = 14 - made.width_mm / 2
    assert np.abs(path.to[:, :2]).max() == pytest.approx(reach)
    assert (np.diff(path.to[:, 2]) >= 0).all()
    assert path.top_mm == pytest.approx(28.0)


def test_every_retraction_is_taken_back(cube):
    made = recipe()
    path = layered(areas.areas(cube, made.layer_mm, made.resolution_mm), made)
    fed = path.filament[path.kind != LAYERWISE]
    assert fed.sum() == pytest.approx(0.0)
    assert (path.kind == RETRACT).sum() > 100
    assert not path.filament[path.kind == TRAVEL].any()


def test_speed_is_bounded_by_what_the_hot_end_melts():
    made = recipe("layerwise.print_mm_s=500", "layerwise.max_flow_mm3_s=10")
    assert made.rates.print_mm_s * made.layer_mm * made.spacing_mm == pytest.approx(10.0)


def test_nothing_as_wide_as_a_line_is_refused():
    with pytest.raises(wireprint.ModelError, match="as wide as a line"):
        layered(squares(0.3), recipe())


def test_a_vase_has_one_wall_that_never_stops(sphere):
    made = recipe()
    path = spiral(areas.areas(sphere, made.layer_mm, made.resolution_mm), made)
    above = path.to[:, 2] > 1.5 * made.layer_mm
    assert (path.kind[above][1:] == LAYERWISE).all()
    assert (np.diff(path.to[:, 2]) >= -1e-9).all()


@pytest.mark.parametrize(
    ("beam", "area"),
    [
        ([[0, 0, 0], [0, 0, 20]], 4.0),
        ([[0, 0, 10], [20, 0, 10]], 2.0 * 22.0),
        ([[0, 0, 0], [20, 0, 20]], 2.0 * 2.0 * np.sqrt(2)),
    ],
    ids=["upright", "flat", "at 45°"],
)
def test_a_beams_section_has_the_area_of_a_square_bars(beam, area):
    sections = frame.sections(np.array([beam], float), 2.0, layer_mm=0.2, layers=100)
    assert sections[50].area == pytest.approx(area)


def test_a_cube_has_its_twelve_edges(cube):
    wires = edges.of_model(cube, settings().layerwise.frame)
    lengths = np.linalg.norm(wires[:, 1] - wires[:, 0], axis=1)
    assert lengths == pytest.approx(np.full(12, 28.0))


def test_a_smooth_model_gets_rings_and_posts(sphere):
    wires = edges.of_model(sphere, settings().layerwise.frame)
    rise = np.abs(wires[:, 1, 2] - wires[:, 0, 2])
    assert (rise == 0).sum() > 20
    assert (rise > 1).sum() > 20
    assert np.linalg.norm(wires - [0, 0, 39], axis=2).max() < 39.5


def test_a_cubes_top_edges_stand_on_struts_at_45_degrees(cube):
    wires = edges.of_model(cube, settings().layerwise.frame)
    found = struts.under(wires, beam_mm=2.0, bridge_mm=20.0)
    down = found[:, 1] - found[:, 0]
    assert len(found) == 8
    assert np.hypot(down[:, 0], down[:, 1]) == pytest.approx(-down[:, 2])
    assert found[:, 0, 2] == pytest.approx(np.full(8, 28.0))
    assert found[:, 1, 2] == pytest.approx(np.full(8, 14.0), abs=0.01)


def test_edges_join_where_two_meet_and_part_where_three_do():
    found = chains.chains(np.array([[0, 1], [1, 2], [2, 3], [2, 4], [5, 6], [6, 7], [7, 5]]))
    assert sorted(len(chain) for chain in found) == [2, 2, 3, 4]
    ring = next(chain for chain in found if len(chain) == 4)
    assert ring[0] == ring[-1]


def test_thinning_keeps_corners_and_drops_what_lies_between():
    line = np.array([[0, 0, 0], [5, 0, 0.1], [10, 0, 0], [10, 4, 0], [10, 10, 0]], float)
    assert chains.thinned(line, 0.5).tolist() == [[0, 0, 0], [10, 0, 0], [10, 10, 0]]


def test_threads_keep_the_order():
    circles = shapely.buffer(shapely.points(np.arange(500.0), 0.0), np.linspace(0.1, 5, 500))
    assert (threads.mapped(shapely.area, circles) == shapely.area(circles)).all()


def test_rims_are_closed_lines_around_areas_and_holes():
    ring = squares(10.0)[0].difference(squares(4.0)[0])
    assert sorted(Lines.rims(np.array([ring])).lengths_mm()) == pytest.approx([16.0, 40.0])
    assert Lines.rims(np.array([ring]), holes=False).lengths_mm() == pytest.approx([40.0])
