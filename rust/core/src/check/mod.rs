//! The certificate: what a file would do on the machine, judged by the rules of a printable file.
//!
//! Of the generator this module shares nothing but [`Head`](crate::head::Head). It takes the moves
//! that the G-code reader gets from a text (arcs as chords, the way home as the printer's profile
//! states it) and reports every breach with the line that commands it:
//!
//! 1. **No collision** ([`collide`]): each move of the whole head, extruding or not, against every
//!    strand laid before it, against the strand that it lays itself, and against the bed. Material
//!    may reach half a strand's diameter into the head, the squash of a joint.
//! 2. **Anchored** ([`stretch`]): a **chain** is a run of extruding moves without a travel between
//!    them (retractions and dwells in place do not break it). It must start in contact, and end in
//!    contact or where a later strand comes into contact ([`closing`]: or close behind, on itself).
//! 3. **Bounded spans** ([`stretch`]): the stretches of a chain between contacts are limited.
//! 4. **In bounds** ([`bounds`]): the build volume, feeds, flow and filament-only moves.
//! 5. **Laid to hold** ([`feed`], [`settle`]): no strand gets too little filament, what was pulled back and is
//!    not forward again left out ([`outflow`]), and no free end is left before it has set.
//! 6. **Ready** ([`nozzle`], [`reading`]): the nozzle is hot, and the axes are home.
//!
//! What can move the head, the bed or the frame of coordinates is carried out, or the file counts as
//! not judged from that line on; what moves nothing is listed ([`reading`], and
//! [`vocabulary`](crate::gcode::vocabulary)).
//!
//! A **strand** is a move that feeds filament forward over a distance. A point of it is in
//! **contact** where the tip stood no higher than [`Rules::bed_contact`] over the bed, or where
//! material laid earlier passes within one strand diameter, centreline to centreline ([`contact`]).
//! Of its own chain only material at least three diameters back along the strand counts: what is
//! nearer touches by mere continuity, and holds nothing.

mod bounds;
pub(crate) mod chain;
mod closing;
mod collide;
pub(crate) mod contact;
pub(crate) mod deposit;
mod feed;
mod file;
pub(crate) mod grid;
mod judge;
mod nozzle;
mod outflow;
pub(crate) mod reading;
pub(crate) mod rules;
mod settle;
mod stretch;
mod verdict;

pub use deposit::Dwell;
pub use file::certify_text;
pub use judge::certify;
pub use reading::Macros;
pub use rules::{Bed, Limits, Rules, Settling};
pub use verdict::{
    Bound, Certificate, Cold, Collision, Hurried, LooseEnd, Obstacle, OutOfBounds, Relaxed, Span,
    Underfed, Unhomed, Unjudged,
};
