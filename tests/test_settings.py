"""Settings: what composes them, what they refuse, and what follows from them."""

import pytest

from wireprint._core import SettingError
from wireprint.settings import Settings


def test_the_default_is_the_papers_kossel_mini_with_abs():
    settings = Settings.load()
    head = settings.printer.head
    assert settings.printer.kinematics == "delta"
    assert (head.slant_deg, head.cone_height_mm, head.nozzle_mm) == (32, 6, 0.7)
    assert settings.printer.speeds.print_mm_s == 30
    assert (settings.slab_min_mm, settings.slab_max_mm) == pytest.approx((1.4, 6.0))


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
        ("material.hold_c=300", r"material: hold_c must lie between air_c and nozzle_c"),
        ("material.glass_c=10", r"material: glass_c \+ 5 must lie between air_c and nozzle_c"),
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

    assert list(walk(Settings)) == []


@pytest.mark.parametrize(
    ("printer", "override", "message"),
    [
        ("voron-2.4", 'bed.shape="round"', r"^--set bed\.shape=\"round\": bed: a round bed has"),
        ("prusa-mk4s", "head.carriage_height_mm=3", r"^--set head\.carriage_height_mm=3: head: "),
        ("voron-2.4", "motion.marlin.steps_per_mm=1", r"^--set motion\.marlin\.steps_per_mm=1: "),
    ],
)
def test_a_table_that_is_wrong_as_a_whole_is_laid_to_what_was_set_last(printer, override, message):
    with pytest.raises(SettingError, match=message):
        Settings.load(printer, overrides=[override])
