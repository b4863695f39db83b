"""Every model file of the shared faults gives what their README expects of it."""

import re

import pytest

from wireprint._core import ModelError
from wireprint.mesh import load_mesh

#: Tables of the README whose files are models that are misread, not odd shapes or G-code.
TABLES = ("Slicers' projects (3MF)", "OBJ, PLY, OFF, STL")
CUBE, TALL = (20, 20, 20), (30, 30, 30)

#: Files that all give the same, their suffix left out.
PARTS_LEFT_OUT = (
    "prusa_ParameterModifier prusa_SupportEnforcer prusa_SupportBlocker bambu_modifier_part "
    "bambu_support_enforcer bambu_support_blocker item_not_printable two_plates type_other "
    "type_support type_solidsupport backslash_names leading_slash"
)
CUBES = {
    "obj": "neg_mixed latin1 utf16 v_tab_only tabs indented hash_after_v bom cr",
    "ply": "lit_mixed lit_trail lit_edge edge_element latin1 tristrips multiline_ascii",
    "off": "latin1 bin",
    "stl": "ind_normal qnan_normal endloop_text no_endsolid ctrl_z bom bin_count0 bin_tail1 flip_7",
}
#: Name → extent, mm, and volume, mm³.
READ = {
    "prusa_NegativeVolume.3mf": ((30, 30, 15), 13_500),
    "bambu_negative_part.3mf": ((30, 30, 15), 13_500),
    "neg_two_objects.obj": ((50, 20, 40), 12_000),
    # The README says 60 cm² of surface; the U is 8 cm² twice, and its walls are 18 cm long.
    "concaveU_2.obj": ((40, 20, 30), 16_000),
    "penta.off": ((36.18, 38.04, 20), 19_021),
    "two_solids_noend.stl": ((50, 20, 20), 16_000),
}
READ |= {f"{name}.3mf": (TALL, 27_000) for name in PARTS_LEFT_OUT.split()}
READ |= {f"{name}.{kind}": (CUBE, 8_000) for kind in CUBES for name in CUBES[kind].split()}
#: Name → what the message says.
REFUSED = {
    "beams_and_mesh.3mf": "beam lattices",
    "beams_only.3mf": "beam lattices",
    "boolean_difference.3mf": "Boolean operations",
    "required_unknown.3mf": "volumetric data",
    "empty_build.3mf": "nothing is to be built",
    "packed.gcode.3mf": "a sliced plate: it holds G-code",
    "stored.gcode.3mf": "a sliced plate: it holds G-code",
}
#: Name → what a note, or a repair, says.
SAID = {
    "item_not_printable.3mf": "object that is not to be printed",
    "two_plates.3mf": "plate 1 alone is taken, of 2; --plate takes 2",
    "bin_count0.stl": "the count at byte 80 is 0",
    "bin_tail1.stl": "bytes after the last facet",
}


def test_every_model_of_the_tables_is_expected_here(shared):
    text = (shared / "faults" / "README.md").read_text(encoding="utf-8")
    named = set()
    for title in TABLES:
        table = text.split(f"## {title}\n")[1].split("\n## ")[0]
        for row in table.splitlines():
            if row.startswith("| "):
                named |= set(re.findall(r"[\w.]+\.(?:3mf|obj|ply|off|stl)", row.split("|")[1]))
    assert named == set(READ) | set(REFUSED)


@pytest.mark.parametrize("name", READ)
def test_a_model_is_read_as_the_readme_says(name, shared):
    size, volume = READ[name]
    mesh = load_mesh(shared / "faults" / name)
    assert mesh.size_mm == pytest.approx(size, abs=0.01)
    assert mesh.volume == pytest.approx(volume, rel=1e-4)
    assert mesh.report["boundary_edges"] == 0
    assert SAID.get(name, "") in "; ".join(mesh.notes)
    assert mesh.report["flipped_facets"] == (7 if name == "flip_7.stl" else 0)


@pytest.mark.parametrize("name", REFUSED)
def test_a_model_is_refused_as_the_readme_says(name, shared):
    with pytest.raises(ModelError, match=f"{re.escape(name)}: .*{REFUSED[name]}"):
        load_mesh(shared / "faults" / name)
