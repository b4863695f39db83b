"""A toolpath as a whole G-code file, with its pictures."""

from __future__ import annotations

from typing import TYPE_CHECKING

from wireprint.gcode import document, file

if TYPE_CHECKING:
    from collections.abc import Callable, Iterable
    from datetime import datetime

    from wireprint._core import Toolpath
    from wireprint.gcode.document import Thumbnail
    from wireprint.gcode.file import Written
    from wireprint.settings import Settings


def to_gcode(
    toolpath: Toolpath,
    settings: Settings,
    *,
    date: datetime | None = None,
    remarks: Iterable[str] = (),
) -> bytes:
    """Return a whole G-code file: header, start, moves with progress, end, footer.

    Parameters
    ----------
    toolpath
        The moves.
    settings
        The settings that they were made with.
    date
        Written into the file; default: as `document.dated` without a file.
    remarks
        Lines of the header of their own.

    Returns
    -------
    bytes
        The text.

    Raises
    ------
    UnprintableError
        A figure of a move is not finite.
    """
    return written_file(toolpath, settings, date, remarks).text


def written_file(
    path: Toolpath,
    settings: Settings,
    date: datetime | None,
    remarks: Iterable[str] = (),
    *,
    pictures: bool = True,
) -> Written:
    """Return `to_gcode`'s text with the times of its planner; a draft needs no pictures."""
    # The pictures take as long as all the text: they are drawn beside it.
    thumbnails = _thumbnails(path, settings) if pictures else list
    return file.write(path, settings, date, thumbnails, remarks)


def _thumbnails(path: Toolpath, settings: Settings) -> Callable[[], list[Thumbnail]]:
    """Begin to draw the pictures; what is returned waits for them."""
    sizes = settings.printer.gcode.thumbnails
    if not sizes:
        return list
    from wireprint.view_source import strands_of
    from wireprint.view_thumbnails import begin_thumbnails

    drawn = begin_thumbnails(strands_of(path, settings), sizes)
    # What is left of a size behind width and height is the picture's form.
    return lambda: [
        document.Thumbnail(*made, *size[2:]) for made, size in zip(drawn(), sizes, strict=True)
    ]
