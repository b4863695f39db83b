"""``wireprint bench``: which models, which rows, and what survives."""

import csv
import dataclasses
import io
import json
import os
import random
import signal
import subprocess
import sys
import time

import numpy as np
import pyarrow.parquet
import pytest
from click.testing import CliRunner
from hypothesis import given
from hypothesis import strategies as st
from PIL import Image

import bench_jobs
from wireprint import ModelError, SettingError, Settings, __version__, cli, comparison, examples
from wireprint.bench import figures, histogram, local, pool, run, table, task
from wireprint.bench.local import Processes
from wireprint.bench.plan import Placement, plan
from wireprint.bench.table import COLUMNS, Table
from wireprint.cli import progress


@pytest.fixture
def cubes(tmp_path, cube):
    """Return a manifest of eight cubes, 10 to 17 mm wide."""
    manifest = tmp_path / "manifest.csv"
    rows = "".join(f"cube.stl,{width / 28}\n" for width in range(10, 18))
    manifest.write_text("name,scale\n" + rows)
    return manifest


#: The command, run by an interpreter.
MAIN = "from wireprint.cli import main; main()"


def planned(*models):
    return plan([str(model) for model in models], Placement(), {})


def job(evaluate):
    return task.Job(Settings.load().model_dump(mode="json"), evaluate)


def bench(*arguments):
    return CliRunner().invoke(cli.main, ["bench", *map(str, arguments)], catch_exceptions=False)


class TestPlan:
    def test_a_folder_holds_models_at_any_depth_in_the_order_of_their_paths(self, tmp_path):
        for name in ("b.obj", "a/z.STL", "a/c.3mf", "notes.txt"):
            (tmp_path / name).parent.mkdir(exist_ok=True)
            (tmp_path / name).touch()
        found = [one.model for one in planned(tmp_path)]
        assert found == [str(tmp_path / name) for name in ("a/c.3mf", "a/z.STL", "b.obj")]

    def test_a_pattern_is_expanded_even_if_no_shell_did(self, cube):
        assert [one.model for one in planned(cube.parent / "**" / "c*.stl")] == [str(cube)]

    def test_a_manifest_says_how_each_of_its_models_is_placed(self, tmp_path, cube):
        manifest = tmp_path / "manifest.csv"
        manifest.write_text("name,scale,up_axis\ncube.stl,2.5,Y\ncube.stl,,\n")
        one, other = plan([str(manifest)], Placement(scale=3.0, up="x"), {})
        assert (one.placement.scale, one.placement.up) == (2.5, "y")
        assert (other.placement.scale, other.placement.up) == (3.0, "x")
        assert one.model_sha256 == other.model_sha256
        assert one.settings_sha256 != other.settings_sha256

    def test_a_model_that_is_named_twice_counts_once(self, cube):
        assert len(planned(cube, cube.parent, cube)) == 1

    @pytest.mark.parametrize(
        ("text", "words"),
        [
            ("file,scale\ncube.stl,1\n", "column called name"),
            ("name,scale\ncube.stl,1\ncube.stl,big\n", r"manifest.csv:3: scale is 'big'"),
            ("name,up_axis\ncube.stl,w\n", r"manifest.csv:2: up_axis is 'w'"),
        ],
    )
    def test_a_wrong_manifest_is_refused_by_line(self, tmp_path, text, words):
        manifest = tmp_path / "manifest.csv"
        manifest.write_text(text)
        with pytest.raises((ModelError, SettingError), match=words):
            planned(manifest)

    def test_an_empty_folder_is_refused(self, tmp_path):
        with pytest.raises(ModelError, match="no models there"):
            planned(tmp_path)


