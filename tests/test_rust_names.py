"""A name means one thing in the heart of the core, through which every print goes."""

from pathlib import Path

import pytest

import rust_imports

CORE = Path(__file__).parents[1] / "rust" / "core" / "src"
#: The stages of the heart, and what lies below them.
HEART = ("geometry", "strand", "stroke", "clearance", "coil", "climb", "slices", "contours")
HEART += ("wireframe", "toolpath")


def shared(root, modules):
    """Types that more than one file of some modules defines, with these files."""
    own = {
        name: [file for file in files if Path(file).parts[0].removesuffix(".rs") in modules]
        for name, files in rust_imports.types(root).items()
    }
    return {name: files for name, files in own.items() if len(files) > 1}


def test_no_type_of_the_heart_has_the_name_of_another():
    assert shared(CORE, HEART) == {}


@pytest.mark.parametrize("kind", ["struct Top;", "pub enum Top { A }", "type Top<T> = Vec<T>;"])
def test_a_type_that_is_defined_twice_is_found_wherever_it_is(tmp_path, kind):
    (tmp_path / "slices").mkdir()
    (tmp_path / "slices" / "one.rs").write_text("pub(super) struct Top(u8);\n#[cfg(test)]\nmod t;")
    (tmp_path / "toolpath.rs").write_text(f"/// struct Over;\n{kind}\nstruct Over {{ top: Top }}")
    (tmp_path / "gcode.rs").write_text("struct Over;\n#[cfg(test)]\nmod tests { struct Top; }")
    assert shared(tmp_path, HEART) == {"Top": ["slices/one.rs", "toolpath.rs"]}
