"""What reading 3MF files promises: what they place and paint, and that hostile ones do no harm."""

import math
import random
import shutil
import subprocess
import sys
import time
import zipfile
from xml.parsers import expat

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from threemf_files import (
    CUBE_FACES,
    CUBE_OBJECT,
    ITEM,
    MODEL,
    cube_object,
    encoded,
    item,
    leaves,
    model,
    relationships,
    write_3mf,
    write_zip,
)
from wireprint._core import ModelError, WireprintError, read_model_part
from wireprint.mesh import load_mesh
from wireprint.model import load_marks, load_model
from wireprint.pipeline import make
from wireprint.project import write_project
from wireprint.regions import Mask, Region, ZRange
from wireprint.settings import Settings
from wireprint.threemf.scene import PROJECT_TYPE

CUBE = np.array([[i & 1, i >> 1 & 1, i >> 2] for i in range(8)], float)

states = st.integers(0, 18)
corners = st.integers(0, 2)
trees = st.recursive(
    states,
    lambda below: st.builds(
        lambda corner, children: [corner, *children],
        corners,
        st.lists(below, min_size=2, max_size=4),
    ),
    max_leaves=30,
)


def decoded(painting):
    """Weights of a painted triangle's corners for those of its leaves, and their states."""
    part = model(cube_object(attributes={5: f'paint_color="{painting}"'}))
    _, [(_, (_, _, found, _, _, _))], _ = read_model_part([part.encode()])
    whole, whole_states, owners, corners, states = found.leaves(
        np.eye(3), np.array([[0, 1, 2]] * 6)
    )
    assert set(whole) | set(owners) == {5}
    return (np.eye(3)[None], whole_states) if len(whole) else (corners.reshape(-1, 3, 3), states)


def samples(random, count=300):
    """Points on the faces of a unit cube, with normals, and their triangles and weights."""
    faces = random.integers(0, len(CUBE_FACES), count)
    weights = random.dirichlet(np.ones(3), count)
    triangles = CUBE[np.array(CUBE_FACES)[faces]]
    normals = np.cross(triangles[:, 1] - triangles[:, 0], triangles[:, 2] - triangles[:, 0])
    return np.einsum("nk,nkx->nx", weights, triangles), normals, faces, weights


def inside(point, triangle, slack):
    """Whether a point of a triangle's plane lies in it, give or take; None if it is too close."""
    weights = np.linalg.lstsq(np.vstack([np.transpose(triangle), np.ones(3)]), [*point, 1])[0]
    return None if abs(weights.min()) < slack else weights.min() > 0


@given(tree=trees)
def test_a_painted_triangle_falls_into_the_leaves_of_its_tree(tree):
    corner = [np.array([0.0, 0, 0]), np.array([1.0, 0, 0]), np.array([0.0, 1, 0])]
    weights, found = decoded(encoded(tree))
    expected = leaves(tree, corner)
    got = sorted(zip((weights @ corner).tolist(), found.tolist(), strict=True))
    assert got == sorted((np.array(triangle).tolist(), state) for triangle, state in expected)


@given(tree=trees)
def test_the_leaves_fill_the_triangle(tree):
    weights, _ = decoded(encoded(tree))
    areas = np.linalg.det(weights)
    assert (areas > 0).all()
    assert areas.sum() == pytest.approx(1)


@pytest.mark.parametrize("text", ["3", "83", "C", "44", "F", "xyz", "0 ", "44480"])
def test_a_string_that_is_no_tree_is_refused(text):
    with pytest.raises(ModelError, match=r"triangle 5: '.*' .*(digits|base 16|corner)"):
        decoded(text)


def test_a_single_digit_paints_the_whole_triangle():
    for text, state in {"4": 1, "8": 2, "0C": 3, "1C": 4, "DC": 16}.items():
        weights, found = decoded(text)
        assert np.array_equal(weights, [np.eye(3)])
        assert found.tolist() == [state]


@pytest.mark.parametrize("attribute", ["slic3rpe:mmu_segmentation", "paint_color"])
@settings(max_examples=40)
@given(paint=st.dictionaries(st.integers(0, 11), trees, max_size=4), seed=st.integers(0, 9))
def test_a_painted_file_covers_what_its_leaves_cover(attribute, paint, seed, tmp_path_factory):
    path = tmp_path_factory.mktemp("painted") / "cube.3mf"
    attributes = {face: f'{attribute}="{encoded(tree)}"' for face, tree in paint.items()}
    write_3mf(path, cube_object(attributes=attributes), unit="inch")
    model = load_model(path, scale=2, up="y", rotate=(10, 20, 30))
    points, normals, faces, _ = samples(np.random.default_rng(seed), 40)
    placed = points @ model.mesh.placement[:3, :3].T + model.mesh.placement[:3, 3]
    covered = model.region.covers(placed, normals)
    for point, face, found in zip(points, faces, covered, strict=True):
        marked = [
            inside(point, triangle, 1e-6) and state > 0
            for triangle, state in leaves(paint.get(face, 0), list(CUBE[list(CUBE_FACES[face])]))
            if inside(point, triangle, 1e-6) is not False
        ]
        assert found in marked or not marked


