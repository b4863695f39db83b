"""Writes as many models as are wanted, by rules and chance, for `wireprint bench` to go through.

python benches/many.py FOLDER [COUNT] [--seed FIRST]

Each model's folder is its kind: those of `benches/random_shells.py`, of `tests/random_parts.py` and
of `tests/random_solids.py` in turn. A seed is always the same model; what is there already is not
written again. `docs/many.md` tells what came of a run.
"""

import argparse
import sys
from collections import Counter
from pathlib import Path

import trimesh

import random_shells
import shared_models

sys.path.append(str(shared_models.REPOSITORY / "tests"))

import random_parts
import random_solids


def model(seed):
    """Kind and mesh of a seed."""
    if seed % 3 == 0:
        kind, vertices, faces = random_shells.shell(seed)
        return f"shell-{kind}", vertices, faces
    made = random_parts.part(seed) if seed % 3 == 1 else random_solids.solid(seed)
    family = "part" if seed % 3 == 1 else "solid"
    return f"{family}-{made.kind}", *made.mesh()


def main():
    """Write the models."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("folder", type=Path)
    parser.add_argument("count", nargs="?", type=int, default=10_000)
    parser.add_argument("--seed", type=int, default=0)
    options = parser.parse_args()
    kinds = Counter()
    for seed in range(options.seed, options.seed + options.count):
        known = next(options.folder.glob(f"*/{seed:06}.stl"), None)
        if known is not None:
            kinds[known.parent.name] += 1
            continue
        kind, vertices, faces = model(seed)
        kinds[kind] += 1
        target = options.folder / kind / f"{seed:06}.stl"
        target.parent.mkdir(parents=True, exist_ok=True)
        trimesh.Trimesh(vertices, faces, process=False).export(target)
    for kind, count in sorted(kinds.items()):
        print(f"{count:6} {kind}")


if __name__ == "__main__":
    main()
