"""Strut graphs: read and written in every format, ordered, certified."""

import csv
import io
import json
import random
import re
import zipfile

import numpy as np
import pytest
import trimesh
from click.testing import CliRunner
from hypothesis import given, settings
from hypothesis import strategies as st

import wireprint
from random_lattices import KINDS
from struts_files import GRAPHS
from wireprint import cli
from wireprint.struts import READ, WRITTEN, Graph, beam_model, order, read_struts, struts_as
from wireprint.struts.compas import read_json
from wireprint.struts.frames import COLUMNS, as_csv, as_json

#: A head that is slim enough for lattices: a long nozzle.
SLIM = [
    "head.slant_deg=70",
    "head.cone_height_mm=40",
    "head.block_radius_mm=30",
    "head.carriage_height_mm=60",
    "wire.slab_max_mm=6",
]
SETTINGS = wireprint.Settings.load(overrides=SLIM)


def tower(cells=3, side=14.0, rise=9.0):
    """A square tower with a brace on each face of each cell, from even corners to odd ones."""
    square = np.array([[0, 0], [side, 0], [side, side], [0, side]])
    nodes = [[*place, rise * level] for level in range(cells + 1) for place in square]
    edges = []
    for base in range(0, 4 * cells + 1, 4):
        edges += [[base + i, base + (i + 1) % 4] for i in range(4)]
        if base < 4 * cells:
            edges += [[base + i, base + 4 + i] for i in range(4)]
            edges += [[base + i, base + 4 + (i + step) % 4] for i in (0, 2) for step in (1, 3)]
    return Graph(nodes, edges)


def shell(sides=9, radii=(32.0, 20.0, 8.0), height=10.0):
    """A flat dome of triangles."""
    nodes, edges = [], []
    for ring, radius in enumerate(radii):
        for side in range(sides):
            turn = 2 * np.pi * (side + ring / 2) / sides
            up = height * (1 - (radius / radii[0]) ** 2)
            nodes.append([radius * np.cos(turn), radius * np.sin(turn), up])
            edges.append([ring * sides + side, ring * sides + (side + 1) % sides])
            if ring:
                below = (ring - 1) * sides
                edges.append([below + side, ring * sides + side])
                edges.append([below + (side + 1) % sides, ring * sides + side])
    return Graph(nodes, edges)


def cage(cells=2, pitch=12.0):
    """Upright struts, level ones, and steep braces that share nodes with them."""
    count = cells + 1
    nodes = np.array(list(np.ndindex(count, count, count)), float) * pitch
    number = np.arange(count**3).reshape(count, count, count)
    edges = [
        np.stack([number[:-1], number[1:]], -1),
        np.stack([number[:, :-1], number[:, 1:]], -1),
        np.stack([number[:, :, :-1], number[:, :, 1:]], -1),
        np.stack([number[:-1, :, :-1], number[1:, :, 1:]], -1)[:, ::cells],
    ]
    return Graph(nodes, np.concatenate([part.reshape(-1, 2) for part in edges]))


def truss(bays=5, bay=13.0, height=5.0):
    """A row of pyramids whose tips are joined."""
    nodes = [[bay * x, bay * y, 0] for x in range(bays + 1) for y in range(2)]
    tops = [[bay * (x + 0.5), bay * 0.5, height] for x in range(bays)]
    edges = []
    for x in range(bays):
        corners = [2 * x, 2 * x + 1, 2 * x + 2, 2 * x + 3]
        edges += [[corner, len(nodes) + x] for corner in corners]
        edges += [[corners[0], corners[1]], [corners[0], corners[2]], [corners[1], corners[3]]]
        if x:
            edges.append([len(nodes) + x - 1, len(nodes) + x])
    edges.append([2 * bays, 2 * bays + 1])
    return Graph(nodes + tops, edges)


LATTICES = {"tower": tower, "shell": shell, "truss": truss}


@pytest.fixture(scope="module", params=LATTICES)
def ordered(request):
    return order(LATTICES[request.param](), SETTINGS)


def test_every_strut_is_printed_once_and_the_file_is_certified(ordered):
    assert ordered.certificate.ok
    assert not ordered.supports
    edges = np.sort(ordered.graph.edges, axis=1)
    assert len(np.unique(edges, axis=0)) == len(edges)


def test_each_begins_where_something_holds_it(ordered):
    graph, bed_mm = ordered.graph, SETTINGS.first_layer_height_mm + 0.2
    held = graph.nodes[:, 2] <= bed_mm
    for (start, end), floats in zip(graph.edges, ordered.floating, strict=True):
        assert held[start]
        assert floats == (not held[end])
        held[[start, end]] = True


