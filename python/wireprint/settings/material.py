"""A filament: ``profiles/materials/*.toml``."""

# No `from __future__ import annotations` here: pydantic would have to evaluate every one of
# them, which costs more than the rest of this module.

from typing import Self

from pydantic import Field, model_validator

from wireprint.cooling import cooling_s
from wireprint.settings.section import Name, Section

#: A strand bears the nozzle's pull from a little above its glass transition on: a model of a
#: bending rod gives 4 to 14 K for all three materials.
_HOLDS_ABOVE_GLASS_K = 5.0


class Material(Section):
    """A filament: ``profiles/materials/*.toml``."""

    name: Name = Field(description="what the profile is called")
    density_g_cm3: float = Field(gt=0.5, le=10, description="of the filament")
    price_per_kg: float = Field(ge=0, le=1e6, description="in the user's currency")
    nozzle_c: int = Field(ge=100, le=500, description="temperature of the nozzle")
    bed_c: int = Field(ge=0, le=200, description="temperature of the bed")
    glass_c: float = Field(ge=-50, le=400, description="glass transition")
    hold_c: float | None = Field(
        None,
        ge=-45,
        le=450,
        description="temperature at which a strand bears the nozzle's pull; None: glass_c + 5",
    )
    air_c: float = Field(25.0, ge=-20, le=100, description="temperature around the print")
    specific_heat_j_kgk: float = Field(gt=100, le=5000, description="between nozzle and hold")
    conductivity_w_mk: float = Field(ge=0.01, le=10, description="of heat, W/(m·K)")
    modulus_mpa: float = Field(
        2200.0, ge=1, le=1e6, description="Young's, of the cold material; ABS unless told"
    )
    strength_mpa: float = Field(
        35.0, ge=0.1, le=1e4, description="of a cold strand, drawn or bent; ABS unless told"
    )
    melt_viscosity_pa_s: float = Field(
        3000.0, ge=1, le=1e7, description="in shear, at the nozzle's temperature; estimated"
    )
    plateau_modulus_pa: float = Field(
        2e5, ge=1, le=1e9, description="of the entangled melt, in shear; estimated"
    )
    draw: float = Field(
        1.1, ge=1, le=2, description="by which the nozzle draws a strand out; a harp tells it"
    )

    @model_validator(mode="after")
    def _cools_from_nozzle_through_hold_to_air(self) -> Self:
        if not self.air_c < self.holding_c < self.nozzle_c:
            name = "glass_c + 5" if self.hold_c is None else "hold_c"
            msg = f"{name} must lie between air_c and nozzle_c"
            raise ValueError(msg)
        return self

    @property
    def holding_c(self) -> float:
        """Temperature at which a strand bears the nozzle's pull, °C."""
        return self.glass_c + _HOLDS_ABOVE_GLASS_K if self.hold_c is None else self.hold_c

    def matter(self, strand_mm: float) -> dict[str, float]:
        """Return what the core knows of a strand: its diameter in mm, and the material."""
        return {
            "strand_mm": strand_mm,
            "nozzle_c": self.nozzle_c,
            "air_c": self.air_c,
            "density_g_cm3": self.density_g_cm3,
            "specific_heat_j_kgk": self.specific_heat_j_kgk,
            "conductivity_w_mk": self.conductivity_w_mk,
            # What is said of the temperature at which strands hold moves all that depends on it.
            "glass_c": self.holding_c - _HOLDS_ABOVE_GLASS_K,
            "modulus_mpa": self.modulus_mpa,
            "melt_viscosity_pa_s": self.melt_viscosity_pa_s,
            "plateau_modulus_pa": self.plateau_modulus_pa,
            "draw": self.draw,
        }

    def solidify_s(self, strand_mm: float, air_mm_s: float) -> float:
        """Time in which a strand cools to the temperature at which it holds, s.

        Parameters
        ----------
        strand_mm
            Diameter of the strand, mm.
        air_mm_s
            Speed of the air across it, mm/s.
        """
        return cooling_s(
            strand_mm,
            self.nozzle_c,
            self.holding_c,
            air_c=self.air_c,
            air_mm_s=air_mm_s,
            density_g_cm3=self.density_g_cm3,
            specific_heat_j_kgk=self.specific_heat_j_kgk,
            conductivity_w_mk=self.conductivity_w_mk,
        )
