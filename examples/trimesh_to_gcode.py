"""A mesh made in memory becomes a certified file: a funnel, revolved by trimesh."""

import numpy as np
import trimesh

import wireprint

# Radius and height, mm, up the outside and down the inside again.
profile = np.array([[8, 0], [9, 25], [30, 60], [28.5, 60], [7.5, 25], [6.5, 0], [8, 0]])
funnel = trimesh.creation.revolve(profile, sections=96)

mesh = wireprint.Mesh.from_arrays(funnel.vertices, funnel.faces)
settings = wireprint.Settings.load(printer="prusa-mk4s", material="pla")
printed = wireprint.make(mesh, settings)
figures = printed.figures()

assert figures["certified"], figures["breaches"]
with open("funnel.gcode", "wb") as file:
    file.write(printed.gcode)
print(
    f"funnel.gcode: {figures['print_time_s'] / 60:.0f} min, {figures['filament_g']:.1f} g, "
    f"{figures['coverage']:.1%} of the surface covered"
)
