"""The table of results: one row a model, kept so that nothing done is lost or done twice."""

from __future__ import annotations

import csv
import io
from typing import TYPE_CHECKING, Any, Final

from wireprint._core import SettingError
from wireprint.bench import journal
from wireprint.bench.figures import column
from wireprint.comparison import CONDITIONS, HYBRID
from wireprint.files import to_stdout, written_whole

if TYPE_CHECKING:
    from collections.abc import Iterable, Mapping, Sequence
    from pathlib import Path
    from typing import Self

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
    "version": str,
    "printer": str,
    "material": str,
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
    "underfed": int,
    "hurried": int,
    "cold": int,
    "unhomed": int,
    "unjudged": int,
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
#: Without these a table is none of ours.
_KEY_COLUMNS: Final = ("model", "model_sha256", "settings_sha256")
#: No row is without these; a file that could not be read has no hash.
_NEEDED: Final = ("model", "settings_sha256")
#: Spreadsheets compute a cell that begins so, unless it is quoted (OWASP, "CSV injection"); what
#: begins with the quote itself needs one more, lest it lose its own.
_QUOTE: Final = "'"
_COMPUTED: Final = ("=", "+", "-", "@", "\t", "\r", _QUOTE)


class Table:
    """The file of results while it grows.

    Each row is added to a journal beside the file at once, and on disk before the next one; the
    file itself is written whole in the end. So a run may be killed at any moment, in either
    format, and the next one goes on where it stopped.

    Parameters
    ----------
    path
        The file; None: the table is written to stdout as CSV, and nothing is kept meanwhile.

    Raises
    ------
    SettingError
        Its suffix is none of `SUFFIXES`, or it or its journal holds something else than results.
    """

    def __init__(self, path: Path | None) -> None:
        self._path = path
        self._journal: journal.Journal | None = None
        rows: list[Row] = []
        if path is not None:
            if path.suffix.lower() not in SUFFIXES:
                msg = f"{path}: results are written as {' or '.join(SUFFIXES)}"
                raise SettingError(msg)
            self._journal = journal.Journal(path.with_name(f"{path.name}.journal"), _is_row)
            rows = [*_read(path), *self._journal.rows()]
        self._rows = {_key(row): row for row in rows}
        self._by_content = {key[:2]: row for key, row in self._rows.items() if key[0]}

    @property
    def rows(self) -> list[Row]:
        """All rows that are there already."""
        return list(self._rows.values())

    def __enter__(self) -> Self:
        """Begin a run."""
        return self

    def __exit__(self, *_: object) -> None:
        """Close the journal; it stays until `finish`."""
        if self._journal is not None:
            self._journal.close()

    def row_of(self, task: Task) -> Row | None:
        """Return a row that is already there, under the model's present name."""
        row = self._by_content.get(task.key)
        return None if row is None else row | {"model": task.name}

    def add(self, row: Row) -> None:
        """Keep a row, even if the machine stops now."""
        if self._journal is not None:
            self._journal.add(row)

    def finish(self, rows: Sequence[Row]) -> None:
        """Write the rows of a run, in its order, after older ones of other models or settings."""
        if self._path is None:
            to_stdout(_csv(rows))
            return
        ours = {_key(row) for row in rows}
        others = [row for key, row in self._rows.items() if key not in ours]
        written_whole(self._path, _encoded(self._path, [*others, *rows]))
        if self._journal is not None:
            self._journal.remove()


def rows_of(path: Path) -> list[Row]:
    """Read a table, with what its run has added since.

    Raises
    ------
    SettingError
        There is none, or it holds something else than results.
    """
    table = Table(path)
    if not table.rows:
        raise SettingError(f"{path}: there are no results in it")
    return table.rows


def _key(row: Row) -> tuple[str, str, str]:
    """Tell rows apart: files that could not be read have no hash, but a name."""
    return row["model_sha256"] or "", row["settings_sha256"], row["model"]


def _read(path: Path) -> list[Row]:
    """Read the rows of a table; what is no table of ours is refused, lest it be overwritten."""
    if not path.exists():
        return []
    try:
        if path.suffix.lower() == ".parquet":
            return _read_parquet(path)
        with path.open(encoding="utf-8", newline="") as file:
            reader = csv.DictReader(file, strict=True)
            if reader.fieldnames is not None:
                _check_columns(path, reader.fieldnames)
            return [_typed(f"{path}:{reader.line_num}", row) for row in reader]
    except (UnicodeDecodeError, csv.Error):
        raise _no_table(path) from None


