"""What a worker does with one model."""

from __future__ import annotations

import hashlib
import tempfile
import time
from contextlib import contextmanager
from dataclasses import asdict, dataclass, replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

from wireprint._core import WireprintError, __version__
from wireprint.text import one_line

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator

    from wireprint.bench.plan import Task
    from wireprint.model import Model
    from wireprint.settings import Settings

Row = dict[str, Any]


@dataclass(frozen=True)
class Job:
    """What all tasks of a run share; it travels to the workers."""

    #: `Settings.model_dump` in JSON's types, for tasks without their own.
    settings: dict[str, Any]
    #: Fills a row with the figures of a model; a function of a module that workers can import.
    evaluate: Callable[[Model, Settings, Row], None]
    #: Whether each model is turned into the pose that is printed best.
    orient: bool = False
    #: What one model may take, s; None: whatever it takes.
    limit_s: float | None = None


def run(job: Job, task: Task) -> Row | None:
    """Evaluate a model.

    Returns
    -------
    Row or None
        What was found; the column ``error`` tells why it is not complete. None: the file that the
        task means is not to be seen from here.
    """
    row = started(task)
    begin = time.perf_counter()
    with _file(task) as path:
        if path is None:
            return None
        row["error"] = _evaluated(job, task, path, row)
    if row["error"] is not None:
        row["error"] = one_line(row["error"])
    row["compute_s"] = time.perf_counter() - begin
    return row


def _evaluated(job: Job, task: Task, path: Path, row: Row) -> str | None:
    """Fill in a row as far as possible; return why no further."""
    from wireprint.model import load_model
    from wireprint.settings import Settings

    try:
        settings = Settings.from_mapping(task.settings or job.settings)
        row["printer"], row["material"] = settings.printer.name, settings.material.name
        model = load_model(path, **asdict(task.placement))
        job.evaluate(_turned(model, settings, row) if job.orient else model, settings, row)
    except WireprintError as error:
        return str(error).removeprefix(f"{path}: ")
    except (KeyboardInterrupt, SystemExit):
        raise
    except BaseException as error:
        # A fault of ours, a panic of the core among them (which is no Exception), must cost one
        # model, not the run; its row says what to look for.
        return f"unexpected {type(error).__name__}: {error}"
    return None


def _turned(model: Model, settings: Settings, row: Row) -> Model:
    """Turn a model into its best pose, and tell the angles about x, y and z."""
    from wireprint.hybrid.motion import motion
    from wireprint.orientation import orient

    found = orient(model.mesh, settings)
    row["turned_deg"] = " ".join(f"{angle:g}" for angle in found.rotate_deg)
    moved = model.region
    if moved:
        moved = moved.transformed(motion(model.mesh, found.mesh, found.rotate_deg))
    return replace(model, mesh=found.mesh, region=moved)


def started(task: Task) -> Row:
    """Return the cells of a row that are known before the work."""
    return {
        "model": task.name,
        "model_sha256": task.model_sha256,
        "settings_sha256": task.settings_sha256,
        "scale": task.placement.scale,
        "up": task.placement.up,
        "error": task.error,
        "version": __version__,
    }


def failed(task: Task, reason: str) -> Row:
    """Return the row of a model that never came back."""
    return started(task) | {"error": reason}


def overrun(task: Task, limit_s: float) -> Row:
    """Return the row of a model that took too long."""
    return failed(task, f"it took longer than {limit_s:g} s")


@contextmanager
def _file(task: Task) -> Iterator[Path | None]:
    """Give a path of the very file that is meant: its own, or one with the bytes that were sent."""
    path = Path(task.model)
    if task.content is None:
        yield path if _is_meant(path, task.model_sha256) else None
        return
    with tempfile.TemporaryDirectory(prefix="wireprint-") as folder:
        copy = Path(folder) / path.name
        copy.write_bytes(task.content)
        yield copy


def _is_meant(path: Path, sha256: str) -> bool:
    try:
        return hashlib.sha256(path.read_bytes()).hexdigest() == sha256
    except OSError:
        return False
