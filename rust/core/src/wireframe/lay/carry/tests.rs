//! What lies too far from all that could hold it.

use super::*;
use crate::wireframe::lay::scene::{curve, rim, square};

#[test]
fn a_curve_is_far_if_some_place_of_it_is() {
    let own = curve(&square(10.0));
    let around = rim(&square(16.0), 5.0);
    // Its corners lie 6 mm from both sides around them.
    assert!(!is_far(&own, &[&around], 6.0) && is_far(&own, &[&around], 5.9));
    let mut half = around.clone();
    half.closed = false;
    half.points.truncate(2);
    assert!(!is_far(&own, &[&half], 26.0) && is_far(&own, &[&half], 25.9));
    assert!(!is_far(&own, &[&half, &around], 6.0));
    assert!(is_far(&own, &[], 1e9));
}