def _check_columns(path: Path, names: Iterable[str]) -> None:
    if not set(_KEY_COLUMNS) <= set(names):
        raise _no_table(path)


def _no_table(path: Path) -> SettingError:
    return SettingError(f"{path}: it holds something else than results; name another file")


def _is_row(row: Any) -> bool:
    """Whether something is a row of results, each column of its type."""
    if not isinstance(row, dict) or any(row.get(name) is None for name in _NEEDED):
        return False
    kinds = COLUMNS | MARKED_COLUMNS
    return all(value is None or _is_of(kinds.get(name, str), value) for name, value in row.items())


def _is_of(kind: type, value: object) -> bool:
    """Whether a value is of a column's type; a whole number may stand for any."""
    is_whole = isinstance(value, int) and not isinstance(value, bool)
    return is_whole if kind is int else isinstance(value, kind) or (kind is float and is_whole)


def _typed(place: str, cells: Mapping[str | None, Any]) -> Row:
    """Return a row of a CSV file with its values."""
    kinds = COLUMNS | MARKED_COLUMNS
    try:
        row = {name: _value(kinds.get(name or "", str), text) for name, text in cells.items()}
    except (ValueError, TypeError, AttributeError):
        row = {}
    if None in row or any(row.get(name) is None for name in _NEEDED):
        msg = f"{place}: this row is damaged; mend it, or name another file"
        raise SettingError(msg)
    return {name: value for name, value in row.items() if name is not None}


def _value(kind: type, text: str) -> Any:
    if text == "":
        return None
    if kind is bool:
        return {"True": True, "False": False}[text]
    return text.removeprefix(_QUOTE) if kind is str else kind(text)


def _cell(value: Any) -> Any:
    """Return a value as a spreadsheet takes it: a text that it would compute is quoted."""
    if isinstance(value, str) and value.startswith(_COMPUTED):
        return _QUOTE + value
    return value


def _encoded(path: Path, rows: Sequence[Row]) -> bytes:
    return _parquet(rows) if path.suffix.lower() == ".parquet" else _csv(rows)


def _columns(rows: Sequence[Row]) -> dict[str, type]:
    """Return the columns that some rows have."""
    marked = any(row.get(name) is not None for row in rows for name in MARKED_COLUMNS)
    return COLUMNS | MARKED_COLUMNS if marked else COLUMNS


def _csv(rows: Sequence[Row]) -> bytes:
    text = io.StringIO(newline="")
    columns = _columns(rows)
    writer = csv.writer(text, lineterminator="\n")
    writer.writerow(columns)
    writer.writerows([_cell(row.get(name)) for name in columns] for row in rows)
    return text.getvalue().encode()


def _read_parquet(path: Path) -> list[Row]:
    pyarrow = _pyarrow()
    try:
        table = pyarrow.parquet.read_table(path)
    except pyarrow.ArrowException:
        raise _no_table(path) from None
    _check_columns(path, table.column_names)
    rows: list[Row] = table.to_pylist()
    if not all(map(_is_row, rows)):
        raise _no_table(path)
    return rows


def _parquet(rows: Sequence[Row]) -> bytes:
    pyarrow = _pyarrow()
    columns = _columns(rows)
    whole = [{name: row.get(name) for name in columns} for row in rows]
    types = {
        str: pyarrow.string(),
        int: pyarrow.int64(),
        float: pyarrow.float64(),
        bool: pyarrow.bool_(),
    }
    schema = pyarrow.schema([(name, types[kind]) for name, kind in columns.items()])
    sink = pyarrow.BufferOutputStream()
    pyarrow.parquet.write_table(pyarrow.Table.from_pylist(whole, schema), sink)
    return bytes(sink.getvalue())


def _pyarrow() -> Any:
    try:
        import pyarrow
        import pyarrow.parquet
    except ImportError as error:
        msg = "Parquet needs pyarrow: pip install 'wireprint[bench]', or write a .csv file"
        raise SettingError(msg) from error
    return pyarrow