class TestTask:
    def test_a_file_that_is_not_to_be_seen_is_asked_for(self, cube):
        [one] = planned(cube)
        content = cube.read_bytes()
        cube.unlink()
        assert task.run(job(bench_jobs.quick), one) is None
        sent = dataclasses.replace(one, content=content)
        assert task.run(job(bench_jobs.quick), sent)["size_x_mm"] == pytest.approx(28)

    def test_another_file_under_the_same_name_is_not_taken_for_it(self, cube):
        [one] = planned(cube)
        cube.write_bytes(examples.stl("sphere"))
        assert task.run(job(bench_jobs.quick), one) is None

    def test_a_fault_becomes_the_row_of_its_model_with_what_was_found_before(self, cube):
        row = task.run(job(bench_jobs.faulty), planned(cube)[0])
        assert row["error"] == "unexpected ZeroDivisionError: by zero"
        assert row["size_x_mm"] == pytest.approx(28)


class TestFigures:
    def test_a_condition_that_fails_costs_only_its_own_cells(self, cube, monkeypatch):
        compare = comparison.compare

        def fails_in_layers(mesh, settings, conditions, region):
            if "layerwise-fast" in conditions:
                raise ModelError("too thin")
            return compare(mesh, settings, conditions, region)

        monkeypatch.setattr(comparison, "compare", fails_in_layers)
        row = task.run(job(figures.comparison), planned(cube)[0])
        assert row["error"] == "layerwise-fast: too thin"
        assert "layerwise_fast_time_s" not in row
        assert row["certified"] is True
        solid_s, wire_s = row["layerwise_solid_time_s"], row["wireprint_time_s"]
        assert row["wireprint_speedup"] == pytest.approx(solid_s / wire_s)
        assert wire_s == pytest.approx(row["print_time_s"])


class Fragile:
    """A pool of one worker that is lost with every task of which `kills` is true."""

    def __init__(self, kills):
        self.kills = kills
        self.task = None

    def has_room(self, *, alone):
        return self.task is None

    def start(self, one, *, alone):
        self.task = one

    def wait(self):
        one, self.task = self.task, None
        return [pool.Ended(one, None if self.kills(one) else task.started(one))]


class Crowded:
    """A pool of one worker of three threads, lost with all it has when one task kills it."""

    def __init__(self, kills):
        self.kills = kills
        self.tasks = []
        self.alone = False

    def has_room(self, *, alone):
        return not self.tasks if alone else len(self.tasks) < 3 and not self.alone

    def start(self, one, *, alone):
        self.tasks.append(one)
        self.alone = alone

    def wait(self):
        tasks, self.tasks, self.alone = self.tasks, [], False
        dead = any(self.kills(one) for one in tasks)
        return [
            pool.Ended(one, None if dead else task.started(one), alone=len(tasks) == 1)
            for one in tasks
        ]


class TestPool:
    def test_a_task_whose_worker_is_lost_once_is_made_again(self, cubes):
        tasks, lost = planned(cubes), []

        def kills(one):
            lost.append(one.index)
            return len(lost) == 1

        rows = {one.index: row for one, row in pool.rows(tasks, Fragile(kills))}
        assert rows == {one.index: task.started(one) for one in tasks}

    def test_a_task_that_kills_its_worker_twice_fails_and_the_others_do_not(self, cubes):
        tasks = planned(cubes)
        found = pool.rows(tasks, Fragile(lambda one: one.index == 3))
        errors = {one.index: row["error"] for one, row in found}
        assert errors.pop(3) == "its worker was lost 2 times"
        assert set(errors.values()) == {None}
        assert len(errors) == 7

    def test_no_model_is_blamed_for_another_ones_deed(self, cubes):
        found = list(pool.rows(planned(cubes), Crowded(lambda one: one.index in (3, 5))))
        failures = {one.index for one, row in found if row["error"]}
        assert failures == {3, 5}
        assert len(found) == 8

    def test_random_kills_make_no_failures_of_models_that_share_a_worker(self, cubes):
        dice = random.Random(7)
        losses = []

        def unlucky(one):
            # The worker is lost now and then, but never twice with the same model alone.
            lost = dice.random() < 0.3 and losses.count(one.index) < 3
            losses.extend([one.index] * lost)
            return lost and losses.count(one.index) < 2

        found = list(pool.rows(planned(cubes), Crowded(unlucky)))
        assert {row["error"] for _, row in found} == {None}

    @pytest.mark.parametrize("seed", range(50))
    def test_random_kills_of_workers_with_one_task_each_make_no_failures(self, cubes, seed):
        dice = random.Random(seed)
        tasks = [dataclasses.replace(planned(cubes)[0], index=index) for index in range(60)]
        found = list(pool.rows(tasks, Fragile(lambda _: dice.random() < 0.1)))
        assert {row["error"] for _, row in found} == {None}
        assert len(found) == 60

    def test_a_fatal_model_is_found_among_random_kills(self, cubes):
        dice = random.Random(5)
        unlucky = Fragile(lambda one: one.index == 3 or dice.random() < 0.2)
        errors = {one.index: row["error"] for one, row in pool.rows(planned(cubes), unlucky)}
        assert errors.pop(3) == "its worker was lost 6 times"
        assert set(errors.values()) == {None}


