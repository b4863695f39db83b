"""What model files are read as: every dialect of docs/formats.md gives the model it describes."""

import re
import struct
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from model_files import (
    DIALECTS,
    POINTS,
    QUADS,
    TRIANGLES,
    obj,
    off,
    ply_bytes,
    ply_header,
    ply_text,
    stl_bytes,
)
from wireprint._core import ModelError
from wireprint.mesh import load_mesh

#: Dialects that deviate from their format so far that it is said.
NOTED = {
    "obj-lines-and-points": "lines and points left out",
    "ply-trailing-bytes": "what follows the last element",
    "stl-binary-count-0": "the count at byte 80 is 0",
    "stl-binary-tail": "bytes after the last facet passed over: 1",
    "stl-ascii-nan-normals": "normals that are no numbers",
    "stl-ascii-text-after-endloop": "text after endloop or endfacet",
    "stl-ascii-no-endsolid": "ends without endsolid",
    "stl-ascii-two-solids": "ends without endsolid",
    "stl-ascii-control-z": "a ^Z ends the text",
    "amf-volume-for-supports": "1 volume left out: for supports, or for settings",
    "amf-volume-for-settings": "1 volume left out: for supports, or for settings",
}


def written(folder, suffix, content):
    path = folder / f"model.{suffix}"
    path.write_bytes(content if isinstance(content, bytes) else content.encode())
    return path


@pytest.mark.parametrize("name", DIALECTS)
def test_a_dialect_gives_the_cube(name, tmp_path):
    mesh = load_mesh(written(tmp_path, *DIALECTS[name]))
    assert mesh.size_mm == [20, 20, 20]
    assert (mesh.volume, mesh.area) == (pytest.approx(8000), pytest.approx(2400))
    report = mesh.report
    assert (report["components"], report["boundary_edges"], report["facets"]) == (1, 0, 12)
    assert report["flipped_facets"] == 0
    assert [NOTED[name] in note for note in mesh.notes] == [True] * (name in NOTED)


def test_the_page_of_formats_names_every_dialect_and_no_other():
    page = (Path(__file__).parents[1] / "docs" / "formats.md").read_text()
    assert set(re.findall(r"`((?:obj|ply|off|stl|amf)-[a-z0-9-]+)`", page)) == set(DIALECTS)


# --- faces of many corners


def prism(outline, height=10.0):
    """A prism over an outline, counter-clockwise, as points and faces of many corners."""
    count = len(outline)
    points = [(x, y, z) for z in (0.0, height) for x, y in outline]
    sides = [(i, (i + 1) % count, (i + 1) % count + count, i + count) for i in range(count)]
    return points, [tuple(range(count))[::-1], tuple(range(count, 2 * count)), *sides]


def area(outline):
    x, y = np.transpose(outline)
    return (x * np.roll(y, -1) - np.roll(x, -1) * y).sum() / 2


U = [(0, 0), (40, 0), (40, 30), (30, 30), (30, 10), (10, 10), (10, 30), (0, 30)]
#: A square with a square hole that a seam joins to its outline.
KEYHOLE = [
    (0, 0),
    (30, 0),
    (30, 30),
    (0, 30),
    (0, 0),
    (10, 10),
    (10, 20),
    (20, 20),
    (20, 10),
    (10, 10),
]
COMB = [(0, 0), (90, 0), *((90 - x, 40 if x % 10 == 5 else 5) for x in range(5, 90, 5)), (0, 40)]
COLLINEAR = [(0, 0), (10, 0), (20, 0), (30, 0), (30, 10), (30, 20), (15, 20), (0, 20), (0, 1)]


def star(random, count):
    """A simple outline with random corners in and out."""
    turns = np.sort(random.uniform(0, 2 * np.pi, count))
    radii = random.uniform(3, 40, count)
    return list(zip(radii * np.cos(turns), radii * np.sin(turns), strict=True))


def turned_about(points, random):
    """Points turned in space, so that no face lies in a plane of the axes."""
    matrix, _ = np.linalg.qr(random.normal(size=(3, 3)))
    return np.array(points) @ (matrix * np.sign(np.linalg.det(matrix)))


def off_file(folder, points, faces):
    text = off(f"OFF\n{len(points)} {len(faces)} 0\n", points, [[len(f), *f] for f in faces])
    return written(folder, "off", text)


@pytest.mark.parametrize("first", range(8))
@pytest.mark.parametrize(
    "outline", [U, COMB, COLLINEAR, KEYHOLE], ids=["U", "comb", "row", "keyhole"]
)
def test_a_concave_face_is_covered_once_and_joined_to_its_neighbours(outline, first, tmp_path):
    outline = outline[first:] + outline[:first]
    points, faces = prism(outline)
    mesh = load_mesh(off_file(tmp_path, points, faces))
    sides = np.hypot(*np.subtract(outline, np.roll(outline, 1, axis=0)).T).sum()
    assert mesh.volume == pytest.approx(10 * area(outline))
    assert mesh.area == pytest.approx(2 * area(outline) + 10 * sides)
    assert mesh.report["boundary_edges"] == 0


