"""Fuzz the readers of model files and of binary G-code.

Run it as ``python tests/fuzz/models.py --seconds 600 --seed 1``.

Valid files are damaged with their structure in mind: numbers are swapped for extreme ones, counts
are inflated, pieces are cut out, doubled, or spliced in from other files; parts of 3MF files are
damaged before they are packed. A process of its own reads each one. What is not read must be
refused by an error of wireprint's, within `LONGEST_S` and `MOST_MB`. The same seed makes the same
files; those that fail are kept.
"""

from __future__ import annotations

import argparse
import io
import multiprocessing
import random
import re
import resource
import sys
import tempfile
import time
import zipfile
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parents[1]))

from bgcode_files import whole
from model_files import DIALECTS
from struts_files import GRAPHS
from threemf_files import CORE, MODEL, cube_object, item, model

#: Of processor time.
LONGEST_S = 10
#: Of waiting, on a machine that others use.
PATIENCE_S = 120
MOST_MB = 500
MOST_BYTES = 1_000_000
NUMBER = re.compile(rb"-?\d+(?:\.\d+)?(?:[eE][+-]?\d+)?")
NUMBERS = [
    b"0",
    b"-1",
    b"1",
    b"nan",
    b"inf",
    b"1e308",
    b"4294967295",
    b"4294967296",
    b"99999999999",
]
WORDS = [
    b"",
    b" ",
    b"\n",
    b"\r",
    b"\0",
    b"\x1a",
    b"\xff",
    b"\\\n",
    b"#",
    b"<",
    b">",
    b'"',
    b"&",
    b"]]>",
]
CONFIG = (
    '<config><object id="1"><metadata key="name" value="box"/><volume firstid="0" lastid="5"/>'
    '<volume firstid="6" lastid="11">'
    '<metadata key="volume_type" value="ParameterModifier"/></volume>'
    '</object><plate><metadata key="plater_id" value="1"/><model_instance>'
    '<metadata key="object_id" value="1"/><metadata key="instance_id" value="0"/>'
    "</model_instance></plate></config>"
)
SETTINGS = (
    '<config><object id="3"><part id="1" subtype="normal_part"/>'
    '<part id="2" subtype="negative_part"/></object></config>'
)
HELD = (
    '<object id="3"><components><component objectid="1"/><component objectid="2"/></components>'
    "</object>"
)
PAINTED = cube_object(20, attributes={3: 'paint_color="48403"', 5: 'paint_color="DC85"'})
PROJECTS = [
    {MODEL: model(PAINTED, item(1, "5 5 5"))},
    {MODEL: model(cube_object(20)), "Metadata/Slic3r_PE_model.config": CONFIG},
    {
        MODEL: model(cube_object(20) + cube_object(12, 2) + HELD, item(3, "0 0 0")),
        "Metadata/model_settings.config": SETTINGS,
    },
    {MODEL: f'<model xmlns="{CORE}"><resources/><build/></model>', "Metadata/plate_1.gcode": "G28"},
]


def damaged(content: bytes, others: list[bytes], chance: random.Random) -> bytes:
    """Damage a file in one to four places."""
    for _ in range(chance.randint(1, 4)):
        content = chance.choice(DAMAGES)(content, others, chance)[:MOST_BYTES]
    return content


def truncated(content: bytes, _: list[bytes], chance: random.Random) -> bytes:
    return content[: chance.randrange(len(content) + 1)]


def number_swapped(content: bytes, _: list[bytes], chance: random.Random) -> bytes:
    found = list(NUMBER.finditer(content))
    if not found:
        return content
    hit = chance.choice(found)
    new = chance.choice([*NUMBERS, chance.choice(found).group()])
    return content[: hit.start()] + new + content[hit.end() :]


def bytes_set(content: bytes, _: list[bytes], chance: random.Random) -> bytes:
    if not content:
        return content
    place, length = chance.randrange(len(content)), chance.choice([1, 2, 4, 8])
    new = chance.choice([b"\0" * length, b"\xff" * length, chance.randbytes(length)])
    return content[:place] + new + content[place + length :]


def spliced(content: bytes, others: list[bytes], chance: random.Random) -> bytes:
    other = chance.choice(others)
    begin, place = chance.randrange(len(other) + 1), chance.randrange(len(content) + 1)
    return content[:place] + other[begin : begin + chance.randint(1, 200)] + content[place:]


def cut_or_doubled(content: bytes, _: list[bytes], chance: random.Random) -> bytes:
    begin = chance.randrange(len(content) + 1)
    end = min(begin + chance.randint(1, 120), len(content))
    times = chance.choice([0, 2, 3, 50, 2000])
    return content[:begin] + content[begin:end] * times + content[end:]


def word_put_in(content: bytes, _: list[bytes], chance: random.Random) -> bytes:
    place = chance.randrange(len(content) + 1)
    return content[:place] + chance.choice(WORDS) + content[place + chance.randint(0, 2) :]


