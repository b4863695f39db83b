"""Profiles inherit from each other, and another nozzle changes what depends on it."""

import itertools
import tomllib

import pytest

from wireprint import catalogue
from wireprint._core import SettingError
from wireprint.profile_text import whole
from wireprint.settings import Settings
from wireprint.toml_text import written


def profile(folder, name, text):
    path = folder / f"{name}.toml"
    path.write_text(text, encoding="utf-8")
    return path


def test_an_heir_differs_in_what_it_says_and_in_its_name(tmp_path):
    mine = profile(tmp_path, "mine", 'inherits = "prusa-mk4s"\n[bed]\nwidth_mm = 200\n')
    heir = Settings.load(str(mine)).printer
    elder = Settings.load("prusa-mk4s").printer
    assert (heir.name, heir.known_as, heir.bed.width_mm) == ("mine", (), 200)
    bed = heir.bed.model_copy(update={"width_mm": elder.bed.width_mm})
    named = {"name": elder.name, "known_as": elder.known_as, "bed": bed}
    assert heir.model_copy(update=named) == elder


def test_a_path_is_meant_from_where_the_file_lies(tmp_path, monkeypatch):
    (tmp_path / "family").mkdir()
    profile(tmp_path / "family", "elder", 'inherits = "voron-2.4"\n[speeds]\nprint_mm_s = 17\n')
    profile(tmp_path, "heir", 'inherits = "family/elder.toml"\nname = "Heir"\n')
    monkeypatch.chdir("/")
    heir = Settings.load(str(tmp_path / "heir.toml")).printer
    assert (heir.name, heir.speeds.print_mm_s, heir.kinematics) == ("Heir", 17, "corexy")


def test_a_material_inherits_too(tmp_path):
    mine = profile(tmp_path, "mine", 'inherits = "pla"\nnozzle_c = 230\n')
    assert Settings.load(material=str(mine)).material.nozzle_c == 230


def test_a_bed_of_another_shape_takes_no_sizes_over(tmp_path):
    text = 'inherits = "prusa-mk4s"\n[bed]\nshape = "round"\ndiameter_mm = 180\norigin = "centre"\n'
    bed = Settings.load(str(profile(tmp_path, "mine", text))).printer.bed
    assert (bed.shape, bed.size_mm, bed.height_mm) == ("round", (180, 180), 220)


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ('\ninherits = "prusa-mk4z"\n', r"mine\.toml:2: inherits: .*did you mean prusa-mk4"),
        ('inherits = "mine.toml"\n', r"mine\.toml:1: inherits: a circle: mine\.toml → mine\.toml"),
        ('inherits = "other.toml"\n', r"mine\.toml:1: inherits: .*other\.toml: no such file"),
        ("inherits = 3\n", r"mine\.toml:1: inherits: 3 is no name"),
        (
            'inherits = "voron-2.4"\n\n[bed]\nwidht_mm = 3\n',
            r"mine\.toml:4: bed\.widht_mm: unknown",
        ),
        ('inherits = "voron-2.4"\n[bed]\nwidth_mm = 1\n', r"mine\.toml:3: bed\.width_mm: input"),
    ],
)
def test_what_is_wrong_names_file_line_and_key(tmp_path, text, message):
    with pytest.raises(SettingError, match=message):
        Settings.load(str(profile(tmp_path, "mine", text)))


def test_a_fault_of_an_elder_is_laid_to_its_file(tmp_path):
    profile(tmp_path, "elder", 'inherits = "voron-2.4"\n[head]\nslant_deg = 90\n')
    heir = profile(tmp_path, "heir", 'inherits = "elder.toml"\n')
    with pytest.raises(SettingError, match=r"elder\.toml:3: head\.slant_deg: input"):
        Settings.load(str(heir))


def test_a_circle_of_several_is_told_whole(tmp_path):
    for name, elder in (("a", "b"), ("b", "c"), ("c", "b")):
        profile(tmp_path, name, f'inherits = "{elder}.toml"\n')
    circle = r"c\.toml:1: inherits: a circle: a\.toml → b\.toml → c\.toml → b\.toml"
    with pytest.raises(SettingError, match=circle):
        Settings.load(str(tmp_path / "a.toml"))


