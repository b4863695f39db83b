"""Kill random workers of a cluster while it evaluates models, and see that no row fails for it.

``python tests/fuzz/worker_kills.py [KILLS] [SEED] [MODELS]``: a scheduler and two workers on this
machine, whose nannies start them anew. A thread kills one of both again and again, by SIGKILL,
until as many were killed as asked for; the models are evaluated meanwhile. Every model must have
its row in the end, and none an error.
"""

from __future__ import annotations

import os
import random
import signal
import sys
import tempfile
import threading
import time
from pathlib import Path
from typing import TYPE_CHECKING

sys.path.insert(0, str(Path(__file__).parents[1]))

import bench_jobs
from wireprint import Settings, examples
from wireprint.bench import cluster, pool, task
from wireprint.bench.plan import Placement, plan

if TYPE_CHECKING:
    from distributed import LocalCluster, Nanny

#: Between two kills no more than this passes, s.
WITHIN_S = 2.0


def kill_workers(local: LocalCluster, kills: int, seed: int, done: threading.Event) -> None:
    """Kill a random worker again and again."""
    draw = random.Random(seed)
    left, killed = kills, set()
    while left and not done.wait(draw.uniform(0, WITHIN_S)):
        # One that is killed before it has begun is given up by its nanny.
        alive = [
            nanny
            for nanny in local.workers.values()
            if nanny.worker_address not in killed and has_begun(nanny)
        ]
        nanny = draw.choice(alive) if alive else None
        if nanny is not None and nanny.pid is not None:
            killed.add(nanny.worker_address)
            os.kill(nanny.pid, signal.SIGKILL)
            left -= 1
    print(f"{kills - left} workers killed", flush=True)


def has_begun(nanny: Nanny) -> bool:
    """Whether a nanny takes its worker as running, and would start it anew."""
    return nanny.process is not None and nanny.process.status.name == "running"


def main() -> None:
    """Evaluate models under fire."""
    words = [*sys.argv[1:], *["40", "1", "400"][len(sys.argv) - 1 :]]
    kills, seed, models = map(int, words)
    import dask
    from distributed import LocalCluster

    # A machine that is busy starts programs slowly: 15 s after a loss Dask's local cluster would
    # close the nanny whose new worker is not there yet, or has been killed again.
    dask.config.set({"distributed.deploy.lost-worker-timeout": "1 hour"})
    cluster.WORKERS_WITHIN_S = 300.0
    done = threading.Event()
    with tempfile.TemporaryDirectory() as scratch:
        folder = Path(scratch)
        (folder / "cube.stl").write_bytes(examples.stl("cube"))
        rows = "".join(f"cube.stl,{1 + number / 1000}\n" for number in range(models))
        (folder / "manifest.csv").write_text("name,scale\n" + rows)
        tasks = plan([str(folder / "manifest.csv")], Placement(), {})
        job = task.Job(Settings.load().model_dump(mode="json"), bench_jobs.slow)
        with LocalCluster(
            n_workers=2, threads_per_worker=1, dashboard_address=None, local_directory=scratch
        ) as local:
            killer = threading.Thread(target=kill_workers, args=(local, kills, seed, done))
            begin = time.monotonic()
            killer.start()
            with cluster.Cluster(job, local.scheduler_address) as opened:
                found = {one.index: row for one, row in pool.rows(tasks, opened)}
            done.set()
            killer.join()
    failed = {index: row["error"] for index, row in found.items() if row["error"]}
    print(
        f"{len(found)} of {models} models in {time.monotonic() - begin:.0f} s, "
        f"{len(failed)} failed: {failed}"
    )
    sys.exit(bool(failed) or len(found) < models)


if __name__ == "__main__":
    main()
