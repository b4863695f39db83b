"""The command line: help, errors, exit codes."""

import importlib
import json
import os
import subprocess
import sys

import click
import pytest
from click.testing import CliRunner

from wireprint import cli, examples
from wireprint._core import __version__


def run(*arguments):
    return CliRunner().invoke(cli.main, arguments)


def test_help_lists_every_command():
    result = run("--help")
    assert result.exit_code == 0
    for name in cli.COMMANDS:
        assert f"  {name}" in result.stdout


@pytest.mark.parametrize("name", cli.COMMANDS)
def test_the_summary_of_a_command_is_the_first_line_of_its_help(name):
    module, attribute, summary = cli.COMMANDS[name]
    command = getattr(importlib.import_module(module), attribute)
    assert isinstance(command, click.Command)
    assert command.help.splitlines()[0] == summary


@pytest.mark.parametrize("name", cli.COMMANDS)
def test_every_command_has_help(name):
    result = run(name, "--help")
    assert result.exit_code == 0
    assert result.stdout.startswith(f"Usage: main {name}") or f" {name} " in result.stdout


def test_the_version_is_the_packages():
    assert run("--version").stdout == f"wireprint {__version__}\n"


def test_help_imports_nothing_heavy():
    heavy = "{'numpy', 'pydantic', 'trimesh', 'shapely', 'rich', 'networkx', 'lxml'}"
    code = (
        "import sys\nfrom wireprint.cli import main\n"
        "try:\n    main(['--help'])\nexcept SystemExit:\n    pass\n"
        f"sys.exit(repr(sorted({heavy} & set(sys.modules))))"
    )
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=False)
    assert done.stderr.strip() == "[]"


def test_an_unknown_command_is_a_usage_error():
    result = run("slize")
    assert result.exit_code == 2
    assert result.stderr.startswith("wireprint: error: No such command 'slize'")
    assert len(result.stderr.splitlines()) <= 2


def test_an_unknown_option_is_a_usage_error():
    result = run("example", "cube", "--colour")
    assert result.exit_code == 2
    assert "--help" in result.stderr
    assert len(result.stderr.splitlines()) == 2


def test_an_unknown_profile_exits_with_4():
    result = run("profiles", "kossel")
    assert result.exit_code == 4
    assert result.stderr == (
        "wireprint: error: no profile is called 'kossel'; did you mean kossel-mini?\n"
    )


def test_a_fault_of_our_own_is_no_traceback(monkeypatch):
    def broken(name):
        raise RuntimeError("boom")

    monkeypatch.setattr(examples, "stl", broken)
    result = run("example", "cube", "-o", os.devnull)
    assert result.exit_code == 1
    assert result.stderr.startswith("wireprint: error: unexpected RuntimeError: boom")


def test_profiles_lists_them_all():
    result = run("profiles")
    assert result.exit_code == 0
    assert "kossel-mini" in result.stdout
    assert "petg" in result.stdout


def test_a_shown_profile_can_be_used_as_ones_own(tmp_path):
    from wireprint.settings import Settings

    mine = tmp_path / "mine.toml"
    mine.write_text(run("profiles", "kossel-mini").stdout, encoding="utf-8")
    assert Settings.load(printer=str(mine)) == Settings.load(printer="kossel-mini")


@pytest.mark.parametrize("shell", ["bash", "zsh", "fish"])
def test_shell_completion_is_offered(shell):
    done = subprocess.run(
        [sys.executable, "-c", "from wireprint.cli import main; main(prog_name='wireprint')"],
        env=os.environ | {"_WIREPRINT_COMPLETE": f"{shell}_source"},
        capture_output=True,
        text=True,
        check=False,
    )
    assert done.returncode == 0
    assert "_WIREPRINT_COMPLETE" in done.stdout


@pytest.mark.parametrize(
    ("words", "offered"),
    [
        ("slice a.stl --printer vor", "voron-2.4"),
        ("slice a.stl --material pe", "petg"),
        ("slice a.stl --set head.sl", "head.slant_deg="),
        ("profiles kos", "kossel-mini"),
    ],
)
def test_shells_are_offered_profiles_and_keys_of_settings(words, offered):
    done = subprocess.run(
        [sys.executable, "-m", "wireprint"],
        env=os.environ
        | {"_WIREPRINT_COMPLETE": "bash_complete", "COMP_WORDS": f"wireprint {words}"}
        | {"COMP_CWORD": str(len(words.split()))},
        capture_output=True,
        text=True,
        check=False,
    )
    assert f"plain,{offered}" in done.stdout.splitlines(), done


def test_a_failure_is_json_too_where_json_is_asked_for(tmp_path):
    for words in (["slice", "none.stl", "-o", "a.gcode"], ["check", "none.gcode"]):
        done = run(*words, "--json")
        found = json.loads(done.stdout)
        assert found["exit_code"] == done.exit_code == 3
        assert found["error"] in done.stderr
