"""What the site is made of besides docs/*.md: pages from code, parts of ARCHITECTURE.

A line ``<!-- section FILE.md: Heading -->`` is replaced by that section of that file,
``<!-- settings -->`` by a table of every setting, ``<!-- command -->`` by the help of each command.
"""

import re
from pathlib import Path
from typing import Any

import click

ROOT = Path(__file__).parents[2]
REPOSITORY = "https://github.com/wireprint/wireprint/blob/main/"


def on_page_markdown(markdown: str, **_: Any) -> str:
    """Fill in what a page takes from elsewhere, and lead out of docs/ to the repository."""
    markdown = re.sub(
        r"^<!-- section ([\w.]+): (.+) -->$",
        lambda found: section(found[1], found[2]),
        markdown,
        flags=re.MULTILINE,
    )
    markdown = markdown.replace("<!-- settings -->", settings())
    markdown = markdown.replace("<!-- command -->", command())
    return re.sub(r"\]\(\.\./([\w./-]+)", rf"]({REPOSITORY}\1", markdown)


def section(name: str, heading: str) -> str:
    """Return what stands under a heading, up to the next one of its level."""
    text = (ROOT / name).read_text(encoding="utf-8")
    found = re.search(rf"^(#+) {re.escape(heading)}$(.*?)(?=^\1 |\Z)", text, re.M | re.S)
    if found is None:
        raise ValueError(f"{name} has no section {heading!r}")
    inner = found[2]
    inner = re.sub(r"\]\(docs/", "](", inner)
    return re.sub(r"\]\((?!http|#)([A-Z]\w*\.md|examples/[\w.]+)", rf"]({REPOSITORY}\1", inner)


def settings() -> str:
    """Return a table of every setting, section by section."""
    from wireprint.settings import describe

    lines: list[str] = []
    last = ""
    for key in describe():
        table, _, name = key.short.rpartition(".")
        table = table or "printer"
        if table != last:
            lines += ["", f"## {table}", ""]
            lines += ["| key | default | unit | bounds | |", "|---|---|---|---|---|"]
            last = table
        cells = (f"`{name}`", key.default_text, key.unit, key.bounds, key.help)
        lines.append("| " + " | ".join(escaped(cell) for cell in cells) + " |")
    return "\n".join(lines)


def escaped(cell: str) -> str:
    """Return text that stays in its cell."""
    text = cell.replace("|", "\\|").replace("\n", " ").replace("<", "&lt;")
    return text if len(text) < 300 else text[:297] + "…"


def command() -> str:
    """Return the help of each command."""
    from wireprint.cli import COMMANDS, main

    parts = []
    with click.Context(main, info_name="wireprint") as above:
        for name in COMMANDS:
            one = main.get_command(above, name)
            with click.Context(one, info_name=name, parent=above, terminal_width=76) as context:
                parts.append(f"## wireprint {name}\n\n```text\n{one.get_help(context)}\n```\n")
    return "\n".join(parts)
