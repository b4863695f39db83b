"""Which parts of a model's surface are printed as layers: marks in the placed model's frame, mm."""

from __future__ import annotations

from wireprint.regions.mask import Mask
from wireprint.regions.region import Mark, Region
from wireprint.regions.shapes import Box, HalfSpace, Predicate, Shape, Sphere, ZRange
from wireprint.regions.stroke import Stroke

__all__ = [
    "Box",
    "HalfSpace",
    "Mark",
    "Mask",
    "Predicate",
    "Region",
    "Shape",
    "Sphere",
    "Stroke",
    "ZRange",
]
