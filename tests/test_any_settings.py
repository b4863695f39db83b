"""Any settings give a print, or an error that says which of them is wrong."""

import sys
from pathlib import Path

from hypothesis import HealthCheck, given, settings

sys.path.append(str(Path(__file__).parent / "fuzz"))

from strategies import KEYS, allowed, drawn

import wireprint
from wireprint import SettingError, Settings, WireprintError

#: The same settings every time: `tests/fuzz/settings.py` looks for new ones.
REPEATED = {"derandomize": True, "deadline": None, "suppress_health_check": list(HealthCheck)}


def loaded(one):
    return Settings.load(one.printer, one.material, overrides=one.overrides)


@settings(max_examples=200, **REPEATED)
@given(drawn())
def test_settings_are_accepted_or_refused_by_a_key(one):
    try:
        accepted = loaded(one)
    except SettingError as error:
        told = str(error)
        assert any(key.rpartition(".")[2] in told for key in one.keys), (one, told)
    else:
        assert Settings.from_mapping(accepted.model_dump()) == accepted


@settings(max_examples=12, **REPEATED)
@given(drawn(most=3))
def test_what_is_accepted_gives_a_print_or_says_why_not(cube, one):
    try:
        told = wireprint.make(cube, loaded(one), compare=False).gcode
    except WireprintError as error:
        told = str(error)
    assert told


def test_every_key_that_is_stated_has_values_that_are_allowed():
    for key in KEYS:
        assert not allowed(key).is_empty, key.key
