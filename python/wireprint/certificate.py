"""The certificate of a G-code file: what the head would do, judged by the rules of wire printing.

Any program's G-code can be judged. How contact, spans and collisions are defined is documented
with the judge itself, ``rust/core/src/check``.
"""

from __future__ import annotations

from dataclasses import asdict, dataclass, replace
from functools import cached_property
from typing import TYPE_CHECKING, Any, Final

from wireprint import _core
from wireprint._core import GcodeError
from wireprint.fidelity import Fidelity, aside_in, fidelity_of
from wireprint.gcode.source import NO_GCODE, read
from wireprint.rules import Judge, faults_of, judge_of, rules_of
from wireprint.timing import RELATIVE_ASSUMED
from wireprint.verdict import (
    Breach,
    Cold,
    Collision,
    Hurried,
    LooseEnd,
    OutOfBounds,
    Point,
    Span,
    Underfed,
    Unhomed,
    Unjudged,
)

if TYPE_CHECKING:
    import os

    from wireprint.settings import Settings
    from wireprint.standing import Standing

NOTHING_PRINTED: Final = "nothing is printed: no move feeds filament over a distance"


@dataclass(frozen=True, repr=False)
class Certificate:
    """The verdict on a file: every breach of the rules, in the order of its lines."""

    #: The settings that it was judged by, and why by these.
    judge: Judge
    #: What the file was judged by.
    rules: dict[str, Any]
    #: Comparison with a model, where one was given.
    fidelity: Fidelity | None
    #: The core's verdict, with all strands as arrays.
    core: _core.Certificate
    #: Kinds of strands that a comparison with a model leaves out.
    aside: frozenset[str]

    def compared(
        self, model: _core.Mesh, *, at_mm: Point = (0.0, 0.0, 0.0), deviation: bool = True
    ) -> Certificate:
        """Return the verdict with a comparison with a model, as `check` gives it.

        Parameters
        ----------
        model
            Mesh to compare with, placed as `slice` places it: in the middle of the bed.
        at_mm
            Where the model stands from the middle of the bed, mm.
        deviation
            Whether to measure how far strands lie from it, too, not only what they cover.

        Returns
        -------
        Certificate
            The same verdict, with `fidelity`.
        """
        settings = self.judge.settings
        found = fidelity_of(self.core, model, at_mm, settings, self.aside, deviation)
        return replace(self, fidelity=found)

    @property
    def printer(self) -> str:
        """Profile whose head and limits were used."""
        return self.judge.settings.printer.name

    @property
    def ok(self) -> bool:
        """Whether all was judged, something is printed, no rule broken, and the profile is true."""
        return self.core.ok and not self.profile and self.strands > 0

    @cached_property
    def profile(self) -> tuple[str, ...]:
        """What is wrong in the profile itself, in sentences."""
        return faults_of(self.judge.settings.printer.head)

    @property
    def harmless(self) -> dict[str, int]:
        """Commands that move nothing, and how often each stands there."""
        return self.core.harmless

    @property
    def preparing(self) -> dict[str, int]:
        """Commands before the print that probe or run macros: not carried out, likewise."""
        return self.core.preparing

    @property
    def remarks(self) -> tuple[str, ...]:
        """What was taken otherwise than it stands in the file, in sentences."""
        found = list(self.judge.remarks)
        if self.core.relative_assumed:
            found.append(RELATIVE_ASSUMED)
        if self.strands == 0:
            found.append(NOTHING_PRINTED)
        return tuple(found)

    @property
    def moves(self) -> int:
        """Number of moves, arcs counted by their chords."""
        return self.core.moves

    @property
    def strands(self) -> int:
        """Number of strands."""
        return self.core.strand_count

    @property
    def max_span_mm(self) -> float:
        """Longest stretch held at both ends, mm."""
        return self.core.max_span_mm

    @property
    def max_free_end_mm(self) -> float:
        """Longest stretch held at one end, mm."""
        return self.core.max_free_end_mm

    @cached_property
    def collisions(self) -> tuple[Collision, ...]:
        """Rule 1: moves that drive the head into material or bed."""
        return tuple(Collision(*row) for row in self.core.collisions)

    @cached_property
    def floating_starts(self) -> tuple[LooseEnd, ...]:
        """Rule 2: runs of strands that start in the air."""
        return tuple(LooseEnd(*row) for row in self.core.floating_starts)

    @cached_property
    def dangling_ends(self) -> tuple[LooseEnd, ...]:
        """Rule 2: runs of strands that end in the air where nothing meets them later."""
        return tuple(LooseEnd(*row) for row in self.core.dangling_ends)

    @cached_property
    def spans_over(self) -> tuple[Span, ...]:
        """Rule 3: stretches that hang too far."""
        free, held = self.rules["free_end_limit_mm"], self.rules["span_limit_mm"]
        return tuple(
            Span(line, start, end, length, free if free_end else held, free_end)
            for line, start, end, length, free_end in self.core.spans_over
        )

    @cached_property
    def out_of_bounds(self) -> tuple[OutOfBounds, ...]:
        """Rule 4: moves beyond the build volume or the machine's limits."""
        return tuple(OutOfBounds(*row) for row in self.core.out_of_bounds)

    @cached_property
    def underfed(self) -> tuple[Underfed, ...]:
        """Rule 5: runs of strands with too little filament."""
        return tuple(Underfed(*row) for row in self.core.underfed)

    @cached_property
    def hurried(self) -> tuple[Hurried, ...]:
        """Rule 5: strokes whose free ends are left before they hold."""
        settling = self.rules["settling"]
        least_s, slow_mm_s = settling["dwell_s"], settling["slow_mm_s"]
        return tuple(Hurried(*row, least_s, slow_mm_s) for row in self.core.hurried)

    @cached_property
    def cold(self) -> tuple[Cold, ...]:
        """Rule 6: extrusions through a cold nozzle."""
        return tuple(Cold(*row, self.rules["coldest_c"]) for row in self.core.cold)

    @cached_property
    def unhomed(self) -> tuple[Unhomed, ...]:
        """Rule 6: moves along axes that were not homed."""
        return tuple(
            Unhomed(line, at_mm, (axes[0], axes[1], axes[2]))
            for line, at_mm, axes in self.core.unhomed
        )

    @cached_property
    def unjudged(self) -> tuple[Unjudged, ...]:
        """Commands that were not carried out: from the first on, nothing is certain."""
        return tuple(Unjudged(*row) for row in self.core.unjudged)

    @property
    def breach_points_mm(self) -> list[Point]:
        """One place for each breach, mm."""
        return [
            *(hit.tip_mm for hit in self.collisions),
            *(end.at_mm for end in self.floating_starts + self.dangling_ends),
            *(span.from_mm for span in self.spans_over),
            *(breach.at_mm for breach in self.out_of_bounds),
            *(run.at_mm for run in self.underfed),
            *(end.at_mm for end in self.hurried),
            *(run.at_mm for run in self.cold),
            *(run.at_mm for run in self.unhomed),
        ]

    def breaches(self) -> dict[str, tuple[Breach, ...]]:
        """Return the lists of breaches by name.

        Returns
        -------
        dict
            Breaches by rule, in the order of lines; empty where it is kept.
        """
        return {
            "collisions": self.collisions,
            "floating_starts": self.floating_starts,
            "dangling_ends": self.dangling_ends,
            "spans_over": self.spans_over,
            "out_of_bounds": self.out_of_bounds,
            "underfed": self.underfed,
            "hurried": self.hurried,
            "cold": self.cold,
            "unhomed": self.unhomed,
            "unjudged": self.unjudged,
        }

    def __repr__(self) -> str:
        """Say what the verdict is."""
        broken = {name: len(found) for name, found in self.breaches().items() if found}
        said = ", ".join(f"{count} {name.replace('_', ' ')}" for name, count in broken.items())
        verdict = "printable" if self.ok else f"not printable{said and f': {said}'}"
        return f"<Certificate {self.printer}, {self.strands} strands: {verdict}>"

    def _repr_png_(self) -> bytes:
        """Draw the picture that a notebook shows: what was judged, its breaches marked."""
        from wireprint.notebook import picture

        return picture(self)

    def to_dict(self) -> dict[str, Any]:
        """Everything as values that JSON knows.

        Returns
        -------
        dict
            What ``wireprint check --json`` prints.
        """
        values: dict[str, Any] = {
            "ok": self.ok,
            "printer": self.printer,
            "judged_by": self.judge.why,
            "not_judged_from_line": self.unjudged[0].line if self.unjudged else None,
            "profile": list(self.profile),
            "remarks": list(self.remarks),
        }
        for name, found in self.breaches().items():
            values[name] = [asdict(breach) for breach in found]
        values |= {
            "max_span_mm": self.max_span_mm,
            "max_free_end_mm": self.max_free_end_mm,
            "moves": self.moves,
            "strands": self.strands,
            "harmless": self.harmless,
            "preparing": self.preparing,
        }
        if self.fidelity is not None:
            values |= asdict(self.fidelity)
        return values


def check(
    source: str | os.PathLike[str] | bytes,
    printer: str | Settings | None = None,
    model: _core.Mesh | None = None,
    *,
    deviation: bool = True,
    standing: Standing | None = None,
    at_mm: Point = (0.0, 0.0, 0.0),
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
    deviation
        Whether to measure how far strands lie from the model, too, not only what they cover.
    standing
        What stands on the bed already: earlier prints are judged together with this one, as one
        text, whose lines come after theirs (`Standing.place`); objects are in the way.
    at_mm
        Where the model stands from the middle of the bed, mm.

    Returns
    -------
    Certificate
        The verdict.

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
    text, name = read(source)
    judge = judge_of(text, printer, name)
    settings = judge.settings
    rules = rules_of(settings)
    if standing is None:
        core = _core.certify(text, rules)
    else:
        core = _core.certify(standing.text + text, rules).after(standing.given)
    if core.moves == 0:
        raise GcodeError(f"{name}: it moves nothing: if it was cut off, write it again; {NO_GCODE}")
    found = Certificate(judge, rules, None, core, aside_in(text))
    return found if model is None else found.compared(model, at_mm=at_mm, deviation=deviation)
