"""Breaches planted anywhere into certified files of our own are found, at the line they are in."""

import math
import re

import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st

import wireprint
from wireprint import examples

LABEL = re.compile(rb";TYPE:(\w+)")
WORD = re.compile(rb"([XYZ])(-?[\d.]+)")


class Print:
    """A certified file, its lines, and where each of its strokes starts and ends."""

    def __init__(self, model, folder):
        path = folder / f"{model}.stl"
        path.write_bytes(examples.stl(model))
        mesh = wireprint.load_mesh(path)
        text = wireprint.make(mesh, wireprint.Settings.load(), compare=False).gcode
        self.lines = text.split(b"\n")
        self.strokes = {b"POST": [], b"DIAGONAL": [], b"CONTOUR": []}
        label, at = b"", {b"X": 0.0, b"Y": 0.0, b"Z": 0.0}
        for index, line in enumerate(self.lines):
            if match := LABEL.match(line):
                label = match[1]
            if not line.startswith((b"G0", b"G1")):
                continue
            start = dict(at)
            at.update({axis: float(value) for axis, value in WORD.findall(line)})
            if b" E" in line and start != at and label in self.strokes:
                self.strokes[label].append((index, start, dict(at)))

    def with_lines(self, index, *lines):
        """The file with the line at `index` replaced."""
        return b"\n".join([*self.lines[:index], *lines, *self.lines[index + 1 :]])


@pytest.fixture(scope="module", params=["cube", "sphere", "bottle"])
def printed(request, tmp_path_factory):
    return Print(request.param, tmp_path_factory.mktemp("planted"))


def place(point):
    return b"X%.3f Y%.3f Z%.3f" % (point[b"X"], point[b"Y"], point[b"Z"])


def lines_of(breaches):
    return [breach.line for breach in breaches]


some = settings(max_examples=25, deadline=None)
anywhere = st.floats(0, 0.999)


def test_the_files_themselves_are_certified(printed):
    assert wireprint.check(b"\n".join(printed.lines)).ok


@some
@given(where=anywhere, depth=st.floats(0.5, 4))
def test_a_travel_lowered_into_a_post_is_found(printed, where, depth):
    posts = printed.strokes[b"POST"]
    index, start, end = posts[int(where * len(posts))]
    depth = min(depth, end[b"Z"] - start[b"Z"])
    low = {**end, b"Z": end[b"Z"] - depth}
    text = printed.with_lines(index, printed.lines[index], b"G0 " + place(low), b"G0 " + place(end))
    hits = [hit for hit in wireprint.check(text).collisions if hit.line == index + 2]
    assert len(hits) == 1
    assert hits[0].depth_mm >= depth - 0.01


@some
@given(where=anywhere, share=st.floats(0.1, 0.95))
def test_a_steepened_diagonal_is_found(printed, where, share):
    """Its foot is nearer to its post than the flank allows, by more than a joint's squash."""
    diagonals = printed.strokes[b"DIAGONAL"]
    index, start, end = diagonals[int(where * len(diagonals))]
    head = wireprint.Settings.load().printer.head
    height = start[b"Z"] - end[b"Z"] - head.nozzle_mm / 2
    # A stroke that falls by less than a joint's squash can be as steep as it likes.
    assume(height > 0.01)
    reach = head.tip_radius_mm + height / math.tan(math.radians(head.slant_deg))
    run = math.hypot(end[b"X"] - start[b"X"], end[b"Y"] - start[b"Y"])
    foot = dict(end)
    for axis in (b"X", b"Y"):
        foot[axis] = start[axis] + share * reach / run * (end[axis] - start[axis])
    text = printed.with_lines(index, b"G1 " + place(foot) + b" E0.5", b"G0 " + place(end))
    assert index + 1 in lines_of(wireprint.check(text).collisions)


@some
@given(where=anywhere)
def test_a_removed_post_is_found(printed, where):
    posts = [post for post in printed.strokes[b"POST"] if post[2][b"Z"] - post[1][b"Z"] > 1.5]
    index, _, end = posts[int(where * len(posts))]
    found = wireprint.check(printed.with_lines(index, b"G0 " + place(end)))
    assert not found.ok
    assert found.floating_starts[0].line > index


@some
@given(rise=st.floats(1.1, 5))
def test_a_shifted_start_is_found(printed, rise):
    index, start, end = printed.strokes[b"CONTOUR"][0]
    shifted = {**start, b"Z": start[b"Z"] + rise}
    stroke = b"G1 " + place(end) + b" E1"
    text = printed.with_lines(index, b"G0 " + place(shifted), stroke)
    assert lines_of(wireprint.check(text).floating_starts) == [index + 2]


@some
@given(where=anywhere, beyond=st.floats(0.01, 500))
def test_leaving_the_bed_is_found(printed, where, beyond):
    index, start, _ = printed.strokes[b"CONTOUR"][-1]
    outside = {b"X": 85 + beyond, b"Y": 0.0, b"Z": start[b"Z"] + 20}
    text = printed.with_lines(index, printed.lines[index], b"G0 " + place(outside))
    bounds = {breach.line: breach for breach in wireprint.check(text).out_of_bounds}
    assert bounds[index + 2].bound == "volume"
    assert bounds[index + 2].value == pytest.approx(beyond, abs=0.001)
