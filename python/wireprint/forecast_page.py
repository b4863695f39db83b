"""A forecast drawn, as a picture or a page that turns: strands in the colours of a figure."""

from __future__ import annotations

from dataclasses import dataclass
from itertools import pairwise
from typing import TYPE_CHECKING, Final

import numpy as np

from wireprint._core import Scene, Strands
from wireprint.forecast_scales import RULES, scale_of
from wireprint.forecast_words import sentences, unknown
from wireprint.view import BREACH_RADIUS_MM
from wireprint.view_camera import camera_angles
from wireprint.view_html import Page
from wireprint.view_styles import BREACH, WHITE, Entry

if TYPE_CHECKING:
    from wireprint.forecast import Forecast
    from wireprint.forecast_scales import Scale
    from wireprint.verdict import Point
    from wireprint.view_styles import Rgb

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


@dataclass(frozen=True)
class _Drawn:
    """Strands in the colours of a figure, and what is said of them."""

    strands: Strands
    entries: list[Entry]
    #: The figure, with its unit.
    coloured_by: str
    headline: str
    size_mm: list[float]
    #: The worst place by the figure's rule, mm, if there is one.
    marks: list[Point]

    @property
    def colours(self) -> list[Rgb]:
        """Colour of each kind of strand."""
        return [entry.colour for entry in self.entries]

    def scene(self) -> Scene:
        """Return what is drawn as solids."""
        scene = Scene(floor=True)
        scene.add_strands(self.strands, self.colours)
        return scene


def page(forecast: Forecast, figure: str, title: str) -> bytes:
    """Draw strands in the colours of a figure, as a page that turns.

    Parameters
    ----------
    forecast
        What is drawn.
    figure
        ``sag``, ``compliance``, ``flow`` or ``weld``.
    title
        Headline.
    """
    drawn, angles = _drawn(forecast, figure, title), camera_angles("iso")
    still = drawn.scene().png(_STILL_PX, angles, supersample=2, margins=(8.0,) * 4, ground=WHITE)
    sheet = Page(drawn.headline, drawn.size_mm, angles[:2], still)
    sheet.add_marks(drawn.marks, "worst")
    sheet.add_words(
        f"A forecast in words: {forecast.trust}, a model and no part of the certificate",
        {
            "What it says": sentences(forecast),
            "What this forecast does not know": unknown(forecast.judge.settings),
        },
    )
    sheet.add_strands(
        drawn.strands,
        drawn.colours,
        drawn.entries,
        travels=False,
        gcode=None,
        coloured_by=drawn.coloured_by,
    )
    return sheet.text().encode()


def picture(
    forecast: Forecast,
    figure: str,
    title: str,
    size: tuple[int, int] = (1600, 1200),
    camera: str = "iso",
) -> bytes:
    """Draw strands in the colours of a figure, as a PNG file; see `page` and `view.render_png`."""
    from wireprint.view_legend import Sheet

    drawn, angles = _drawn(forecast, figure, title), camera_angles(camera)
    scene, entries = drawn.scene(), list(drawn.entries)
    if drawn.marks:
        scene.add_marks(drawn.marks, BREACH, BREACH_RADIUS_MM)
        entries.append(Entry("worst", "worst", BREACH))
    width, depth, height = drawn.size_mm
    sheet = Sheet(size, drawn.headline, f"{width:.1f} x {depth:.1f} x {height:.1f} mm", entries)
    rgba, px_per_mm = scene.render(size, angles, supersample=2, margins=sheet.margins, ground=WHITE)
    return sheet.png(rgba, px_per_mm)


def _drawn(forecast: Forecast, figure: str, title: str) -> _Drawn:
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
    strand_mm = forecast.judge.settings.strand_mm
    strands = Strands.from_arrays(ends, kinds.astype(np.uint16), names, strand_mm)
    size_mm = np.ptp(ends.reshape(-1, 3), axis=0).tolist() if len(ends) else [0.0] * 3
    place = forecast.rules[RULES[figure]].place_mm
    headline = f"{title}: {scale.name}, {forecast.trust}"
    return _Drawn(strands, entries, scale.name, headline, size_mm, [] if place is None else [place])


def _names(scale: Scale) -> list[str]:
    edges, unit = [scale.written(edge) for edge in scale.edges], scale.unit
    between = [f"{low} to {high} {unit}" for low, high in pairwise(edges)]
    return [f"up to {edges[0]} {unit}", *between, f"more than {edges[-1]} {unit}"]
