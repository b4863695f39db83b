"""The library: its names, and that they are cheap, safe and repeatable."""

import base64
import re
import struct
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor

import numpy as np
import pytest

import wireprint
from wireprint import examples


@pytest.fixture(scope="module")
def mesh(tmp_path_factory):
    model = tmp_path_factory.mktemp("models") / "sphere.stl"
    model.write_bytes(examples.stl("sphere"))
    return wireprint.load_mesh(model)


@pytest.fixture(scope="module")
def settings():
    return wireprint.Settings.load()


@pytest.mark.parametrize("name", wireprint.__all__)
def test_every_name_can_be_had(name):
    assert getattr(wireprint, name) is not None
    assert name in dir(wireprint)


def test_an_unknown_name_is_an_attribute_error():
    with pytest.raises(AttributeError, match="no attribute 'slicer'"):
        wireprint.slicer  # noqa: B018


def test_importing_the_package_imports_nothing_else():
    code = (
        "import sys, wireprint\n"
        "heavy = {'numpy', 'pydantic', 'click', 'trimesh', 'shapely', 'wireprint._core'}\n"
        "sys.exit(repr(sorted(heavy & set(sys.modules))))"
    )
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=False)
    assert done.stderr.strip() == "[]"


def test_the_stages_one_by_one_give_what_make_gives(mesh, settings):
    strands = wireprint.wireframe(mesh, settings)
    path = wireprint.toolpath(strands, settings)
    made = wireprint.make(mesh, settings)
    assert wireprint.to_gcode(path, settings) == made.gcode
    assert made.figures()["posts"] == strands.post_count


def test_gcode_is_written_whole(mesh, settings, tmp_path):
    path = wireprint.make(mesh, settings).toolpath
    wireprint.write_gcode(tmp_path / "a.gcode", path, settings)
    assert (tmp_path / "a.gcode").read_bytes() == wireprint.to_gcode(path, settings)
    assert [file.name for file in tmp_path.iterdir()] == ["a.gcode"]


def test_the_header_carries_pictures_of_the_sizes_asked_for(mesh):
    settings = wireprint.Settings.load(overrides=["gcode.thumbnails=[[64, 48], [32, 32]]"])
    text = wireprint.make(mesh, settings).gcode.decode()
    found = re.findall(r"; thumbnail begin (\d+x\d+) \d+\n; (\S+)", text)
    assert [size for size, _ in found] == ["64x48", "32x32"]
    for _, row in found:
        assert base64.b64decode(row[:24]).startswith(b"\x89PNG")


def test_the_header_carries_pictures_in_the_forms_that_prusas_printers_read(mesh):
    sizes = "[[16, 16, 'QOI'], [313, 173, 'QOI'], [440, 240, 'QOI'], [64, 48]]"
    settings = wireprint.Settings.load(overrides=[f"gcode.thumbnails={sizes}"])
    text = wireprint.make(mesh, settings).gcode.decode()
    # As Prusa-Firmware-Buddy looks for them: form and size on the line, base64 until the end.
    found = re.findall(
        r"; thumbnail(|_QOI) begin (\d+)x(\d+) (\d+)\n((?:; \S+\n)+); thumbnail\1 end\n", text
    )
    assert [(form, int(w), int(h)) for form, w, h, _, _ in found] == [
        ("_QOI", 16, 16),
        ("_QOI", 313, 173),
        ("_QOI", 440, 240),
        ("", 64, 48),
    ]
    for form, width, height, length, rows in found:
        code = rows.replace("; ", "").replace("\n", "")
        assert len(code) == int(length)
        picture = base64.b64decode(code, validate=True)
        if form:
            assert picture[:4] == b"qoif"
            assert struct.unpack(">II", picture[4:12]) == (int(width), int(height))
        else:
            assert picture.startswith(b"\x89PNG")


def test_threads_may_share_a_mesh(mesh, settings):
    with ThreadPoolExecutor(4) as pool:
        texts = list(pool.map(lambda _: wireprint.make(mesh, settings).gcode, range(8)))
    assert len(set(texts)) == 1


def test_every_stage_measures_itself(mesh, settings):
    assert list(wireprint.make(mesh, settings).timings_s) == [
        "wireframe",
        "toolpath",
        "gcode",
        "check",
    ]


def test_a_model_fits_a_round_bed_if_any_place_on_it_will_do():
    """A long triangle: its box's centre is not its circle's, and only the latter fits."""
    outline = np.array([[0, 0], [160, 0], [20, 78]], float)
    low = np.column_stack([outline, np.zeros(3)])
    high = low + np.array([0, 0, 20])
    sides = [[a, b, b + 3, a, b + 3, a + 3] for a, b in ((0, 1), (1, 2), (2, 0))]
    faces = np.array([0, 2, 1, 3, 4, 5, *np.ravel(sides)]).reshape(-1, 3)
    mesh = wireprint.Mesh.from_arrays(np.vstack([low, high]), faces)
    assert mesh.reach_mm > 85
    made = wireprint.make(mesh, wireprint.Settings.load(), partial=True)
    assert made.mesh.reach_mm < 85
    assert made.certificate.ok
    assert made.certificate.fidelity.deviation_mm < 0.5


def test_a_ring_that_leaves_the_bed_is_not_printed(tmp_path):
    settings = wireprint.Settings.load(overrides=["bed.diameter_mm=42", "wire.skirt_rings=2"])
    (tmp_path / "cube.stl").write_bytes(examples.stl("cube"))
    cube = wireprint.load_mesh(tmp_path / "cube.stl")
    made = wireprint.make(cube, settings)
    assert made.certificate.ok
    assert b";TYPE:SKIRT" not in made.gcode
    assert b";TYPE:SKIRT" in wireprint.make(cube, wireprint.Settings.load()).gcode
