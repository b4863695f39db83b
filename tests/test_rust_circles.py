"""No file of the Rust core imports, through others, itself."""

from pathlib import Path

import networkx
import pytest

import rust_imports

CORE = Path(__file__).parents[1] / "rust" / "core" / "src"


def circles(edges):
    """Members that import each other, directly or through others."""
    found = networkx.strongly_connected_components(networkx.DiGraph(edges))
    return sorted(sorted(members) for members in found if len(members) > 1)


@pytest.fixture(scope="module")
def core():
    """The imports between the core's files."""
    return rust_imports.imports(CORE)


def test_the_core_has_no_circle(core):
    assert circles(core) == []


def test_the_core_stages_import_each_other_in_one_direction(core):
    stages = [[Path(file).parts[0].removesuffix(".rs") for file in edge] for edge in core]
    assert circles((one, other) for one, other in stages if one != other) == []


@pytest.fixture
def crate(tmp_path):
    """Write a crate of the files given."""

    def write(**files):
        for name, text in files.items():
            path = tmp_path / (name.replace("__", "/") + ".rs")
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(text)
        return tmp_path

    return write


def test_a_circle_through_a_third_file_is_found(crate):
    root = crate(
        lib="mod a; mod b; mod c;",
        a="use crate::b::B;\npub struct A;",
        b="use crate::c::{self, C};\npub struct B;",
        c="pub struct C;\nfn f() { crate::a::A; }",
    )
    assert circles(rust_imports.imports(root)) == [["a.rs", "b.rs", "c.rs"]]


@pytest.mark.parametrize(
    "use",
    [
        "use super::two::Two;",
        "use super::{two::{Two, other}};",
        "use super::Two;",
        "use super::*;",
        "use crate::m::two as second;\nfn g() { second::Two; }",
    ],
)
def test_a_name_comes_from_the_file_that_defines_it(crate, use):
    root = crate(
        lib="mod m;",
        m__mod="mod one; mod two;\npub use two::Two;\npub use one::One;",
        m__one=f"{use}\npub struct One {{ two: Two }}",
        m__two="pub struct Two;\npub fn other() {}",
    )
    assert rust_imports.imports(root) == [("m/one.rs", "m/two.rs")]


def test_a_parent_that_uses_what_its_child_takes_from_it_is_a_circle(crate):
    root = crate(
        lib="mod m;",
        m__mod="mod one;\nuse one::One;\npub struct Whole { one: One }",
        m__one="use super::Whole;\npub struct One;\nfn f(_: Whole) {}",
    )
    assert circles(rust_imports.imports(root)) == [["m/mod.rs", "m/one.rs"]]


def test_tests_comments_and_strings_import_nothing(crate):
    root = crate(
        lib="mod a; mod b;",
        a="pub struct A;\n#[cfg(test)]\nmod tests {\n use crate::b::B; fn f() { {} }\n}",
        b='use crate::a::A;\npub struct B;\n// crate::a::A\nconst T: &str = "use crate::b::B;";',
    )
    assert rust_imports.imports(root) == [("b.rs", "a.rs")]
