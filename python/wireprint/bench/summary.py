"""What the rows of a run amount to."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from wireprint.bench.figures import column
from wireprint.bench.histogram import quantile
from wireprint.comparison import CONDITIONS, HYBRID

if TYPE_CHECKING:
    from collections.abc import Sequence

    from wireprint.bench.task import Row


def summary(rows: Sequence[Row]) -> dict[str, Any]:
    """Summarise rows under the keys of ``wireprint bench --json``.

    Failed models count as such and enter a distribution only with the cells that they have.
    """
    conditions = (*CONDITIONS, HYBRID)
    speedups = {name: distribution(speedups_of(rows, name)) for name in conditions}
    return {
        "models": len(rows),
        "failed": sum(bool(row.get("error")) for row in rows),
        "certified": sum(row.get("certified") is True for row in rows),
        "speedup": {name: found for name, found in speedups.items() if found is not None},
        "coverage": distribution(_values(rows, "coverage")),
        "deviation_mm": distribution(_values(rows, "deviation_mm")),
        "compute_s": distribution(_values(rows, "compute_s")),
        "failures": [
            {"model": row["model"], "error": row["error"]} for row in rows if row.get("error")
        ],
    }


def speedups_of(rows: Sequence[Row], condition: str) -> list[float]:
    """Return the speed-ups of one condition, of all models that have one."""
    return _values(rows, column(condition, "speedup"))


def distribution(values: Sequence[float]) -> dict[str, float] | None:
    """Return quartiles, median and extremes; None for no values."""
    if not values:
        return None
    return {
        "min": min(values),
        "lower_quartile": quantile(values, 0.25),
        "median": quantile(values, 0.5),
        "upper_quartile": quantile(values, 0.75),
        "max": max(values),
    }


def _values(rows: Sequence[Row], column: str) -> list[float]:
    return [row[column] for row in rows if row.get(column) is not None]
