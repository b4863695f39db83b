"""Writes docs/regions.md: what regions of layers cost, and what they gain.

python benches/regions.py [-o PAGE]
"""

import argparse
import tempfile
from pathlib import Path

import numpy as np
from scipy.spatial import cKDTree

import shared_models
from wireprint import examples
from wireprint._core import KINDS
from wireprint.duration import duration
from wireprint.hybrid.sketch import Sketch
from wireprint.mesh import load_mesh
from wireprint.pipeline import make
from wireprint.regions import Box, HalfSpace, Region, Sphere, ZRange
from wireprint.settings import Settings

ROOT = Path(__file__).resolve().parent.parent
PAGE = """# Layers where detail is wanted: what they cost and what they gain

Written by `python benches/regions.py`. Defaults of `kossel-mini`, `abs` and `[regions]`
(0.2 mm layers, two walls, 10 % infill), on a bed that is large enough for all models.

## Time lies between wire and solid

Marked from the top down, so that a share of the surface's area is layers. *In proportion* is the
wire print's time plus that share of what marking everything adds.

| model | marked | layers | time | in proportion | breaches | stays wire |
|---|--:|--:|--:|--:|--:|--:|
{shares}

A share of the area is not a share of the volume: infill and solid faces make wide parts dearer
than slender ones.

## Detail

**to surface**: mean distance from points of the model's surface to the nearest strand's centre
line, of the wire print and of the one with layers, in the region and outside it. **posts**:
how many of the wire print's posts stand where they stood, of those that are farther from all layers
than a stroke as high as the highest slab bars the head. **filled**: how much of the region's inside
behind contours that are marked in part is filled; the rest is beside wire, or nothing carries it.

| model | marked | runs | time | in it, mm | outside, mm | posts | filled, cm³ | breaches | wire |
|---|---|--:|--:|--:|--:|--:|--:|--:|--:|
{details}
"""
SETTINGS = Settings.load(overrides=["gcode.thumbnails=[]", *shared_models.ROOMY])
SHARES = (0, 10, 25, 50, 75, 100)
#: Points along a strand lie so far apart, mm.
PITCH = 0.1
#: What moves less stays where it is, mm: coordinates are written to 1 µm.
SAME = 1e-3


def surface(mesh):
    """Short pieces of the model's contours at all heights, with their areas."""
    plain = make(mesh, SETTINGS, certify=False)
    return plain, Sketch(mesh, plain.wireframe, SETTINGS).samples


def height_above(samples, percent):
    """Height above which a share of the surface lies, mm."""
    order = np.argsort(-samples.middle[:, 2], kind="stable")
    share = np.cumsum(samples.area[order]) / samples.area.sum()
    return samples.middle[order[np.searchsorted(share, percent / 100)], 2]


def distances(print_, points):
    """Distance of points from the strands, mm."""
    ends = print_.wireframe.strands
    count = np.ceil(np.linalg.norm(ends[:, 1] - ends[:, 0], axis=1) / PITCH).astype(int) + 1
    which = np.repeat(np.arange(len(ends)), count)
    rank = np.arange(len(which)) - np.repeat(np.cumsum(count) - count, count)
    share = (rank / np.maximum(count[which] - 1, 1))[:, None]
    return cKDTree(ends[which, 0] * (1 - share) + ends[which, 1] * share).query(points)[0]


def kept(plain, made):
    """Count the posts far from layers that stay where they are, and all of these."""
    kinds = ("post", "layer-wise", "layer-fill")
    post, *layers = (KINDS.index(kind) for kind in kinds)
    strands = [p.wireframe.strands[p.wireframe.strand_kinds == post] for p in (plain, made)]
    before, after = (each.reshape(-1, 6) for each in strands)
    lines = made.wireframe.strands[np.isin(made.wireframe.strand_kinds, layers)]
    head = SETTINGS.printer.head
    reach = head.tip_radius_mm + SETTINGS.slab_max_mm / np.tan(np.radians(head.slant_deg))
    far = cKDTree(lines[:, 0, :2]).query(before[:, :2])[0] > reach
    stand = cKDTree(after).query(before[far])[0] < SAME
    return f"{stand.sum()} of {far.sum()}"


def filled(print_):
    """How much of a region's inside is filled."""
    report = print_.figures()["regions"]
    hollow = sum(part["volume_mm3"] for part in report["hollow"])
    whole = report["filled_mm3"] + hollow
    return f"{report['filled_mm3'] / 1000:.1f} of {whole / 1000:.1f}" if whole else "–"


