"""A session: what is marked and set is printed, undone, exported and told."""

import numpy as np
import pytest
from studio_strokes import flank
from studio_talk import Talk, source_of

from command import run
from wireprint import examples, simulate
from wireprint.forecast_scales import scale_of
from wireprint.forecast_words import sentences


def box(low, high):
    return {"shape": {"kind": "box", "low_mm": low, "high_mm": high}}


BAND = box([-20, -20, 8], [20, 20, 16])


def test_the_print_is_that_of_slice(talk, cube, tmp_path):
    assert run("slice", cube, "-o", tmp_path / "cube.gcode").exit_code == 0
    assert talk.gcode() == (tmp_path / "cube.gcode").read_bytes()


def test_a_stroke_prints_layers_and_undo_and_redo_give_the_same_bytes(talk, cube, tmp_path):
    plain = talk.gcode()
    talk.edit("mark", mark={"shape": flank()})
    painted = talk.gcode()
    assert b";TYPE:LAYER-WISE" in painted
    assert b";TYPE:LAYER-WISE" not in plain
    _, strokes = talk.ask("export", kind="strokes")
    (tmp_path / "strokes.json").write_bytes(strokes["file"].tobytes())
    talk.edit("undo")
    assert talk.gcode() == plain
    talk.edit("redo")
    assert talk.gcode() == painted
    out = tmp_path / "out.gcode"
    assert run("slice", cube, "--fill-file", tmp_path / "strokes.json", "-o", out).exit_code == 0
    assert out.read_bytes() == painted


def test_a_mark_that_is_erased_switched_off_or_deleted_leaves_the_plain_print(talk):
    plain = talk.gcode()
    number = talk.edit("mark", mark=BAND)["number"]
    marked = talk.gcode()
    assert marked != plain
    talk.edit("change", number=number, on=False)
    assert talk.gcode() == plain
    talk.edit("change", number=number, on=True)
    assert talk.gcode() == marked
    eraser = talk.edit("mark", mark=BAND | {"erase": True})["number"]
    assert talk.gcode() == plain
    # The last one that covers wins: the eraser before the mark erases nothing.
    talk.edit("move", number=eraser, to=0)
    assert talk.gcode() == marked
    talk.edit("delete", number=number)
    assert talk.gcode() == plain


def test_the_list_of_marks_tells_names_and_shapes_but_no_points(talk):
    talk.edit("mark", mark={"shape": flank()})
    talk.edit("mark", mark=BAND, name="collar")
    head, _ = talk.wait("state", lambda one: len(one["items"]) == 2)
    stroke, collar = head["items"]
    assert set(stroke["shape"]) == {"kind", "radius_mm"}
    assert (collar["name"], collar["shape"]["high_mm"]) == ("collar", [20, 20, 16])
    assert head["can_undo"]
    assert not head["can_redo"]


def test_a_refused_setting_says_why_and_leaves_all_as_it_was(talk):
    before = talk.gcode()
    head, _ = talk.ask("set", key="wire.slab_max_mm", value=500)
    assert "wire.slab_max_mm (500) exceeds head.cone_height_mm" in head["error"]
    head, _ = talk.ask("set", key="wire.skirt_rings", value=99)
    assert head["error"] == "wire.skirt_rings: input should be less than or equal to 20"
    head, _ = talk.ask("set", key="wire.no_such_key", value=1)
    assert "unknown key" in head["error"]
    assert talk.gcode() == before


def test_a_setting_is_that_of_slice_and_none_is_the_profiles_again(talk, cube, tmp_path):
    before = talk.gcode()
    talk.edit("set", key="wire.slab_max_mm", value=4)
    head, _ = talk.wait("state", lambda one: one["differs"])
    assert head["differs"] == {"wire.slab_max_mm": None}
    out = tmp_path / "out.gcode"
    assert run("slice", cube, "--set", "wire.slab_max_mm=4", "-o", out).exit_code == 0
    assert talk.gcode() == out.read_bytes()
    talk.edit("set", key="wire.slab_max_mm", value=None)
    assert talk.gcode() == before


def test_another_printer_is_taken_by_name_but_no_file(talk, cube, tmp_path):
    talk.edit("profile", printer="voron-2.4", material="pla")
    out = tmp_path / "out.gcode"
    made = run("slice", cube, "--printer", "voron-2.4", "--material", "pla", "-o", out)
    assert made.exit_code == 0
    assert talk.gcode() == out.read_bytes()
    for name in ("/etc/passwd", "../x.toml", "no-such"):
        head, _ = talk.ask("profile", printer=name)
        assert "is none of the printers" in head["error"]


