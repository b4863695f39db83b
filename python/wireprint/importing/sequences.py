"""Start and end sequences of others as ours: what a wire print needs of them, and what it does not.

A wire print primes the nozzle by its own skirt. So moves that lay filament are left out of a start
sequence, and with them what leads beside the bed, where only an own wiper or bin would be.
"""

from __future__ import annotations

import re
from typing import TYPE_CHECKING, Final

if TYPE_CHECKING:
    from collections.abc import Iterable

    from wireprint.importing.draft import Draft

#: What any printer can do, where a source's own sequences are not known, or cannot be judged.
PLAIN_END: Final = "\nG90\nG1 Z{park_z_mm} F600\nM104 S0\nM140 S0\nM107\nM84\n"
_PLAIN_START: Final = ("M140 S{bed_c}", "M104 S150", "G28")
_WAITS: Final = ("M190 S{bed_c}", "M109 S{nozzle_c}")
_LEVELS: Final = re.compile(r"^\s*G(?:29|80)\b", re.IGNORECASE | re.MULTILINE)

_WORD: Final = re.compile(r"([A-Za-z])\s*(-?\d*\.?\d+)")
_MOVE: Final = re.compile(r"\s*(?:N\d+\s*)?G0*([0123])\b", re.IGNORECASE)
#: Commands that no sequence of ours wants: they tell slicers or hosts something, or end a file.
_NOT_WANTED: Final = re.compile(
    r"\s*(?:M0|M1|M25|M73|M115|M117|M118|M221|M300|M555|M600|M701|M702|M862\.\d|M1002|M17 [A-Z]\d"
    r"|G92\s+E|T\d+)\b",
    re.IGNORECASE,
)
_HEIGHT: Final = re.compile(r"\s*Z-?[\d.]+", re.IGNORECASE)
_HOMES: Final = re.compile(r"\s*G28\b", re.IGNORECASE)
_NOZZLE_WAITS: Final = re.compile(r"\s*M109\b.*\bS\{?", re.IGNORECASE)
_BED_WAITS: Final = re.compile(r"\s*M190\b", re.IGNORECASE)
_MOST_TOLD: Final = 3
#: Heights below this are where filament is laid, mm.
_LOW_MM: Final = 1.0


def plain_start(other: str = "") -> str:
    """Return a start sequence that heats and homes, and levels where another one does."""
    levels = ["G29"] if _LEVELS.search(other) else []
    return "\n".join(["", *_PLAIN_START, *levels, *_WAITS, ""])


def start_of(lines: Iterable[str], draft: Draft, homes_itself: bool = False) -> str:
    """Return a start sequence with what ours must have.

    Parameters
    ----------
    lines
        The sequence of others, resolved.
    draft
        The bed; remarks on what was left out are added to it.
    homes_itself
        Whether a macro of the printer's does that.
    """
    kept, dropped = [], []
    for line in lines:
        code = line.partition(";")[0].rstrip()
        if not code.strip():
            continue
        if _NOT_WANTED.match(code):
            continue
        if _MOVE.match(code) and _lays_or_leaves(code, draft):
            dropped.append(code.strip())
            continue
        kept.append(code.strip())
    if dropped:
        draft.remark(
            f"gcode.start is without {len(dropped)} moves that lay filament or lead off the bed, "
            f"for the skirt primes the nozzle: {_told(dropped)}"
        )
    if not homes_itself and not any(map(_HOMES.match, kept)):
        kept.insert(0, "G28")
        draft.remark("gcode.start homed nothing: G28 was added")
    if not any("{bed_c}" in line for line in kept):
        kept.insert(0, "M140 S{bed_c}")
    if not any(map(_BED_WAITS.match, kept)):
        kept.append("M190 S{bed_c}")
    waits = [line for line in kept if _NOZZLE_WAITS.match(line)]
    if not waits or "{nozzle_c}" not in waits[-1]:
        kept.append("M109 S{nozzle_c}")
    return "\n" + "\n".join(kept) + "\n"


def end_of(lines: Iterable[str], draft: Draft) -> str:
    """Return an end sequence with what ours must have: it parks above the print, and cools."""
    kept, dropped = [], []
    relative = False
    for line in lines:
        code = line.partition(";")[0].strip()
        if not code or _NOT_WANTED.match(code):
            continue
        if re.match(r"G9[01]\b", code):
            relative = code.startswith("G91")
        if _MOVE.match(code) and "{park_z_mm}" not in code:
            # The head rises to where it parks before all else.
            code = _HEIGHT.sub("", code).strip()
            if not re.search(r"[XYEIJ]", code, re.IGNORECASE):
                continue
            if not relative and _lays_or_leaves(code, draft, ending=True):
                dropped.append(code)
                continue
        kept.append(code)
    if dropped:
        draft.remark(f"gcode.end is without what leads off the bed: {_told(dropped)}")
    if not any("{park_z_mm}" in line for line in kept):
        kept[:0] = ["G90", "G1 Z{park_z_mm} F600"]
    for command in ("M104", "M140"):
        if not any(re.match(rf"{command}\b", line, re.IGNORECASE) for line in kept):
            kept.append(f"{command} S0")
    return "\n" + "\n".join(kept) + "\n"


def tell_left_out(draft: Draft, place: str, key: str, lines: list[str]) -> None:
    """Remark the lines of a sequence that were not understood, of those that matter."""
    lines = [line for line in lines if not _NOT_WANTED.match(line)]
    if lines:
        count = f"{len(lines)} lines that are" if len(lines) > 1 else "a line that is"
        draft.remark(f"{place}: {key} is without {count} not understood: {_told(lines)}")


def _told(lines: list[str]) -> str:
    shown = "; ".join(lines[:_MOST_TOLD])
    return f"{shown}; …" if len(lines) > _MOST_TOLD else shown


def _lays_or_leaves(code: str, draft: Draft, *, ending: bool = False) -> bool:
    """Whether a move feeds filament over a distance, or leads off the bed."""
    words = {letter.upper(): float(value) for letter, value in _WORD.findall(code)}
    moves = "X" in words or "Y" in words
    feeds = words.get("E", 0.0) > 0 and moves and not ending
    # What is that low was to prime the nozzle; the print goes there by itself.
    low_down = words.get("Z", _LOW_MM) < _LOW_MM and not ending
    low, high = bounds_mm(draft)
    outside = any(
        axis in words and not low[i] <= words[axis] <= high[i] for i, axis in enumerate("XY")
    )
    top = draft.get("bed.height_mm")
    too_high = "Z" in words and top is not None and words["Z"] > top
    return feeds or (moves and outside) or too_high or low_down


def bounds_mm(draft: Draft) -> tuple[tuple[float, float], tuple[float, float]]:
    """Return the bed's lowest and highest x and y, mm; all there is where it is not known."""
    bed = draft.get("bed") or {}
    across = bed.get("diameter_mm")
    width, depth = bed.get("width_mm", across), bed.get("depth_mm", across)
    if width is None or depth is None:
        return (-1e9, -1e9), (1e9, 1e9)
    if bed.get("origin") == "centre":
        return (-width / 2, -depth / 2), (width / 2, depth / 2)
    return (0.0, 0.0), (width, depth)