def test_times_rise_in_the_order_of_printing(ordered):
    times = ordered.graph.time_s
    assert (np.diff(times) > 0).all()
    assert times[-1] < ordered.print_time_s


def test_the_same_graph_gives_the_same_bytes():
    assert order(tower(), SETTINGS).gcode == order(tower(), SETTINGS).gcode


@pytest.mark.parametrize("suffix", WRITTEN)
def test_what_is_written_is_read_again(suffix, tmp_path):
    graph = Graph(tower().nodes, tower().edges, np.linspace(0.3, 0.5, len(tower())))
    path = tmp_path / f"a.{suffix}"
    path.write_bytes(struts_as(graph, suffix, 0.35))
    again = read_struts(path)
    assert len(again) == len(graph)

    def sorted_ends(one):
        ends = np.sort(one.ends.round(3).reshape(len(one), 2, 3), axis=1)
        return np.array(sorted(ends.reshape(len(one), 6).tolist()))

    assert sorted_ends(again) == pytest.approx(sorted_ends(graph), abs=2e-3)
    if suffix in ("ply", "json", "3mf"):
        assert sorted(again.radius_mm) == pytest.approx(sorted(graph.radius_mm), rel=1e-4)


def test_order_and_time_travel_in_the_file(tmp_path):
    found = order(tower(2), SETTINGS)
    path = tmp_path / "a.json"
    path.write_bytes(struts_as(found.graph, "json", 0.35))
    edge = json.loads(path.read_bytes())["data"]["edge"]
    orders = sorted(about["order"] for ends in edge.values() for about in ends.values())
    assert orders == list(range(len(found.graph)))
    assert read_struts(path).ends == pytest.approx(found.graph.ends)


def test_frames_tell_where_the_tool_is_and_what_it_extrudes():
    found = order(tower(1), SETTINGS)
    rows = list(csv.DictReader(io.StringIO(as_csv(found.toolpath, SETTINGS).decode())))
    assert list(rows[0]) == list(COLUMNS)
    assert len(rows) == len(found.toolpath)
    fed = sum(float(row["extrude_mm3"]) for row in rows if float(row["extrude_mm3"]) > 0)
    assert fed > found.graph.ends.shape[0] * 0.38 * 9
    told = json.loads(as_json(found.toolpath, SETTINGS))["frames"]
    assert told[3]["axis_z"] == 1.0
    assert {row["kind"] for row in rows} >= {"post", "contour", "travel"}


COMPAS = {
    "dtype": "compas.datastructures/Graph",
    "data": {
        "node": {"0": {"x": 0, "y": 0, "z": 0}, "7": {"x": 9, "z": 0}, "b": {"x": 4, "z": 6}},
        "edge": {"0": {"7": {}, "b": {"radius": 0.4}}, "7": {"b": None}, "b": {}},
        "default_node_attributes": {"x": 0.0, "y": 0.0, "z": 0.0},
    },
}


@pytest.mark.parametrize(
    ("name", "text", "struts"),
    [
        ("a.obj", "v 0 0 0\nv 9 0 0\nv 4 0 6\nl 1 2 3\nl -1 -3\nl 2 1\n", 3),
        ("a.json", json.dumps(COMPAS), 3),
        ("a.json", json.dumps({"object": [COMPAS]}), 3),
        ("a.json", '{"nodes": [[0,0,0],[0,0,5]], "edges": [[0,1]], "radius": [0.4]}', 1),
        (
            "a.ply",
            "ply\nformat ascii 1.0\nelement vertex 2\nproperty float x\nproperty float y\n"
            "property float z\nelement edge 1\nproperty int vertex1\nproperty int vertex2\n"
            "end_header\n0 0 0\n0 0 5\n0 1\n",
            1,
        ),
    ],
)
def test_struts_of_others_are_read(name, text, struts, tmp_path):
    (tmp_path / name).write_text(text)
    assert len(read_struts(tmp_path / name)) == struts


