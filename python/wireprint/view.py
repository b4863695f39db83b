"""Pictures of wire prints and models: PNG files, pages that turn in a browser, thumbnails.

A picture of a print replays its G-code, or shows a toolpath before it is written. Strands are
drawn with their real diameter; their colour tells what they are for, by the ``;TYPE:`` label.
"""

from __future__ import annotations

import os
from pathlib import Path
from typing import TYPE_CHECKING, Final

from wireprint._core import Mesh, Scene, Strands
from wireprint.files import apart, written_whole
from wireprint.text import one_line
from wireprint.view_camera import camera_angles
from wireprint.view_source import (
    Shown,
    Source,
    is_gcode,
    judged_in,
    load,
    mesh_of,
    size_mm,
    size_text,
    strands_from,
    strands_in,
    strands_of,
    text_in,
)
from wireprint.view_styles import (
    BREACH,
    EDGE,
    MODEL,
    TRAVEL,
    TRAVELS,
    WEAK,
    WHITE,
    Entry,
    legend,
    palette,
)
from wireprint.view_thumbnails import thumbnails

if TYPE_CHECKING:
    from collections.abc import Collection, Iterable, Sequence

    from wireprint.model import Model

__all__ = (
    "load",
    "render_html",
    "render_png",
    "strands_in",
    "strands_of",
    "thumbnails",
)

BREACH_RADIUS_MM: Final = 0.9
#: Below this width a picture has no room for a legend, pixels.
LEGEND_FROM_PX: Final = 480
#: The picture that a page holds for browsers that cannot draw it, pixels.
_STILL_PX: Final = (960, 720)


def render_png(
    source: Source,
    path: str | os.PathLike[str] | None = None,
    *,
    size: tuple[int, int] = (1600, 1200),
    camera: str = "iso",
    kinds: Collection[str] | None = None,
    travels: bool = False,
    breaches: Iterable[Sequence[float]] = (),
    weak: Iterable[Sequence[float]] = (),
    edges: bool = False,
    with_legend: bool | None = None,
    title: str | None = None,
) -> bytes:
    """Draw a print or a model on the bed.

    Parameters
    ----------
    source
        What is drawn, see `load`.
    path
        PNG file to write; none by default.
    size
        Width and height, pixels.
    camera
        ``iso``, ``front``, ``side``, ``top``, or ``AZIMUTH,ELEVATION`` in degrees.
    kinds
        Kinds of strands to show; all but the start code's by default.
    travels
        Whether moves without extrusion are drawn, as thin lines.
    breaches
        Points (x, y, z) in mm that are marked in red, beside those of a certificate.
    weak
        Points in mm that are marked as giving way easily, in black.
    edges
        Whether the edges of a model's triangles are drawn.
    with_legend
        Whether a legend and a scale bar are drawn; by default where there is room.
    title
        First line of the legend; the file's name by default.

    Returns
    -------
    bytes
        The PNG file.

    Raises
    ------
    GcodeError, ModelError, OSError
        The file cannot be read, or not be written.
    SettingError
        An argument is out of its bounds.
    """
    shown = load(source)
    breaches = _breaches(source, breaches)
    scene = Scene(floor=True)
    entries = _fill(scene, shown, kinds, travels, edges)
    for name, points, colour in (("weak", weak, WEAK), ("breach", breaches, BREACH)):
        marks = _points(points)
        if marks:
            scene.add_marks(marks, colour, BREACH_RADIUS_MM)
            entries.append(Entry(name, f"{name} ({len(marks)})", colour))
    if with_legend is None:
        with_legend = size[0] >= LEGEND_FROM_PX
    angles = camera_angles(camera)
    if not with_legend:
        margin = max(2.0, size[1] / 40)
        png = scene.png(size, angles, supersample=2, margins=(margin,) * 4, ground=WHITE)
    else:
        from wireprint.view_legend import Sheet

        sheet = Sheet(size, _title(title, source), size_text(shown), entries)
        rgba, px_per_mm = scene.render(
            size, angles, supersample=2, margins=sheet.margins, ground=WHITE
        )
        png = sheet.png(rgba, px_per_mm)
    if path is not None:
        _write(path, png, source)
    return png


