"""Prints random mechanical parts, and tells how many are whole and certified, and what is wrong.

python benches/parts.py [COUNT] [--solids | --fittings] [--seed FIRST]
    [--printer NAME --material NAME] [--kind KIND]

Parts are those of `tests/random_parts.py`, with --solids those of `tests/random_solids.py`, with
--fittings those of `tests/random_fittings.py`, and the rules those of `tests/part_rules.py`; a seed
is always the same part. --stl FOLDER writes the parts that fail, to look at.
"""

import argparse
import multiprocessing
import sys
from collections import Counter, defaultdict
from functools import partial
from pathlib import Path

import numpy as np
import trimesh

import shared_models

sys.path.append(str(shared_models.REPOSITORY / "tests"))

import part_rules
import random_fittings
import random_parts
import random_solids

#: Seeds that are told for each shortcoming.
TOLD = 12


def judged(machine, of_seed, seed):
    """A part and what is wrong with its print; a fault of ours is a shortcoming like others."""
    part = of_seed(seed)
    try:
        return part, part_rules.shortcomings(part, shared_models.roomy(machine))
    except Exception as error:
        return part, [f"failed: {type(error).__name__}: {error}"[:100]]


def told(results):
    """What came of all parts, as lines."""
    sound = sum(not found for _, found in results)
    yield f"{sound} of {len(results)} whole and certified: {sound / max(1, len(results)):.1%}"
    seeds = defaultdict(list)
    for part, found in results:
        for name in found:
            seeds[name].append(part.seed)
    for name, of in sorted(seeds.items(), key=lambda pair: -len(pair[1])):
        rest = " …" if len(of) > TOLD else ""
        yield f"{len(of):5} {name}: seeds {' '.join(map(str, of[:TOLD]))}{rest}"
    parts = Counter(part.kind for part, _ in results)
    failed = Counter(part.kind for part, found in results if found)
    shares = (f"{kind} {failed[kind]}/{parts[kind]}" for kind in sorted(parts))
    yield f"failed by kind: {', '.join(shares)}"


def write(folder, part):
    """Write a part as binary STL."""
    folder.mkdir(parents=True, exist_ok=True)
    vertices, faces = part.mesh()
    solid = trimesh.Trimesh(vertices, np.asarray(faces), process=False)
    solid.export(folder / f"{part.kind}_{part.seed}.stl")


def main():
    """Print the parts and tell what came of them."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("count", nargs="?", type=int, default=100)
    parser.add_argument("--seed", type=int, default=0, help="of the first part")
    parser.add_argument("--printer", default="kossel-mini")
    parser.add_argument("--material", default="abs")
    parser.add_argument("--solids", action="store_true", help="round, slanted and thin shapes")
    parser.add_argument("--fittings", action="store_true", help="gears, clips, trays and the like")
    parser.add_argument("--kind", help="only parts of this kind")
    parser.add_argument("--stl", type=Path, help="folder for the parts that fail")
    parser.add_argument("--jobs", type=int, default=1)
    options = parser.parse_args()
    seeds = range(options.seed, options.seed + options.count)
    of_seed = random_solids.solid if options.solids else random_parts.part
    of_seed = random_fittings.fitting if options.fittings else of_seed
    if options.kind:
        seeds = [seed for seed in seeds if of_seed(seed).kind == options.kind]
    judge = partial(judged, f"{options.printer}/{options.material}", of_seed)
    with multiprocessing.get_context("spawn").Pool(options.jobs) as pool:
        results = list(pool.imap(judge, seeds))
    print("\n".join(told(results)))
    for part, found in results:
        if found and options.stl:
            write(options.stl, part)
    sys.exit(any(found for _, found in results))


if __name__ == "__main__":
    main()
