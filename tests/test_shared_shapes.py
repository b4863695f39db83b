"""Every shape of the shared faults is printed whole and certified, on printers that people own."""

import re

import pytest

from wireprint import load_mesh, make
from wireprint.settings import Settings

MACHINES = [
    ("kossel-mini", "abs"),
    ("prusa-mk4s", "pla"),
    ("voron-2.4", "abs"),
    ("printrbot-simple", "pla"),
]
#: Name → height, mm.
SHAPES = {
    "pin_60_10.stl": 30,
    "flange.stl": 50,
    "step_pyramid.stl": 30,
    "pocket_plate.stl": None,
    "ledge_30_40.stl": None,
    "U60.stl": None,
    "stairs.stl": None,
    "base_t1.stl": None,
    "perforated_floor.stl": None,
    "stack_flush.stl": None,
    "side_flush.stl": None,
    "inner_body.stl": None,
}


def test_every_shape_of_the_table_is_expected_here(shared):
    text = (shared / "faults" / "README.md").read_text(encoding="utf-8")
    table = text.split("## Shapes\n")[1].split("\n## ")[0]
    rows = [row.split("|")[1] for row in table.splitlines() if row.startswith("| ")]
    assert {name for row in rows for name in re.findall(r"[\w.]+\.stl", row)} == set(SHAPES)


@pytest.mark.parametrize("machine", MACHINES, ids=lambda machine: machine[0])
@pytest.mark.parametrize("name", SHAPES)
def test_a_shape_is_printed_whole(name, machine, shared):
    settings = Settings.load(*machine, overrides=["gcode.thumbnails=[]"])
    mesh = load_mesh(shared / "faults" / name)
    if mesh.size_mm[0] > min(settings.printer.bed.size_mm):
        pytest.skip(f"{name} is larger than the bed of {machine[0]}")
    made = make(mesh, settings)
    figures = made.figures()
    assert figures["certified"], figures["breaches"]
    assert figures["coverage"] > 0.9995
    assert figures["unprinted"] == []
    height = SHAPES[name]
    if height is not None:
        top = made.wireframe.strands[..., 2].max()
        assert top == pytest.approx(height, abs=settings.printer.head.nozzle_mm)
