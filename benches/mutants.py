"""Breaks the heart of the core in random places, one at a time, and tells what no test notices.

python benches/mutants.py [COUNT] [--seed N] [--jobs N] [--most SHARE] [-o FOLDER]

Needs `cargo mutants` (cargo install cargo-mutants). A sample of COUNT mutants is drawn by its
seed from all of slices, toolpath and wireframe; Rust's own tests are run against each. Each takes a
build of the core: hours for the 200 that count. Exit code 1: more than --most (0.15) stay alive.
"""

import argparse
import json
import random
import re
import subprocess
import sys
from collections import Counter
from pathlib import Path

ROOT = Path(__file__).parents[1]
#: What is broken: the modules that every print goes through.
HEART = ("slices", "toolpath", "wireframe")
FILES = [f"--file=rust/core/src/{module}/**/*.rs" for module in HEART]
#: Verdicts on a mutant that count; what does not compile is no mutant.
CAUGHT, ALIVE = ("CaughtMutant", "Timeout"), "MissedMutant"


def mutants():
    """Names of all mutants of the heart, in an order that does not depend on the machine."""
    command = ["cargo", "mutants", "--list", "--json", "--package", "wireprint-core", *FILES]
    done = subprocess.run(command, cwd=ROOT, stdout=subprocess.PIPE, text=True, check=True)
    return sorted(mutant["name"] for mutant in json.loads(done.stdout))


def sample(names, count, seed):
    """Draw mutants by a seed."""
    return random.Random(seed).sample(names, min(count, len(names)))


def verdicts(names, jobs, folder):
    """Run the tests against each mutant; verdict by name."""
    exactly = "|".join(re.escape(name).replace(r"\ ", " ") for name in names)
    command = ["cargo", "mutants", "--package", "wireprint-core", *FILES, f"--re=^({exactly})$"]
    command += ["--profile=ci", "--no-shuffle", f"--jobs={jobs}", f"--output={folder}"]
    subprocess.run(command, cwd=ROOT)
    told = json.loads((folder / "mutants.out" / "outcomes.json").read_text(encoding="utf-8"))
    return {
        outcome["scenario"]["Mutant"]["name"]: outcome["summary"]
        for outcome in told["outcomes"]
        if "Mutant" in outcome["scenario"]
    }


def main():
    """Break, test, and tell what stays alive."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("count", nargs="?", type=int, default=200)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--jobs", type=int, default=1)
    parser.add_argument("--most", type=float, default=0.15, help="share that may stay alive")
    parser.add_argument("-o", "--output", type=Path, default=ROOT / "target" / "mutants")
    options = parser.parse_args()
    options.output.mkdir(parents=True, exist_ok=True)
    drawn = sample(mutants(), options.count, options.seed)
    found = verdicts(drawn, options.jobs, options.output)
    counts = Counter(found.values())
    alive = sorted(name for name, verdict in found.items() if verdict == ALIVE)
    tried = len(alive) + sum(counts[verdict] for verdict in CAUGHT)
    print("\n".join(["alive:", *alive]) if alive else "none is alive")
    print(f"{len(alive)} of {tried} alive ({len(alive) / max(1, tried):.1%}); {dict(counts)}")
    sys.exit(len(found) < len(drawn) or len(alive) > options.most * tried)


if __name__ == "__main__":
    main()
