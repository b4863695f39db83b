"""The window in a notebook: the same program over the kernel's comm."""

import json
import time

import pytest

import wireprint
from wireprint.regions import Region, ZRange
from wireprint.window import opening
from wireprint.window.answer import decoded

pytest.importorskip("anywidget")

PATIENCE_S = 120.0


class Cell:
    """A view of a widget, without a browser: what the kernel sends, and what it is asked."""

    def __init__(self, widget, monkeypatch):
        self.widget, self.told = widget, []
        monkeypatch.setattr(
            widget, "send", lambda _, buffers: self.told.extend(map(decoded, buffers))
        )

    def ask(self, do, **values):
        self.widget._handle_custom_msg(json.dumps({"do": do, **values}), [])

    def wait(self, fits):
        end = time.monotonic() + PATIENCE_S
        while time.monotonic() < end:
            for head, arrays in reversed(list(self.told)):
                if fits(head):
                    return head, arrays
            time.sleep(0.01)
        raise AssertionError([head.get("event", head.get("re")) for head, _ in self.told])


@pytest.fixture
def notebook(monkeypatch):
    monkeypatch.setattr(opening, "in_notebook", lambda: True)


@pytest.fixture
def cell(notebook, cube_stl, monkeypatch):
    widget = wireprint.studio(wireprint.load_mesh(cube_stl))
    yield Cell(widget, monkeypatch)
    widget.close()


def test_a_view_is_told_all_and_a_stroke_is_answered_by_its_print(cell):
    cell.ask("open")
    first, _ = cell.wait(lambda head: head.get("event") == "welcome")
    # There is no file to write beside.
    assert not first["saves"]
    cell.wait(lambda head: head.get("event") == "current")
    mark = {"shape": {"kind": "z", "low_mm": 10.0, "high_mm": 16.0}}
    cell.ask("mark", id=5, mark=mark)
    answer, _ = cell.wait(lambda head: head.get("re") == 5)
    cell.wait(
        lambda head: head.get("event") == "current" and head["revision"] == answer["revision"]
    )
    head, arrays = cell.wait(lambda head: head.get("event") == "print")
    assert "layer-wise" in [one["label"] for one in head["labels"]]
    assert len(arrays["strands"]) > 0
    assert len(cell.widget.region.marks) == 1
    assert b";TYPE:LAYER-WISE" in cell.widget.gcode()


def test_what_is_given_is_where_it_begins(notebook, cube_stl):
    settings = wireprint.Settings.load("voron-2.4", "pla")
    region = Region().add(ZRange(low_mm=20))
    widget = wireprint.studio(cube_stl, settings, region)
    try:
        made = wireprint.make(wireprint.load_mesh(cube_stl), settings, region)
        commands = [line for line in made.gcode.splitlines() if not line.startswith(b";")]
        found = widget.gcode().splitlines()
        assert [line for line in found if not line.startswith(b";")] == commands
        assert widget.region.marks == region.marks
        assert widget.settings.printer.name == "voron-2.4"
    finally:
        widget.close()


def test_the_program_is_the_windows_own(cell):
    from importlib import resources

    own = resources.files("wireprint.window").joinpath("static", "studio.js").read_text("utf-8")
    assert cell.widget._esm == own


def test_elsewhere_the_window_opens_in_the_browser(cube_stl, monkeypatch, capsys):
    import webbrowser

    from wireprint.window import server

    served, opened = [], []

    def serve(source, address):
        served.append(source)
        address.listening.close()

    monkeypatch.setattr(server, "serve", serve)
    monkeypatch.setattr(webbrowser, "open", opened.append)
    assert not opening.in_notebook()
    assert wireprint.studio(cube_stl) is None
    assert served[0].name == "cube.stl"
    assert opened == capsys.readouterr().out.split()


def test_what_is_missing_is_said(notebook, cube_stl, monkeypatch):
    import importlib.util

    find = importlib.util.find_spec
    monkeypatch.setattr(
        importlib.util, "find_spec", lambda name: None if name == "anywidget" else find(name)
    )
    with pytest.raises(wireprint.SettingError, match=r"wireprint\[notebook\]"):
        wireprint.studio(cube_stl)
