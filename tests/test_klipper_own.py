"""Klipper itself: its configurations read by us and by it, and our files carried out by it.

Both are skipped without a checkout, see `klipper_batch`.
"""

import importlib
import sys

import pytest

import klipper_batch
import wireprint
from wireprint import catalogue, examples
from wireprint.importing import imported

CONFIGS = sorted((klipper_batch.CHECKOUT / "config").glob("printer-*.cfg"))
#: Section and key of Klipper, and where the figure is in a profile.
FIGURES = {
    ("printer", "max_velocity"): ("motion", "max_velocity"),
    ("printer", "max_accel"): ("motion", "max_accel"),
    ("printer", "max_z_velocity"): ("motion", "max_z_velocity"),
    ("printer", "max_z_accel"): ("motion", "max_z_accel"),
    ("printer", "square_corner_velocity"): ("motion", "square_corner_velocity"),
    ("printer", "delta_radius"): ("motion", "delta_radius"),
    ("extruder", "nozzle_diameter"): ("head", "nozzle_mm"),
    ("extruder", "filament_diameter"): ("extruder", "filament_diameter_mm"),
}


@pytest.fixture(scope="module")
def parser():
    """Klipper's reader of configurations."""
    folder = str(klipper_batch.CHECKOUT / "klippy")
    sys.path.insert(0, folder)
    try:
        yield importlib.import_module("configfile").ConfigFileReader()
    finally:
        sys.path.remove(folder)


@pytest.mark.skipif(not CONFIGS, reason="WIREPRINT_KLIPPER names no checkout of Klipper")
@pytest.mark.parametrize("path", CONFIGS, ids=lambda path: path.stem)
def test_figures_are_those_that_klipper_reads(parser, path):
    own = parser.build_fileconfig(path.read_text(encoding="utf-8"), str(path))
    found = imported([path], hotend="v6").values
    told = 0
    for (section, key), (table, name) in FIGURES.items():
        if own.has_section(section) and own.has_option(section, key):
            told += 1
            assert found[table][name] == pytest.approx(float(own.get(section, key))), key
    assert told >= 4


@pytest.mark.skipif(not klipper_batch.ready(), reason="no built Klipper")
@pytest.mark.parametrize("name", catalogue.names("printers"))
@pytest.mark.parametrize("model", ["cube", "bottle"])
def test_klipper_carries_out_what_is_written_for_its_printers(name, model, tmp_path):
    settings = wireprint.Settings.load(name, "pla")
    if settings.printer.gcode.flavor != "klipper":
        pytest.skip("not Klipper's")
    (tmp_path / "model.stl").write_bytes(examples.stl(model))
    mesh = wireprint.load_mesh(tmp_path / "model.stl", height_mm=28)
    made = wireprint.make(mesh, settings, compare=False)
    assert klipper_batch.complaints(settings.printer, made.gcode, tmp_path) == []
