"""Files beside the model: whole, and over nothing that is not the window's to write over."""

import io

import pytest
from PIL import Image
from studio_talk import Talk, source_of

from command import run


def test_a_file_is_saved_beside_the_model(talk, cube):
    head, _ = talk.ask("save", kind="gcode")
    assert head["name"] == "cube.gcode"
    assert not head["exists"]
    assert cube.with_name("cube.gcode").read_bytes() == talk.gcode()
    for kind, name in (("project", "cube.3mf"), ("strokes", "cube.strokes.json")):
        head, arrays = talk.ask("export", kind=kind)
        assert head["name"] == name
        talk.ask("save", kind=kind)
        assert cube.with_name(name).read_bytes() == arrays["file"].tobytes()


def test_what_is_the_users_is_written_over_only_once_that_was_asked(talk, cube):
    mine = cube.with_name("cube.gcode")
    mine.write_bytes(b"mine")
    asked, _ = talk.ask("save", kind="gcode")
    assert asked["exists"]
    assert mine.read_bytes() == b"mine"
    # It changes while the user thinks: the answer was about another file.
    mine.write_bytes(b"mine, and newer")
    again, _ = talk.ask("save", kind="gcode", over=asked["exists"])
    assert again["exists"] not in (None, asked["exists"])
    assert mine.read_bytes() == b"mine, and newer"
    done, _ = talk.ask("save", kind="gcode", over=again["exists"])
    assert not done["exists"]
    assert mine.read_bytes() == talk.gcode()


def test_the_model_itself_is_never_written_over(cube, tmp_path):
    project = tmp_path / "p.3mf"
    assert run("project", cube, "-o", project).exit_code == 0
    before = project.read_bytes()
    with Talk(source_of(project)) as talk:
        head, _ = talk.ask("save", kind="project")
        assert head["name"] == "p.studio.3mf"
        assert project.read_bytes() == before
        # Nor by a link of that name.
        (tmp_path / "p.gcode").symlink_to(project)
        head, _ = talk.ask("save", kind="gcode")
        assert "which is read" in head["error"]
        assert project.read_bytes() == before


def test_a_folder_that_may_not_be_written_to_is_said(talk, cube, monkeypatch):
    from wireprint import _aside

    def refuse(*_):
        raise PermissionError(13, "Permission denied")

    monkeypatch.setattr(_aside, "replace", refuse)
    head, _ = talk.ask("save", kind="gcode")
    assert "ermission denied" in head["error"]
    assert not cube.with_name("cube.gcode").exists()


def test_a_print_that_slice_refuses_is_saved_by_force_alone(tmp_path):
    from wireprint import examples

    path = tmp_path / "sphere.stl"
    path.write_bytes(examples.stl("sphere"))
    with Talk(
        source_of(path, overrides=["wire.coverage_within_mm=0.5", "wire.coverage_goal=0"])
    ) as talk:
        head, _ = talk.ask("save", kind="gcode")
        assert "outer surface would be covered" in head["error"]
        assert not path.with_suffix(".gcode").exists()
        head, _ = talk.ask("save", kind="gcode", force=True)
        assert path.with_suffix(".gcode").exists()


def test_a_picture_is_drawn_for_browsers_that_cannot(talk):
    _, front = talk.ask("picture", azimuth_deg=0, elevation_deg=0, width=320, height=240)
    _, top = talk.ask("picture", azimuth_deg=0, elevation_deg=90, width=320, height=240)
    pictures = [Image.open(io.BytesIO(one["file"].tobytes())) for one in (front, top)]
    assert [one.size for one in pictures] == [(320, 240)] * 2
    assert pictures[0].tobytes() != pictures[1].tobytes()


@pytest.mark.parametrize("wrong", [{"width": 100_000}, {"elevation_deg": 91}, {"height": 1}])
def test_a_picture_has_bounds(talk, wrong):
    values = {"azimuth_deg": 0, "elevation_deg": 0, "width": 320, "height": 240} | wrong
    head, _ = talk.ask("picture", **values)
    assert next(iter(wrong)) in head["error"]
