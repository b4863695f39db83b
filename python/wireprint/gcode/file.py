"""A toolpath as a whole file, and what the planner says of it."""

from __future__ import annotations

from typing import TYPE_CHECKING, NamedTuple

from wireprint.gcode import document, griffin
from wireprint.gcode.flavors import FLAVORS

if TYPE_CHECKING:
    from collections.abc import Callable, Iterable
    from datetime import datetime

    from wireprint._core import Estimate, Toolpath
    from wireprint.gcode.document import Thumbnail
    from wireprint.settings import Settings


class Written(NamedTuple):
    """A whole file."""

    text: bytes
    estimate: Estimate


def write(
    path: Toolpath,
    settings: Settings,
    date: datetime | None = None,
    thumbnails: Callable[[], Iterable[Thumbnail]] = list,
    remarks: Iterable[str] = (),
) -> Written:
    """Write a toolpath with progress, header and footer.

    Parameters
    ----------
    path, settings
        The moves, and the settings that they were made with.
    date
        Written into the file; default: as `document.dated` without a file.
    thumbnails
        Gives the pictures, when all else is there.
    remarks
        Lines of the header of their own.
    """
    text, estimate = document.timed(document.commands(path, settings), settings)
    layers = text.count(b";LAYER_CHANGE\n")
    footer = document.footer(settings, estimate.filament_mm, estimate.total_s, layers)
    date = date or document.dated(None)
    header = document.header(settings, date, thumbnails(), remarks)
    if FLAVORS[settings.printer.gcode.flavor].griffin:
        header = griffin.header(path, settings, estimate, date) + header
    return Written(b"".join((header, text, footer)), estimate)
