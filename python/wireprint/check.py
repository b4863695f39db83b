"""The certificate of a G-code file: what the head would do, judged by the rules of wire printing.

Any program's G-code can be judged. How contact, spans and collisions are defined is documented
with the judge itself, ``rust/core/src/check``.
"""

from __future__ import annotations

import math
import os
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any, Final

from wireprint import _core
from wireprint._core import GcodeError
from wireprint.limits import firmware_of

if TYPE_CHECKING:
    from wireprint.settings import Printer, Settings

Point = tuple[float, float, float]

#: ``;TYPE:`` labels of strands that are no part of the object: fidelity leaves them aside.
ASIDE: Final = frozenset({"support", "brim", "skirt", "prime", "custom"})
#: Most filament that one command may move in place, mm: Klipper's default
#: max_extrude_only_distance, and Marlin's EXTRUDE_MAXLENGTH.
FILAMENT_ONLY_MM: Final = {"klipper": 50.0, "marlin": 200.0}


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
class Patch:
    """A connected part of the model's surface that no strand is near to."""

    #: Area, mm².
    area_mm2: float
    #: Centre of area, mm, relative to the model's place on the bed.
    centroid_mm: Point
    #: Lowest and highest coordinates, mm.
    low_mm: Point
    high_mm: Point


@dataclass(frozen=True, slots=True)
class Fidelity:
    """How a print compares with its model (rule 6)."""

    #: Share of the surface within `within_mm` of a strand, 0-1.
    coverage: float
    #: Distance that counts as covered, mm.
    within_mm: float
    #: Mean distance of the strands from the surface, by length, mm.
    deviation_mm: float
    #: Greatest distance, mm.
    max_deviation_mm: float
    #: The same, strands that hang taken as the chords that they relax to.
    chord_deviation_mm: float
    max_chord_deviation_mm: float
    #: Uncovered patches, the largest first.
    uncovered: tuple[Patch, ...]


@dataclass(frozen=True, slots=True)
class Certificate:
    """The verdict on a file: every breach of the rules, in the order of its lines."""

    #: Whether no rule is broken.
    ok: bool
    #: Rule 1: moves that drive the head into material or bed.
    collisions: tuple[Collision, ...]
    #: Rule 2: runs of strands that start in the air.
    floating_starts: tuple[LooseEnd, ...]
    #: Rule 2: runs that end in the air where nothing meets them later.
    dangling_ends: tuple[LooseEnd, ...]
    #: Rule 3: stretches that hang too far.
    spans_over: tuple[Span, ...]
    #: Longest stretch held at both ends, mm.
    max_span_mm: float
    #: Longest stretch held at one end, mm.
    max_free_end_mm: float
    #: Rule 4: moves beyond the build volume or the machine's limits.
    out_of_bounds: tuple[OutOfBounds, ...]
    #: Profile whose head and limits were used.
    printer: str
    #: Moves, arcs counted by their chords.
    moves: int
    #: Strands.
    strands: int
    #: Comparison with a model, where one was given.
    fidelity: Fidelity | None
    #: The core's verdict, with all strands as arrays.
    core: _core.Certificate

    @property
    def breach_points_mm(self) -> list[Point]:
        """One place for each breach, mm."""
        return [
            *(hit.tip_mm for hit in self.collisions),
            *(end.at_mm for end in self.floating_starts + self.dangling_ends),
            *(span.from_mm for span in self.spans_over),
            *(breach.at_mm for breach in self.out_of_bounds),
        ]

    def breaches(self) -> dict[str, tuple[Collision | LooseEnd | Span | OutOfBounds, ...]]:
        """Return the lists of breaches by name."""
        return {
            "collisions": self.collisions,
            "floating_starts": self.floating_starts,
            "dangling_ends": self.dangling_ends,
            "spans_over": self.spans_over,
            "out_of_bounds": self.out_of_bounds,
        }

    def to_dict(self) -> dict[str, Any]:
        """Everything as values that JSON knows."""
        values: dict[str, Any] = {"ok": self.ok, "printer": self.printer}
        for name, found in self.breaches().items():
            values[name] = [asdict(breach) for breach in found]
        values |= {
            "max_span_mm": self.max_span_mm,
            "max_free_end_mm": self.max_free_end_mm,
            "moves": self.moves,
            "strands": self.strands,
        }
        if self.fidelity is not None:
            values |= asdict(self.fidelity)
        return values


