"""Rows by kind of shape, and what changed between two tables."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import PurePosixPath
from typing import TYPE_CHECKING, Final

from wireprint.bench.figures import column
from wireprint.bench.summary import distribution
from wireprint.comparison import CONDITIONS

if TYPE_CHECKING:
    from collections.abc import Callable, Iterable, Sequence

    from wireprint.bench.task import Row


@dataclass(frozen=True)
class Figure:
    """A column that is told about."""

    column: str
    title: str
    unit: str
    #: Whether more of it is better; None: neither is.
    more_is_better: bool | None
    decimals: int


#: What distributions and changes are told of, where a table has it.
FIGURES: Final = (
    Figure("coverage", "Covered surface", "", True, 3),
    Figure("deviation_mm", "Deviation", "mm", False, 2),
    Figure("print_time_s", "Print time", "s", False, 0),
    Figure("strand_mm", "Strand", "mm", None, 0),
    Figure("support_mm", "Supports", "mm", None, 0),
    Figure("compute_s", "Computing", "s", False, 2),
    *(
        Figure(column(name, "speedup"), f"Speed-up, {name}", "×", True, 2)
        for name in CONDITIONS
        if name != "layerwise-solid"
    ),
)
#: Changes by less than this part of the older value are none.
_SAME: Final = 1e-6


def by_kind(rows: Iterable[Row]) -> dict[str, list[Row]]:
    """Group rows by the folders of their models, told apart from where the paths part.

    Models in one and the same folder are of one kind, named by it.
    """
    listed = list(rows)
    folders = [PurePosixPath(row["model"]).parent for row in listed]
    shared = _shared(folders)
    groups: dict[str, list[Row]] = {}
    for row, folder in zip(listed, folders, strict=True):
        rest = folder.parts[shared:]
        groups.setdefault("/".join(rest) or folder.name or "all", []).append(row)
    return dict(sorted(groups.items()))


def _shared(folders: Sequence[PurePosixPath]) -> int:
    """Return how many parts all paths begin with alike."""
    ranks = list(zip(*(folder.parts for folder in folders), strict=False))
    return next((n for n, names in enumerate(ranks) if len(set(names)) > 1), len(ranks))


def spread(rows: Iterable[Row], figure: Figure) -> dict[str, float] | None:
    """Return how a figure is distributed; None where no row has it."""
    values = [row.get(figure.column) for row in rows]
    return distribution([float(value) for value in values if value is not None])


@dataclass(frozen=True)
class Change:
    """A figure of a model that is not what it was."""

    model: str
    before: float
    after: float

    @property
    def share(self) -> float:
        """By how much it grew, as a part of what it was; of nothing: as it is."""
        return (self.after - self.before) / (abs(self.before) or 1.0)

    @property
    def signed(self) -> str:
        """The same in percent, with its sign."""
        return f"{self.share:+.1%}"


@dataclass(frozen=True)
class Changes:
    """What two tables of the same models tell apart."""

    #: Models that both have.
    shared: int
    #: Models that only one has.
    gone: tuple[str, ...]
    new: tuple[str, ...]
    #: Models that are certified no more, and that are now; that fail now, and that no more do.
    lost: tuple[str, ...]
    won: tuple[str, ...]
    failing: tuple[str, ...]
    mended: tuple[str, ...]
    #: By column: what changed, the greatest change first.
    figures: dict[str, tuple[Change, ...]]


def changes(before: Sequence[Row], after: Sequence[Row]) -> Changes:
    """Compare two tables, model by model.

    A model is the same if its file and its placement are, whatever its name, and whatever settings
    or version made it.
    """
    old, new = _named(before), _named(after)
    both = [key for key in new if key in old]
    pairs = [(old[key], new[key]) for key in both]

    def where(test: Callable[[Row, Row], bool]) -> tuple[str, ...]:
        return tuple(b["model"] for a, b in pairs if test(a, b))

    return Changes(
        shared=len(both),
        gone=tuple(row["model"] for key, row in old.items() if key not in new),
        new=tuple(row["model"] for key, row in new.items() if key not in old),
        lost=where(lambda a, b: bool(a.get("certified")) and not b.get("certified")),
        won=where(lambda a, b: not a.get("certified") and bool(b.get("certified"))),
        failing=where(lambda a, b: not a.get("error") and bool(b.get("error"))),
        mended=where(lambda a, b: bool(a.get("error")) and not b.get("error")),
        figures={figure.column: _changed(pairs, figure) for figure in FIGURES},
    )


def _named(rows: Iterable[Row]) -> dict[tuple[object, ...], Row]:
    """Return rows by what model they are of; of several the newest counts."""
    return {
        (row.get("model_sha256") or row["model"], row.get("scale"), row.get("up")): row
        for row in rows
    }


def _changed(pairs: Iterable[tuple[Row, Row]], figure: Figure) -> tuple[Change, ...]:
    found = []
    for old, new in pairs:
        a, b = old.get(figure.column), new.get(figure.column)
        if a is not None and b is not None and abs(b - a) > _SAME * abs(a):
            found.append(Change(new["model"], float(a), float(b)))
    return tuple(sorted(found, key=lambda change: (-abs(change.share), change.model)))
