//! Edge adjacency.

use std::collections::HashMap;

use super::NO_FACE;

/// The face across each edge of each face.
pub fn neighbours(faces: &[[u32; 3]]) -> Vec<[u32; 3]> {
    let mut result = vec![[NO_FACE; 3]; faces.len()];
    let mut open: HashMap<(u32, u32), (usize, usize)> = HashMap::with_capacity(faces.len() * 2);
    for (f, face) in faces.iter().enumerate() {
        for i in 0..3 {
            let (a, b) = (face[i], face[(i + 1) % 3]);
            if let Some((g, j)) = open.remove(&(b, a)) {
                result[f][i] = g as u32;
                result[g][j] = f as u32;
            } else {
                open.insert((a, b), (f, i));
            }
        }
    }
    result
}
