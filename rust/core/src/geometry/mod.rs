//! Geometry, mostly of the plane, that every stage shares; it knows of no stage.

pub mod buckets;
pub mod cells;
pub mod curve;
pub mod disjoint_sets;
pub mod extents;
pub mod hatch;
pub mod holding;
pub mod layers;
pub mod nearest;
pub mod nearest_first;
pub mod passing;
pub mod polygon;
pub mod polyline;
pub mod segments;
pub mod space;
pub mod station;
pub mod tour;
