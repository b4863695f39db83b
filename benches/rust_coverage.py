"""Tells how much of each module of the core Rust's own tests run through.

python benches/rust_coverage.py [--least SHARE] [-- CARGO TEST ARGUMENTS]

Needs `cargo llvm-cov` (cargo install cargo-llvm-cov) and LLVM's tools of the compiler's version:
rustup's component `llvm-tools`, or `llvm-cov-NN` and `llvm-profdata-NN` on PATH. The heart must be
covered to --least (0.9) of its lines; exit code 1 where it is not.
"""

import argparse
import json
import os
import re
import shutil
import subprocess
import sys
from collections import defaultdict
from pathlib import Path

CORE = Path(__file__).parents[1] / "rust" / "core"
#: The modules whose tests guard every print.
HEART = ("slices", "toolpath", "wireframe")


def tools():
    """Environment that names LLVM's tools where rustup's are absent."""
    told = subprocess.run(["rustc", "-vV"], capture_output=True, text=True, check=True).stdout
    major = re.search(r"LLVM version: (\d+)", told)[1]
    named = {"LLVM_COV": f"llvm-cov-{major}", "LLVM_PROFDATA": f"llvm-profdata-{major}"}
    found = {name: path for name, tool in named.items() if (path := shutil.which(tool))}
    return found | dict(os.environ)


def measured(arguments):
    """Run the tests; lines of each file and how many were run, by path below `src`."""
    command = ["cargo", "llvm-cov", "--package", "wireprint-core", "--json", "--summary-only"]
    command += ["--ignore-run-fail", "--profile", "ci", *arguments]
    done = subprocess.run(command, cwd=CORE, env=tools(), stdout=subprocess.PIPE, text=True)
    if done.returncode:
        sys.exit("cargo llvm-cov failed")
    files = json.loads(done.stdout)["data"][0]["files"]
    source = CORE / "src"
    return {
        Path(file["filename"]).relative_to(source): file["summary"]["lines"]
        for file in files
        if Path(file["filename"]).is_relative_to(source)
    }


def module(path):
    """Module that a file is counted under: a folder, within the wireframe a room."""
    parts = path.with_suffix("").parts
    return "/".join(parts[:2] if parts[0] == "wireframe" and len(parts) > 2 else parts[:1])


def main():
    """Print a line a module, and the files of the heart that are covered least."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--least", type=float, default=0.9, help="share of the heart's lines")
    parser.add_argument("arguments", nargs="*", help="for cargo test, after --")
    options = parser.parse_args()
    files = measured(options.arguments)
    modules = defaultdict(lambda: [0, 0])
    for path, lines in files.items():
        for name in (module(path), "all", *(["heart"] if path.parts[0] in HEART else [])):
            modules[name][0] += lines["covered"]
            modules[name][1] += lines["count"]
    for name, (covered, count) in sorted(modules.items()):
        print(f"{covered / max(1, count):7.1%} {covered:6} of {count:6}  {name}")
    low = {path: lines["percent"] / 100 for path, lines in files.items() if path.parts[0] in HEART}
    for path, share in sorted(low.items(), key=lambda pair: pair[1]):
        if share < options.least:
            print(f"{share:7.1%} {path}")
    covered, count = modules["heart"]
    sys.exit(covered < options.least * count)


if __name__ == "__main__":
    main()
