//! What makes two corners one vertex: the very same coordinates.

use glam::DVec3;

/// The bits of a point's coordinates, with −0 stored as 0.
pub trait VertexKey: Copy + Eq + Send + Sync {
    /// A hash whose high and low bits are both well mixed.
    fn hash(self) -> u64;
    /// The point.
    fn point(self) -> DVec3;
}

fn mix(a: u64, b: u64, c: u64) -> u64 {
    // Odd constants of the golden ratio and of murmur3's finaliser.
    let sum = (a.wrapping_mul(0x9E37_79B9_7F4A_7C15).rotate_left(23) ^ b)
        .wrapping_mul(0xFF51_AFD7_ED55_8CCD)
        .rotate_left(29)
        ^ c;
    let hash = sum.wrapping_mul(0xC4CE_B9FE_1A85_EC53);
    (hash ^ (hash >> 32)).wrapping_mul(0x9E37_79B9_7F4A_7C15)
}

impl VertexKey for [u32; 3] {
    fn hash(self) -> u64 {
        mix(self[0].into(), self[1].into(), self[2].into())
    }
    fn point(self) -> DVec3 {
        DVec3::from(self.map(|bits| f64::from(f32::from_bits(bits))))
    }
}

impl VertexKey for [u64; 3] {
    fn hash(self) -> u64 {
        mix(self[0], self[1], self[2])
    }
    fn point(self) -> DVec3 {
        DVec3::from(self.map(f64::from_bits))
    }
}