def test_a_painted_file_gives_the_runs_of_the_mask_it_stands_for(tmp_path):
    deep = [1, 2, [0, 4, [2, 0, 1], 3], 0]
    paint = {face: [0, 3, 0, deep, 1] for face in range(4, 8)} | {8: 1, 9: [2, 0, deep]}
    attributes = {face: f'paint_color="{encoded(tree)}"' for face, tree in paint.items()}
    model = load_model(write_3mf(tmp_path / "a.3mf", cube_object(31, attributes=attributes)))
    corners = [31 * CUBE[list(face)] for face in CUBE_FACES]
    parts = [leaf for i, three in enumerate(corners) for leaf in leaves(paint.get(i, 0), [*three])]
    vertices = np.array([triangle for triangle, _ in parts]).reshape(-1, 3)
    faces = np.arange(len(vertices)).reshape(-1, 3)
    mask = Mask(vertices=vertices, faces=faces, marked=np.array([s > 0 for _, s in parts]))
    region = Region().add(mask).transformed(model.mesh.placement)
    chosen = Settings.load()
    painted, marked = (make(model.mesh, chosen, marks) for marks in (model.region, region))
    assert painted.figures()["regions"]["runs"]
    assert painted.figures()["regions"] == marked.figures()["regions"]
    assert painted.gcode == marked.gcode


def test_paint_follows_copies_components_and_mirrors(tmp_path):
    half = encoded([0, 0, 5])
    inner = cube_object(attributes={2: f'paint_color="{half}"', 3: 'paint_color="4"'})
    outer = (
        '<object id="2"><components>'
        '<component objectid="1"/>'
        '<component objectid="1" transform="-1 0 0 0 1 0 0 0 1 5 0 0"/>'
        "</components></object>"
    )
    path = write_3mf(tmp_path / "copies.3mf", inner + outer, item(2, "0 0 3") + item(1, "0 4 0"))
    model = load_model(path)
    region = model.region.transformed(np.linalg.inv(model.mesh.placement))
    a, b, c = CUBE[list(CUBE_FACES[2])]
    unpainted, painted = (a + b + (b + c) / 2) / 3, (a + c + (b + c) / 2) / 3
    for move in (
        lambda p: np.add(p, (0, 0, 3)),
        lambda p: np.add(p * (-1, 1, 1), (5, 0, 3)),
        lambda p: np.add(p, (0, 4, 0)),
    ):
        points = np.array([move(unpainted), move(painted), move(np.array([0.5, 0.5, 0]))])
        found = region.covers(points, np.zeros((3, 3)))
        assert found.tolist() == [False, True, False]


def test_only_the_extruders_asked_for_count(tmp_path):
    attributes = {4: 'paint_color="8"', 5: 'paint_color="0C"'}
    path = write_3mf(tmp_path / "two.3mf", cube_object(attributes=attributes))
    points = np.array([CUBE[list(CUBE_FACES[face])].mean(axis=0) for face in (4, 5, 6)])

    def covered(**options):
        model = load_model(path, **options)
        placed = points + model.mesh.placement[:3, 3]
        return model.region.covers(placed, np.zeros((3, 3))).tolist()

    assert covered() == [True, True, False]
    assert covered(states=[3]) == [False, True, False]
    assert covered(states=[2, 3]) == [True, True, False]
    assert not load_model(path, states=[7]).region
    with pytest.raises(ModelError, match="nothing in it is painted"):
        load_marks(path, states=[7])


def set_tag(name, content):
    return f'<t:triangleset name="{name}" identifier="{name}1">{content}</t:triangleset>'


def test_triangle_sets_count_when_they_are_named(tmp_path):
    sets = (
        "<t:trianglesets>"
        + set_tag("floor", '<t:refrange startindex="0" endindex="1"/>')
        + set_tag("a side", '<t:ref index="4"/><t:ref index="5"/>')
        + "</t:trianglesets>"
    )
    path = write_3mf(tmp_path / "sets.3mf", cube_object(after=sets))
    points = np.array([CUBE[list(CUBE_FACES[face])].mean(axis=0) for face in (0, 4, 6)])

    def covered(region, mesh):
        return region.covers(points + mesh.placement[:3, 3], np.zeros((3, 3))).tolist()

    assert not load_model(path).region
    model = load_model(path, sets=["a side"])
    assert covered(model.region, model.mesh) == [False, True, False]
    assert covered(load_marks(path), model.mesh) == [True, True, False]
    assert covered(load_marks(path, sets=["floor"]), model.mesh) == [True, False, False]
    with pytest.raises(ModelError, match=r"no triangle set 'roof'; it has 'floor', 'a side'"):
        load_model(path, sets=["roof"])
    wrong = set_tag("x", '<t:ref index="12"/>')
    write_3mf(path, cube_object(after=f"<t:trianglesets>{wrong}</t:trianglesets>"))
    with pytest.raises(ModelError, match="names triangles 12 to 12"):
        load_model(path, sets=["x"])