class TestProcesses:
    def test_a_model_that_kills_its_process_costs_only_its_own_row(self, cubes):
        tasks = planned(cubes)
        with Processes(job(bench_jobs.fatal), 2) as processes:
            rows = {one.index: row for one, row in pool.rows(tasks, processes)}
        fatal = rows.pop(3)
        assert fatal["error"] == "its worker was lost 2 times"
        widths = [row["size_x_mm"] for _, row in sorted(rows.items())]
        assert widths == pytest.approx([10, 11, 12, 14, 15, 16, 17])

    def test_a_model_that_takes_too_long_ends_as_a_failure_and_the_others_go_on(
        self, cubes, monkeypatch
    ):
        monkeypatch.setattr(local, "STARTS_WITHIN_S", 20.0)
        limited = dataclasses.replace(job(bench_jobs.endless), limit_s=2.0)
        with Processes(limited, 2) as processes:
            rows = {one.index: row for one, row in pool.rows(planned(cubes), processes)}
        assert rows.pop(3)["error"] == "it took longer than 2 s"
        assert {row["error"] for row in rows.values()} == {None}

    def test_rows_do_not_depend_on_the_number_of_processes(self, cubes, tmp_path):
        def rows(jobs):
            results = tmp_path / f"{jobs}.csv"
            assert bench(cubes, "-o", results, "--no-compare", "--jobs", jobs).exit_code == 0
            with results.open(newline="") as file:
                found = list(csv.DictReader(file))
            return [
                {name: cell for name, cell in row.items() if name not in ("plan_s", "compute_s")}
                for row in found
            ]

        assert rows(1) == rows(3)


#: A row of each sort.
ROWS = [
    {"model": "a.stl", "model_sha256": "1", "settings_sha256": "x", "error": None}
    | {"certified": True, "collisions": 0, "coverage": 0.1 + 0.2, "up": "z"},
    {"model": "b, c.stl", "model_sha256": "", "settings_sha256": "x", "error": "lost"},
]


