"""Filament: what weight and cost are computed from."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from wireprint.settings import Settings


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
