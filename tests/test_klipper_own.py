"""Klipper's own configurations, read by us and by Klipper's own parser, figure by figure.

WIREPRINT_KLIPPER names a checkout of Klipper; without one this is skipped.
"""

import importlib
import os
import sys
from pathlib import Path

import pytest

from wireprint.importing import imported

KLIPPER = os.environ.get("WIREPRINT_KLIPPER")
CONFIGS = sorted(Path(KLIPPER or "/nowhere", "config").glob("printer-*.cfg"))
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
    folder = str(Path(KLIPPER or "/nowhere", "klippy"))
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
