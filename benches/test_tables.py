"""The scripts that write tables into docs/ still run."""

import os
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

import shared_models
from wireprint import examples

BENCHES = Path(__file__).parent


def page(script, folder):
    """Let a script write its page about a cube and about a file that is no model."""
    (folder / "cube.stl").write_bytes(examples.stl("cube"))
    (folder / "broken.stl").write_bytes(b"no model")
    manifest = folder / "manifest.csv"
    manifest.write_text("name\ncube.stl\nbroken.stl\n")
    target = folder / "page.md"
    command = [sys.executable, BENCHES / script, manifest, "-o", target, "--jobs", "1"]
    done = subprocess.run(command, capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    return target.read_text().splitlines()


def cells(row):
    return [cell.strip() for cell in row.strip("|").split("|")]


def test_the_certificates_have_a_row_for_each_model_with_the_reason_where_one_fails(tmp_path):
    lines = page("certificates.py", tmp_path)
    table = [cells(line) for line in lines if line.startswith("|")]
    assert len({len(row) for row in table}) == 1
    _, _, cube, broken = table
    assert cube[:2] == ["cube.stl", "0"]
    assert float(cube[2].rstrip("%")) > 95
    assert broken[0] == "broken.stl"
    assert "STL" in broken[1]
    assert any(line.startswith("1 of 2 models; 1 without a breach") for line in lines)


def test_the_cost_has_a_row_for_each_size_of_each_model(tmp_path):
    target = tmp_path / "cost.md"
    command = [sys.executable, BENCHES / "cost.py", "-o", target, "--most", "1000"]
    subprocess.run(command, check=True, capture_output=True)
    rows = [cells(line) for line in target.read_text().splitlines() if line.startswith("|")]
    assert [row[0] for row in rows[2:]] == ["vase", "pins"]
    assert all(int(row[1]) > 500 for row in rows[2:])


def test_curas_prints_are_judged_at_either_angle(tmp_path):
    ready = shared_models.SHARED.is_dir() and "CURA_DEFS_HOME" in os.environ
    if not ready or not shutil.which("CuraEngine"):
        pytest.skip("needs CuraEngine: ../shared/peers/setup.sh DIR, and CURA_DEFS_HOME=DIR")
    lines = page("cura_certificates.py", tmp_path)
    cubes = [cells(line) for line in lines if line.startswith("| cube.stl")]
    assert len(cubes) == 2
    assert all(int(row[1]) > 0 for row in cubes)
    assert [line for line in lines if line.startswith("## ")] == ["## 45°", "## 32°"]


def test_the_printers_have_a_row_each_with_a_time_for_each_thing(tmp_path):
    target = tmp_path / "printers.md"
    command = [sys.executable, BENCHES / "printers.py", "-o", target, "--only", "kossel-mini"]
    subprocess.run([*command, "--nozzles", "0.4"], check=True, capture_output=True)
    rows = [cells(line) for line in target.read_text().splitlines() if line.startswith("|")]
    (row,) = rows[2:]
    assert row[0] == "kossel-mini"
    assert all(":" in time for time in row[2].split("<br>"))
