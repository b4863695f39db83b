"""Counts lines of code by module, at one commit or several.

python benches/lines.py [REVISION…]

Code is what is neither blank nor comment, docstring or test; what is generated does not count.
Without a revision: as committed last.
"""

import io
import re
import subprocess
import sys
import tarfile
import tokenize
from collections import Counter
from pathlib import Path

ROOT = Path(__file__).parents[1]
#: Where the product lies, and how deep its modules do below.
FOLDERS = {"rust/core/src": 1, "rust/py/src": 0, "python/wireprint": 1, "web/src": 0}
#: Files that tests alone use.
FOR_TESTS = ("/tests.rs", "lay/scene.rs", "physics/scene.rs")
GENERATED = ("python/wireprint/window/static/", "python/wireprint/studio/static/")


def files(revision):
    """Paths and texts of the product's sources at a revision."""
    command = ["git", "archive", revision, *FOLDERS]
    packed = subprocess.run(command, cwd=ROOT, capture_output=True, check=True).stdout
    with tarfile.open(fileobj=io.BytesIO(packed)) as archive:
        for member in filter(tarfile.TarInfo.isfile, archive):
            name = member.name
            is_source = name.endswith((".rs", ".py", ".pyi", ".ts", ".tsx"))
            if is_source and not name.endswith(FOR_TESTS) and not name.startswith(GENERATED):
                yield name, archive.extractfile(member).read()


def code(name, text):
    """Number of lines of code in a text."""
    if name.endswith((".py", ".pyi")):
        return python_code(text)
    text = text.decode().split("#[cfg(test)]\nmod tests {")[0]
    text = re.sub(r"/\*.*?\*/", "", text, flags=re.S)
    return sum(1 for line in text.splitlines() if re.sub(r"//.*", "", line).strip())


def python_code(text):
    """Number of lines that hold a token which is no comment and no docstring."""
    lines, fresh = set(), True
    skipped = (tokenize.COMMENT, tokenize.NL, tokenize.ENCODING)
    for token in tokenize.tokenize(io.BytesIO(text).readline):
        if token.type in skipped:
            continue
        is_docstring = token.type == tokenize.STRING and fresh
        fresh = token.type in (tokenize.NEWLINE, tokenize.INDENT, tokenize.DEDENT)
        if token.string.strip() and not is_docstring:
            lines.update(range(token.start[0], token.end[0] + 1))
    return len(lines)


def module(name):
    """Module that a file belongs to."""
    folder = next(folder for folder in FOLDERS if name.startswith(folder))
    parts = name.removeprefix(folder + "/").split("/")
    below = [part.split(".")[0] if len(parts) == 1 else part for part in parts[: FOLDERS[folder]]]
    return "/".join([folder, *below]) if len(parts) > 1 or folder == "rust/core/src" else folder


def main():
    """Print a table with a column for each revision."""
    revisions = sys.argv[1:] or ["HEAD"]
    counts = {}
    for revision in revisions:
        counts[revision] = Counter()
        for name, text in files(revision):
            counts[revision][module(name)] += code(name, text)
    print("| module |", " | ".join(revisions), "|")
    print("|---|" + "--:|" * len(revisions))
    for name in sorted(set().union(*counts.values())):
        print(f"| {name} |", " | ".join(str(counts[r][name]) for r in revisions), "|")
    print("| in all |", " | ".join(str(sum(counts[r].values())) for r in revisions), "|")


if __name__ == "__main__":
    main()
