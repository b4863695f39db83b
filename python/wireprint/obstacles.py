"""An object on the bed as strands: so close that the head meets one where it meets the object."""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

from wireprint import _core

if TYPE_CHECKING:
    import os
    from collections.abc import Iterator

    import numpy as np
    import numpy.typing as npt
    import shapely

    from wireprint._core import Mesh
    from wireprint.settings import Settings

#: Distance of an object's strands, in strands' diameters: what the head may reach into a strand is
#: half a diameter, so it meets one before it is as deep in the object.
_PITCH: Final = 0.5
#: Sections of an object that are cut at most; a taller one is cut more coarsely.
_MOST_SECTIONS: Final = 2000
#: Points that a section's outline may stray by, in strands' diameters.
_FOLLOWS: Final = 0.1


def load_object(path: str | os.PathLike[str]) -> tuple[Mesh, tuple[float, float, float]]:
    """Read an object, and where its file puts the middle of its foot, mm.

    Raises
    ------
    ModelError
        See `wireprint.load_mesh`.
    """
    from wireprint.mesh import load_mesh

    mesh = load_mesh(path)
    # What took the file's points to the mesh's moved them by as much.
    x, y, z = (-float(value) for value in mesh.placement[:3, 3])
    return mesh, (x, y, z)


def as_gcode(
    mesh: Mesh, settings: Settings, at_mm: tuple[float, float, float] = (0.0, 0.0, 0.0)
) -> bytes:
    """Return strands all over an object, as G-code that nobody prints.

    Parameters
    ----------
    mesh
        The object, placed.
    settings
        The printer's.
    at_mm
        Where the middle of its foot stands, from the middle of the bed.

    Returns
    -------
    bytes
        Lines of G-code; they leave the machine with absolute coordinates and absolute E.
    """
    import numpy as np

    x, y = settings.printer.bed.centre_mm
    origin = np.array([x, y, 0.0]) + np.array(at_mm)
    lines = ["G90", "M83", ";TYPE:OBJECT"]
    for start, *rest in _paths(mesh, settings.strand_mm):
        lines.append("G0 X{:.3f} Y{:.3f} Z{:.3f}".format(*(start + origin)))
        lines += ["G1 X{:.3f} Y{:.3f} Z{:.3f} E1".format(*(place + origin)) for place in rest]
    # The head is not in the object when the print begins.
    lines += [f"G0 Z{settings.printer.bed.height_mm:.3f}", "M82", "G92 E0"]
    return ("\n".join(lines) + "\n").encode()


def _paths(mesh: Mesh, strand_mm: float) -> Iterator[npt.NDArray[np.float64]]:
    """Yield polylines (N, 3), mm: outlines of sections, and hatches where a section ends."""
    import numpy as np
    import shapely

    from wireprint.layerwise.areas import buffered, of_slices

    height = mesh.size_mm[2]
    pitch = max(_PITCH * strand_mm, height / _MOST_SECTIONS)
    heights = np.append(np.arange(pitch / 2, height, pitch), height)
    slices = _core.slice_mesh(mesh, heights, "below")
    areas = of_slices(slices, _FOLLOWS * strand_mm)
    for number, z in enumerate(heights):
        above = areas[number + 1] if number + 1 < len(areas) else shapely.Polygon()
        bare = shapely.difference(areas[number], buffered(above, pitch))
        lines = [*_rings(areas[number]), *_hatch(bare, pitch)]
        for line in lines:
            if len(line) > 1:
                yield np.column_stack([line, np.full(len(line), z)])


def _rings(area: shapely.Geometry) -> Iterator[npt.NDArray[np.float64]]:
    import shapely

    for part in shapely.get_parts(area):
        for ring in (part.exterior, *part.interiors):
            yield shapely.get_coordinates(ring)


def _hatch(area: shapely.Geometry, pitch: float) -> Iterator[npt.NDArray[np.float64]]:
    """Yield straight lines that fill an area."""
    import numpy as np
    import shapely

    if shapely.is_empty(area):
        return
    low_x, low_y, high_x, high_y = shapely.bounds(area)
    rows = np.arange(low_y + pitch / 2, high_y, pitch)
    lines = shapely.linestrings([[(low_x - 1, y), (high_x + 1, y)] for y in rows])
    for found in shapely.get_parts(shapely.intersection(lines, area)):
        if found.geom_type == "LineString":
            yield shapely.get_coordinates(found)
