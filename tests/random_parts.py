"""Random mechanical parts: plates, bosses, pockets, ribs, steps, sleeves, tables, boxes."""

import math
from dataclasses import dataclass
from random import Random

import numpy as np
import shapely
from shapely import affinity

from layered_solids import Body

#: Extent of a part's longer side, mm.
SMALLEST, LARGEST = 5.0, 200.0
#: Plates are so thick, mm.
THINNEST, THICKEST = 0.6, 10.0
#: No post, wall or hole is narrower than this, mm.
NARROWEST = 1.2
#: Parts that stand on a side instead, and the share of outlines that are not square to the bed.
LYING, SPUN = 0.15, 0.5


@dataclass(frozen=True)
class Part:
    """A part as bodies that touch each other at most."""

    seed: int
    kind: str
    bodies: tuple[Body, ...]
    #: Turns by 90° about x before the part is set on the bed.
    quarter_turns: int
    spin_deg: float

    def mesh(self):
        """Vertices (V, 3) in mm, standing on z = 0, and faces (F, 3)."""
        meshes = [body.mesh() for body in self.bodies]
        starts = np.cumsum([0, *(len(vertices) for vertices, _ in meshes)])
        vertices = np.concatenate([vertices for vertices, _ in meshes])
        faces = np.concatenate([f + n for (_, f), n in zip(meshes, starts, strict=False)])
        for _ in range(self.quarter_turns):
            vertices = vertices[:, [0, 2, 1]] * (1, -1, 1)
        turn = math.radians(self.spin_deg)
        x, y, z = vertices.T
        vertices = np.column_stack(
            [x * math.cos(turn) - y * math.sin(turn), x * math.sin(turn) + y * math.cos(turn), z]
        )
        return vertices - (0, 0, vertices[:, 2].min()), faces


def part(seed):
    """The part of a seed."""
    random = Random(seed)
    kind = random.choice(sorted(KINDS))
    size = math.exp(random.uniform(math.log(SMALLEST), math.log(LARGEST)))
    made = KINDS[kind](random, size)
    bodies = tuple(made) if isinstance(made, list) else (made,)
    turns = random.choice((1, 2, 3)) if random.random() < LYING else 0
    spin = random.uniform(0, 90) if random.random() < SPUN else 0.0
    return Part(seed, kind, bodies, turns, spin)


def thickness(random, size):
    """How thick a plate is, mm: any, but no more than it is long."""
    return min(math.exp(random.uniform(math.log(THINNEST), math.log(THICKEST))), size / 2)


def wall(random, size):
    """How thick an upright wall is, mm."""
    return max(NARROWEST, size * random.uniform(0.02, 0.12))


def rectangle(width, depth):
    """A rectangle around the origin."""
    return shapely.box(-width / 2, -depth / 2, width / 2, depth / 2)


def disc(diameter):
    """A disc around the origin."""
    return shapely.Point(0, 0).buffer(diameter / 2, quad_segs=16)


def outline(random, size):
    """An outline as long as `size`, and at least three tenths as deep, around the origin."""
    depth = size * random.uniform(0.3, 1)
    whole = rectangle(size, depth)
    arm = random.uniform(0.25, 0.5)
    corner = shapely.box(-size, -depth, size * (0.5 - arm), depth * (0.5 - arm))
    slot = shapely.box(-size * (0.5 - arm / 2), -depth, size * (0.5 - arm / 2), depth * (0.5 - arm))
    kinds = {
        "rectangle": lambda: whole,
        "disc": lambda: disc(size),
        "rounded": lambda: whole.buffer(-depth / 5).buffer(depth / 5, quad_segs=8),
        "L": lambda: whole.difference(corner),
        "U": lambda: whole.difference(slot),
        "hexagon": lambda: shapely.Polygon(
            [(size / 2 * math.cos(t), size / 2 * math.sin(t)) for t in np.arange(6) * math.pi / 3]
        ),
    }
    return kinds[random.choice(sorted(kinds))]()


def small(random, size):
    """The section of a boss, pocket or hole: from a tenth to two fifths of the plate."""
    extent = max(NARROWEST, size * random.uniform(0.1, 0.4))
    if random.random() < 0.5:
        return disc(extent)
    return rectangle(extent, max(NARROWEST, extent * random.uniform(0.3, 1)))


