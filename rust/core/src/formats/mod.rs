//! Model files as facets: STL, OBJ, PLY and OFF in the dialects that programs write.
//!
//! What makes no sense is refused where it stands; what is passed over or mended is noted. Memory
//! stays in proportion to the file, whatever counts it declares.

mod facets;
mod kind;
mod load;
mod notes;
mod obj;
mod off;
mod ply;
mod polygon;
mod records;
mod source;
mod stl;
mod text;

pub use facets::Facets;
pub use kind::Format;
pub use load::{Loaded, load};
pub use stl::read as read_stl;
