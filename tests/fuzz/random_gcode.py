"""Random G-codes: wire cages, walks and prints of our own, damaged in random ways, with a seed."""

from __future__ import annotations

import math
import random
import re
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from collections.abc import Sequence

    from wireprint import Settings

MOVE = re.compile(r"^G[01] .*[XYZ]")


def gcode(draw: random.Random, settings: Settings, ours: Sequence[str]) -> list[str]:
    """Return the lines of a random file for a printer; `ours` are those of a print of our own."""
    kind = draw.random()
    if kind < 0.3:
        lines = walk(draw, settings)
    elif kind < 0.75:
        lines = cage(draw, settings)
    else:
        lines = list(ours)
    for _ in range(draw.choice([0, 1, 1, 2, 3, 6])):
        damage(draw, lines, settings)
    return lines


def opening(draw: random.Random, settings: Settings) -> list[str]:
    """Heat, home, modes: mostly right."""
    heat = draw.choice([["M104 S150", "M109 S245"]] * 8 + [[], ["M104 S245"], ["M109 S120"]])
    home = draw.choice([["G28"]] * 8 + [["G28 X0 Y0"], []])
    return [*heat, *home, "G90", draw.choice(["M83"]), "G1 F1200"]


def feed(settings: Settings, length: float) -> float:
    """Filament of a free strand, mm."""
    thread = math.pi / 4 * settings.printer.head.nozzle_mm**2
    return length * thread / (math.pi / 4 * settings.printer.extruder.filament_diameter_mm**2)


class Pen:
    """Writes lines."""

    def __init__(self, draw: random.Random, settings: Settings) -> None:
        """Begin a file."""
        self.draw, self.settings = draw, settings
        self.lines = opening(draw, settings)
        self.at = (*settings.printer.bed.centre_mm, 20.0)
        self.goes(self.at)

    def goes(self, to: tuple[float, float, float]) -> None:
        """Travel."""
        x, y, z = to
        self.lines.append(f"G0 X{x:.3f} Y{y:.3f} Z{z:.3f}")
        self.at = to

    def draws(self, to: tuple[float, float, float]) -> None:
        """Print a strand."""
        x, y, z = to
        fed = feed(self.settings, math.dist(self.at, to))
        self.lines.append(f"G1 X{x:.3f} Y{y:.3f} Z{z:.3f} E{fed:.5f}")
        self.at = to

    def stays(self) -> None:
        """Dwell, mostly for long enough."""
        self.lines.append(f"G4 P{self.draw.choice([2000, 2000, 2000, 500, 100, 0])}")


def cage(draw: random.Random, settings: Settings) -> list[str]:
    """Slices of a prism with posts and diagonals between them, as a wire print has."""
    pen = Pen(draw, settings)
    x0, y0 = settings.printer.bed.centre_mm
    sides, radius = draw.randint(3, 8), draw.uniform(4, 30)
    rise, first = draw.uniform(0.8, 8), settings.printer.head.nozzle_mm / 2
    turn = draw.uniform(0, math.tau)
    corners = [
        (
            x0 + radius * math.cos(turn + math.tau * i / sides),
            y0 + radius * math.sin(turn + math.tau * i / sides),
        )
        for i in range(sides)
    ]
    for slab in range(draw.randint(1, 4)):
        z = first + slab * rise
        pen.goes((*pen.at[:2], z + rise + 5))
        pen.goes((*corners[0], z + rise + 5))
        pen.goes((*corners[0], z))
        for i in range(1, sides + 1):
            pen.draws((*corners[i % sides], z))
        if draw.random() < 0.2:
            continue
        for i in range(sides):
            pen.draws((*corners[i], z + rise))
            pen.stays()
            if i + 1 < sides and draw.random() < 0.8:
                pen.draws((*corners[i + 1], z))
            elif i + 1 < sides:
                pen.goes((*pen.at[:2], z + rise + 2))
                pen.goes((*corners[i + 1], z + rise + 2))
                pen.goes((*corners[i + 1], z))
    return pen.lines


def walk(draw: random.Random, settings: Settings) -> list[str]:
    """A walk that rises slowly and sometimes leaps."""
    pen = Pen(draw, settings)
    x0, y0 = settings.printer.bed.centre_mm
    pen.goes((x0, y0, 0.2))
    for _ in range(draw.randint(3, 60)):
        scale = draw.choice([0.3, 1, 1, 1, 5])
        x, y, z = pen.at
        x = min(max(x + scale * draw.uniform(-9, 9), x0 - 70), x0 + 70)
        y = min(max(y + scale * draw.uniform(-9, 9), y0 - 70), y0 + 70)
        z = min(max(z + draw.uniform(-3, 4), 0), 70)
        place = (round(x, 3), round(y, 3), round(z, 3))
        draw.choice([pen.draws, pen.draws, pen.goes])(place)
        if draw.random() < 0.2:
            pen.stays()
    return pen.lines


def damage(draw: random.Random, lines: list[str], settings: Settings) -> None:
    """Change, drop, move or add a line."""
    moves = [index for index, line in enumerate(lines) if MOVE.match(line)]
    index = draw.choice(moves)
    line = lines[index]
    x0, y0 = settings.printer.bed.centre_mm
    place = (
        f"X{x0 + draw.gauss(0, 25):.3f} Y{y0 + draw.gauss(0, 25):.3f} Z{abs(draw.gauss(0, 12)):.3f}"
    )
    added = [
        "G28",
        "G28 X",
        "G28 Y0",
        "G28 Z",
        "G92 Z0",
        f"G92 Z{draw.uniform(0, 30):.2f}",
        "G92 X3 Y-2",
        "M104 S0",
        "M109 S200",
        "M84",
        "M220 S40",
        "M220 S900",
        "M221 S10",
        "M221 S300",
        "G4 P2000",
        "G1 E-3",
        "G1 E3",
        "G1 E300",
        "G1 F200",
        "G1 F90000",
        f"G0 {place}",
        f"G1 {place} E2",
        "G91",
        "G90",
        "M82",
        "M83",
        "G92 E0",
        "G1 Z-0.5",
        f"G0 Z{draw.uniform(0, 40):.3f}",
    ]
    kind = draw.randrange(7)
    if kind == 0:
        lines.insert(index, draw.choice(added))
    elif kind == 1:
        del lines[index]
    elif kind == 2:
        other = draw.choice(moves)
        lines[index], lines[other] = lines[other], line
    elif kind == 3:
        lines[index] = re.sub(r" E\S+", "", line)
    elif kind == 4:
        factor = draw.choice([0.01, 0.1, 0.24, 0.5, 3])
        lines[index] = re.sub(r" E([\d.]+)", lambda m: f" E{float(m[1]) * factor:.5f}", line)
    elif kind == 5:
        shift = draw.choice([0.1, 1, 5]) * draw.gauss(0, 1)
        letter = draw.choice("XYZ")
        least = 0.0 if letter == "Z" else -math.inf

        def shifted(word: re.Match[str]) -> str:
            return f"{letter}{max(float(word[1]) + shift, least):.3f}"

        lines[index] = re.sub(rf"{letter}(-?[\d.]+)", shifted, line)
    else:
        dwells = [i for i, text in enumerate(lines) if text.startswith("G4")]
        if dwells:
            lines[draw.choice(dwells)] = draw.choice(["G4 P0", "G4 P100", "G4 S1"])
