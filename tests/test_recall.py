"""Settings recalled from the cache are those that validation gave."""

import random
import re
import subprocess
import sys

import pytest

from wireprint import _recall
from wireprint.settings import Settings


@pytest.fixture(autouse=True)
def cache(tmp_path, monkeypatch):
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path))
    return tmp_path / "wireprint"


def values_of(group, kept):
    """All values of a group and of the groups within, properties included."""
    names = {**kept["fields"], **kept["derived"]}
    return {
        name: values_of(getattr(group, name), value)
        if isinstance(value, dict)
        else getattr(group, name)
        for name, value in names.items()
    }


@pytest.mark.parametrize("printer", ["kossel-mini", "prusa-mk4s"])
def test_what_is_recalled_has_the_values_and_properties_of_what_was_validated(printer, cache):
    first = _recall.settings(printer, "pla", (), ["wire.pause_s=0.5"])
    again = _recall.settings(printer, "pla", (), ["wire.pause_s=0.5"])
    assert isinstance(first, Settings)
    assert isinstance(again, _recall.Recalled)
    assert values_of(again, _recall.plain(first)) == values_of(first, _recall.plain(first))
    assert again.model_dump() == first.model_dump()
    assert again.model_dump(mode="json") == first.model_dump(mode="json")
    assert again.printer.head.model_copy() == first.printer.head
    assert str(again.printer.bed) == str(first.printer.bed)


def test_another_text_is_validated_anew(tmp_path):
    own = tmp_path / "own.toml"
    own.write_text("[wire]\npause_s = 0.25\n")
    assert _recall.settings("kossel-mini", "abs", [own], ()).pause_s == 0.25
    own.write_text("[wire]\npause_s = 0.75\n")
    assert _recall.settings("kossel-mini", "abs", [own], ()).pause_s == 0.75
    assert _recall.settings("kossel-mini", "abs", [own], ["wire.pause_s=2"]).pause_s == 2


@pytest.mark.parametrize("harm", [b"", b"{", b"[]", b'{"key": 1}', b"\xff", b"\n", b"00000000\n"])
def test_a_damaged_cache_is_not_believed(cache, harm):
    _recall.settings("kossel-mini", "abs", (), ())
    (kept,) = cache.iterdir()
    whole = kept.read_bytes()
    kept.write_bytes(harm)
    assert isinstance(_recall.settings("kossel-mini", "abs", (), ()), Settings)
    assert kept.read_bytes() == whole


@pytest.mark.parametrize("seed", range(20))
def test_values_that_were_changed_in_the_cache_are_not_believed(cache, seed):
    expected = _recall.settings("kossel-mini", "abs", (), ())
    (kept,) = cache.iterdir()
    whole = kept.read_bytes()
    draw = random.Random(seed)
    values = whole.index(b'"values"')
    places = [match.start() for match in re.finditer(rb"[0-9]", whole) if match.start() > values]
    place = draw.choice(places)
    digit = draw.choice([d for d in b"123456789" if d != whole[place]])
    kept.write_bytes(whole[:place] + bytes([digit]) + whole[place + 1 :])
    again = _recall.settings("kossel-mini", "abs", (), ())
    assert isinstance(again, Settings)
    assert again == expected
    assert kept.read_bytes() == whole
    assert isinstance(_recall.settings("kossel-mini", "abs", (), ()), _recall.Recalled)


def test_a_cache_that_cannot_be_written_to_is_done_without(tmp_path, monkeypatch):
    (tmp_path / "file").write_text("")
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path / "file"))
    assert isinstance(_recall.settings("kossel-mini", "abs", (), ()), Settings)


def test_the_second_slice_loads_no_pydantic_and_writes_the_same_bytes(tmp_path):
    script = (
        "import sys\n"
        "from wireprint.cli import main\n"
        "main(sys.argv[1:], standalone_mode=False)\n"
        "print('pydantic' in sys.modules)\n"
    )
    make = [sys.executable, "-c", script, "example", "cube"]
    subprocess.run(make, cwd=tmp_path, capture_output=True, check=True)
    runs = []
    for name in ("a.gcode", "b.gcode"):
        command = [sys.executable, "-c", script, "slice", "cube.stl", "-q", "-o", name]
        run = subprocess.run(command, cwd=tmp_path, capture_output=True, text=True, check=True)
        runs.append((run.stdout.strip(), (tmp_path / name).read_bytes()))
    assert [run[0] for run in runs] == ["True", "False"]
    assert runs[0][1] == runs[1][1]