@given(seed=st.integers(0, 2**32 - 1), count=st.integers(4, 60))
def test_any_simple_outline_is_covered_once(seed, count, tmp_path_factory):
    random = np.random.default_rng(seed)
    outline = star(random, count)
    points, faces = prism(outline)
    path = off_file(tmp_path_factory.mktemp("star"), turned_about(points, random).tolist(), faces)
    mesh = load_mesh(path)
    assert mesh.volume == pytest.approx(10 * abs(area(outline)), rel=1e-6)
    assert mesh.report["boundary_edges"] == 0


def test_a_face_whose_outline_crosses_itself_is_named(tmp_path):
    points, faces = prism([(0, 0), (10, 10), (10, 0), (0, 12), (-5, 5)])
    mesh = load_mesh(off_file(tmp_path, points, faces))
    assert mesh.notes == [
        "faces whose outline crosses itself, filled as well as it goes: 2 times, first in face 1"
    ]


# --- what is refused

LITTLE = (ply_header("binary_little_endian") + "end_header\n").encode() + ply_bytes("<")
#: Name → suffix, content, and what the message says besides the file.
REFUSED = {
    "no face": ("obj", "v 0 0 0\nv 1 0 0\n", "no facets, only points"),
    "nothing": ("obj", "# nothing\n", "no facets"),
    "index 0": ("obj", obj() + "f 0 1 2\n", "line 15: a face has the corner '0', of 8 vertices"),
    "index beyond": ("obj", obj() + "f 9 1 2\n", "line 15: .* vertex 9, but there are 8 .* from 1"),
    "negative index beyond": ("obj", obj() + "f -9 1 2\n", "line 15: .* corner '-9'"),
    "index no number": ("obj", obj() + "f 1 2 x/3\n", "line 15: 'x' is no such number"),
    "decimal comma": ("obj", "v 0,5 0 0\n" + obj(), "line 1: '0,5' is no such number"),
    "nan": ("obj", "v 0 nan 0\n" + obj(), "line 1: NaN is no finite, sensible coordinate"),
    "huge coordinate": ("obj", "v 0 1e300 0\n" + obj(), "line 1: .*sensible coordinate"),
    "few coordinates": ("obj", "v 0 0\n" + obj(), "line 1: a number is missing"),
    "free form": ("obj", "vp 0 0\nsurf 0 1 0 1 1 2\n", "free-form curves and surfaces"),
    "another file": ("obj", "call other.obj\n" + obj(), "line 1: it calls another file"),
    "no ply": ("ply", "solid x\n", "line 1: expected ply, found 'solid x'"),
    "endless header": ("ply", "ply\nformat ascii 1.0\n", "line 2: the header does not end"),
    "no format": ("ply", "ply\nend_header\n", "line 2: no format"),
    "other format": ("ply", "ply\nformat binary 1.0\n", "line 2: 'binary' is no format"),
    "word of no header": ("ply", "ply\nelemnt vertex 8\n", "line 2: 'elemnt' is no word"),
    "type of no value": (
        "ply",
        "ply\nformat ascii 1.0\nelement vertex 1\nproperty real x\n",
        "line 4: 'real' is no type",
    ),
    "no z": (
        "ply",
        (ply_header() + "end_header\n").replace("property float z\n", "") + ply_text(),
        "vertex 0 of 8: it has no property z",
    ),
    "no list": (
        "ply",
        (ply_header() + "end_header\n").replace("vertex_indices", "corners") + ply_text(),
        "face 0 of 6: it has no property vertex_indices",
    ),
    "element twice": (
        "ply",
        ply_header() + "element vertex 1\nproperty int x\nend_header\n" + ply_text(),
        "vertex is declared twice",
    ),
    "scan": (
        "ply",
        ply_header() + "element range_grid 1\nproperty int a\nend_header\n" + ply_text() + "1\n",
        "grid of a scanner",
    ),
    "bytes that end early": ("ply", LITTLE[:-1], "face 6 of 6: the file ends early"),
    "count of billions": (
        "ply",
        LITTLE.replace(b"face 6", b"face 4000000000"),
        "face 7 of 4000000000: the file ends early",
    ),
    "list of billions": (
        "ply",
        (ply_header("binary_little_endian", lists="uint int") + "end_header\n").encode()
        + ply_bytes("<", length="I")[:-20]
        + struct.pack("<II", 2**32 - 1, 0),
        "face 6 of 6: the file ends early",
    ),
    "negative vertex": ("ply", LITTLE[:-4] + b"\xff" * 4, "-1 is no index of a vertex"),
    "vertex beyond": (
        "ply",
        ply_header() + "end_header\n" + ply_text([*QUADS[:5], (1, 3, 7, 8)]),
        "line 25: .* vertex 8, but there are 8 vertices, counted from 0",
    ),
    "vertex between": (
        "ply",
        ply_header() + "end_header\n" + ply_text([*QUADS[:5], (1, 3, 7, 5.5)]),
        "line 25: face 6 of 6: 5.5 is no index",
    ),
    "many values": (
        "ply",
        ply_header() + "end_header\n" + ply_text().replace("20 20 20", "20 20 20 7"),
        "line 19: vertex 8 of 8: there are more values",
    ),
    "few values": (
        "ply",
        ply_header() + "end_header\n" + ply_text().replace("20 20 20", "20 20"),
        "line 19: vertex 8 of 8: a number is missing",
    ),
    "no off": ("off", "<html>", "line 1: expected OFF and how many"),
    "counts missing": ("off", "OFF\n", "line 1: the file ends early"),
    "other dimensions": ("off", "nOFF\n5\n8 6 0\n", "not of three dimensions"),
    "faces missing": ("off", off("OFF\n8 7 0\n"), "line 16: the file ends early"),
    "count of billions in text": ("off", off("OFF\n4000000000 6 0\n"), "the file ends early"),
    "corner beyond": ("off", off(faces=[[3, 0, 1, 9]] * 6), "line 11: .* vertex 9"),
    "negative corner": ("off", off(faces=[[3, 0, 1, -1]] * 6), "line 11: '-1' is no such number"),
    "corners missing": ("off", off(faces=[[4, 0, 1, 2]] * 6), "line 11: a number is missing"),
    "colours without lines": (
        "off",
        "COFF 1 1 0 " + "0 " * 9,
        "colours or normals, but no line of their own",
    ),
    "endless weight": ("off", "4OFF\n1 0 0\n1 1 1 0\n", "line 3: inf is no finite"),
    "binary counts": ("off", b"OFF BINARY\n" + struct.pack(">3i", -1, 0, 0), "byte 15: -1 is no"),
    "short stl": ("stl", stl_bytes()[:-30], "declares 12 facets"),
}


