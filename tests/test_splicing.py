"""Wire between another program's layers: supports, cores and tops, certified as one file."""

import re

import numpy as np
import pytest
import trimesh
from click.testing import CliRunner

import wireprint
from layers_of_others import Layers
from wireprint import cli
from wireprint.gcode import document
from wireprint.splicing import splice

SETTINGS = wireprint.Settings.load("prusa-mk3s", "pla")
LAYER = 0.2


def box(width, depth, height):
    body = trimesh.creation.box((width, depth, height))
    body.apply_translation((0, 0, height / 2))
    return wireprint.as_mesh(body)


def roof():
    """Two towers, and a roof over 50 mm between them."""
    layers = Layers()
    for number in range(60):
        layers.layer((number + 1) * LAYER)
        layers.block(-29, 0, 8, 12)
        layers.block(29, 0, 8, 12)
    return layers.plate(0, 0, 66, 12, 12.0, 12.6)


@pytest.mark.parametrize("relative", [False, True])
def test_a_top_of_wire_stands_on_layers(relative):
    base = Layers(relative).plate(0, 0, 34, 34, 0.0, 4.0)
    found = splice(box(24, 24, 20), base.text(), SETTINGS, at_mm=(0, 0, 4.0))
    assert found.certificate.ok, found.certificate
    assert found.certificate.fidelity.coverage > 0.95
    assert found.certificate.core.strands[..., 2].max() == pytest.approx(24.0, abs=0.3)
    # The other program does not know how high the print is now: our own sequence ends it.
    assert b"G1 Z60" not in found.gcode
    assert found.gcode.rstrip().endswith(b"; prusaslicer_config = end")


def test_wire_carries_a_roof_between_layers():
    layers = roof().text()
    alone = wireprint.check(layers, SETTINGS)
    found = splice(box(36, 12, 11.9), layers, SETTINGS)
    assert found.certificate.ok, found.certificate
    assert len(found.heights_mm) > 2
    assert found.certificate.max_span_mm < 0.5 * alone.max_span_mm


def test_the_other_programs_lines_stay_and_mean_what_they_meant():
    layers = roof().text()
    found = splice(box(36, 12, 11.9), layers, SETTINGS)
    parts = re.split(rb"(?s); wire of wireprint begins\n.*?; wire of wireprint ends\n", found.gcode)
    rest = b"".join(parts)
    rest = re.sub(rb"(?s); wireprint_settings = begin.*; wireprint_settings = end\n", b"", rest)
    assert rest == layers

    # Strand by strand what the layers were, with the filament that they had.
    def fed(text):
        core = wireprint.check(text, SETTINGS).core
        names = np.array(core.features)[core.strand_features]
        return core.strands[names == "solid infill"]

    np.testing.assert_allclose(fed(found.gcode), fed(layers), atol=1e-6)
    # Between runs of ours the fan blows as it did: ours ends with the command that was last.
    ends = found.gcode.split(b"; wire of wireprint ends\n")[:-1]
    assert all(end.rfind(b"M106 S102") > end.rfind(b"M106 S255") for end in ends[:-1])


def test_filament_that_is_fed_is_the_sum_of_both():
    layers, body = roof().text(), box(36, 12, 11.9)
    found = splice(body, layers, SETTINGS)
    filament = document.timing(found.gcode, SETTINGS).filament_mm
    wire = wireprint.toolpath(wireprint.wireframe(body, SETTINGS), SETTINGS)
    own = document.timing(layers, SETTINGS).filament_mm
    assert own < filament < own + wire.figures()["filament_mm"] + 1


def test_layers_that_travel_through_the_wire_are_refused():
    low = Layers(lift=0.0)
    for number in range(30):
        low.layer((number + 1) * LAYER)
        low.block(-29, 0, 8, 12)
        low.block(29, 0, 8, 12)
    found = splice(box(36, 12, 5.9), low.text(), SETTINGS)
    assert found.certificate.collisions


@pytest.mark.parametrize("line", ["G92 X3", "M221 S90", "M220 S50"])
def test_where_words_mean_something_else_nothing_is_put_in(line):
    layers = Layers().plate(0, 0, 30, 30, 0.0, 2.0)
    text = layers.text().replace(b"G92 E0", f"G92 E0\n{line}".encode(), 1)
    with pytest.raises(wireprint.SettingError, match=r"line \d+: .*wire cannot be put in"):
        splice(box(20, 20, 10), text, SETTINGS, at_mm=(0, 0, 2.0))


