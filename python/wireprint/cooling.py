"""How fast a strand cools: Newton's law for a cylinder in air that stands or blows across it.

The core computes it, ``rust/core/src/physics/cooling.rs``, which names the sources.
"""

from __future__ import annotations

from wireprint._core import cooling_time, heat_transfer


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
    thermal = {
        "strand_mm": strand_mm,
        "nozzle_c": strand_c,
        "air_c": air_c,
        "density_g_cm3": 1.0,
        "specific_heat_j_kgk": 1.0,
        "conductivity_w_mk": conductivity_w_mk,
    }
    return heat_transfer(thermal, strand_c, air_mm_s)


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
    thermal = {
        "strand_mm": strand_mm,
        "nozzle_c": from_c,
        "air_c": air_c,
        "density_g_cm3": density_g_cm3,
        "specific_heat_j_kgk": specific_heat_j_kgk,
        "conductivity_w_mk": conductivity_w_mk,
    }
    return cooling_time(thermal, to_c, air_mm_s)
