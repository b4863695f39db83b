"""Print time: what a firmware's planner makes of a G-code file."""

from __future__ import annotations

import math
import os
from dataclasses import asdict, dataclass, field
from pathlib import Path
from typing import TYPE_CHECKING, Any, Final

from wireprint import _core
from wireprint._core import GcodeError, SettingError
from wireprint.duration import duration
from wireprint.gcode.origin import stated_time_s
from wireprint.gcode.source import NO_GCODE, TEXT, kind_of, read
from wireprint.records import Record
from wireprint.timed_machine import Choice, Machine

if TYPE_CHECKING:
    from collections.abc import Mapping, Sequence

    import numpy as np
    import numpy.typing as npt

    from wireprint.limits import Firmware
    from wireprint.settings import Settings


#: More than the settings at a file's end take, and what other programs say at its beginning.
_END_BYTES: Final = 1 << 16
#: What is said of files whose E runs backwards.
RELATIVE_ASSUMED: Final = (
    "E runs backwards and the file does not say how it counts (M82, M83): taken as relative"
)


@dataclass(frozen=True, slots=True)
class Allowances:
    """Time for what G-code commands but does not describe, s; nothing by default."""

    #: For each G28.
    homing_s: float = 0.0
    #: For each M109 to a higher temperature than the last.
    nozzle_heating_s: float = 0.0
    #: For each M190 to a higher temperature than the last.
    bed_heating_s: float = 0.0
    #: For each change of tool, and of filament (M600).
    tool_change_s: float = 0.0

    def __post_init__(self) -> None:
        """Refuse what is no time.

        Raises
        ------
        SettingError
            Where one is negative or not finite.
        """
        for key, seconds in asdict(self).items():
            if not (math.isfinite(seconds) and seconds >= 0):
                raise SettingError(f"{key} is {seconds}; it must be finite and not negative")


@dataclass(frozen=True, slots=True)
class LayerTime:
    """Time of one layer."""

    #: Height, mm; None where nothing is extruded.
    z_mm: float | None
    #: Time of its moves and dwells, s.
    time_s: float


@dataclass(frozen=True, repr=False)
class PerMove(Record):
    """One row for each move and each dwell, in the file's order; read-only arrays of shape (N,)."""

    #: Line of the file, from 1.
    line: npt.NDArray[np.uint64]
    #: Time, s.
    duration_s: npt.NDArray[np.float64]
    #: Index into `types`.
    kind: npt.NDArray[np.uint16]
    #: What the entries of `kind` stand for.
    types: tuple[str, ...]


@dataclass(frozen=True, slots=True, repr=False)
class Estimate:
    """The time that a file takes, and where it goes."""

    #: Whose planner it is the time of.
    firmware: str
    #: Everything: motion, dwells and allowances, s.
    total_s: float
    #: Time in motion, s.
    moving_s: float
    #: Time of G4, s.
    dwell_s: float
    #: Time of moves of the head that extrude nothing, s; part of `moving_s`.
    travel_s: float
    #: Allowed for homing, s.
    homing_s: float
    #: Allowed for heating, s.
    heating_s: float
    #: Allowed for changes of tool and filament, s.
    tool_change_s: float
    #: Number of these changes.
    tool_changes: int
    #: Time by feature, s: ``travel``, ``retract``, ``dwell`` and the file's ``;TYPE:`` labels in
    #: small letters, ``other`` for strands without one; adds up to moving and dwelling.
    by_feature: dict[str, float]
    #: Time by layer; the first entry is what comes before the first layer, if anything does.
    by_layer: tuple[LayerTime, ...]
    #: Filament used, mm: the furthest that it was ever fed.
    filament_mm: float
    #: Its weight, g.
    filament_g: float
    #: Its price, in the currency of the material's profile.
    filament_cost: float
    #: Moves, arcs counted by their chords.
    moves: int
    #: Lines that no firmware would execute.
    garbage_lines: int
    #: Whether E was taken as relative though the file does not say so, since it runs backwards.
    relative_assumed: bool
    #: Printer whose limits apply; None: those of a table.
    printer: str | None = field(default=None, compare=False)
    #: Why these: ``as named``, ``as the file says``, ``by default``.
    why: str = field(default="", compare=False)
    #: What the program that wrote the file thinks, s; None if it does not say.
    stated_s: float | None = field(default=None, compare=False)
    #: One row for each move, where asked for.
    per_move: PerMove | None = None

    def __repr__(self) -> str:
        """Say how long it takes."""
        return f"<Estimate {duration(self.total_s)}, {self.filament_g:.1f} g, {self.moves} moves>"

    @property
    def remarks(self) -> tuple[str, ...]:
        """What was taken otherwise than it stands in the file, or not timed, in sentences."""
        remarks = [RELATIVE_ASSUMED] if self.relative_assumed else []
        if self.tool_changes and not self.tool_change_s:
            remarks.append(
                f"{self.tool_changes} changes of tool or filament count no time "
                "(allowances.tool_change_s)"
            )
        return tuple(remarks)

    def to_dict(self) -> dict[str, Any]:
        """Everything but the rows, as values that JSON knows."""
        names = [name for name in self.__slots__ if name != "per_move"]
        values = {name: getattr(self, name) for name in names}
        values["remarks"] = list(self.remarks)
        values["by_layer"] = [
            {"z_mm": layer.z_mm, "time_s": layer.time_s} for layer in self.by_layer
        ]
        return values