def test_the_command_writes_what_is_certified_and_nothing_else(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    base = Layers().plate(0, 0, 34, 34, 0.0, 4.0).text()
    (tmp_path / "base.gcode").write_bytes(base)
    trimesh.creation.box((24, 24, 20)).export("top.stl")
    words = ["splice", "base.gcode", "top.stl", "--printer", "prusa-mk3s", "--material", "pla"]
    run = CliRunner().invoke(cli.main, [*words, "--lift", "4", "-o", "both.gcode"])
    assert run.exit_code == 0, run.output
    assert "certified" in run.output
    checked = CliRunner().invoke(cli.main, ["check", "both.gcode"])
    assert checked.exit_code == 0, checked.output
    # Beside the plate it would be printed in the air.
    run = CliRunner().invoke(cli.main, [*words, "--lift", "9", "-o", "air.gcode"])
    assert run.exit_code == 5
    assert not (tmp_path / "air.gcode").exists()
    run = CliRunner().invoke(cli.main, [*words, "-o", "base.gcode"])
    assert run.exit_code == 2
    assert (tmp_path / "base.gcode").read_bytes() == base


def mushroom():
    """A stem under a wide plate, in layers, and as a mesh."""
    layers = Layers()
    layers.plate(0, 0, 10, 10, 0.0, 12.0).plate(0, 0, 60, 30, 12.0, 13.0)
    stem, cap = trimesh.creation.box((10, 10, 12)), trimesh.creation.box((60, 30, 2))
    stem.apply_translation((0, 0, 6))
    cap.apply_translation((0, 0, 13))
    return layers.text(), wireprint.as_mesh(trimesh.util.concatenate([stem, cap]))


def test_supports_alone_carry_layers_of_the_same_model():
    layers, mesh = mushroom()
    alone = wireprint.check(layers, SETTINGS)
    assert alone.spans_over
    found = splice(mesh, layers, SETTINGS, supports=True)
    assert found.certificate.ok, found.certificate
    names = np.array(found.certificate.core.features)[found.certificate.core.strand_features]
    assert set(names) == {"solid infill", "support"}


@pytest.mark.parametrize(("half_mm", "stem_mm"), [(20, 5), (25, 8), (30, 10)])
def test_supports_carry_what_is_one_body_with_what_it_leans_on(half_mm, stem_mm):
    outline = [(0, 0), (stem_mm, 0), (stem_mm, 12), (half_mm, 12), (half_mm, 14), (0, 14), (0, 0)]
    to_corner = np.array(outline) * (np.sqrt(2), 1)
    mesh = trimesh.creation.revolve(to_corner, sections=4)
    mesh.apply_transform(trimesh.transformations.rotation_matrix(np.pi / 4, (0, 0, 1)))
    layers = Layers().plate(0, 0, 2 * stem_mm, 2 * stem_mm, 0.0, 12.0)
    layers.plate(0, 0, 2 * half_mm, 2 * half_mm, 12.0, 13.0)
    found = splice(wireprint.as_mesh(mesh), layers.text(), SETTINGS, supports=True)
    assert found.certificate.ok, found.certificate


def boxes(*parts):
    """Boxes (x, y, width, depth, low, high) in layers, and as a mesh."""
    layers, bodies = Layers(), []
    for number in range(round(max(part[5] for part in parts) / LAYER)):
        top = (number + 1) * LAYER
        layers.layer(top)
        for x, y, width, depth, low, high in parts:
            if low + 1e-6 < top <= high + 1e-6:
                layers.block(x, y, width, depth)
    for x, y, width, depth, low, high in parts:
        body = trimesh.creation.box((width, depth, high - low))
        bodies.append(body.apply_translation((x, y, (low + high) / 2)))
    return layers.text(), wireprint.as_mesh(trimesh.util.concatenate(bodies))


@pytest.mark.parametrize(
    "parts",
    [
        [(0, 0, 10, 10, 0, 12), (0, 0, 70, 70, 12, 13)],
        [(0, 0, 10, 10, 0, 12), (0, 0, 90, 90, 12, 14)],
        [(0, 0, 10, 10, 0, 12), (0, 0, 120, 120, 12, 14)],
        [(33, -26, 12, 12, 0, 11), (28, -21, 14, 11, 0, 11), (0, 0, 76, 105, 11, 12)],
        # A plate stands on a plate.
        [(9, 4, 19, 9, 0, 9), (0, 0, 96, 77, 9, 11), (5, 0, 9, 9, 11, 20), (0, 0, 81, 62, 20, 21)],
    ],
)
def test_supports_carry_plates_that_are_wider_than_a_span(parts):
    layers, mesh = boxes(*parts)
    assert wireprint.check(layers, SETTINGS).max_span_mm > SETTINGS.wire.span_limit_mm
    found = splice(mesh, layers, SETTINGS, supports=True)
    assert found.certificate.ok, found.certificate
    core = found.certificate.core
    own = core.strands[np.array(core.features)[core.strand_features] == "support"]
    middles = own.mean(axis=1) - (*SETTINGS.printer.bed.centre_mm, 0)
    # Nothing of them is where layers fill the model.
    for x, y, width, depth, low, high in parts:
        away = np.abs(middles - (x, y, (low + high) / 2)) - np.array([width, depth, high - low]) / 2
        assert not (away < -SETTINGS.strand_mm).all(axis=1).any()


def test_decks_are_laid_closer_where_layers_begin_beside_their_strands():
    """Layers that keep half a line and more from the model's outline, as perimeters do."""
    _, mesh = boxes((0, 0, 10, 10, 0, 12), (0, 0, 90, 80, 12, 14))
    layers = Layers().plate(0, 0, 10, 10, 0.0, 12.0).plate(0, 0, 87, 77, 12.0, 14.0).text()
    found = splice(mesh, layers, SETTINGS, supports=True)
    assert found.certificate.ok, found.certificate
    assert found.settings.wire.cap_spacing_mm < SETTINGS.wire.cap_spacing_mm
    # The file tells what it was made with.
    told = wireprint.check(found.gcode)
    assert told.ok


def test_a_model_that_needs_no_supports_is_told_so():
    layers = Layers().plate(0, 0, 30, 30, 0.0, 2.0).text()
    with pytest.raises(wireprint.UnprintableError, match="needs no supports"):
        splice(box(30, 30, 10), layers, SETTINGS, supports=True)
