"""What the library offers is documented as numpydoc asks: every parameter, every result.

Fields of dataclasses and of settings are documented where they stand, by ``#:`` or a description.
"""

import dataclasses
import inspect
import re

import pytest
from numpydoc.validate import validate
from pydantic import BaseModel

import wireprint
from wireprint import (
    budget,
    inputs,
    keys,
    regions,
    settings,
    splicing,
    standing,
    stopped,
    struts,
    view,
)

#: What must not be said of any public name: undocumented parameters (PR01), parameters that are
#: none (PR02), results that are not told (RT01), no text at all (GL08), no summary (SS01).
REFUSED = {"PR01", "PR02", "RT01", "GL08", "SS01"}
#: Modules of the library besides the package's own names, with what they offer.
MODULES = {
    inputs: ("as_mesh", "as_model"),
    keys: ("Key",),
    regions: tuple(regions.__all__),
    settings: ("describe",),
    budget: tuple(budget.__all__),
    splicing: ("splice", "Spliced"),
    standing: ("Standing", "read_prints"),
    stopped: ("Stopped",),
    struts: ("Graph", "OrderedGraph", "order", "read_struts", "struts_as"),
    view: ("load", "render_png", "render_html", "strands_in", "strands_of", "thumbnails"),
}

#: Fields whose names and types say all there is.
TELL_THEMSELVES = {
    "settings",
    "wireframe",
    "toolpath",
    "estimate",
    "mesh",
    "shape",
    "chosen",
    "print_time_s",
    "made",
    "budget",
    "marks",
    "kind",
    "erase",
}


def public():
    """Dotted name of everything that a user of the library calls."""
    found = {}
    names = [(wireprint, name) for name in wireprint.__all__]
    names += [(module, name) for module, offered in MODULES.items() for name in offered]
    for module, name in names:
        one = getattr(module, name)
        if not callable(one) and not inspect.isclass(one):
            continue
        home = f"{one.__module__}.{one.__qualname__}" if hasattr(one, "__qualname__") else None
        if home is None or not home.startswith("wireprint"):
            continue
        found[home.replace("wireprint.WireprintError", "wireprint._core.WireprintError")] = one
        if inspect.isclass(one) and not issubclass(one, Exception):
            for member in vars(one):
                if not member.startswith("_") and callable(getattr(one, member)):
                    found[f"{home}.{member}"] = getattr(one, member)
    return {name: one for name, one in found.items() if not is_error(one)}


def is_error(one):
    return inspect.isclass(one) and issubclass(one, Exception)


def has_fields(one):
    return dataclasses.is_dataclass(one) or (inspect.isclass(one) and issubclass(one, BaseModel))


@pytest.mark.parametrize("name", sorted(public()))
def test_it_is_documented(name):
    refused = REFUSED - {"PR01"} if has_fields(public()[name]) else REFUSED
    errors = [f"{code} {text}" for code, text in validate(name)["errors"] if code in refused]
    assert not errors


@pytest.mark.parametrize("name", [name for name, one in public().items() if has_fields(one)])
def test_each_field_is_documented(name):
    one = public()[name]
    if not dataclasses.is_dataclass(one):
        # Settings hold tables, which have docstrings; other models' fields have descriptions.
        return
    lines = inspect.getsource(one).splitlines()
    for number, line in enumerate(lines):
        found = re.match(r"    (\w+): ", line)
        if found and found[1] in {field.name for field in dataclasses.fields(one)}:
            told = lines[number - 1].strip().startswith("#:") or found[1] in TELL_THEMSELVES
            assert told, f"{name}.{found[1]}"


def test_there_is_something_to_document():
    assert len(public()) > 60
