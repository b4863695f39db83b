"""Print time: what a firmware's planner makes of a G-code file."""

from __future__ import annotations

import math
import os
from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING, Any, Final

from wireprint import _core
from wireprint import limits as motion_limits
from wireprint._core import GcodeError, SettingError
from wireprint.naming import named

if TYPE_CHECKING:
    from collections.abc import Mapping, Sequence

    import numpy as np
    import numpy.typing as npt

    from wireprint.limits import Firmware, MotionTable
    from wireprint.settings import Settings


#: More than the settings at a file's end take.
_TAIL_BYTES: Final = 1 << 16


@dataclass(frozen=True, slots=True)
class Allowances:
    """Time for what G-code commands but does not describe, s; nothing by default."""

    #: For each G28.
    homing_s: float = 0.0
    #: For each M109 to a higher temperature than the last.
    nozzle_heating_s: float = 0.0
    #: For each M190 to a higher temperature than the last.
    bed_heating_s: float = 0.0


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


@dataclass(frozen=True, slots=True)
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
    #: One row for each move, where asked for.
    per_move: PerMove | None = None

    def to_dict(self) -> dict[str, Any]:
        """Everything but the rows, as values that JSON knows."""
        names = [name for name in self.__slots__ if name != "per_move"]
        values = {name: getattr(self, name) for name in names}
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
        was made for if wireprint wrote it, else kossel-mini.
    material
        Profile whose density and price apply to the filament. Default: likewise, else abs.
    firmware
        ``klipper``, ``marlin`` (junction deviation) or ``marlin-jerk`` (classic jerk). Default: the
        printer's own; ``klipper`` for `limits`.
    allowances
        Time for homing and heating.
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
    machine = choice.machine(source)
    options = _options(allowances, per_move)
    found = _core.estimate(source, machine.limits, machine.firmware, **options)
    return _checked(found, "the text", machine)


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
    machines = [_machine_of(path, choice) for path in paths]
    found: list[Estimate | None] = [None] * len(paths)
    for machine in (one for i, one in enumerate(machines) if one not in machines[:i]):
        places = [i for i, one in enumerate(machines) if one == machine]
        results = _core.estimate_files(
            [os.fspath(paths[i]) for i in places],
            machine.limits,
            machine.firmware,
            **_options(allowances, per_move),
        )
        for i, result in zip(places, results, strict=True):
            found[i] = _checked(result, os.fspath(paths[i]), machine)
    return [one for one in found if one is not None]


@dataclass(frozen=True, slots=True)
class Machine:
    """What a file is timed on."""

    limits: MotionTable
    firmware: Firmware
    filament: Filament


@dataclass(frozen=True)
class Choice:
    """What is known of the machine; what is None follows from the file, as for `estimate`."""

    limits: Mapping[str, Any] | str | None = None
    printer: str | None = None
    material: str | None = None
    firmware: Firmware | None = None

    def machine(self, text: bytes) -> Machine:
        """Return the machine for a file, given its end, where wireprint writes its settings.

        Raises
        ------
        SettingError
            A profile or limit is wrong.
        """
        if self.limits is not None and self.printer is not None:
            raise SettingError("limits and printer exclude each other")
        from wireprint.gcode.own_settings import settings_in

        own = settings_in(text) if self.material is None or self._limits is None else None
        return self._chosen if own is None else self._machine(own)

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
        from wireprint.settings import Settings

        given = {"printer": self.printer, "material": self.material}
        return Settings.load(**{name: value for name, value in given.items() if value is not None})

    @cached_property
    def _chosen(self) -> Machine:
        return self._machine(self._known)

    def _machine(self, settings: Settings) -> Machine:
        """Return the machine of a file's settings, as far as nothing else was chosen."""
        printer = settings.printer if self.printer is None else self._known.printer
        material = settings.material if self.material is None else self._known.material
        its_own = "klipper" if self.limits is not None else motion_limits.firmware_of(printer)
        filament = Filament(
            printer.extruder.filament_diameter_mm, material.density_g_cm3, material.price_per_kg
        )
        limits = self._limits or motion_limits.of_printer(printer)
        return Machine(limits, self.firmware or its_own, filament)


def clock(seconds: float) -> str:
    """Write a time as people read it: ``2:26`` or ``1:59:07``."""
    minutes, rest = divmod(round(seconds), 60)
    hours, minutes = divmod(minutes, 60)
    return f"{hours}:{minutes:02}:{rest:02}" if hours else f"{minutes}:{rest:02}"


def _options(allowances: Allowances, per_move: bool) -> dict[str, Any]:
    times = (allowances.homing_s, allowances.nozzle_heating_s, allowances.bed_heating_s)
    return {"allowances_s": times, "per_move": per_move}


def _machine_of(path: str | os.PathLike[str], choice: Choice) -> Machine:
    with named(path):
        try:
            return choice.machine(_tail(path))
        except GcodeError:
            # Only the whole file tells the line of what is damaged.
            with open(path, "rb") as file:
                return choice.machine(file.read())


def _tail(path: str | os.PathLike[str]) -> bytes:
    """End of a file, which holds the settings that wireprint wrote there."""
    with open(path, "rb") as file:
        file.seek(0, os.SEEK_END)
        file.seek(max(0, file.tell() - _TAIL_BYTES))
        return file.read()


def _checked(found: _core.Estimate | Exception, name: str, machine: Machine) -> Estimate:
    if isinstance(found, Exception):
        raise found
    if found.moves == 0 and found.garbage_lines > 0:
        msg = f"{name}: nothing in it is G-code"
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
        by_feature=dict(found.by_feature),
        by_layer=tuple(LayerTime(z_mm, time_s) for z_mm, time_s in found.by_layer),
        filament_mm=found.filament_mm,
        filament_g=machine.filament.grams(found.filament_mm),
        filament_cost=machine.filament.cost(found.filament_mm),
        moves=found.moves,
        garbage_lines=found.garbage_lines,
        per_move=None if rows is None else PerMove(*rows[:3], tuple(rows[3])),
    )
