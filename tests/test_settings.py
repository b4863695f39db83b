"""Settings: what composes them, what they refuse, and what follows from them."""

import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from wireprint._core import SettingError
from wireprint.settings import Material, Settings


def test_the_default_is_the_papers_kossel_mini_with_abs():
    settings = Settings.load()
    head = settings.printer.head
    assert settings.printer.kinematics == "delta"
    assert (head.slant_deg, head.cone_height_mm, head.nozzle_mm) == (32, 6, 0.7)
    assert settings.printer.speeds.print_mm_s == 30
    assert (settings.slab_min_mm, settings.slab_max_mm) == pytest.approx((1.4, 6.0))
    assert settings.pause_s == pytest.approx(1.0, abs=1e-3)


def test_settings_cannot_be_changed_in_place():
    settings = Settings.load()
    with pytest.raises(ValueError, match="frozen"):
        settings.wire.pattern = "peaks"


def test_later_layers_win(tmp_path):
    file = tmp_path / "mine.toml"
    file.write_text('[head]\nslant_deg = 40\n[wire]\npattern = "peaks"\n[material]\nbed_c = 90\n')
    settings = Settings.load(load=[file], overrides=["head.slant_deg=45"])
    assert settings.printer.head.slant_deg == 45
    assert settings.wire.pattern == "peaks"
    assert settings.material.bed_c == 90
    assert settings.material.nozzle_c == Settings.load().material.nozzle_c


@pytest.mark.parametrize(
    "key", ["slab_max_mm", "wire.slab_max_mm", "head.slant_deg", "printer.head.slant_deg"]
)
def test_a_key_may_leave_out_what_is_clear(key):
    settings = Settings.load(overrides=[f"{key}=5.5"])
    assert 5.5 in (settings.wire.slab_max_mm, settings.printer.head.slant_deg)


def test_a_mapping_round_trips():
    settings = Settings.load(overrides=["wire.skirt_rings=2"])
    assert Settings.from_mapping(settings.model_dump()) == settings


@pytest.mark.parametrize(
    ("override", "message"),
    [
        ("head.slant_dg=3", r"head\.slant_dg: unknown key; did you mean head\.slant_deg\?"),
        ("slant=3", r"unknown key slant; did you mean head\.slant_deg\?"),
        ("nonsense=1", r"unknown key nonsense"),
        ("max_velocity=1", r"max_velocity is ambiguous: .*motion\.max_velocity"),
        ("head.slant_deg", r"expected key=value"),
        ("=3", r"expected key=value"),
        ("head.slant_deg=400", r"head\.slant_deg: input should be less than or equal to 85"),
        ("head.slant_deg=steep", r"head\.slant_deg: input should be a valid number"),
        ("head.slant_deg=nan", r"head\.slant_deg: input should be a finite number"),
        ("head.tip_radius_mm=0.1", r"head: tip_radius_mm is smaller than half of nozzle_mm"),
        ("wire.slab_max_mm=7", r"wire\.slab_max_mm \(7\) exceeds head\.cone_height_mm \(6\)"),
        ("wire.slab_min_mm=6.5", r"wire\.slab_min_mm \(6\.5\) exceeds wire\.slab_max_mm \(6\)"),
        ("bed.width_mm=100", r"bed: a round bed has diameter_mm"),
        ("material.solidify_c=300", r"material: solidify_c must lie between air_c and nozzle_c"),
        ("gcode.flavor=sailfish", r"gcode\.flavor: input should be 'marlin'"),
    ],
)
def test_a_wrong_key_or_value_is_refused_by_name(override, message):
    with pytest.raises(SettingError, match=message) as error:
        Settings.load(overrides=[override])
    assert error.value.exit_code == 4


def test_an_error_in_a_file_names_file_and_line(tmp_path):
    file = tmp_path / "mine.toml"
    file.write_text(
        '# a comment\n[gcode]\nstart = """\n[head]\nslant_deg = 3\n"""\n\n[head]\nslant_deg = 400\n'
    )
    with pytest.raises(SettingError, match=r"mine\.toml:9: head\.slant_deg: "):
        Settings.load(load=[file])


