"""On which machine a file is timed: as named, as the file says, or by default."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from typing import TYPE_CHECKING, Any

from wireprint import limits as motion_limits
from wireprint._core import GcodeError, SettingError
from wireprint.filament import Filament
from wireprint.gcode.source import TEXT
from wireprint.naming import named

if TYPE_CHECKING:
    from collections.abc import Mapping

    from wireprint.limits import Firmware, MotionTable
    from wireprint.settings import Settings


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
    #: Name or path of a profile, or settings, which name the material, too.
    printer: str | Settings | None = None
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
        if self._is_whole and self.material is not None:
            raise SettingError("settings and material exclude each other")
        if (self._is_whole or self.material is not None) and self._limits is not None:
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

    @property
    def _is_whole(self) -> bool:
        """Whether settings are given."""
        return not isinstance(self.printer, str | None)

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

    def _loaded(self, printer: str | Settings | None) -> Settings:
        from wireprint.settings import Settings

        if isinstance(printer, Settings):
            return printer
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
        own = self.material is None and not self._is_whole
        material = settings.material if own else self._known.material
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
