"""Random fittings as people draw them: gears, clips, trays, honeycombs, threads, hinges, letters.

Plain shapes again, yet each of a kind that neither `random_parts` nor `random_solids` has: teeth,
cells, slots, turns of a thread, strokes of letters. Bodies are closed, and may overlap.
"""

import math
from random import Random

import numpy as np
import shapely
from shapely import affinity

from random_parts import LARGEST, NARROWEST, SMALLEST, disc, rectangle, thickness, wall
from random_solids import SPUN, Solid, at, block, cylinder, lathed, prism, standing, tube_of, turned

#: Strokes of letters, in units of their height.
LETTERS = {
    "A": [[(0, 0), (0.35, 1), (0.7, 0)], [(0.15, 0.4), (0.55, 0.4)]],
    "E": [[(0.6, 0), (0, 0), (0, 1), (0.6, 1)], [(0, 0.5), (0.5, 0.5)]],
    "K": [[(0, 0), (0, 1)], [(0.6, 1), (0, 0.45), (0.6, 0)]],
    "R": [[(0, 0), (0, 1), (0.55, 1), (0.55, 0.5), (0, 0.5)], [(0.25, 0.5), (0.6, 0)]],
    "S": [[(0, 0), (0.6, 0), (0.6, 0.5), (0, 0.5), (0, 1), (0.6, 1)]],
    "T": [[(0.3, 0), (0.3, 1)], [(0, 1), (0.6, 1)]],
}


def fitting(seed):
    """The fitting of a seed."""
    random = Random(seed)
    kind = random.choice(sorted(KINDS))
    size = math.exp(random.uniform(math.log(2 * SMALLEST), math.log(LARGEST)))
    bodies = KINDS[kind](random, size)
    if random.random() < SPUN:
        spin = turned("z", random.uniform(0, 360))
        bodies = [body.apply_transform(spin) for body in bodies]
    return Solid(seed, kind, tuple(bodies))


def star(radius, deep, teeth, share=0.5):
    """A disc with square teeth, which take this share of the way around."""
    turns = np.linspace(0, 2 * math.pi, teeth, endpoint=False)
    half = math.pi * share / teeth
    points = []
    for turn in turns:
        low = radius - deep
        for angle, r in ((-half, low), (-half, radius), (half, radius), (half, low)):
            points.append((r * math.cos(turn + angle), r * math.sin(turn + angle)))
    return shapely.Polygon(points)


def gear(random, size):
    """A gear with a bore, and a hub on it or none."""
    teeth = random.randint(8, 24)
    area = star(size / 2, max(NARROWEST, size * random.uniform(0.05, 0.12)), teeth)
    bore = size * random.uniform(0.1, 0.3)
    height = max(NARROWEST, size * random.uniform(0.08, 0.4))
    bodies = [prism(area.difference(disc(bore)), height)]
    if random.random() < 0.5 and size * 0.4 - bore > 2 * NARROWEST:
        bodies.append(at(tube_of(size * 0.4, bore, size * 0.2), z=height))
    return bodies


def knurl(random, size):
    """A knob with a fine knurl, and a shaft below or above."""
    area = star(size / 2, max(0.4, size * 0.02), random.randint(16, 40))
    knob, shaft = prism(area, size * random.uniform(0.2, 0.6)), size * random.uniform(0.1, 0.4)
    stem = cylinder(max(NARROWEST, shaft), size * random.uniform(0.2, 0.8))
    upper = (knob, stem) if random.random() < 0.5 else (stem, knob)
    return [upper[0], at(upper[1], z=upper[0].bounds[1][2])]


def honeycomb(random, size):
    """A plate or a rim full of six-sided cells."""
    cell = max(4 * NARROWEST, size * random.uniform(0.1, 0.25))
    web = max(NARROWEST, cell * random.uniform(0.1, 0.25))
    hexagon = shapely.Polygon(
        [(cell / 2 * math.cos(a), cell / 2 * math.sin(a)) for a in np.arange(6) * math.pi / 3]
    )
    room = rectangle(size, size * random.uniform(0.5, 1))
    inner = room.buffer(-web, join_style="mitre")
    step = math.sqrt(3) / 2 * cell + web
    count = int(size / step) + 2
    cells = [
        affinity.translate(hexagon, i * step * math.sqrt(3) / 2, (j + 0.5 * (i % 2)) * step)
        for i in range(-count, count + 1)
        for j in range(-count, count + 1)
    ]
    holes = shapely.union_all([each for each in cells if inner.contains(each)])
    height = max(NARROWEST, size * random.uniform(0.03, 0.3))
    bodies = [prism(room.difference(holes), height)]
    if random.random() < 0.4:
        bodies.append(prism(room, min(thickness(random, size), height)))
    return bodies


def thread(random, size):
    """A threaded rod as a core with rings of a saw's profile, and a head or none."""
    core, length = size * random.uniform(0.1, 0.3), size
    pitch = max(2.0, size * random.uniform(0.03, 0.1))
    deep = min(pitch * 0.5, core * 0.3)
    bodies = [cylinder(core, length)]
    low = pitch
    while low + pitch < length:
        rim = (core / 2 - 0.1, low), (core / 2 + deep, low + deep), (core / 2 - 0.1, low + 2 * deep)
        bodies.append(lathed(*rim))
        low += pitch
    if random.random() < 0.5:
        head = prism(disc(core * 2).intersection(rectangle(core * 1.8, core * 1.6)), core * 0.8)
        bodies.append(head)
    return bodies


