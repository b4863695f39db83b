"""A model with what is marked on it, as the groups of triangles that a picture shows."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from wireprint.regions.surface import marked_surface
from wireprint.view_styles import MODEL, STYLES, Entry

if TYPE_CHECKING:
    import numpy as np
    import numpy.typing as npt

    from wireprint.model import Model


@dataclass(frozen=True)
class Group:
    """Triangles of one colour."""

    entry: Entry
    #: float64 of shape (T, 3, 3), mm.
    corners: npt.NDArray[np.float64]


def groups(model: Model) -> list[Group]:
    """Split a model's surface into what is printed as wire and what as layers."""
    surface = marked_surface(model.mesh, model.region)
    marked, share = surface.marked, surface.marked_mm2 / surface.area_mm2
    wire = Entry("wire", "not marked", MODEL, share=1 - share)
    layers = Entry("layer-wise", "marked", STYLES["layer-wise"].colour, share=share)
    return [Group(wire, surface.corners[~marked]), Group(layers, surface.corners[marked])]
