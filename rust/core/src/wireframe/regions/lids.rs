//! What a region's last layer has closed needs no strands of a cap on top.

use glam::DVec2;

use crate::geometry::polygon;

/// The parts of a polyline, at least `least` mm long, that lie within an even number of closed
/// rings.
#[must_use]
pub fn outside(line: &[DVec2], rings: &[Vec<DVec2>], least: f64) -> Vec<Vec<DVec2>> {
    let mut parts: Vec<Vec<DVec2>> = Vec::new();
    let mut open: Vec<DVec2> = Vec::new();
    for pair in line.windows(2) {
        let (from, to) = (pair[0], pair[1]);
        let mut stops: Vec<f64> = rings.iter().flat_map(|ring| crossings(ring, from, to)).collect();
        stops.extend([0.0, 1.0]);
        stops.sort_by(f64::total_cmp);
        for span in stops.windows(2).filter(|span| span[1] > span[0]) {
            let middle = from.lerp(to, f64::midpoint(span[0], span[1]));
            let depth = rings.iter().filter(|ring| polygon::contains(ring, middle)).count();
            if depth % 2 == 1 {
                parts.push(std::mem::take(&mut open));
                continue;
            }
            if open.is_empty() {
                open.push(from.lerp(to, span[0]));
            }
            open.push(from.lerp(to, span[1]));
        }
    }
    parts.push(open);
    parts.retain(|part| part.len() > 1 && polygon::length(part, false) >= least);
    parts
}

/// Where a segment crosses a closed ring, as shares of the segment.
fn crossings(ring: &[DVec2], from: DVec2, to: DVec2) -> impl Iterator<Item = f64> {
    let ends = ring.iter().copied().zip(ring.iter().copied().cycle().skip(1));
    ends.filter_map(move |(a, b)| {
        let (way, side) = (to - from, b - a);
        let across = way.perp_dot(side);
        let share = (a - from).perp_dot(side) / across;
        let along = (a - from).perp_dot(way) / across;
        (across != 0.0 && (0.0..=1.0).contains(&share) && (0.0..=1.0).contains(&along))
            .then_some(share)
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn square(low: f64, high: f64) -> Vec<DVec2> {
        [(low, low), (high, low), (high, high), (low, high)].map(DVec2::from).to_vec()
    }

    #[test]
    fn a_line_is_cut_where_layers_have_closed_the_face() {
        let line = [(-5.0, 2.0), (15.0, 2.0), (15.0, 20.0)].map(DVec2::from);
        let rings = [square(0.0, 10.0), square(4.0, 6.0)];
        let parts = outside(&line, &rings, 1.0);
        assert_eq!(parts.len(), 2);
        assert_eq!(parts[0], [(-5.0, 2.0), (0.0, 2.0)].map(DVec2::from));
        assert_eq!(parts[1], [(10.0, 2.0), (15.0, 2.0), (15.0, 20.0)].map(DVec2::from));
    }

    #[test]
    fn a_hole_in_the_closed_part_keeps_its_strands() {
        let line = [(-5.0, 5.0), (15.0, 5.0)].map(DVec2::from);
        let rings = [square(0.0, 10.0), square(3.0, 7.0)];
        let lengths: Vec<f64> =
            outside(&line, &rings, 1.0).iter().map(|part| polygon::length(part, false)).collect();
        assert_eq!(lengths, [5.0, 4.0, 5.0]);
        assert_eq!(outside(&line, &rings, 4.5).len(), 2);
        assert_eq!(outside(&line, &[], 4.5), [line.to_vec()]);
    }
}
