//! The time of one move.

/// The lesser of two numbers: one instruction, since neither is NaN.
#[inline]
pub(super) fn lesser(a: f64, b: f64) -> f64 {
    if a < b { a } else { b }
}

/// The greater of two numbers, likewise.
#[inline]
pub(super) fn greater(a: f64, b: f64) -> f64 {
    if a > b { a } else { b }
}

/// Time of a move of length `length_d` that enters at `√entry_v2`, cruises at `√cruise_v2` and
/// leaves at `√exit_v2`, changing speed at `accel`, s.
///
/// `t = (2c − u − w)/a + (d − (2c² − u² − w²)/(2a))/c`
#[inline]
pub(super) fn duration(
    length_d: f64,
    accel: f64,
    entry_v2: f64,
    cruise_v2: f64,
    exit_v2: f64,
) -> f64 {
    if cruise_v2 <= 0.0 {
        return 0.0;
    }
    // Two divisions in place of three: the parts in a and in c are brought together.
    let cruise_v = cruise_v2.sqrt();
    let per_cruise_v = 1.0 / cruise_v;
    let changing_v = 2.0 * cruise_v - entry_v2.sqrt() - exit_v2.sqrt();
    let changing_v2 = 2.0 * cruise_v2 - entry_v2 - exit_v2;
    (changing_v - changing_v2 * per_cruise_v / 2.0) / accel + length_d * per_cruise_v
}

/// Squared speed at which acceleration meets deceleration where there is no room to cruise.
#[inline]
pub(super) fn peak_v2(length_d: f64, accel: f64, entry_v2: f64, exit_v2: f64) -> f64 {
    accel * length_d + (entry_v2 + exit_v2) / 2.0
}
