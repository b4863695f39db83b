"""CAD models: what the kernel makes of them, and that its faults stay its own."""

import math
import os
import random
import subprocess
import sys

import pytest

import step_files
from command import run
from wireprint import ModelError, cad, load_mesh

pytest.importorskip("cascadio", reason="Open CASCADE is not installed: pip install '.[step]'")


def written(folder, text, name="model.step"):
    (folder / name).write_text(text)
    return folder / name


@pytest.mark.parametrize("name", ["model.step", "model.STP"])
def test_a_box_is_as_large_as_its_file_says(name, tmp_path):
    mesh = load_mesh(written(tmp_path, step_files.box((10, 20, 30)), name))
    assert mesh.size_mm == pytest.approx([10, 20, 30], abs=1e-4)
    assert mesh.volume == pytest.approx(6000, rel=1e-5)
    assert (mesh.report["facets"], mesh.report["boundary_edges"]) == (12, 0)


@pytest.mark.parametrize(
    ("unit", "mm"), [("SI_UNIT(.CENTI.,.METRE.)", 10), ("SI_UNIT($,.METRE.)", 1000)]
)
def test_the_files_own_unit_counts(unit, mm, tmp_path):
    path = written(tmp_path, step_files.box([30 / mm, 20 / mm, 10 / mm], unit))
    assert load_mesh(path).size_mm == pytest.approx([30, 20, 10], abs=1e-3)
    refused = run("info", path, "--units", "inch")
    assert "states its own unit" in refused.stderr


def test_a_round_surface_is_followed_within_what_is_said(tmp_path):
    radius, height = 20, 50
    mesh = load_mesh(written(tmp_path, step_files.cylinder(radius, height)))
    exact = math.pi * radius**2 * height
    least = math.pi * (radius - cad.DEFLECTION_MM) ** 2 * height
    assert least < mesh.volume < exact
    assert mesh.report["boundary_edges"] == 0


def test_the_parts_of_an_assembly_stand_where_it_puts_them(tmp_path):
    mesh = load_mesh(
        written(tmp_path, step_files.assembly((5, 6, 7), [(0, 0, 0), (20, 0, 0), (0, 30, 10)]))
    )
    assert mesh.size_mm == pytest.approx([25, 36, 17], abs=1e-4)
    assert mesh.report["components"] == 3
    assert mesh.volume == pytest.approx(3 * 210, rel=1e-5)


def test_a_model_is_printed_the_same_every_time(tmp_path):
    path = written(tmp_path, step_files.cylinder(12, 30))
    prints = []
    for name in ("a.gcode", "b.gcode"):
        assert run("slice", path, "-o", tmp_path / name, "-q").exit_code == 0
        prints.append((tmp_path / name).read_bytes())
    assert prints[0] == prints[1]


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("", "no STEP that can be read"),
        ("solid a\nendsolid a\n", "no STEP that can be read"),
        (step_files.box((1, 2, 3))[:3000], "Incorrect syntax"),
        (step_files.Step().text(), "no STEP that can be read"),
    ],
)
def test_what_is_no_model_is_refused_by_name_with_a_way_out(text, words, tmp_path):
    path = written(tmp_path, text)
    done = run("info", path)
    assert done.exit_code == 3
    assert words in done.stderr
    assert done.stderr.startswith(f"wireprint: error: {path}: ")
    assert "export it as STL" in done.stderr


@pytest.mark.parametrize("seed", range(6))
def test_a_damaged_file_is_read_or_refused(seed, tmp_path):
    """Some of these end the kernel's process by a signal; none ends ours."""
    draw = random.Random(seed)
    lines = step_files.box((10, 20, 30)).splitlines()
    for _ in range(3):
        index = draw.randrange(8, len(lines) - 2)
        lines[index] = lines[draw.randrange(8, len(lines) - 2)].split("=")[-1]
        lines[index] = f"#{index - 6}={lines[index]}"
    path = written(tmp_path, "\n".join(lines))
    done = run("info", path)
    assert done.exit_code in (0, 3)
    assert done.exit_code == 0 or done.stderr.startswith(f"wireprint: error: {path}: ")


def test_a_kernel_that_does_not_end_or_breaks_down_is_told(tmp_path, monkeypatch):
    path = written(tmp_path, step_files.box((10, 20, 30)))
    monkeypatch.setattr(cad, "_PATIENCE_S", 0.5)
    for code, words in (
        ("import os, sys, time; os.kill(os.getpid(), 9)", "is not done after 2 s of work"),
        ("import os, signal; os.kill(os.getpid(), signal.SIGSEGV)", "fails over it"),
        ("raise MemoryError", "needs more memory than WIREPRINT_MEMORY allows"),
    ):
        monkeypatch.setattr(cad, "_FACETED", code)
        with pytest.raises(ModelError, match=words):
            load_mesh(path)


def test_without_the_kernel_the_extra_is_named(tmp_path):
    path = written(tmp_path, step_files.box((10, 20, 30)))
    code = (
        "import sys; sys.modules['cascadio'] = None\n"
        "from wireprint.cli import main\n"
        "sys.argv = ['wireprint', 'info', sys.argv[1]]\n"
        "main()"
    )
    done = subprocess.run(
        [sys.executable, "-c", code, str(path)], capture_output=True, text=True, env=os.environ
    )
    assert done.returncode == 4
    assert "pip install 'wireprint[step]'" in done.stderr
