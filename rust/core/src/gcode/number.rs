//! Plain decimals as G-code writes them, read without a detour over `str`.

/// Powers of ten that an `f64` holds exactly.
const POWERS: [f64; 23] = [
    1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15, 1e16,
    1e17, 1e18, 1e19, 1e20, 1e21, 1e22,
];

/// No word of a file may exceed this: no machine has such figures, and what is computed from them
/// would overflow.
pub(super) const LARGEST: f64 = 1e9;

/// Digits that certainly fit a `u64`.
const MAX_DIGITS: usize = 19;

/// Reads the number at the front of `text`: sign, digits, point, digits. Returns it and its length
/// in bytes, or `None` where there is no digit.
///
/// There is no exponent: to every firmware the `E` of `X1E3` begins the next word. The result is
/// the nearest `f64` up to 15 digits (both the digits and the power of ten are exact, and a
/// division rounds once); digits beyond the nineteenth are read as zeros.
#[inline]
#[must_use]
pub fn decimal(text: &[u8]) -> Option<(f64, usize)> {
    let sign = text.first().copied();
    let signed = matches!(sign, Some(b'-' | b'+'));
    let mut at = usize::from(signed);
    let mut digits: u64 = 0;
    let whole = at;
    while let Some(digit) = digit_at(text, at) {
        digits = digits.wrapping_mul(10).wrapping_add(digit);
        at += 1;
    }
    let mut count = at - whole;
    let mut decimals = 0;
    if text.get(at) == Some(&b'.') {
        at += 1;
        let first = at;
        while let Some(digit) = digit_at(text, at) {
            digits = digits.wrapping_mul(10).wrapping_add(digit);
            at += 1;
        }
        decimals = at - first;
        count += decimals;
    }
    if count == 0 {
        return None;
    }
    let magnitude = if count <= MAX_DIGITS {
        scaled(digits, decimals)
    } else {
        many_digits(text.get(whole..at).unwrap_or_default())
    };
    Some((if sign == Some(b'-') { -magnitude } else { magnitude }, at))
}

#[inline]
fn digit_at(text: &[u8], at: usize) -> Option<u64> {
    let digit = text.get(at)?.wrapping_sub(b'0');
    (digit < 10).then_some(u64::from(digit))
}

#[inline]
#[expect(clippy::cast_precision_loss, reason = "exact up to 15 digits, as documented")]
fn scaled(digits: u64, decimals: usize) -> f64 {
    digits as f64 / POWERS.get(decimals).copied().unwrap_or(f64::INFINITY)
}

/// The rare long number: leading zeros do not count, what follows nineteen digits is dropped.
#[cold]
fn many_digits(text: &[u8]) -> f64 {
    let (mut digits, mut count, mut decimals, mut dropped) = (0_u64, 0, 0, 0_i32);
    let mut fraction = false;
    for &byte in text {
        if byte == b'.' {
            fraction = true;
        } else if count < MAX_DIGITS {
            digits = digits * 10 + u64::from(byte - b'0');
            count += usize::from(digits > 0);
            decimals += usize::from(fraction);
        } else if !fraction {
            dropped = dropped.saturating_add(1);
        }
    }
    scaled(digits, decimals) * 10_f64.powi(dropped)
}
