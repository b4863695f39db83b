//! Where slabs are to be low.

use super::*;

#[test]
fn slabs_are_low_that_have_a_part_where_they_are_to_be() {
    let low = LowSlabs(10.0, 20.0, 2.0);
    assert_eq!(low.ends(), [10.0, 20.0]);
    for (from, to) in [(9.0, 10.5), (10.0, 20.0), (12.0, 13.0), (19.9, 25.0), (5.0, 30.0)] {
        assert_eq!(low.most(from, to), 2.0, "{from} to {to}");
    }
    for (from, to) in [(5.0, 9.0), (8.0, 10.0), (20.0, 22.0), (25.0, 30.0)] {
        assert_eq!(low.most(from, to), f64::INFINITY, "{from} to {to}");
    }
}