@pytest.mark.parametrize(
    "content",
    [
        b"",
        b"[]",
        b"{}",
        b"\xff\xfe",
        b'{"do": "explode"}',
        b'{"do": "mark"}',
        b'{"do": "mark", "mark": {"shape": {"kind": "z", "low_mm": 2, "high_mm": 1}}}',
        b'{"do": "delete", "number": -1}',
        b'{"do": "delete", "number": 99}',
        b'{"do": "set", "key": "wire", "value": 1}',
        b'{"do": "set", "key": "wire.pause_s", "value": NaN}',
        b'{"do": "undo", "more": 1}',
        b'{"do": "export", "kind": "/etc/passwd"}',
        b"[" * 100_000,
    ],
)
def test_what_is_no_message_is_answered_by_a_sentence_and_changes_nothing(talk, content):
    from wireprint.window.answer import decoded

    before = talk.gcode()
    head, _ = decoded(talk.session.handle(content))
    assert head["error"]
    assert "unexpected" not in head["error"]
    assert talk.gcode() == before


def test_strands_are_told_in_printing_order_with_their_times(talk):
    head, arrays = talk.wait("print")
    strands, when = arrays["strands"], arrays["when"]
    assert len(strands) == len(when) == len(arrays["speed"])
    assert (when[:, 0] <= when[:, 1]).all()
    assert (np.diff(when[:, 1]) >= 0).all()
    assert when[-1, 1] <= head["total_s"]
    assert head["total_s"] == pytest.approx(head["figures"]["print_time_s"])
    slabs = strands[:, 3] >> 16
    assert (np.diff(slabs.astype(int)) >= 0).all()
    assert slabs.max() + 1 == len(head["slabs_mm"])
    ends = strands[:, :3].copy().view("<u2").reshape(-1, 2, 3)
    places = np.array(head["low"]) + ends / 65535 * np.array(head["span"])
    # 28 mm of a cube about the bed's centre, whatever the machine calls that.
    inside = np.isin(
        strands[:, 3] & 0x7F,
        [i for i, one in enumerate(head["labels"]) if one["name"] == "contour"],
    )
    assert np.abs(places[inside][..., :2]).max() == pytest.approx(14, abs=0.6)


def test_what_strands_relax_to_is_told_as_strands_in_their_place(tmp_path):
    path = tmp_path / "bottle.stl"
    path.write_bytes(examples.stl("bottle"))
    with Talk(source_of(path, height_mm=40.0)) as talk:
        head, printed = talk.wait("print")
        _, arrays = talk.wait("rest")
    chords, of = arrays["relaxed"], arrays["relaxed_of"]
    assert len(chords) == len(of)
    assert (np.diff(of.astype(int)) >= 0).all()
    strands = printed["strands"]
    assert (chords[:, 3] == strands[of, 3]).all()

    def ends_mm(texels):
        steps = texels[:, :3].copy().view("<u2").reshape(-1, 2, 3)
        return np.array(head["low"]) + steps / 65535 * np.array(head["span"])

    commanded, relaxed = ends_mm(strands), ends_mm(chords)
    lengths = [np.linalg.norm(ends[:, 1] - ends[:, 0], axis=1) for ends in (commanded, relaxed)]
    # Chords are shorter than the arcs that they are chords of, and end on the last of its strands.
    assert 0.9 * lengths[0].sum() < lengths[1].sum() < 0.999 * lengths[0].sum()
    start, run = commanded[of, 0], commanded[of, 1] - commanded[of, 0]
    along = ((relaxed[:, 1] - start) * run).sum(axis=1) / np.maximum((run**2).sum(axis=1), 1e-9)
    nearest = start + np.clip(along, 0, 1)[:, None] * run
    assert np.linalg.norm(relaxed[:, 1] - nearest, axis=1).max() < 0.02


def test_what_is_painted_is_told_as_triangles_of_the_marked_area(talk):
    talk.edit("mark", mark=box([-20, -20, -1], [20, 20, 14]))
    _, arrays = talk.wait("paint", lambda one: len(one["corners"]))
    a, b, c = arrays["corners"].astype(float).transpose(1, 0, 2)
    area = np.linalg.norm(np.cross(b - a, c - a), axis=1).sum() / 2
    assert area == pytest.approx(28 * 28 + 4 * 28 * 14, rel=0.02)


