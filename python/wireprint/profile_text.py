"""A profile's text with all that it inherits written out, sources included."""

from __future__ import annotations

import re
from typing import TYPE_CHECKING, Any, Final

from wireprint.lineage import generations
from wireprint.toml import merge
from wireprint.toml_text import written

if TYPE_CHECKING:
    from wireprint import catalogue
    from wireprint.toml import Key

#: A comment behind an entry of one line.
_BEHIND: Final = re.compile(r"""(?:"[^"]*"|'[^']*'|[^#"'])*#\s*(.*)""")


def whole(kind: catalogue.Kind, name: str) -> list[str]:
    """Return the lines of a profile that says by itself what it and its elders say together.

    Parameters
    ----------
    kind, name
        As for `catalogue.find`.
    """
    family = generations(kind, name)
    if len(family) == 1:
        return family[0].text.splitlines()
    head: list[str] = []
    values: dict[str, Any] = {}
    comments: dict[Key, str] = {}
    for file in family:
        lines = file.text.splitlines()
        first = next((i for i, line in enumerate(lines) if not line.startswith("#")), len(lines))
        head = [line.lstrip("# ").rstrip() for line in lines[:first]] + head
        merge(values, file.table)
        for key, number in file.lines.items():
            found = _BEHIND.fullmatch(lines[number - 1])
            comments[key] = found[1] if found else ""
    return written(values, comments, head).splitlines()
