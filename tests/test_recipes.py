"""The recipes under "How to add …" in ARCHITECTURE: each is followed, in a copy of the package."""

import json
import os
import re
import shutil
import subprocess
import sys
from pathlib import Path
from typing import get_args

import pytest

import wireprint
from wireprint import choices

ROOT = Path(__file__).parents[1]
PACKAGE = Path(wireprint.__file__).parent
CORE = ROOT / "rust/core/src"
RECIPES = (ROOT / "ARCHITECTURE.md").read_text(encoding="utf-8").partition("## How to add …")[2]

PRINTER = """\
# One printer more, as its owner would write it.

inherits = "ender-3"
name = "workbench"

[bed]
width_mm = 140              # measured
"""
MATERIAL = """\
inherits = "pla"
name = "beeswax"
nozzle_c = 195              # tried
"""
FLAVOR = """\
    "smoothie": Flavor(
        valve_on="M400\\nM42 P{pin} S1\\n",
        valve_off="M400\\nM42 P{pin} S0\\n",
        valve_halts=True,
        progress="M73 P{percent} ; of {minutes} min left\\n",
    ),
"""
SHAPE = '''

class Cylinder(Shape):
    """An upright cylinder without ends."""

    noun = "cylinder"
    kind: Literal["cylinder"] = "cylinder"
    middle_mm: Point
    radius_mm: Length

    def _covered(self, points: Floats, normals: Floats) -> Flags:
        beside: Floats = np.hypot(*(points[:, :2] - self.middle_mm[:2]).T)
        return beside <= self.radius_mm
'''
GRAMMAR = """\
    "cylinder": (
        "cylinder:X,Y,RADIUS",
        3,
        lambda n: Cylinder(middle_mm=_point([*n[:2], 0.0]), radius_mm=n[2]),
    ),
"""
SETTING = """\
    lean_limit_mm: float = Field(0.5, ge=0.0, le=10.0, description="as CONTRIBUTING has it")
"""


def put(path, *changes):
    """Put something into a file, before or behind what stands there once."""
    text = path.read_text(encoding="utf-8")
    for known, changed in changes:
        assert text.count(known) == 1, (path.name, known)
        text = text.replace(known, changed)
    path.write_text(text, encoding="utf-8")


@pytest.fixture(scope="module")
def copy(tmp_path_factory):
    """Copy the package and add one of everything that takes no build; the folder around it."""
    folder = tmp_path_factory.mktemp("copy")
    package = folder / "wireprint"
    skipped = shutil.ignore_patterns("__pycache__", "_core.abi3.so")
    shutil.copytree(PACKAGE, package, ignore=skipped)
    for extension in PACKAGE.glob("_core*.so"):
        (package / extension.name).symlink_to(extension)
    (package / "profiles/printers/workbench.toml").write_text(PRINTER, encoding="utf-8")
    (package / "profiles/materials/beeswax.toml").write_text(MATERIAL, encoding="utf-8")
    put(package / "choices.py", ('"klipper",', '"klipper", "smoothie",'))
    put(
        package / "gcode/flavors.py",
        ('    "klipper": Flavor(\n', f'{FLAVOR}    "klipper": Flavor(\n'),
    )
    with (package / "regions/shapes.py").open("a", encoding="utf-8") as shapes:
        shapes.write(SHAPE)
    put(
        package / "regions/document.py",
        ("import Box, HalfSpace", "import Box, Cylinder, HalfSpace"),
        ("Annotated[Box |", "Annotated[Box | Cylinder |"),
    )
    put(
        package / "regions/grammar.py",
        ("import Box, HalfSpace", "import Box, Cylinder, HalfSpace"),
        ('    "half": (\n', f'{GRAMMAR}    "half": (\n'),
    )
    put(
        package / "settings/wire.py",
        (
            'follows from the printer."""\n\n    slab_min',
            f'follows from the printer."""\n\n{SETTING}    slab_min',
        ),
    )
    return folder


def run(folder, *arguments):
    """Run the copy's Python."""
    environment = os.environ | {"PYTHONPATH": str(folder), "XDG_CACHE_HOME": str(folder / "cache")}
    command = [sys.executable, *map(str, arguments)]
    return subprocess.run(
        command, cwd=folder, env=environment, capture_output=True, text=True, check=False
    )


