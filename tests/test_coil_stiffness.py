"""A wall whose every turn lies on the last gives way as the tube that it is."""

import math

import numpy as np
import pytest

from wireprint import Settings, simulate

RADIUS_MM, PITCH_MM, PER_TURN = 2.2, 0.315, 10


def coil(height_mm, low_mm):
    """A coil on the bed whose first turn is level."""
    lines = ["M83", "G28", "G1 X10 Y0 Z5 F3000", f"G1 X{RADIUS_MM} Y0 Z{low_mm}"]
    for step in range(round(height_mm / PITCH_MM) * PER_TURN + 1):
        angle = 2 * math.pi * step / PER_TURN
        x, y = RADIUS_MM * math.cos(angle), RADIUS_MM * math.sin(angle)
        z = low_mm + max(0, step - PER_TURN) / PER_TURN * PITCH_MM
        lines.append(f"G1 X{x:.3f} Y{y:.3f} Z{z:.3f} E0.2 F600")
    return "\n".join([*lines, "G1 Z200"]).encode()


@pytest.mark.parametrize("height_mm", [20, 40, 80])
def test_a_coil_gives_way_as_a_tube(height_mm):
    settings = Settings.load()
    strand = settings.strand_mm
    forecast = simulate(coil(height_mm, strand / 2), settings)
    ends = forecast.compliance_mm_n[-PER_TURN:]
    moment = math.pi * RADIUS_MM**3 * strand
    tube = height_mm**3 / (3 * settings.material.modulus_mpa * moment)
    assert np.isfinite(ends).all()
    # Turns are joined where they touch, not all along: softer than a tube of one piece.
    assert (ends > tube).all()
    assert (ends < 5 * tube).all()