def test_lines_of_gltf_stand_where_their_nodes_put_them(tmp_path):
    document = {
        "asset": {"version": "2.0"},
        "scenes": [{"nodes": [0]}],
        "nodes": [{"children": [1], "translation": [0, 0.01, 0]}, {"mesh": 0, "scale": [2, 2, 2]}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "mode": 3}]}],
        "buffers": [{"byteLength": 36, "uri": "data:application/octet-stream;base64,"}],
        "bufferViews": [{"buffer": 0, "byteLength": 36}],
        "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3"}],
    }
    import base64

    places = np.array([[0, 0, 0], [0.005, 0, 0], [0.005, 0.005, 0]], "<f4")
    document["buffers"][0]["uri"] += base64.b64encode(places.tobytes()).decode()
    (tmp_path / "a.gltf").write_text(json.dumps(document))
    graph = read_struts(tmp_path / "a.gltf")
    assert graph.ends[1] == pytest.approx(np.array([[10, 0, 10], [10, 0, 20]]), abs=1e-3)


@pytest.mark.parametrize("suffix", READ)
@pytest.mark.parametrize("text", [b"", b"\0" * 9, b"glTF\2\0\0\0\x10\0\0\0", b"{}", b"ply\n[[[["])
def test_what_is_no_graph_is_refused_by_name(suffix, text, tmp_path):
    path = tmp_path / f"a.{suffix}"
    path.write_bytes(text)
    with pytest.raises(wireprint.ModelError, match=f"a.{suffix}"):
        read_struts(path)


@pytest.mark.parametrize("cut", [1, 20, 60, -40, -3])
def test_a_file_that_was_cut_off_is_refused_or_read_not_more(cut, tmp_path):
    whole = struts_as(tower(1), "glb", 0.35)
    (tmp_path / "a.glb").write_bytes(whole[:cut])
    with pytest.raises(wireprint.ModelError):
        read_struts(tmp_path / "a.glb")


def test_a_part_that_floats_gets_a_support_or_is_named():
    graph = tower(1)
    above = Graph.of_segments(
        np.array([[[40, 0, 6], [48, 0, 6]], [[48, 0, 6], [44, 6, 6]], [[44, 6, 6], [40, 0, 6]]])
    )
    both = Graph(
        np.concatenate([graph.nodes, above.nodes]),
        np.concatenate([graph.edges, above.edges + len(graph.nodes)]),
    )
    found = order(both, SETTINGS)
    assert len(found.supports) == 1
    assert found.certificate.ok
    with pytest.raises(wireprint.UnprintableError, match="nothing leads to it from the bed"):
        order(both, SETTINGS, supports=False)


def test_what_ends_in_the_air_is_named():
    graph = Graph([[0, 0, 0], [9, 0, 0], [4, 0, 8]], [[0, 1], [0, 2]])
    with pytest.raises(wireprint.UnprintableError, match=r"end in the air.*0-2 \(.*8\.3\)"):
        order(graph, SETTINGS)


def test_what_hangs_too_far_is_named():
    graph = Graph([[0, 0, 0], [80, 0, 0], [0, 0, 8], [80, 0, 8]], [[0, 2], [1, 3], [2, 3], [0, 1]])
    with pytest.raises(wireprint.UnprintableError, match="longer than what may hang"):
        order(graph, SETTINGS)


@pytest.mark.parametrize(
    ("nodes", "edges"),
    [
        ([[0, 0, np.nan]], [[0, 0]]),
        ([[0, 0, 0]], [[0, 1]]),
        ([[0, 0]], [[0, 0]]),
        (["a"], [[0, 1]]),
    ],
)
def test_what_is_no_graph_is_refused(nodes, edges):
    with pytest.raises(wireprint.ModelError):
        Graph(nodes, edges)


def run(*arguments):
    sets = [word for one in SLIM for word in ("--set", one)]
    return CliRunner().invoke(cli.main, ["order", *map(str, arguments), *sets])


def test_the_command_writes_gcode_graph_and_frames(tmp_path):
    source = tmp_path / "tower.obj"
    source.write_bytes(struts_as(tower(2), "obj", 0.35))
    out = [tmp_path / name for name in ("a.gcode", "a.3mf", "a.csv")]
    told = run(source, "-o", out[0], "--graph", out[1], "--frames", out[2], "--json")
    assert told.exit_code == 0, told.output
    figures = json.loads(told.stdout)
    assert figures["certified"]
    assert wireprint.check(out[0], SETTINGS).ok
    assert len(read_struts(out[1])) == figures["struts"] == len(tower(2))
    assert out[2].read_text().startswith("kind,x_mm")


