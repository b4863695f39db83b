"""Text of others, such as names of files and printers, made fit to be shown."""

from __future__ import annotations


def one_line(text: str) -> str:
    r"""Return a text as one line of printable characters.

    Whatever else is in it (line breaks, control characters that a terminal would obey, marks that
    turn the direction of writing, bytes of a name that are no UTF-8) is shown as an escape.

    Examples
    --------
    >>> one_line("a\nb\x1b[2J")
    'a\\nb\\x1b[2J'
    """
    if text.isprintable():
        return text
    return "".join(map(_shown, text))


def _shown(character: str) -> str:
    if character.isprintable():
        return character
    if "\udc80" <= character <= "\udcff":  # A byte that Python could not decode.
        return f"\\x{ord(character) - 0xDC00:02x}"
    return character.encode("unicode_escape", "backslashreplace").decode("ascii")
