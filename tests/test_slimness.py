"""What a slimmer strand means is said, with figures, and with a way out."""

import pytest

import wireprint
from command import run
from wireprint import Settings, examples
from wireprint.slimness import strand_of, told


def test_the_papers_own_strand_is_its_own_measure():
    strand = strand_of(Settings.load("kossel-mini"))
    assert (strand["strength"], strand["stiffness"], strand["free_end_mm"]) == (1, 1, 20)
    assert strand["help"] == ""
    assert told(strand) == ""


@pytest.mark.parametrize(
    ("nozzle_mm", "strength", "stiffness", "free_end_mm"),
    [(0.4, 0.3265, 0.1066, 15.12), (0.6, 0.7347, 0.5398, 18.52), (0.8, 1.306, 1.706, 21.38)],
)
def test_figures_follow_from_the_diameter(nozzle_mm, strength, stiffness, free_end_mm):
    strand = strand_of(Settings.load("prusa-mk4s", nozzle_mm=nozzle_mm))
    assert strand["strength"] == pytest.approx(strength, rel=1e-3)
    assert strand["stiffness"] == pytest.approx(stiffness, rel=1e-3)
    assert strand["free_end_mm"] == pytest.approx(free_end_mm, rel=1e-3)


def test_a_wider_nozzle_is_offered_where_it_helps():
    assert "--nozzle 0.6, if you have one, makes it 5 times" in told(
        strand_of(Settings.load("prusa-mk4s"))
    )
    assert "--nozzle 0.4" in told(strand_of(Settings.load("prusa-mk4s", nozzle_mm=0.25)))
    for nozzle_mm in (0.6, 0.8, 1.0):
        assert told(strand_of(Settings.load("prusa-mk4s", nozzle_mm=nozzle_mm))) == ""


def test_more_filament_makes_a_thicker_strand():
    usual = Settings.load("prusa-mk4s", "pla")
    fed = usual.but(overrides=["wire.flow=1.5"])
    assert fed.strand_mm == pytest.approx(0.4 * 1.5**0.5)
    assert strand_of(fed)["stiffness"] / strand_of(usual)["stiffness"] == pytest.approx(1.5**2)
    assert fed.pause_s > usual.pause_s
    assert "--set wire.flow=1.5" in strand_of(usual)["help"]
    assert "wire.flow" not in strand_of(fed)["help"]
    assert usual.strand_mm == usual.printer.head.nozzle_mm


@pytest.mark.parametrize("printer", ["prusa-mk4s", "kossel-mini", "voron-0"])
def test_a_print_with_more_filament_is_certified_and_takes_as_much_more(tmp_path, printer):
    (tmp_path / "cube.stl").write_bytes(examples.stl("cube"))
    mesh = wireprint.load_mesh(tmp_path / "cube.stl")

    def per_mm(flow):
        overrides = [f"wire.flow={flow}", "wire.prime_mm=0", "gcode.thumbnails=[]"]
        made = wireprint.make(mesh, Settings.load(printer, "pla", overrides=overrides))
        assert made.certificate.ok
        figures = made.figures()
        return figures["filament_mm"] / figures["strand_mm"]

    assert per_mm(1.5) / per_mm(1.0) == pytest.approx(1.5, rel=0.03)


def test_layers_beside_thicker_strands_are_as_wide_as_these(tmp_path):
    from wireprint.regions import Region, ZRange

    (tmp_path / "cube.stl").write_bytes(examples.stl("cube"))
    mesh = wireprint.load_mesh(tmp_path / "cube.stl")
    settings = Settings.load("prusa-mk4s", "pla", overrides=["wire.flow=1.5"])
    made = wireprint.make(mesh, settings, Region().add(ZRange(low_mm=10, high_mm=16)))
    assert made.certificate.ok
    assert made.figures()["regions"]["layer_wise_mm"] > 0


def test_a_slimmer_strand_pauses_for_less():
    slim, wide = (
        strand_of(Settings.load("prusa-mk4s", nozzle_mm=nozzle_mm)) for nozzle_mm in (0.4, 0.8)
    )
    assert slim["pause_s"] < wide["pause_s"]


@pytest.mark.parametrize(("nozzle", "said"), [("0.4", True), ("0.6", False)])
def test_the_command_says_so(tmp_path, nozzle, said):
    (tmp_path / "cube.stl").write_bytes(examples.stl("cube"))
    done = run(
        *("slice", tmp_path / "cube.stl", "-o", tmp_path / "cube.gcode"),
        *("--printer", "ender-3", "--material", "pla", "--nozzle", nozzle),
    )
    assert done.exit_code == 0, done.output
    assert ("has 33 % of the strength and 11 % of the stiffness of 0.7 mm" in done.output) is said
