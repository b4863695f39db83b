"""``wireprint bench --scheduler``: a real scheduler and two workers, some of which die."""

import csv
import dataclasses
import json
import os
import signal
import subprocess
import sys
import time
from contextlib import ExitStack, contextmanager, suppress
from pathlib import Path

import pytest
from click.testing import CliRunner

import bench_jobs
from wireprint import SettingError, Settings, WireprintError, cli, examples
from wireprint.bench import cluster, pool, run, task
from wireprint.bench.cluster import Cluster
from wireprint.bench.plan import Placement, plan
from wireprint.bench.table import Table

pytest.importorskip("distributed", reason="Dask is not installed: pip install '.[dask]'")

#: How long anything here may take to begin, s.
PATIENCE_S = 60


@contextmanager
def dask(*arguments):
    """Run a command of Dask's in a session of its own; end all of it afterwards."""
    # Workers import the jobs of the tests; the core's threads would only queue.
    places = [str(Path(__file__).parent), os.environ.get("PYTHONPATH", "")]
    environment = os.environ | {
        "PYTHONPATH": os.pathsep.join(filter(None, places)),
        "RAYON_NUM_THREADS": "1",
    }
    process = subprocess.Popen(
        [sys.executable, "-m", "dask", *map(str, arguments)],
        env=environment,
        stdout=subprocess.DEVNULL,
        stderr=subprocess.DEVNULL,
        start_new_session=True,
    )
    try:
        yield process
    finally:
        killed(process)


def killed(process):
    """End a command and all that it started, as a machine that loses power would."""
    with suppress(ProcessLookupError):
        os.killpg(process.pid, signal.SIGKILL)
    process.wait()


@pytest.fixture
def scheduler(tmp_path):
    """Return the address of a scheduler with two workers, and the workers' processes."""
    card = tmp_path / "scheduler.json"
    local = ["--host", "127.0.0.1", "--no-dashboard"]
    with ExitStack() as stack:
        options = ["--scheduler-file", card, "--port", 0, *local]
        stack.enter_context(dask("scheduler", *options))
        address = awaited(lambda: address_on(card))
        options = ["--nthreads", 1, "--local-directory", tmp_path, *local]
        workers = [stack.enter_context(dask("worker", address, *options)) for _ in range(2)]
        awaited(lambda: len(threads(address)) == 2)
        yield address, workers


def address_on(card):
    """Read where a scheduler is; None as long as the card is not written."""
    with suppress(FileNotFoundError, json.JSONDecodeError):
        return json.loads(card.read_text())["address"]


def threads(address):
    from distributed import Client

    with Client(address, set_as_default=False) as client:
        return client.nthreads()


def awaited(condition):
    until = time.monotonic() + PATIENCE_S
    while not (found := condition()):
        assert time.monotonic() < until
        time.sleep(0.05)
    return found


@pytest.fixture
def tasks(tmp_path):
    """Twelve cubes, 10 to 21 mm wide."""
    (tmp_path / "cube.stl").write_bytes(examples.stl("cube"))
    manifest = tmp_path / "manifest.csv"
    rows = "".join(f"cube.stl,{width / 28}\n" for width in range(10, 22))
    manifest.write_text("name,scale\n" + rows)
    return plan([str(manifest)], Placement(), {})


def job(evaluate):
    return task.Job(Settings.load().model_dump(mode="json"), evaluate)


def widths(rows):
    return [row["size_x_mm"] for row in rows]


def test_a_lost_worker_costs_no_row(scheduler, tasks, tmp_path):
    address, workers = scheduler
    finished = []

    def lose_one(one, row):
        finished.append(one)
        if len(finished) == 2:
            killed(workers[0])

    opened = run.cluster(job(bench_jobs.slow), address)
    rows = run.run(tasks, Table(tmp_path / "results.csv"), opened, on_row=lose_one)
    assert widths(rows) == pytest.approx(range(10, 22))
    assert {row["error"] for row in rows} == {None}
    assert len(threads(address)) == 1


def test_a_model_that_kills_its_worker_twice_fails_and_the_others_do_not(scheduler, tasks):
    # The workers' nannies start them anew.
    with Cluster(job(bench_jobs.fatal), scheduler[0]) as opened:
        rows = {one.index: row for one, row in pool.rows(tasks, opened)}
    assert rows.pop(3)["error"] == "its worker was lost 2 times"
    assert len(rows) == 11
    assert {row["error"] for row in rows.values()} == {None}


