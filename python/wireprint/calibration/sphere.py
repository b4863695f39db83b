"""The spheres of the paper's figure 15: one for each speed and pause.

All are printed at once, slab by slab, as one print of nine bodies; only speeds and pauses of its
strokes differ from those of any other print.
"""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any, Final

import numpy as np

from wireprint import _core
from wireprint._core import KINDS, Mesh
from wireprint.calibration import numbers
from wireprint.calibration.tents import APART
from wireprint.heads.gauge_path import Path
from wireprint.stages import toolpath, wireframe

if TYPE_CHECKING:
    import numpy.typing as npt

    from wireprint._core import Toolpath
    from wireprint.settings import Settings

    Array = npt.NDArray[np.float64]

#: Speeds as shares of that of printing (the paper: 30 and 5 mm/s), and pauses as shares of the
#: computed one. The shortest has just over the quarter that a certificate asks for.
SPEEDS: Final = (1.0, 0.5, 1 / 6)
PAUSES: Final = (0.3, 0.6, 1.2)
#: Radii that are tried, in slabs of the greatest height: the largest that is quick enough.
RADII: Final = (1.6, 1.3, 1.15, 1.0, 0.9, 0.8, 0.7, 0.6, 0.5)
#: A sphere is cut off so far below its middle, in radii: it stands on a ring, not on a point.
_FOOT: Final = 0.7
#: Meridians and circles of latitude.
_AROUND: Final = 48
_UP: Final = 24
_STROKES: Final = [KINDS.index(kind) for kind in ("contour", "post", "diagonal", "cap", "support")]


def speeds_mm_s(settings: Settings) -> tuple[float, ...]:
    """Return the speeds of the rows, mm/s, from front to back."""
    return tuple(share * settings.print_mm_s for share in SPEEDS)


def pauses_s(settings: Settings) -> tuple[float, ...]:
    """Return the pauses of the columns, s, from left to right."""
    return tuple(share * settings.solidify_s for share in PAUSES)


def spheres(settings: Settings, slabs: float) -> Toolpath:
    """Plan the moves of all spheres, of so many slabs' radius, and of their numbers."""
    radius = slabs * settings.slab_max_mm
    strand = settings.strand_mm
    run = _core.stroke_run(settings.printer.head.model_dump(), strand, settings.slab_max_mm)
    wide, deep = numbers.size_mm(1, strand)
    pitch = np.array([2 * radius + run, 2 * radius + run + deep]) + APART * strand
    columns = np.arange(len(PAUSES)) - (len(PAUSES) - 1) / 2
    rows = np.arange(len(SPEEDS)) - (len(SPEEDS) - 1) / 2
    places = np.array([(x, y) for y in rows for x in columns]) * pitch
    mesh = _bodies(radius, places)
    # The numbers prime the nozzle; a skirt would run over them.
    bare = settings.but(overrides=["wire.skirt_rings=0"])
    path = toolpath(wireframe(mesh, bare), bare)
    own = _columns(path)
    middles = places + np.array(settings.printer.bed.centre_mm)
    _vary(own, middles, settings)
    label = Path(settings)
    foot = radius * math.sqrt(1 - _FOOT**2)
    for number, (x, y) in enumerate(middles.tolist(), 1):
        at = (x - wide / 2, y - max(foot, radius) - APART * strand - deep)
        numbers.lay(label, number, at, settings.first_layer_height_mm)
    label.go((*label.at[:2], label.top + settings.wire.travel_lift_mm), prints=False)
    labels = _columns(label.toolpath(centred=False))
    start = tuple(labels["to"][0].tolist())
    joined = {name: np.concatenate([labels[name], own[name]]) for name in own}
    return _core.Toolpath.from_arrays(start=start, **joined)


def _vary(own: dict[str, Any], middles: Array, settings: Settings) -> None:
    """Give each sphere its speed and its pause."""
    off = np.linalg.norm(own["to"][:, None, :2] - middles[None], axis=-1)
    of = np.argmin(off, axis=1)
    row, column = np.divmod(of, len(PAUSES))
    prints = np.isin(own["kind"], _STROKES)
    shares = np.array(SPEEDS)[row]
    own["speed"] = np.where(prints, own["speed"] * shares, own["speed"])
    held = np.array(pauses_s(settings))[column]
    own["pause"] = np.where(own["pause"] > 0, held, 0.0)


def _columns(path: Toolpath) -> dict[str, Any]:
    names = ("to", "kind", "speed", "filament", "pause", "air", "slab")
    return {name: np.array(getattr(path, name)) for name in names}


def _bodies(radius: float, places: Array) -> Mesh:
    """Return spheres on the bed, cut off below, as one mesh."""
    ups = np.linspace(-math.asin(_FOOT), math.pi / 2, _UP + 1)[:-1]
    turns = np.arange(_AROUND) * 2 * math.pi / _AROUND
    rings = [
        (radius * math.cos(up) * np.cos(turns), radius * math.cos(up) * np.sin(turns)) for up in ups
    ]
    heights = [radius * (math.sin(up) + _FOOT) for up in ups]
    points = [
        np.column_stack([x, y, np.full(_AROUND, z)])
        for (x, y), z in zip(rings, heights, strict=True)
    ]
    poles = [[0.0, 0.0, 0.0], [0.0, 0.0, radius * (1 + _FOOT)]]
    body = np.vstack([*points, np.array(poles)])
    bottom, top = len(body) - 2, len(body) - 1
    faces: list[tuple[int, int, int]] = []
    for number in range(_AROUND):
        after = (number + 1) % _AROUND
        faces.append((bottom, after, number))
        last = (_UP - 1) * _AROUND
        faces.append((top, last + number, last + after))
        for ring in range(0, last, _AROUND):
            a, b = ring + number, ring + after
            faces += [(a, b, b + _AROUND), (a, b + _AROUND, a + _AROUND)]
    count = len(body)
    vertices = np.vstack([body + np.array([x, y, 0.0]) for x, y in places])
    shifted = [np.array(faces) + count * number for number in range(len(places))]
    return Mesh.from_arrays(vertices, np.vstack(shifted).astype(np.int64))


def sphere_words(settings: Settings) -> tuple[str, ...]:
    """Say what to look for."""
    pauses = " ".join(f"{pause:.2f}" for pause in pauses_s(settings))
    speeds = ", ".join(f"{speed:.3g}" for speed in speeds_mm_s(settings))
    return (
        f"nine spheres, numbered: rows from front to back at {speeds} mm/s, columns from left to "
        f"right with pauses of {pauses} s (figure 15 of the paper)",
        "measure: in each row, by eye, the first sphere that is whole: its zigzags straight, its "
        "rings at one height within half a strand",
        "answer: for each row that has one [[sphere]] speed_mm_s = …, pause_s = that of its column",
    )
