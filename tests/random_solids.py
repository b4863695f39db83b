"""Random solids of round, slanted and thin shapes: cylinders that lie, domes, hooks, fins, tilts.

Where the plates of `random_parts` know level faces and upright walls alone, these know the rest.
Bodies are closed, and may overlap.
"""

import math
from dataclasses import dataclass
from random import Random

import numpy as np
import shapely
import trimesh
from shapely import affinity

import random_parts
from layered_solids import Body
from random_parts import LARGEST, NARROWEST, SMALLEST, disc, rectangle, thickness, wall

#: Corners of a circle.
CORNERS = 48
#: Share of solids that are turned about z.
SPUN = 0.5


@dataclass(frozen=True)
class Solid:
    """A part as closed bodies, which may overlap."""

    seed: int
    kind: str
    bodies: tuple[trimesh.Trimesh, ...]

    def mesh(self):
        """Vertices (V, 3) in mm, standing on z = 0, and faces (F, 3)."""
        starts = np.cumsum([0, *(len(body.vertices) for body in self.bodies)])
        vertices = np.concatenate([np.asarray(body.vertices) for body in self.bodies])
        faces = [np.asarray(b.faces) + n for b, n in zip(self.bodies, starts, strict=False)]
        return vertices - (0, 0, vertices[:, 2].min()), np.concatenate(faces)


def solid(seed):
    """The solid of a seed."""
    random = Random(seed)
    kind = random.choice(sorted(KINDS))
    size = math.exp(random.uniform(math.log(SMALLEST), math.log(LARGEST)))
    bodies = KINDS[kind](random, size)
    if random.random() < SPUN:
        spin = turned("z", random.uniform(0, 360))
        bodies = [body.apply_transform(spin) for body in bodies]
    return Solid(seed, kind, tuple(bodies))


def turned(axis, degrees):
    """A turn about an axis through the origin."""
    direction = {"x": (1, 0, 0), "y": (0, 1, 0), "z": (0, 0, 1)}[axis]
    return trimesh.transformations.rotation_matrix(math.radians(degrees), direction)


def at(body, x=0.0, y=0.0, z=0.0):
    """Move a body."""
    return body.apply_translation((x, y, z))


def block(width, depth, height):
    """A block that stands on z = 0 around the z axis."""
    return at(trimesh.creation.box((width, depth, height)), z=height / 2)


def prism(area, height):
    """An area that is extruded upwards from z = 0."""
    vertices, faces = Body().add(area, 0, height).mesh()
    return trimesh.Trimesh(vertices, faces, process=False)


def standing(area, depth):
    """An area of x and z that is extruded along y, around y = 0."""
    return at(prism(area, depth).apply_transform(turned("x", 90)), y=depth / 2)


def lathed(*outline):
    """A body of revolution about z from points (radius, height), counter-clockwise."""
    return trimesh.creation.revolve(np.array([*outline, outline[0]]), sections=CORNERS)


def cylinder(diameter, length):
    """A cylinder that stands on z = 0."""
    return at(trimesh.creation.cylinder(diameter / 2, length, sections=CORNERS), z=length / 2)


def tube_of(outer, inner, length):
    """A tube that stands on z = 0; diameters."""
    low, high = (inner / 2, 0.0), (inner / 2, length)
    return lathed(low, (outer / 2, 0.0), (outer / 2, length), high)


def lying(random, size):
    """Cylinders, cones and tubes that lie, on the bed, on a plate or let into it."""
    thick = max(2 * NARROWEST, size * random.uniform(0.1, 0.5))
    kind = random.choice(("cylinder", "cone", "tube", "cylinders"))
    if kind == "cone":
        tip = thick * random.uniform(0.2, 0.9) / 2
        made = [lathed((0.0, 0.0), (thick / 2, 0.0), (tip, size), (0.0, size))]
    elif kind == "tube" and thick > 4 * NARROWEST:
        made = [tube_of(thick, thick - 2 * max(NARROWEST, wall(random, size)), size)]
    else:
        made = [cylinder(thick, size)]
        if kind == "cylinders":
            aside = thick * random.uniform(0.6, 1.6)
            made.append(at(cylinder(thick * random.uniform(0.5, 1.2), size * 0.8), x=aside))
    made = [at(body.apply_transform(turned("y", 90)), x=-size / 2, z=thick / 2) for body in made]
    if random.random() < 0.6:
        plate = block(size * random.uniform(0.5, 1.2), thick * 2, thickness(random, size))
        sunk = random.uniform(0, 0.6) * thick
        made = [plate, *(at(body, z=plate.bounds[1][2] - sunk) for body in made)]
    return made