def test_an_unknown_key_in_a_file_names_file_line_and_close_matches(tmp_path):
    file = tmp_path / "mine.toml"
    file.write_text("[wire]\n\nslab_maxx_mm = 4\n")
    with pytest.raises(SettingError, match=r"mine\.toml:3: .*did you mean wire\.slab_max_mm"):
        Settings.load(load=[file])


def test_a_file_that_is_no_toml_is_refused(tmp_path):
    file = tmp_path / "mine.toml"
    file.write_text("[wire\n")
    with pytest.raises(SettingError, match=r"mine\.toml: not TOML: .*line 1"):
        Settings.load(load=[file])


def test_a_missing_file_is_refused(tmp_path):
    with pytest.raises(SettingError, match="No such file"):
        Settings.load(load=[tmp_path / "none.toml"])


@pytest.mark.parametrize(("heat_transfer_w_m2k", "seconds"), [(60, 2.3), (100, 1.4), (200, 0.7)])
def test_the_pause_agrees_with_the_worked_example(heat_transfer_w_m2k, seconds):
    """0.7 mm PLA, 210 → 155 °C: 2.3, 1.4 and 0.7 s, from the published lumped-cooling formula."""
    overrides = [f"material.heat_transfer.fan={heat_transfer_w_m2k}", "cooling.method=fan"]
    assert Settings.load(material="pla", overrides=overrides).pause_s == pytest.approx(
        seconds, abs=0.05
    )


@given(st.floats(0.1, 2), st.sampled_from(["valve", "fan", "none"]))
def test_cooling_obeys_its_differential_equation(strand_mm, method):
    """Newton's law for a cylinder, integrated numerically, takes the same time."""
    material = Settings.load().material
    h = getattr(material.heat_transfer, method)
    rho, c, d = 1000 * material.density_g_cm3, material.specific_heat_j_kgk, strand_mm / 1000
    per_second = 4 * h / (rho * c * d)
    steps = 2000
    step = material.solidify_s(strand_mm, method) / steps
    excess = material.nozzle_c - material.air_c
    for _ in range(steps):
        middle = excess - excess * per_second * step / 2
        excess -= middle * per_second * step
    assert excess + material.air_c == pytest.approx(material.solidify_c, abs=1e-3)


def test_weaker_cooling_means_a_longer_pause():
    pauses = [
        Settings.load(overrides=[f"cooling.method={method}"]).pause_s
        for method in ("valve", "fan", "none")
    ]
    assert pauses == sorted(pauses)
    assert len(set(pauses)) == 3


def test_an_explicit_pause_wins():
    assert Settings.load(overrides=["wire.pause_s=0.25"]).pause_s == 0.25


def test_a_rectangular_bed_has_its_centre_off_the_corner():
    bed = Settings.load(printer="prusa-mk4s").printer.bed
    assert bed.centre_mm == (125, 105)
    assert Settings.load().printer.bed.centre_mm == (0, 0)


def test_every_knob_has_a_description_or_a_unit_in_its_name():
    units = ("_mm", "_mm_s", "_mm3_s", "_s", "_c", "_deg", "_cm3", "_kg", "_kgk", "_velocity")

    def walk(model):
        for name, field in model.model_fields.items():
            if hasattr(field.annotation, "model_fields"):
                yield from walk(field.annotation)
            elif not field.description and not name.endswith((*units, "_accel", "name")):
                yield f"{model.__name__}.{name}"

    exempt = {"Bed.shape", "Printer.kinematics", "Gcode.flavor"}
    assert set(walk(Settings)) == exempt


def test_the_formula_needs_a_material_that_cools():
    values = Settings.load().material.model_dump() | {"air_c": 95.0, "solidify_c": 96.0}
    seconds = Material.model_validate(values).solidify_s(0.7, "fan")
    assert math.isfinite(seconds)
    assert seconds > Settings.load().material.solidify_s(0.7, "fan")
