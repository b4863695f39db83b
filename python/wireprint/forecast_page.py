"""A forecast as a page that turns in a browser: strands in the colours of a figure."""

from __future__ import annotations

from dataclasses import dataclass
from itertools import pairwise
from typing import TYPE_CHECKING, Final, cast

import numpy as np

from wireprint.view import camera_angles
from wireprint.view_html import Page
from wireprint.view_styles import Entry

if TYPE_CHECKING:
    import numpy.typing as npt

    from wireprint._core import Strands
    from wireprint.forecast import Forecast
    from wireprint.view_styles import Rgb

    Array = npt.NDArray[np.float64]

#: From what is well to what is not, and last what has no figure. ColorBrewer's RdYlBu, reversed,
#: which those who do not see red from green tell apart.
_COLOURS: Final[tuple[Rgb, ...]] = (
    (69, 117, 180),
    (145, 191, 219),
    (254, 224, 144),
    (252, 141, 89),
    (215, 48, 39),
)
_NONE: Final[Rgb] = (205, 205, 205)


@dataclass(frozen=True)
class _Scale:
    """A figure of strands, and where one colour ends and the next begins, the worse later."""

    values: Array
    edges: tuple[float, ...]
    name: str


@dataclass(frozen=True)
class _Coloured:
    """Strands as the page takes them, a label for each colour."""

    segments: Array
    features: npt.NDArray[np.int64]
    labels: tuple[str, ...]
    diameters: Array


def page(forecast: Forecast, figure: str, title: str) -> bytes:
    """Draw strands in the colours of a figure.

    Parameters
    ----------
    forecast
        What is drawn.
    figure
        ``sag``, ``compliance``, ``flow`` or ``weld``.
    title
        Headline.
    """
    settings = forecast.judge.settings
    scale = _scale(forecast, figure)
    kinds = np.searchsorted(scale.edges, np.nan_to_num(scale.values), side="left")
    kinds[np.isnan(scale.values)] = len(_COLOURS)
    ends = forecast.ends_mm
    lengths = np.linalg.norm(ends[:, 1] - ends[:, 0], axis=1)
    names = [*_names(scale), f"no {figure}"]
    entries = [
        Entry(name, name, colour, float(lengths[kinds == kind].sum()))
        for kind, (name, colour) in enumerate(zip(names, (*_COLOURS, _NONE), strict=True))
    ]
    diameters = np.full(len(ends), settings.strand_mm)
    drawn = _Coloured(ends, kinds, tuple(names), diameters)
    sheet = Page(f"{title}: {scale.name}, {forecast.trust}", _size(ends), camera_angles("iso")[:2])
    # Without travels, the page asks for no more than these.
    sheet.add_strands(cast("Strands", drawn), [entry.colour for entry in entries], entries, None)
    worst = {"sag": "sags", "compliance": "meets", "flow": "flows", "weld": "welds"}[figure]
    place = forecast.rules[worst].place_mm
    sheet.add_marks([] if place is None else [place])
    return sheet.text().encode()


def _scale(forecast: Forecast, figure: str) -> _Scale:
    """Return a figure in shares of its limit: a quarter, a half, the whole and twice of it."""
    settings = forecast.judge.settings
    strand = settings.strand_mm
    shares = (0.25, 0.5, 1.0, 2.0)
    if figure == "sag":
        edges = tuple(share * strand for share in shares)
        return _Scale(forecast.sag_mm, edges, "sag, mm")
    if figure == "compliance":
        limit = strand / 2 / settings.wire.pull_n
        edges = tuple(share * limit for share in shares)
        return _Scale(forecast.compliance_mm_n, edges, "gives way, mm/N")
    if figure == "flow":
        limit = forecast.rules["flows"].limit or 0.0
        edges = tuple(share * limit for share in shares)
        return _Scale(abs(forecast.flow_share - 1), edges, "off its material, share")
    return _Scale(1 - forecast.weld, (0.2, 0.4, 0.6, 0.8), "missing to a weld, share")


def _names(scale: _Scale) -> list[str]:
    edges = [f"{edge:.2g}" for edge in scale.edges]
    between = [f"{low} to {high}" for low, high in pairwise(edges)]
    return [f"up to {edges[0]}", *between, f"more than {edges[-1]}"]


def _size(ends: Array) -> str:
    if not len(ends):
        return ""
    points = ends.reshape(-1, 3)
    x, y, z = np.ptp(points, axis=0)
    return f"{x:.1f} × {y:.1f} × {z:.1f} mm"
