//! Straight strands that close a horizontal region from rim to rim.

use glam::DVec2;

/// Directions tried for the lines; the one with the shortest longest line wins.
const DIRECTIONS: usize = 8;

/// The lines of one row, from left to right.
type Row = Vec<[DVec2; 2]>;

/// Parallel lines, `spacing` mm apart, through the region that lies within an odd number of the
/// `rims` (closed polygons). Each run of lines that can be drawn in one stroke, to and fro, is
/// one polyline whose points all lie on the rims. Lines longer than `longest` mm, and those with
/// an end that is not `held`, are left out; the second value is the length left out, mm.
#[must_use]
pub fn hatch(
    rims: &[Vec<DVec2>],
    spacing: f64,
    longest: f64,
    held: impl Fn(DVec2) -> bool,
) -> (Vec<Vec<DVec2>>, f64) {
    let mut best: Option<(f64, DVec2, Vec<Row>)> = None;
    for i in 0..DIRECTIONS {
        let angle = std::f64::consts::PI * i as f64 / DIRECTIONS as f64;
        let along = DVec2::from_angle(angle);
        let rows = rows(rims, along, spacing);
        let span = rows.iter().flatten().map(|l| l[0].distance(l[1])).fold(0.0, f64::max);
        // A hair's preference for the first direction keeps symmetric shapes stable.
        if best.as_ref().is_none_or(|b| span < b.0 - 1e-6) {
            best = Some((span, along, rows));
        }
    }
    let Some((_, along, mut rows)) = best else { return (Vec::new(), 0.0) };
    let mut dropped = 0.0;
    for row in &mut rows {
        row.retain(|l| {
            let length = l[0].distance(l[1]);
            let keep = length <= longest && l.iter().all(|&end| held(end));
            if !keep {
                dropped += length;
            }
            keep
        });
    }
    (join(rows, along, 2.0 * spacing), dropped)
}

/// Lines from rim to rim, `spacing` mm apart, across the place of a figure within the rims. None
/// where in no direction all of them, two at least, are within `longest` mm and `held` at both
/// ends.
#[must_use]
pub fn bridges(
    rims: &[Vec<DVec2>],
    figure: &[DVec2],
    spacing: f64,
    longest: f64,
    held: impl Fn(DVec2) -> bool,
) -> Option<Vec<[DVec2; 2]>> {
    let mut best: Option<(f64, Row)> = None;
    for i in 0..DIRECTIONS {
        let along = DVec2::from_angle(std::f64::consts::PI * i as f64 / DIRECTIONS as f64);
        let across = along.perp();
        let (low, high) = extent(figure.iter().map(|p| p.dot(across)));
        let (left, right) = extent(figure.iter().map(|p| p.dot(along)));
        let count = (((high - low) / spacing).ceil() as usize).max(2);
        let row = |k: usize| {
            let level = low + (high - low) * (k as f64 + 0.5) / count as f64;
            lines(rims, along, &[level])
                .into_iter()
                .flatten()
                .find(|l| l[0].dot(along) < right && l[1].dot(along) > left)
        };
        let Some(found) = (0..count).map(row).collect::<Option<Row>>() else { continue };
        let span = found.iter().map(|l| l[0].distance(l[1])).fold(0.0, f64::max);
        let all_held = || found.iter().flatten().all(|&end| held(end));
        if span <= longest && all_held() && best.as_ref().is_none_or(|b| span < b.0 - 1e-6) {
            best = Some((span, found));
        }
    }
    best.map(|(_, lines)| lines)
}

/// Least and greatest of some numbers.
fn extent(values: impl Iterator<Item = f64>) -> (f64, f64) {
    values.fold((f64::INFINITY, f64::NEG_INFINITY), |m, v| (m.0.min(v), m.1.max(v)))
}

/// The lines of each row, from left to right along the direction.
fn rows(rims: &[Vec<DVec2>], along: DVec2, spacing: f64) -> Vec<Row> {
    let across = along.perp();
    let (low, high) = extent(rims.iter().flatten().map(|p| p.dot(across)));
    if high.partial_cmp(&low) != Some(std::cmp::Ordering::Greater) {
        return Vec::new();
    }
    // Rows at even distances from each other and from the region's ends.
    let count = ((high - low) / spacing - 0.2).ceil().max(0.0);
    let pitch = (high - low) / (count + 1.0);
    let levels: Vec<f64> = (1..=count as usize).map(|i| low + pitch * i as f64).collect();
    let mut rows = lines(rims, along, &levels);
    for row in &mut rows {
        row.retain(|l| l[0].distance(l[1]) > 0.25 * spacing);
    }
    rows
}

/// The parts within an odd number of rims of each of the lines at these distances from the origin,
/// which ascend.
fn lines(rims: &[Vec<DVec2>], along: DVec2, levels: &[f64]) -> Vec<Row> {
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
fn join(rows: Vec<Row>, along: DVec2, reach: f64) -> Vec<Vec<DVec2>> {
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
mod tests {
    use super::*;

    fn square(side: f64) -> Vec<DVec2> {
        [(0.0, 0.0), (side, 0.0), (side, side), (0.0, side)].map(DVec2::from).to_vec()
    }

    #[test]
    fn a_square_is_closed_in_one_stroke() {
        let (lines, dropped) = hatch(&[square(28.0)], 6.0, 65.0, |_| true);
        assert_eq!(lines.len(), 1);
        assert_eq!(dropped, 0.0);
        assert!(lines[0].len() >= 8);
    }

    #[test]
    fn a_hole_is_left_open() {
        let hole: Vec<DVec2> = square(8.0).into_iter().map(|p| p + 10.0).rev().collect();
        let (lines, _) = hatch(&[square(28.0), hole], 3.0, 65.0, |_| true);
        for line in lines.iter().flat_map(|l| l.windows(2)) {
            let middle = (line[0] + line[1]) * 0.5;
            assert!(!(middle - 14.0).abs().cmplt(DVec2::splat(3.9)).all());
        }
    }

    #[test]
    fn no_line_ends_where_nothing_holds_it() {
        let (lines, dropped) = hatch(&[square(28.0)], 6.0, 65.0, |end| end.x > 0.1);
        assert!(lines.iter().flatten().all(|end| end.x > 0.1));
        assert!(dropped > 0.0);
    }

    #[test]
    fn lines_beyond_the_span_are_reported() {
        let (lines, dropped) = hatch(&[square(100.0)], 10.0, 65.0, |_| true);
        assert!(lines.iter().flat_map(|l| l.windows(2)).all(|w| w[0].distance(w[1]) <= 65.0));
        assert!(dropped > 0.0);
    }
}
