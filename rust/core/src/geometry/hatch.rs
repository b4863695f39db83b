//! Parallel lines through a horizontal region.

use glam::DVec2;

/// The lines of one row, from left to right.
pub type Row = Vec<[DVec2; 2]>;

/// Least and greatest of some numbers.
pub fn extent(values: impl Iterator<Item = f64>) -> (f64, f64) {
    values.fold((f64::INFINITY, f64::NEG_INFINITY), |m, v| (m.0.min(v), m.1.max(v)))
}

/// Distances from the origin at which rows lie evenly, about `spacing` apart, between two others
/// and away from both.
#[must_use]
pub fn between(low: f64, high: f64, spacing: f64) -> Vec<f64> {
    let count = ((high - low) / spacing - 0.2).ceil().max(0.0);
    let pitch = (high - low) / (count + 1.0);
    (1..=count as usize).map(|i| low + pitch * i as f64).collect()
}

/// Distances from the origin in the middle of even parts, two at least and about `spacing` wide, of
/// the way from one to another.
#[must_use]
pub fn middles(low: f64, high: f64, spacing: f64) -> Vec<f64> {
    let count = ((high - low) / spacing).ceil().max(2.0);
    (0..count as usize).map(|k| low + (high - low) * (k as f64 + 0.5) / count).collect()
}

/// The parts within an odd number of rims of each of the lines at these distances from the origin,
/// which ascend; each row from left to right.
#[must_use]
pub fn lines(rims: &[Vec<DVec2>], along: DVec2, levels: &[f64]) -> Vec<Row> {
    let across = along.perp();
    let mut hits: Vec<Vec<f64>> = vec![Vec::new(); levels.len()];
    for rim in rims {
        let ends = rim.iter().zip(rim.iter().cycle().skip(1));
        for (&a, &b) in ends {
            let (ha, hb) = (a.dot(across), b.dot(across));
            // A vertex on a line counts as above it.
            let first = levels.partition_point(|level| *level <= ha.min(hb));
            let crossed = levels[first..].iter().take_while(|level| **level <= ha.max(hb));
            for (hits, level) in hits[first..].iter_mut().zip(crossed) {
                let (da, db) = (ha - level, hb - level);
                hits.push(a.lerp(b, da / (da - db)).dot(along));
            }
        }
    }
    let row = |(mut hits, level): (Vec<f64>, &f64)| -> Row {
        hits.sort_by(f64::total_cmp);
        let ends = hits.chunks_exact(2);
        ends.map(|x| [along * x[0] + across * *level, along * x[1] + across * *level]).collect()
    };
    hits.into_iter().zip(levels).map(row).collect()
}

/// Joins lines of successive rows to and fro where their near ends lie within `reach` mm.
#[must_use]
pub fn join(rows: Vec<Row>, along: DVec2, reach: f64) -> Vec<Vec<DVec2>> {
    let mut done: Vec<Vec<DVec2>> = Vec::new();
    let mut open: Vec<Vec<DVec2>> = Vec::new();
    for row in rows {
        let mut next: Vec<Vec<DVec2>> = Vec::new();
        for line in row {
            let near = |chain: &Vec<DVec2>| {
                let end = chain[chain.len() - 1];
                // The chain ends on the side to which its last line ran.
                let rightward = (end - chain[chain.len() - 2]).dot(along) > 0.0;
                let entry = if rightward { line[1] } else { line[0] };
                (end.distance(entry), entry)
            };
            let found = (0..open.len())
                .map(|i| (near(&open[i]).0, i))
                .filter(|(d, _)| *d <= reach)
                .min_by(|a, b| a.0.total_cmp(&b.0));
            let chain = match found {
                Some((_, i)) => {
                    let mut chain = open.remove(i);
                    let entry = near(&chain).1;
                    let exit = if entry == line[0] { line[1] } else { line[0] };
                    chain.extend([entry, exit]);
                    chain
                }
                None => line.to_vec(),
            };
            next.push(chain);
        }
        done.append(&mut open);
        open = next;
    }
    done.append(&mut open);
    done
}

#[cfg(test)]
mod tests;