class TestTable:
    @pytest.mark.parametrize("suffix", table.SUFFIXES)
    def test_what_is_written_is_read_back(self, tmp_path, cube, suffix):
        path = tmp_path / f"results{suffix}"
        [one] = planned(cube)
        row = dict(ROWS[0], model_sha256=one.model_sha256, settings_sha256=one.settings_sha256)
        with Table(path) as kept:
            kept.add(row)
        kept.finish([row, ROWS[1]])
        found = Table(path).row_of(one)
        assert {name: found[name] for name in row} == row | {"model": one.model}
        assert list(found) == list(COLUMNS)
        assert [file.name for file in tmp_path.iterdir() if "results" in file.name] == [path.name]

    def test_what_a_killed_run_had_finished_is_kept_and_its_torn_row_is_not(self, tmp_path, cubes):
        tasks = planned(cubes)
        path = tmp_path / "results.csv"
        with Table(path) as kept:
            kept.add(task.started(tasks[0]))
        with (tmp_path / "results.csv.journal").open("a") as journal:
            journal.write('{"model": "cube.stl", "model_sh')
        with Table(path) as kept:
            kept.add(task.started(tasks[1]))
        found = Table(path)
        assert [found.row_of(one) is not None for one in tasks] == [True, True] + [False] * 6

    def test_rows_of_other_runs_stay(self, tmp_path, cubes):
        path = tmp_path / "results.csv"
        tasks = planned(cubes)
        Table(path).finish([task.started(one) for one in tasks[4:]])
        Table(path).finish([task.started(one) for one in tasks[:6]])
        assert all(Table(path).row_of(one) for one in tasks)
        assert len(path.read_text().splitlines()) == 1 + 8

    @pytest.mark.parametrize(
        "content", [b"name,scale\n", b"name,scale\ncube.stl,1\n", b"\xff\xfe", b"PAR1", b"notes"]
    )
    @pytest.mark.parametrize("suffix", table.SUFFIXES)
    def test_a_file_that_holds_no_results_is_not_overwritten(self, content, suffix, cube, tmp_path):
        path = tmp_path / f"notes{suffix}"
        path.write_bytes(content)
        with pytest.raises(SettingError, match="something else than results"):
            Table(path)
        assert bench(cube, "-o", path).exit_code == 4
        assert path.read_bytes() == content

    @pytest.mark.parametrize(
        "row",
        ["x,y", "x,y,z,big", "x,y,z,1,more", ",,,", 'x,y,"z', "x,y,,1"],
    )
    def test_a_damaged_row_is_named_by_line(self, row, tmp_path):
        path = tmp_path / "results.csv"
        path.write_text(f"model,model_sha256,settings_sha256,scale\na,b,c,1\n{row}\n")
        with pytest.raises(SettingError, match=r"results\.csv(:3: |: it holds)"):
            Table(path)

    @pytest.mark.parametrize(
        "content", ["null\n", "[]\n", "dear diary\n", '{"a": 1}\n', "1" * 5000]
    )
    def test_a_journal_that_is_none_is_named_and_not_taken_away(self, content, tmp_path):
        journal = tmp_path / "results.csv.journal"
        journal.write_text(content)
        with pytest.raises(SettingError, match=r"results\.csv\.journal:1: "):
            Table(tmp_path / "results.csv")
        assert journal.read_text() == content

    def test_a_run_that_ends_before_its_first_row_leaves_nothing(self, tmp_path):
        with pytest.raises(KeyboardInterrupt), Table(tmp_path / "results.csv"):
            raise KeyboardInterrupt
        assert list(tmp_path.iterdir()) == []

    @pytest.mark.parametrize(
        "text", ["=1+1", "+1", "-1", "@sum", "\tx", "'=1", "'", "caf\\xe9", 'a "b", c', "a\nb"]
    )
    def test_a_text_that_a_spreadsheet_would_compute_is_quoted_and_read_back(self, text, tmp_path):
        path = tmp_path / "results.csv"
        row = dict(ROWS[0], model=text, error=text)
        Table(path).finish([row])
        with path.open(newline="") as file:
            [cells] = csv.DictReader(file)
        assert not cells["model"].startswith(("=", "+", "-", "@", "\t"))
        [found] = table._read(path)
        assert (found["model"], found["error"]) == (text, text)

    @pytest.mark.parametrize("suffix", table.SUFFIXES)
    def test_a_name_that_is_no_utf8_costs_no_table(self, tmp_path, suffix):
        odd = os.fsdecode(b"caf\xe9.stl")
        (tmp_path / odd).write_bytes(examples.stl("sphere"))
        (tmp_path / "cube.stl").write_bytes(examples.stl("cube"))
        results = tmp_path / f"results{suffix}"
        arguments = (tmp_path, "-o", results, "--no-compare", "--jobs", "1", "--scale", "0.5")
        assert bench(*arguments).exit_code == 0
        names = [row["model"] for row in table._read(results)]
        assert names == [f"{tmp_path}/caf\\xe9.stl", f"{tmp_path}/cube.stl"]
        before = results.read_bytes()
        assert bench(*arguments).exit_code == 0
        assert results.read_bytes() == before

    def test_an_unknown_suffix_is_refused(self, tmp_path):
        with pytest.raises(SettingError, match=r"\.csv or \.parquet"):
            Table(tmp_path / "results.xls")