def test_objects_may_stand_in_parts_of_their_own(tmp_path):
    component = '<component objectid="1" p:path="/3D/Objects/one.model"/>'
    resources = f'<object id="8"><components>{component}</components></object>'
    paint = {0: 'paint_color="4"'}
    parts = {"3D/Objects/one.model": model(cube_object(attributes=paint), "")}
    path = write_3mf(tmp_path / "bambu.3mf", resources, item(8, "5 5 5"), parts=parts)
    found = load_model(path)
    assert len(found.mesh.faces) == 12
    assert found.region


def test_the_package_says_which_part_is_the_model(tmp_path):
    kind = "http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel"
    parts = {"_rels/.rels": relationships("/elsewhere.model", kind), "elsewhere.model": model()}
    assert len(load_mesh(write_zip(tmp_path / "a.3mf", parts)).faces) == 12


# --- slicers' projects

CONFIG = "Metadata/Slic3r_PE_model.config"
SETTINGS = "Metadata/model_settings.config"


def two_cubes(low, high, size=20):
    """One object of two cubes: the second one from `low` on, stretched by `high`."""
    inner = cube_object(size)
    vertices = "".join(
        f'<vertex x="{low[0] + high[0] * (i & 1)}" y="{low[1] + high[1] * (i >> 1 & 1)}" '
        f'z="{low[2] + high[2] * (i >> 2)}"/>'
        for i in range(8)
    )
    triangles = "".join(
        f'<triangle v1="{a + 8}" v2="{b + 8}" v3="{c + 8}"/>' for a, b, c in CUBE_FACES
    )
    return inner.replace("</vertices>", vertices + "</vertices>").replace(
        "</triangles>", triangles + "</triangles>"
    )


def prusa(kind, extra=""):
    return {
        CONFIG: '<config><object id="1"><metadata type="object" key="name" value="box"/>'
        '<volume firstid="0" lastid="11"/><volume firstid="12" lastid="23">'
        f'<metadata key="name" value="other"/>{extra}'
        f'<metadata key="volume_type" value="{kind}"/></volume></object></config>'
    }


def bambu(subtype):
    return {
        SETTINGS: '<config><object id="3"><metadata key="name" value="box"/>'
        f'<part id="1" subtype="normal_part"/><part id="2" subtype="{subtype}">'
        '<metadata key="name" value="other"/></part></object></config>'
    }


def bambu_model(shift="10 5 5"):
    held = f'<component objectid="2" transform="1 0 0 0 1 0 0 0 1 {shift}"/>'
    outer = f'<object id="3"><components><component objectid="1"/>{held}</components></object>'
    return cube_object(20, 1) + cube_object(20, 2) + outer


@pytest.mark.parametrize(
    ("kind", "subtype", "word"),
    [
        ("ParameterModifier", "modifier_part", "modifier"),
        ("SupportBlocker", "support_blocker", "support blocker"),
        ("SupportEnforcer", "support_enforcer", "support enforcer"),
        ("SeamPosition", "seam_part", "volume of an unknown kind"),
    ],
)
def test_volumes_that_are_no_parts_are_left_out_and_said(kind, subtype, word, tmp_path):
    prusas = write_3mf(tmp_path / "p.3mf", two_cubes((30, 0, 0), (5, 5, 50)), parts=prusa(kind))
    bambus = write_3mf(tmp_path / "b.3mf", bambu_model(), item(3, "9 9 9"), parts=bambu(subtype))
    for path in (prusas, bambus):
        mesh = load_mesh(path)
        assert mesh.size_mm == [20, 20, 20]
        assert mesh.notes == [f"left out: 1 × {word} ('other')"]


def test_negative_parts_are_cut_out_of_their_object_alone(tmp_path):
    path = tmp_path / "p.3mf"
    write_3mf(path, two_cubes((-5, -5, 12), (40, 40, 40)), parts=prusa("NegativeVolume"))
    mesh = load_mesh(path)
    assert mesh.size_mm == [20, 20, 12]
    assert mesh.volume == pytest.approx(4800)
    assert mesh.notes == ["cut out: 1 × negative part ('other')"]
    items = item(3, "0 0 0") + item(1, "10 40 5")
    write_3mf(path, bambu_model(), items, parts=bambu("negative_part"))
    mesh = load_mesh(path, scale=2)
    assert mesh.volume == pytest.approx(8 * (8000 - 10 * 15 * 15 + 8000))
    assert mesh.report["closed_components"] == 2


