"""Writes docs/scaling.md: posts of models where all is so many times as large, as they are at one.

python benches/scaling.py [-o PAGE] [--most SHARE]

Exit code 1: one has more than --most (0.02) more or fewer of them.
"""

import argparse
import sys
from pathlib import Path

import shared_models
from wireprint.mesh import load_mesh
from wireprint.stages import wireframe

sys.path.append(str(shared_models.REPOSITORY / "tests"))
from scaled_machines import scaled

#: Models, and what their own units are in mm.
MODELS = {
    "bunny.stl": 792.372,
    "kossel_effector.stl": 1.0,
    "benchy_lowpoly.stl": 1.0,
    "mug.stl": 857.422,
    "stepped_tower.stl": 2.0,
    "prusa_x_end_idler.stl": 1.0,
}
MACHINES = (("kossel-mini", "abs"), ("prusa-mk4s", "pla"), ("ender-3", "pla"))
FACTORS = (0.5, 0.7, 1.0, 1.5, 2.0)
PAGE = """# From half to twice the size

Written by `python benches/scaling.py`. Model, head, strand, limits and speeds are so many times as
large as they are: what decides is told in strands, tips and limits, so posts stay the same, but
for coordinates that are rounded. Pauses are kept.

| printer | model | {factors} | most off |
|---|---|{rules}--:|
{rows}
"""


def counted(machine, model, size):
    """Posts of a model at every factor."""
    path = shared_models.SHARED / "models" / model
    frames = (wireframe(load_mesh(path, scale=size * f), scaled(machine, f)) for f in FACTORS)
    return [frame.post_count for frame in frames]


def most_off(posts):
    """Largest difference from the posts at one, as a share of them."""
    own = posts[FACTORS.index(1.0)]
    return max(abs(count - own) for count in posts) / max(1, own)


def row(machine, model, posts):
    """One line of the table."""
    counts = " | ".join(map(str, posts))
    return f"| {machine} | {Path(model).stem} | {counts} | {most_off(posts):.1%} |"


def main():
    """Count the posts and write the page."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    target = shared_models.REPOSITORY / "docs" / "scaling.md"
    parser.add_argument("-o", "--output", type=Path, default=target)
    parser.add_argument("--most", type=float, default=0.02, help="share that may differ")
    options = parser.parse_args()
    found = [
        (machine, model, counted(machine, model, size))
        for machine in MACHINES
        for model, size in MODELS.items()
    ]
    rows = "\n".join(row(machine[0], model, posts) for machine, model, posts in found)
    factors = " | ".join(f"×{factor:g}" for factor in FACTORS)
    page = PAGE.format(rows=rows, factors=factors, rules="--:|" * len(FACTORS))
    options.output.write_text(page, encoding="utf-8")
    off = [f"{model} on {machine[0]}" for machine, model, p in found if most_off(p) > options.most]
    sys.exit(f"more than {options.most:.0%} off: {', '.join(off)}" if off else 0)


if __name__ == "__main__":
    main()