def sliced(folder, *options):
    """Print a cube with the copy; what it tells, and the file."""
    target = folder / "cube.gcode"
    target.unlink(missing_ok=True)
    made = run(folder, "-m", "wireprint", "example", "cube", "-o", folder / "cube.stl")
    assert made.returncode == 0 or "exists" in made.stderr, made.stderr
    options = ["cube.stl", "-o", target, "--json", *options]
    done = run(folder, "-m", "wireprint", "slice", *options)
    assert done.returncode == 0, done.stderr
    return json.loads(done.stdout), target.read_text(encoding="utf-8")


def test_a_printer_and_a_material_are_a_file_each(copy):
    told, gcode = sliced(copy, "--printer", "workbench", "--material", "beeswax")
    assert told["certified"]
    assert '; printer.name = "workbench"' in gcode
    assert "; printer.bed.width_mm = 140" in gcode
    assert "S195" in gcode, "the new material's temperature"
    listed = run(copy, "-m", "wireprint", "profiles").stdout
    assert "workbench" in listed
    assert "beeswax" in listed


def test_a_flavour_is_an_entry_and_its_name(copy):
    told, gcode = sliced(copy, "--printer", "ender-3", "--flavor", "smoothie")
    assert told["certified"]
    assert '; printer.gcode.flavor = "smoothie"' in gcode
    assert re.search(r"^M73 P\d+ ; of \d+ min left$", gcode, re.MULTILINE)
    offered = run(copy, "-m", "wireprint", "slice", "--help").stdout
    assert "smoothie" in offered


def test_a_shape_is_a_class_its_place_and_its_word(copy):
    program = """
import numpy as np
from wireprint.regions.document import from_json, to_json
from wireprint.regions.grammar import parse
from wireprint.regions.region import Region

region = Region((parse("cylinder:1,2,5"),))
points = np.array([[1.0, 2.0, 9.0], [6.0, 2.0, 0.0], [6.1, 2.0, 0.0]])
again = from_json(to_json(region), "marks")
for one in (region, again):
    assert one.covers(points, np.zeros_like(points)).tolist() == [True, True, False]
print(type(again.marks[0].shape).noun)
"""
    done = run(copy, "-c", program)
    assert (done.returncode, done.stdout.strip()) == (0, "cylinder"), done.stderr


def test_a_setting_is_a_field(copy):
    _, gcode = sliced(copy, "--set", "wire.lean_limit_mm=2")
    assert "; wire.lean_limit_mm = 2" in gcode
    options = ["cube.stl", "-o", "none.gcode", "--set", "wire.lean_limit_mm=11"]
    refused = run(copy, "-m", "wireprint", "slice", *options)
    assert refused.returncode != 0
    assert "wire.lean_limit_mm" in refused.stderr


def variants(enum, path):
    """Names of an enum's variants in the core."""
    body = re.search(
        rf"pub enum {enum} \{{(.*?)^\}}", path.read_text(encoding="utf-8"), re.M | re.S
    )
    return re.findall(r"^    (\w+)\b.*,$", body[1], re.M)


def test_patterns_are_the_same_here_and_in_the_core():
    names = {name.lower() for name in variants("Pattern", CORE / "wireframe/params.rs")}
    assert names == set(get_args(choices.Pattern))


def test_every_bound_has_its_row_its_name_and_its_unit():
    rows = (CORE / "check/bounds.rs").read_text(encoding="utf-8")
    binding = (ROOT / "rust/py/src/check.rs").read_text(encoding="utf-8")
    verdict = (PACKAGE / "verdict.py").read_text(encoding="utf-8")
    for variant in variants("Bound", CORE / "check/verdict.rs"):
        assert f"Bound::{variant}," in rows
        name = re.search(rf'::{variant} => "(\w+)"', binding)[1]
        assert f'"{name}"' in verdict


@pytest.mark.parametrize("span", sorted(set(re.findall(r"`([^`]+)`", RECIPES))))
def test_what_the_recipes_name_is_there(span):
    if re.fullmatch(r"[\w/.]+(/|\.(py|pyi|rs|md))[\w/.]*", span):
        places = (ROOT, PACKAGE, CORE, PACKAGE / "regions")
        assert any((place / span).exists() for place in places), span
        return
    sources = [*PACKAGE.rglob("*.py"), *CORE.rglob("*.rs"), *(ROOT / "rust/py/src").rglob("*.rs")]
    text = "\n".join(path.read_text(encoding="utf-8") for path in sources)
    modules = {path.stem for path in sources} | {path.parent.name for path in sources}
    for name in re.findall(r"[A-Za-z_]{3,}", span):
        assert name in modules or re.search(rf"\b{name}\b", text) or name == "NAME", span
