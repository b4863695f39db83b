"""Models that the package makes itself, as binary STL.

All are closed and oriented outwards, in millimetres, standing on z = 0.
"""

from __future__ import annotations

import math
import struct
from collections.abc import Callable, Iterator, Sequence
from itertools import pairwise
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    import numpy as np
    import numpy.typing as npt

    Floats = npt.NDArray[np.float64]

Point = tuple[float, float, float]
Triangle = tuple[Point, Point, Point]

#: Segments of every circle; 96 keep the sphere's chords within 0.021 mm of its surface.
_AROUND = 96


def names() -> list[str]:
    """Names of the examples."""
    return list(_EXAMPLES)


def stl(name: str) -> bytes:
    """Binary STL of an example.

    Parameters
    ----------
    name
        One of `names`.
    """
    triangles = list(_EXAMPLES[name]())
    header = f"wireprint example {name}".encode().ljust(80)
    facets = [
        struct.pack("<12fH", 0, 0, 0, *a, *b, *c, 0)  # readers work the normal out themselves
        for a, b, c in triangles
    ]
    return header + struct.pack("<I", len(facets)) + b"".join(facets)


def _cube() -> Iterator[Triangle]:
    """Yield the paper's validation object, 28 mm."""
    half, height = 14.0, 28.0
    square = [(-half, -half), (half, -half), (half, half), (-half, half)]
    rings = [[(x, y, z) for x, y in square] for z in (0.0, height)]
    return _tube(rings)


def _sphere() -> Iterator[Triangle]:
    """Yield the paper's test print, radius 39 mm."""
    radius, steps = 39.0, 48
    angles = [math.pi * step / steps for step in range(steps + 1)]
    return _revolved([(radius * math.sin(a), radius - radius * math.cos(a)) for a in angles])


def _bottle() -> Iterator[Triangle]:
    """Yield a bottle of 180 mm with a waist, a shoulder and a neck."""
    profile = [(0.0, 0.0), (30.0, 0.0)]
    profile += [(30.0 - 4.0 * math.sin(math.pi * z / 100) ** 2, z) for z in range(5, 105, 5)]
    shoulder = [math.pi * step / 16 for step in range(17)]
    profile += [(20.0 + 10.0 * math.cos(a), 105.0 + 40.0 * a / math.pi) for a in shoulder]
    profile += [(10.0, 180.0), (0.0, 180.0)]
    return _revolved(profile)


def _arch() -> Iterator[Triangle]:
    """Yield two legs that lean together and merge: the paper's receiver on its caps."""
    thickness, radius, leg = 13.0, 32.0, 40.0
    spine = [(radius, leg * step / 8, 0.0) for step in range(8)]
    spine += [
        (radius * math.cos(a), leg + radius * math.sin(a), a)
        for a in (math.pi * step / 48 for step in range(49))
    ]
    spine += [(-radius, leg * step / 8, math.pi) for step in range(7, -1, -1)]
    rings = []
    for x, z, turn in spine:
        across = (math.cos(turn), math.sin(turn))
        rings.append([(x + u * across[0], v, z + u * across[1]) for u, v in _circle(thickness)])
    return _tube(rings)


def _torus() -> Iterator[Triangle]:
    """Yield a ring that stands upright: it forks just above the bed and merges at the top."""
    radius, thickness = 28.0, 10.0
    rings = []
    for step in range(_AROUND):
        turn = -2 * math.pi * step / _AROUND
        circle = [(radius + u, v) for u, v in _circle(thickness)]
        rings.append([(r * math.sin(turn), v, 38.0 + r * math.cos(turn)) for r, v in circle])
    for below, above in pairwise([*rings, rings[0]]):
        yield from _band(below, above)


def _branch() -> Iterator[Triangle]:
    """Yield a trunk that forks into three arms, two of which merge again."""
    import numpy as np

    from wireprint._implicit import surface

    limbs = [
        ((0, 0, -40), (0, 0, 24), 13.0),
        ((0, 0, 24), (24, 0, 56), 8.5),
        ((0, 0, 24), (-24, 0, 56), 8.5),
        ((0, 0, 24), (0, 26, 58), 7.5),
        ((24, 0, 56), (0, 0, 96), 8.5),
        ((-24, 0, 56), (0, 0, 96), 8.5),
        ((0, 0, 96), (0, 0, 156), 10.0),
    ]
    blend = 2.5

    def outside(x: Floats, y: Floats, z: Floats) -> Floats:
        """Signed distance, about, from the smooth union of the limbs."""
        total = np.zeros(np.broadcast_shapes(x.shape, y.shape, z.shape))
        for start, end, radius in limbs:
            axis = np.subtract(end, start)
            arm = (x - start[0], y - start[1], z - start[2])
            along = sum(a * u for a, u in zip(axis, arm, strict=True)) / (axis @ axis)
            along = np.clip(along, 0, 1)
            rest = (u - along * a for a, u in zip(axis, arm, strict=True))
            total += np.exp((radius - np.sqrt(sum(r * r for r in rest))) / blend)
        return -blend * np.log(total)

    # The lowest and the highest limb leave the box upright, so that the cuts are flat and round.
    facets = surface(outside, (-46.0, -26.0, 0.0), (46.0, 46.0, 116.0), 2.0)
    triangles: list[Triangle] = [(tuple(a), tuple(b), tuple(c)) for a, b, c in facets.tolist()]
    yield from triangles
    edges = {edge for a, b, c in triangles for edge in ((a, b), (b, c), (c, a))}
    for a, b in sorted(edges):
        if (b, a) not in edges:
            yield b, a, (0.0, 0.0, a[2])


_EXAMPLES: dict[str, Callable[[], Iterator[Triangle]]] = {
    "cube": _cube,
    "sphere": _sphere,
    "bottle": _bottle,
    "arch": _arch,
    "torus": _torus,
    "branch": _branch,
}


def _circle(radius: float) -> list[tuple[float, float]]:
    turns = (2 * math.pi * step / _AROUND for step in range(_AROUND))
    return [(radius * math.cos(turn), radius * math.sin(turn)) for turn in turns]


def _revolved(profile: Sequence[tuple[float, float]]) -> Iterator[Triangle]:
    """Turn a profile of (radius, height), from the axis below to the axis above, about z."""
    bottom, top = (0.0, 0.0, profile[0][1]), (0.0, 0.0, profile[-1][1])
    rings = [[(x, y, z) for x, y in _circle(radius)] for radius, z in profile[1:-1]]
    yield from _fan(rings[0][::-1], bottom)
    for below, above in pairwise(rings):
        yield from _band(below, above)
    yield from _fan(rings[-1], top)


def _tube(rings: Sequence[Sequence[Point]]) -> Iterator[Triangle]:
    """Join rings that run counter-clockwise about the tube's direction; close both ends."""
    yield from _fan(rings[0][::-1], _middle(rings[0]))
    for below, above in pairwise(rings):
        yield from _band(below, above)
    yield from _fan(rings[-1], _middle(rings[-1]))


def _band(below: Sequence[Point], above: Sequence[Point]) -> Iterator[Triangle]:
    for i, (a, c) in enumerate(zip(below, above, strict=True)):
        j = (i + 1) % len(below)
        yield a, below[j], above[j]
        yield a, above[j], c


def _fan(ring: Sequence[Point], hub: Point) -> Iterator[Triangle]:
    for i, a in enumerate(ring):
        yield a, ring[(i + 1) % len(ring)], hub


def _middle(ring: Sequence[Point]) -> Point:
    x, y, z = (sum(axis) / len(ring) for axis in zip(*ring, strict=True))
    return x, y, z
