"""Three lattices as strut graphs, printed in an order that is found, certified and drawn.

Run: python examples/lattices.py [FOLDER]
"""

import math
import sys
from pathlib import Path

import numpy as np

from wireprint import Settings
from wireprint.struts import Graph, order, struts_as
from wireprint.view import render_png

#: A long needle of a nozzle, as lattices want it: 25 mm of it are free before the heater block.
NOZZLE = ("head.slant_deg=75", "head.cone_height_mm=25", "wire.free_end_limit_mm=24")


def grid(cells: int, pitch: float) -> Graph:
    """Return a cube of cells; two of its walls have diagonals."""
    count = cells + 1
    places = np.array(list(np.ndindex(count, count, count)), float) * pitch
    numbers = np.arange(count**3).reshape(count, count, count)
    edges = [np.stack([numbers[:-1], numbers[1:]], -1)]
    edges += [np.stack([numbers[:, :-1], numbers[:, 1:]], -1)]
    edges += [np.stack([numbers[:, :, :-1], numbers[:, :, 1:]], -1)]
    edges += [np.stack([numbers[:-1, :, :-1], numbers[1:, :, 1:]], -1)[:, ::cells]]
    return Graph(places, np.concatenate([part.reshape(-1, 2) for part in edges]))


def tower(height: float, rings: int, around: int) -> Graph:
    """Return a hyperboloid of two families of straight lines, with rings: a diagrid tower."""
    z = np.linspace(0, height, rings)
    radius = 18 * np.sqrt(1 + ((z - 0.6 * height) / (0.7 * height)) ** 2)
    nodes = []
    for level, (r, h) in enumerate(zip(radius, z, strict=True)):
        for step in range(around):
            turn = 2 * math.pi * (step + level / 2) / around
            nodes.append((r * math.cos(turn), r * math.sin(turn), h))
    edges = []
    for level in range(rings):
        here = level * around
        for step in range(around):
            edges.append((here + step, here + (step + 1) % around))
            if level + 1 < rings:
                edges.append((here + step, here + around + step))
                edges.append((here + step, here + around + (step - 1) % around))
    return Graph(np.array(nodes), np.array(edges))


def dome(radius: float, rings: int, around: int) -> Graph:
    """Return a ribbed dome: rings of triangles that close at the crown."""
    nodes, edges = [], []
    for level in range(rings):
        rise = 0.5 * math.pi * level / rings
        for step in range(around):
            turn = 2 * math.pi * (step + level / 2) / around
            flat = radius * math.cos(rise)
            nodes.append((flat * math.cos(turn), flat * math.sin(turn), radius * math.sin(rise)))
    crown = len(nodes)
    nodes.append((0.0, 0.0, radius))
    for level in range(rings):
        here = level * around
        for step in range(around):
            edges.append((here + step, here + (step + 1) % around))
            if level + 1 < rings:
                edges.append((here + step, here + around + step))
                edges.append((here + step, here + around + (step - 1) % around))
            else:
                edges.append((here + step, crown))
    return Graph(np.array(nodes), np.array(edges))


def main(folder: Path) -> None:
    """Print each, and tell how long it takes."""
    folder.mkdir(parents=True, exist_ok=True)
    settings = Settings.load("kossel-mini", "abs", overrides=NOZZLE)
    lattices = {
        "grid": grid(3, 12.0),
        "tower": tower(60.0, 6, 12),
        "dome": dome(36.0, 4, 14),
    }
    for name, graph in lattices.items():
        ordered = order(graph, settings)
        (folder / f"{name}.gcode").write_bytes(ordered.gcode)
        (folder / f"{name}.png").write_bytes(render_png(ordered.certificate, title=name))
        (folder / f"{name}.json").write_bytes(struts_as(ordered.graph, "json", 0.35))
        print(
            f"{name}: {len(ordered.graph)} struts, {int(ordered.floating.sum())} to a free end, "
            f"{ordered.print_time_s / 60:.0f} min, certified: {ordered.certificate.ok}"
        )


if __name__ == "__main__":
    main(Path(sys.argv[1] if len(sys.argv) > 1 else "."))