def dome(random, size):
    """Domes: whole or hollow, on a drum, on a plate, or upside down."""
    radius, rise = size / 2, size * random.uniform(0.15, 0.6)
    arc = np.linspace(0, math.pi / 2, 12)[1:-1]
    outside = [(radius * math.cos(t), rise * math.sin(t)) for t in arc]
    thin = wall(random, size)
    if random.random() < 0.5 and thin < 0.4 * min(radius, rise):
        inner = [
            ((radius - thin) * math.cos(t), (rise - thin) * math.sin(t)) for t in reversed(arc)
        ]
        made = lathed(
            (radius - thin, 0.0), (radius, 0.0), *outside, (0.0, rise), (0.0, rise - thin), *inner
        )
    else:
        made = lathed((0.0, 0.0), (radius, 0.0), *outside, (0.0, rise))
    if random.random() < 0.25:
        made.apply_transform(turned("x", 180))
    bodies = [at(made, z=-made.bounds[0][2])]
    if random.random() < 0.5:
        drum = cylinder(size, max(NARROWEST, size * random.uniform(0.05, 0.5)))
        bodies = [drum, at(bodies[0], z=drum.bounds[1][2])]
    return bodies


def cones(random, size):
    """Cones, frustums and funnels, one upon the other."""
    bodies, low, radius = [], 0.0, size * random.uniform(0.2, 0.5)
    for _ in range(random.randint(1, 3)):
        height, top = size * random.uniform(0.1, 0.6), size * random.uniform(0.03, 0.5)
        thin = wall(random, size)
        if random.random() < 0.4 and thin < 0.6 * min(radius, top):
            outline = (radius - thin, 0.0), (radius, 0.0), (top, height), (top - thin, height)
        else:
            outline = (0.0, 0.0), (radius, 0.0), (top, height), (0.0, height)
        bodies.append(at(lathed(*outline), z=low))
        low, radius = low + height, top
    return bodies


def gussets(random, size):
    """A plate with a wall and slanted ribs against it."""
    depth, height, thick = (
        size * random.uniform(0.4, 1),
        size * random.uniform(0.3, 1),
        thickness(random, size),
    )
    height = max(height, thick + 2 * NARROWEST)
    web = max(NARROWEST, min(thickness(random, size), size / 4))
    bodies = [block(size, depth, thick), at(block(web, depth, height), x=(web - size) / 2)]
    for _ in range(random.randint(1, 4)):
        reach, rise = size * random.uniform(0.3, 0.9), (height - thick) * random.uniform(0.4, 1)
        foot = web - size / 2 - web / 2
        area = shapely.Polygon([(foot, thick / 2), (foot + reach, thick / 2), (foot, thick + rise)])
        thin = wall(random, size)
        bodies.append(at(standing(area, thin), y=random.uniform(-1, 1) * max(depth - thin, 0) / 2))
    return bodies


def hook(random, size):
    """A hook: a plate or a block with an arm that leads up, out and back, round or angular."""
    thick, depth = (
        max(NARROWEST, size * random.uniform(0.08, 0.2)),
        size * random.uniform(0.05, 0.5),
    )
    reach, height = size * random.uniform(0.3, 0.8), size * random.uniform(0.4, 1)
    lip = height * random.uniform(0.1, 0.5)
    ways = {
        "up": [(0, 0), (0, height), (reach, height), (reach, height - lip)],
        "down": [(0, height), (0, 0), (reach, 0), (reach, lip)],
        "slanted": [(0, 0), (0, height / 2), (reach, height), (reach, height + lip)],
    }
    line = shapely.LineString(ways[random.choice(sorted(ways))])
    if random.random() < 0.5:
        area = line.buffer(thick / 2, quad_segs=8)
    else:
        area = line.buffer(thick / 2, cap_style="flat", join_style="mitre")
    bodies = [standing(area, max(NARROWEST, depth))]
    if random.random() < 0.5:
        low = bodies[0].bounds[0][2]
        bodies.append(
            at(block(size * 0.6, max(NARROWEST, depth) * 1.5, thickness(random, size)), z=low)
        )
    return bodies


