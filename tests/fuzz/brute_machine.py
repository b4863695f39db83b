"""A machine that carries out the few commands that random prints use, a line at a time."""

from __future__ import annotations

import math
import re
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

if TYPE_CHECKING:
    from collections.abc import Iterable

    from wireprint import Settings

Place = tuple[float, float, float]
WORD = re.compile(r"\b([A-Z])(-?\d*\.?\d+|\b)")


class Move(NamedTuple):
    """A straight move: places in mm, filament in mm, speed in mm/s."""

    line: int
    start: Place
    end: Place
    filament: float
    speed: float
    homing: bool


@dataclass
class Run:
    """All that a text does."""

    moves: list[Move] = field(default_factory=list)
    #: After how many moves the head stands still, and for how long, s.
    dwells: list[tuple[int, float]] = field(default_factory=list)
    #: Lines with the first filament through a nozzle that is cold.
    cold: list[int] = field(default_factory=list)
    #: Lines with the first move of axes that are not home.
    unhomed: list[int] = field(default_factory=list)


class Machine:
    """State of a printer that has just been switched on."""

    def __init__(self, settings: Settings, rules: dict) -> None:
        """Take the dialect, the way home and the least temperature from a profile."""
        self.printer = settings.printer
        self.klipper = settings.printer.gcode.flavor == "klipper"
        self.coldest_c = rules["coldest_c"]
        self.at = [0.0, 0.0, 0.0]
        self.offset = [0.0, 0.0, 0.0]
        self.relative = self.relative_e = False
        self.e = 0.0
        self.feed, self.feed_factor, self.flow_factor = 25.0, 1.0, 1.0
        self.home_axes: set[int] = set()
        self.target_c: float | None = None
        self.hot = self.was_cold = self.was_unhomed = False
        self.run = Run()

    def carry_out(self, lines: Iterable[str]) -> Run:
        """Carry out all lines."""
        for number, line in enumerate(lines, 1):
            code = line.split(";")[0].strip()
            if code:
                self.command(number, code.split(" ")[0], dict(WORD.findall(code)))
        return self.run

    def command(self, number: int, code: str, text: dict[str, str]) -> None:
        """Carry out one command."""
        words = {letter: float(value or 0) for letter, value in text.items()}
        if code in ("G0", "G1"):
            self.straight(number, words)
        elif code == "G4":
            self.dwell(words)
        elif code == "G28":
            named = {axis for axis, letter in enumerate("XYZ") if letter in words}
            self.home(number, named or {0, 1, 2})
        elif code == "G280":
            # Ultimaker's priming: that printer homes ahead of a file.
            self.home_axes = {0, 1, 2}
        elif code in ("G90", "G91"):
            self.relative = code == "G91"
            if not self.klipper:
                self.relative_e = self.relative
        elif code == "G92":
            for axis, letter in enumerate("XYZ"):
                if letter in words:
                    self.offset[axis] = self.at[axis] - words[letter]
            self.e = words.get("E", self.e)
        elif code in ("M82", "M83"):
            self.relative_e = code == "M83"
        elif code == "M84":
            self.home_axes = set()
        elif code == "M220" and words.get("S", 0) > 0:
            self.feed_factor = words["S"] / 100
        elif code == "M221" and words.get("S", 0) > 0:
            self.flow_factor = words["S"] / 100
        elif code in ("M104", "M109"):
            self.heat(words, waits=code == "M109")

    def heat(self, words: dict[str, float], *, waits: bool) -> None:
        """M104 aims, M109 waits."""
        self.target_c = words.get("S", words.get("R"))
        hot_enough = self.target_c is not None and self.target_c >= self.coldest_c
        self.hot = hot_enough if waits else self.hot and hot_enough

    def dwell(self, words: dict[str, float]) -> None:
        """G4: Klipper reads P alone, to others S comes first."""
        seconds = words.get("P", 0.0) / 1000
        if not self.klipper:
            seconds = words.get("S", seconds)
        if self.run.moves:
            self.run.dwells.append((len(self.run.moves), max(seconds, 0.0)))

    def straight(self, number: int, words: dict[str, float]) -> None:
        """G0 and G1."""
        if words.get("F", 0) > 0:
            self.feed = words["F"] / 60
        end = list(self.at)
        for axis, letter in enumerate("XYZ"):
            if letter in words:
                base = self.at[axis] if self.relative else self.offset[axis]
                end[axis] = base + words[letter]
        fed = 0.0
        if "E" in words:
            as_relative = self.relative_e or (self.klipper and self.relative)
            fed = words["E"] if as_relative else words["E"] - self.e
            self.e += fed
        filament = fed * self.flow_factor
        if end == self.at and filament == 0:
            return
        self.watch(number, end, filament)
        speed = self.feed * self.feed_factor
        self.run.moves.append(Move(number, tuple(self.at), tuple(end), filament, speed, False))
        self.at = end

    def watch(self, number: int, end: list[float], filament: float) -> None:
        """Note cold filament and moves that do not know where they are; a run once."""
        lost = any(end[axis] != self.at[axis] and axis not in self.home_axes for axis in range(3))
        if lost and not self.was_unhomed:
            self.run.unhomed.append(number)
        self.was_unhomed |= lost
        if filament > 0:
            is_cold = self.target_c is not None and not self.hot
            if is_cold and not self.was_cold:
                self.run.cold.append(number)
            self.was_cold = is_cold

    def home(self, number: int, named: set[int]) -> None:
        """G28, as the profile states its ways."""
        strokes, home = self.way_home(named)
        for end in strokes:
            if list(end) != self.at:
                start = tuple(self.at)
                self.run.moves.append(Move(number, start, tuple(end), 0.0, 0.0, True))
                self.at = list(end)
        for axis in home:
            self.offset[axis] = 0.0
        self.home_axes |= home
        self.was_unhomed = False

    def way_home(self, named: set[int]) -> tuple[list[list[float]], set[int]]:
        """Ends of the strokes, and the axes that are home then."""
        printer, at = self.printer, list(self.at)
        if printer.kinematics == "delta":
            top = printer.motion.endstop_height
            return [[at[0], at[1], max(self.first_end(top), at[2])], [0.0, 0.0, top]], {0, 1, 2}
        homing, bed = printer.homing, printer.bed
        low = np.subtract(bed.centre_mm, np.divide(bed.size_mm, 2))
        ends = [homing.x_mm, homing.y_mm]
        strokes: list[list[float]] = []

        def go(**axes: float) -> None:
            for letter, value in axes.items():
                at["xyz".index(letter)] = float(value)
            strokes.append(list(at))

        top = homing.z_end == "top"
        if 2 in named and top:
            go(z=bed.height_mm)
        if named & {0, 1} and at[2] < homing.lift_mm:
            go(z=homing.lift_mm)
        for axis in sorted(named & {0, 1}):
            go(**{"xy"[axis]: low[axis] if ends[axis] is None else ends[axis]})
        if 2 in named and not top:
            if homing.z_place_mm is not None:
                x, y = homing.z_place_mm
                go(x=x, y=y, z=max(at[2], homing.lift_mm))
            go(z=0.0)
        return strokes, set(named)

    def first_end(self, top: float) -> float:
        """Height of the tip when the first carriage of a delta meets its end, mm."""
        radius, arm = self.printer.motion.delta_radius, self.printer.motion.arm_length
        highest = 0.0
        for degrees in (210, 330, 90):
            x, y = (
                radius * math.cos(math.radians(degrees)),
                radius * math.sin(math.radians(degrees)),
            )
            squared = (x - self.at[0]) ** 2 + (y - self.at[1]) ** 2
            highest = max(highest, math.sqrt(max(arm**2 - squared, 0.0)))
        return top + math.sqrt(arm**2 - radius**2) - highest
