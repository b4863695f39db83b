"""A forecast as a page that turns in a browser: strands in the colours of a figure."""

from __future__ import annotations

from itertools import pairwise
from typing import TYPE_CHECKING, Final

import numpy as np

from wireprint._core import Scene, Strands
from wireprint.forecast_scales import RULES, scale_of
from wireprint.view import camera_angles
from wireprint.view_html import Page
from wireprint.view_styles import WHITE, Entry

if TYPE_CHECKING:
    import numpy.typing as npt

    from wireprint.forecast import Forecast
    from wireprint.forecast_scales import Scale
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
#: Of the picture that is shown until the page turns.
_STILL_PX: Final = (640, 480)


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
    scale = scale_of(forecast, figure)
    kinds = np.searchsorted(scale.edges, np.nan_to_num(scale.values), side="left")
    kinds[np.isnan(scale.values)] = len(_COLOURS)
    ends = forecast.ends_mm
    lengths = np.linalg.norm(ends[:, 1] - ends[:, 0], axis=1)
    names = [*_names(scale), f"no {figure}"]
    entries = [
        Entry(name, name, colour, float(lengths[kinds == kind].sum()))
        for kind, (name, colour) in enumerate(zip(names, (*_COLOURS, _NONE), strict=True))
    ]
    drawn = Strands.from_arrays(ends, kinds.astype(np.uint16), names, settings.strand_mm)
    colours = [entry.colour for entry in entries]
    size_mm = np.ptp(ends.reshape(-1, 3), axis=0).tolist() if len(ends) else [0.0] * 3
    angles, headline = camera_angles("iso"), f"{title}: {scale.name}, {forecast.trust}"
    sheet = Page(headline, size_mm, angles[:2], _still(drawn, colours, angles))
    place = forecast.rules[RULES[figure]].place_mm
    sheet.add_marks([] if place is None else [place])
    sheet.add_strands(drawn, colours, entries, travels=False, gcode=None)
    return sheet.text().encode()


def _still(drawn: Strands, colours: list[Rgb], angles: tuple[float, float, float]) -> bytes:
    scene = Scene(floor=True)
    scene.add_strands(drawn, colours)
    return scene.png(_STILL_PX, angles, supersample=2, margins=(8.0,) * 4, ground=WHITE)


def _names(scale: Scale) -> list[str]:
    edges = [f"{edge:.2g}" for edge in scale.edges]
    between = [f"{low} to {high}" for low, high in pairwise(edges)]
    return [f"up to {edges[0]}", *between, f"more than {edges[-1]}"]
