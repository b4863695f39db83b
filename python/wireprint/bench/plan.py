"""Which models are to be evaluated, and how each is placed."""

from __future__ import annotations

import csv
import glob
import hashlib
import json
import stat
from dataclasses import asdict, dataclass, field
from pathlib import Path
from typing import TYPE_CHECKING, Any, Final

from wireprint import mesh, streams
from wireprint._core import ModelError, SettingError, WireprintError, __version__
from wireprint.streams import STREAM
from wireprint.text import one_line

if TYPE_CHECKING:
    from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence

#: What a folder is searched for.
SUFFIXES: Final = tuple(f".{name}" for name in mesh.SUFFIXES)
AXES: Final = ("x", "y", "z")


@dataclass(frozen=True)
class Placement:
    """How a model is placed: arguments of ``wireprint.load_mesh``."""

    scale: float = 1.0
    units: str = "mm"
    up: str = "z"
    rotate: tuple[float, float, float] = (0.0, 0.0, 0.0)
    height_mm: float | None = None
    file_format: str | None = None
    plate: int | None = None


@dataclass(frozen=True)
class Task:
    """One model to evaluate."""

    #: Place among the tasks of its run.
    index: int
    #: Path as the user reaches it; the row's name.
    model: str
    placement: Placement
    #: Hash of the file; empty where it cannot be read.
    model_sha256: str
    #: Hash of everything else that the row depends on.
    settings_sha256: str
    #: Size of the file; large ones begin first.
    size_bytes: int = 0
    #: Why it cannot even begin.
    error: str | None = None
    #: The settings, as `Settings.model_dump` gives them, of a model that brings its own.
    settings: dict[str, Any] | None = field(default=None, repr=False)
    #: The file itself, for a worker that cannot read `model`.
    content: bytes | None = field(default=None, repr=False)

    @property
    def name(self) -> str:
        """The path as rows show it."""
        return one_line(self.model)

    @property
    def key(self) -> tuple[str, str]:
        """What tells whether a row is already there."""
        return self.model_sha256, self.settings_sha256


def plan(
    models: Iterable[str],
    placement: Placement,
    fingerprint: Mapping[str, Any],
    own_settings: Callable[[Path], dict[str, Any] | None] = lambda _: None,
) -> list[Task]:
    """List the models that files, folders, globs and manifests name, in that order.

    Parameters
    ----------
    models
        Files; folders, searched through for `SUFFIXES`; glob patterns; manifests: ``.csv`` files
        with a column ``name`` (relative to the manifest) and, where they differ from `placement`,
        ``scale`` and ``up_axis``; ``-``: a manifest on stdin. A model that is named twice in one
        way counts once.
    placement
        What applies unless a manifest says otherwise.
    fingerprint
        What else the rows depend on, as values that JSON knows.
    own_settings
        Tells the settings of a model that brings its own, in place of the fingerprint's.

    Raises
    ------
    ModelError
        A folder or pattern holds no model, or a manifest cannot be understood.
    """
    found = dict.fromkeys(pair for name in models for pair in _named(name, placement))
    return [
        _task(index, path, placed, fingerprint, own_settings)
        for index, (path, placed) in enumerate(found)
    ]


def _named(name: str, placement: Placement) -> Iterator[tuple[Path, Placement]]:
    path = Path(name)
    if name == STREAM:
        yield from _manifest(streams.regular(streams.STDIN), Path(), placement)
    elif path.suffix.lower() == ".csv":
        yield from _manifest(streams.regular(path), path.parent, placement)
    elif path.is_dir():
        yield from _some(name, sorted(path.rglob("*")), placement)
    elif glob.has_magic(name) and not path.exists():
        yield from _some(name, sorted(map(Path, glob.glob(name, recursive=True))), placement)
    else:
        yield path, placement


def _some(
    name: str, paths: Sequence[Path], placement: Placement
) -> Iterator[tuple[Path, Placement]]:
    models = [path for path in paths if path.suffix.lower() in SUFFIXES and path.is_file()]
    if not models:
        msg = f"{name}: no models there; known are {', '.join(SUFFIXES)}"
        raise ModelError(msg)
    for path in models:
        yield path, placement


def _manifest(path: Path, folder: Path, placement: Placement) -> Iterator[tuple[Path, Placement]]:
    try:
        with path.open(encoding="utf-8-sig", newline="") as file:
            rows = csv.DictReader(file)
            if "name" not in (rows.fieldnames or ()):
                msg = f"{path}: a manifest has a column called name"
                raise ModelError(msg)
            for row in rows:
                place = f"{path}:{rows.line_num}"
                name = row["name"]
                if not name or "\0" in name:
                    raise ModelError(f"{place}: name is {name!r}; it must be that of a model")
                yield folder / name, _placed(place, row, placement)
    except (UnicodeDecodeError, csv.Error) as error:
        msg = f"{path}: not a CSV file in UTF-8: {error}"
        raise ModelError(msg) from error


def _placed(place: str, row: Mapping[str, str], placement: Placement) -> Placement:
    """Let the cells of a manifest's row that are not empty win."""
    values = asdict(placement)
    try:
        values["scale"] = float(row.get("scale") or placement.scale)
    except ValueError:
        msg = f"{place}: scale is {row['scale']!r}; it must be a number"
        raise SettingError(msg) from None
    values["up"] = (row.get("up_axis") or placement.up).lower()
    if values["up"] not in AXES:
        msg = f"{place}: up_axis is {row['up_axis']!r}; it must be one of {', '.join(AXES)}"
        raise SettingError(msg)
    return Placement(**values)


def _task(
    index: int,
    path: Path,
    placement: Placement,
    fingerprint: Mapping[str, Any],
    own_settings: Callable[[Path], dict[str, Any] | None],
) -> Task:
    size, sha256, settings, error = 0, "", None, None
    try:
        size, sha256 = _content(path)
        settings = own_settings(path)
    except OSError as failure:
        error = f"the file cannot be read: {failure.strerror}"
    except WireprintError as failure:
        error = str(failure).removeprefix(f"{path}: ")
    whole = {"version": __version__, "placement": asdict(placement), **fingerprint}
    if settings is not None:
        whole["settings"] = settings
    return Task(
        index=index,
        model=path.as_posix(),
        placement=placement,
        model_sha256=sha256,
        settings_sha256=hashlib.sha256(json.dumps(whole, sort_keys=True).encode()).hexdigest(),
        size_bytes=size,
        error=error,
        settings=settings,
    )


def _content(path: Path) -> tuple[int, str]:
    """Return size and hash of a file.

    Raises
    ------
    ModelError
        It is none, and may not end.
    """
    status = path.stat()
    if not stat.S_ISREG(status.st_mode) and not path.is_dir():
        msg = f"{path}: it is no file; save what comes from there as one first"
        raise ModelError(msg)
    with path.open("rb") as file:
        return status.st_size, hashlib.file_digest(file, "sha256").hexdigest()