def test_a_model_that_takes_too_long_ends_with_its_worker(scheduler, tasks):
    # The worker's nanny starts it anew.
    limited = dataclasses.replace(job(bench_jobs.endless), limit_s=5.0)
    with Cluster(limited, scheduler[0]) as opened:
        rows = {one.index: row for one, row in pool.rows(tasks, opened)}
    assert rows.pop(3)["error"] == "it took longer than 5 s"
    assert {row["error"] for row in rows.values()} == {None}


def test_workers_that_do_not_see_a_file_are_sent_it(scheduler, tmp_path, monkeypatch):
    # The workers stand elsewhere, so that the relative path leads nowhere for them.
    (tmp_path / "elsewhere.stl").write_bytes(examples.stl("cube"))
    monkeypatch.chdir(tmp_path)
    with Cluster(job(bench_jobs.quick), scheduler[0]) as opened:
        [(_, row)] = pool.rows(plan(["elsewhere.stl"], Placement(), {}), opened)
    assert row["error"] is None
    assert row["size_x_mm"] == pytest.approx(28)


def test_the_command_gives_the_same_rows_as_on_one_machine(scheduler, tmp_path):
    model = tmp_path / "cube.stl"
    model.write_bytes(examples.stl("cube"))

    def bench(name, *options):
        results = tmp_path / name
        arguments = ["bench", str(model), "-o", str(results), "--no-compare", *options]
        done = CliRunner().invoke(cli.main, arguments, catch_exceptions=False)
        assert done.exit_code == 0, done.output
        with results.open(newline="") as file:
            [row] = csv.DictReader(file)
        return {name: cell for name, cell in row.items() if name not in ("plan_s", "compute_s")}

    assert bench("far.csv", "--scheduler", scheduler[0]) == bench("near.csv", "--jobs", "1")


def test_a_cluster_without_workers_is_waited_for_in_vain_only_so_long(
    scheduler, tasks, monkeypatch
):
    address, workers = scheduler
    for worker in workers:
        killed(worker)
    monkeypatch.setattr(cluster, "WORKERS_WITHIN_S", 1.0)
    with (
        Cluster(job(bench_jobs.quick), address) as opened,
        pytest.raises(WireprintError, match="no worker for 1 s"),
    ):
        list(pool.rows(tasks, opened))


def test_a_scheduler_that_does_not_answer_is_refused(monkeypatch):
    monkeypatch.setattr(cluster, "CONNECT_WITHIN_S", 1.0)
    with pytest.raises(SettingError, match=r"no scheduler answers at tcp://127\.0\.0\.1:1"):
        Cluster(job(bench_jobs.quick), "tcp://127.0.0.1:1")


def test_workers_with_other_code_are_refused_by_hash(scheduler, tasks, monkeypatch):
    monkeypatch.setattr(cluster, "_ours", lambda: ("0.0.0", "another"))
    with pytest.raises(WireprintError, match=r"no worker .* this is 0\.0\.0 \(another\)"):
        Cluster(job(bench_jobs.quick), scheduler[0])


def test_a_scheduler_that_is_lost_is_named(tmp_path, tasks, monkeypatch):
    card = tmp_path / "lost.json"
    local = ["--host", "127.0.0.1", "--no-dashboard"]
    with dask("scheduler", "--scheduler-file", card, "--port", 0, *local) as process:
        address = awaited(lambda: address_on(card))
        monkeypatch.setattr(cluster, "CONNECT_WITHIN_S", 3.0)
        with Cluster(job(bench_jobs.quick), address) as opened:
            killed(process)
            with pytest.raises(WireprintError, match=r"scheduler at .* is gone; the rows so far"):
                list(pool.rows(tasks, opened))


def test_tls_without_certificates_is_explained(monkeypatch):
    monkeypatch.setattr(cluster, "CONNECT_WITHIN_S", 1.0)
    with pytest.raises(SettingError, match="tls needs certificates"):
        Cluster(job(bench_jobs.quick), "tls://127.0.0.1:1")
