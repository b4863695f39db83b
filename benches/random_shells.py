"""Random shapes that people wire: vases, twisted prisms, lumps, knots, shells with lobes.

Where `tests/random_parts.py` and `tests/random_solids.py` know what is machined, these know what is
modelled. Each is closed, and the same seed gives the same shape.
"""

import math
from random import Random

import numpy as np
import trimesh

#: Height or extent, mm.
SMALLEST, LARGEST = 15.0, 120.0
#: Points around a shape, and rings along it.
AROUND, ALONG = 64, 48


def shell(seed):
    """Kind, vertices (V, 3) in mm standing on z = 0, and faces (F, 3) of a seed's shape."""
    random = Random(seed)
    kind = random.choice(sorted(KINDS))
    size = math.exp(random.uniform(math.log(SMALLEST), math.log(LARGEST)))
    vertices, faces = KINDS[kind](random, size)
    return kind, vertices - (0, 0, vertices[:, 2].min()), faces


def waves(random, count, most):
    """A smooth random function of a turn or a height, between 1 - most and 1 + most."""
    sizes = [random.uniform(0, most / count) for _ in range(count)]
    phases = [random.uniform(0, 2 * math.pi) for _ in range(count)]
    terms = list(zip(sizes, range(1, count + 1), phases, strict=True))
    return lambda t: 1 + sum(a * np.sin(k * t + phase) for a, k, phase in terms)


def vase(random, size):
    """A lathed outline."""
    height, profile = size, waves(random, 4, 0.7)
    width = size * random.uniform(0.15, 0.45)
    z = np.linspace(0, 1, ALONG)
    return _lofted([_circle(width * float(profile(math.pi * t)), 1.0, 0.0) for t in z], height * z)


def lobed(random, size):
    """A vase whose rings have lobes that turn with the height."""
    lobes, depth = random.randint(3, 9), random.uniform(0.05, 0.3)
    twist, profile = random.uniform(-1.5, 1.5), waves(random, 3, 0.5)
    width = size * random.uniform(0.2, 0.45)
    turn = np.linspace(0, 2 * math.pi, AROUND, endpoint=False)
    z = np.linspace(0, 1, ALONG)

    def ring(t):
        radius = (
            width * float(profile(math.pi * t)) * (1 + depth * np.sin(lobes * turn + twist * t))
        )
        return np.column_stack([radius * np.cos(turn), radius * np.sin(turn)])

    return _lofted([ring(float(t)) for t in z], size * z)


def twisted(random, size):
    """A prism of few corners that turns and tapers."""
    corners, twist = random.randint(3, 8), random.uniform(0, math.pi / 2)
    taper, width = random.uniform(0.3, 1.2), size * random.uniform(0.15, 0.4)
    z = np.linspace(0, 1, ALONG // 2)
    rings = [_circle(width * (1 + (taper - 1) * t), 1.0, twist * t, corners) for t in z]
    return _lofted(rings, size * z)


def lump(random, size):
    """A ball that is pressed and swollen."""
    ball = trimesh.creation.icosphere(subdivisions=4, radius=1.0)
    points = np.asarray(ball.vertices)
    swell = np.ones(len(points))
    for _ in range(random.randint(2, 6)):
        at = np.array([random.gauss(0, 1) for _ in range(3)])
        at /= np.linalg.norm(at)
        swell += random.uniform(-0.35, 0.6) * np.exp(-4 * (1 - points @ at))
    stretch = [random.uniform(0.6, 1.3) for _ in range(3)]
    return points * swell[:, None] * stretch * size / 2.5, np.asarray(ball.faces)


def knot(random, size):
    """A tube along a torus knot."""
    p, q = random.choice(((1, 2), (1, 3), (2, 1), (2, 3), (3, 2)))
    width = size * random.uniform(0.05, 0.08)
    t = np.linspace(0, 2 * math.pi, 240, endpoint=False)
    r = size * (0.3 + 0.12 * np.cos(q * t))
    way = np.column_stack([r * np.cos(p * t), r * np.sin(p * t), 0.16 * size * np.sin(q * t)])
    return _tube(way, width)


def bowl(random, size):
    """A wall with a thickness that opens upwards."""
    wall, width = size * random.uniform(0.04, 0.1), size * random.uniform(0.3, 0.6)
    flare, height = random.uniform(0.4, 0.9), size * random.uniform(0.4, 1.0)
    outer = [
        (width * (flare + (1 - flare) * math.sqrt(t)), height * t) for t in np.linspace(0, 1, 24)
    ]
    inner = [(max(r - wall, 0.5), max(z, wall)) for r, z in reversed(outer)]
    lathe = trimesh.creation.revolve([(0, 0), *outer, *inner, (0, wall)], sections=AROUND)
    lathe.fix_normals()
    return np.asarray(lathe.vertices), np.asarray(lathe.faces)


def _circle(radius, squeeze, turned, corners=AROUND):
    turn = np.linspace(0, 2 * math.pi, corners, endpoint=False) + turned
    return np.column_stack([radius * np.cos(turn), radius * squeeze * np.sin(turn)])


def _lofted(rings, heights):
    """Skin of rings (N, 2) above each other, closed by a fan at either end."""
    count, levels = len(rings[0]), len(rings)
    points = [np.column_stack([r, np.full(count, z)]) for r, z in zip(rings, heights, strict=True)]
    hubs = [[*rings[0].mean(axis=0), heights[0]], [*rings[-1].mean(axis=0), heights[-1]]]
    here = np.arange(count)
    after = (here + 1) % count
    faces = []
    for level in range(levels - 1):
        low, high = level * count, (level + 1) * count
        faces += [np.column_stack([low + here, low + after, high + after])]
        faces += [np.column_stack([low + here, high + after, high + here])]
    top, hub = (levels - 1) * count, levels * count
    faces += [np.column_stack([after, here, np.full(count, hub)])]
    faces += [np.column_stack([top + here, top + after, np.full(count, hub + 1)])]
    return np.vstack([*points, hubs]), np.vstack(faces)


def _tube(way, radius, sides=16):
    """A tube along a closed way (N, 3)."""
    ahead = np.roll(way, -1, axis=0) - np.roll(way, 1, axis=0)
    ahead /= np.linalg.norm(ahead, axis=1)[:, None]
    side = np.cross(ahead, (0.0, 0.0, 1.0))
    side /= np.linalg.norm(side, axis=1)[:, None]
    up = np.cross(side, ahead)
    turn = np.linspace(0, 2 * math.pi, sides, endpoint=False)
    around = np.cos(turn)[:, None, None] * side + np.sin(turn)[:, None, None] * up
    points = (way + radius * around).transpose(1, 0, 2).reshape(-1, 3)
    here = np.arange(len(points)).reshape(len(way), sides)
    on, along = np.roll(here, -1, axis=1), np.roll(here, -1, axis=0)
    across = np.roll(on, -1, axis=0)
    quads = [np.stack(corners, axis=-1) for corners in ((here, along, across), (here, across, on))]
    faces = np.concatenate([quad.reshape(-1, 3) for quad in quads])
    volume = np.einsum(
        "ij,ij->i", points[faces[:, 0]], np.cross(points[faces[:, 1]], points[faces[:, 2]])
    )
    return points, faces if volume.sum() > 0 else faces[:, ::-1]


KINDS = {
    "bowl": bowl,
    "knot": knot,
    "lobed": lobed,
    "lump": lump,
    "twisted": twisted,
    "vase": vase,
}