def test_a_project_from_the_window_is_sliced_to_the_same_print(talk, tmp_path):
    talk.edit("mark", mark=BAND)
    talk.edit("set", key="wire.skirt_rings", value=3)
    _, arrays = talk.ask("export", kind="project")
    project, out = tmp_path / "p.3mf", tmp_path / "out.gcode"
    project.write_bytes(arrays["file"].tobytes())
    assert run("slice", project, "-o", out).exit_code == 0
    commands = [line for line in talk.gcode().splitlines() if not line.startswith(b";")]
    assert [one for one in out.read_bytes().splitlines() if not one.startswith(b";")] == commands


def test_a_print_is_given_up_between_the_steps_of_its_regions(cube):
    from wireprint.clock import Clock
    from wireprint.mesh import load_mesh
    from wireprint.pipeline import make
    from wireprint.regions import Region, ZRange
    from wireprint.settings import Settings

    class NotWantedError(Exception):
        pass

    mesh, region = load_mesh(cube), Region().add(ZRange(low_mm=10, high_mm=16))

    def steps_until(last):
        steps = []

        def step(name):
            steps.append(name)
            if name == last:
                raise NotWantedError

        try:
            make(mesh, Settings.load(), region, clock=Clock(on_step=step))
        except NotWantedError:
            assert steps[-1] == last
        return steps

    steps = steps_until(None)
    assert steps[:3] == ["marks", "layers, round 1", "walls"]
    printing = ["wire beside layers", "moves", "file", "proof"]
    assert steps[-4:] == [f"{name}, round 1" for name in printing]
    assert len(set(steps)) > 8
    for name in set(steps):
        assert steps_until(name) == steps[: steps.index(name) + 1]


def test_lines_that_are_laid_for_a_print_out_of_date_are_given_up(talk, monkeypatch):
    from wireprint.hybrid import lines, prove

    fringe, wireframe, wired = lines.fringe, prove.wireframe, []

    def changed_meanwhile(*arguments):
        monkeypatch.setattr(lines, "fringe", fringe)
        talk.ask("undo")
        return fringe(*arguments)

    def wire(*arguments, **options):
        wired.append(arguments)
        return wireframe(*arguments, **options)

    monkeypatch.setattr(lines, "fringe", changed_meanwhile)
    monkeypatch.setattr(prove, "wireframe", wire)
    head, _ = talk.ask("mark", mark=BAND)
    talk.wait("current", lambda one: one["revision"] == head["revision"] + 1)
    assert wired == []
    talk.edit("redo")
    assert len(wired) == 1


def test_a_slow_print_tells_what_it_is_at_until_it_is_shown(talk, monkeypatch):
    from wireprint.window import workshop

    monkeypatch.setattr(workshop, "_SILENT_S", -1.0)
    talk.wait("rest")
    talk.told.clear()
    talk.edit("mark", mark=BAND)
    talk.wait("rest")
    names = [name for name, _ in talk.told]
    shown = names.index("print")
    assert "progress" in names[:shown]
    assert "progress" not in names[shown:]


def test_a_saved_model_is_printed_anew_and_marks_stay(talk, cube):
    talk.edit("mark", mark=box([-40, -40, 8], [40, 40, 16]))
    cube.write_bytes(examples.stl("sphere"))
    head, _ = talk.wait("model", lambda one: one["size_mm"][0] > 70)
    assert head["size_mm"] == pytest.approx([78, 78, 78], abs=0.5)
    talk.wait("current", lambda one: one["revision"] == 2)
    state, _ = talk.wait("state")
    assert [one["name"] for one in state["items"]] == ["box 1"]
    assert b";TYPE:LAYER-WISE" in talk.gcode()


def test_a_truncated_or_deleted_model_leaves_the_print_and_a_sentence(talk, cube):
    before = talk.gcode()
    cube.write_bytes(examples.stl("cube")[:200])
    head, _ = talk.wait("notice", lambda one: "the old one is shown" in one["words"])
    assert "cube.stl" in head["words"]
    assert talk.gcode() == before
    cube.unlink()
    talk.wait(
        "notice", lambda one: one["words"] == "cube.stl is gone; what is shown is what it was"
    )
    cube.write_bytes(examples.stl("cube"))
    talk.wait("notice", lambda one: one["words"] == "")


