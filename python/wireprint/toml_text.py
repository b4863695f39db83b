"""TOML as text, each figure with a comment that states its source."""

from __future__ import annotations

import json
from typing import TYPE_CHECKING, Any, Final

if TYPE_CHECKING:
    from collections.abc import Iterator, Mapping

    from wireprint.toml import Key

#: Column in which comments begin, as in the profiles of the package.
_COMMENTS_AT: Final = 28


def written(values: Mapping[str, Any], comments: Mapping[Key, str], head: list[str]) -> str:
    """Write tables as TOML.

    Parameters
    ----------
    values
        Tables of strings, numbers, truth values, lists of these, tables, and lists of tables; what
        is None is left out.
    comments
        What is said about an entry, by its key; one line each.
    head
        Lines of comment at the top.
    """
    lines = [f"# {line}" for line in head]
    return "\n".join([*lines, *_table(values, (), comments)]).strip() + "\n"


def _table(
    values: Mapping[str, Any], prefix: Key, comments: Mapping[Key, str], opening: str = ""
) -> Iterator[str]:
    entries = {key: value for key, value in values.items() if not _is_table(value)}
    present = {key: value for key, value in entries.items() if value is not None}
    if present:
        yield ""
        if prefix:
            yield opening or f"[{'.'.join(prefix)}]"
    for key, value in present.items():
        yield from _entry(key, value, comments.get((*prefix, key), ""))
    for key, value in values.items():
        below = (*prefix, key)
        if isinstance(value, dict):
            yield from _table(value, below, comments)
        elif _is_table(value):
            for one in value:
                yield from _table(one, below, comments, f"[[{'.'.join(below)}]]")


def _is_table(value: Any) -> bool:
    many = isinstance(value, list | tuple) and bool(value)
    return isinstance(value, dict) or (many and all(isinstance(one, dict) for one in value))


def _entry(key: str, value: Any, comment: str) -> Iterator[str]:
    text = f"{key} = {_value(value)}"
    if "\n" in text:
        if comment:
            yield f"# {key}: {comment}"
        yield text
    else:
        yield f"{text:{_COMMENTS_AT - 1}} # {comment}" if comment else text


def _value(value: Any) -> str:
    if isinstance(value, bool):
        return str(value).lower()
    if isinstance(value, float):
        return f"{value:.10g}"
    if isinstance(value, int):
        return str(value)
    if isinstance(value, str):
        return _string(value)
    return f"[{', '.join(map(_value, value))}]"


def _string(text: str) -> str:
    # JSON's escapes are TOML's, too; but for one character it has none.
    quoted = json.dumps(text, ensure_ascii=False).replace("\x7f", "\\u007f")
    if "\n" not in text:
        return quoted
    return '"""\n' + quoted[1:-1].replace("\\n", "\n").replace("\\\n", "\\\\n") + '"""'
