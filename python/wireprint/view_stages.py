"""What each stage makes of a model, as strands that `view` draws: from slices to moves.

A reader sees with it what one stage hands to the next, for all slabs or for one.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Final, Literal, get_args

import numpy as np

from wireprint import stages
from wireprint._core import KINDS, SettingError, Strands

if TYPE_CHECKING:
    from collections.abc import Iterable, Iterator

    import numpy.typing as npt

    from wireprint._core import Mesh, Wireframe, _Contours
    from wireprint.settings import Settings

    #: Ends of strokes (N, 2, 3), mm.
    Segments = npt.NDArray[np.float64]

Stage = Literal["slices", "contours", "strips", "posts", "strands", "toolpath"]
STAGES: Final[tuple[Stage, ...]] = get_args(Stage)
#: Strips beside each other take turns with as many colours.
_STRIP_COLOURS: Final = 6


def stage(name: Stage, mesh: Mesh, settings: Settings, slabs: range | None = None) -> Strands:
    """Return what a stage makes of a model.

    Parameters
    ----------
    name
        ``slices``: the contours of every slice as cut; ``contours``: which of them are outside,
        which are holes; ``strips``: the surface of each slab, by the contours that it joins;
        ``posts``: where zigzags rise; ``strands``: all that is extruded; ``toolpath``: the same
        with the head's ways between.
    mesh
        The model, placed as `wireprint.load_mesh` does.
    settings
        Printer, material and way of wiring.
    slabs
        Slabs to show, from the bed up; all by default. A slab has the slices at its foot and top.

    Raises
    ------
    SettingError
        There are no such slabs.
    ModelError
        No slice has a contour.
    """
    wireframe = stages.wireframe(mesh, settings)
    count = wireframe.slice_count - 1
    shown = range(count) if slabs is None else slabs
    if count > 0 and not (0 <= shown.start < shown.stop <= count):
        last = count - 1
        raise SettingError(f"slabs: {shown.start} to {shown.stop - 1}; there are 0 to {last}")
    diameter_mm = settings.strand_mm
    if name == "toolpath":
        return _toolpath(wireframe, settings, shown)
    groups = {
        "slices": _slices,
        "contours": _contours,
        "strips": _strips,
        "posts": _posts,
        "strands": _strands,
    }[name](wireframe, shown)
    return _as_strands(groups, diameter_mm)


def _as_strands(groups: Iterable[tuple[str, Segments]], diameter_mm: float) -> Strands:
    """Join labelled strokes."""
    given = list(groups)
    labels = sorted({label for label, _ in given})
    features = [np.full(len(ends), labels.index(label), np.uint16) for label, ends in given]
    segments = np.concatenate([np.empty((0, 2, 3)), *(ends for _, ends in given)])
    all_features = np.concatenate([np.empty(0, np.uint16), *features])
    return Strands.from_arrays(segments, all_features, labels, diameter_mm)


def _loops(contours: _Contours, level: int, z_mm: float) -> Iterator[tuple[int, Segments]]:
    """Yield each contour of a slice, its number and its strokes."""
    points, offsets = contours["points"], contours["offsets"]
    first, last = contours["slice_offsets"][level : level + 2]
    for contour in range(first, last):
        loop = points[offsets[contour] : offsets[contour + 1]]
        if contours["closed"][contour]:
            loop = np.concatenate([loop, loop[:1]])
        flat = np.column_stack([loop, np.full(len(loop), z_mm)])
        yield contour, np.stack([flat[:-1], flat[1:]], axis=1)


def _levels(slabs: range) -> range:
    """Levels at which the slabs begin and end."""
    return range(slabs.start, slabs.stop + 1)


def _slices(wireframe: Wireframe, slabs: range) -> Iterator[tuple[str, Segments]]:
    for level in _levels(slabs):
        z_mm = wireframe.levels[level, 0]
        for _, ends in _loops(wireframe.contours_below, level, z_mm):
            yield "slice", ends


def _contours(wireframe: Wireframe, slabs: range) -> Iterator[tuple[str, Segments]]:
    contours = wireframe.contours_below
    for level in _levels(slabs):
        for contour, ends in _loops(contours, level, wireframe.levels[level, 0]):
            is_hole = contours["depth"][contour] % 2 == 1
            yield ("hole" if is_hole else "outside"), ends


def _strips(wireframe: Wireframe, slabs: range) -> Iterator[tuple[str, Segments]]:
    levels, above, below = wireframe.levels, wireframe.contours_above, wireframe.contours_below
    strips = wireframe.strips
    for slab in slabs:
        feet = [ends for _, ends in _loops(above, slab, levels[slab, 0])]
        tops = [ends for _, ends in _loops(below, slab + 1, levels[slab + 1, 0])]
        for number, (lower, upper, _) in enumerate(strips[slab]):
            label = f"strip {number % _STRIP_COLOURS + 1}"
            yield from ((label, feet[contour]) for contour in lower)
            yield from ((label, tops[contour]) for contour in upper)


def _posts(wireframe: Wireframe, slabs: range) -> Iterator[tuple[str, Segments]]:
    yield from _slices(wireframe, slabs)
    slab_of = wireframe.post_places[:, 0]
    yield "post", wireframe.posts[(slab_of >= slabs.start) & (slab_of < slabs.stop)]


def _strands(wireframe: Wireframe, slabs: range) -> Iterator[tuple[str, Segments]]:
    slab_of, kinds = wireframe.strand_slabs, wireframe.strand_kinds
    chosen = (slab_of >= slabs.start) & (slab_of < slabs.stop)
    for code in np.unique(kinds[chosen]):
        yield KINDS[code], wireframe.strands[chosen & (kinds == code)]


def _toolpath(wireframe: Wireframe, settings: Settings, slabs: range) -> Strands:
    from wireprint._core import Toolpath

    path = stages.toolpath(wireframe, settings)
    chosen = (path.slab >= slabs.start) & (path.slab < slabs.stop)
    first = int(np.argmax(chosen))
    before = path.to[first - 1] if first > 0 else np.asarray(path.start)
    cut = Toolpath.from_arrays(
        start=(float(before[0]), float(before[1]), float(before[2])),
        to=path.to[chosen],
        kind=path.kind[chosen],
        speed=path.speed[chosen],
        filament=path.filament[chosen],
        pause=path.pause[chosen],
        air=path.air[chosen],
        slab=path.slab[chosen],
    )
    return Strands.from_toolpath(cut, KINDS, settings.printer.extruder.filament_diameter_mm)
