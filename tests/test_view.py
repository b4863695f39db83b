"""Pictures: what is shown where, in which colour, read off the pixels."""

import io
import subprocess
import sys

import numpy as np
import pytest
from PIL import Image

from command import run
from wireprint import examples, view, view_camera, view_source, view_styles
from wireprint._core import GcodeError, Scene, SettingError, Strands
from wireprint.gcode.document import moves
from wireprint.mesh import load_mesh
from wireprint.settings import Settings
from wireprint.stages import toolpath, wireframe
from wireprint.view_legend import round_length

SIZE = (240, 160)
#: Share of such a picture that a strand takes at least.
SEEN = 0.004


def gcode(*labels, length=40.0):
    """One strand along x for each label, 10 mm above each other, seen from the front."""
    lines = ["G90", "M83", "G1 X0 Y0 Z5 F1200"]
    for i, label in enumerate(labels):
        z = 5 + 10 * i
        lines += [f"G0 X0 Z{z}", f";TYPE:{label}", f"G1 X{length} E{length * 0.16}"]
    return "\n".join(lines).encode()


def picture(source, **options):
    """Pixels of a picture from the front, without a legend."""
    options = {"size": SIZE, "camera": "front", "with_legend": False} | options
    return pixels(view.render_png(source, **options))


def pixels(png):
    with Image.open(io.BytesIO(png)) as image:
        return np.asarray(image.convert("RGBA"), np.int64)


def size_of(path):
    with Image.open(path) as image:
        return image.size


def hue_share(image, colour):
    """Share of the pixels whose colour is a darker or paler `colour`."""
    rgb = image[..., :3] - image[..., :3].mean(axis=2, keepdims=True)
    wanted = np.array(colour) - np.mean(colour)
    strength = np.linalg.norm(rgb, axis=2)
    aligned = rgb @ wanted / np.maximum(strength * np.linalg.norm(wanted), 1e-9)
    return float(((aligned > 0.97) & (strength > 12)).mean())


@pytest.mark.parametrize("label", sorted(view_styles.STYLES))
def test_every_label_is_drawn_in_its_own_colour(label):
    strands = Strands.from_gcode(gcode(label.upper()))
    style = view_styles.STYLES[label]
    assert hue_share(picture(strands, kinds=[label]), style.colour) > SEEN


def test_kinds_of_a_wire_print_have_colours_that_differ():
    wire = ["contour", "post", "diagonal", "cap", "layer-wise", "support"]
    colours = [view_styles.STYLES[label].colour for label in wire]
    colours += [view_styles.TRAVEL, view_styles.FOREIGN, view_styles.BREACH]
    for i, a in enumerate(colours):
        for b in colours[:i]:
            assert np.linalg.norm(np.subtract(a, b)) > 60, (a, b)


def test_labels_of_other_programs_are_shown_in_a_neutral_colour():
    strands = Strands.from_gcode(gcode("WALL-OUTER", "External perimeter"))
    assert strands.labels[1:] == ["wall-outer", "external perimeter"]
    image = picture(strands)
    assert hue_share(image, view_styles.FOREIGN) > 2 * SEEN
    assert view_styles.FOREIGN not in {style.colour for style in view_styles.STYLES.values()}


def test_only_the_kinds_asked_for_are_shown():
    strands = Strands.from_gcode(gcode("CONTOUR", "POST"))
    image = picture(strands, kinds=["Post"])
    assert hue_share(image, view_styles.STYLES["post"].colour) > SEEN
    assert hue_share(image, view_styles.STYLES["contour"].colour) == 0.0


def test_a_kind_that_is_neither_known_nor_in_the_file_is_refused_with_what_there_is():
    strands = Strands.from_gcode(gcode("CONTOUR", "WALL-OUTER"))
    with pytest.raises(SettingError, match=r"foam is unknown; the file has contour.*wall"):
        view_styles.palette(strands, ["contour", "foam"])
    assert view_styles.palette(strands, ["cap"]) == [None] * 3


