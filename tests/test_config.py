"""``wireprint config``: the user's own printer and material."""

import pytest

from command import run


@pytest.fixture(autouse=True)
def own_config(tmp_path, monkeypatch):
    monkeypatch.setenv("XDG_CONFIG_HOME", str(tmp_path / "config"))
    monkeypatch.delenv("WIREPRINT_PRINTER", raising=False)
    return tmp_path / "config" / "wireprint" / "config.toml"


def machine(cube, *options):
    done = run("slice", cube, "-o", cube.with_suffix(".gcode"), *options)
    assert done.exit_code == 0, done.stderr
    return done.stdout.splitlines()[0].partition(" on ")[2]


def test_an_option_wins_over_the_variable_that_over_the_file_and_that_over_ours(cube, monkeypatch):
    assert machine(cube) == "kossel-mini with abs"
    assert run("config", "printer", "voron-2.4").stdout.startswith("printer: voron-2.4 (")
    assert run("config", "material", "pla").exit_code == 0
    assert machine(cube) == "voron-2.4 with pla"
    monkeypatch.setenv("WIREPRINT_PRINTER", "prusa-mk4s")
    assert machine(cube) == "prusa-mk4s with pla"
    assert machine(cube, "--printer", "kossel-mini") == "kossel-mini with pla"
    assert run("config", "material", "--unset").stdout == "material: abs (built in)\n"


def test_a_wrong_name_is_not_kept(own_config):
    assert run("config", "printer", "kossel").exit_code == 4
    assert not own_config.exists()


@pytest.mark.parametrize("text", ["printer", "printer = 3\n", "colour = 'red'\n"])
def test_a_damaged_file_is_named(text, own_config, cube):
    own_config.parent.mkdir(parents=True)
    own_config.write_text(text)
    done = run("slice", cube, "-o", cube.with_suffix(".gcode"))
    assert done.exit_code == 4
    assert str(own_config) in done.stderr