def test_two_outputs_are_two_files(tmp_path):
    source, out = tmp_path / "tower.json", tmp_path / "both.json"
    source.write_bytes(struts_as(tower(2), "json", 0.35))
    told = run(
        source, "-o", tmp_path / "a.gcode", "--graph", out, "--frames", tmp_path / "./both.json"
    )
    assert told.exit_code != 0
    assert "two outputs" in told.stderr
    assert sorted(path.name for path in tmp_path.iterdir()) == ["tower.json"]


def test_the_command_names_what_it_cannot_print(tmp_path):
    source = tmp_path / "a.obj"
    source.write_text("v 0 0 0\nv 9 0 0\nv 0 0 90\nv 9 0 90\nl 1 2\nl 3 4\n")
    told = run(source, "-o", tmp_path / "a.gcode")
    assert told.exit_code == 5
    assert "nothing leads to it" in told.output
    assert not (tmp_path / "a.gcode").exists()


# --- files that are damaged, or larger than they look

#: What reads as a number somewhere, and is none there.
ODD = [b"nan", b"-1", b"1e999", b"9" * 400, b"99999999999", b"null", b"[]", b'"a"', b"{}"]


@pytest.mark.parametrize("kind", sorted(GRAPHS))
@given(seed=st.integers(0, 2**32 - 1))
@settings(max_examples=60, deadline=None)
def test_a_damaged_file_is_read_or_refused_by_name(kind, seed, tmp_path_factory):
    draw = random.Random(seed)
    content = bytearray(GRAPHS[kind])
    for _ in range(draw.randint(1, 3)):
        place = draw.randrange(len(content))
        content[place : place + draw.randint(0, 6)] = draw.choice([*ODD, draw.randbytes(3)])
    path = tmp_path_factory.mktemp("odd") / f"a.{kind}"
    path.write_bytes(content)
    try:
        read_struts(path)
    except wireprint.ModelError as error:
        assert str(path) in str(error)  # noqa: PT017


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("element vertex 2\nproperty\nend_header\n", "line 4: a property has a type and a name"),
        (
            "element vertex 999999999\nproperty list a b c\nend_header\n",
            "ends before its 999999999",
        ),
        ("element vertex 1\nproperty float x\nend_header\n0 0\n", "line 6: it is no vertex"),
    ],
)
def test_a_ply_file_that_ends_early_or_says_too_little_is_named(text, words, tmp_path):
    (tmp_path / "a.ply").write_text("ply\nformat ascii 1.0\n" + text)
    with pytest.raises(wireprint.ModelError, match=words):
        read_struts(tmp_path / "a.ply")


def test_struts_that_share_an_end_or_a_place_are_welded_without_comparing_all():
    """Squares of these numbers would be memory that nobody has."""
    count = 60_000
    fan = np.zeros((count, 2, 3))
    fan[:, 1] = np.column_stack([np.linspace(1, 200, count), np.full(count, 5.0), np.ones(count)])
    assert len(Graph.of_segments(fan).nodes) == count + 1
    column = np.zeros((count, 2, 3))
    column[:, :, 2] = np.arange(count)[:, None] + [0, 1]
    assert len(Graph.of_segments(column).nodes) == count + 1
    near = np.zeros((count, 2, 3))
    near[:, 1, 0] = 7 + 1e-9 * np.arange(count)
    assert len(Graph.of_segments(near).nodes) == 2


def test_ends_are_one_node_across_the_borders_of_what_compares_them():
    at = np.array([1.0, 2.0, 3.0])
    for step in (0.9e-3 * np.eye(3)).tolist():
        for sign in (1, -1):
            there = at + sign * np.array(step)
            graph = Graph.of_segments([[[0, 0, 0], at], [there, [9, 9, 9]]])
            assert len(graph.nodes) == 3
    apart = Graph.of_segments([[[0, 0, 0], at], [at + np.array([3e-3, 0, 0]), [9, 9, 9]]])
    assert len(apart.nodes) == 4


