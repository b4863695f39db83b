"""Models are printed as the goldens say; `python benches/goldens.py` tells what differs."""

import pytest

import goldens
from wireprint.threads import cores


@pytest.fixture(scope="session")
def prints():
    """What all models come to now, by printer and name."""
    return goldens.rows(jobs=cores())


@pytest.mark.parametrize("machine", goldens.MACHINES)
@pytest.mark.parametrize("source", ["example", "shared"])
def test_models_are_printed_as_their_goldens_say(prints, source, machine):
    after = {key: row for key, row in prints.items() if key[0] == machine}
    after = {key: row for key, row in after.items() if key[1].startswith(source)}
    if not after:
        pytest.skip("the shared models are absent")
    before = goldens.kept()
    found = goldens.changes(before, after)
    hint = "\nIf this is meant: python benches/goldens.py --update, and tell why in the commit."
    assert not found, goldens.told(found, before, after) + hint


def golden(**cells):
    return {
        ("kossel-mini/abs", "example/cube.stl"): goldens.golden(
            {"posts": "40", "coverage": "0.9900", "travel_mm": "100.0", "breaches": "0"} | cells
        )
    }


@pytest.mark.parametrize(
    ("cells", "verdict"),
    [
        ({"coverage": "0.9800"}, "worse"),
        ({"coverage": "1.0000"}, "better"),
        ({"travel_mm": "99.0"}, "better"),
        ({"breaches": "1"}, "worse"),
        ({"error": "leaves the build volume", "posts": ""}, "worse"),
        ({"posts": "41"}, None),
        ({"toolpath": "0123456789abcdef"}, None),
    ],
)
def test_a_change_is_told_with_its_verdict(cells, verdict):
    before, after = golden(), golden(**cells)
    *_, change = goldens.changes(before, after)
    assert change.verdict == verdict
    assert "example/cube.stl on kossel-mini/abs" in goldens.told([change], before, after)
    assert not goldens.changes(after, after)


def test_the_words_of_an_error_do_not_matter():
    assert not goldens.changes(golden(error="too wide"), golden(error="wider than the bed"))


def test_goldens_are_read_as_they_were_written(tmp_path, monkeypatch):
    monkeypatch.setattr(goldens, "FOLDER", tmp_path)
    kept = golden()
    goldens.keep(kept)
    assert goldens.kept() == kept