DAMAGES = [
    truncated,
    number_swapped,
    number_swapped,
    bytes_set,
    spliced,
    cut_or_doubled,
    word_put_in,
]


def made(chance: random.Random) -> tuple[str, bytes]:
    """Make a damaged file: suffix and content."""
    if chance.random() < 0.35:
        return "3mf", packed(chance)
    if chance.random() < 0.1:
        ways = (whole(chance.randrange(4), chance.randrange(3), checked=False) for _ in range(2))
        return "bgcode", damaged(next(ways), [next(ways)], chance)
    if chance.random() < 0.1:
        kind = chance.choice(sorted(GRAPHS))
        return f"struts.{kind}", damaged(GRAPHS[kind], list(GRAPHS.values()), chance)
    suffix, content = chance.choice(list(DIALECTS.values()))
    others = [other for kind, other in DIALECTS.values() if kind == suffix]
    return suffix, damaged(content, others, chance)


def packed(chance: random.Random) -> bytes:
    """Pack a 3MF file, damaged within its parts, and now and then as a whole."""
    parts = {name: text.encode() for name, text in chance.choice(PROJECTS).items()}
    others = [text.encode() for project in PROJECTS for text in project.values()]
    name = chance.choice(sorted(parts))
    parts[name] = damaged(parts[name], others, chance)
    file = io.BytesIO()
    with zipfile.ZipFile(file, "w", zipfile.ZIP_DEFLATED) as archive:
        for key in parts:
            archive.writestr(zipfile.ZipInfo(key, (1980, 1, 1, 0, 0, 0)), parts[key])
    content = file.getvalue()
    return bytes_set(content, others, chance) if chance.random() < 0.2 else content


def serve(pipe: multiprocessing.connection.Connection) -> None:
    """Read the files that are named, and tell what became of each."""
    from wireprint._core import FaultError, WireprintError
    from wireprint.gcode.source import read
    from wireprint.model import load_model
    from wireprint.struts import read_struts

    while (path := pipe.recv()) is not None:
        begin = time.process_time()
        try:
            reader = read_struts if ".struts." in path else load_model
            (read if path.endswith(".bgcode") else reader)(path)
            said = "read"
        except FaultError as error:
            said = f"FAULT {error}"
        except WireprintError as error:
            said = "refused" if path in str(error) else f"FAULT names no file: {error}"
        except BaseException as error:
            said = f"FAULT {type(error).__name__}: {error}"
        # Kilobytes, on Linux.
        peak_mb = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024
        pipe.send((said, peak_mb, time.process_time() - begin))


def started() -> tuple[multiprocessing.Process, multiprocessing.connection.Connection]:
    context = multiprocessing.get_context("spawn")
    ours, theirs = context.Pipe()
    worker = context.Process(target=serve, args=(theirs,), daemon=True)
    worker.start()
    theirs.close()
    return worker, ours


def main() -> int:
    options = argparse.ArgumentParser(description=__doc__)
    options.add_argument("--seconds", type=float, default=60)
    options.add_argument("--seed", type=int, default=1)
    options.add_argument(
        "--keep", type=Path, default=Path(tempfile.gettempdir()) / "wireprint-fuzz"
    )
    given = options.parse_args()
    given.keep.mkdir(parents=True, exist_ok=True)
    counts: dict[str, int] = {}
    longest_s, most_mb, failed, number = 0.0, 0.0, 0, 0
    worker, pipe = started()
    end = time.monotonic() + given.seconds
    while time.monotonic() < end:
        suffix, content = made(random.Random(f"{given.seed} {number}"))
        path = given.keep / f"{given.seed}-{number}.{suffix}"
        path.write_bytes(content)
        pipe.send(str(path))
        try:
            said, peak_mb, took_s = pipe.recv() if pipe.poll(PATIENCE_S) else ("HANG", 0.0, 0.0)
        except EOFError:
            said, peak_mb, took_s = "CRASH", 0.0, 0.0
        longest_s, most_mb = max(longest_s, took_s), max(most_mb, peak_mb)
        said = said if peak_mb <= MOST_MB else f"MEMORY {peak_mb:.0f} MB"
        said = said if took_s <= LONGEST_S else f"SLOW {took_s:.1f} s"
        kind = said.split()[0]
        counts[f"{suffix} {kind}"] = counts.get(f"{suffix} {kind}", 0) + 1
        if kind in ("read", "refused"):
            path.unlink()
        else:
            failed += 1
            print(f"{path}: {said}", flush=True)
            worker.kill()
            worker.join()
            worker, pipe = started()
        number += 1
    pipe.send(None)
    print(f"{number} files, {failed} failed; longest {longest_s:.2f} s, peak {most_mb:.0f} MB")
    print(", ".join(f"{name}: {count}" for name, count in sorted(counts.items())))
    return min(failed, 1)


if __name__ == "__main__":
    sys.exit(main())