@pytest.mark.parametrize(
    ("change", "words"),
    [
        ({"nodes": [{"mesh": 0, "children": [0]}], "scenes": [{"nodes": [0]}]}, "two parents"),
        ({"nodes": [{"mesh": 0, "children": [1, 1]}, {}]}, "two parents"),
        ({"bufferViews": [{"buffer": 0, "byteStride": 0}]}, "stride"),
        ({"accessors": [{"bufferView": 0, "count": 10**9}]}, "repeat meshes"),
        ({"nodes": [{"mesh": 0}] * 3000}, "repeat meshes"),
        ({"nodes": [{"mesh": 0, "translation": [1e308, 0, 0]}]}, "no number"),
    ],
)
def test_a_scene_that_is_larger_than_its_file_is_refused(change, words, tmp_path):
    document = {
        "scenes": [{}],
        "nodes": [{"mesh": 0}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "mode": 3}]}],
        "buffers": [{"uri": "data:;base64," + "AAAA" * 3000}],
        "bufferViews": [{"buffer": 0, "byteLength": 9000}],
        "accessors": [{"bufferView": 0, "componentType": 5126, "count": 750, "type": "VEC3"}],
    }
    (tmp_path / "a.gltf").write_text(json.dumps(document | change))
    with pytest.raises(wireprint.ModelError, match=f"a.gltf: .*{words}"):
        read_struts(tmp_path / "a.gltf")


def beam_file(path, body, unit="millimeter"):
    """A 3MF file with two beams along x and y in object 1, and what `body` says besides."""
    with zipfile.ZipFile(path, "w") as archive:
        archive.writestr(
            "3D/3dmodel.model",
            f'<model unit="{unit}" xmlns="{beam_model.CORE}" xmlns:b="{beam_model.BEAM}">'
            '<resources><object id="1"><mesh><vertices><vertex x="0" y="0" z="0"/>'
            '<vertex x="5" y="0" z="0"/><vertex x="0" y="4" z="0"/></vertices>'
            '<b:beamlattice radius="0.5"><b:beams><b:beam v1="0" v2="1"/><b:beam v1="0" v2="2"/>'
            f"</b:beams></b:beamlattice></mesh></object>{body}</model>",
        )
    return path


def test_beams_stand_where_items_and_components_put_them(tmp_path):
    path = beam_file(
        tmp_path / "a.3mf",
        '<object id="2"><components><component objectid="1"/>'
        '<component objectid="1" transform="2 0 0 0 2 0 0 0 2 0 0 10"/></components></object>'
        '</resources><build><item objectid="2" transform="0 1 0 -1 0 0 0 0 1 100 0 0"/></build>',
        "centimeter",
    )
    graph = read_struts(path)
    # Turned by 90° about z, then moved: x becomes y, y becomes -x.
    there = 10 * np.array(
        [
            [[100, 0, 0], [100, 5, 0]],
            [[100, 0, 0], [96, 0, 0]],
            [[100, 0, 10], [100, 10, 10]],
            [[100, 0, 10], [92, 0, 10]],
        ]
    )
    assert graph.ends == pytest.approx(there)
    assert graph.radius_mm == pytest.approx([5, 5, 10, 10])


@pytest.mark.parametrize(
    ("body", "words"),
    [
        ('<object id="2"><components><component objectid="2"/></components></object>'
         '</resources><build><item objectid="2"/></build>', "holds itself"),
        ("".join(f'<object id="{i}"><components>' + f'<component objectid="{i - 1}"/>' * 2
                 + "</components></object>" for i in range(2, 45))
         + '</resources><build><item objectid="44"/></build>', "built too often"),
        ('</resources><build><item objectid="7"/></build>', "not there"),
        ('</resources><build><item objectid="1" transform="1 2"/></build>', "damaged element"),
        ("</resources>", ""),
    ],
)  # fmt: skip
def test_beams_that_are_built_wrongly_are_refused_by_name(body, words, tmp_path):
    path = beam_file(tmp_path / "a.3mf", body)
    if not words:
        assert len(read_struts(path)) == 2
        return
    with pytest.raises(wireprint.ModelError, match=f"a.3mf: .*{words}"):
        read_struts(path)


#: A needle of a nozzle, for struts that rise steeply.
NEEDLE = [*SLIM, "head.slant_deg=75", "wire.free_end_limit_mm=24"]


def steep_dome(radius=36.0, rings=3, around=12):
    """A half ball of triangles: at its foot struts rise by 60 degrees."""
    nodes, edges = [], []
    for level in range(rings):
        rise, here = 0.5 * np.pi * level / rings, level * around
        for side in range(around):
            turn, flat = 2 * np.pi * (side + level / 2) / around, radius * np.cos(rise)
            nodes.append([flat * np.cos(turn), flat * np.sin(turn), radius * np.sin(rise)])
            edges.append([here + side, here + (side + 1) % around])
            if level + 1 < rings:
                edges += [[here + side, here + around + (side - step) % around] for step in (0, 1)]
            else:
                edges.append([here + side, rings * around])
    return Graph([*nodes, [0, 0, radius]], edges)


