"""What is shown in which colour: styles by label, and the lines of a legend."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Final, TypeAlias

from wireprint._core import SettingError
from wireprint.text import one_line

if TYPE_CHECKING:
    from collections.abc import Collection, Sequence

    from wireprint._core import Strands

Rgb: TypeAlias = tuple[int, int, int]


@dataclass(frozen=True)
class Style:
    """How strands of one label are shown."""

    name: str
    colour: Rgb
    #: Whether they are part of the object: those count for its size.
    is_object: bool = True
    #: Whether they are shown unless other kinds are asked for.
    shown: bool = True


#: Label in small letters → how its strands are shown, in the legend's order. The hues are
#: those of Okabe and Ito, which colour-blind readers can tell apart; red is kept for breaches.
STYLES: Final[dict[str, Style]] = {
    "contour": Style("contour", (0, 104, 180)),
    "post": Style("post", (232, 146, 12)),
    "diagonal": Style("diagonal", (0, 150, 112)),
    "cap": Style("cap", (236, 208, 50)),
    "layer-wise": Style("layer-wise", (140, 98, 190)),
    "layer-fill": Style("layer fill", (178, 150, 212)),
    "support": Style("support", (208, 120, 166), is_object=False),
    "brim": Style("brim", (150, 140, 124), is_object=False),
    "skirt": Style("skirt", (150, 140, 124), is_object=False),
    "prime": Style("priming", (150, 140, 124), is_object=False, shown=False),
    "custom": Style("start code", (150, 140, 124), is_object=False, shown=False),
    "slice": Style("slice", (110, 122, 134)),
    "outside": Style("outer contour", (0, 104, 180)),
    "hole": Style("hole", (208, 120, 166)),
    "strip 1": Style("strip 1", (0, 104, 180)),
    "strip 2": Style("strip 2", (232, 146, 12)),
    "strip 3": Style("strip 3", (0, 150, 112)),
    "strip 4": Style("strip 4", (208, 120, 166)),
    "strip 5": Style("strip 5", (140, 98, 190)),
    "strip 6": Style("strip 6", (120, 92, 58)),
}
#: Strands of other programs, whose labels mean something else.
FOREIGN: Final[Rgb] = (96, 128, 158)
#: Strands before the first label.
UNLABELLED: Final = "no label"

TRAVEL: Final[Rgb] = (178, 190, 202)
BREACH: Final[Rgb] = (222, 22, 34)
WEAK: Final[Rgb] = (16, 16, 16)
MODEL: Final[Rgb] = (120, 164, 208)
EDGE: Final[Rgb] = (52, 78, 106)
WHITE: Final[Rgb] = (255, 255, 255)


@dataclass(frozen=True)
class Entry:
    """One line of a legend."""

    label: str
    name: str
    colour: Rgb
    length_mm: float | None = None
    #: Share of the surface (0–1).
    share: float | None = None

    @property
    def amount(self) -> str:
        """Length in metres or share of the surface, or nothing."""
        if self.share is not None:
            return f"{self.share:.1%}"
        return "" if self.length_mm is None else f"{self.length_mm / 1000:.2f} m"


TRAVELS: Final = Entry("travel", "travel", TRAVEL)


def style_of(label: str) -> Style:
    """How strands with a ``;TYPE:`` label are shown, other programs' labels included."""
    known = STYLES.get(label)
    return known or Style(one_line(label) or UNLABELLED, FOREIGN)


def palette(strands: Strands, kinds: Collection[str] | None = None) -> list[Rgb | None]:
    """Colour of each of the strands' labels, ``None`` for those that are left out.

    Parameters
    ----------
    strands
        What is shown.
    kinds
        Labels or names to show, in any case; all but the start code's by default.

    Returns
    -------
    list
        One entry per label.

    Raises
    ------
    SettingError
        A kind is neither known nor in the file.
    """
    styles = [style_of(label) for label in strands.labels]
    if kinds is None:
        return [style.colour if style.shown else None for style in styles]
    wanted = {kind.lower() for kind in kinds}
    known = wanted & (STYLES.keys() | set(strands.labels) | {style.name for style in styles})
    if unknown := sorted(wanted - known):
        has = ", ".join(sorted(style.name for style in styles))
        raise SettingError(f"kinds: {', '.join(unknown)} is unknown; the file has {has}")
    pairs = zip(strands.labels, styles, strict=True)
    return [style.colour if {label, style.name} & wanted else None for label, style in pairs]


def legend(strands: Strands, colours: Sequence[Rgb | None]) -> list[Entry]:
    """Lines of the legend, known kinds first, for what has a colour and a length."""
    order = list(STYLES)
    entries = [
        Entry(label, style_of(label).name, colour, length)
        for label, colour, length in zip(strands.labels, colours, strands.lengths, strict=True)
        if colour is not None and length > 0.0
    ]
    known = [entry for entry in entries if entry.label in STYLES]
    known.sort(key=lambda entry: order.index(entry.label))
    return known + [entry for entry in entries if entry.label not in STYLES]
