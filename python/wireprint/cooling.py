"""How fast a strand cools: Newton's law for a cylinder in air that stands or blows across it.

Sources: Churchill & Chu 1975 (free convection about a level cylinder), Churchill & Bernstein 1977
(cross-flow), joined as the cubes' sum (Churchill 1977); dry air by the U.S. Standard Atmosphere
1976. Temperatures are in °C, everything else in SI units but where a name says otherwise.
"""

from __future__ import annotations

import math
from typing import Final

_KELVIN: Final = 273.15
_GRAVITY: Final = 9.80665
_STEFAN_BOLTZMANN: Final = 5.670374e-8
#: Of plastics, which all shine alike in the infrared.
_EMISSIVITY: Final = 0.92
_PRESSURE_PA: Final = 101325.0
_GAS_CONSTANT_J_KGK: Final = 287.053
_AIR_HEAT_J_KGK: Final = 1006.0
#: Steps of Simpson's rule: the error is below a millionth of a second for any strand.
_STEPS: Final = 8


def nusselt_still(rayleigh: float, prandtl: float) -> float:
    """Return the Nusselt number of a level cylinder in still air (Churchill & Chu)."""
    damping = math.pow(1 + math.pow(0.559 / prandtl, 9 / 16), 8 / 27)
    return math.pow(0.60 + 0.387 * math.pow(rayleigh, 1 / 6) / damping, 2)


def nusselt_across(reynolds: float, prandtl: float) -> float:
    """Return the Nusselt number of a cylinder in a cross-flow (Churchill & Bernstein)."""
    damping = math.pow(1 + math.pow(0.4 / prandtl, 2 / 3), 1 / 4)
    growth = math.pow(1 + math.pow(reynolds / 282000, 5 / 8), 4 / 5)
    return 0.3 + 0.62 * math.sqrt(reynolds) * math.cbrt(prandtl) / damping * growth


def heat_transfer_w_m2k(
    strand_mm: float, strand_c: float, air_c: float, air_mm_s: float, conductivity_w_mk: float
) -> float:
    """Return the heat transfer from a strand's mean temperature to the air, W/(m²·K).

    Parameters
    ----------
    strand_mm
        Diameter of the strand, mm.
    strand_c, air_c
        Mean temperature of the strand, and that of the air; the strand is the hotter.
    air_mm_s
        Speed of the air across the strand, mm/s.
    conductivity_w_mk
        Of the material, W/(m·K).

    Notes
    -----
    ``1/h = 1/(h_c + h_r) + d/(8k)``: convection and radiation at the surface, and the gradient
    inside, which is a parabola once the strand has begun to cool.
    """
    diameter, strand, air = strand_mm / 1000, strand_c + _KELVIN, air_c + _KELVIN
    film = (strand + air) / 2
    viscosity = 1.458e-6 * math.pow(film, 1.5) / (film + 110.4)
    conductivity = 2.64638e-3 * math.pow(film, 1.5) / (film + 245.4 * math.pow(10, -12 / film))
    kinematic = viscosity * _GAS_CONSTANT_J_KGK * film / _PRESSURE_PA
    prandtl = _AIR_HEAT_J_KGK * viscosity / conductivity
    rayleigh = prandtl * _GRAVITY * (strand - air) / film * diameter**3 / kinematic**2
    reynolds = air_mm_s / 1000 * diameter / kinematic
    still, across = nusselt_still(rayleigh, prandtl), nusselt_across(reynolds, prandtl)
    convection = math.cbrt(still**3 + across**3) * conductivity / diameter
    radiation = _EMISSIVITY * _STEFAN_BOLTZMANN * (strand**2 + air**2) * (strand + air)
    return 1 / (1 / (convection + radiation) + diameter / (8 * conductivity_w_mk))


def cooling_s(
    strand_mm: float,
    from_c: float,
    to_c: float,
    *,
    air_c: float,
    air_mm_s: float,
    density_g_cm3: float,
    specific_heat_j_kgk: float,
    conductivity_w_mk: float,
) -> float:
    """Return the time in which a strand's mean temperature falls, s.

    Parameters
    ----------
    strand_mm
        Diameter of the strand, mm.
    from_c, to_c
        Temperatures before and after, both above `air_c`.
    air_c, air_mm_s
        Temperature of the air, and its speed across the strand, mm/s.
    density_g_cm3, specific_heat_j_kgk, conductivity_w_mk
        Of the material.

    Notes
    -----
    ``dT/dt = -4h(T)·(T - Tₐ)/(ρ·c·d)``, integrated over the logarithm of ``T - Tₐ``.
    """
    capacity = 1000 * density_g_cm3 * specific_heat_j_kgk * strand_mm / 1000 / 4
    last, first = math.log(to_c - air_c), math.log(from_c - air_c)
    step = (first - last) / _STEPS

    def resistance(logarithm: float) -> float:
        strand_c = air_c + math.exp(logarithm)
        return 1 / heat_transfer_w_m2k(strand_mm, strand_c, air_c, air_mm_s, conductivity_w_mk)

    weights = [1, *(4 if i % 2 else 2 for i in range(1, _STEPS)), 1]
    area = sum(w * resistance(last + i * step) for i, w in enumerate(weights)) * step / 3
    return capacity * area