@pytest.mark.parametrize("make", [cage, steep_dome])
def test_steep_struts_that_share_nodes_leave_and_arrive_level(make):
    graph = make()
    found = order(graph, wireprint.Settings.load(overrides=NEEDLE))
    assert found.certificate.ok
    # Each strut is told once, whole, from where it is begun; not its pieces.
    assert len(found.graph) == len(graph)
    middle = found.graph.nodes.mean(axis=0) - graph.nodes.mean(axis=0)
    ends = {frozenset(map(tuple, strut.round(3))) for strut in found.graph.ends - middle}
    assert ends == {frozenset(map(tuple, strut.round(3))) for strut in graph.ends}
    assert (np.diff(found.graph.time_s) >= 0).all()
    # Pieces lie within the tip's reach of the struts.
    pieces = found.certificate.core.strands.reshape(-1, 3)
    centre = [*found.settings.printer.bed.centre_mm, 0.0]
    whole = found.graph.ends
    run = whole[:, 1] - whole[:, 0]
    for place in pieces - centre:
        share = np.einsum("ij,ij->i", place - whole[:, 0], run) / (run**2).sum(axis=1)
        near = whole[:, 0] + np.clip(share, 0, 1)[:, None] * run
        assert np.linalg.norm(near - place, axis=1).min() < 0.5 + 0.7


@pytest.mark.parametrize("kind", [5120, 5122, 5126])
def test_indices_that_may_be_negative_or_broken_are_refused(kind, tmp_path):
    graph = tower(1)
    whole = struts_as(graph, "glb", 0.35)
    (tmp_path / "a.glb").write_bytes(
        whole.replace(b'"componentType": 5125', b'"componentType": %d' % kind)
    )
    with pytest.raises(wireprint.ModelError, match="damaged glTF"):
        read_struts(tmp_path / "a.glb")


def choreo(unit="millimeter", **changes):
    """A tripod in the form of Choreo's examples."""
    places = [(0, 0, 0), (10, 0, 0), (5, 8, 0), (5, 4, 6)]
    nodes = [
        {"point": dict(zip("XYZ", place, strict=True)), "node_id": 7 + n, "is_grounded": n < 3}
        for n, place in enumerate(places)
    ]
    legs = [{"end_node_ids": [7 + n, 10], "element_id": n, "layer_id": 0} for n in range(3)]
    document = {"unit": unit, "node_list": nodes, "element_list": legs}
    return json.dumps(document | changes).encode()


@pytest.mark.parametrize(("unit", "mm"), [("millimeter", 1), ("centimeter", 10), ("meter", 1000)])
def test_choreos_frames_are_read_in_their_unit(unit, mm):
    graph = read_json(choreo(unit))
    assert graph.edges.tolist() == [[0, 3], [1, 3], [2, 3]]
    assert graph.nodes[3].tolist() == [5 * mm, 4 * mm, 6 * mm]


@pytest.mark.parametrize(
    ("changes", "said"),
    [
        ({"unit": "furlong"}, "its unit 'furlong' is none of"),
        ({"node_list": [{}]}, "a node or an element of it is none"),
        ({"element_list": [{"end_node_ids": [7, 99]}]}, "a node or an element of it is none"),
        ({"node_list": 3}, "a node or an element of it is none"),
    ],
)
def test_what_is_no_frame_of_choreos_is_told(changes, said):
    with pytest.raises(wireprint.ModelError, match=said):
        read_json(choreo(**changes))


#: A needle that is slim far up, on any printer.
LONG_NEEDLE = [
    "head.slant_deg=80",
    "head.cone_height_mm=60",
    "head.block_radius_mm=30",
    "head.carriage_height_mm=80",
    "wire.free_end_limit_mm=24",
]


@pytest.mark.parametrize("printer", ["kossel-mini", "prusa-mk4s", "voron-2.4"])
@pytest.mark.parametrize("kind", sorted(KINDS))
def test_lattices_by_chance_are_printed_whole(kind, printer):
    graph = KINDS[kind](np.random.default_rng(7))
    found = order(graph, wireprint.Settings.load(printer, "pla", overrides=LONG_NEEDLE))
    assert found.certificate.ok
    assert len(found.graph) == len(graph)
    assert not found.supports


