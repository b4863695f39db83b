"""The legend of a picture: names, colours, lengths, size and a scale bar, drawn with Pillow."""

from __future__ import annotations

import io
import math
from typing import TYPE_CHECKING, Final

from PIL import Image, ImageDraw, ImageFont

if TYPE_CHECKING:
    from collections.abc import Sequence

    from wireprint.view_styles import Entry

INK: Final = (38, 44, 52)
FAINT: Final = (112, 120, 130)
#: A line of text per this much of the picture's shorter side.
LINES_PER_SIDE: Final = 46
LEAST_FONT_PX: Final = 10
#: The scale bar is the longest round length up to this share of the picture's width.
BAR_SHARE: Final = 0.16


class Sheet:
    """The margins of a picture, and what is written on them.

    Parameters
    ----------
    size
        Width and height of the picture, pixels.
    title
        First line; may be empty.
    size_text
        Size of the object.
    entries
        Lines of the legend.
    """

    def __init__(
        self, size: tuple[int, int], title: str, size_text: str, entries: Sequence[Entry]
    ) -> None:
        self.size = size
        self.title = title
        self.size_text = size_text
        self.entries = entries
        self.em = max(LEAST_FONT_PX, round(min(size) / LINES_PER_SIDE))
        self.font = ImageFont.load_default(self.em)
        # A long title is written smaller, so that all of it is there.
        large = ImageFont.load_default(self.em * 1.25)
        room = size[0] - 2.0 * self.em
        share = min(1.0, room / max(large.getlength(title), 1.0))
        self.title_font = ImageFont.load_default(max(self.em * 1.25 * share, LEAST_FONT_PX / 2))
        self.line = round(self.em * 1.6)
        self.gap = self.em

    @property
    def margins(self) -> tuple[float, float, float, float]:
        """Room to keep at the left, top, right and bottom, pixels."""
        left = self.gap + self._legend_width() + self.gap if self.entries else 2 * self.gap
        above = 0 if self.entries else self._head_height()
        return (left, above + 2.0 * self.gap, 2.0 * self.gap, self.line + 2.0 * self.gap)

    def png(self, rgba: bytes, px_per_mm: float) -> bytes:
        """Write on a rendered picture and encode it.

        Parameters
        ----------
        rgba
            The picture, four bytes a pixel.
        px_per_mm
            Its scale, for the bar.

        Returns
        -------
        bytes
            The PNG file.
        """
        image = Image.frombuffer("RGBA", self.size, rgba, "raw", "RGBA", 0, 1).convert("RGB")
        draw = ImageDraw.Draw(image)
        self._draw_head(draw)
        self._draw_entries(draw)
        self._draw_bar(draw, px_per_mm)
        out = io.BytesIO()
        image.save(out, "PNG", compress_level=4)
        return out.getvalue()

    def _head_height(self) -> int:
        return self.gap + self.line * (2 if self.title else 1)

    def _draw_head(self, draw: ImageDraw.ImageDraw) -> None:
        y = self.gap
        if self.title:
            draw.text((self.gap, y), self.title, INK, self.title_font)
            y += self.line
        draw.text((self.gap, y), self.size_text, FAINT, self.font)

    def _columns(self) -> tuple[float, float]:
        """Width of the legend's names and lengths."""
        names = max((self.font.getlength(entry.name) for entry in self.entries), default=0.0)
        lengths = (self.font.getlength(entry.amount) for entry in self.entries)
        return names, max(lengths, default=0.0)

    def _legend_width(self) -> float:
        names, lengths = self._columns()
        return 3.0 * self.em + names + self.em + lengths

    def _draw_entries(self, draw: ImageDraw.ImageDraw) -> None:
        names, lengths = self._columns()
        text_x = self.gap + 3.0 * self.em
        right = text_x + names + self.em + lengths
        y = self._head_height() + self.gap
        for entry in self.entries:
            middle = y + self.line / 2
            thick = self.em * 0.22
            bar = (self.gap, middle - thick, self.gap + 2.2 * self.em, middle + thick)
            draw.rounded_rectangle(bar, thick, entry.colour)
            draw.text((text_x, middle), entry.name, INK, self.font, anchor="lm")
            draw.text((right, middle), entry.amount, FAINT, self.font, anchor="rm")
            y += self.line

    def _draw_bar(self, draw: ImageDraw.ImageDraw, px_per_mm: float) -> None:
        millimetres = round_length(self.size[0] * BAR_SHARE / px_per_mm)
        length = millimetres * px_per_mm
        y, tick = self.size[1] - 1.5 * self.gap, self.em * 0.35
        x = float(self.gap)
        thick = max(1, round(self.em / 10))
        draw.line((x, y, x + length, y), INK, thick)
        for end in (x, x + length):
            draw.line((end, y - tick, end, y + tick), INK, thick)
        text = f"{millimetres:g} mm"
        draw.text((x + length / 2, y - 0.4 * self.em), text, INK, self.font, anchor="ms")


def round_length(longest_mm: float) -> float:
    """Find the greatest of 1, 2 and 5 times a power of ten that is not above a length, mm."""
    power = 10.0 ** math.floor(math.log10(longest_mm))
    return power * max(step for step in (1.0, 2.0, 5.0) if step * power <= longest_mm)
