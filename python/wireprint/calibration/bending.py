"""How far a strand bends that stands out level and has a weight at its end."""

from __future__ import annotations

import math
from typing import Final

import numpy as np

#: Standard gravity, m/s².
GRAVITY_M_S2: Final = 9.80665
#: Points of Gauss and Legendre's rule; integrands are smooth, and steep only near a hanging strand.
_NODES, _WEIGHTS = (values / 2 for values in np.polynomial.legendre.leggauss(48))
_ALONG: Final = _NODES + 0.5
#: Halvings of the sine of the end's slope.
_HALVINGS: Final = 60


def stiffness_n_mm2(weight_g: float, length_mm: float, drop_mm: float) -> float:
    """Return the bending stiffness of a strand, N·mm², by how far its end drops.

    Parameters
    ----------
    weight_g
        What hangs at its end, g.
    length_mm
        Of strand between its clamp and the weight, mm.
    drop_mm
        How far its end moves down, less than the length, mm.

    Notes
    -----
    The elastica, for drops of any size: with ``s`` the sine of the slope at its end and
    ``sin θ = s·(1 − t²)``, ``W·L²/EI = ½·I²`` with ``I = ∫ 2·√s/cos θ dt`` and a drop of
    ``∫ sin θ ds``. Small drops follow ``W·L³/(3·EI)``. Source: Bisshopp & Drucker 1945.
    """
    low, high = 0.0, 1.0
    for _ in range(_HALVINGS):
        sine = (low + high) / 2
        if _drop(sine)[0] * length_mm < drop_mm:
            low = sine
        else:
            high = sine
    load = _drop((low + high) / 2)[1]
    return weight_g / 1000 * GRAVITY_M_S2 * length_mm**2 / load


def drop_mm(weight_g: float, length_mm: float, stiffness: float) -> float:
    """Return how far the end of a strand drops, mm; its stiffness in N·mm²."""
    load = weight_g / 1000 * GRAVITY_M_S2 * length_mm**2 / stiffness
    low, high = 0.0, 1.0
    for _ in range(_HALVINGS):
        sine = (low + high) / 2
        if _drop(sine)[1] < load:
            low = sine
        else:
            high = sine
    return length_mm * _drop((low + high) / 2)[0]


def of_strand(diameter_mm: float, modulus_mpa: float) -> float:
    """Return the bending stiffness of a round strand, N·mm²."""
    return modulus_mpa * math.pi * diameter_mm**4 / 64


def _drop(sine: float) -> tuple[float, float]:
    """Return drop and load, W·L²/EI, by the sine of the end's slope; the drop in lengths."""
    slopes = sine * (1 - _ALONG**2)
    steps = _WEIGHTS / np.sqrt(1 - slopes**2)
    whole = float(steps.sum())
    if sine <= 0:
        return 0.0, 0.0
    return float((steps * slopes).sum()) / whole, 2 * sine * whole**2
