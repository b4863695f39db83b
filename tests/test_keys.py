"""Every key of the settings is told: what it is, in which unit, between which bounds."""

import json

import pytest
from click.testing import CliRunner

import wireprint
from wireprint import _compose, cli
from wireprint.settings import Settings, describe


def run(*arguments):
    return CliRunner().invoke(cli.main, ["profiles", *arguments])


def test_all_keys_are_there_by_the_names_that_set_takes():
    shorts = [key.short for key in describe()]
    # What each macro has is no key of its own: macros are a list.
    lists = tuple(f"{key.short}." for key in describe() if key.kind == "list")
    known = {key for key in _compose.keys(Settings) if not key.startswith(lists)}
    assert known <= set(shorts)
    assert len(shorts) == len(set(shorts))
    assert wireprint.settings.describe() == describe()


def test_each_number_has_bounds_and_what_has_a_unit_tells_it():
    for key in describe():
        if key.kind in ("number", "integer"):
            assert key.low is not None, key
            assert key.high is not None, key
        if key.key.endswith(("_mm", "_s", "_c", "_deg", "_mpa", "_n")):
            assert key.unit, key


def test_each_key_has_a_default_or_says_where_it_comes_from():
    for key in describe():
        assert key.default_text
        assert key.required == (key.default_text == "from the profile"), key


def test_each_key_says_what_it_is():
    assert [key.key for key in describe() if not key.help] == []


@pytest.mark.parametrize(
    ("short", "bounds", "default", "unit"),
    [
        ("head.slant_deg", "5 … 85", "from the profile", "°"),
        ("wire.pattern", "zigzag | peaks", "zigzag", ""),
        ("wire.caps", "true | false", "true", ""),
        ("wire.slab_min_mm", "0.1 … 2000", "automatic", "mm"),
        ("wire.brim_rings", "0 … 50 | auto", "auto", ""),
        ("wire.cap_spacing_mm", "> 0.5 … 50", "6", "mm"),
        ("motion.max_velocity", "0.1 … 5000", "from the profile", "mm/s"),
    ],
)
def test_a_key_is_told_as_it_is(short, bounds, default, unit):
    (key,) = [key for key in describe() if key.short == short]
    assert (key.bounds, key.default_text, key.unit) == (bounds, default, unit)


def test_the_command_lists_them_in_words_and_as_json():
    words = run("--keys")
    told = json.loads(run("--keys", "--json").stdout)["keys"]
    assert len(told) == len(describe())
    for key in told:
        assert f"{key['short']} = " in words.stdout


def test_keys_are_chosen_by_their_beginning():
    found = run("--keys", "head").stdout
    assert "head.slant_deg = from the profile °  (5 … 85)" in found
    assert "wire." not in found
    refused = run("--keys", "haed")
    assert refused.exit_code == 4
    assert "did you mean head" in refused.output


def test_profiles_are_told_as_json():
    assert json.loads(run("--json").stdout)["printers"]["kossel-mini"]
    shown = json.loads(run("--json", "kossel-mini").stdout)
    assert shown["printer"]["head"]["slant_deg"] > 0
