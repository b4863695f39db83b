"""Every knob of wireprint: its unit, its bounds, its default and where the default comes from.

Units stand in the names: ``_mm``, ``_mm_s``, ``_mm3_s``, ``_s``, ``_c``, ``_deg``. The one
exception is ``[motion]``, which keeps the names that Klipper and ``--limits`` files use. Each group
has a module of its own here; bounds of a machine's figures are in `wireprint.bounds`.
"""

# No `from __future__ import annotations` here: pydantic would have to evaluate every one of
# them, which costs more than the rest of this module.

import math
from pathlib import Path
from typing import TYPE_CHECKING, Any, Final, Self

from pydantic import Field, model_validator

from wireprint.settings.calibration import Calibration
from wireprint.settings.layers import Layerwise, Regions
from wireprint.settings.material import Material
from wireprint.settings.printer import Printer
from wireprint.settings.section import Section
from wireprint.settings.wire import Wire

if TYPE_CHECKING:
    from collections.abc import Iterable, Mapping

    from wireprint.keys import Key

#: Share of what a hot end melts that is asked for: coordinates of three decimals shorten a strand
#: of a twentieth of a millimetre by so much, and its flow rises with that.
_ROUNDED: Final = 0.97


class Settings(Section):
    """One printer, one material, one way of wiring.

    Examples
    --------
    >>> settings = Settings.load(material="abs", overrides=["head.slant_deg=40"])
    >>> settings.printer.head.slant_deg
    40.0
    >>> round(settings.pause_s, 1)
    1.0
    """

    printer: Printer
    material: Material
    wire: Wire = Field(default_factory=Wire)
    layerwise: Layerwise = Field(default_factory=Layerwise)
    regions: Regions = Field(default_factory=Regions)
    calibration: Calibration | None = Field(None, description="None: nothing was measured")

    @model_validator(mode="after")
    def _a_valve_has_a_pin(self) -> Self:
        cooling, flavor = self.printer.cooling, self.printer.gcode.flavor
        if cooling.method == "valve" and cooling.valve_pin is None and flavor != "klipper":
            msg = f"cooling.method is valve: {flavor} needs cooling.valve_pin, the pin of the valve"
            raise ValueError(msg)
        return self

    @model_validator(mode="after")
    def _slabs_have_a_range(self) -> Self:
        if self.slab_min_mm > self.slab_max_mm:
            msg = (
                f"wire.slab_min_mm ({self.slab_min_mm:g}) exceeds "
                f"wire.slab_max_mm ({self.slab_max_mm:g})"
            )
            raise ValueError(msg)
        if self.slab_max_mm > self.printer.head.cone_height_mm:
            msg = (
                f"wire.slab_max_mm ({self.slab_max_mm:g}) exceeds "
                f"head.cone_height_mm ({self.printer.head.cone_height_mm:g}): "
                "the heater block would hit the posts"
            )
            raise ValueError(msg)
        return self

    @property
    def strand_mm(self) -> float:
        """Diameter of a strand, mm: as wide as the nozzle, unless more is fed."""
        return self.printer.head.nozzle_mm * math.sqrt(self.wire.flow)

    @property
    def slab_min_mm(self) -> float:
        """Lowest slab, mm."""
        return self.wire.slab_min_mm or min(2 * self.strand_mm, self.printer.head.cone_height_mm)

    @property
    def slab_max_mm(self) -> float:
        """Highest slab, mm."""
        return self.wire.slab_max_mm or self.printer.head.cone_height_mm

    @property
    def first_layer_height_mm(self) -> float:
        """Height of the tip over the bed where strands lie on it, mm."""
        return self.wire.first_layer_height_mm or self.strand_mm / 2

    @property
    def print_mm_s(self) -> float:
        """Speed along strands, mm/s: as asked for, but no faster than the hot end melts."""
        return min(self.printer.speeds.print_mm_s, self._melting_mm_s)

    @property
    def first_layer_mm_s(self) -> float:
        """Speed along strands on the bed, mm/s: likewise."""
        return min(self.printer.speeds.first_layer_mm_s, self._melting_mm_s)

    @property
    def _melting_mm_s(self) -> float:
        """Speed at which a strand takes all that the hot end melts, mm/s."""
        section_mm2 = math.pi / 4 * self.strand_mm**2
        return _ROUNDED * self.printer.extruder.max_flow_mm3_s / section_mm2

    @property
    def pause_s(self) -> float:
        """Pause at the end of a floating stroke, s: as asked for, as measured, or as computed."""
        if self.wire.pause_s is not None:
            return self.wire.pause_s
        calibration = self.calibrated_by()
        return self.solidify_s if calibration is None else calibration.pause_s

    def calibrated_by(self) -> Calibration | None:
        """Return the calibration, if it was measured with what these settings are.

        Returns
        -------
        Calibration or None
            What was measured; None where nothing was, or for another strand or temperature.
        """
        known = self.calibration
        if known is None or self.wire.flow != 1.0:
            return None
        then = (round(known.strand_mm, 6), known.nozzle_c, known.method)
        cooling = self.printer.cooling
        now = (round(self.strand_mm, 6), self.material.nozzle_c, cooling.method)
        return known if then == now else None

    @property
    def solidify_s(self) -> float:
        """Time in which a strand cools until it holds, s."""
        cooling = self.printer.cooling
        air_mm_s: float = getattr(cooling.air_mm_s, cooling.method)
        return self.material.solidify_s(self.strand_mm, air_mm_s)

    @classmethod
    def load(
        cls,
        printer: str = "kossel-mini",
        material: str = "abs",
        load: "Iterable[str | Path]" = (),
        overrides: "Iterable[str]" = (),
        nozzle_mm: float | None = None,
    ) -> Self:
        """Compose settings from profiles, files and single keys; later ones win.

        Parameters
        ----------
        printer, material
            Name of a profile that comes with the package, or path of a TOML file.
        load
            TOML files with any of the tables ``[bed]`` … ``[gcode]``, ``[material]``, ``[wire]``.
        overrides
            ``key=value`` with a dotted key, such as ``head.slant_deg=40``.
        nozzle_mm
            Diameter of another nozzle than the printer's profile has; None: that one. What depends
            on it changes, too: `wireprint.nozzles.changed`.

        Raises
        ------
        SettingError
            Where a profile, key or value is wrong; it names key, file and line.
        """
        from wireprint import _compose

        return _compose.compose(cls, {}, printer, material, load, overrides, nozzle_mm)

    def but(
        self,
        printer: str | None = None,
        material: str | None = None,
        load: "Iterable[str | Path]" = (),
        overrides: "Iterable[str]" = (),
        nozzle_mm: float | None = None,
    ) -> Self:
        """Return these settings with others laid over them.

        Parameters
        ----------
        printer, material
            As for `load`; None keeps what these settings have.
        load, overrides, nozzle_mm
            As for `load`.

        Returns
        -------
        Settings
            New ones; these stay as they are.

        Raises
        ------
        SettingError
            See `load`.
        """
        from wireprint import _compose

        base = self.model_dump(mode="json")
        return _compose.compose(type(self), base, printer, material, load, overrides, nozzle_mm)

    @classmethod
    def from_mapping(cls, values: "Mapping[str, Any]") -> Self:
        """Validate a mapping of the form that ``model_dump`` gives.

        Parameters
        ----------
        values
            Tables by name, values by key.

        Returns
        -------
        Settings
            What they amount to.

        Raises
        ------
        SettingError
            Where a key or value is wrong.
        """
        from wireprint import _compose

        return _compose.validate(cls, values, {})

    def __repr__(self) -> str:
        """Say whose they are; ``model_dump()`` holds every value."""
        return f"<Settings {self.printer.name} with {self.material.name}>"

    __str__ = __repr__


def describe() -> "tuple[Key, ...]":
    """List every key that can be set, with its unit, bounds, default and help.

    Returns
    -------
    tuple of Key
        In the order of the settings; `Key.to_dict` gives values that JSON knows.

    Examples
    --------
    >>> {key.short: key.bounds for key in describe()}["head.slant_deg"]
    '5 … 85'
    """
    from wireprint.keys import described

    return described(Settings)
