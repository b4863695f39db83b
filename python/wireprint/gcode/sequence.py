"""Start and end sequences: G-code with names in braces, and no more of a language than that."""

from __future__ import annotations

import re
from typing import TYPE_CHECKING, Final

if TYPE_CHECKING:
    from collections.abc import Collection, Mapping

#: A doubled brace; a name, perhaps with digits after the point (``.1f``) or none (``d``); any other
#: brace.
_PLACE: Final = re.compile(r"(\{\{|\}\})|\{(\w+)(?::(?:\.([0-6])f|(d)))?\}|[{}]")
_MOST_SHOWN: Final = 30
#: The rectangle that the print covers, mm.
EDGE_NAMES: Final = ("min_x_mm", "min_y_mm", "max_x_mm", "max_y_mm")
#: What a start sequence may name: temperatures, °C, and the rectangle that the print covers.
START_NAMES: Final = ("nozzle_c", "bed_c", *EDGE_NAMES)
#: What an end sequence may name: a height above the print.
END_NAMES: Final = ("park_z_mm",)


def check(text: str, names: Collection[str]) -> None:
    """Refuse a sequence that cannot be filled in, or does not look as what it does.

    Parameters
    ----------
    text
        The sequence.
    names
        What may stand in braces.

    Raises
    ------
    ValueError
        It has braces around something else, or control characters.
    """
    for found in _PLACE.finditer(text):
        if found[1] is None and found[2] not in names:
            known = ", ".join(f"{{{name}}}" for name in names)
            shown = text[found.start() :].partition("\n")[0][:_MOST_SHOWN]
            msg = (
                f"{shown!r} is no name in braces; there are {known}, with digits as in "
                f"{{{next(iter(names))}:.1f}}; double braces that are meant as such"
            )
            raise ValueError(msg)
    for character in text:
        if not character.isprintable() and character not in "\n\r\t":
            msg = f"it holds {character!r}, which is no character of a text"
            raise ValueError(msg)


def filled(text: str, numbers: Mapping[str, float]) -> str:
    """Put numbers in the place of names in a sequence that was checked.

    Whole numbers are written as such, others with three digits after the point, unless the
    sequence says how many.

    Examples
    --------
    >>> filled("G1 Z{park_z_mm:.1f} ; {{up}}", {"park_z_mm": 12.25})
    'G1 Z12.2 ; {up}'
    """

    def written(found: re.Match[str]) -> str:
        if found[1] is not None:
            return found[1][0]
        number = numbers[found[2]]
        default = 0 if found[4] or isinstance(number, int) else 3
        return f"{number:.{found[3] or default}f}"

    return _PLACE.sub(written, text)
