"""What a certificate says: breaches of the rules, each with its line and place."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TypeAlias

Point: TypeAlias = tuple[float, float, float]


@dataclass(frozen=True, slots=True)
class Collision:
    """A move that drives the head into material or bed, at its deepest place."""

    #: Line of the move.
    line: int
    #: Where the tip is, mm.
    tip_mm: Point
    #: Where the material is, mm.
    material_mm: Point
    #: How far the material reaches into the head, mm.
    depth_mm: float
    #: Line of the strand that is hit; None: the bed.
    hit_line: int | None

    def __str__(self) -> str:
        """Say what happens, in a line."""
        hit = "the bed" if self.hit_line is None else f"the strand of line {self.hit_line}"
        return f"head {self.depth_mm:.2f} mm into {hit}, {_at(self.tip_mm)}"


@dataclass(frozen=True, slots=True)
class LooseEnd:
    """A run of strands that starts or ends in the air."""

    #: Line of the strand.
    line: int
    #: Where, mm.
    at_mm: Point

    def __str__(self) -> str:
        """Say where it is, in a line."""
        return _at(self.at_mm)


@dataclass(frozen=True, slots=True)
class Span:
    """A stretch that hangs farther than its limit."""

    #: Line of the strand at whose end the stretch ends.
    line: int
    #: Where it begins, mm.
    from_mm: Point
    #: Where it ends, mm.
    to_mm: Point
    #: Length along the strands, mm.
    length_mm: float
    #: What it may have, mm.
    limit_mm: float
    #: Whether it is held at one end only.
    free_end: bool

    def __str__(self) -> str:
        """Say how long it is, in a line."""
        kind = "free end" if self.free_end else "span"
        return f"{kind} of {self.length_mm:.1f} mm (limit {self.limit_mm:g}), {_at(self.from_mm)}"


@dataclass(frozen=True, slots=True)
class OutOfBounds:
    """A move that asks for more than the machine has."""

    #: Line of the move.
    line: int
    #: Where it ends, mm.
    at_mm: Point
    #: ``volume`` (mm outside), ``feed`` (mm/s), ``flow`` (mm³/s) or ``filament`` (mm, in place).
    bound: str
    #: What is asked for, in the bound's unit.
    value: float
    #: What there is, in the bound's unit.
    limit: float

    def __str__(self) -> str:
        """Say what is exceeded, in a line."""
        if self.bound == "volume":
            return f"{self.value:.2f} mm outside the build volume, {_at(self.at_mm)}"
        unit = {"feed": "mm/s", "flow": "mm³/s", "filament": "mm in place"}[self.bound]
        return f"{self.bound} {self.value:.1f} {unit} (limit {self.limit:g}), {_at(self.at_mm)}"


@dataclass(frozen=True, slots=True)
class Underfed:
    """A run of strands that gets too little filament to become any."""

    #: Line of the first one.
    line: int
    #: Where it starts, mm.
    at_mm: Point
    #: Length of the run, mm.
    length_mm: float
    #: What it gets, as a share of what a free strand takes.
    share: float
    #: What it needs at least: more where it hangs than where it lies.
    least: float

    def __str__(self) -> str:
        """Say how little it is, in a line."""
        return (
            f"{self.length_mm:.1f} mm of strand with {self.share:.1%} of the filament of a free "
            f"one (needs {self.least:.0%}), {_at(self.at_mm)}"
        )


@dataclass(frozen=True, slots=True)
class Hurried:
    """A stroke that ends in the air, and is left before it holds by itself."""

    #: Line of the stroke.
    line: int
    #: Where it ends, mm.
    at_mm: Point
    #: How long the head stays, s.
    dwell_s: float
    #: How long it must stay at least, s.
    least_s: float
    #: At this speed and below it need not, mm/s.
    slow_mm_s: float

    def __str__(self) -> str:
        """Say what is missing, in a line."""
        return (
            f"the head leaves a free end after {self.dwell_s:.2f} s (it must dwell "
            f"{self.least_s:.2f} s, or arrive at {self.slow_mm_s:g} mm/s at most), "
            f"{_at(self.at_mm)}"
        )


@dataclass(frozen=True, slots=True)
class Cold:
    """Filament that is fed through a cold nozzle."""

    #: Line of the first strand.
    line: int
    #: Where it starts, mm.
    at_mm: Point
    #: What the nozzle was told last, °C.
    nozzle_c: float
    #: What it needs, °C.
    least_c: float

    def __str__(self) -> str:
        """Say how cold it is, in a line."""
        told = f"the nozzle was told {self.nozzle_c:g} °C"
        if self.nozzle_c < self.least_c:
            return f"{told} (at least {self.least_c:g}; M109 heats and waits), {_at(self.at_mm)}"
        return f"{told}, but nothing waits until it is hot (M109), {_at(self.at_mm)}"


@dataclass(frozen=True, slots=True)
class Unhomed:
    """A move along axes that do not know where they are."""

    #: Line of the first move.
    line: int
    #: Where it would end, mm.
    at_mm: Point
    #: Whether x, y and z are meant.
    axes: tuple[bool, bool, bool]

    def __str__(self) -> str:
        """Say which axes, in a line."""
        names = ", ".join(name for name, meant in zip("xyz", self.axes, strict=True) if meant)
        return f"{names} not homed before the move (G28), {_at(self.at_mm)}"


@dataclass(frozen=True, slots=True)
class Unjudged:
    """A command that may move the head, the bed or the frame, and was not carried out."""

    #: Its line: from there on, nothing is certain.
    line: int
    #: The command.
    command: str
    #: Why it was not.
    why: str

    def __str__(self) -> str:
        """Say what and why, in a line."""
        return f"{self.command}: {self.why}"


Breach: TypeAlias = (
    Collision | LooseEnd | Span | OutOfBounds | Underfed | Hurried | Cold | Unhomed | Unjudged
)


def _at(point: Point) -> str:
    return "at ({:.2f}, {:.2f}, {:.2f})".format(*point)
