"""How a print begins where something stands: its start neither probes there nor homes into it."""

from __future__ import annotations

import re
from dataclasses import dataclass
from typing import TYPE_CHECKING, Final

from wireprint import _core
from wireprint._core import UnprintableError
from wireprint.gcode import sequence
from wireprint.rules import rules_of

if TYPE_CHECKING:
    from collections.abc import Sequence

    from wireprint.settings import Settings
    from wireprint.standing import Standing

_HOMES: Final = re.compile(r"\s*G28\b(?!.*[XY])", re.IGNORECASE)
#: Home the two axes along the bed; the third keeps the place that the earlier print left it at.
_SIDEWAYS: Final = "G28 X Y"
#: What a macro may have done that is left out.
_HEATS: Final = {"M190": "M190 S{bed_c}", "M109": "M109 S{nozzle_c}"}
#: Clearance above what stands before the first way to the print, mm.
_ABOVE_MM: Final = 1.0
#: Lines of `_rise`.
_RISES: Final = 2


@dataclass(frozen=True)
class _Faults:
    """Lines of a start sequence, from 0, and what is wrong with them."""

    unjudged: frozenset[int]
    hits: frozenset[int]
    #: Whether some axis is not homed in the end.
    lost: bool

    def __bool__(self) -> bool:
        return bool(self.unjudged or self.hits or self.lost)


def over(settings: Settings, standing: Standing) -> tuple[Settings, tuple[str, ...]]:
    """Return settings whose start sequence can be carried out over what stands.

    What probes the bed, and macros of which nobody knows what they do, are left out; where the way
    home leads into what stands, z is not homed anew.

    Returns
    -------
    settings
        As given, but for ``printer.gcode.start``.
    remarks
        What was changed, in sentences.

    Raises
    ------
    UnprintableError
        The printer must home where something stands.
    """
    if not standing.text:
        return settings, ()
    # From wherever it homed, the first way to the print leads over all that stands.
    lines = [*settings.printer.gcode.start.strip().splitlines(), *_rise(settings, standing)]
    faults = _faults_of(lines, settings, standing)
    remarks = []
    if faults.unjudged:
        left_out = [lines[number] for number in sorted(faults.unjudged)]
        lines = _without(lines, faults.unjudged)
        remarks.append(f"started without {', '.join(left_out)}, for something stands on the bed")
        faults = _faults_of(lines, settings, standing)
    if faults.hits or faults.lost:
        sideways = [_SIDEWAYS if _HOMES.match(line) else line for line in lines]
        if _faults_of(sideways, settings, standing):
            raise UnprintableError(_in_the_way(settings, standing))
        lines = sideways
        remarks.append("z is not homed anew, for something stands there: keep the printer on")
    gcode = settings.printer.gcode.model_copy(update={"start": "\n".join(["", *lines, ""])})
    printer = settings.printer.model_copy(update={"gcode": gcode})
    return settings.model_copy(update={"printer": printer}), tuple(remarks)


def _faults_of(lines: Sequence[str], settings: Settings, standing: Standing) -> _Faults:
    """Judge a start sequence after all that stands."""
    material = settings.material
    x, y = settings.printer.bed.centre_mm
    names: dict[str, float] = {"nozzle_c": material.nozzle_c, "bed_c": material.bed_c}
    names |= {"min_x_mm": x, "max_x_mm": x, "min_y_mm": y, "max_y_mm": y}
    filled = [sequence.filled(line, names) for line in lines]
    text = "\n".join([*filled, ""])
    before = standing.text.count(b"\n")
    core = _core.certify(standing.text + text.encode(), rules_of(settings))

    def of_start(found: Sequence[tuple[int, object]] | Sequence[tuple[object, ...]]) -> list[int]:
        numbers = (int(str(one[0])) - before - 1 for one in found)
        return [number for number in numbers if number >= 0]

    return _Faults(
        unjudged=frozenset(of_start(core.unjudged)),
        hits=frozenset(of_start(core.collisions)),
        lost=bool(of_start(core.unhomed)),
    )


def _rise(settings: Settings, standing: Standing) -> tuple[str, str]:
    """Return moves to above all that stands; they tell, too, whether z is known."""
    up_mm = min(standing.top_mm + _ABOVE_MM, settings.printer.bed.height_mm)
    return "G90", f"G1 Z{up_mm:.3f} F{60 * settings.printer.motion.max_z_velocity:.0f}"


def _without(lines: Sequence[str], numbers: frozenset[int]) -> list[str]:
    """Return a sequence without some lines, homed and heated all the same."""
    kept = [line for number, line in enumerate(lines) if number not in numbers]
    if not any(re.match(r"\s*G28\b", line, re.IGNORECASE) for line in kept):
        kept.insert(min(min(numbers), len(kept)), "G28")
    for command, line in _HEATS.items():
        if not any(one.strip().startswith(command) for one in kept):
            kept.insert(len(kept) - _RISES, line)
    return kept


def _in_the_way(settings: Settings, standing: Standing) -> str:
    x, y = _z_place_mm(settings)
    where = f"{settings.printer.name} homes z at ({x:g}, {y:g}), where something stands"
    if not standing.prints:
        return f"{where}: put it away from there (as the model's own coordinates say)"
    return (
        f"{where}, and z is not known any more, for its motor was switched off after the earlier "
        "print: go on before that (--stopped), or print the earlier one with a gcode.end that "
        "leaves z on (M84 X Y E)"
    )


def _z_place_mm(settings: Settings) -> tuple[float, float]:
    """Return where the printer homes z, mm."""
    homing = settings.printer.homing
    if homing.z_place_mm is not None:
        return homing.z_place_mm
    rules = rules_of(settings)
    x, y, _ = rules["homing"]["at_mm"]
    return x, y
