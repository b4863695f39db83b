"""Tells how much of each module of the core Rust's own tests run through.

python benches/rust_coverage.py [--least SHARE] [--lines] [-- CARGO TEST ARGUMENTS]

Needs LLVM's tools of the compiler's version: rustup's component `llvm-tools`, or `llvm-cov-NN` and
`llvm-profdata-NN` on PATH, as Debian's packages bring them. Only lines of the product count: tests
and what they alone use do not. The heart must be covered to --least (0.9) of its lines; exit code 1
where it is not.
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
#: Where the instrumented tests and what they count are kept.
FOLDER = CORE.parents[1] / "target" / "coverage"
#: Files that tests alone use.
FOR_TESTS = ("/tests.rs", "lay/scene.rs", "physics/scene.rs")


def told(command, **options):
    """What a command prints; ends the program with the command's own words where it fails."""
    done = subprocess.run(command, stdout=subprocess.PIPE, text=True, cwd=CORE, **options)
    if done.returncode:
        sys.exit(f"{command[0]} failed")
    return done.stdout


def tool(name):
    """Path of one of LLVM's tools."""
    compiler = told(["rustc", "-vV"])
    host, major = (
        re.search(rf"{key}: (\w[\w-]*)", compiler)[1] for key in ("host", "LLVM version")
    )
    own = Path(told(["rustc", "--print=sysroot"]).strip(), "lib/rustlib", host, "bin", name)
    return str(own) if own.exists() else shutil.which(f"{name}-{major}") or sys.exit(f"no {name}")


def measured(arguments):
    """Run the tests; how often each line of each file was run, by path below `src`."""
    shutil.rmtree(FOLDER / "counts", ignore_errors=True)
    FOLDER.mkdir(parents=True, exist_ok=True)
    # Dependencies are built as ever: they count nothing.
    wrapper = FOLDER / "rustc"
    wrapper.write_text('#!/bin/sh\nexec "$@" -Cinstrument-coverage\n', encoding="utf-8")
    wrapper.chmod(0o755)
    build = os.environ | {"RUSTC_WORKSPACE_WRAPPER": str(wrapper)}
    run = build | {"LLVM_PROFILE_FILE": str(FOLDER / "counts" / "%m-%p.profraw")}
    command = ["cargo", "test", "--package=wireprint-core", "--profile=ci"]
    command += arguments or ["--tests"]
    rows = told([*command, "--no-run", "--message-format=json"], env=build).splitlines()
    subprocess.run([*command, "--no-fail-fast", "--quiet"], cwd=CORE, env=run, stdout=sys.stderr)
    programs = [json.loads(row).get("executable") for row in rows if row.startswith("{")]
    counts = [str(path) for path in (FOLDER / "counts").glob("*.profraw")]
    merged = str(FOLDER / "counts" / "all.profdata")
    told([tool("llvm-profdata"), "merge", "--sparse", f"--output={merged}", *counts])
    command = [tool("llvm-cov"), "export", "--format=lcov", f"--instr-profile={merged}"]
    objects = [f"--object={program}" for program in programs if program]
    return lines_of(told([*command, *objects]))


def lines_of(lcov):
    """How often each line of the product was run, from LCOV's rows."""
    source, files = CORE / "src", {}
    for record in lcov.split("end_of_record"):
        if not (named := re.search(r"^SF:(.*)$", record, re.M)):
            continue
        path = Path(named[1])
        if not path.is_relative_to(source) or named[1].endswith(FOR_TESTS):
            continue
        product = path.read_text(encoding="utf-8").split("#[cfg(test)]\nmod tests {")[0]
        last = product.count("\n")
        rows = re.findall(r"^DA:(\d+),(\d+)", record, re.M)
        files[path.relative_to(source)] = {int(n): int(c) for n, c in rows if int(n) <= last}
    return files


def module(path):
    """Module that a file is counted under: a folder, within the wireframe a room."""
    parts = path.with_suffix("").parts
    return "/".join(parts[:2] if parts[0] == "wireframe" and len(parts) > 2 else parts[:1])


def main():
    """Print a line a module, and the files of the heart that are covered least."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--least", type=float, default=0.9, help="share of the heart's lines")
    parser.add_argument("--lines", action="store_true", help="name the heart's lines never run")
    parser.add_argument("arguments", nargs="*", help="for cargo test, after --")
    options = parser.parse_args()
    files = measured(options.arguments)
    modules = defaultdict(lambda: [0, 0])
    for path, lines in files.items():
        for name in (module(path), "all", *(["heart"] if path.parts[0] in HEART else [])):
            modules[name][0] += sum(count > 0 for count in lines.values())
            modules[name][1] += len(lines)
    for name, (covered, count) in sorted(modules.items()):
        print(f"{covered / max(1, count):7.1%} {covered:6} of {count:6}  {name}")
    for path, lines in sorted(files.items()):
        missed = [number for number, count in lines.items() if not count]
        share = 1 - len(missed) / max(1, len(lines))
        if path.parts[0] in HEART and (share < options.least or (options.lines and missed)):
            named = " ".join(map(str, missed)) if options.lines else ""
            print(f"{share:7.1%} {path} {named}".rstrip())
    covered, count = modules["heart"]
    sys.exit(covered < options.least * count)


if __name__ == "__main__":
    main()
