"""The layers that a region is made of, cut through the whole model, and points along them."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING

import numpy as np

from wireprint.records import Record, sealed

if TYPE_CHECKING:
    import numpy.typing as npt

    from wireprint._core import Mesh, Wireframe

    Floats = npt.NDArray[np.float64]
    Ints = npt.NDArray[np.int64]
    Bools = npt.NDArray[np.bool_]

#: Points along a contour lie at most this part of a strand apart.
_PITCH = 0.5
#: A wall counts as no flatter than this: its area per height would be infinite.
_FLATTEST = 0.05


@dataclass(frozen=True, repr=False)
class Cut(Record):
    """Every slab of a model divided evenly into layers, the last at the slab's top."""

    #: Slab, printed height and thickness of each layer, mm, bottom up, shape (K,).
    slab: Ints
    z: Floats
    thickness: Floats
    #: Points of all contours, mm, shape (P, 2), and the mesh's face behind each, shape (P,).
    points: Floats
    face: Ints
    #: Contour i has the points ``offsets[i]:offsets[i + 1]``, shape (M + 1,).
    offsets: Ints
    #: Layer k has the contours ``slice_offsets[k]:slice_offsets[k + 1]``, shape (K + 1,).
    slice_offsets: Ints
    #: Of each contour, shape (M,): what encloses it, how often, whether it is closed, and the
    #: strip of its slab that it lies on, −1 for none.
    parent: Ints
    depth: npt.NDArray[np.uint32]
    closed: Bools
    strip: Ints

    @classmethod
    def of(cls, wireframe: Wireframe, mesh: Mesh, layer_mm: float, strand_mm: float) -> Cut:
        """Cut the slabs of a wireframe's model into layers about `layer_mm` high."""
        found = wireframe.layers(mesh, layer_mm, strand_mm)
        return cls(
            found["slab"],
            found["z"],
            found["thickness"],
            found["points"],
            found["face"],
            found["offsets"],
            found["slice_offsets"],
            found["parent"],
            found["depth"],
            found["closed"],
            found["strip"],
        )

    @cached_property
    def layer(self) -> Ints:
        """Layer of each contour, shape (M,)."""
        return sealed(np.repeat(np.arange(len(self.z)), np.diff(self.slice_offsets)))

    @cached_property
    def steps(self) -> tuple[Ints, Floats]:
        """The point after each one along its contour, and the way there, mm.

        An open contour goes nowhere from its last point.
        """
        following = np.arange(1, len(self.points) + 1)
        following[self.offsets[1:] - 1] = self.offsets[:-1]
        lengths: Floats = np.hypot(*(self.points[following] - self.points).T)
        lengths[(self.offsets[1:] - 1)[~self.closed]] = 0.0
        return sealed((following, lengths))

    def is_last(self) -> Bools:
        """Tell which layers lie at the top of their slabs, shape (K,)."""
        return np.append(self.slab[1:] != self.slab[:-1], True)[: len(self.slab)]


@dataclass(frozen=True, repr=False)
class Samples(Record):
    """Short pieces of the layers' contours, in the order of contour and arc length."""

    #: Contour of each, shape (S,).
    contour: Ints
    #: Where it begins and ends along its contour, mm, shape (S,).
    begin: Floats
    end: Floats
    #: Its middle, mm, and the surface's outward unit normal there, shape (S, 3).
    middle: Floats
    normal: Floats
    #: Area of the surface that it stands for, mm², shape (S,).
    area: Floats

    @classmethod
    def of(cls, cut: Cut, normals: Floats, strand_mm: float) -> Samples:
        """Divide all contours into pieces of at most half a strand, given the faces' normals."""
        sizes = np.diff(cut.offsets)
        contour = np.repeat(np.arange(len(sizes)), sizes)
        following, lengths = cut.steps
        steps = cut.points[following] - cut.points
        along = np.cumsum(lengths) - lengths
        along -= along[cut.offsets[:-1]][contour]
        count = np.ceil(lengths / (_PITCH * strand_mm)).astype(np.int64)
        which = np.repeat(np.arange(len(count)), count)
        rank = np.arange(len(which)) - np.repeat(np.cumsum(count) - count, count)
        share = lengths[which] / count[which]
        begin = along[which] + rank * share
        middle = cut.points[which] + steps[which] * ((rank + 0.5) / count[which])[:, None]
        layer = cut.layer[contour[which]]
        normal = normals[cut.face[which]]
        steep = np.maximum(np.hypot(normal[:, 0], normal[:, 1]), _FLATTEST)
        return cls(
            contour[which],
            begin,
            begin + share,
            np.column_stack([middle, cut.z[layer]]),
            normal,
            share * cut.thickness[layer] / steep,
        )


def normals_of(mesh: Mesh) -> Floats:
    """Return the unit normals of all faces, shape (F, 3); upwards for a face without area."""
    # Each access makes an array.
    vertices, faces = mesh.vertices, mesh.faces
    a, b, c = (vertices[faces[:, corner]] for corner in range(3))
    normals: Floats = np.cross(b - a, c - a)
    lengths = np.linalg.norm(normals, axis=1)
    normals[lengths == 0] = (0.0, 0.0, 1.0)
    return normals / np.where(lengths == 0, 1.0, lengths)[:, None]