def ring(random, size):
    """Thin rings, one upon the other or one in the other."""
    bodies, outer, low = [], size, 0.0
    for _ in range(random.randint(1, 3)):
        thin = max(NARROWEST, min(wall(random, size), outer / 8))
        height = max(NARROWEST, size * random.uniform(0.03, 0.3))
        bodies.append(at(tube_of(outer, outer - 2 * thin, height), z=low))
        low += height * (random.random() < 0.5)
        outer -= thin * random.choice((0, 1, 2.5))
    bodies[0] = at(bodies[0], z=-bodies[0].bounds[0][2])
    return bodies


def tray(random, size):
    """A tray with dividers, lower than its rim or as high."""
    width, depth = size, size * random.uniform(0.4, 1)
    height = max(3 * NARROWEST, size * random.uniform(0.1, 0.5))
    thin, floor = max(NARROWEST, wall(random, size)), min(thickness(random, size), height / 3)
    rim = rectangle(width, depth).difference(rectangle(width - 2 * thin, depth - 2 * thin))
    bodies = [block(width, depth, floor), prism(rim, height)]
    for along in range(random.randint(1, 4)):
        reach = height * random.choice((0.5, 0.8, 1))
        if along % 2:
            bodies.append(at(block(width, thin, reach), y=random.uniform(-0.4, 0.4) * depth))
        else:
            bodies.append(at(block(thin, depth, reach), x=random.uniform(-0.4, 0.4) * width))
    return bodies


def clip(random, size):
    """A clip: an open ring that lies or stands, on a foot."""
    thick = max(NARROWEST, size * random.uniform(0.08, 0.15))
    outer = disc(size).difference(disc(size - 2 * thick))
    gap = shapely.box(-size * random.uniform(0.15, 0.35), 0, size * 0.25, size)
    area = outer.difference(gap)
    depth = max(NARROWEST, size * random.uniform(0.1, 0.4))
    if random.random() < 0.5:
        return [prism(area, depth)]
    made = standing(area, depth)
    foot = block(size * 0.7, max(depth, NARROWEST) * 1.5, thick)
    return [made, at(foot, z=made.bounds[0][2])]


def hinge(random, size):
    """Knuckles on a leaf, with a bore through them."""
    across = max(4 * NARROWEST, size * random.uniform(0.12, 0.25))
    bore, thick = across * random.uniform(0.3, 0.6), max(NARROWEST, across * 0.3)
    count = random.randint(2, 4)
    pitch = size / (2 * count - 1)
    leaf = at(block(size * 0.5, size, thick), x=size * 0.25)
    bodies = [leaf]
    area = disc(across).union(shapely.box(0, -across / 2, across, across / 2 * 0.2))
    for number in range(count):
        knuckle = standing(area.difference(disc(bore)), pitch)
        bodies.append(at(knuckle, y=-size / 2 + pitch * (2 * number + 0.5), z=across / 2))
    return bodies


def slot(random, size):
    """An extrusion with T-slots, standing or lying."""
    wide = size * random.uniform(0.2, 0.5)
    mouth, room = wide * 0.25, wide * 0.45
    cut = shapely.union(
        shapely.box(-mouth / 2, wide * 0.25, mouth / 2, wide),
        shapely.box(-room / 2, wide * 0.25, room / 2, wide * 0.4),
    )
    area = rectangle(wide, wide).difference(disc(wide * 0.15))
    for quarter in range(4):
        area = area.difference(affinity.rotate(cut, 90 * quarter, origin=(0, 0)))
    made = prism(area, size * random.uniform(0.3, 1))
    if random.random() < 0.4:
        made.apply_transform(turned("x", 90))
    return [at(made, z=-made.bounds[0][2])]


def letters(random, size):
    """Raised letters on a plate, or letters alone, or letters that stand."""
    word = "".join(random.choice(sorted(LETTERS)) for _ in range(random.randint(1, 4)))
    high = size / len(word)
    stroke = max(NARROWEST, high * random.uniform(0.1, 0.2))
    lines = [
        shapely.LineString([(high * (x + 0.9 * place), high * y) for x, y in line])
        for place, letter in enumerate(word)
        for line in LETTERS[letter]
    ]
    area = shapely.union_all(
        [line.buffer(stroke / 2, cap_style="square", join_style="mitre") for line in lines]
    )
    raised = max(0.6, high * random.uniform(0.05, 0.5))
    kind = random.choice(("plate", "alone", "standing"))
    if kind == "standing":
        made = standing(area, max(2 * NARROWEST, raised))
        return [
            made,
            at(
                block(*(made.extents[:2] * (1.1, 2)), stroke),
                *made.bounds.mean(axis=0)[:2],
                made.bounds[0][2],
            ),
        ]
    if kind == "alone":
        return [prism(area, raised)]
    low, thick = area.bounds, thickness(random, size)
    plate = shapely.box(*low).buffer(stroke, join_style="mitre")
    return [prism(plate, thick), at(prism(area, raised), z=thick)]


KINDS = {
    maker.__name__: maker
    for maker in (clip, gear, hinge, honeycomb, knurl, letters, ring, slot, thread, tray)
}
