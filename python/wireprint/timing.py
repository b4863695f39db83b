"""Print time: what a firmware's planner makes of a G-code file."""

from __future__ import annotations

import math
import os
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from wireprint import _core
from wireprint import limits as motion_limits
from wireprint._core import GcodeError

if TYPE_CHECKING:
    from collections.abc import Mapping, Sequence

    import numpy as np
    import numpy.typing as npt

    from wireprint.limits import Firmware, MotionTable
    from wireprint.settings import Settings


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
    material: str = "abs",
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
        In place of `limits`: name of a profile, or path of one.
    material
        Profile whose density and price apply to the filament.
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
    machine = Machine.of(limits, printer, material, firmware)
    options = _options(allowances, per_move)
    if isinstance(source, bytes):
        found = _core.estimate(source, machine.limits, machine.firmware, **options)
        return _checked(found, "the text", machine.filament)
    return machine.estimate_files([source], allowances, per_move=per_move)[0]


@dataclass(frozen=True, slots=True)
class Machine:
    """What all files of one run share."""

    limits: MotionTable
    firmware: Firmware
    filament: Filament

    @classmethod
    def of(
        cls,
        limits: Mapping[str, Any] | str | None,
        printer: str | None,
        material: str,
        firmware: Firmware | None,
    ) -> Machine:
        """Resolve the arguments of `estimate`."""
        from wireprint.settings import Settings

        chosen = {} if printer is None else {"printer": printer}
        settings = Settings.load(material=material, **chosen)
        filament = Filament.of(settings)
        if limits is None:
            own = motion_limits.firmware_of(settings.printer)
            return cls(motion_limits.of_printer(settings.printer), firmware or own, filament)
        if printer is not None:
            raise _core.SettingError("limits and printer exclude each other")
        if isinstance(limits, str):
            return cls(motion_limits.of_file(limits), firmware or "klipper", filament)
        return cls(motion_limits.of_mapping(limits), firmware or "klipper", filament)

    def estimate_files(
        self,
        paths: Sequence[str | os.PathLike[str]],
        allowances: Allowances,
        *,
        per_move: bool = False,
    ) -> list[Estimate]:
        """Time files in parallel, the results in their order.

        Raises
        ------
        GcodeError
            For the first file that cannot be read.
        """
        found = _core.estimate_files(
            [os.fspath(path) for path in paths],
            self.limits,
            self.firmware,
            **_options(allowances, per_move),
        )
        return [
            _checked(one, os.fspath(path), self.filament)
            for one, path in zip(found, paths, strict=True)
        ]


def clock(seconds: float) -> str:
    """Write a time as people read it: ``2:26`` or ``1:59:07``."""
    minutes, rest = divmod(round(seconds), 60)
    hours, minutes = divmod(minutes, 60)
    return f"{hours}:{minutes:02}:{rest:02}" if hours else f"{minutes}:{rest:02}"


def _options(allowances: Allowances, per_move: bool) -> dict[str, Any]:
    times = (allowances.homing_s, allowances.nozzle_heating_s, allowances.bed_heating_s)
    return {"allowances_s": times, "per_move": per_move}


def _checked(found: _core.Estimate | Exception, name: str, filament: Filament) -> Estimate:
    if isinstance(found, Exception):
        raise found
    if found.moves == 0 and found.garbage_lines > 0:
        msg = f"{name}: nothing in it is G-code"
        raise GcodeError(msg)
    rows = found.per_move
    return Estimate(
        total_s=found.total_s,
        moving_s=found.moving_s,
        dwell_s=found.dwell_s,
        travel_s=found.travel_s,
        homing_s=found.homing_s,
        heating_s=found.heating_s,
        by_feature=dict(found.by_feature),
        by_layer=tuple(LayerTime(z_mm, time_s) for z_mm, time_s in found.by_layer),
        filament_mm=found.filament_mm,
        filament_g=filament.grams(found.filament_mm),
        filament_cost=filament.cost(found.filament_mm),
        moves=found.moves,
        garbage_lines=found.garbage_lines,
        per_move=None if rows is None else PerMove(*rows[:3], tuple(rows[3])),
    )
