"""Supports of a wire print without the print: what carries layers of the same model."""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

import numpy as np
import shapely

from wireprint import _core
from wireprint._core import KINDS, UnprintableError
from wireprint.alongside import SAME_MM, lying_along
from wireprint.layerwise.areas import of_slices
from wireprint.struts.supports import parts

if TYPE_CHECKING:
    import numpy.typing as npt

    from wireprint._core import Mesh, Wireframe
    from wireprint.certificate import Certificate
    from wireprint.verdict import Point

_SUPPORT: Final = KINDS.index("support")
#: How far a section may leave the exact one, of a strand.
_RESOLUTION: Final = 0.1


def carrying(frame: Wireframe, body: Mesh, strand_mm: float) -> Wireframe:
    """Return the supports of a print alone, without those within the model: layers fill it.

    Parameters
    ----------
    frame
        The print, whose supports bear layers.
    body
        The model.
    strand_mm
        Diameter of a strand.

    Returns
    -------
    Wireframe
        Its supports.

    Raises
    ------
    UnprintableError
        There are none.
    """
    own = frame.strand_kinds == _SUPPORT
    own[own] = ~_within(frame, body, own, strand_mm)
    if not own.any():
        raise UnprintableError("the model needs no supports: print its layers as they are")
    return frame.beyond(np.flatnonzero(~own).tolist())


def _within(
    frame: Wireframe, body: Mesh, which: npt.NDArray[np.bool_], strand_mm: float
) -> npt.NDArray[np.bool_]:
    """Tell which strands belong to a column within the model.

    Such a column is within all the way: one of its rising strands is, by the model's section
    halfway up their slab. A deck's strand may cross what stands below it, but joins no such one.
    """
    ends = frame.strands[which]
    levels = frame.levels[:, 1]
    sections = of_slices(
        _core.slice_mesh(body, (levels[1:] + levels[:-1]) / 2), _RESOLUTION * strand_mm
    )
    # What is level lies on the slab below it.
    slabs = np.searchsorted(levels, ends[..., 2].mean(axis=1) - strand_mm / 2) - 1
    areas = sections[slabs.clip(0, len(sections) - 1)]
    within = shapely.contains_xy(areas[:, None], ends[..., 0], ends[..., 1])
    inside: npt.NDArray[np.bool_] = within.all(axis=1)
    rises = np.ptp(ends[..., 2], axis=1) > SAME_MM
    steps = np.round(ends[inside].reshape(-1, 3) / SAME_MM)
    _, nodes = np.unique(steps, axis=0, return_inverse=True)
    edges = nodes.reshape(-1, 2)
    part = parts(len(edges) * 2, edges)[edges[:, 0]]
    inside[inside] = np.isin(part, part[rises[inside]])
    return inside


def barred(frame: Wireframe, certificate: Certificate, origin_mm: Point) -> list[int]:
    """Return the strands of supports that layers run into, and those that hang.

    Parameters
    ----------
    frame
        The supports that were put in.
    certificate
        The verdict on the whole file.
    origin_mm
        The model's place on the printer, mm.

    Returns
    -------
    list of int
        Numbers of strands of `frame`.
    """
    core = certificate.core
    lines = {hit.hit_line for hit in certificate.collisions}
    lines |= {end.line for end in (*certificate.floating_starts, *certificate.dangling_ends)}
    lines |= {hit.line for hit in certificate.collisions}
    lines |= {span.line for span in certificate.spans_over}
    lines |= {end.line for end in certificate.hurried}
    named = [number for number, name in enumerate(core.features) if name == KINDS[_SUPPORT]]
    blamed = np.isin(core.strand_lines, [line for line in lines if line is not None])
    blamed &= np.isin(core.strand_features, named)
    return lying_along(frame, origin_mm, core.strands[blamed])