def test_the_start_code_is_left_out_unless_asked_for():
    strands = Strands.from_gcode(gcode("PRIME", "CONTOUR"))
    assert hue_share(picture(strands), view_styles.STYLES["prime"].colour) == 0.0
    assert hue_share(picture(strands, kinds=["priming"]), view_styles.STYLES["prime"].colour) > SEEN


def test_travels_are_drawn_only_where_asked_for():
    strands = Strands.from_gcode(gcode("CONTOUR", "CONTOUR"))
    without, with_travels = picture(strands), picture(strands, travels=True)
    added = (without != with_travels).any(axis=2)
    assert 0.002 < added.mean() < 0.05
    assert (with_travels[added][:, :3].mean(axis=0) > 170).all(), "faint"


def test_breaches_are_red_and_seen_through_everything():
    strands = Strands.from_gcode(gcode("CONTOUR"))
    behind = [(20.0, 30.0, 5.0)]
    image = picture(strands, breaches=behind)
    assert hue_share(image, view_styles.BREACH) > 0.001
    assert hue_share(picture(strands), view_styles.BREACH) == 0.0


def test_a_strand_is_as_thick_as_its_filament_makes_it():
    text = gcode("CONTOUR", length=40.0)
    strands = Strands.from_gcode(b"; filament_diameter = 2.85\n" + text)
    area = 0.16 * np.pi / 4 * 2.85**2
    assert strands.diameters == pytest.approx([2 * np.sqrt(area / np.pi)])
    assert Strands.from_gcode(text).diameters == pytest.approx([np.sqrt(0.16) * 1.75])


def test_strands_and_travels_are_replayed_in_order():
    strands = Strands.from_gcode(gcode("CONTOUR", "POST"))
    assert strands.segments.tolist() == [[[0, 0, 5], [40, 0, 5]], [[0, 0, 15], [40, 0, 15]]]
    assert strands.travels.tolist() == [[[0, 0, 0], [0, 0, 5]], [[40, 0, 5], [0, 0, 15]]]
    assert strands.travel_after.tolist() == [0, 1]
    assert strands.lengths == [0.0, 40.0, 40.0]
    assert strands.bounds(["post"]) == ((0, 0, 15), (40, 0, 15))


def test_g_code_without_a_strand_is_refused():
    with pytest.raises(GcodeError, match="no strand"):
        Strands.from_gcode(b"G28\nG1 X10 F3000\n")


def test_strands_from_arrays_are_checked():
    segments = np.zeros((2, 2, 3))
    features = np.zeros(2, np.uint16)
    assert len(Strands.from_arrays(segments, features, ["contour"], 0.7)) == 2
    with pytest.raises(SettingError, match=r"segments: float64 of shape \[2, 3, 2\]"):
        Strands.from_arrays(np.zeros((2, 3, 2)), features, ["contour"], 0.7)
    with pytest.raises(SettingError, match="1 indices for 2 segments"):
        Strands.from_arrays(segments, features[:1], ["contour"], 0.7)
    with pytest.raises(SettingError, match="0 for 0 labels"):
        Strands.from_arrays(segments, features, [], 0.7)
    strands = Strands.from_arrays(segments + np.nan, features, ["contour"], 0.7)
    with pytest.raises(SettingError, match="finite"):
        view.render_png(strands)


def test_a_model_is_drawn_as_shaded_triangles(tmp_path):
    path = tmp_path / "cube.stl"
    path.write_bytes(examples.stl("cube"))
    image = picture(load_mesh(path), camera="iso")
    assert hue_share(image, view_styles.MODEL) > 0.1
    shades = {tuple(c) for c in image[..., :3].reshape(-1, 3)}
    assert len(shades) > 3
    edged = picture(load_mesh(path), camera="iso", edges=True)
    assert (edged != image).any(axis=2).mean() < 0.1