def placed(random, shape, area, margin=0.0):
    """Move a shape to somewhere within an area; None where there is no room."""
    room = area.buffer(-margin, join_style="mitre")
    low_x, low_y, high_x, high_y = room.bounds if room else (0, 0, 0, 0)
    for _ in range(20):
        x, y = random.uniform(low_x, high_x), random.uniform(low_y, high_y)
        moved = affinity.translate(shape, x, y)
        if room.contains(moved):
            return moved
    return None


def plate(random, size):
    """A plate with bosses, pins, pockets, holes and ribs."""
    thick, area = thickness(random, size), outline(random, size)
    body = Body().add(area, 0, thick)
    taken = shapely.Polygon()
    for _ in range(random.randint(0, 6)):
        shape = placed(random, small(random, size), area, NARROWEST)
        if shape is None or shape.distance(taken) < NARROWEST:
            continue
        taken = taken.union(shape)
        random.choice((boss, pocket, hole, sleeve_on, rib))(random, body, shape, thick, size)
    return body


def boss(random, body, shape, thick, size):
    """Something that stands on a plate; a pin where it is slender."""
    body.add(shape, thick, thick + size * random.uniform(0.05, 0.8))


def pocket(random, body, shape, thick, size):
    """A pocket, or a blind hole."""
    body.cut(shape, thick * random.uniform(0.2, 0.8), thick)


def hole(random, body, shape, thick, size):
    """A hole through the plate."""
    body.cut(shape, 0, thick)


def sleeve_on(random, body, shape, thick, size):
    """A sleeve around a hole: blind, or through the plate."""
    inner = shape.buffer(-wall(random, size))
    body.add(shape, thick, thick + size * random.uniform(0.05, 0.6))
    if inner:
        top = max(body.heights())
        body.cut(inner, 0 if random.random() < 0.5 else thick, top)


def rib(random, body, shape, thick, size):
    """A rib across the place, within the plate's outline."""
    x, y = shape.centroid.coords[0]
    across = affinity.translate(rectangle(size * 2, wall(random, size)), x, y)
    across = affinity.rotate(across, random.choice((0, 90, random.uniform(0, 180))), (x, y))
    area = body.steps[0][0].intersection(across)
    body.add(area, thick, thick + size * random.uniform(0.03, 0.3))


def stairs(random, size):
    """Steps that rise along x."""
    count, depth = random.randint(2, 6), size * random.uniform(0.3, 1)
    rise = max(THINNEST, size * random.uniform(0.03, 0.25))
    body = Body()
    for step in range(count):
        body.add(shapely.box(size * step / count, 0, size, depth), step * rise, (step + 1) * rise)
    return body


def step_pyramid(random, size):
    """Ever narrower outlines on one another."""
    area, low = outline(random, size), 0.0
    body = Body()
    for _ in range(random.randint(2, 5)):
        high = low + max(THINNEST, size * random.uniform(0.03, 0.3))
        body.add(area, low, high)
        scale = random.uniform(0.3, 0.85)
        area, low = affinity.scale(area, scale, scale, origin=(0, 0)), high
        if math.sqrt(area.area) < 2 * NARROWEST:
            break
    return body


def beam(random, size):
    """A beam whose section is a U, T, L or I, standing on its flange or upside down."""
    depth, height = size * random.uniform(0.3, 1), size * random.uniform(0.2, 0.8)
    thick = min(thickness(random, size), height / 3)
    web = wall(random, size)
    flange, top = rectangle(size, depth), height - thick
    places = {"U": (-1, 1), "L": (-1,), "T": (0,), "I": (0,)}
    section = random.choice(sorted(places))
    body = Body()
    if section != "T":
        body.add(flange, 0, thick)
    for side in places[section]:
        body.add(affinity.translate(rectangle(size, web), 0, side * (depth - web) / 2), 0, height)
    if section in "TI":
        body.add(flange, top, height)
    return body