def test_what_only_falls_steeply_to_its_foot_is_supported():
    """A beam between two posts, and a drop that hangs from it."""
    nodes = [[0, 0, 0], [0, 0, 14], [9, 0, 14], [18, 0, 14], [18, 0, 0], [9, 0, 6], [9, 5, 14]]
    edges = [[0, 1], [1, 2], [2, 3], [4, 3], [2, 5], [2, 6], [6, 1], [6, 3]]
    settings = wireprint.Settings.load("kossel-mini", "abs", overrides=LONG_NEEDLE)
    found = order(Graph(nodes, edges), settings)
    [support] = found.supports
    foot, top = found.graph.ends[support]
    assert top - foot == pytest.approx([0, 0, 6], abs=1e-9)
    with pytest.raises(wireprint.UnprintableError, match="falls more steeply than the head"):
        order(Graph(nodes, edges), settings, supports=False)


def test_struts_that_no_order_has_are_named_alone():
    both = forked()
    with pytest.raises(wireprint.UnprintableError, match="no order has them all") as refused:
        order(both, SETTINGS)
    assert str(refused.value).startswith(f"2 of {len(both)} struts cannot be printed")


def forked():
    """A tower; two steep struts from one foot beside it, each in the way of the other."""
    fork = Graph([[40, 0, 0], [41, 0, 9], [39, 0, 9]], [[0, 1], [0, 2], [1, 2]])
    beside = tower()
    return Graph(
        np.concatenate([beside.nodes, fork.nodes]),
        np.concatenate([beside.edges, fork.edges + len(beside.nodes)]),
    )


def test_a_part_is_printed_where_all_cannot_be_and_the_rest_is_named():
    graph = forked()
    found = order(graph, SETTINGS, partial=True)
    assert found.certificate.ok
    # One leg of the fork bars the other, and what it was to hold ends in the air.
    legs = {len(graph) - 3, len(graph) - 2, len(graph) - 1}
    missing = {number for number, _ in found.unprinted}
    assert missing <= legs
    assert found.unprinted[0][1] == "locked"
    assert len(found.graph) == len(graph) - len(missing)
    printed = {tuple(sorted(edge)) for edge in found.graph.edges.tolist()}
    wanted = [tuple(sorted(edge)) for edge in graph.edges.tolist()]
    assert printed == {edge for number, edge in enumerate(wanted) if number not in missing}


def test_where_nothing_can_be_printed_partial_says_so():
    graph = Graph([[0, 0, 0], [9, 0, 0], [0, 0, 90], [9, 0, 90]], [[0, 2], [1, 3]])
    with pytest.raises(wireprint.UnprintableError, match="2 of 2 struts cannot be printed"):
        order(graph, SETTINGS, partial=True)


def test_a_support_is_not_asked_for_twice():
    """A bar that floats too high for its support to be straight up, among much that can stand."""
    graph = forked()
    high = Graph([[0, 40, 60], [9, 40, 60]], [[0, 1]])
    both = Graph(
        np.concatenate([graph.nodes, high.nodes]),
        np.concatenate([graph.edges, high.edges + len(graph.nodes)]),
    )
    found = order(both, SETTINGS, partial=True)
    assert found.certificate.ok
    assert (len(graph), "floats") in found.unprinted


def test_a_graph_is_put_on_the_side_on_which_it_can_be_printed():
    """A cage from whose roof a swing hangs: the head cannot draw straight down."""
    floor = [[-8, 8, 0], [8, 8, 0], [8, -8, 0], [-8, -8, 0]]
    roof = [[x, y, 14] for x, y, _ in floor]
    swing = [[0, 8, 14], [0, -8, 14], [0, 8, 5], [0, -8, 5]]
    edges = [[0, 1], [1, 2], [2, 3], [3, 0], [0, 4], [1, 5], [2, 6], [3, 7], [4, 8], [8, 5]]
    edges += [[5, 6], [6, 9], [9, 7], [7, 4], [8, 10], [9, 11], [10, 11]]
    cage = Graph([*floor, *roof, *swing], edges)
    settings = wireprint.Settings.load("kossel-mini", "abs", overrides=LONG_NEEDLE)
    with pytest.raises(wireprint.UnprintableError, match="--orient auto"):
        order(cage, settings, supports=False)
    found = order(cage, settings, supports=False, orient=True)
    assert found.certificate.ok
    turned = order(cage.turned(found.rotate_deg), settings, supports=False)
    assert turned.gcode == found.gcode