def test_an_open_body_cannot_be_cut_and_is_named(tmp_path):
    body = two_cubes((5, 5, 5), (40, 40, 40))
    first = body.index("<triangle ")
    path = tmp_path / "open.3mf"
    for _ in range(2):
        body = body[:first] + body[body.index("/>", first) + 2 :]
    config = prusa("NegativeVolume")[CONFIG].replace('"11"', '"9"').replace('"12"', '"10"')
    write_3mf(path, body, parts={CONFIG: config.replace('"23"', '"21"')})
    with pytest.raises(ModelError, match="is not closed, so that nothing can be cut out of it"):
        load_mesh(path)


def test_a_volume_of_triangles_that_are_not_there_is_refused(tmp_path):
    path = write_3mf(tmp_path / "p.3mf", cube_object(20), parts=prusa("ParameterModifier"))
    with pytest.raises(ModelError, match="its triangles 12 to 23, of 12"):
        load_mesh(path)


def test_what_is_cut_out_is_not_painted(tmp_path):
    painted = two_cubes((5, 5, 5), (10, 10, 40)).replace(
        "/><triangle", ' paint_color="4"/><triangle'
    )
    path = write_3mf(tmp_path / "p.3mf", painted, parts=prusa("NegativeVolume"))
    model = load_model(path)
    points = np.array([[10.0, 0, 10], [5, 10, 10]]) + model.mesh.placement[:3, 3]
    assert model.region.covers(points, np.zeros((2, 3))).tolist() == [True, False]


PLATES = {
    SETTINGS: "<config>"
    + "".join(
        f'<plate><metadata key="plater_id" value="{number}"/>'
        f'<metadata key="plater_name" value="{name}"/><model_instance>'
        f'<metadata key="object_id" value="1"/><metadata key="instance_id" value="{instance}"/>'
        "</model_instance></plate>"
        for number, name, instance in ((1, "small", 1), (2, "", 0))
    )
    + "</config>"
}
TWO_ITEMS = (
    '<item objectid="1" transform="2 0 0 0 2 0 0 0 2 0 0 0"/>'
    + item(1, "300 0 0")
    + item(1, "0 9 9")
)


def test_plates_that_share_a_number_cannot_be_told_apart(tmp_path):
    twice = {SETTINGS: PLATES[SETTINGS].replace('value="2"', 'value="1"')}
    path = write_3mf(tmp_path / "plates.3mf", cube_object(10), TWO_ITEMS, parts=twice)
    with pytest.raises(ModelError, match=r"plates\.3mf: 2 plates have the number 1; export"):
        load_model(path)


def test_one_plate_is_taken_and_the_others_are_named(tmp_path):
    path = write_3mf(tmp_path / "plates.3mf", cube_object(10), TWO_ITEMS, parts=PLATES)
    mesh = load_mesh(path)
    assert mesh.size_mm == [10, 10, 10]
    assert mesh.notes == [
        "plate 1 alone is taken, of 2; --plate takes 2",
        "left out: 1 × object beside all plates",
    ]
    assert load_mesh(path, plate=2).size_mm == [20, 20, 20]
    with pytest.raises(ModelError, match=r"no plate 3 with objects on it; there are 1, 2"):
        load_mesh(path, plate=3)
    held = load_model(path).contents
    assert [(one.number, one.name, one.taken) for one in held.plates] == [
        (1, "small", True),
        (2, "", False),
    ]


@pytest.mark.parametrize(
    ("old", "new"),
    [
        ('<object id="1">', '<object id="1" type="support">'),
        ('<object id="1">', '<object id="1" type="solidsupport">'),
        ('<object id="1">', '<object id="1" type="other">'),
        (
            '<object id="1">',
            '<object id="1"><metadatagroup><metadata name="cura:anti_overhang_mesh">True'
            "</metadata></metadatagroup>",
        ),
    ],
)
def test_objects_that_are_no_models_are_left_out(old, new, tmp_path):
    resources = cube_object(50).replace(old, new) + cube_object(20, 2)
    path = write_3mf(tmp_path / "types.3mf", resources, ITEM + item(2, "60 0 0"))
    mesh = load_mesh(path)
    assert mesh.size_mm == [20, 20, 20]
    assert mesh.notes[0].startswith("left out: 1 × ")
    write_3mf(path, resources, ITEM)
    with pytest.raises(ModelError, match="nothing in it is to be printed: left out"):
        load_mesh(path)


def test_what_a_slicer_would_not_print_is_left_out(tmp_path):
    hidden = item(1, "60 0 0").replace("/>", ' printable="0"/>')
    mesh = load_mesh(write_3mf(tmp_path / "hidden.3mf", cube_object(20), ITEM + hidden))
    assert mesh.size_mm == [20, 20, 20]
    assert mesh.notes == ["left out: 1 × object that is not to be printed"]


BEAMS = "http://schemas.microsoft.com/3dmanufacturing/beamlattice/2017/02"