FINITE = st.floats(0.01, 1e4)


class TestHistogram:
    @given(st.lists(FINITE, min_size=1), st.floats(0, 1))
    def test_quantiles_are_numpys(self, values, share):
        assert histogram.quantile(values, share) == pytest.approx(np.quantile(values, share))

    @given(st.lists(FINITE, min_size=1, max_size=200))
    def test_every_value_is_in_one_bin(self, values):
        edges, counts = histogram.bins(values)
        assert np.all(np.diff(edges) > 0)
        assert sum(counts) == len(values)
        assert edges[0] <= min(values) * (1 + 1e-9)
        assert max(values) <= edges[-1] * (1 + 1e-9)

    @given(st.lists(FINITE, min_size=1, max_size=20))
    def test_any_values_can_be_drawn(self, values):
        drawn = Image.open(io.BytesIO(histogram.png(values, "title", "axis")))
        assert drawn.size == (histogram.WIDTH, histogram.HEIGHT)
        colours = {colour: count for count, colour in drawn.getcolors(1 << 20)}
        assert colours[histogram.BAR] > 0


class TestCommand:
    def test_failures_are_rows_too_and_the_summary_tells_all(self, cube, tmp_path):
        broken = tmp_path / "broken.stl"
        broken.write_bytes(b"no model")
        absent = tmp_path / "absent.stl"
        results = tmp_path / "results.parquet"
        done = bench(cube, broken, absent, "-o", results, "--json", "--no-compare", "--jobs", "1")
        assert done.exit_code == 0
        found = json.loads(done.stdout)
        assert (found["models"], found["failed"], found["certified"]) == (3, 2, 1)
        assert [failure["model"] for failure in found["failures"]] == [str(broken), str(absent)]
        rows = pyarrow.parquet.read_table(results).to_pylist()
        assert [row["model"] for row in rows] == [str(cube), str(broken), str(absent)]
        assert rows[0]["certified"] is True
        assert rows[0]["coverage"] > 0.95
        assert rows[1]["error"]
        assert str(broken) not in rows[1]["error"]
        assert rows[2]["error"] == "the file cannot be read: No such file or directory"

    def test_every_condition_has_its_columns_and_the_speed_ups_a_picture(self, cube, tmp_path):
        results = tmp_path / "results.csv"
        found = json.loads(bench(cube, "-o", results, "--json", "--jobs", "1").stdout)
        with results.open(newline="") as file:
            [row] = csv.DictReader(file)
        for condition, spread in found["speedup"].items():
            column = f"{condition.replace('-', '_')}_speedup"
            assert spread["median"] == pytest.approx(float(row[column]))
        assert found["speedup"]["layerwise-solid"]["median"] == 1
        with Image.open(found["histogram"]) as picture:
            assert picture.size == (histogram.WIDTH, histogram.HEIGHT)

    def test_a_row_tells_what_it_was_made_with_and_one_time_for_the_wire_print(
        self, cube, tmp_path
    ):
        results = tmp_path / "results.parquet"
        options = ["--printer", "voron-2.4", "--material", "pla", "--jobs", "1", "--scale", "0.5"]
        done = bench(cube, "-o", results, *options)
        assert "on voron-2.4 with pla" in done.stdout
        [row] = pyarrow.parquet.read_table(results).to_pylist()
        assert (row["printer"], row["material"]) == ("voron-2.4", "pla")
        assert row["version"] == __version__
        assert row["wireprint_time_s"] == row["print_time_s"]

    def test_the_command_fails_where_every_row_does(self, cube, tmp_path):
        broken = tmp_path / "broken.stl"
        broken.write_bytes(b"no model")
        results = tmp_path / "a.csv"
        assert bench(broken, "-o", results, "--jobs", "1").exit_code == 1
        with results.open(newline="") as file:
            [row] = csv.DictReader(file)
        assert (row["printer"], row["material"]) == ("kossel-mini", "abs")

    def test_a_picture_that_is_no_histogram_is_not_overwritten(self, cube, tmp_path):
        picture = tmp_path / "results.png"
        picture.write_bytes(b"\x89PNG holiday")
        done = bench(cube, "-o", tmp_path / "results.csv", "--jobs", "1")
        assert done.exit_code == 2
        assert "no histogram" in done.stderr
        assert picture.read_bytes() == b"\x89PNG holiday"
        picture.write_bytes(histogram.png([1.0], "", ""))
        assert histogram.is_ours(picture)

    def test_without_a_terminal_a_line_is_printed_now_and_then(self, cubes, tmp_path, monkeypatch):
        monkeypatch.setattr(progress, "LINE_EVERY_S", 0.0)
        done = bench(cubes, "-o", tmp_path / "results.csv", "--no-compare", "--jobs", "2")
        assert "8 of 8 models, 0 failed" in done.stderr

    def test_a_second_run_computes_nothing(self, cubes, tmp_path):
        results = tmp_path / "results.csv"
        assert bench(cubes, "-o", results, "--no-compare", "--jobs", "2").exit_code == 0
        first = results.read_text()
        begin = time.perf_counter()
        assert bench(cubes, "-o", results, "--no-compare", "--jobs", "2").exit_code == 0
        assert time.perf_counter() - begin < 1
        # The times to compute would differ if anything had been computed again.
        assert results.read_text() == first

    def test_failures_are_made_again_only_if_asked_for(self, cube, tmp_path):
        results = tmp_path / "results.csv"
        [one] = planned(cube)
        kept = Table(results)
        kept.finish([task.failed(one, "its worker was lost")])

        def opened(count):
            return Processes(job(bench_jobs.quick), count)

        assert run.run([one], Table(results), opened)[0]["error"] == "its worker was lost"
        again = run.run([one], Table(results), opened, retry_failed=True)
        assert again[0]["error"] is None

    def test_a_run_that_is_killed_goes_on_where_it_was(self, cubes, tmp_path):
        results = tmp_path / "results.csv"
        journal = tmp_path / "results.csv.journal"
        command = [sys.executable, "-c", MAIN, "bench", cubes, "-o", results]
        first = subprocess.Popen([*command, "--no-compare", "--jobs", "1"])
        until = time.monotonic() + 60
        while not (journal.exists() and journal.stat().st_size > 1):
            assert first.poll() is None
            assert time.monotonic() < until
            time.sleep(0.005)
        first.send_signal(signal.SIGKILL)
        first.wait()
        kept = [json.loads(line) for line in journal.read_text().splitlines() if line]
        assert not results.exists()
        assert bench(cubes, "-o", results, "--no-compare", "--jobs", "1").exit_code == 0
        assert not journal.exists()
        with results.open(newline="") as file:
            times = [row["compute_s"] for row in csv.DictReader(file)]
        assert len(times) == 8
        assert {str(row["compute_s"]) for row in kept} <= set(times)


@pytest.mark.parametrize("cell", ['"1.5"', "true", "[1]", "{}"])
def test_a_journal_whose_numbers_are_none_is_refused_by_its_line(cell, tmp_path):
    row = f'{{"model": "a", "model_sha256": "b", "settings_sha256": "c", "coverage": {cell}}}'
    (tmp_path / "r.csv.journal").write_text(row + "\n")
    with pytest.raises(SettingError, match=r"r\.csv\.journal:1: this is no row"):
        Table(tmp_path / "r.csv")


def test_what_does_not_end_is_no_model(tmp_path):
    [one] = plan(["/dev/zero"], Placement(), {})
    assert "it is no file" in one.error
    os.mkfifo(tmp_path / "pipe.stl")
    [one] = plan([str(tmp_path / "pipe.stl")], Placement(), {})
    assert "it is no file" in one.error
