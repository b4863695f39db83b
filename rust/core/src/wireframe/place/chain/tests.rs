//! What a chord costs; chains as a whole are held to a plain search in `tests/posts_chain.rs`.

use super::*;

#[test]
fn a_chord_costs_by_the_square_of_the_share_that_it_is_longer_or_shorter() {
    assert_eq!(uneven(6.0, 6.0), 0.0);
    assert!((uneven(9.0, 6.0) - EVEN / 4.0).abs() < 1e-12 && uneven(3.0, 6.0) == EVEN / 4.0);
}
