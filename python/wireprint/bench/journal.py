"""The rows of a run that is not finished, each on disk before the next is made."""

from __future__ import annotations

import json
import os
from typing import TYPE_CHECKING, Any, Final

from wireprint._core import SettingError
from wireprint.files import OutputError

if TYPE_CHECKING:
    from collections.abc import Callable
    from pathlib import Path
    from typing import IO

    from wireprint.bench.task import Row

#: How every row begins; what does so and is no JSON was torn when a run was killed.
_BEGIN: Final = '{"model": '


class Journal:
    """A file with a row of JSON on each line.

    Parameters
    ----------
    path
        The file. It is made with the first row, so that a run without one leaves nothing.
    is_row
        Whether what a line says is a row.
    """

    def __init__(self, path: Path, is_row: Callable[[Any], bool]) -> None:
        self._path = path
        self._is_row = is_row
        self._file: IO[str] | None = None

    def rows(self) -> list[Row]:
        """Read the rows of a run that was stopped; one that is torn is left out.

        Raises
        ------
        SettingError
            The file is no journal.
        """
        if not self._path.exists():
            return []
        text = self._path.read_text(encoding="utf-8", errors="replace")
        lines = enumerate(text.splitlines(), start=1)
        found = [self._row(number, line) for number, line in lines if line.strip()]
        return [row for row in found if row is not None]

    def _row(self, number: int, line: str) -> Row | None:
        row: Any = None
        try:
            row = json.loads(line)
        except (ValueError, RecursionError):
            if line.startswith(_BEGIN) or _BEGIN.startswith(line):
                return None
        if self._is_row(row):
            found: Row = row
            return found
        msg = f"{self._path}:{number}: this is no row of a run that was stopped; move the file away"
        raise SettingError(msg)

    def add(self, row: Row) -> None:
        """Write a row, and see it on disk.

        Raises
        ------
        OutputError
            It cannot be written.
        """
        try:
            if self._file is None:
                # What a killed run left unfinished must not join the first row of this one.
                torn = self._path.exists()
                self._file = self._path.open("a", encoding="utf-8")
                self._file.write("\n" if torn else "")
            self._file.write(json.dumps(row) + "\n")
            self._file.flush()
            os.fsync(self._file.fileno())
        except OSError as error:
            raise OutputError(f"{self._path}: {error.strerror or error}") from None

    def close(self) -> None:
        """Close the file; it stays."""
        if self._file is not None:
            self._file.close()
            self._file = None

    def remove(self) -> None:
        """Take the file away: its rows are in the table."""
        self._path.unlink(missing_ok=True)
