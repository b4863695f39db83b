"""A name means one thing in the core, but for words that formats and judges share."""

from pathlib import Path

import pytest

import rust_imports

CORE = Path(__file__).parents[1] / "rust" / "core" / "src"
#: The stages of the heart, and what lies below them.
HEART = ("geometry", "strand", "stroke", "clearance", "coil", "climb", "slices", "contours")
HEART += ("wireframe", "toolpath")


#: Words that formats of files share, with meanings of their own: each reader uses its format's.
FORMATS = {"Element", "Encoding", "Header", "Model", "Object", "Read", "Volume"}
#: What each judge calls its own: rules, limits, terms; strokes of lattices and of posts that hold.
JUDGES = {"Laid", "Limits", "Rules", "Scene", "Stroke", "Terms", "Triangle", "Way"}


def shared(root, modules):
    """Types of some modules whose name another file gives one of its own, with these files."""

    def is_in(file):
        return Path(file).parts[0].removesuffix(".rs") in modules

    return {
        name: files
        for name, files in rust_imports.types(root).items()
        if len(files) > 1 and any(map(is_in, files))
    }


def test_no_type_of_the_heart_has_the_name_of_another():
    assert shared(CORE, HEART) == {}


def test_other_types_share_names_only_where_formats_and_judges_have_the_same_word():
    common = {name for name, files in rust_imports.types(CORE).items() if len(files) > 1}
    assert common == FORMATS | JUDGES


@pytest.mark.parametrize("kind", ["struct Top;", "pub enum Top { A }", "type Top<T> = Vec<T>;"])
def test_a_type_that_is_defined_twice_is_found_wherever_it_is(tmp_path, kind):
    (tmp_path / "slices").mkdir()
    (tmp_path / "slices" / "one.rs").write_text("pub(super) struct Top(u8);\n#[cfg(test)]\nmod t;")
    (tmp_path / "toolpath.rs").write_text(f"/// struct Over;\n{kind}\nstruct Over {{ top: Top }}")
    (tmp_path / "gcode.rs").write_text("struct Out;\n#[cfg(test)]\nmod tests { struct Top; }")
    (tmp_path / "xml.rs").write_text("struct Out;\n#[cfg(test)]\npub mod scene;")
    (tmp_path / "xml").mkdir()
    (tmp_path / "xml" / "scene.rs").write_text("struct Over;")
    assert shared(tmp_path, HEART) == {"Top": ["slices/one.rs", "toolpath.rs"]}
    (tmp_path / "render.rs").write_text("struct Over;")
    assert shared(tmp_path, HEART).keys() == {"Top", "Over"}
