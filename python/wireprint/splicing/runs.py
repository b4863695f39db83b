"""Runs of a wire's moves between another program's lines, and the ways there and back."""

from __future__ import annotations

import itertools
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Final

import numpy as np

from wireprint import _core
from wireprint._core import KINDS, Toolpath
from wireprint.alongside import SAME_MM

if TYPE_CHECKING:
    from collections.abc import Iterator, Sequence

    import numpy.typing as npt

    from wireprint.settings import Settings
    from wireprint.verdict import Point

    Floats = npt.NDArray[np.float64]

_TRAVEL, _RETRACT, _UNRETRACT = (KINDS.index(name) for name in ("travel", "retract", "unretract"))
#: Kinds that no wire between layers needs: the nozzle was primed before, and the bed has its own.
_PRIMING: Final = ("skirt", "brim")
_COLUMNS: Final = ("to", "kind", "speed", "filament", "pause", "air", "slab")


@dataclass(frozen=True)
class Run:
    """Moves of the wire that follow one line of the other file."""

    #: Number of lines before it.
    line: int
    #: The first move, and the one after the last.
    moves: tuple[int, int]
    #: Height of all that stands when it begins, mm.
    top_mm: float


def without_priming(path: Toolpath) -> Toolpath:
    """Leave out skirt and brim, and what leads there and away."""
    leave = {KINDS.index(name) for name in _PRIMING}
    kinds = path.kind
    strands = np.flatnonzero(_is_strand(kinds))
    kept = [int(number) for number in strands if int(kinds[number]) not in leave]
    return path if not kept else _part(path, _first_of(path, kept[0]), len(path))


def _is_strand(kinds: npt.NDArray[np.uint8]) -> npt.NDArray[np.bool_]:
    found: npt.NDArray[np.bool_] = ~np.isin(kinds, (_TRAVEL, _RETRACT, _UNRETRACT))
    return found


def _first_of(path: Toolpath, strand: int) -> int:
    """Return the move with which a strand's way begins: what follows the strand before it."""
    before = np.flatnonzero(_is_strand(path.kind[:strand]))
    return int(before[-1]) + 1 if len(before) else 0


def _part(path: Toolpath, first: int, end: int) -> Toolpath:
    """Return some moves of a toolpath, from where the head then is."""
    start = path.to[first - 1] if first else np.array(path.start)
    return Toolpath.from_arrays(
        start=tuple(start.tolist()),
        **{name: getattr(path, name)[first:end] for name in _COLUMNS},
    )


def runs_of(path: Toolpath, core: _core.Certificate, lines: Sequence[bytes]) -> Iterator[Run]:
    """Tell after which line each part of a slab comes; parts that follow each other are one run.

    A zigzag comes before the layers beside it hide its foot. What lies on top of it, a contour or a
    deck, waits for the layers of its own height: some of its strands end on them.
    """
    tops = core.strands[..., 2].max(axis=1)
    run: Run | None = None
    for first, end, level in _parts(path):
        # A strand lies below a part if the part can stand on it: half a step of rounding aside.
        above = np.flatnonzero(tops > level + SAME_MM)
        count = int(above[0]) if len(above) else len(tops)
        line = int(core.strand_lines[count - 1]) if count else _prepared(core, lines)
        top = max(tops[:count].max(initial=0.0), path.to[:first, 2].max(initial=0.0))
        if run is not None and run.line == line:
            run = Run(line, (run.moves[0], end), run.top_mm)
            continue
        if run is not None:
            yield run
        run = Run(line, (first, end), float(top))
    if run is not None:
        yield run


def _parts(path: Toolpath) -> Iterator[tuple[int, int, float]]:
    """Return the parts of slabs: the first strand, the move after the last one, and the foot, mm.

    The level strands that come last in a slab are a part of their own.
    """
    strands = np.flatnonzero(_is_strand(path.kind))
    from_z = np.concatenate([[path.start[2]], path.to[:-1, 2]])[strands]
    heights = np.column_stack([from_z, path.to[strands, 2]])
    rises = np.ptp(heights, axis=1) > SAME_MM
    slabs = path.slab[strands]
    bounds = np.flatnonzero(np.diff(slabs, prepend=slabs[:1] + 1, append=slabs[-1:] + 1))
    for begin, end in itertools.pairwise(bounds.tolist()):
        level = end - int(rises[begin:end][::-1].argmax()) if rises[begin:end].any() else begin
        for first, last in ((begin, level), (level, end)):
            if first < last:
                foot = float(heights[first:last].min())
                yield int(strands[first]), int(strands[last - 1]) + 1, foot


def _from(path: Toolpath, move: int) -> Floats:
    return path.to[move - 1] if move else np.array(path.start)


def _prepared(core: _core.Certificate, lines: Sequence[bytes]) -> int:
    """Return the number of lines before the first layer, where nothing lies below the wire."""
    first = int(core.strand_lines[0])
    for number, line in enumerate(lines[:first]):
        if line.startswith((b";LAYER_CHANGE", b";LAYER:0", b"; CHANGE_LAYER")):
            return number
    return first - 1


def led(path: Toolpath, run: Run, at: Point, more: bool, settings: Settings) -> Toolpath:
    """Return a run's moves, with the way from the other program's last place and back to it.

    Back only where that prints any `more`: else the head merely rises.
    """
    first, end = run.moves
    last = first + int(np.flatnonzero(_is_strand(path.kind[first:end]))[-1])
    extruder, travel = settings.printer.extruder, settings.printer.speeds.travel_mm_s
    lift = settings.wire.travel_lift_mm
    part = _part(path, first, last + 1)
    begin, finish = _from(path, first), path.to[last]
    over = max(run.top_mm, at[2]) + lift
    back_over = max(run.top_mm, float(part.to[:, 2].max()), at[2]) + lift
    begun = _way(np.array(at), begin, max(over, float(begin[2])))
    ended = _way(finish, np.array(at), back_over)[: None if more else 1]
    pull = [] if extruder.retract_mm == 0 else [-extruder.retract_mm]
    sides = []
    for place, leads, slab, primes in (
        (np.array(at), begun, part.slab[0], True),
        (finish, ended, part.slab[-1], more),
    ):
        rows = [(place, _RETRACT, extruder.retract_speed_mm_s, mm) for mm in pull]
        rows += [(to, _TRAVEL, travel, 0.0) for to in leads]
        if primes:
            rows += [(leads[-1], _UNRETRACT, extruder.unretract_speed_mm_s, -mm) for mm in pull]
        sides.append(_arrays(rows, int(slab)))
    joined = {
        name: np.concatenate([sides[0][name], getattr(part, name), sides[1][name]])
        for name in _COLUMNS
    }
    return Toolpath.from_arrays(start=at, **joined)


def _way(start: Floats, end: Floats, over_mm: float) -> list[Floats]:
    """Return the corners of a way over all that stands."""
    return [np.array([*start[:2], over_mm]), np.array([*end[:2], over_mm]), end]


def _arrays(rows: Sequence[tuple[Floats, int, float, float]], slab: int) -> dict[str, Any]:
    to, kind, speed, filament = zip(*rows, strict=True)
    return {
        "to": np.array(to),
        "kind": np.array(kind, np.uint8),
        "speed": np.array(speed, float),
        "filament": np.array(filament, float),
        "pause": np.zeros(len(rows)),
        "air": np.zeros(len(rows), bool),
        "slab": np.full(len(rows), slab, np.uint32),
    }
