"""README and ARCHITECTURE tell what there is."""

import json
import re
from pathlib import Path

import pytest
from click.testing import CliRunner

import wireprint
from wireprint import budget, cli, examples, regions, struts

ROOT = Path(__file__).parents[1]
README = (ROOT / "README.md").read_text(encoding="utf-8")


def section(title):
    """Text under a heading, up to the next one."""
    return re.search(rf"^#+ {re.escape(title)}$(.*?)(?=^#+ |\Z)", README, re.M | re.S)[1]


def names_in_first_column(text):
    rows = re.findall(r"^\| (`.+?`) \|", text, re.M)
    return {name for row in rows for name in re.findall(r"`([\w-]+)`", row)}


def test_readme_opens_with_a_picture_that_is_there():
    picture = re.match(r"# wireprint\n\n!\[.+?\]\((.+?)\)", README)
    assert (ROOT / picture[1]).is_file()


def test_the_two_commands_are_given_as_they_are():
    assert (
        "pip install . && wireprint example bottle && "
        "wireprint slice bottle.stl -o bottle.gcode\n" in README
    )
    assert "pip install '.[test]' && pytest\n" in README


def test_every_command_is_listed():
    assert set(re.findall(r"^\| `wireprint (\w+)", README, re.M)) == set(cli.COMMANDS)


def test_every_example_is_named():
    row = re.search(r"^\| `wireprint example NAME` \|(.*)\|$", README, re.M)[1]
    assert re.findall(r"`(\w+)`", row) == examples.names()


def test_every_key_of_json_is_described_and_no_other(tmp_path):
    model = tmp_path / "cube.stl"
    model.write_bytes(examples.stl("cube"))
    arguments = ["slice", str(model), "-o", str(tmp_path / "cube.gcode"), "--json"]
    found = json.loads(CliRunner().invoke(cli.main, arguments).stdout)
    assert names_in_first_column(section("What `--json` tells")) == set(found)


def test_every_option_of_slice_is_listed():
    parameters = cli.main.get_command(None, "slice").params
    options = {name for one in parameters for name in one.opts if name.startswith("--")}
    described = set(re.findall(r"--[\w-]+", section("Options of `slice`")))
    assert options - {"--output"} <= described


@pytest.mark.parametrize("name", ["README.md", "ARCHITECTURE.md"])
def test_links_lead_somewhere(name):
    text = (ROOT / name).read_text(encoding="utf-8")
    for target in re.findall(r"\]\((?!https?:)([^)#]+)", text):
        assert (ROOT / target).exists(), target


def test_every_public_name_is_on_the_page_of_the_library():
    page = (ROOT / "docs/api.md").read_text(encoding="utf-8")
    offered = {*wireprint.__all__, *regions.__all__, *budget.__all__, *struts.__all__}
    offered -= {"__version__", "READ", "WRITTEN"}
    assert not {name for name in offered if not re.search(rf"\b{name}\b", page)}


def test_every_module_of_the_core_is_in_the_module_graph():
    text = (ROOT / "ARCHITECTURE.md").read_text(encoding="utf-8")
    source = (ROOT / "rust/core/src/lib.rs").read_text(encoding="utf-8")
    for module in re.findall(r"^pub mod (\w+);", source, re.M):
        assert re.search(rf"`{module}(::|`)", text), module


def test_every_module_of_the_package_is_in_the_module_table():
    text = (ROOT / "ARCHITECTURE.md").read_text(encoding="utf-8")
    for path in sorted((ROOT / "python/wireprint").rglob("*.py")):
        parts = path.relative_to(ROOT / "python/wireprint").with_suffix("").parts
        if parts[-1] == "__init__":
            continue
        dotted = ".".join(parts)
        assert f"`{dotted}`" in text or f"`{parts[0]}.*`" in text, dotted


def core_file(name):
    """A file of the core, as docs/walk.md names it; None where there is none."""
    roots = [ROOT, ROOT / "rust/core", ROOT / "rust/core/src", ROOT / "rust/core/src/wireframe"]
    return next((root / name for root in roots if (root / name).exists()), None)


def test_the_walk_names_functions_where_they_are():
    text = (ROOT / "docs/walk.md").read_text(encoding="utf-8")
    for name in re.findall(r"`([\w/]+(?:\.rs|/\w+))`", text):
        assert core_file(name), name
    for name, function in re.findall(r"`([\w/]+\.rs)`\)?,\s+`([\w:]+)`", text):
        source = core_file(name).read_text(encoding="utf-8")
        assert f"fn {function.rpartition(':')[2]}" in source, (name, function)
    sources = sorted((ROOT / "rust/core/src").rglob("*.rs"))
    core = "\n".join(source.read_text(encoding="utf-8") for source in sources)
    for name in re.findall(r"`([a-z]+(?:_[a-z]+)*)`", text):
        assert re.search(rf"\b(fn|mod) {name}\b", core), name
