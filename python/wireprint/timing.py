"""Print time: what a firmware's planner makes of a G-code file."""

from __future__ import annotations

import math
import os
from dataclasses import asdict, dataclass, field
from functools import cached_property
from pathlib import Path
from typing import TYPE_CHECKING, Any, Final

from wireprint import _core
from wireprint import limits as motion_limits
from wireprint._core import GcodeError, SettingError
from wireprint.gcode.origin import stated_time_s
from wireprint.gcode.source import NO_GCODE, TEXT, kind_of, read
from wireprint.naming import named

if TYPE_CHECKING:
    from collections.abc import Mapping, Sequence

    import numpy as np
    import numpy.typing as npt

    from wireprint.limits import Firmware, MotionTable
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
class Filament:
    """What weight and cost are computed from."""

    diameter_mm: float
    density_g_cm3: float
    price_per_kg: float

    @classmethod
    def of(cls, settings: Settings) -> Filament:
        """Return the filament of a printer and a material."""
        return cls(
            settings.printer.extruder.filament_diameter_mm,
            settings.material.density_g_cm3,
            settings.material.price_per_kg,
        )

    def grams(self, length_mm: float) -> float:
        """Weight of a length of filament, g."""
        return math.pi / 4 * self.diameter_mm**2 * length_mm * self.density_g_cm3 / 1000

    def cost(self, length_mm: float) -> float:
        """Price of a length of filament, in the currency of the material's profile."""
        return self.grams(length_mm) / 1000 * self.price_per_kg


@dataclass(frozen=True, slots=True)
class LayerTime:
    """Time of one layer."""

    #: Height, mm; None where nothing is extruded.
    z_mm: float | None
    #: Time of its moves and dwells, s.
    time_s: float


@dataclass(frozen=True, slots=True)
class PerMove:
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
        return f"<Estimate {clock(self.total_s)}, {self.filament_g:.1f} g, {self.moves} moves>"

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
    printer: str | None = None,
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
        In place of `limits`: name of a profile, or path of one. Default: the printer that the file
        says it is for, if that is known, else kossel-mini.
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


@dataclass(frozen=True, slots=True)
class Machine:
    """What a file is timed on."""

    limits: MotionTable
    firmware: Firmware
    filament: Filament
    #: Profile that the limits are from, and why it was chosen.
    printer: str | None
    why: str


@dataclass(frozen=True)
class Choice:
    """What is known of the machine; what is None follows from the file, as for `estimate`."""

    limits: Mapping[str, Any] | str | None = None
    printer: str | None = None
    material: str | None = None
    firmware: Firmware | None = None

    def machine(self, text: bytes, name: str = TEXT) -> Machine:
        """Return the machine for a file, given at least its beginning and its end.

        There programs write for which printer it is.

        Raises
        ------
        GcodeError
            The settings at its end are damaged.
        SettingError
            A profile or limit is wrong.
        """
        if self.limits is not None and self.printer is not None:
            raise SettingError("limits and printer exclude each other")
        if self.material is not None and self._limits is not None:
            return self._named
        from wireprint.gcode.origin import known_printer
        from wireprint.gcode.own_settings import settings_in

        with named(None if name == TEXT else name):
            try:
                own = settings_in(text)
            except GcodeError:
                if name != TEXT:
                    # Once more over the whole file, which tells the line as it is counted there.
                    settings_in(Path(name).read_bytes())
                raise
        if own is not None:
            return self._machine(own, "as the file says")
        if self._limits is not None:
            return self._named
        known = known_printer(text)
        return self._default if known is None else self._foreign(*known)

    @cached_property
    def _limits(self) -> MotionTable | None:
        """Limits that do not depend on the file."""
        if self.limits is None:
            return None if self.printer is None else motion_limits.of_printer(self._known.printer)
        if isinstance(self.limits, str):
            return motion_limits.of_file(self.limits)
        return motion_limits.of_mapping(self.limits)

    @cached_property
    def _known(self) -> Settings:
        """Settings of a file that states none."""
        return self._loaded(self.printer)

    def _loaded(self, printer: str | None) -> Settings:
        from wireprint.settings import Settings

        given: dict[str, Any] = {"printer": printer, "material": self.material}
        return Settings.load(**{name: value for name, value in given.items() if value is not None})

    @cached_property
    def _named(self) -> Machine:
        return self._machine(self._known, "as named")

    @cached_property
    def _default(self) -> Machine:
        return self._machine(self._known, "by default: the file names no printer that is known")

    def _foreign(self, printer: str, written: str) -> Machine:
        """Return the machine of a file of another program that names it."""
        return self._machine(self._loaded(printer), f"as the file says ({written})")

    def _machine(self, settings: Settings, why: str) -> Machine:
        """Return the machine of a file's settings, as far as nothing else was chosen."""
        printer = settings.printer if self.printer is None else self._known.printer
        material = settings.material if self.material is None else self._known.material
        its_own = "klipper" if self.limits is not None else motion_limits.firmware_of(printer)
        filament = Filament(
            printer.extruder.filament_diameter_mm, material.density_g_cm3, material.price_per_kg
        )
        chosen = self._limits
        return Machine(
            motion_limits.of_printer(printer) if chosen is None else chosen,
            self.firmware or its_own,
            filament,
            None if self.limits is not None else printer.name,
            why if chosen is None else "as named",
        )


def clock(seconds: float) -> str:
    """Write a time as people read it: ``2:26`` or ``1:59:07``."""
    minutes, rest = divmod(round(seconds), 60)
    hours, minutes = divmod(minutes, 60)
    return f"{hours}:{minutes:02}:{rest:02}" if hours else f"{minutes}:{rest:02}"


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
