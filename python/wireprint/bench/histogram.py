"""A picture of how speed-ups are distributed."""

from __future__ import annotations

import io
import itertools
import math
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Final

from PIL import Image, ImageDraw, ImageFont, PngImagePlugin

if TYPE_CHECKING:
    from collections.abc import Sequence
    from pathlib import Path

WIDTH, HEIGHT = 900, 560
MARGIN: Final = 70
INK, FAINT, BAR, MARK = (40, 40, 40), (200, 200, 200), (40, 90, 200), (220, 60, 40)
#: Widths that a bin may have, and a power of ten times them.
_ROUND: Final = (1.0, 2.0, 2.5, 5.0, 10.0)
_MOST_BINS: Final = 40
_MOST_LABELS: Final = 12
#: What the file says that it was made with, and how far from its begin that may stand, bytes.
_SOFTWARE: Final = "wireprint bench"
_ABOUT_BYTES: Final = 256


def png(values: Sequence[float], title: str, axis: str) -> bytes:
    """Draw a histogram with the median marked.

    Parameters
    ----------
    values
        At least one, all finite.
    title, axis
        What is written above and below.

    Returns
    -------
    bytes
        A PNG of `WIDTH` by `HEIGHT` pixels.
    """
    edges, counts = bins(values)
    image = Image.new("RGB", (WIDTH, HEIGHT), "white")
    sheet = _Sheet(ImageDraw.Draw(image), edges[0], edges[-1], max(counts))
    sheet.grid()
    for (low, high), height in zip(itertools.pairwise(edges), counts, strict=True):
        sheet.bar(low, high, height)
    sheet.axis(edges)
    sheet.mark(quantile(values, 0.5))
    sheet.titles(title, axis)
    out = io.BytesIO()
    about = PngImagePlugin.PngInfo()
    about.add_text("Software", _SOFTWARE)
    image.save(out, "PNG", pnginfo=about)
    return out.getvalue()


def is_ours(path: Path) -> bool:
    """Whether a file is a histogram that was drawn here, which another one may replace."""
    with path.open("rb") as file:
        return f"tEXtSoftware\0{_SOFTWARE}".encode() in file.read(_ABOUT_BYTES)


@dataclass(frozen=True)
class _Sheet:
    """A drawing with the values from `low` to `high` across and counts up to `top` upwards."""

    draw: ImageDraw.ImageDraw
    low: float
    high: float
    top: int
    font: ImageFont.FreeTypeFont | ImageFont.ImageFont = field(
        default_factory=lambda: ImageFont.load_default(18)
    )

    def x(self, value: float) -> float:
        return MARGIN + (value - self.low) / (self.high - self.low) * (WIDTH - 2 * MARGIN)

    def y(self, count: float) -> float:
        return HEIGHT - MARGIN - count / self.top * (HEIGHT - 2 * MARGIN)

    def grid(self) -> None:
        for level in _levels(self.top):
            self.draw.line((MARGIN, self.y(level), WIDTH - MARGIN, self.y(level)), FAINT)
            place = (MARGIN - 10, self.y(level))
            self.draw.text(place, str(level), INK, self.font, anchor="rm")

    def bar(self, low: float, high: float, count: int) -> None:
        if count:
            self.draw.rectangle((self.x(low) + 1, self.y(count), self.x(high) - 1, self.y(0)), BAR)

    def axis(self, edges: Sequence[float]) -> None:
        for edge in edges[:: math.ceil(len(edges) / _MOST_LABELS)]:
            place = (self.x(edge), self.y(0) + 8)
            self.draw.text(place, f"{edge:.6g}", INK, self.font, anchor="ma")

    def mark(self, median: float) -> None:
        x, top = self.x(median), MARGIN - 12
        self.draw.line((x, self.y(0), x, top), MARK, 2)
        # The words stand on the side where there is more room.
        shift, anchor = (8, "lm") if x < WIDTH / 2 else (-8, "rm")
        self.draw.text((x + shift, top), f"median {median:.2f}", MARK, self.font, anchor=anchor)

    def titles(self, title: str, axis: str) -> None:
        large = ImageFont.load_default(22)
        self.draw.text((WIDTH / 2, 12), title, INK, large, anchor="ma")
        self.draw.text((WIDTH / 2, HEIGHT - 12), axis, INK, self.font, anchor="md")


def bins(values: Sequence[float]) -> tuple[list[float], list[int]]:
    """Return edges at round numbers, and how many values lie between each two of them.

    The width follows Freedman and Diaconis, 2·IQR/∛n, rounded up.
    """
    low, high = min(values), max(values)
    spread = quantile(values, 0.75) - quantile(values, 0.25)
    width = 2 * spread / len(values) ** (1 / 3)
    width = _rounded_up(max(width, (high - low) / _MOST_BINS, abs(high) / 1000) or 1.0)
    places = [math.floor(value / width) for value in values]
    first, last = min(places), max(places)
    edges = [index * width for index in range(first, last + 2)]
    return edges, [places.count(index) for index in range(first, last + 1)]


def quantile(values: Sequence[float], share: float) -> float:
    """Return a quantile by linear interpolation, as numpy's default and R's type 7 do."""
    ranked = sorted(values)
    place = share * (len(ranked) - 1)
    below = math.floor(place)
    above = min(below + 1, len(ranked) - 1)
    return ranked[below] + (place - below) * (ranked[above] - ranked[below])


def _levels(top: int) -> list[int]:
    """Return round whole numbers from 0 to `top`, few enough to be labelled."""
    return list(range(0, top + 1, max(1, math.ceil(_rounded_up(top / _MOST_LABELS)))))


def _rounded_up(value: float) -> float:
    power = 10.0 ** math.floor(math.log10(value))
    return next(step * power for step in _ROUND if step * power >= value * (1 - 1e-9))