def profile(random, size):
    """A T, L, Z, U, I, C or plus as a profile that lies, or leans."""
    width, height = size * random.uniform(0.2, 0.8), size * random.uniform(0.2, 0.8)
    thick = max(NARROWEST, min(width, height) * random.uniform(0.1, 0.3))
    w, h = width / 2, height
    strokes = {
        "T": [[(0, 0), (0, h)], [(-w, h), (w, h)]],
        "L": [[(-w, h), (-w, 0), (w, 0)]],
        "Z": [[(-w, 0), (0, 0), (0, h), (w, h)]],
        "U": [[(-w, h), (-w, 0), (w, 0), (w, h)]],
        "I": [[(-w, 0), (w, 0)], [(0, 0), (0, h)], [(-w, h), (w, h)]],
        "C": [[(w, 0), (-w, 0), (-w, h), (w, h)]],
        "+": [[(-w, h / 2), (w, h / 2)], [(0, 0), (0, h)]],
    }
    lines = strokes[random.choice(sorted(strokes))]
    area = shapely.union_all(
        [
            shapely.LineString(line).buffer(thick / 2, cap_style="square", join_style="mitre")
            for line in lines
        ]
    )
    if random.random() < 0.25:
        area = affinity.rotate(area, random.uniform(0, 90))
    return [standing(area, size)]


def brackets(random, size):
    """A wall with shelves that hang over: square, or carried by a slope."""
    height, web = size * random.uniform(0.5, 1.2), max(NARROWEST, size * random.uniform(0.08, 0.3))
    depth = size * random.uniform(0.2, 1)
    bodies = [block(web, depth, min(height, LARGEST))]
    for _ in range(random.randint(1, 3)):
        low, reach = height * random.uniform(0.1, 0.8), size * random.uniform(0.1, 0.6)
        thick = min(thickness(random, size), height - low)
        slope = min(random.choice((0.0, 0.3, 1.0)) * reach, low)
        area = shapely.Polygon(
            [(0, low - slope), (reach, low), (reach, low + thick), (0, low + thick)]
        )
        if random.random() < 0.4:
            area = affinity.scale(area, -1, 1, origin=(0, 0))
        along = depth * random.uniform(0.3, 1)
        bodies.append(at(standing(area, along), y=random.uniform(-1, 1) * (depth - along) / 2))
    return bodies


def nested(random, size):
    """Tubes in tubes on a floor, or without one."""
    thin, height = wall(random, size), size * random.uniform(0.2, 1)
    gap = max(NARROWEST, size * random.uniform(0.02, 0.15))
    bodies, outer = [], size
    for _ in range(random.randint(2, 4)):
        if outer < 2 * thin + NARROWEST:
            break
        bodies.append(tube_of(outer, outer - 2 * thin, height * random.uniform(0.4, 1)))
        outer -= 2 * (thin + gap)
    if random.random() < 0.6:
        bodies.append(cylinder(size, min(thickness(random, size), height * 0.3)))
    if outer > NARROWEST and random.random() < 0.5:
        bodies.append(cylinder(outer, height))
    return bodies


def fins(random, size):
    """A foot with thin fins."""
    depth, thick = size * random.uniform(0.3, 1), thickness(random, size)
    height, thin = size * random.uniform(0.1, 0.7), random.uniform(0.6, 2.0)
    pitch = max(thin * random.uniform(1.8, 6), size / 16)
    bodies, x = [block(size, depth, thick)], (thin - size) / 2
    while x <= (size - thin) / 2:
        bodies.append(at(block(thin, depth, thick + height), x=x))
        x += pitch
    return bodies


