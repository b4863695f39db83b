"""PrusaSlicer's and OrcaSlicer's placeholders, as far as start and end sequences use them.

help.prusa3d.com, "Macros", tells it: names in square brackets or braces, expressions, and
``{if …}…{elsif …}…{else}…{endif}``. What cannot be resolved is left out line by line, and named.
"""

from __future__ import annotations

import re
from typing import TYPE_CHECKING, Final

from wireprint.importing.expressions import Missing, Ours, Unknown, Value, evaluated, is_true

if TYPE_CHECKING:
    from collections.abc import Callable, Collection

#: An expression in braces, or a name in square brackets, perhaps with an index.
_PLACE: Final = re.compile(r"\{([^{}]*)\}|\[([A-Za-z_]\w*?)(?:_(\d+))?\]")
#: Levelling of the bed, with what stands before the area that is meant.
_LEVELS: Final = re.compile(r"\s*G(?:29|80)(?: [A-WZ][\d.]*)*(?=\s|$)")
#: What a slicer shall remember for later: it writes nothing.
_ASSIGNS: Final = re.compile(r"\s*(?:local\s+|global\s+)?\w+\s*(?:\[[^\]]*\])?\s*=(?![=~])")
#: A call of a macro that starts a print, up to a parameter's value.
_PARAMETER: Final = re.compile(
    r"(\s*\w*(?:start|begin|print)\w*(?:\s+\w+=\S+)*)\s+\w+=\S*", re.IGNORECASE | re.ASCII
)
_WORDS: Final = re.compile(r"\s*(if|elsif|else|endif)\b(.*)", re.DOTALL)


def resolved(
    text: str, lookup: Callable[[str, int | None], Value], names: Collection[str]
) -> tuple[list[str], list[str]]:
    """Resolve a sequence.

    Parameters
    ----------
    text
        The sequence, lines and all.
    lookup
        Returns what a name stands for; `Ours` stays a name in braces where it stands by itself.
    names
        Which names of ours the sequence may have; others become numbers.

    Returns
    -------
    lines
        What is left of it, with our own names in braces; all other braces doubled.
    unknown
        Lines that were left out, as they are written.
    """
    lines: list[str] = []
    unknown: list[str] = []
    # Whether what stands in each branch around is wanted, and whether one was taken; None: unknown.
    branches: list[tuple[bool, bool]] = []
    for line in _joined(text):
        parts: list[str] = []
        known, skips, at = True, False, 0
        for found in _PLACE.finditer(_without_comment(line)):
            live = all(wanted for wanted, _ in branches)
            if live:
                between = line[at : found.start()]
                if skips:
                    between, skips = _next_word(between)
                parts.append(between.replace("{", "{{").replace("}", "}}"))
            at = found.end()
            expression = found[1] if found[1] is not None else found[2]
            if found[1] is not None and (word := _WORDS.fullmatch(expression)):
                known = _branch(word[1], word[2], branches, lookup) and known
                continue
            if not live or (found[1] is not None and _ASSIGNS.match(expression)):
                continue
            try:
                if found[1] is None:
                    value = lookup(found[2], int(found[3]) if found[3] else None)
                else:
                    value = evaluated(expression, lookup)
                parts.append(_written(value, names))
            except Unknown:
                # What starts a print does without a parameter that has a default.
                skips = skips or _left_out(parts)
                known = known and skips
        if all(wanted for wanted, _ in branches):
            rest = _next_word(line[at:])[0] if skips else line[at:]
            parts.append(rest.replace("{", "{{").replace("}", "}}"))
        shown = "".join(parts).rstrip()
        if (levels := _LEVELS.match(shown)) and (not known or "_mm}" in shown):
            # An area of which not all is known: then all of the bed is levelled.
            lines.append(levels[0].strip())
        elif known and shown:
            lines.append(shown)
        elif not known:
            unknown.append(line.strip())
    return lines, unknown


def _without_comment(line: str) -> str:
    """Return a line without a comment that holds no part of the language."""
    code, _, comment = line.partition(";")
    return code if "{" not in comment else line


def _joined(text: str) -> list[str]:
    """Return lines, those within braces that span several joined."""
    joined: list[str] = []
    for line in text.splitlines():
        open_before = joined and joined[-1].count("{") > joined[-1].count("}")
        if open_before and len(joined[-1]) < 4000:
            joined[-1] += " " + line.strip()
        else:
            joined.append(line)
    return joined


def _branch(
    word: str,
    condition: str,
    branches: list[tuple[bool, bool]],
    lookup: Callable[[str, int | None], Value],
) -> bool:
    """Go into a branch or out of it; return whether its condition is known."""
    if word == "if":
        branches.append((False, False))
    elif not branches:
        return False
    if word == "endif":
        branches.pop()
        return True
    _, taken = branches.pop()
    outer = all(wanted for wanted, _ in branches)
    if taken or not outer:
        branches.append((False, True))
        return True
    if word == "else":
        branches.append((True, True))
        return True
    try:
        holds = is_true(evaluated(condition, lookup))
    except Unknown:
        # Neither branch is taken where nobody knows which is meant.
        branches.append((False, True))
        return False
    branches.append((holds, holds))
    return True


def _left_out(parts: list[str]) -> bool:
    """Take the name of a macro's parameter from behind a line; return whether there was one."""
    line = "".join(parts)
    found = _PARAMETER.fullmatch(line)
    if found:
        parts[:] = [found[1]]
    return found is not None


def _next_word(text: str) -> tuple[str, bool]:
    """Return a text from its first space on, and whether it has none."""
    at = next((i for i, letter in enumerate(text) if letter.isspace()), None)
    return ("", True) if at is None else (text[at:], False)


def _written(value: Value, names: Collection[str]) -> str:
    if isinstance(value, Ours):
        if value.name in names:
            return f"{{{value.name}}}"
        if value.number is None:
            raise Unknown(value.name)
        value = value.number
    if isinstance(value, Missing):
        raise Unknown(value.name)
    if isinstance(value, str):
        # What a text could add to a program is not wanted.
        if not re.fullmatch(r"[\w .+\-]*", value):
            raise Unknown(value)
        return value
    return f"{float(value):.10g}"