def test_a_line_of_many_elders_is_refused(tmp_path):
    profile(tmp_path, "p0", 'inherits = "voron-2.4"\n')
    for older, younger in itertools.pairwise(range(30)):
        profile(tmp_path, f"p{younger}", f'inherits = "p{older}.toml"\n')
    with pytest.raises(SettingError, match="more than 10 files"):
        Settings.load(str(tmp_path / "p29.toml"))


@pytest.mark.parametrize(
    ("kind", "name"), [(kind, name) for kind in catalogue.KINDS for name in catalogue.names(kind)]
)
def test_a_profile_that_is_shown_says_by_itself_what_it_is(kind, name, tmp_path):
    shown = profile(tmp_path, "shown", "\n".join(whole(kind, name)))
    assert "inherits" not in tomllib.loads(shown.read_text(encoding="utf-8"))
    option = kind.removesuffix("s")
    assert Settings.load(**{option: str(shown)}) == Settings.load(**{option: name})


def test_what_is_inherited_keeps_its_source_where_it_is_shown(tmp_path):
    text = '# Mine.\ninherits = "prusa-mk4s"\n[bed]\nwidth_mm = 200  # measured\n'
    lines = whole("printers", str(profile(tmp_path, "mine", text)))
    assert lines[0] == "# Mine."
    assert any(line.startswith("width_mm = 200") and "# measured" in line for line in lines)
    assert any(line.startswith("depth_mm = 210") and "# Orca" in line for line in lines)


@pytest.mark.parametrize(
    "text",
    [
        "",
        "\n",
        'a "quoted" \\ thing',
        '"""',
        "G28\nM104 S0\n",
        '\n"""\n\\n\\\n',
        "é\t\x7f\x1f",
        "'''",
    ],
)
def test_any_text_survives_the_way_through_toml(text):
    values = {
        "gcode": {"start": text, "sizes": [[1, 2, "QOI"], [3, 4]], "macros": [{"name": text}]}
    }
    assert tomllib.loads(written(values, {}, ["head"])) == values


@pytest.mark.parametrize("printer", catalogue.names("printers"))
@pytest.mark.parametrize("nozzle_mm", [0.4, 0.6, 0.8])
def test_a_nozzle_changes_what_depends_on_it_and_nothing_else(printer, nozzle_mm):
    usual = Settings.load(printer).printer
    fitted = Settings.load(printer, nozzle_mm=nozzle_mm).printer
    old_mm = usual.head.nozzle_mm
    assert fitted.head.nozzle_mm == nozzle_mm
    land_mm = usual.head.tip_radius_mm - old_mm / 2
    assert fitted.head.tip_radius_mm - nozzle_mm / 2 == pytest.approx(land_mm)
    assert fitted.extruder.max_flow_mm3_s <= usual.extruder.max_flow_mm3_s
    wider = nozzle_mm >= old_mm
    assert (fitted.extruder.pressure_lag_s <= usual.extruder.pressure_lag_s) is (
        wider or not usual.extruder.pressure_lag_s
    )
    head = {key: getattr(usual.head, key) for key in ("nozzle_mm", "tip_radius_mm")}
    fed = {key: getattr(usual.extruder, key) for key in ("max_flow_mm3_s", "pressure_lag_s")}
    same = {
        "head": fitted.head.model_copy(update=head),
        "extruder": fitted.extruder.model_copy(update=fed),
    }
    assert fitted.model_copy(update=same) == usual


def test_the_profiles_own_nozzle_changes_nothing():
    for printer in catalogue.names("printers"):
        usual = Settings.load(printer)
        assert Settings.load(printer, nozzle_mm=usual.printer.head.nozzle_mm) == usual


def test_a_single_setting_wins_over_the_nozzle():
    settings = Settings.load("prusa-mk4s", nozzle_mm=0.8, overrides=["head.tip_radius_mm=0.9"])
    assert settings.printer.head.tip_radius_mm == 0.9


@pytest.mark.parametrize("nozzle_mm", [0, -1, 3, float("nan"), float("inf"), 1e-9])
def test_a_nozzle_that_nobody_makes_is_refused(nozzle_mm):
    with pytest.raises(SettingError, match=r"--nozzle .* within 0\.1–2 mm"):
        Settings.load(nozzle_mm=nozzle_mm)


def test_a_projects_printer_takes_another_nozzle():
    other = Settings.load("prusa-mk4s").but(nozzle_mm=0.6)
    assert other == Settings.load("prusa-mk4s", nozzle_mm=0.6)