@pytest.mark.parametrize(
    ("required", "uri", "complaint"),
    [
        ("b", BEAMS, "beam lattices"),
        ("x", "urn:nobody:knows", "the extension urn:nobody:knows"),
        ("y", "urn:x", "an unknown extension 'y'"),
    ],
)
def test_an_extension_that_is_required_and_not_read_is_named(required, uri, complaint, tmp_path):
    prefix = required if complaint != "an unknown extension 'y'" else "z"
    text = model().replace(
        "<model ", f'<model requiredextensions="p {required}" xmlns:{prefix}="{uri}" '
    )
    path = write_zip(tmp_path / "required.3mf", {MODEL: text})
    with pytest.raises(ModelError, match=f"requires .*{complaint}"):
        load_mesh(path)


def test_a_shape_that_is_not_read_is_named_even_where_it_is_not_required(tmp_path):
    lattice = f'<b:beamlattice xmlns:b="{BEAMS}" radius="1"/>'
    path = write_3mf(tmp_path / "beams.3mf", cube_object(20, after=lattice))
    with pytest.raises(ModelError, match="has a shape by the extension for beam lattices"):
        load_mesh(path)
    resources = '<object id="1"><x:shape xmlns:x="urn:x"/></object>'
    with pytest.raises(ModelError, match="has a shape by the extension urn:x"):
        load_mesh(write_3mf(path, resources))


@pytest.mark.parametrize("name", ["3D\\3dmodel.model", "/3D/3dmodel.model"])
def test_names_of_parts_are_read_as_slicers_do(name, tmp_path):
    path = write_zip(tmp_path / "a.3mf", {name: model(cube_object(20))})
    assert load_mesh(path).size_mm == [20, 20, 20]


def test_a_sliced_plate_is_named_as_such(tmp_path):
    parts = {MODEL: model("", ""), "Metadata/plate_1.gcode": "G28\n"}
    with pytest.raises(ModelError, match=r"a sliced plate: it holds G-code .*plate_1\.gcode"):
        load_mesh(write_zip(tmp_path / "a.gcode.3mf", parts))


# --- XML

SNIPPETS = [
    *(
        "<a>",
        "</a>",
        "<b x='1' y=\"2\"/>",
        "<p:c p:x='' x=''>",
        "</p:c>",
        "text",
        "&lt;&#65;&#x41;",
    ),
    *(
        "<!-- c -->",
        "<![CDATA[<&]]>",
        "<?hint h?>",
        "\n",
        " ",
        "<d xmlns='' xmlns:q='urn:q' q:x=''/>",
    ),
    *("]]>", "--", "<", ">", "&", ";", "'", '"', "=", "/", ":", "!", "?", "-", "x", "9", "é", "\t"),
]


@settings(max_examples=300)
@given(
    inner=st.lists(st.sampled_from(SNIPPETS), max_size=12),
    edits=st.lists(st.tuples(st.integers(0, 200), st.integers(0, 3), st.sampled_from(SNIPPETS))),
    cut=st.integers(1, 50),
)
def test_xml_is_well_formed_where_expat_says_so(inner, edits, cut):
    text = f"<m xmlns='urn:m' xmlns:p='urn:p'>{''.join(inner)}</m>"
    for place, length, word in edits:
        text = text[:place] + word + text[place + length :]
    content = text.encode()
    parser = expat.ParserCreate(namespace_separator="|")
    try:
        parser.Parse(content, True)
        expected = True
    except expat.ExpatError:
        expected = False
    try:
        read_model_part([content[:cut], content[cut:]])
        found = True
    except ModelError as error:
        # Well-formed, but no model.
        found = "no <model>" in str(error)
        assert found or "damaged" in str(error)  # noqa: PT017
    assert found == expected


@pytest.mark.parametrize("encoding", ["utf-8", "utf-8-sig", "utf-16"])
def test_a_model_may_be_written_in_either_encoding_that_3mf_allows(encoding, tmp_path):
    text = f'<?xml version="1.0" encoding="{encoding[:6].rstrip("-")}"?>{model()}'
    parts = {MODEL: text.encode(encoding)}
    assert len(load_mesh(write_zip(tmp_path / "a.3mf", parts)).faces) == 12


# --- hostile files


def growing(first, pieces):
    """A part that begins well and goes on and on, in pieces that do not compress."""
    noise = random.Random(7)
    yield f'<model xmlns="http://x">{first}'
    for _ in range(pieces):
        yield noise.randbytes(1 << 17).hex()


def nested(count):
    noise = random.Random(7)
    for _ in range(count):
        yield "".join(f"<a{noise.randrange(10**9)}>" for _ in range(1000))