def check(
    source: str | os.PathLike[str] | bytes,
    printer: str | Settings | None = None,
    model: _core.Mesh | None = None,
) -> Certificate:
    """Judge a G-code file, or G-code in memory.

    Parameters
    ----------
    source
        Path of a file, or the text itself as bytes.
    printer
        Whose head and limits apply: name of a profile, path of one, or settings. Default: what the
        file says that it was made with, else ``kossel-mini``.
    model
        Mesh to compare with, placed as `slice` places it: in the middle of the bed.

    Returns
    -------
    Certificate

    Raises
    ------
    GcodeError
        Nothing in the file is G-code.
    OSError
        The file cannot be read.
    SettingError
        The profile is wrong.

    Examples
    --------
    >>> check(b"G1 X0 Y0 Z-1 F600", "kossel-mini").collisions[0].depth_mm
    1.0
    """
    text = source if isinstance(source, bytes) else Path(source).read_bytes()
    settings = settings_for(text, printer)
    rules = rules_of(settings)
    core = _core.certify(text, rules)
    if core.moves == 0:
        name = "the text" if isinstance(source, bytes) else os.fspath(source)
        raise GcodeError(f"{name}: it moves nothing")
    limits = {True: rules["free_end_limit_mm"], False: rules["span_limit_mm"]}
    return Certificate(
        ok=core.ok,
        collisions=tuple(Collision(*row) for row in core.collisions),
        floating_starts=tuple(LooseEnd(*row) for row in core.floating_starts),
        dangling_ends=tuple(LooseEnd(*row) for row in core.dangling_ends),
        spans_over=tuple(
            Span(line, start, end, length, limits[free_end], free_end)
            for line, start, end, length, free_end in core.spans_over
        ),
        max_span_mm=core.max_span_mm,
        max_free_end_mm=core.max_free_end_mm,
        out_of_bounds=tuple(OutOfBounds(*row) for row in core.out_of_bounds),
        printer=settings.printer.name,
        moves=core.moves,
        strands=core.strand_count,
        fidelity=None if model is None else _fidelity(core, model, settings),
        core=core,
    )


def settings_for(text: bytes, printer: str | Settings | None) -> Settings:
    """Return the settings to judge a text by: those given, those in the text, or the default."""
    from wireprint.gcode.document import settings_in
    from wireprint.settings import Settings

    if isinstance(printer, Settings):
        return printer
    if printer is not None:
        return Settings.load(printer)
    return settings_in(text) or Settings.load()


def rules_of(settings: Settings) -> dict[str, Any]:
    """Return what the core judges by: lengths in mm, speeds in mm/s.

    A strand is as thick as the nozzle is wide. It lies on the bed where the tip is at most one
    strand, or the first layer's height, above it.
    """
    printer, wire = settings.printer, settings.wire
    head, extruder = printer.head, printer.extruder
    width, depth = printer.bed.size_mm
    firmware = "klipper" if firmware_of(printer) == "klipper" else "marlin"
    return {
        "head": head.model_dump(),
        "strand_mm": head.nozzle_mm,
        "bed_contact_mm": max(head.nozzle_mm, settings.first_layer_height_mm),
        "span_limit_mm": wire.span_limit_mm,
        "free_end_limit_mm": wire.free_end_limit_mm,
        "bed_centre_mm": printer.bed.centre_mm,
        "bed_half_mm": (width / 2, depth / 2),
        "bed_round": printer.bed.shape == "round",
        "height_mm": printer.bed.height_mm,
        "max_feed_mm_s": printer.motion.max_velocity,
        "max_flow_mm3_s": extruder.max_flow_mm3_s,
        "max_filament_only_mm": FILAMENT_ONLY_MM[firmware],
        "filament_area_mm2": math.pi / 4 * extruder.filament_diameter_mm**2,
        "klipper": firmware == "klipper",
        "arc_resolution_mm": printer.motion.arc_resolution,
        "home_mm": _home_mm(printer),
        "home_all": printer.kinematics == "delta",
    }


def _home_mm(printer: Printer) -> Point:
    """Where G28 leaves the head."""
    return (0.0, 0.0, printer.motion.endstop_height or 0.0)


def _fidelity(core: _core.Certificate, model: _core.Mesh, settings: Settings) -> Fidelity:
    within_mm = settings.wire.coverage_within_mm
    share, patches, commanded, relaxed = core.fidelity(
        model, settings.printer.bed.centre_mm, set(ASIDE), within_mm
    )
    return Fidelity(
        coverage=share,
        within_mm=within_mm,
        deviation_mm=commanded[0],
        max_deviation_mm=commanded[1],
        chord_deviation_mm=relaxed[0],
        max_chord_deviation_mm=relaxed[1],
        uncovered=tuple(Patch(*row) for row in patches),
    )


def _at(point: Point) -> str:
    return "at ({:.2f}, {:.2f}, {:.2f})".format(*point)
