"""Which parts of a model's surface are printed as layers: marks in the placed model's frame, mm."""

from __future__ import annotations

from wireprint.regions.region import Mark, Region
from wireprint.regions.shapes import Box, HalfSpace, Predicate, Shape, Sphere, ZRange

__all__ = ["Box", "HalfSpace", "Mark", "Predicate", "Region", "Shape", "Sphere", "ZRange"]