def tube(random, size):
    """A sleeve, with flanges at its ends or between them, or none."""
    outer = size * random.uniform(0.4, 0.8)
    inner = outer - 2 * max(NARROWEST, outer * random.uniform(0.03, 0.3))
    height = size * random.uniform(0.3, 1.5)
    height, thick = min(height, LARGEST), min(thickness(random, size), height / 3)
    body = Body().add(disc(outer), 0, height)
    for low in (0, (height - thick) / 2, height - thick):
        if random.random() < 0.4:
            body.add(disc(size), low, low + thick)
    return body.cut(disc(inner), 0, height) if inner > NARROWEST else body


def mushroom(random, size):
    """Stems under a disc or plate that hangs over."""
    area, height = outline(random, size), size * random.uniform(0.15, 0.8)
    stem = placed(random, small(random, size), area) or disc(max(NARROWEST, size / 8))
    body = Body().add(stem, 0, height)
    if random.random() < 0.4:
        body.add(affinity.scale(stem, 2, 2), 0, thickness(random, size))
    return body.add(area, height, height + thickness(random, size))


def table(random, size):
    """A top on four legs, with a shelf between them or none."""
    depth, height = size * random.uniform(0.4, 1), size * random.uniform(0.2, 0.9)
    leg = max(NARROWEST, size * random.uniform(0.04, 0.15))
    x, y = (size - leg) / 2, (depth - leg) / 2
    body = Body()
    for sx, sy in ((-1, -1), (-1, 1), (1, -1), (1, 1)):
        body.add(affinity.translate(rectangle(leg, leg), sx * x, sy * y), 0, height)
    if random.random() < 0.3:
        low = height * random.uniform(0.2, 0.6)
        body.add(rectangle(size, depth), low, low + min(thickness(random, size), height / 4))
    return body.add(rectangle(size, depth), height, height + thickness(random, size))


def box(random, size):
    """A box: open, closed all around, or with a lid that is a body of its own."""
    area, height = outline(random, size), size * random.uniform(0.2, 0.9)
    floor = min(thickness(random, size), height / 4)
    inside = area.buffer(-wall(random, size), join_style="mitre")
    body = Body().add(area, 0, height)
    kind = random.choice(("open", "closed", "lid"))
    if inside:
        body.cut(inside, floor, height - floor if kind == "closed" else height)
    if kind == "lid":
        return [body, Body().add(area, height, height + thickness(random, size))]
    return body


def shelves(random, size):
    """Thin shelves around a tower."""
    height, thick = size * random.uniform(0.4, 1.2), thickness(random, size)
    height = min(height, LARGEST)
    tower = disc if random.random() < 0.5 else lambda d: rectangle(d, d)
    body = Body().add(tower(size * random.uniform(0.15, 0.5)), 0, height)
    for _ in range(random.randint(1, 3)):
        low = random.uniform(0, height - min(thick, height / 2))
        body.add(outline(random, size), low, low + min(thick, height / 2))
    return body


def stack(random, size):
    """Bodies of their own that lie flush on each other, or side by side."""
    first, second = outline(random, size), outline(random, size * random.uniform(0.3, 1))
    height = max(THINNEST, size * random.uniform(0.05, 0.4))
    above = height + max(THINNEST, size * random.uniform(0.05, 0.4))
    bodies = [Body().add(first, 0, height), Body().add(second, height, above)]
    if random.random() < 0.3:
        aside = affinity.translate(rectangle(size * 0.3, size * 0.3), size * 0.65)
        bodies.append(Body().add(aside, 0, height))
    return bodies


def tray(random, size):
    """A floor with holes inside a rim."""
    area, floor = outline(random, size), thickness(random, size)
    height = floor + size * random.uniform(0.05, 0.4)
    inside = area.buffer(-wall(random, size), join_style="mitre")
    body = Body().add(area, 0, height)
    if not inside:
        return body
    body.cut(inside, floor, height)
    for _ in range(random.randint(1, 8)):
        opening = placed(random, small(random, size * 0.5), inside)
        if opening is not None:
            body.cut(opening, 0, floor)
    return body


KINDS = {
    maker.__name__: maker
    for maker in (
        beam,
        box,
        mushroom,
        plate,
        shelves,
        stack,
        stairs,
        step_pyramid,
        table,
        tray,
        tube,
    )
}