def estimate(
    source: str | os.PathLike[str] | bytes,
    limits: Mapping[str, Any] | str | None = None,
    *,
    printer: str | Settings | None = None,
    material: str | None = None,
    firmware: Firmware | None = None,
    allowances: Allowances = Allowances(),
    per_move: bool = False,
) -> Estimate:
    """Time a G-code file, or G-code in memory, as a firmware's planner would.

    Parameters
    ----------
    source
        Path of a file, or the text itself as bytes.
    limits
        The machine's limits (mm, mm/s, mm/s²): a mapping with the keys of ``[motion]`` in a
        printer's profile and ``kinematics``, or ``FILE.toml#TABLE``.
    printer
        In place of `limits`: name of a profile, or path of one, or settings, which name the
        material, too. Default: the printer that the file says it is for, if that is known, else
        kossel-mini.
    material
        Profile whose density and price apply to the filament. Default: likewise, else abs.
    firmware
        ``klipper``, ``marlin`` (junction deviation) or ``marlin-jerk`` (classic jerk). Default: the
        printer's own; ``klipper`` for `limits`.
    allowances
        Time for homing, heating and changes of tool.
    per_move
        Whether to keep one row for each move.

    Returns
    -------
    Estimate

    Raises
    ------
    SettingError
        A profile, limit or argument is wrong.
    GcodeError
        The file cannot be read, or nothing in it is G-code.

    Examples
    --------
    >>> round(estimate(b"G1 X100 F6000", printer="printrbot-simple").total_s, 2)
    1.05
    """
    choice = Choice(limits, printer, material, firmware)
    if not isinstance(source, bytes):
        return estimate_files([source], choice, allowances, per_move=per_move)[0]
    return _of_text(source, TEXT, choice, _options(allowances, per_move))


def estimate_files(
    paths: Sequence[str | os.PathLike[str]],
    choice: Choice,
    allowances: Allowances = Allowances(),
    *,
    per_move: bool = False,
) -> list[Estimate]:
    """Time files in parallel, the results in their order.

    Parameters
    ----------
    paths
        G-code files.
    choice
        What is known of the machine.
    allowances, per_move
        As for `estimate`.

    Raises
    ------
    GcodeError
        For the first file that cannot be read.
    """
    options = _options(allowances, per_move)
    found: list[Estimate | None] = [None] * len(paths)
    streamed: list[tuple[int, Machine, bytes]] = []
    for i, path in enumerate(paths):
        if kind_of(path) is None and Path(path).is_file():
            ends = _ends(path)
            streamed.append((i, choice.machine(ends, os.fspath(path)), ends))
        else:
            found[i] = _of_text(*read(path), choice, options)
    machines = [machine for _, machine, _ in streamed]
    for machine in (one for i, one in enumerate(machines) if one not in machines[:i]):
        group = [(i, ends) for i, one, ends in streamed if one == machine]
        names = [os.fspath(paths[i]) for i, _ in group]
        results = _core.estimate_files(names, machine.limits, machine.firmware, **options)
        for (i, ends), name, result in zip(group, names, results, strict=True):
            found[i] = _checked(result, name, machine, ends)
    return [one for one in found if one is not None]


def _of_text(text: bytes, name: str, choice: Choice, options: dict[str, Any]) -> Estimate:
    machine = choice.machine(text, name)
    found = _core.estimate(text, machine.limits, machine.firmware, **options)
    # A search of all of it would take longer than the estimate.
    ends = text[:_END_BYTES] + text[max(_END_BYTES, len(text) - _END_BYTES) :]
    return _checked(found, name, machine, ends)


def _options(allowances: Allowances, per_move: bool) -> dict[str, Any]:
    times = (
        allowances.homing_s,
        allowances.nozzle_heating_s,
        allowances.bed_heating_s,
        allowances.tool_change_s,
    )
    return {"allowances_s": times, "per_move": per_move}


def _ends(path: str | os.PathLike[str]) -> bytes:
    """Beginning and end of a file, where programs say for which printer it is."""
    with open(path, "rb") as file:
        begin = file.read(_END_BYTES)
        file.seek(0, os.SEEK_END)
        file.seek(max(len(begin), file.tell() - _END_BYTES))
        return begin + file.read()


def _checked(
    found: _core.Estimate | Exception, name: str, machine: Machine, ends: bytes
) -> Estimate:
    if isinstance(found, Exception):
        raise found
    if found.moves == 0 and found.garbage_lines > 0:
        msg = f"{name}: nothing in it is G-code; {NO_GCODE}"
        raise GcodeError(msg)
    rows = found.per_move
    return Estimate(
        firmware=machine.firmware,
        total_s=found.total_s,
        moving_s=found.moving_s,
        dwell_s=found.dwell_s,
        travel_s=found.travel_s,
        homing_s=found.homing_s,
        heating_s=found.heating_s,
        tool_change_s=found.tool_change_s,
        tool_changes=found.tool_changes,
        by_feature=dict(found.by_feature),
        by_layer=tuple(LayerTime(z_mm, time_s) for z_mm, time_s in found.by_layer),
        filament_mm=found.filament_mm,
        filament_g=machine.filament.grams(found.filament_mm),
        filament_cost=machine.filament.cost(found.filament_mm),
        moves=found.moves,
        garbage_lines=found.garbage_lines,
        relative_assumed=found.relative_assumed,
        printer=machine.printer,
        why=machine.why,
        stated_s=stated_time_s(ends),
        per_move=None if rows is None else PerMove(*rows[:3], tuple(rows[3])),
    )
