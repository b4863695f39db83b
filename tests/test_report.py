"""``wireprint report``: results by kind of shape, and what changed between two of them."""

import json
import re
from html.parser import HTMLParser

import pytest
from click.testing import CliRunner

from wireprint import cli
from wireprint.bench.kinds import by_kind, changes
from wireprint.bench.table import Table


def row(model, **cells):
    whole = {"model": model, "model_sha256": model.rpartition("/")[2], "settings_sha256": "s"}
    whole |= {"scale": 1.0, "up": "z", "printer": "p", "material": "m", "certified": True}
    return whole | {"coverage": 1.0, "print_time_s": 60.0, "compute_s": 0.5} | cells


def written(path, rows):
    Table(path).finish(rows)
    return path


@pytest.fixture(params=["csv", "parquet"])
def tables(request, tmp_path):
    """An older and a newer table of four models of two kinds."""
    names = ["in/vase/a.stl", "in/vase/b.stl", "in/part/c.stl", "in/part/<d>.stl"]
    old = [row(name, print_time_s=60.0 + n) for n, name in enumerate(names)]
    new = [dict(one) for one in old]
    new[0] |= {"print_time_s": 30.0}
    new[1] |= {"certified": False, "coverage": 0.5}
    new[3] |= {"error": "it took longer than 5 s", "certified": None, "coverage": None}
    new.append(row("in/part/e.stl"))
    suffix = request.param
    before, now = tmp_path / f"old.{suffix}", tmp_path / f"new.{suffix}"
    return written(before, old), written(now, new)


def called(*words):
    return CliRunner().invoke(cli.main, ["report", *map(str, words)])


class Parsed(HTMLParser):
    def __init__(self, text):
        super().__init__()
        self.tags, self.words, self.asked = [], [], []
        self.feed(text)

    def handle_starttag(self, tag, attrs):
        self.tags.append(tag)
        self.asked += [value for name, value in attrs if name in ("src", "href")]

    def handle_data(self, data):
        self.words.append(data)


def test_the_page_asks_for_nothing_and_tells_every_kind(tables, tmp_path):
    page = tmp_path / "page.html"
    run = called(tables[1], "-o", page)
    assert run.exit_code == 0, run.output
    parsed = Parsed(page.read_text())
    assert not parsed.asked
    assert "script" not in parsed.tags
    assert {"all", "part", "vase"} <= set(parsed.words)
    # Names are words, not tags.
    assert "in/part/<d>.stl" in parsed.words
    assert "it took longer than 5 s" in parsed.words


def test_what_changed_is_told_model_by_model(tables, tmp_path):
    page = tmp_path / "page.html"
    run = called(tables[1], "--against", tables[0], "-o", page, "--json")
    assert run.exit_code == 0, run.output
    found = json.loads(run.stdout)["changes"]
    assert found["shared"] == 4
    assert found["lost"] == ["in/vase/b.stl", "in/part/<d>.stl"]
    assert found["failing"] == ["in/part/<d>.stl"]
    assert found["new"] == ["in/part/e.stl"]
    assert not found["gone"]
    [faster] = found["figures"]["print_time_s"]
    assert (faster["model"], faster["before"], faster["after"]) == ("in/vase/a.stl", 60.0, 30.0)
    assert "-50.0%" in page.read_text()


def test_the_same_table_has_not_changed(tables):
    run = called(tables[0], "--against", tables[0], "-o", "-", "--json")
    told = json.loads(run.stderr)["changes"]
    assert not any(told["figures"].values())
    assert not any(told[name] for name in ("gone", "new", "lost", "won", "failing", "mended"))


def test_a_model_is_the_same_under_another_name():
    found = changes([row("old/a.stl")], [row("elsewhere/a.stl", coverage=0.9)])
    assert found.shared == 1
    assert found.figures["coverage"][0].after == 0.9


def test_kinds_are_folders_from_where_paths_part():
    rows = [row(f"/data/{name}.stl") for name in ("x/y/a", "x/z/b", "x/y/c")]
    assert {kind: len(of) for kind, of in by_kind(rows).items()} == {"y": 2, "z": 1}
    assert list(by_kind(rows[:1])) == ["y"]
    assert list(by_kind([row("a.stl")])) == ["all"]


@pytest.mark.parametrize("text", [b"", b"a,b\n1,2\n", b"\x00\xff", b"model\n"])
def test_what_is_no_table_is_told_and_nothing_written(tmp_path, text):
    path = tmp_path / "x.csv"
    path.write_bytes(text)
    run = called(path, "-o", tmp_path / "page.html")
    assert run.exit_code == 4, run.output
    assert re.search(r"x\.csv", run.output)
    assert not (tmp_path / "page.html").exists()


def test_the_table_that_is_read_is_not_written_over(tables):
    assert called(tables[0], "-o", tables[0]).exit_code == 2