LAUGHS = "".join(f'<!ENTITY e{i} "{f"&e{i - 1};" * 10 if i else "ha"}">' for i in range(12))
CYCLE = (
    '<object id="1"><components><component objectid="2"/></components></object>'
    '<object id="2"><components><component objectid="1"/></components></object>'
)
CHAIN = "".join(
    f'<object id="{i}"><components><component objectid="{i + 1}"/></components></object>'
    for i in range(2, 3000)
)
ELSEWHERE = '<object id="1"><components><component objectid="1" p:path="{}"/></components></object>'
ELEMENT, COMPONENT = '<object id="n{}"/>', '<component objectid="1"/>'
VERTEX = '<vertex x="0" y="0" z="0"/>'
MODEL_TYPE = "http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel"
PROJECT = {"_rels/.rels": relationships("/Metadata/x.json", PROJECT_TYPE), MODEL: model()}


def cube_with(old, new):
    assert old in CUBE_OBJECT
    return {MODEL: model(CUBE_OBJECT.replace(old, new, 1))}


def painted_with(text):
    return {MODEL: model(cube_object(attributes={0: f'paint_color="{text}"'}))}


#: Name → parts, and what the message must say.
HOSTILE = {
    "zip bomb": ({MODEL: (bytes(1 << 20) for _ in range(64))}, "unpacks to"),
    "path escape": ({MODEL: model(), "../../etc/x": "x"}, "leads out of the file"),
    "drive": ({MODEL: model(), "C:\\x": "x"}, "leads out of the file"),
    "one part twice": ({MODEL: model(), MODEL.upper(): model()}, "two parts"),
    "too many parts": ({MODEL: model()} | {f"p{i}": "" for i in range(25000)}, "directory"),
    "no model": ({"readme": "x"}, "no part 3D/3dmodel.model"),
    "relationship to nowhere": (
        {"_rels/.rels": relationships("/../x", MODEL_TYPE), MODEL: model()},
        "no part",
    ),
    "entity bomb": ({MODEL: model(head=f"<!DOCTYPE m [{LAUGHS}]>")}, "document type"),
    "external entity": (
        {MODEL: model(head='<!DOCTYPE m [<!ENTITY x SYSTEM "file:///etc/passwd">]>')},
        "document type",
    ),
    "DTD elsewhere": (
        {MODEL: model(head='<!DOCTYPE m SYSTEM "http://127.0.0.1/x.dtd">')},
        "document type",
    ),
    "undefined entity": ({MODEL: model(items="&x;")}, "damaged"),
    "unknown encoding": ({MODEL: '<?xml version="1.0" encoding="rot13"?><a/>'}, "damaged"),
    "strange encoding": ({MODEL: '<?xml version="1.0" encoding="utf-7"?><a/>'}, "damaged"),
    "no XML": ({MODEL: b"\xff\xfe\x00"}, "damaged"),
    "XML that ends early": ({MODEL: model()[:-9]}, "damaged"),
    "deep XML": ({MODEL: nested(100)}, "nested"),
    "endless attribute": ({MODEL: growing('<a b="', 40)}, "tag of more than"),
    "endless comment": ({MODEL: growing("<!-- ", 40)}, "tag of more than"),
    "negative index": (cube_with('v1="0"', 'v1="-1"'), r"names vertices \[-1, 2, 3\]"),
    "index beyond": (cube_with('v1="0"', 'v1="8"'), "there are 8"),
    "huge index": (cube_with('v1="0"', f'v1="{10**30}"'), "line 1: a <triangle> makes no sense"),
    "no index": (cube_with('v1="0"', ""), "<triangle> has no attribute 'v1'"),
    "not a number": (cube_with('x="0"', 'x="nan"'), "vertex 0 of object '1'"),
    "infinite": (cube_with('x="0"', 'x="-inf"'), "vertex 0 of object '1'"),
    "a word": (cube_with('x="0"', 'x="zero"'), "<vertex> makes no sense"),
    "matrix of nan": (
        {MODEL: model(items=item(1, "nan 0 0"))},
        "placed by numbers that make no sense",
    ),
    "matrix that overflows": (
        {MODEL: model(items=item(1, "1e308 1e308 0").replace("1 0 0", "1e308 0 0"))},
        "placed by numbers that make no sense",
    ),
    "short matrix": ({MODEL: model(items='<item objectid="1" transform="1 0"/>')}, "12 numbers"),
    "another outermost element": (
        {MODEL: model().replace("<model ", "<scene ").replace("</model>", "</scene>")},
        "outermost element is no <model>",
    ),
    "a model within a model": (
        {MODEL: model(CUBE_OBJECT + '<model unit="inch"/>')},
        "within another",
    ),
    "unknown unit": ({MODEL: model(unit="parsec")}, "parsec"),
    "unknown object": ({MODEL: model(items='<item objectid="7"/>')}, "object '7'"),
    "object twice": ({MODEL: model(CUBE_OBJECT * 2)}, "another one has the id"),
    "cycle": ({MODEL: model(CYCLE)}, "component of itself"),
    "chain": ({MODEL: model(CUBE_OBJECT + CHAIN, '<item objectid="2"/>')}, "deep"),
    "path of a component": ({MODEL: model(ELSEWHERE.format("/../../etc/passwd"))}, "leads out"),
    "many objects": ({MODEL: model("".join(map(ELEMENT.format, range(70000))))}, "objects"),
    "many components": (
        {MODEL: model(CUBE_OBJECT + f'<object id="2">{COMPONENT * 70000}</object>')},
        "items and components",
    ),
    "many vertices": (
        {MODEL: model(CUBE_OBJECT.replace("<vertices>", "<vertices>" + VERTEX * 5000), ITEM * 900)},
        "places more than",
    ),
    "endless name": ({MODEL: model(ELEMENT.format("x" * 2000))}, "a name of more than"),
    "missing part": ({MODEL: model(ELSEWHERE.format("/3D/x.model"))}, "no part '/3D/x.model'"),
    "nothing built": ({MODEL: model(items="")}, "nothing is to be built"),
    "paint that ends early": (painted_with("83"), "triangle 0: '83' has fewer digits"),
    "paint that goes on": (painted_with("44"), "more digits"),
    "paint in words": (painted_with("red"), "painting of triangle 0"),
    "paint without end": (painted_with("8" * (1 << 21) + "3"), "digits"),
    "project of half a document": (PROJECT | {"Metadata/x.json": '{"format":'}, "invalid JSON"),
    "deep project": (PROJECT | {"Metadata/x.json": "[" * 100000}, "recursion"),
    "project of another version": (
        PROJECT | {"Metadata/x.json": '{"format":"wireprint-project","version":2}'},
        "version: input should be 1",
    ),
    "project without its part": (PROJECT, "no part '/Metadata/x.json'"),
}


