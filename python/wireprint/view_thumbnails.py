"""Small pictures for the head of a G-code file."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from wireprint.view_camera import CAMERAS
from wireprint.view_styles import style_of

if TYPE_CHECKING:
    from collections.abc import Callable, Iterable, Sequence

    from wireprint._core import Strands


def thumbnails(
    strands: Strands, sizes: Iterable[Sequence[Any]] = ((32, 32), (300, 300))
) -> list[tuple[int, int, bytes]]:
    """Draw small pictures of the object on a transparent ground, for the head of a G-code file.

    Parameters
    ----------
    strands
        What is shown.
    sizes
        Width and height of each, pixels; with a third part, its form: ``PNG`` or ``QOI``.

    Returns
    -------
    list
        Width, height and file of each.
    """
    return begin_thumbnails(strands, sizes)()


def begin_thumbnails(
    strands: Strands, sizes: Iterable[Sequence[Any]]
) -> Callable[[], list[tuple[int, int, bytes]]]:
    """Begin to draw `thumbnails` beside other work; what is returned waits for them, once."""
    styles = [style_of(label) for label in strands.labels]
    objects = [style.colour if style.is_object else None for style in styles]
    wanted = [(width, height, *(form or ["PNG"])) for width, height, *form in sizes]
    drawn = strands.thumbnails(objects, wanted, CAMERAS["iso"], margin=1.0)
    return lambda: [
        (width, height, file)
        for (width, height, _), file in zip(wanted, drawn.files(), strict=True)
    ]
