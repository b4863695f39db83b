"""The glossary explains the names of the files, and names files that are there."""

import re
from pathlib import Path

ROOT = Path(__file__).parents[1]
CORE = ROOT / "rust/core/src"
GLOSSARY = (ROOT / "docs/glossary.md").read_text(encoding="utf-8")
#: Folders whose files are named by the words of the trade.
NAMED = [CORE / "wireframe", CORE / "slices", CORE / "toolpath", ROOT / "python/wireprint/hybrid"]
#: Words that say what they are: of any program, of geometry, or of what is printed.
PLAIN = {
    "bed",
    "build",
    "context",
    "cost",
    "costs",
    "cut",
    "features",
    "frame",
    "heights",
    "interval",
    "layers",
    "lines",
    "mechanics",
    "order",
    "params",
    "path",
    "plan",
    "plane",
    "pressure",
    "profile",
    "ranks",
    "search",
    "sliced",
    "tuning",
    "outlines",
    "columns",
    "on_layers",
    "run",
}


def rows():
    """Words of the glossary's tables, and the files that are named beside them."""
    for word, where in re.findall(r"^\| ([^|]+) \|[^|]+\| ([^|]+) \|$", GLOSSARY, re.M):
        yield word.replace("*", ""), re.findall(r"`([^`]+)`", where)


def test_files_of_the_glossary_are_there():
    for word, files in rows():
        for name in files:
            path = ROOT / name if name.startswith("python/") else CORE / name
            assert path.exists() or path.with_suffix(".rs").exists(), f"{word}: {name}"


def test_names_of_files_are_explained():
    known = {word.replace(" ", "_") for word, _ in rows()} | PLAIN
    files = {Path(name).stem for _, names in rows() for name in names}
    unknown = sorted(
        str(path.relative_to(ROOT))
        for folder in NAMED
        for path in folder.rglob("*.*")
        if path.suffix in (".rs", ".py") and path.stem not in ("mod", "tests", "__init__", "scene")
        if path.stem not in known | files and path.stem.removesuffix("s") not in known
    )
    assert unknown == []
