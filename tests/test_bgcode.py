"""Binary G-code, and plates in archives, are read as the plain G-code that they were made from."""

import random
import zipfile

import pytest

from bgcode_files import (
    DEFLATE,
    MEATPACK,
    MEATPACK_WITH_COMMENTS,
    NONE,
    PLAIN,
    SHRINK_11,
    SHRINK_12,
    TEXT,
    bgcode,
    block,
    meatpacked,
    whole,
)
from command import run
from wireprint import GcodeError, estimate
from wireprint.gcode.source import read


@pytest.mark.parametrize("checked", [True, False])
@pytest.mark.parametrize("encoding", [PLAIN, MEATPACK, MEATPACK_WITH_COMMENTS])
@pytest.mark.parametrize("compression", [NONE, DEFLATE, SHRINK_11, SHRINK_12])
def test_every_packing_gives_the_text_back(compression, encoding, checked, tmp_path):
    path = tmp_path / "a.bgcode"
    path.write_bytes(whole(compression, encoding, checked))
    text, _ = read(path)
    assert TEXT in text.replace(b"\n\n", b"\n")
    assert b"; printer_model = MK4S\n" in text
    assert b"PNG" not in text


def test_an_e_stands_for_the_space_where_spaces_are_left_out(tmp_path):
    path = tmp_path / "a.bgcode"
    content = meatpacked(b"G1X10E2.5F600\n", spaceless=True)
    path.write_bytes(bgcode(block(1, content, SHRINK_11, MEATPACK)))
    assert read(path)[0] == b"G1X10E2.5F600\n"


def test_it_is_timed_as_its_text_on_the_printer_that_it_names(tmp_path):
    path = tmp_path / "a.bgcode"
    path.write_bytes(whole())
    found = estimate(path)
    assert found.printer == "prusa-mk4s"
    assert found.stated_s == 62
    plain = tmp_path / "a.gcode"
    plain.write_bytes(b"; printer_model = MK4S\n" + TEXT)
    assert found.total_s == estimate(plain).total_s > 0


def test_every_damage_is_an_error_that_names_the_file(tmp_path):
    chance = random.Random(5)
    content, path = whole(), tmp_path / "a.bgcode"
    cuts = [content[:end] for end in range(len(b"GCDE"), len(content))]
    flips = []
    for place in range(len(b"GCDE"), len(content)):
        flipped = bytearray(content)
        flipped[place] ^= 1 << chance.randrange(8)
        flips.append(bytes(flipped))
    for one in flips:
        path.write_bytes(one)
        with pytest.raises(GcodeError, match=r"a\.bgcode: .*(damaged|version)"):
            read(path)
    refused = []
    for one in cuts:
        path.write_bytes(one)
        try:
            read(path)
        except GcodeError as error:
            refused.append(str(error))
    assert all("a.bgcode: damaged" in reason for reason in refused)
    # Behind the header, and each block but the last.
    assert len(cuts) - len(refused) == 7


@pytest.mark.parametrize(
    "content",
    [
        bgcode(version=2),
        bgcode(block(1, TEXT, size=1 << 31)),
        bgcode(block(1, TEXT, DEFLATE, size=len(TEXT) + 1)),
        bgcode(block(1, TEXT, DEFLATE, size=len(TEXT) - 1)),
        bgcode(block(1, TEXT, encoding=3)),
        bgcode(block(6, TEXT)),
        bgcode(block(1, bytes(1 << 28), DEFLATE)),
        bgcode(*[block(1, bytes(1 << 20), DEFLATE)] * 200),
    ],
    ids=["version", "size", "short", "long", "encoding", "type", "bomb", "bombs"],
)
def test_what_is_not_as_the_specification_says_is_refused(content, tmp_path):
    path = tmp_path / "a.bgcode"
    path.write_bytes(content)
    done = run("estimate", path)
    assert done.exit_code == 3
    assert "a.bgcode: " in done.stderr


@pytest.mark.parametrize("method", [zipfile.ZIP_STORED, zipfile.ZIP_DEFLATED])
@pytest.mark.parametrize(
    ("name", "part"),
    [("a.gcode.3mf", "Metadata/plate_1.gcode"), ("a.ufp", "/3D/model.gcode")],
)
def test_a_sliced_plate_is_timed_as_its_gcode(name, part, method, tmp_path):
    path, plain = tmp_path / name, tmp_path / "a.gcode"
    with zipfile.ZipFile(path, "w", method) as archive:
        archive.writestr("[Content_Types].xml", "<Types/>")
        archive.writestr(part, TEXT)
    plain.write_bytes(TEXT)
    assert estimate(path).total_s == estimate(plain).total_s > 0


@pytest.mark.parametrize("suffix", ["bgcode", "ufp", "gcode"])
def test_it_is_no_model(suffix, tmp_path):
    path = tmp_path / f"a.{suffix}"
    path.write_bytes(whole())
    done = run("info", path)
    assert done.exit_code == 3
    assert "G-code, sliced already" in done.stderr
