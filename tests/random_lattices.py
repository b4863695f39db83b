"""Lattices by rules and chance: towers, domes, space frames, bridges, trees."""

import math

import numpy as np

from wireprint.struts import Graph


def tower(rng):
    """A mast of three to six legs that lean in, braced from ring to ring."""
    sides, storeys = rng.integers(3, 7), rng.integers(2, 6)
    radius, rise, lean = rng.uniform(9, 15), rng.uniform(7, 11), rng.uniform(0.82, 1.0)
    twist = rng.uniform(-0.3, 0.3)
    nodes, edges = [], []
    for storey in range(storeys + 1):
        flat = radius * lean**storey
        for side in range(sides):
            turn = 2 * math.pi * side / sides + twist * storey
            nodes.append([flat * math.cos(turn), flat * math.sin(turn), rise * storey])
            here, beside = storey * sides + side, storey * sides + (side + 1) % sides
            edges.append([here, beside])
            if storey:
                edges.append([here - sides, here])
                edges.append([here - sides, beside] if side % 2 else [beside - sides, here])
    return Graph(nodes, edges)


def dome(rng):
    """A cap of triangles with an opening in its crown."""
    rings, steep = rng.integers(3, 6), rng.uniform(0.7, 1.2)
    # Struts as long as may hang, at most.
    radius = rng.uniform(8, 11) * (rings - 1) / steep
    around = math.ceil(2 * math.pi * radius / rng.uniform(13, 17))
    nodes, edges = [], []
    for ring in range(rings):
        rise = steep * ring / (rings - 1)
        for side in range(around):
            turn = 2 * math.pi * (side + ring / 2) / around
            flat = radius * math.cos(rise)
            nodes.append([flat * math.cos(turn), flat * math.sin(turn), radius * math.sin(rise)])
            here = ring * around + side
            edges.append([here, ring * around + (side + 1) % around])
            if ring:
                edges.append([here - around, here])
                edges.append([(ring - 1) * around + (side + 1) % around, here])
    return Graph(nodes, edges)


def space_frame(rng):
    """A double layer of squares: the upper ones stand on the middles of the lower ones."""
    columns, rows = rng.integers(2, 5, 2)
    pitch, height = rng.uniform(11, 15), rng.uniform(5, 8)
    lower = [[pitch * x, pitch * y, 0] for x in range(columns + 1) for y in range(rows + 1)]
    middles = [(x, y) for x in range(columns) for y in range(rows)]
    upper = [[pitch * (x + 0.5), pitch * (y + 0.5), height] for x, y in middles]

    def low(x, y):
        return x * (rows + 1) + y

    def high(x, y):
        return len(lower) + x * rows + y

    edges = []
    for x in range(columns + 1):
        for y in range(rows + 1):
            if x < columns:
                edges.append([low(x, y), low(x + 1, y)])
            if y < rows:
                edges.append([low(x, y), low(x, y + 1)])
            if x < columns and y < rows:
                edges += [[low(x + i, y + j), high(x, y)] for i in (0, 1) for j in (0, 1)]
                if x + 1 < columns:
                    edges.append([high(x, y), high(x + 1, y)])
                if y + 1 < rows:
                    edges.append([high(x, y), high(x, y + 1)])
    return Graph(lower + upper, edges)


def bridge(rng):
    """Two trusses side by side on the bed, their upper chords joined."""
    bays = rng.integers(3, 7)
    bay, height, width = rng.uniform(9, 13), rng.uniform(6, 10), rng.uniform(9, 14)
    nodes, edges = [], []
    for x in range(bays + 1):
        nodes += [[bay * x, y, 0] for y in (0, width)]
        edges.append([2 * x, 2 * x + 1])
        if x:
            edges += [[2 * x - 2, 2 * x], [2 * x - 1, 2 * x + 1]]
    first = len(nodes)
    for x in range(bays):
        nodes += [[bay * (x + 0.5), y, height] for y in (0, width)]
        upper = first + 2 * x
        edges.append([upper, upper + 1])
        for side in (0, 1):
            edges += [[2 * x + side, upper + side], [2 * x + 2 + side, upper + side]]
            if x:
                edges.append([upper - 2 + side, upper + side])
        if x:
            edges.append([upper - 2, upper + 1])
    return Graph(nodes, edges)


def tree(rng):
    """A trunk that forks, each branch's tips joined in a ring: a column that carries a roof."""
    forks = rng.integers(3, 6)
    nodes, edges = [[0, 0, 0], [0, 0, rng.uniform(4, 8)]], [[0, 1]]
    reach, rise = rng.uniform(6, 9), rng.uniform(4, 6)
    for _ in range(2):
        tips = []
        for fork in range(forks):
            turn = 2 * math.pi * fork / forks + rng.uniform(-0.2, 0.2)
            stem = 1 if len(nodes) < 2 + forks else 2 + fork
            away = reach * np.array([math.cos(turn), math.sin(turn)])
            tips.append(len(nodes))
            nodes.append([*(np.array(nodes[stem][:2]) + away), nodes[stem][2] + rise])
            edges.append([stem, tips[-1]])
        edges += [[tips[k], tips[(k + 1) % forks]] for k in range(forks)]
    return Graph(nodes, edges)


#: By name.
KINDS = {"tower": tower, "dome": dome, "space_frame": space_frame, "bridge": bridge, "tree": tree}