def chamfered(random, size):
    """A block or a plate whose edges are chamfered, below or above; with a stem or none."""
    width, depth, height = (size * random.uniform(low, 1) for low in (0.5, 0.3, 0.1))
    cut = min(width, depth, height) * random.uniform(0.05, 0.45)
    levels = {
        "below": [(0, cut), (cut, 0), (height, 0)],
        "above": [(0, 0), (height - cut, 0), (height, cut)],
        "both": [(0, cut), (cut, 0), (height - cut, 0), (height, cut)],
    }
    corners = []
    for z, inset in levels[random.choice(sorted(levels))]:
        x, y = width / 2 - inset, depth / 2 - inset
        corners += [(sx * x, sy * y, z) for sx in (-1, 1) for sy in (-1, 1)]
    bodies = [trimesh.convex.convex_hull(np.array(corners))]
    if random.random() < 0.4:
        stem = cylinder(max(NARROWEST, min(width, depth) * random.uniform(0.2, 0.6)), size * 0.5)
        bodies.append(at(stem, z=height / 2))
    return bodies


def tilted(random, size):
    """A plate, tube or box that leans, on a foot or on its own corner."""
    kind = random.choice(("plate", "tube", "box", "beam"))
    vertices, faces = random_parts.Part(
        0, kind, (_single(random_parts.KINDS[kind](random, size)),), 0, 0.0
    ).mesh()
    body = trimesh.Trimesh(vertices, faces, process=False)
    body.apply_transform(
        turned(random.choice("xy"), random.choice((-60, -45, -30, -15, -5, 5, 15, 30, 45, 60)))
    )
    body.apply_transform(turned(random.choice("xyz"), random.uniform(-40, 40)))
    body = at(body, z=-body.bounds[0][2])
    if random.random() < 0.5:
        low, high = body.bounds
        foot = block(*(0.6 * (high - low)[:2]), max(NARROWEST, 0.15 * (high - low)[2]))
        return [body, at(foot, *(low + high)[:2] / 2)]
    return [body]


def _single(made):
    return made[0] if isinstance(made, list) else made


def overlapping(random, size):
    """Blocks, cylinders, balls and cones that run into each other."""
    bodies = []
    for _ in range(random.randint(2, 6)):
        body = lump(random, size)
        if random.random() < 0.4:
            turn = random.choice((90, random.uniform(0, 90)))
            body.apply_transform(turned(random.choice("xy"), turn))
        body = at(body, z=-body.bounds[0][2])
        if bodies:
            low, high = random.choice(bodies).bounds
            place = [random.uniform(a, b) for a, b in zip(low, high, strict=True)]
            body = at(body, place[0], place[1], random.choice((0.0, low[2], place[2])))
        bodies.append(body)
    return bodies


def lump(random, size):
    """A block, a cylinder, a ball or a pointed cone."""
    extent = max(2 * NARROWEST, size * random.uniform(0.15, 0.6))
    long = max(2 * NARROWEST, extent * random.uniform(0.3, 1.5))
    kind = random.choice(("block", "cylinder", "ball", "cone"))
    if kind == "block":
        return block(extent, long, max(NARROWEST, size * random.uniform(0.05, 0.6)))
    if kind == "cylinder":
        return cylinder(extent, long)
    if kind == "ball":
        return trimesh.creation.icosphere(3, extent / 2)
    return lathed((0.0, 0.0), (extent / 2, 0.0), (extent / 8, long), (0.0, long))


def clevis(random, size):
    """Ears with a round end and a hole across, on a foot: the hole's crown hangs over."""
    thick, wide = max(NARROWEST, size * random.uniform(0.08, 0.25)), size * random.uniform(0.3, 0.8)
    height, bore = size * random.uniform(0.4, 1), wide * random.uniform(0.2, 0.7)
    ear = rectangle(wide, 2 * height).intersection(shapely.box(-size, 0, size, 2 * size))
    ear = ear.union(affinity.translate(disc(wide), 0, height))
    ear = ear.difference(affinity.translate(disc(bore), 0, height))
    gap = thick + size * random.uniform(0.1, 0.5)
    bodies = [
        block(wide * random.uniform(1, 1.6), gap + thick, min(thickness(random, size), height / 2))
    ]
    sides = random.choice(((-1, 1), (0,)))
    return [*bodies, *(at(standing(ear, thick), y=side * gap / 2) for side in sides)]


KINDS = {
    maker.__name__: maker
    for maker in (
        brackets,
        chamfered,
        clevis,
        cones,
        dome,
        fins,
        gussets,
        hook,
        lying,
        nested,
        overlapping,
        profile,
        tilted,
    )
}