def test_turning_is_about_x_then_y_then_z_as_models_are_turned():
    points = np.random.default_rng(3).uniform(-9, 9, (4, 3))
    graph = Graph(points, [[0, 1], [1, 2], [2, 3]], normals=np.eye(3)).turned((20, -35, 70))
    hull = trimesh.Trimesh(points, [[0, 1, 2], [0, 2, 3], [0, 3, 1], [1, 3, 2]])
    hull.fix_normals()
    mesh = wireprint.Mesh.from_arrays(np.array(hull.vertices), np.array(hull.faces))
    turned = mesh.turned((20.0, -35.0, 70.0)).vertices
    ends = graph.nodes - graph.nodes[0]

    def gaps(one):
        return np.linalg.norm(one[:, None] - one, axis=2)

    np.testing.assert_allclose(gaps(graph.nodes), gaps(points), atol=1e-9)
    assert np.ptp(turned, axis=0) == pytest.approx(np.ptp(ends, axis=0), abs=1e-6)
    assert np.linalg.norm(graph.normals, axis=1) == pytest.approx(1)


def test_a_size_in_which_it_can_be_printed_is_told_and_right():
    """A tripod whose legs are as long as nothing may hang."""
    turns = np.radians([0, 120, 240])
    feet = np.column_stack([22 * np.cos(turns), 22 * np.sin(turns), np.zeros(3)])
    large = Graph([*feet, [0, 0, 12]], [[0, 3], [1, 3], [2, 3], [0, 1], [1, 2], [2, 0]])
    settings = wireprint.Settings.load("kossel-mini", "abs", overrides=LONG_NEEDLE)
    with pytest.raises(wireprint.UnprintableError, match=r"(?s)hang.*times as large") as refused:
        order(large, settings)
    factor = float(re.search(r"--scale, times (\S+)", str(refused.value))[1])
    assert order(large.moved((0, 0, 0), factor), settings).certificate.ok
    with pytest.raises(wireprint.UnprintableError):
        order(large.moved((0, 0, 0), 1.1), settings)


def arm():
    """A post, and an arm of short pieces that sticks out of it farther than anything may hang."""
    nodes = [[0, 0, 0], [0, 0, 15], *([3.0 * n, 0, 15] for n in range(1, 15))]
    return Graph(nodes, [[n, n + 1] for n in range(len(nodes) - 1)])


def test_what_hangs_too_far_or_ends_in_the_air_is_supported_where_a_part_is_wanted():
    settings = wireprint.Settings.load("kossel-mini", "abs", overrides=LONG_NEEDLE)
    with pytest.raises(wireprint.UnprintableError, match="hang from a free end"):
        order(arm(), settings)
    found = order(arm(), settings, partial=True)
    assert found.certificate.ok
    assert not found.unprinted
    assert 1 <= len(found.supports) <= 4
    for support in found.supports:
        assert found.graph.ends[support, 1, 2] == pytest.approx(15.3, abs=0.1)
    with pytest.raises(wireprint.UnprintableError, match="nothing meets them"):
        order(arm(), settings, partial=True, supports=False)


def test_a_search_that_spends_its_effort_gives_the_best_it_found_and_says_so():
    graph = KINDS["dome"](np.random.default_rng(7))
    settings = wireprint.Settings.load("kossel-mini", "abs", overrides=LONG_NEEDLE)
    whole = order(graph, settings)
    assert not whole.effort_spent
    part = order(graph, settings, partial=True, effort=1e-5)
    assert part.effort_spent
    assert part.certificate.ok
    assert 0 < len(part.graph) < len(graph)
    assert len(part.graph) + len(part.unprinted) == len(graph)
    assert order(graph, settings, partial=True, effort=1e-5).gcode == part.gcode
    for partial in (False, True):
        with pytest.raises(wireprint.UnprintableError, match="--effort 4"):
            order(graph, settings, partial=partial, effort=1e-9)


def thicket(side=11, pitch=3.0):
    """Steep struts so close to each other that the head gets between few of them."""
    rng = np.random.default_rng(5)
    feet = [[pitch * x, pitch * y, 0.0] for x in range(side) for y in range(side)]
    lean = np.array([*rng.uniform(-1, 1, 2), 9.0])
    tops = np.array(feet) + lean
    edges = [[n, n + side * side] for n in range(side * side)]
    across = [[n, n + 1] for n in range(side * side, 2 * side * side - 1) if (n + 1) % side]
    return Graph([*feet, *tops], edges + across)


def test_who_watches_a_search_may_end_it():
    settings = wireprint.Settings.load("kossel-mini", "abs", overrides=LONG_NEEDLE)

    def stop(most):
        assert 0 <= most <= 231
        raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        order(thicket(), settings, partial=True, told=stop)
