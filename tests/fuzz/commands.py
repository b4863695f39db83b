"""Fuzz the command: ``python tests/fuzz/commands.py --seconds 600 --seed 1``.

Random cases of `inputs` are run, each in a process of its own. Each must do what it is asked for or
refuse it with an exit code of README and an error that names the file or option it is about:
without a traceback, within `LONGEST_S` of processor time, and within `MOST_MB`. The same seed makes
the same cases; those that fail are kept.
"""

from __future__ import annotations

import argparse
import importlib
import os
import resource
import signal
import sys
import tempfile
import time
from collections import Counter
from pathlib import Path

from inputs import Case, Inputs

LONGEST_S = 10.0
#: Of waiting, on a machine that others use.
PATIENCE_S = 120.0
MOST_MB = 1000.0
CODES = {0, 2, 3, 4, 5}
#: What cases import, before a process of their own is split off.
MODULES = [
    "cli",
    "settings",
    "certificate",
    "timing",
    "pipeline",
    "stages",
    "gcode.document",
    "view",
]


def run(case: Case, folder: Path) -> tuple[str, float, float]:
    """Run a case; return what is wrong, the processor time in s and the most memory in MB."""
    child = os.fork()
    if child == 0:
        carry_out(case, folder)
    begin = time.monotonic()
    while True:
        done, status, used = os.wait4(child, os.WNOHANG)
        if done:
            break
        if time.monotonic() - begin > PATIENCE_S:
            os.kill(child, signal.SIGKILL)
        time.sleep(0.003)
    seconds, most_mb = used.ru_utime + used.ru_stime, used.ru_maxrss / 1024
    code = os.waitstatus_to_exitcode(status)
    return wrong_in(case, folder, code, seconds, most_mb), seconds, most_mb


def carry_out(case: Case, folder: Path) -> None:
    """Be the command."""
    try:
        os.chdir(folder)
        for descriptor, name in ((1, "stdout"), (2, "stderr")):
            os.dup2(os.open(name, os.O_WRONLY | os.O_CREAT | os.O_TRUNC), descriptor)
        resource.setrlimit(resource.RLIMIT_CPU, (60, 60))
        from wireprint.cli import main

        sys.argv = ["wireprint", *case.words]
        main()
        sys.stdout.flush()
        os._exit(0)
    except SystemExit as end:
        sys.stdout.flush()
        sys.stderr.flush()
        os._exit(end.code if isinstance(end.code, int) else int(end.code is not None))
    except BaseException:
        import traceback

        traceback.print_exc()
        sys.stderr.flush()
        os._exit(99)


def wrong_in(case: Case, folder: Path, code: int, seconds: float, most_mb: float) -> str:
    """Say what is wrong; empty: nothing."""
    told = (folder / "stderr").read_text(errors="replace")
    if code < 0:
        return f"killed by signal {-code} after {seconds:.1f} s"
    if "Traceback" in told or "fault of wireprint" in told or "panicked" in told:
        return f"traceback or fault: {told.strip().splitlines()[-1][:200]}"
    if seconds > LONGEST_S:
        return f"{seconds:.1f} s"
    if most_mb > MOST_MB:
        return f"{most_mb:.0f} MB"
    if code == 0 or (code == 1 and case.words[0] in ("check", "bench")):
        return ""
    if code not in CODES:
        return f"exit code {code}"
    if not told.startswith(("wireprint: error: ", "Usage")) and case.words[0] != "bench":
        return f"exit code {code} without an error"
    if code != 2 and not any(name in told for name in case.names):
        return f"nothing is named: {told.strip()[:200]}"
    return ""


def main() -> None:
    """Run cases until the time is over."""
    options = argparse.ArgumentParser(description=__doc__)
    options.add_argument("--seconds", type=float, default=60)
    options.add_argument("--seed", type=int, default=1)
    options.add_argument("--first", type=int, default=0, help="number of the first case")
    options.add_argument("--cases", type=int, help="run so many, however long it takes")
    options.add_argument(
        "--keep", type=Path, default=Path(tempfile.gettempdir()) / "wireprint-fuzz"
    )
    asked = options.parse_args()
    for name in MODULES:
        importlib.import_module(f"wireprint.{name}")
    kinds: Counter[str] = Counter()
    failed, longest_s, most_mb = 0, 0.0, 0.0
    with tempfile.TemporaryDirectory() as scratch:
        os.environ["XDG_CACHE_HOME"] = os.environ["XDG_CONFIG_HOME"] = scratch
        folder = Path(scratch) / "work"
        folder.mkdir()
        inputs = Inputs(folder)
        end = time.monotonic() + asked.seconds
        number = asked.first
        while (number < asked.first + asked.cases) if asked.cases else time.monotonic() < end:
            case = inputs.case(f"{asked.seed} {number}")
            files = {n: (folder / n).read_bytes() for n in case.names if (folder / n).is_file()}
            wrong, seconds, peak_mb = run(case, folder)
            kinds[case.kind] += 1
            longest_s, most_mb = max(longest_s, seconds), max(most_mb, peak_mb)
            if wrong:
                failed += 1
                print(
                    f"seed {asked.seed} case {number}: {' '.join(case.words)[:300]}: {wrong}",
                    flush=True,
                )
                kept = asked.keep / f"{asked.seed}-{number}"
                kept.mkdir(parents=True, exist_ok=True)
                for name, content in files.items():
                    (kept / name).write_bytes(content)
            number += 1
    told = ", ".join(f"{kind} {count}" for kind, count in sorted(kinds.items()))
    most = f"at most {longest_s:.1f} s, {most_mb:.0f} MB"
    print(f"{number - asked.first} cases ({told}), {failed} failed; {most}")
    sys.exit(failed > 0)


if __name__ == "__main__":
    main()
