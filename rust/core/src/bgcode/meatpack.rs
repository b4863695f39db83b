//! `MeatPack`: two of the fifteen characters that G-code mostly consists of in a byte.
//!
//! The lower half of a byte is the first character. The half 15 stands for a character that is not in
//! the table and follows whole; where both are, both follow. Two bytes of 255 precede an order.

/// The characters of the halves 0 to 14.
const TABLE: [u8; 15] = *b"0123456789. \nGX";
/// The half of which the character follows.
const FOLLOWS: u8 = 15;
/// The half that is a space, or an E where spaces are left out.
const SPACE: u8 = 11;
const ORDER: u8 = 0xff;

/// Unpacks what one stream holds.
pub fn unpacked(packed: &[u8]) -> Vec<u8> {
    let mut text = Vec::with_capacity(packed.len() * 2);
    let (mut packing, mut spaceless) = (false, false);
    let mut bytes = packed.iter().copied().peekable();
    while let Some(byte) = bytes.next() {
        if byte == ORDER && bytes.peek() == Some(&ORDER) {
            bytes.next();
            match bytes.next() {
                Some(251) => packing = true,
                Some(250) => packing = false,
                Some(249) => (packing, spaceless) = (false, false),
                Some(247) => spaceless = true,
                Some(246) => spaceless = false,
                _ => {}
            }
        } else if packing {
            let halves = [byte & 15, byte >> 4].map(|half| match half {
                FOLLOWS => None,
                SPACE if spaceless => Some(b'E'),
                half => TABLE.get(usize::from(half)).copied(),
            });
            match halves {
                [Some(first), Some(second)] => text.extend([first, second]),
                // The whole character comes next whichever half it is.
                [Some(first), None] => text.extend([first].into_iter().chain(bytes.next())),
                [None, Some(second)] => text.extend(bytes.next().into_iter().chain([second])),
                [None, None] => text.extend(bytes.by_ref().take(2)),
            }
        } else {
            text.push(byte);
        }
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    const ON: [u8; 3] = [0xff, 0xff, 251];

    #[test]
    fn halves_stand_for_characters_and_others_follow_whole() {
        let stream =
            [&ON[..], &[0x1d, 0xeb, 0xf5, b'Y', 0x2f, b'-', 0xff, b'F', b'a', 0xcc]].concat();
        assert_eq!(unpacked(&stream), b"G1 X5Y-2Fa\n\n");
    }

    #[test]
    fn orders_turn_packing_and_spaces_off_and_on() {
        let stream =
            [&ON[..], &[0xff, 0xff, 247, 0x1b, 0xff, 0xff, 246, 0x1b], &[0xff, 0xff, 250], b"M0\n"];
        assert_eq!(unpacked(&stream.concat()), b"E1 1M0\n");
        assert_eq!(unpacked(b"plain"), b"plain");
    }

    #[test]
    fn what_ends_within_an_order_or_a_character_ends_there() {
        for stream in [&[0xff, 0xff][..], &[0xff, 0xff, 251, 0x1f], &[0xff, 0xff, 251, 0xff, b'a']]
        {
            assert!(unpacked(stream).len() <= 1);
        }
    }
}
