"""The figures of a forecast that strands are coloured by, each with where it becomes too much."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Final

if TYPE_CHECKING:
    import numpy as np
    import numpy.typing as npt

    from wireprint.forecast import Forecast, Name

    Array = npt.NDArray[np.float64]

#: Figure → the rule that it is judged by.
RULES: Final[dict[str, Name]] = {
    "sag": "sags",
    "compliance": "meets",
    "flow": "flows",
    "weld": "welds",
}
#: Where one colour ends and the next begins, in shares of a figure's limit.
_SHARES: Final = (0.25, 0.5, 1.0, 2.0)
#: The same of a weld, which has no limit: in hundredths of a whole one.
_MISSING: Final = (20.0, 40.0, 60.0, 80.0)
_PERCENT: Final = 100.0


@dataclass(frozen=True)
class Scale:
    """A figure of strands, and where one colour ends and the next begins, the worse later."""

    values: Array
    edges: tuple[float, ...]
    #: What it is, and in what its amounts are.
    quantity: str
    unit: str

    @property
    def name(self) -> str:
        """What it is, with its unit."""
        return f"{self.quantity}, {self.unit}"

    def written(self, amount: float) -> str:
        """Return an amount in two digits, without its unit."""
        return f"{float(f'{amount:.2g}'):g}"


def scale_of(forecast: Forecast, figure: str) -> Scale:
    """Return a figure, of `RULES`, in shares of its limit: a quarter, a half, the whole, twice it.

    Parameters
    ----------
    forecast
        What it is of.
    figure
        Which.
    """
    settings = forecast.judge.settings
    strand = settings.strand_mm
    if figure == "sag":
        return Scale(forecast.sag_mm, _edges(strand), "sag", "mm")
    if figure == "compliance":
        limit = strand / 2 / settings.wire.pull_n
        return Scale(forecast.compliance_mm_n, _edges(limit), "gives way", "mm/N")
    if figure == "flow":
        limit = forecast.rules["flows"].limit or 0.0
        off = _PERCENT * abs(forecast.flow_share - 1)
        return Scale(off, _edges(_PERCENT * limit), "off its material", "%")
    return Scale(_PERCENT * (1 - forecast.weld), _MISSING, "missing to a weld", "%")


def _edges(limit: float) -> tuple[float, ...]:
    return tuple(share * limit for share in _SHARES)
