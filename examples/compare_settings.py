"""Time, filament and fidelity over slab heights and printers."""

from pathlib import Path

import wireprint
from wireprint import examples

Path("torus.stl").write_bytes(examples.stl("torus"))
mesh = wireprint.load_mesh("torus.stl")

print(f"{'printer':>16} {'slab mm':>8} {'min':>6} {'g':>6} {'off mm':>7}")
for printer, material in (("kossel-mini", "abs"), ("prusa-mk4s", "pla")):
    for slab_mm in (2.0, 3.0, 4.0):
        options = [f"wire.slab_max_mm={slab_mm}"]
        settings = wireprint.Settings.load(printer, material, overrides=options)
        figures = wireprint.make(mesh, settings, partial=True).figures()
        print(
            f"{printer:>16} {slab_mm:8.1f} {figures['print_time_s'] / 60:6.1f} "
            f"{figures['filament_g']:6.2f} {figures['deviation_mm']:7.3f}"
        )
