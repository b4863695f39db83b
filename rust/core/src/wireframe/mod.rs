//! Stage 4, the wireframe: strips, posts, strands.
//!
//! By question: [`plan`] (what is there to print), [`place`] (where do posts stand), [`regions`] (what
//! is layers), [`lay`] (in which strands, slab by slab), [`order`] (what first). [`build`] runs them.

pub mod build;
pub mod flat;
pub mod frame;
pub mod lay;
pub mod order;
pub mod params;
pub mod place;
pub mod plan;
pub mod regions;