@pytest.mark.parametrize("name", REFUSED)
def test_what_makes_no_sense_is_refused_with_its_place(name, tmp_path):
    suffix, content, complaint = REFUSED[name]
    path = written(tmp_path, suffix, content)
    with pytest.raises(ModelError, match=complaint) as refused:
        load_mesh(path)
    assert str(refused.value).startswith(f"{path}: ")
    assert "export" in str(refused.value)


def test_what_is_left_out_is_said(tmp_path):
    text = obj() + "v 1 1 1\nf 1 2\nf 9 9\ncurv 0 1\nnonsense\nnonsense\n"
    mesh = load_mesh(written(tmp_path, "obj", text))
    assert mesh.notes == [
        "faces of fewer than three corners left out: 2 times, first in line 16",
        "free-form curves and surfaces left out (line 18)",
        "what is no statement of OBJ passed over: 2 times, first in line 19",
    ]
    assert mesh.volume == pytest.approx(8000)


@pytest.mark.parametrize("turned", range(len(TRIANGLES) + 1))
def test_turned_facets_are_counted_once(turned, tmp_path):
    faces = [face[::-1] if i < turned else face for i, face in enumerate(TRIANGLES)]
    path = off_file(tmp_path, POINTS, faces)
    mesh = load_mesh(path)
    assert mesh.report["flipped_facets"] == turned
    assert mesh.volume == pytest.approx(8000)


def test_a_fresh_install_reads_every_format(tmp_path, run_python):
    """Neither numpy nor any reader of others is needed on the way."""
    names = ["obj-quads", "ply-other-elements", "off-latin-1", "obj-latin-1", "stl-ascii"]
    paths = []
    for name in names:
        (tmp_path / name).mkdir()
        paths.append(str(written(tmp_path / name, *DIALECTS[name])))
    run_python(
        "import sys\n"
        "for name in ('trimesh', 'scipy', 'charset_normalizer', 'chardet', 'lxml', 'networkx'):\n"
        "    sys.modules[name] = None\n"
        "from wireprint.mesh import load_mesh\n"
        f"for path in {paths!r}:\n    assert load_mesh(path).size_mm == [20, 20, 20]\n"
        "assert 'numpy' not in sys.modules"
    )


@pytest.mark.parametrize("suffix", ["step", "STP", "iges"])
def test_a_broken_cad_model_is_told_with_a_way_out(suffix, tmp_path):
    path = tmp_path / f"a.{suffix}"
    path.write_text("ISO-10303-21;")
    with pytest.raises(ModelError, match=r"CAD model|read: .*export it as STL"):
        load_mesh(path)
