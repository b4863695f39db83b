//! How much of each there may be in a document.

/// Most elements inside one another; a 3MF needs eight.
pub const MOST_DEEP: usize = 32;
/// Most bytes of one tag, comment or text; a triangle that was painted finely has some thousands.
pub const MOST_TOKEN: usize = 1 << 22;
/// Most attributes of an element.
pub const MOST_ATTRIBUTES: usize = 32;
/// Most prefixes that are bound to namespaces at a time.
pub const MOST_BINDINGS: usize = 64;