@pytest.mark.parametrize("name", HOSTILE)
def test_a_hostile_file_is_refused_by_name(name, tmp_path):
    parts, complaint = HOSTILE[name]
    path = tmp_path / "hostile.3mf"
    write_zip(path, parts)
    with pytest.raises(ModelError, match=complaint) as refused:
        load_model(path)
    assert str(refused.value).startswith(str(path))


def test_a_hostile_archive_is_refused_by_name(tmp_path):
    path = write_3mf(tmp_path / "whole.3mf")
    whole = path.read_bytes()
    broken = [whole[:end] for end in (0, 10, 60, len(whole) // 2, len(whole) - 5)]
    flipped = bytearray(whole)
    flipped[90] ^= 0xFF
    for content in [*broken, bytes(flipped), random.Random(1).randbytes(5000)]:
        path.write_bytes(content)
        with pytest.raises(ModelError, match="cannot be read as 3MF"):
            load_model(path)
    write_zip(path, {MODEL: model()}, zipfile.ZIP_LZMA)
    with pytest.raises(ModelError, match="packed in a way"):
        load_model(path)


@settings(max_examples=200)
@given(data=st.data())
def test_a_file_in_which_bytes_were_changed_is_read_or_refused(data, tmp_path_factory):
    path = tmp_path_factory.mktemp("changed") / "x.3mf"
    cube = load_model(write_3mf(path, cube_object(9))).mesh
    write_project(path, cube, Settings.load(), Region().add(ZRange(low_mm=1)))
    with zipfile.ZipFile(path) as archive:
        parts = {name: archive.read(name).decode() for name in archive.namelist()}
    parts[MODEL] = model(cube_object(9, attributes={3: 'paint_color="48403"'}))
    name = data.draw(st.sampled_from(sorted(parts)))
    place = data.draw(st.integers(0, len(parts[name])))
    end = place + data.draw(st.integers(0, 4))
    word = data.draw(st.sampled_from(["nan", "-1", "1e999", "<", "&", '"', "[", "null", "\0", "9"]))
    parts[name] = parts[name][:place] + word + parts[name][end:]
    write_zip(path, parts)
    content = bytearray(path.read_bytes())
    if data.draw(st.booleans()):
        content[data.draw(st.integers(0, len(content) - 1))] = data.draw(st.integers(0, 255))
    path.write_bytes(content)
    try:
        load_model(path)
    except WireprintError as error:
        assert str(path) in str(error)  # noqa: PT017


@pytest.mark.skipif(sys.platform != "linux", reason="reads the peak from /proc")
@pytest.mark.parametrize(
    "name", ["zip bomb", "path escape", "entity bomb", "index beyond", "endless attribute"]
)
def test_the_command_refuses_a_hostile_file_soon_and_in_little_memory(name, tmp_path, run_python):
    path = tmp_path / "hostile.3mf"
    parts = dict(HOSTILE[name][0])
    parts[MODEL] = parts[MODEL] if isinstance(parts[MODEL], str) else again(name)
    write_zip(path, parts)
    target = tmp_path / "x.gcode"
    code = (
        "from wireprint.cli import main\n"
        f"try:\n    main(['slice', {str(path)!r}, '-o', {str(target)!r}])\n"
        "except SystemExit as end:\n    print(end.code)\n"
        "print(next(line for line in open('/proc/self/status') if 'VmHWM' in line))"
    )
    begin = time.monotonic()
    code, _, peak, unit = run_python(code).split()
    assert code == "3"
    assert int(peak) < 200 * 1024, unit
    # A second on an idle machine, half of it the interpreter's start.
    assert time.monotonic() - begin < 10
    assert not target.exists()


def again(name):
    """The pieces of a part that another test may have used up."""
    return growing('<a b="', 40) if "attribute" in name else (bytes(1 << 20) for _ in range(64))


# --- against PrusaSlicer


@pytest.mark.skipif(shutil.which("prusa-slicer") is None, reason="prusa-slicer is not installed")
def test_prusa_slicer_paints_the_same_leaves(tmp_path):
    """Slice a painted triangle as the roof of a prism; each tool must stay in its leaves."""
    tree = [1, [2, 0, 2, 3], [0, 4, 3], [0, 0, 4, 2, 3]]
    prism = [(0, 0), (60, 0), (0, 50)]
    vertices = [(x, y, z) for z in (0, 2) for x, y in prism]
    faces = [(0, 2, 1), (3, 4, 5), (0, 1, 4), (0, 4, 3), (1, 2, 5), (1, 5, 4), (2, 0, 3), (2, 3, 5)]
    paint = {1: f'slic3rpe:mmu_segmentation="{encoded(tree)}"'}
    mesh = "".join(f'<vertex x="{x}" y="{y}" z="{z}"/>' for x, y, z in vertices)
    mesh = f"<vertices>{mesh}</vertices><triangles>" + "".join(
        f'<triangle v1="{a}" v2="{b}" v3="{c}" {paint.get(index, "")}/>'
        for index, (a, b, c) in enumerate(faces)
    )
    versions = '<metadata name="slic3rpe:MmPaintingVersion">1</metadata>'
    resources = f'<object id="1"><mesh>{mesh}</triangles></mesh></object>'
    text = model(resources).replace("<resources>", f"{versions}<resources>")
    path = write_zip(tmp_path / "painted.3mf", {MODEL: text, **OPC})
    target = tmp_path / "painted.gcode"
    four = lambda value: ",".join([value] * 4)  # noqa: E731
    subprocess.run(
        [
            *("prusa-slicer", "-g", path, "-o", target, "--single-extruder-multi-material"),
            *("--nozzle-diameter", four("0.4"), "--filament-diameter", four("1.75")),
            *("--temperature", four("200"), "--first-layer-temperature", four("200")),
            *("--extruder-offset", four("0x0"), "--skirts", "0", "--center", "130,125"),
            *("--bed-shape", "0x0,300x0,300x300,0x300", "--use-relative-e-distances"),
        ],
        check=True,
        capture_output=True,
    )
    roof = [np.array([x, y, 0.0]) for x, y in prism]
    checked = 0
    for point, tool in roof_points(target, (100, 100)):
        for triangle, state in leaves(tree, roof):
            if inside(point, triangle, 0) and margin(point, triangle) > 1.5:
                assert tool == max(state - 1, 0), (point, state)
                checked += 1
    assert checked > 500


OPC = {
    "[Content_Types].xml": (
        '<Types xmlns="http://schemas.openxmlformats.org/package/2006/content-types">'
        '<Default Extension="rels" '
        'ContentType="application/vnd.openxmlformats-package.relationships+xml"/>'
        '<Default Extension="model" '
        'ContentType="application/vnd.ms-package.3dmanufacturing-3dmodel+xml"/></Types>'
    ),
    "_rels/.rels": relationships(f"/{MODEL}", MODEL_TYPE),
}


def roof_points(path, shift):
    """Points along the strands of the highest layer, with the tool that prints them."""
    tool, at, found = 0, {"X": 0.0, "Y": 0.0, "Z": 0.0}, []
    for line in path.read_text().splitlines():
        words = line.split(";")[0].split()
        if words and words[0][:1] == "T" and words[0][1:].isdigit():
            tool = int(words[0][1:])
        if words and words[0] == "G1":
            values = {word[0]: float(word[1:]) for word in words[1:]}
            to = at | {axis: values[axis] for axis in "XYZ" if axis in values}
            if values.get("E", 0) > 0 and ("X" in values or "Y" in values):
                steps = math.ceil(math.hypot(to["X"] - at["X"], to["Y"] - at["Y"]))
                for step in range(steps):
                    share = (step + 0.5) / steps
                    x, y = (at[axis] + share * (to[axis] - at[axis]) for axis in "XY")
                    found.append((to["Z"], np.array([x - shift[0], y - shift[1], 0.0]), tool))
            at = to
    top = max(z for z, _, _ in found)
    return [(point, tool) for z, point, tool in found if z > top - 1e-6]


def margin(point, triangle):
    """Distance of a point inside from the nearest side."""
    sides = [(triangle[i], triangle[(i + 1) % 3]) for i in range(3)]
    return min(np.linalg.norm(np.cross(b - a, point - a)) / np.linalg.norm(b - a) for a, b in sides)