@pytest.mark.parametrize("camera", ["back", "1", "1,2,3", "a,b", ""])
def test_an_unknown_camera_is_refused(camera):
    with pytest.raises(SettingError, match="camera"):
        view_camera.camera_angles(camera)


def test_a_camera_may_be_two_angles():
    assert view_camera.camera_angles("-30, 12.5")[:2] == (-30.0, 12.5)
    strands = Strands.from_gcode(gcode("CONTOUR"))
    with pytest.raises(SettingError, match="elevation"):
        view.render_png(strands, camera="0,91")


def test_the_legend_names_what_is_shown_in_the_order_of_the_pipeline():
    strands = Strands.from_gcode(gcode("SKIN", "POST", "CONTOUR"))
    entries = view_styles.legend(strands, view_styles.palette(strands))
    assert [entry.name for entry in entries] == ["contour", "post", "skin"]
    assert entries[0].amount == "0.04 m"
    assert view_source.size_text(strands) == "40.0 x 0.0 x 20.0 mm"


def test_the_size_is_that_of_the_object_without_its_skirt():
    strands = Strands.from_gcode(gcode("SKIRT", "CONTOUR", "CONTOUR"))
    assert view_source.size_text(strands) == "40.0 x 0.0 x 10.0 mm"


def test_the_legend_lies_beside_the_picture():
    strands = Strands.from_gcode(gcode("CONTOUR"))
    size = (800, 600)
    plain = picture(strands, size=size)
    labelled = picture(strands, size=size, with_legend=True, title="a print")
    assert plain.shape == labelled.shape == (600, 800, 4)
    assert (plain[:150, :150] == 255).all()
    assert not (labelled[:150, :150] == 255).all()


@pytest.mark.parametrize(
    ("longest", "length"), [(1.0, 1.0), (4.99, 2.0), (5.0, 5.0), (99.0, 50.0), (0.3, 0.2)]
)
def test_the_scale_bar_has_a_round_length(longest, length):
    assert round_length(longest) == pytest.approx(length)


def test_the_scale_bar_is_true():
    # From the front there is no perspective: 40 mm of strand between the ends of its row.
    strands = Strands.from_gcode(gcode("CONTOUR"))
    scene = Scene()
    scene.add_strands(strands, view_styles.palette(strands))
    _, px_per_mm = scene.render(
        (400, 100),
        view_camera.CAMERAS["front"],
        supersample=1,
        margins=(20,) * 4,
        ground=view_styles.WHITE,
    )
    assert px_per_mm == pytest.approx(360 / 40)


def test_thumbnails_have_the_sizes_asked_for_and_a_transparent_ground():
    strands = Strands.from_gcode(gcode("CONTOUR", "POST", "CONTOUR"))
    made = view.thumbnails(strands)
    assert [(w, h) for w, h, _ in made] == [(32, 32), (300, 300)]
    for width, height, png in made:
        image = pixels(png)
        assert image.shape == (height, width, 4)
        assert 0 < (image[..., 3] > 0).mean() < 1
        assert len(np.unique(image.reshape(-1, 4), axis=0)) <= 64
    assert hue_share(pixels(made[1][2]), view_styles.STYLES["contour"].colour) > SEEN


def test_a_thumbnail_in_qoi_shows_what_one_in_png_does():
    strands = Strands.from_gcode(gcode("CONTOUR", "POST", "CONTOUR"))
    (_, _, qoi), (_, _, png) = view.thumbnails(strands, [(440, 240, "QOI"), (440, 240)])
    read = np.asarray(Image.open(io.BytesIO(qoi)).convert("RGBA")).astype(int)
    other = pixels(png).astype(int)
    assert read.shape == other.shape == (240, 440, 4)
    # As many as QOI remembers: each is one byte wherever it comes back.
    assert len(np.unique(read.reshape(-1, 4), axis=0)) <= 64
    assert len(qoi) < read.shape[0] * read.shape[1] / 2
    assert np.abs(read[..., 3] - other[..., 3]).mean() < 2
    seen = read[..., 3] > 0
    assert 0 < seen.mean() < 1
    assert np.abs(read[seen] - other[seen]).mean() < 8


