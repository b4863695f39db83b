"""What a G-code file of another program says of itself: for which printer it is, and how long."""

from __future__ import annotations

import re
from typing import Final

#: Where slicers write the printer's name: PrusaSlicer and its kin; Cura.
_PRINTER: Final = re.compile(
    rb"^;[ \t]*(?:printer_model|printer_settings_id|TARGET_MACHINE\.NAME)[ \t]*[=:][ \t]*(.+?)\s*$",
    re.MULTILINE,
)
#: Where they write their own estimate: PrusaSlicer, OrcaSlicer; Bambu Studio; Cura, in seconds.
_TIMES: Final = tuple(
    (words, re.compile(pattern, re.MULTILINE))
    for words, pattern in (
        (
            b"estimated printing time",
            rb"^; estimated printing time \(normal mode\) = ([\d dhms]+)$",
        ),
        (b"total estimated time", rb"^;.*total estimated time: ([\d dhms]+)$"),
        (b";TIME:", rb"^;TIME:(\d+(?:\.\d+)?)\s*$"),
    )
)
#: What says more is no estimate, s: thirty years.
_LONGEST_S: Final = 1e9
_UNITS_S: Final = {b"d": 86400, b"h": 3600, b"m": 60, b"s": 1}


def printers_named_in(text: bytes) -> list[str]:
    """Return the printers that a file says it is for, as it writes them."""
    names = [match[1].decode("utf-8", "replace").strip('"') for match in _PRINTER.finditer(text)]
    return list(dict.fromkeys(names))


def known_printer(text: bytes) -> tuple[str, str] | None:
    """Return the profile of the printer that a file names, and that name; None if unknown."""
    from wireprint.lineage import profile_called

    return profile_called(printers_named_in(text))


def stated_time_s(text: bytes) -> float | None:
    """Return how long the program that wrote a file thinks it takes, s; None if it does not say."""
    for words, pattern in _TIMES:
        # To find words takes a hundredth of the time of a search for what is not there.
        if words in text and (match := pattern.search(text)):
            return _seconds(match[1])
    return None


def _seconds(text: bytes) -> float | None:
    parts = re.findall(rb"(\d+)\s*([dhms])", text)
    try:
        if not parts:
            seconds = float(text)
        else:
            seconds = sum(float(number) * _UNITS_S[unit] for number, unit in parts)
    except ValueError:
        return None
    return seconds if seconds <= _LONGEST_S else None
