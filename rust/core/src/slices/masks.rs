//! Buffers that tasks hand on to each other.

use std::sync::{Mutex, PoisonError};

/// Masks over all faces, zero when not in use, handed from task to task.
pub struct Masks {
    idle: Mutex<Vec<Vec<u32>>>,
    faces: usize,
}

impl Masks {
    /// None yet, for so many faces.
    pub fn new(faces: usize) -> Self {
        Self { idle: Mutex::new(Vec::new()), faces }
    }

    /// A mask that was put back, or another one.
    pub fn take(&self) -> Vec<u32> {
        let idle = self.idle.lock().unwrap_or_else(PoisonError::into_inner).pop();
        idle.unwrap_or_else(|| vec![0; self.faces])
    }

    /// Hands a mask on, which is zero again.
    pub fn put_back(&self, mask: Vec<u32>) {
        self.idle.lock().unwrap_or_else(PoisonError::into_inner).push(mask);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_mask_that_was_put_back_is_the_next_one_taken() {
        let masks = Masks::new(5);
        let (mut one, other) = (masks.take(), masks.take());
        assert_eq!((&one, &other), (&vec![0; 5], &vec![0; 5]));
        // Told from a new one by its room.
        one.reserve_exact(95);
        let room = one.capacity();
        masks.put_back(one);
        assert_eq!((masks.take().capacity(), masks.take().capacity()), (room, 5));
    }
}
