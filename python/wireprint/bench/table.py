"""The table of results: one row a model, kept so that nothing done is lost or done twice."""

from __future__ import annotations

import csv
import io
import json
import os
from typing import TYPE_CHECKING, Any, Final

from wireprint._core import SettingError
from wireprint.bench.figures import column
from wireprint.comparison import CONDITIONS, HYBRID
from wireprint.files import written_whole

if TYPE_CHECKING:
    from collections.abc import Mapping, Sequence
    from pathlib import Path
    from typing import IO, Self

    from wireprint.bench.plan import Task
    from wireprint.bench.task import Row

_FIGURES: Final = ("time_s", "filament_mm", "filament_g", "speedup", "compute_s")
#: Columns in their order, with their types; a cell without a value is empty, or null in Parquet.
COLUMNS: Final[dict[str, type]] = {
    "model": str,
    "model_sha256": str,
    "settings_sha256": str,
    "scale": float,
    "up": str,
    "turned_deg": str,
    "error": str,
    "triangles": int,
    "size_x_mm": float,
    "size_y_mm": float,
    "size_z_mm": float,
    "certified": bool,
    "collisions": int,
    "floating_starts": int,
    "dangling_ends": int,
    "spans_over": int,
    "out_of_bounds": int,
    "coverage": float,
    "deviation_mm": float,
    "chord_deviation_mm": float,
    "unprinted_parts": int,
    "unprinted_mm2": float,
    "print_time_s": float,
    "strand_mm": float,
    "support_mm": float,
    "filament_g": float,
    "plan_s": float,
    "compute_s": float,
} | {column(condition, figure): float for condition in CONDITIONS for figure in _FIGURES}
#: Further columns, where a model is marked.
MARKED_COLUMNS: Final[dict[str, type]] = {column(HYBRID, figure): float for figure in _FIGURES}
SUFFIXES: Final = (".csv", ".parquet")


class Table:
    """The file of results while it grows.

    Each row is added to a journal beside the file at once, and on disk before the next one; the
    file itself is written whole in the end. So a run may be killed at any moment, in either
    format, and the next one goes on where it stopped.
    """

    def __init__(self, path: Path) -> None:
        if path.suffix.lower() not in SUFFIXES:
            msg = f"{path}: results are written as {' or '.join(SUFFIXES)}"
            raise SettingError(msg)
        if path.suffix.lower() == ".parquet":
            _pyarrow()
        self._path = path
        self._journal = path.with_name(f"{path.name}.journal")
        self._rows = {_key(row): row for row in [*_read(path), *_journalled(self._journal)]}
        self._by_content = {key[:2]: row for key, row in self._rows.items() if key[0]}
        self._file: IO[str] | None = None

    def __enter__(self) -> Self:
        """Open the journal."""
        self._file = self._journal.open("a", encoding="utf-8")
        # What a killed run left unfinished must not join the first row of this one.
        self._file.write("\n")
        return self

    def __exit__(self, *_: object) -> None:
        """Close the journal; it stays until `finish`."""
        if self._file is not None:
            self._file.close()

    def row_of(self, task: Task) -> Row | None:
        """Return a row that is already there, under the model's present name."""
        row = self._by_content.get(task.key)
        return None if row is None else row | {"model": task.model}

    def add(self, row: Row) -> None:
        """Keep a row, even if the machine stops now."""
        if self._file is None:
            raise ValueError("the table is not open")
        self._file.write(json.dumps(row) + "\n")
        self._file.flush()
        os.fsync(self._file.fileno())

    def finish(self, rows: Sequence[Row]) -> None:
        """Write the rows of a run, in its order, after older ones of other models or settings."""
        ours = {_key(row) for row in rows}
        others = [row for key, row in self._rows.items() if key not in ours]
        written_whole(self._path, _encoded(self._path, [*others, *rows]))
        self._journal.unlink(missing_ok=True)


def _key(row: Row) -> tuple[str, str, str]:
    """Tell rows apart: files that could not be read have no hash, but a name."""
    return row["model_sha256"] or "", row["settings_sha256"], row["model"]


def _journalled(path: Path) -> list[Row]:
    """Read the rows of a run that was stopped; the last one may be torn."""
    rows: list[Row] = []
    if path.exists():
        for line in path.read_text(encoding="utf-8", errors="replace").splitlines():
            try:
                rows.append(json.loads(line))
            except json.JSONDecodeError:
                continue
    return rows


def _read(path: Path) -> list[Row]:
    if not path.exists():
        return []
    if path.suffix.lower() == ".parquet":
        import pyarrow.parquet

        rows: list[Row] = pyarrow.parquet.read_table(path).to_pylist()
    else:
        with path.open(encoding="utf-8", newline="") as file:
            rows = [_typed(row) for row in csv.DictReader(file)]
    if rows and not {"model", "model_sha256", "settings_sha256"} <= rows[0].keys():
        msg = f"{path}: it holds something else than results; name another file"
        raise SettingError(msg)
    return rows


def _typed(cells: Mapping[str, str]) -> Row:
    kinds = COLUMNS | MARKED_COLUMNS
    return {name: _value(kinds.get(name, str), text) for name, text in cells.items()}


def _value(kind: type, text: str) -> Any:
    if text == "":
        return None
    return text == "True" if kind is bool else kind(text)


def _encoded(path: Path, rows: Sequence[Row]) -> bytes:
    marked = any(row.get(name) is not None for row in rows for name in MARKED_COLUMNS)
    columns = COLUMNS | MARKED_COLUMNS if marked else COLUMNS
    whole = [{name: row.get(name) for name in columns} for row in rows]
    if path.suffix.lower() == ".parquet":
        return _parquet(columns, whole)
    text = io.StringIO(newline="")
    writer = csv.DictWriter(text, list(columns), lineterminator="\n")
    writer.writeheader()
    writer.writerows(whole)
    return text.getvalue().encode()


def _parquet(columns: Mapping[str, type], rows: list[Row]) -> bytes:
    pyarrow = _pyarrow()
    types = {
        str: pyarrow.string(),
        int: pyarrow.int64(),
        float: pyarrow.float64(),
        bool: pyarrow.bool_(),
    }
    schema = pyarrow.schema([(name, types[kind]) for name, kind in columns.items()])
    sink = pyarrow.BufferOutputStream()
    pyarrow.parquet.write_table(pyarrow.Table.from_pylist(rows, schema), sink)
    return bytes(sink.getvalue())


def _pyarrow() -> Any:
    try:
        import pyarrow
        import pyarrow.parquet
    except ImportError as error:
        msg = "Parquet needs pyarrow: pip install 'wireprint[bench]', or write a .csv file"
        raise SettingError(msg) from error
    return pyarrow
