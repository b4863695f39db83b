"""Every command that README and the documents give is run, on models that are made here.

A block of commands is run from top to bottom in a folder of its own, where each file that it reads
and does not write is put first. What waits for a person or a printer is read, not run.
"""

import re
import shlex
from itertools import pairwise
from pathlib import Path

import click
import numpy as np
import pytest
import trimesh
from click.testing import CliRunner

import printer_files
from layers_of_others import Layers
from wireprint import cli, examples
from wireprint.struts import Graph, struts_as

ROOT = Path(__file__).parents[1]
PAGES = ("README.md", *(f"docs/{page.name}" for page in sorted((ROOT / "docs").glob("*.md"))))
#: Commands that wait for a person or a printer.
WAITING = (["studio"], ["send"], ["profiles", "head", "--printer", "kossel-mini", "-o"])


def commands(page):
    """Blocks of a page, each a list of commands as words."""
    text = (ROOT / page).read_text(encoding="utf-8")
    for _, block in re.findall(r"^```(\w*)\n(.*?)^```", text, re.M | re.S):
        lines = [part for line in block.splitlines() for part in line.split(" && ")]
        lines = [line.removeprefix("$ ") for line in lines]
        found = [
            shlex.split(line, comments=True)[1:] for line in lines if line[:10] == "wireprint "
        ]
        if found:
            yield found


BLOCKS = [
    pytest.param(block, id=f"{page}:{' '.join(block[0])[:40]}")
    for page in PAGES
    for block in commands(page)
]


def turned(outline):
    return trimesh.creation.revolve(np.array(outline, float), sections=32)


def at_height(mesh, low):
    mesh.apply_translation((0, 0, low - mesh.bounds[0, 2]))
    return mesh


def tripod():
    turns = np.radians([0, 120, 240])
    feet = [[14 * np.cos(turn), 14 * np.sin(turn), 0] for turn in turns]
    edges = [[0, 3], [1, 3], [2, 3], [0, 1], [1, 2], [2, 0]]
    return Graph([*feet, [0, 0, 6]], edges)


def mushroom():
    stem, cap = trimesh.creation.box((10, 10, 12)), trimesh.creation.box((60, 30, 2))
    return trimesh.util.concatenate([at_height(stem, 0), at_height(cap, 12)])


def magnet():
    return at_height(trimesh.creation.cylinder(5, 4), 0).apply_translation((45, 0, 0))


def roof():
    layers = Layers()
    for number in range(60):
        layers.layer((number + 1) * 0.2)
        layers.block(-29, 0, 8, 12)
        layers.block(29, 0, 8, 12)
    return layers.plate(0, 0, 66, 12, 12.0, 12.6).text()


def mushroom_layers():
    layers = Layers().plate(0, 0, 10, 10, 0.0, 12.0)
    return layers.plate(0, 0, 60, 30, 12.0, 13.0).text()


#: Models by their names in the documents.
MODELS = {
    "bottle.stl": lambda: examples.stl("bottle"),
    "bunny.stl": lambda: trimesh.creation.icosphere(3, 16).export(file_type="stl"),
    "vase.stl": lambda: turned([(0, 0), (14, 0), (10, 60), (0, 60)]).export(file_type="stl"),
    "box.stl": lambda: at_height(trimesh.creation.box((40, 40, 30)), 0).export(file_type="stl"),
    "lid.stl": lambda: at_height(trimesh.creation.box((40, 40, 6)), 0).export(file_type="stl"),
    "cup.stl": lambda: turned([(0, 0), (9, 0), (11, 20), (0, 20)]).export(file_type="stl"),
    "wire.stl": lambda: mushroom().export(file_type="stl"),
    "cube.stl": lambda: examples.stl("cube"),
    "magnet.stl": lambda: magnet().export(file_type="stl"),
    "support.stl": lambda: at_height(trimesh.creation.box((36, 12, 11.9)), 0).export(
        file_type="stl"
    ),
    "top.stl": lambda: at_height(trimesh.creation.box((24, 24, 20)), 0).export(file_type="stl"),
    "mushroom.stl": lambda: mushroom().export(file_type="stl"),
    "table.gcode": roof,
    "base.gcode": lambda: Layers().plate(0, 0, 34, 34, 0.0, 10.0).text(),
    "mushroom.gcode": mushroom_layers,
    "lattice.obj": lambda: struts_as(tripod(), "obj", 0.35),
    "lattice.json": lambda: struts_as(tripod(), "json", 0.35),
    "printer.cfg": lambda: printer_files.DELTA.encode(),
}


def prepared(words, folder):
    """Put what a command reads, and nobody has written, into the folder."""
    outputs = {word for flag, word in pairwise(words) if flag[:1] == "-"}
    for word in words[1:]:
        path = folder / word
        if path.exists() or "/" in word or "." not in word or word[:1] == "-":
            continue
        if word in MODELS and words[words.index(word) - 1] != "-o":
            path.write_bytes(MODELS[word]())
        elif word.endswith(".gcode") and word not in outputs | {"-"}:
            made(word, folder)
    for flag in ("--onto", "--against"):
        if flag in words and not (folder / words[words.index(flag) + 1]).exists():
            made(words[words.index(flag) + 1], folder)


def made(name, folder):
    """Print the model of the same name, or all models for a table of results."""
    if name.endswith(".parquet"):
        run(["bench", "models", "--no-compare", "-o", name])
        return
    model = f"{Path(name).stem}.stl"
    (folder / model).write_bytes(MODELS[model]())
    run(["slice", model, "-o", name])


def models(folder):
    """Folders of models, and a list of some."""
    for place, name in (("models", "cube"), ("more/kind", "arch")):
        (folder / place).mkdir(parents=True, exist_ok=True)
        (folder / place / f"{name}.stl").write_bytes(examples.stl(name))
    (folder / "manifest.csv").write_text("name,scale\nmodels/cube.stl,0.8\n")


def run(words):
    told = CliRunner().invoke(cli.main, words)
    assert told.exit_code == 0, f"wireprint {' '.join(words)}\n{told.output}"
    return told.stdout


def cut(words, at):
    """Words before one, the one, and those behind it."""
    place = words.index(at) if at in words else len(words)
    return words[:place], words[place : place + 1], words[place + 1 :]


def is_told(words):
    """Whether every option of a command is there."""
    command = cli.main.get_command(None, words[0])
    if words[:2] == ["profiles", "head"]:
        command = command.get_command(click.Context(command), "head")
    known = {name for one in command.params for name in (*one.opts, *one.secondary_opts)}
    named = {word for word in words if re.match(r"--?[a-z]", word)}
    return named <= known | {"--help", "--version"}


@pytest.mark.parametrize("block", BLOCKS)
def test_commands_do_what_they_are_given_for(block, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    models(tmp_path)
    for words in block:
        if any(words[: len(waits)] == waits for waits in WAITING):
            assert is_told(words), words
            continue
        if "--scheduler" in words:
            # No cluster here: by this machine's own processes.
            at = words.index("--scheduler")
            words = words[:at] + words[at + 2 :]
        words, _, target = (list(part) for part in cut(words, ">"))
        prepared(words, tmp_path)
        told = run(words)
        if target:
            (tmp_path / target[0]).write_text(told)
