"""Every error about a file of G-code names the file, the line where there is one, and a way out."""

import random
import re
import sys
from pathlib import Path

import pytest

import wireprint
from own_prints import lines_of
from wireprint._core import WireprintError
from wireprint.timing import estimate

sys.path.append(str(Path(__file__).parent / "fuzz"))

from inputs import Inputs

#: What to do instead: an option, a command, another form of the file.
WAY_OUT = re.compile(
    r"--\w+|slice it first|write it again|unpack|unzip|plain G-code|start it anew|export it again"
)


@pytest.fixture
def inputs(tmp_path, monkeypatch):
    """A maker of damaged files that has no command make anything."""
    monkeypatch.chdir(tmp_path)
    made = Inputs.__new__(Inputs)
    made.folder = tmp_path
    printers = ("kossel-mini", "prusa-mk4s", "voron-2.4")
    made.gcodes = ["\n".join(lines_of(printer)).encode() for printer in printers]
    return made


def errors_of(path):
    """What is said of a file by those who read it."""
    for read in (wireprint.check, estimate):
        try:
            read(path)
        except WireprintError as error:
            yield str(error)


def test_errors_of_damaged_files_name_file_line_and_a_way_out(inputs):
    said = []
    for seed in range(120):
        make = inputs.footer if seed % 3 else inputs.gcode
        path = make(random.Random(seed)).names[0]
        said += [(path, text) for text in errors_of(path)]
    assert len(said) > 60
    for path, text in said:
        assert text.startswith(f"{path}: "), text
        assert WAY_OUT.search(text), text
        if "settings that the file was made with" in text:
            assert re.search(r": line \d+: ", text), text


@pytest.mark.parametrize(
    "content",
    [
        b"",
        b"hello",
        b"GCDE\x01",
        b"\x1f\x8b\x08",
        b"PK\x03\x04broken",
        b"solid x\nendsolid x\n",
        b"\0",
    ],
)
def test_a_file_that_is_no_gcode_is_told_apart_with_a_way_out(content, tmp_path):
    path = tmp_path / "what.gcode"
    path.write_bytes(content)
    said = list(errors_of(str(path)))
    assert said
    for text in said:
        assert text.startswith(f"{path}: ")
        assert WAY_OUT.search(text), text


def test_the_line_of_a_setting_that_does_not_fit_is_that_of_its_key(tmp_path):
    lines = list(lines_of("kossel-mini"))
    index = next(i for i, line in enumerate(lines) if line.startswith("; printer.head.slant_deg"))
    lines[index] = "; printer.head.slant_deg = 100.0"
    path = tmp_path / "steep.gcode"
    path.write_text("\n".join(lines))
    for text in errors_of(str(path)):
        assert text.startswith(f"{path}: line {index + 1}: ")
        assert "head.slant_deg" in text