def test_what_does_not_fit_is_said_and_another_printer_helps(tmp_path):
    path = tmp_path / "bottle.stl"
    path.write_bytes(examples.stl("bottle"))
    talk = Talk(source_of(path, height_mm=240.0))
    talk.session.start()
    try:
        head, _ = talk.wait("failed")
        assert "does not fit the build volume of kossel-mini" in head["words"]
        head, _ = talk.ask("export", kind="gcode")
        assert head["error"] == "there is no print to export"
        talk.edit("profile", printer="voron-2.4")
        assert talk.gcode()
    finally:
        talk.session.stop()


def test_a_print_that_slice_refuses_is_given_by_force_alone(tmp_path):
    path = tmp_path / "sphere.stl"
    path.write_bytes(examples.stl("sphere"))
    with Talk(
        source_of(path, overrides=["wire.coverage_within_mm=0.5", "wire.coverage_goal=0"])
    ) as talk:
        head, _ = talk.wait("print")
        assert "outer surface would be covered" in head["refused"]
        answer, arrays = talk.ask("export", kind="gcode")
        assert answer["error"] == head["refused"]
        assert "file" not in arrays
        assert talk.gcode(force=True)


def test_a_page_that_comes_later_is_told_what_is_known(talk):
    from wireprint.window.answer import decoded

    talk.edit("mark", mark=BAND)
    events = [decoded(one)[0]["event"] for one in talk.session.welcome()]
    assert events[:4] == ["welcome", "model", "state", "print"]
    assert decoded(talk.session.welcome()[4])[0]["revision"] == 1


def test_every_setting_of_the_form_can_be_set_to_what_it_is(talk):
    """Names, kinds and bounds in the form are those that the settings obey."""
    head, _ = talk.ask("schema")
    state, _ = talk.wait("state")
    assert len(head["fields"]) > 100
    for field in head["fields"]:
        assert field["section"] in head["sections"]
        value = state["settings"].get(field["key"])
        if isinstance(value, str) and field["choices"]:
            assert value in field["choices"]
        elif value is not None:
            assert field["low"] is None or value >= field["low"]
            assert field["high"] is None or value <= field["high"]


def test_a_number_may_be_a_word_where_the_settings_say_so(talk):
    head, _ = talk.ask("schema")
    (brim,) = (field for field in head["fields"] if field["key"] == "wire.brim_rings")
    assert (brim["kind"], brim["choices"]) == ("integer", ["auto"])
    for value in (3, "auto"):
        talk.edit("set", key="wire.brim_rings", value=value)
        differs = value != "auto"
        state, _ = talk.wait("state", lambda one, wanted=differs: bool(one["differs"]) == wanted)
        assert state["settings"]["wire.brim_rings"] == value


def test_a_print_is_forecast_strand_by_strand(talk):
    answer, _ = talk.ask("forecast")
    assert answer["there"]
    head, arrays = talk.wait("forecast")
    _, strands = talk.wait("print")
    assert head["error"] == ""
    assert head["revision"] == talk.wait("current")[0]["revision"]
    assert list(head["figures"]) == list(arrays) == ["sag", "compliance", "flow", "weld"]
    found = simulate(talk.gcode())
    assert head["sentences"] == sentences(found)
    for shares in arrays.values():
        assert len(shares) == len(strands["strands"])
        told = shares[shares >= 0]
        assert told.size
        assert told.max() <= 1
    scale = scale_of(found, "sag")
    told = {"name": "sag", "unit": "mm", "most": scale.written(scale.edges[-1])}
    assert head["figures"]["sag"] == told
    sag = found.sag_mm / scale.edges[-1]
    assert np.array_equal(np.isnan(sag), arrays["sag"] < 0)
    assert np.allclose(arrays["sag"][~np.isnan(sag)], np.minimum(sag[~np.isnan(sag)], 1), atol=1e-6)


def test_of_several_forecasts_that_are_asked_for_the_newest_is_told(talk):
    talk.ask("forecast")
    revision = talk.edit("mark", mark=BAND)["revision"]
    talk.ask("forecast")
    _, arrays = talk.wait("forecast", lambda one: one["revision"] == revision)
    assert len(arrays["sag"]) == len(talk.wait("print")[1]["strands"])
