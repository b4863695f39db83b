//! Numbers with a fixed count of decimals, as text; several times faster than `format!`.

/// All pairs of digits: two are written at a time.
const PAIRS: [[u8; 2]; 100] = {
    let mut pairs = [[0; 2]; 100];
    let mut n = 0;
    while n < 100 {
        pairs[n] = [b'0' + (n / 10) as u8, b'0' + (n % 10) as u8];
        n += 1;
    }
    pairs
};

/// Room for the digits of any `u64`, its point and leading zeros.
const ROOM: usize = 40;

/// Appends `value` · 10^-`decimals` (at most 18) with all its decimals. Zero has no sign.
pub fn push(out: &mut Vec<u8>, value: i64, decimals: u32) {
    // The compiler turns division by a constant into multiplication.
    match decimals {
        0 => push_with(out, value, 0),
        3 => push_with(out, value, 3),
        5 => push_with(out, value, 5),
        other => push_with(out, value, other.min(18)),
    }
}

#[inline(always)]
fn push_with(out: &mut Vec<u8>, value: i64, decimals: u32) {
    if value < 0 {
        out.push(b'-');
    }
    let one = 10_u64.pow(decimals);
    let magnitude = value.unsigned_abs();
    let mut room = [b'0'; ROOM];
    let start = if decimals == 0 {
        digits(&mut room, ROOM, magnitude, 1)
    } else {
        let point = digits(&mut room, ROOM, magnitude % one, decimals as usize) - 1;
        room[point] = b'.';
        digits(&mut room, point, magnitude / one, 1)
    };
    out.extend_from_slice(&room[start..]);
}

/// Writes `value` so that it ends before `end`, with at least `width` digits; returns its start.
fn digits(room: &mut [u8; ROOM], end: usize, mut value: u64, width: usize) -> usize {
    let mut start = end;
    while value >= 10 {
        start -= 2;
        let pair = PAIRS[(value % 100) as usize];
        room[start] = pair[0];
        room[start + 1] = pair[1];
        value /= 100;
    }
    if value > 0 {
        start -= 1;
        room[start] = b'0' + value as u8;
    }
    // What lies before is zeros already.
    start.min(end - width)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn text(value: i64, decimals: u32) -> String {
        let mut out = Vec::new();
        push(&mut out, value, decimals);
        String::from_utf8(out).unwrap()
    }

    #[test]
    fn numbers_have_all_their_decimals() {
        assert_eq!(text(0, 3), "0.000");
        assert_eq!(text(5, 3), "0.005");
        assert_eq!(text(-5, 3), "-0.005");
        assert_eq!(text(123_456, 3), "123.456");
        assert_eq!(text(-100_000, 5), "-1.00000");
        assert_eq!(text(1800, 0), "1800");
        assert_eq!(text(i64::MIN, 0), i64::MIN.to_string());
        assert_eq!(text(i64::MAX, 18), "9.223372036854775807");
    }

    #[test]
    fn the_text_is_what_format_gives() {
        let mut value: i64 = 1;
        for step in 0..2_000_i64 {
            value = value.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(step);
            let small = value >> (step % 60);
            for decimals in [0, 1, 2, 3, 5, 9] {
                let one = 10_i64.pow(decimals);
                let sign = if small < 0 { "-" } else { "" };
                let (whole, part) =
                    (small.unsigned_abs() / one as u64, small.unsigned_abs() % one as u64);
                let expected = if decimals == 0 {
                    format!("{sign}{whole}")
                } else {
                    format!("{sign}{whole}.{part:0width$}", width = decimals as usize)
                };
                assert_eq!(text(small, decimals), expected);
            }
        }
    }
}
