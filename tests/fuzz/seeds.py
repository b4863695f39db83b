"""Write what libFuzzer starts from: ``python tests/fuzz/seeds.py``.

For each target of `rust/fuzz`, the files that the tests read go into `corpus/TARGET` there, and the
words that they consist of into `TARGET.dict`.
"""

from __future__ import annotations

import random
import re
import sys
import tempfile
from collections import Counter
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parents[1]))

from check_brute import own_lines
from inputs import LINES
from models import PROJECTS
from random_gcode import gcode

from bgcode_files import TEXT, whole
from model_files import DIALECTS
from threemf_files import MODEL, relationships
from wireprint import Settings

FUZZ = Path(__file__).parents[2] / "rust/fuzz"
#: Names of tags, attributes, keys and commands.
WORD = re.compile(rb"[</;]?(?:[A-Za-z_][A-Za-z_:-]+\d*|[GMT]\d+)=?")
MOST_WORDS = 300


def texts() -> list[bytes]:
    """G-code: random prints, and lines that few files have, some at a time."""
    draw, settings = random.Random(1), Settings.load()
    odd = [line.strip() for line in LINES.split("|") if line.strip()]
    found = [TEXT, *("\n".join(odd[i : i + 8]).encode() for i in range(0, len(odd), 8))]
    with tempfile.TemporaryDirectory() as folder:
        ours = own_lines(settings, Path(folder))
    for _ in range(40):
        lines = gcode(draw, settings, ours)[:200]
        lines.insert(draw.randrange(len(lines) + 1), draw.choice(odd))
        found.append("\n".join(lines).encode())
    return found


def seeds() -> dict[str, list[bytes]]:
    """Files for each target; what comes in pieces begins with the length of the pieces."""
    found: dict[str, list[bytes]] = {}
    for suffix, content in DIALECTS.values():
        found.setdefault(suffix, []).append(content)
    found["amf"] = [b"\xff" + content for content in found["amf"] if content[:2] != b"PK"]
    parts = [text for project in PROJECTS for name, text in project.items() if ".gcode" not in name]
    parts.append(
        relationships(f"/{MODEL}", "http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel")
    )
    found["threemf"] = [b"\xff" + text.encode() for text in parts]
    found["xml"] = found["amf"] + found["threemf"]
    found["gcode"] = texts()
    found["bgcode"] = [
        whole(compression, encoding, checked=checked)
        for compression in range(4)
        for encoding in range(3)
        for checked in (True, False)
    ]
    return found


def main() -> None:
    """Write corpora and dictionaries."""
    for target, files in seeds().items():
        folder = FUZZ / "corpus" / target
        folder.mkdir(parents=True, exist_ok=True)
        words: Counter[bytes] = Counter()
        for number, content in enumerate(files):
            (folder / f"seed-{number}").write_bytes(content)
            words.update(word for word in WORD.findall(content) if len(word) < 60)
        kept = sorted(word.decode() for word, _ in words.most_common(MOST_WORDS))
        (FUZZ / f"{target}.dict").write_text("".join(f'"{word}"\n' for word in kept))


if __name__ == "__main__":
    main()
