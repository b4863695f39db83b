"""Writes docs/placement.md: our placement of posts beside the paper's averaging rule.

python benches/placement.py [-o PAGE]
"""

import argparse
from pathlib import Path

import numpy as np

import shared_models
from wireprint import examples
from wireprint.mesh import load_mesh
from wireprint.pipeline import make
from wireprint.settings import Settings

ROOT = Path(__file__).resolve().parent.parent
PAGE = """# Where posts stand: our rule beside the paper's

Written by `python benches/placement.py`. The paper (#3) averages even spacing with the points of
the slice below; ours is the cheapest chain of candidates (algorithms.md). Defaults of
`kossel-mini` and `abs`, 3–4 mm slabs for both, so that only the placement differs.

| model | rule | posts | alignment, mm | unevenness | deviation, mm | as chords, mm | breaches |
|---|---|--:|--:|--:|--:|--:|--:|
{rows}

- **alignment**: mean horizontal distance from a post's base to the nearest peak below it.
- **unevenness**: standard deviation of the distance between neighbouring peaks of a contour over
  its mean, averaged over the contours.
- **deviation**: mean distance of the strands from the surface, as commanded and as the chords
  between supports.
"""


def alignment_mm(posts, places):
    """Mean horizontal distance of bases from the peaks of the slab below, mm."""
    offsets = []
    for slab in np.unique(places[:, 0])[1:]:
        bases = posts[places[:, 0] == slab, 0, :2]
        peaks = posts[places[:, 0] == slab - 1, 1, :2]
        if len(peaks):
            offsets.append(np.linalg.norm(bases[:, None] - peaks[None], axis=2).min(axis=1))
    return float(np.concatenate(offsets).mean())


def unevenness(posts, places):
    """Coefficient of variation of the spacing of peaks, averaged over the contours."""
    values = []
    for key in np.unique(places, axis=0):
        peaks = posts[(places == key).all(axis=1), 1, :2]
        if len(peaks) > 3:
            gaps = np.linalg.norm(np.diff(peaks, axis=0, append=peaks[:1]), axis=1)
            values.append(gaps.std() / gaps.mean())
    return float(np.mean(values))


def row(name, mesh, rule):
    """One line of the table."""
    settings = Settings.load(
        overrides=[f"wire.placement={rule}", "wire.slab_min_mm=3", "wire.slab_max_mm=4"]
    )
    printed = make(mesh, settings, partial=True)
    wire, found = printed.wireframe, printed.figures()
    posts, places = wire.posts, wire.post_places
    breaches = sum(found["breaches"].values())
    return (
        f"| {name} | {'ours' if rule == 'optimal' else 'paper'} | {len(posts)} "
        f"| {alignment_mm(posts, places):.2f} | {unevenness(posts, places):.2f} "
        f"| {found['deviation_mm']:.3f} | {found['chord_deviation_mm']:.3f} | {breaches} |"
    )


def meshes():
    """The package's own models, and shared ones where they are at hand."""
    import tempfile

    with tempfile.TemporaryDirectory() as folder:
        for name in ("bottle", "sphere", "cube"):
            path = Path(folder) / f"{name}.stl"
            path.write_bytes(examples.stl(name))
            yield name, load_mesh(path)
    models = shared_models.SHARED / "models"
    if models.is_dir():
        yield "bunny", load_mesh(models / "bunny.stl", scale=792.372)
        yield "duck", load_mesh(models / "duck.stl", scale=937.142)


def main():
    """Write the page."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("-o", "--output", type=Path, default=ROOT / "docs" / "placement.md")
    output = parser.parse_args().output
    rows = [row(name, mesh, rule) for name, mesh in meshes() for rule in ("paper", "optimal")]
    output.write_text(PAGE.format(rows="\n".join(rows)))


if __name__ == "__main__":
    main()
