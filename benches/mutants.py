"""Breaks the heart of the core in random places, one at a time, and tells what no test notices.

python benches/mutants.py [COUNT] [--seed N] [--most SHARE] [--seconds S] [-o FOLDER]

Needs `cargo mutants` (cargo install cargo-mutants), which lists what can be broken, and the extra
`mutants` (tree-sitter). A sample of COUNT breakages is drawn by its seed from all of slices,
toolpath and wireframe. All of them are built at once, into a copy of the core: each is a branch
that is taken where the environment names its number, so that a breakage costs a run of Rust's
tests and no build. Exit code 1: more than --most (0.15) stay alive.
"""

import argparse
import json
import os
import random
import shutil
import subprocess
import sys
from pathlib import Path

import mutant_branches

ROOT = Path(__file__).parents[1]
#: What is broken: the modules that every print goes through.
HEART = ("slices", "toolpath", "wireframe")
#: The tests that guard it, the quickest first; those of the library by their modules.
TESTS = (
    "lib",
    "toolpath",
    "posts_chain",
    "slices_features",
    "strips",
    "wireframe_columns",
    "flat_deck",
    "weave",
    "slices",
    "prints",
)
#: Names the breakage that is to be run.
CHOSEN = mutant_branches.CHOSEN


def listed():
    """All breakages of the heart, in an order that does not depend on the machine."""
    command = ["cargo", "mutants", "--list", "--json", "--package", "wireprint-core"]
    command += [f"--file=rust/core/src/{module}/**/*.rs" for module in HEART]
    done = subprocess.run(command, cwd=ROOT, stdout=subprocess.PIPE, text=True, check=True)
    return sorted(json.loads(done.stdout), key=lambda mutant: mutant["name"])


def copied(folder):
    """Copy what the core is built from; what has not changed keeps its time of change."""
    for name in ("rust", "benches", "Cargo.toml", "Cargo.lock"):
        source = ROOT / name
        for path in sorted(source.rglob("*")) if source.is_dir() else [source]:
            if path.is_file() and path.suffix in (".rs", ".toml", ".lock", ".txt", ".json"):
                mutant_branches.write(folder / path.relative_to(ROOT), path.read_bytes())


def built(folder, target):
    """Build the tests; their executables by name, or the errors as path, line and column."""
    command = ["cargo", "test", "--no-run", "--profile=ci", "--package=wireprint-core"]
    command += ["--message-format=json", "--lib"]
    command += [f"--test={name}" for name in TESTS if name != "lib"]
    environment = os.environ | {"CARGO_TARGET_DIR": str(target)}
    done = subprocess.run(command, cwd=folder, env=environment, stdout=subprocess.PIPE, text=True)
    told = [json.loads(line) for line in done.stdout.splitlines() if line.startswith("{")]
    errors = {
        (span["file_name"], span["line_start"], span["column_start"])
        for message in told
        if message["reason"] == "compiler-message" and message["message"]["level"] == "error"
        for span in message["message"]["spans"]
        if span["is_primary"]
    }
    if not done.returncode:
        found = {m["target"]["name"]: m["executable"] for m in told if m.get("executable")}
        return {"lib" if name == "wireprint_core" else name: path for name, path in found.items()}
    if not errors:
        sys.exit("the core cannot be built")
    return errors


def own_module(mutant):
    """Path of the module that is broken, as its tests are named."""
    path = Path(mutant["file"]).relative_to("rust/core/src").with_suffix("")
    return "::".join(part for part in path.parts if part != "mod") + "::"


def caught(tests, number, folder, seconds, first=()):
    """Name of the first test binary that fails with a breakage; None where all pass.

    The library's tests in the modules `first` come before all others, which take longer.
    """
    environment = os.environ | {CHOSEN: str(number)}
    runs = [("lib", first)] if first else []
    runs += [(name, HEART if name == "lib" else ()) for name in TESTS]
    for name, modules in runs:
        command = [tests[name], "--quiet", *modules]
        try:
            done = subprocess.run(
                command,
                cwd=folder / "rust/core",
                env=environment,
                capture_output=True,
                timeout=seconds,
            )
        except subprocess.TimeoutExpired:
            return "time"
        if done.returncode:
            return name
    return None


def main():
    """Break, test, and tell what stays alive."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("count", nargs="?", type=int, default=200)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--most", type=float, default=0.15, help="share that may stay alive")
    parser.add_argument("--seconds", type=float, default=120, help="longest run of a test binary")
    parser.add_argument("-o", "--output", type=Path, default=ROOT / "target" / "mutants")
    options = parser.parse_args()
    everything = listed()
    drawn = random.Random(options.seed).sample(everything, min(options.count, len(everything)))
    mutants = dict(enumerate(drawn, start=1))
    tree = options.output.absolute() / "tree"
    copied(tree)
    while True:
        mutants = mutant_branches.branch(tree, mutants)
        tests = built(tree, options.output.absolute() / "target")
        if isinstance(tests, dict):
            break
        # What does not compile is no breakage.
        mutants = mutant_branches.without(tree, mutants, tests)
        copied(tree)
    if failed := caught(tests, 0, tree, options.seconds):
        sys.exit(f"{failed} fails with nothing broken")
    alive = []
    for number, mutant in mutants.items():
        by = caught(tests, number, tree, options.seconds, [own_module(mutant)])
        print(f"{by or 'ALIVE':>18}  {mutant['name']}", flush=True)
        alive += [] if by else [mutant["name"]]
    tried = len(mutants)
    share = len(alive) / max(1, tried)
    print("\n".join(["alive:", *alive]) if alive else "none is alive")
    none = len(drawn) - tried
    print(f"{len(alive)} of {tried} alive ({share:.1%}); {none} cannot be made or built")
    shutil.rmtree(tree)
    sys.exit(len(alive) > options.most * tried)


if __name__ == "__main__":
    main()
