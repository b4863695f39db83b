"""Strut graphs: read and written in every format, ordered, certified."""

import csv
import io
import json

import numpy as np
import pytest
from click.testing import CliRunner

import wireprint
from wireprint import cli
from wireprint.struts import READ, WRITTEN, Graph, order, read_struts, struts_as
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


def test_the_command_names_what_it_cannot_print(tmp_path):
    source = tmp_path / "a.obj"
    source.write_text("v 0 0 0\nv 9 0 0\nv 0 0 90\nv 9 0 90\nl 1 2\nl 3 4\n")
    told = run(source, "-o", tmp_path / "a.gcode")
    assert told.exit_code == 5
    assert "nothing leads to it" in told.output
    assert not (tmp_path / "a.gcode").exists()