def test_a_thumbnail_of_an_unknown_form_is_refused():
    strands = Strands.from_gcode(gcode("CONTOUR"))
    with pytest.raises(ValueError, match="PNG or QOI, not JPG"):
        view.thumbnails(strands, [(32, 32, "JPG")])


def test_thumbnails_show_the_object_without_its_skirt():
    alone = view.thumbnails(Strands.from_gcode(gcode("CONTOUR", "POST")))
    skirted = view.thumbnails(Strands.from_gcode(gcode("CONTOUR", "POST", "SKIRT")))
    assert alone == skirted


SAME_ON_ANY_THREADS = """
import hashlib, sys
from wireprint import view
from wireprint._core import Strands
strands = Strands.from_gcode(sys.stdin.buffer.read())
for png in [view.render_png(strands), *(png for _, _, png in view.thumbnails(strands))]:
    print(hashlib.sha256(png).hexdigest())
assert "numpy" not in sys.modules
"""


def test_pictures_are_the_same_on_any_number_of_threads_and_need_no_numpy():
    def hashes(threads):
        return subprocess.run(
            [sys.executable, "-c", SAME_ON_ANY_THREADS],
            input=gcode(*["CONTOUR", "POST"] * 20),
            env={"RAYON_NUM_THREADS": threads},
            capture_output=True,
            check=True,
        ).stdout.split()

    one, four = hashes("1"), hashes("4")
    assert len(one) == 3
    assert one == four


@pytest.fixture
def printed(tmp_path):
    path = tmp_path / "print.gcode"
    path.write_bytes(gcode("CONTOUR", "POST"))
    return path


def test_the_command_writes_a_picture_of_g_code(printed):
    result = run("view", printed, "--size", "200x100", "--camera", "top", "--travels")
    assert result.exit_code == 0
    target = printed.with_suffix(".png")
    assert size_of(target) == (200, 100)
    assert result.stdout == f"{target}: print.gcode\n"


def test_the_command_writes_a_picture_of_a_model(tmp_path):
    assert run("example", "cube", "-o", tmp_path / "cube.stl").exit_code == 0
    target = tmp_path / "cube.png"
    result = run("view", tmp_path / "cube.stl", "-o", target, "--edges", "--height", "50")
    assert result.exit_code == 0
    assert size_of(target) == (1600, 1200)


@pytest.mark.parametrize(
    ("options", "code", "message"),
    [
        (["-o", "x.jpg"], 2, "end the name in .png or .html"),
        (["--size", "big"], 2, "'big' is not WIDTHxHEIGHT"),
        (["--camera", "behind"], 4, "camera is 'behind'"),
        (["--kinds", "foam"], 4, "foam is unknown"),
        (["--size", "99999x10"], 4, "99999×10 pixels"),
    ],
)
def test_wrong_options_are_named_and_nothing_is_written(printed, options, code, message):
    result = run("view", printed, *options)
    assert result.exit_code == code
    assert message in result.stderr
    assert list(printed.parent.iterdir()) == [printed]


def test_a_toolpath_is_drawn_as_its_g_code_will_be(tmp_path):
    settings = Settings.load("kossel-mini", "abs", overrides=["gcode.relative_extrusion=true"])
    run("example", "cube", "-o", tmp_path / "cube.stl")
    planned = toolpath(wireframe(load_mesh(tmp_path / "cube.stl"), settings), settings)
    before = view.strands_of(planned, settings)
    after = Strands.from_gcode(b"M83\n" + moves(planned, settings))
    assert len(before) == len(after)
    assert np.abs(before.segments - after.segments).max() < 1e-3

    def named(strands):
        return [strands.labels[i] for i in strands.features]

    assert named(before) == named(after)
    ours = {view_styles.style_of(label) for label in named(after)}
    assert ours <= set(view_styles.STYLES.values())