def render_html(
    source: Source,
    path: str | os.PathLike[str] | None = None,
    *,
    kinds: Collection[str] | None = None,
    travels: bool = False,
    breaches: Iterable[Sequence[float]] = (),
    weak: Iterable[Sequence[float]] = (),
    camera: str = "iso",
    title: str | None = None,
    gcode: bytes | None = None,
) -> str:
    """Make one page that turns in a browser and needs no network.

    Parameters
    ----------
    source, kinds, travels, breaches, weak, title
        See `render_png`; here kinds and travels can be switched on and off.
    path
        HTML file to write; none by default.
    camera
        From where it is seen first, see `render_png`; in perspective always.
    gcode
        The text that strands are of, where `source` is no file: it plays them at the planner's
        times, tells what they take, and shows the printer's bed.

    Returns
    -------
    str
        The page.

    Raises
    ------
    GcodeError, ModelError, OSError
        The file cannot be read, or not be written.
    SettingError
        A kind or the camera is unknown.
    """
    from wireprint.view_html import Page

    if gcode is None and isinstance(source, str | os.PathLike) and is_gcode(source):
        gcode = text_in(source)
        shown: Shown = strands_from(gcode, source)
    else:
        shown = load(source)
    marks, gives = _points(_breaches(source, breaches)), _points(weak)
    still = render_png(
        shown,
        size=_STILL_PX,
        camera=camera,
        kinds=kinds,
        breaches=marks,
        weak=gives,
        with_legend=False,
    )
    page = Page(_title(title, source), size_mm(shown), camera_angles(camera)[:2], still)
    page.add_marks(marks)
    page.add_weak(gives)
    if isinstance(shown, Strands):
        colours = palette(shown, kinds)
        entries = legend(shown, colours)
        page.add_strands(shown, colours, entries, travels=travels, gcode=gcode)
    elif isinstance(shown, Mesh):
        page.add_mesh(shown)
    else:
        from wireprint.view_marks import groups

        page.add_groups(shown.mesh, groups(shown))
    text = page.text()
    if path is not None:
        _write(path, text.encode(), source)
    return text


def _write(path: str | os.PathLike[str], content: bytes, source: Source) -> None:
    """Write a picture or page, though never over what it shows."""
    if isinstance(source, str | os.PathLike):
        apart(path, [source])
    written_whole(Path(path), content)


def _title(title: str | None, source: Source) -> str:
    if title is None:
        title = Path(source).name if isinstance(source, str | os.PathLike) else ""
    return one_line(title)


def _breaches(source: Source, more: Iterable[Sequence[float]]) -> list[Sequence[float]]:
    judged = judged_in(source)
    return [*more, *(() if judged is None else judged.breach_points_mm)]


def _points(marked: Iterable[Sequence[float]]) -> list[tuple[float, float, float]]:
    return [(float(x), float(y), float(z)) for x, y, z in marked]


def _fill(
    scene: Scene,
    shown: Shown,
    kinds: Collection[str] | None,
    travels: bool,
    edges: bool,
) -> list[Entry]:
    """Put what is shown into the scene, and return the legend."""
    if not isinstance(shown, Strands):
        if edges:
            scene.add_edges(mesh_of(shown), EDGE)
        return _fill_surface(scene, shown)
    colours = palette(shown, kinds)
    scene.add_strands(shown, colours, travel=TRAVEL if travels else None)
    entries = legend(shown, colours)
    if travels:
        entries.append(TRAVELS)
    return entries


def _fill_surface(scene: Scene, shown: Mesh | Model) -> list[Entry]:
    """Put a model's triangles into the scene, and return the legend."""
    if isinstance(shown, Mesh):
        scene.add_mesh(shown, MODEL)
        return []
    from wireprint.view_marks import groups

    found = groups(shown)
    for group in found:
        scene.add_facets(group.corners.reshape(-1, 3), group.entry.colour)
    return [group.entry for group in found]
