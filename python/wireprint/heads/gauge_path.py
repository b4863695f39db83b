"""The moves of a gauge: rows of teeth, then fences whose roofs rise like stairs.

**Teeth** are one zigzag on a strip: posts of one height. Beside each post the head comes down, at
such a distance that a flank of the tooth's angle would just touch it: from directions 15° apart,
for nozzles have six sides.

**A fence** is a row of rails with roofs between them; with each step fewer of them grow, those
further along. So the tip is low beside roofs that are all as high as the one that is tried, or
lower, and what is hit first is the lowest that can be. The head slides past on both sides; of two
fences one stands across.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Final

import numpy as np

from wireprint import _core
from wireprint._core import KINDS

if TYPE_CHECKING:
    from collections.abc import Callable

    from wireprint._core import Toolpath
    from wireprint.heads.gauge import Gauge
    from wireprint.settings import Settings

    Point = tuple[float, float, float]
    #: From a row's own x and y to the gauge's.
    Frame = Callable[[float, float], tuple[float, float]]

_TRAVEL, _POST, _DIAGONAL = (KINDS.index(kind) for kind in ("travel", "post", "diagonal"))
_CONTOUR, _SKIRT = KINDS.index("contour"), KINDS.index("skirt")
_RETRACT, _UNRETRACT = KINDS.index("retract"), KINDS.index("unretract")
#: Directions from a tooth to where the tip comes down, degrees.
DIRECTIONS: Final = (75, 90, 105, 255, 270, 285)
#: How long the tip stays beside a tooth, s: long enough for a hot flank to leave its mark.
STAYS_S: Final = 1.0
#: Teeth in a row.
IN_A_ROW: Final = 5
#: A strip is three lines wide and reaches so many strands beyond its posts.
STRIP_LINES, STRIP_BEYOND = (-1, 0, 1), 3


@dataclass
class Path:
    """Moves under way, in mm from the middle of what is laid."""

    settings: Settings
    moves: list[tuple[Point, int, float, float, float, bool]] = field(default_factory=list)
    at: Point = (0.0, 0.0, 0.0)
    #: Height of all that stands, mm.
    top: float = 0.0
    #: Number of the level that is printed.
    slab: int = 0
    slabs: list[int] = field(default_factory=list)
    #: Whether the filament is at the nozzle's end, not drawn up.
    full: bool = False

    def _add(
        self, to: Point, kind: int, speed: float, *, filament: float = 0, pause: float = 0
    ) -> None:
        air = kind in (_POST, _DIAGONAL, _CONTOUR)
        self.moves.append((to, kind, speed, filament, pause, air))
        self.slabs.append(self.slab)
        self.at = to

    def go(self, to: Point, *, prints: bool = True) -> None:
        """Travel over all that stands, and down; the filament drawn up meanwhile."""
        printer = self.settings.printer
        extruder, speed = printer.extruder, printer.speeds.travel_mm_s
        over = max(self.top + self.settings.wire.travel_lift_mm, to[2])
        if self.moves:
            if self.at[2] < over:
                self._retract()
            self._add((*self.at[:2], over), _TRAVEL, speed)
        self._add((*to[:2], over), _TRAVEL, speed)
        self._add(to, _TRAVEL, speed)
        if prints and extruder.retract_mm:
            self._add(to, _UNRETRACT, extruder.unretract_speed_mm_s, filament=extruder.retract_mm)
            self.full = True

    def _retract(self) -> None:
        extruder = self.settings.printer.extruder
        if self.full:
            self._add(self.at, _RETRACT, extruder.retract_speed_mm_s, filament=-extruder.retract_mm)
        self.full = False

    def strand(
        self,
        to: Point,
        kind: int,
        *,
        pause: bool = False,
        pause_s: float | None = None,
        share: float = 1.0,
    ) -> None:
        """Lay a strand to a place, at a share of its speed, and stay there until it holds.

        `pause_s` is how long, where that is not the settings' pause.
        """
        settings = self.settings
        length = math.dist(self.at, to)
        area = (settings.strand_mm / settings.printer.extruder.filament_diameter_mm) ** 2
        speed = settings.first_layer_mm_s if kind == _SKIRT else settings.print_mm_s
        held = settings.pause_s if pause else 0.0
        held = held if pause_s is None else pause_s
        self._add(to, kind, share * speed, filament=length * area, pause=held)
        self.top = max(self.top, to[2])

    def touch(self, at: Point, along: Point | None = None) -> None:
        """Lower the tip beside what is to be tried, stay or slide, and rise again."""
        self.go(at, prints=False)
        slow = self.settings.first_layer_mm_s
        self._add(along or at, _TRAVEL, slow, pause=STAYS_S)

    def toolpath(self, *, centred: bool = True) -> Toolpath:
        """Return the moves, in the middle of the bed, or where they were laid."""
        to = np.array([move[0] for move in self.moves])
        if centred:
            low, high = to[:, :2].min(axis=0), to[:, :2].max(axis=0)
            to[:, :2] += np.array(self.settings.printer.bed.centre_mm) - (low + high) / 2
        columns = list(zip(*self.moves, strict=True))
        return _core.Toolpath.from_arrays(
            start=tuple(to[0].tolist()),
            to=to,
            kind=np.array(columns[1], np.uint8),
            speed=np.array(columns[2], float),
            filament=np.array(columns[3], float),
            pause=np.array(columns[4], float),
            air=np.array(columns[5], bool),
            slab=np.array(self.slabs, np.uint32),
        )

    @property
    def extent_mm(self) -> tuple[float, float]:
        """Extent of all moves along x and y."""
        to = np.array([move[0] for move in self.moves])
        width, depth = np.ptp(to[:, :2], axis=0).tolist()
        return width, depth


def drawn(gauge: Gauge, settings: Settings, fences: int, roofs: int) -> Path:
    """Return the moves of a gauge with so many fences of so many roofs."""
    path = Path(settings)
    base = settings.first_layer_height_mm
    tip = base + gauge.head.nozzle_mm / 2
    pitch = gauge.pitch_mm
    farthest = gauge.beside_tooth_mm(gauge.teeth_deg[0])
    rows = [gauge.teeth_deg[i : i + IN_A_ROW] for i in range(0, len(gauge.teeth_deg), IN_A_ROW)]
    places = [(0.0, -(farthest + pitch) * i) for i in range(len(rows))]
    for (x, y), teeth in zip(places, rows, strict=True):
        _teeth(path, gauge, teeth, (x, y), base, tip)
    if fences and roofs:
        beside = gauge.beside_roof_mm(gauge.roofs_mm[roofs - 1])
        y = max(farthest, beside) + pitch
        across = max(len(rows[0]) * pitch + pitch, roofs * pitch + beside) + beside
        down = (y + beside + places[-1][1] - farthest - roofs * pitch) / 2
        frames: list[Frame] = [
            lambda along, off: (along, y + off),
            lambda along, off: (across + off, down + along),
        ]
        _fences(path, gauge, roofs, frames[:fences], base, tip)
    path.go((*path.at[:2], path.top + settings.wire.travel_lift_mm), prints=False)
    return path


def _strip(path: Path, frame: Frame, length: float, base: float) -> None:
    """Lay what posts stand on: lines side by side on the bed."""
    wide = path.settings.printer.head.nozzle_mm
    beyond = STRIP_BEYOND * wide
    ends = [(-beyond, length + beyond), (length + beyond, -beyond)]
    for number, line in enumerate(STRIP_LINES):
        begin, end = ends[number % 2]
        start = (*frame(begin, line * wide), base)
        if number == 0:
            path.go(start)
        else:
            path.strand(start, _SKIRT)
        path.strand((*frame(end, line * wide), base), _SKIRT)


def _teeth(
    path: Path,
    gauge: Gauge,
    teeth: tuple[float, ...],
    place: tuple[float, float],
    base: float,
    tip: float,
) -> None:
    pitch, (x, y) = gauge.pitch_mm, place
    _strip(path, lambda along, off: (x + along, y + off), len(teeth) * pitch, base)
    path.go((x, y, base))
    for number in range(len(teeth)):
        path.strand((x + number * pitch, y, tip + gauge.tooth_mm), _POST, pause=True)
        path.strand((x + (number + 1) * pitch, y, base), _DIAGONAL)
    for number, angle in enumerate(teeth):
        beside = gauge.beside_tooth_mm(angle)
        for direction in DIRECTIONS:
            turn = math.radians(direction)
            at = (x + number * pitch + beside * math.cos(turn), y + beside * math.sin(turn), tip)
            path.touch(at)


def _fences(
    path: Path, gauge: Gauge, roofs: int, frames: list[Frame], base: float, tip: float
) -> None:
    pitch = gauge.pitch_mm
    for frame in frames:
        _strip(path, frame, roofs * pitch, base)
    heights = [gauge.tooth_mm, *gauge.roofs_mm[:roofs]]
    below = base
    for level, height in enumerate(heights):
        path.slab += 1
        for frame in frames:
            first = max(level - 1, 0)
            for rail in range(roofs, first - 1, -1):
                path.go((*frame(rail * pitch, 0.0), below))
                path.strand((*frame(rail * pitch, 0.0), tip + height), _POST, pause=True)
                if rail < roofs:
                    path.strand((*frame((rail + 1) * pitch, 0.0), tip + height), _CONTOUR)
            if level:
                off = gauge.beside_roof_mm(height)
                for side in (-off, off):
                    begin = (*frame(first * pitch, side), tip)
                    path.touch(begin, (*frame(roofs * pitch, side), tip))
        below = tip + height
