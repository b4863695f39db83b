"""The profiles that come with the package."""

import re

import pytest

from wireprint import catalogue
from wireprint._core import SettingError
from wireprint.settings import Settings

ALL = [(kind, name) for kind in catalogue.KINDS for name in catalogue.names(kind)]


@pytest.mark.parametrize("printer", catalogue.names("printers"))
@pytest.mark.parametrize("material", catalogue.names("materials"))
def test_every_printer_goes_with_every_material(printer, material):
    settings = Settings.load(printer=printer, material=material)
    assert settings.printer.name == printer
    assert settings.material.name == material
    assert 0 < settings.slab_min_mm < settings.slab_max_mm


def test_the_issues_profiles_are_there():
    assert {"kossel-mini", "printrbot-simple"} < set(catalogue.names("printers"))
    assert set(catalogue.names("materials")) >= {"abs", "pla", "petg"}


def test_the_kinds_of_machine_are_all_covered():
    kinds = {Settings.load(printer=name).printer.kinematics for name in catalogue.names("printers")}
    assert kinds == {"delta", "cartesian", "corexy"}


@pytest.mark.parametrize(("kind", "name"), ALL)
def test_every_figure_states_its_source_in_a_comment(kind, name):
    lines = catalogue.find(kind, name).read_text(encoding="utf-8").splitlines()
    figures = [line for line in lines if re.match(r"\w+ = [\[\d]", line)]
    assert figures
    assert [line for line in figures if "#" not in line] == []


@pytest.mark.parametrize(("kind", "name"), ALL)
def test_the_first_line_says_what_it_is(kind, name):
    assert len(catalogue.headline(catalogue.find(kind, name))) > 20


@pytest.mark.parametrize("printer", catalogue.names("printers"))
def test_the_print_speed_is_within_what_the_extruder_melts(printer):
    settings = Settings.load(printer=printer)
    strand_mm2 = 3.14159 / 4 * settings.printer.head.nozzle_mm**2
    flow = strand_mm2 * settings.printer.speeds.print_mm_s
    assert flow <= settings.printer.extruder.max_flow_mm3_s


@pytest.mark.parametrize("printer", ["kossel-mini", "printrbot-simple", "prusa-mk4s"])
def test_klipper_and_marlin_limits_of_a_machine_agree(printer):
    motion = Settings.load(printer=printer).printer.motion
    assert motion.marlin.max_velocity[0] == motion.max_velocity
    assert motion.marlin.max_velocity[2] == motion.max_z_velocity
    assert motion.marlin.max_velocity[3] == motion.max_extrude_only_velocity


def test_a_profile_may_be_a_file_of_the_users(tmp_path):
    text = catalogue.find("printers", "kossel-mini").read_text(encoding="utf-8")
    mine = tmp_path / "mine.toml"
    mine.write_text(text.replace('name = "kossel-mini"', 'name = "mine"'), encoding="utf-8")
    assert Settings.load(printer=str(mine)).printer.name == "mine"


@pytest.mark.parametrize(
    ("name", "message"),
    [
        ("kossel", "did you mean kossel-mini"),
        ("xyz", "there are anycubic-kobra-2, anycubic-kossel"),
        ("none.toml", r"none\.toml: no such file"),
    ],
)
def test_an_unknown_profile_is_refused_with_what_there_is(name, message):
    with pytest.raises(SettingError, match=message):
        Settings.load(printer=name)
