"""How long a strand takes to hold: the heat it gives to the air, and the pauses that follow."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from wireprint import cooling, examples, load_mesh, make
from wireprint._core import nusselt_across, nusselt_still
from wireprint.settings import Settings

ABS = Settings.load().material


@pytest.mark.parametrize(
    ("nusselt", "value"),
    [
        # Worked out with 40 digits from the papers' formulas (Python's decimal).
        (nusselt_across(4, 0.71), 1.2720759),
        (nusselt_across(100, 0.7), 5.1561317),
        (nusselt_still(0.01, 0.7), 0.5609396),
        (nusselt_still(1, 0.71), 0.8487518),
    ],
)
def test_the_correlations_are_those_of_the_papers(nusselt, value):
    assert nusselt == pytest.approx(value, abs=1e-6)


def test_a_textbooks_cylinder_in_a_wind_tunnel_comes_out():
    """Incropera & DeWitt, Fundamentals of Heat and Mass Transfer, example 7.4."""
    assert nusselt_across(6071, 0.70) == pytest.approx(40.6, abs=0.05)


def bessel(order, x):
    """J0 or J1 by Bessel's integral; the midpoint rule converges faster than any power."""
    angle = (np.arange(400) + 0.5) * np.pi / 400
    return np.cos(order * angle - np.multiply.outer(x, np.sin(angle))).mean(axis=-1)


X = np.linspace(1e-6, 40, 20_001)
J0, J1 = bessel(0, X), bessel(1, X)


def exact_mean_excess(biot, fourier):
    """Mean excess temperature of a cylinder that gives heat to air: twelve terms of the series."""
    balance = X * J1 - biot * J0
    before = np.flatnonzero(np.diff(np.sign(balance)))
    share = balance[before] / (balance[before] - balance[before + 1])
    roots = X[before] + share * (X[1] - X[0])
    terms = 4 * biot**2 / (roots**2 * (roots**2 + biot**2))
    return (terms * np.exp(-(roots**2) * fourier)).sum()


@pytest.mark.parametrize(
    ("strand_mm", "air_mm_s"),
    [
        (0.4, 0),
        (0.4, 3000),
        (0.4, 12000),
        (0.7, 0),
        (0.7, 3000),
        (0.7, 6000),
        (1.2, 0),
        (1.2, 3000),
    ],
)
def test_the_gradient_inside_agrees_with_the_exact_series(strand_mm, air_mm_s):
    """Within 1 % of the whole fall, once the strand has begun to cool (Fourier number 0.2)."""
    inside = ABS.conductivity_w_mk
    outer, whole = (
        cooling.heat_transfer_w_m2k(strand_mm, 150, 25, air_mm_s, k) for k in (1e9, inside)
    )
    biot = outer * strand_mm / 2000 / inside
    assert biot <= 0.8, "beyond what the closed form is for"
    for fourier in (0.2, 0.5, 1, 2, 4):
        # 4·h·t/(ρ·c·d) in terms of the Fourier number on the radius.
        lumped = np.exp(-2 * whole * strand_mm / 2000 / inside * fourier)
        assert lumped == pytest.approx(exact_mean_excess(biot, fourier), abs=0.01)


@given(st.floats(0.1, 2), st.floats(0, 2e4), st.floats(120, 300), st.floats(30, 110))
def test_cooling_obeys_its_differential_equation(strand_mm, air_mm_s, from_c, to_c):
    """Newton's law, integrated numerically in small steps of time, takes the same time."""
    seconds = cooling.cooling_s(
        strand_mm,
        from_c,
        to_c,
        air_c=25,
        air_mm_s=air_mm_s,
        density_g_cm3=1.04,
        specific_heat_j_kgk=2000,
        conductivity_w_mk=0.18,
    )
    steps = 1000
    at_c, step = from_c, seconds / steps
    capacity = 1040 * 2000 * strand_mm / 1000 / 4

    def fall(strand_c):
        h = cooling.heat_transfer_w_m2k(strand_mm, strand_c, 25, air_mm_s, 0.18)
        return h * (strand_c - 25) / capacity

    for _ in range(steps):
        at_c -= step * fall(at_c - step / 2 * fall(at_c))
    assert at_c == pytest.approx(to_c, abs=0.02)


def test_the_papers_pause_comes_out():
    """ABS from a 0.7 mm nozzle under air jets: the paper found 1 s."""
    assert 0.9 <= Settings.load("kossel-mini", "abs").pause_s <= 1.3


@pytest.mark.parametrize(
    ("material", "nozzle_mm", "still", "fan", "jets"),
    [
        # A bending rod that must not lean by half a strand when the nozzle pulls at its tip.
        ("abs", 0.7, 6.8, 1.6, 1.2),
        ("abs", 0.4, None, 0.7, None),
        ("pla", 0.7, None, 2.9, None),
        ("pla", 0.4, 5.5, 1.2, None),
        ("petg", 0.4, None, 1.0, None),
    ],
)
def test_pauses_are_those_after_which_a_post_bears_the_pull(material, nozzle_mm, still, fan, jets):
    for method, expected in (("none", still), ("fan", fan), ("valve", jets)):
        if expected is not None:
            overrides = [
                f"cooling.method={method}",
                f"head.nozzle_mm={nozzle_mm}",
                "air_mm_s.valve=6000",
            ]
            found = Settings.load("kossel-mini", material, overrides=overrides).pause_s
            assert found == pytest.approx(expected, rel=0.05)


@pytest.mark.parametrize("material", ["abs", "pla", "petg"])
@pytest.mark.parametrize("nozzle_mm", [0.25, 0.4, 0.6, 0.7, 1.0])
def test_still_air_needs_three_times_the_pause_of_a_fan(material, nozzle_mm):
    still, fan, jets = (
        Settings.load(
            "kossel-mini",
            material,
            overrides=[f"cooling.method={method}", f"head.nozzle_mm={nozzle_mm}"],
        ).pause_s
        for method in ("none", "fan", "valve")
    )
    assert still >= 3 * fan
    assert fan > jets


def test_full_speed_and_a_pause_beat_a_slow_head(tmp_path):
    """The paper's figure 15, on its sphere: 30 mm/s with a pause against 5 mm/s without."""
    model = tmp_path / "sphere.stl"
    model.write_bytes(examples.stl("sphere"))
    mesh = load_mesh(model)
    times = [
        make(mesh, Settings.load(overrides=[f"wire.strategy={way}"]), certify=False).estimate
        for way in ("pause", "slow")
    ]
    assert times[0].total_s < times[1].total_s