def stays(print_, area_mm2):
    """Share of a marked area that is not layers after all."""
    left = sum(run["area_mm2"] for run in print_.figures()["regions"]["dropped"])
    return f"{100 * left / area_mm2:.1f} %"


def breaches(print_):
    """Return how often a print breaks the rules."""
    return sum(print_.figures()["breaches"].values())


def shares(name, mesh):
    """Rows of the first table."""
    _, samples = surface(mesh)
    area = samples.area.sum()
    prints = []
    for percent in SHARES:
        low = {0: np.inf, 100: -np.inf}.get(percent) or height_above(samples, percent)
        marks = ZRange(low_mm=float(low)) if np.isfinite(low) else ZRange()
        region = None if percent == 0 else Region().add(marks)
        prints.append(make(mesh, SETTINGS, region, compare=False))
    wire, solid = prints[0].estimate.total_s, prints[-1].estimate.total_s
    for percent, made in zip(SHARES, prints, strict=True):
        runs = () if made.regions is None else made.regions.plan.sections
        layers = sum(run.area_mm2 for run in runs) / area
        expected = wire + layers * (solid - wire)
        wires = stays(made, area) if made.regions else "–"
        yield (
            f"| {name} | {percent} % | {100 * layers:.0f} % | {duration(made.estimate.total_s)} "
            f"| {duration(expected)} | {breaches(made)} | {wires} |"
        )


def detail(name, mesh, called, region):
    """One row of the second table."""
    plain, _ = surface(mesh)
    made = make(mesh, SETTINGS, region, compare=False)
    runs, samples = made.regions.plan.runs, made.regions.plan.samples
    inside = runs.of_sample >= 0
    far = [distances(print_, samples.middle) for print_ in (plain, made)]
    near, apart = ([f"{np.mean(d[part]):.2f}" for d in far] for part in (inside, ~inside))
    times = " → ".join(duration(print_.estimate.total_s) for print_ in (plain, made))
    marked = samples.area[inside].sum()
    return (
        f"| {name} | {called} | {len(runs.runs)} | {times} | {' → '.join(near)} "
        f"| {' → '.join(apart)} | {kept(plain, made)} | {filled(made)} | {breaches(made)} "
        f"| {stays(made, marked)} |"
    )


def example(name):
    """Load a model of the package."""
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / f"{name}.stl"
        path.write_bytes(examples.stl(name))
        return load_mesh(path)


def tables(models):
    """Return the rows of both tables; shared models are left out where they are absent."""
    bottle = example("bottle")
    first, second = [("bottle", bottle)], []
    second.append(("bottle", bottle, "neck", Region().add(ZRange(low_mm=135))))
    ball, middle = example("sphere"), Box(low_mm=(-40, -40, 11), high_mm=(40, -2, 22))
    second.append(("sphere", ball, "box in mid-air", Region().add(middle)))
    if models.is_dir():
        bunny = load_mesh(models / "bunny.stl", scale=792.372)
        mug = load_mesh(models / "mug.stl", height_mm=90)
        kossel = load_mesh(models / "kossel_frame_top.stl")
        figure = load_mesh(models / "figure_man.obj", up="y", height_mm=160)
        first += [("bunny", bunny), ("kossel_frame_top", kossel)]
        head = Sphere(centre_mm=(-36, -12, 63), radius_mm=25)
        handle = Box(low_mm=(22.5, -20, -1), high_mm=(60, 20, 91))
        face = Box(low_mm=(-20, -20, 138), high_mm=(20, 1, 170))
        holes = Box(low_mm=(-30, -37, 2), high_mm=(30, 6, 13))
        half = HalfSpace(normal=(1, 0.2, 0), offset_mm=5)
        wall = Box(low_mm=(-60, -60, 25), high_mm=(10, 0, 55))
        second += [
            ("bunny", bunny, "head", Region().add(head)),
            ("mug", mug, "handle", Region().add(handle)),
            ("figure_man", figure, "face", Region().add(face)),
            ("kossel_frame_top", kossel, "holes", Region().add(holes)),
            ("bunny", bunny, "hind half", Region().add(half)),
            ("mug", mug, "part of the wall", Region().add(wall)),
        ]
    return first, second


def main():
    """Write the page."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("-o", "--output", type=Path, default=ROOT / "docs" / "regions.md")
    output = parser.parse_args().output
    first, second = tables(shared_models.SHARED / "models")
    rows = [row for name, mesh in first for row in shares(name, mesh)]
    details = [detail(*each) for each in second]
    output.write_text(PAGE.format(shares="\n".join(rows), details="\n".join(details)))


if __name__ == "__main__":
    main()
