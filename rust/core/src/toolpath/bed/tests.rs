//! Rings on the bed, measured.

use glam::DVec3;

use super::*;
use crate::geometry::polyline::segment_distance;
use crate::printer::PATH;
use crate::toolpath::BedShape;

/// Strands through points, in one stroke each.
fn strokes(lines: &[&[(f64, f64)]], kind: Kind) -> Vec<Strand> {
    let strand = |pair: &[(f64, f64)]| {
        let [from, to] = [pair[0], pair[1]].map(|(x, y)| DVec3::new(x, y, 0.35));
        Strand { from, to, kind, slab: 0, floating: false, flow: 1.0, direct: false }
    };
    lines.iter().flat_map(|line| line.windows(2).map(strand)).collect()
}

const SQUARE: [(f64, f64); 5] = [(0.0, 0.0), (10.0, 0.0), (10.0, 10.0), (0.0, 10.0), (0.0, 0.0)];

fn refs(strands: &[Strand]) -> Vec<&Strand> {
    strands.iter().collect()
}

/// Least and greatest distance of a ring's corners from the square.
fn off_square(ring: &[DVec2]) -> [f64; 2] {
    let off = ring.iter().map(|&p| {
        let sides = SQUARE.windows(2).map(|s| segment_distance(p, s[0].into(), s[1].into()));
        sides.fold(f64::INFINITY, f64::min)
    });
    off.fold([f64::INFINITY, 0.0], |[low, high], off| [low.min(off), high.max(off)])
}

#[test]
fn a_stroke_of_contours_is_a_loop_if_it_has_three_corners() {
    let triangle = [(20.0, 0.0), (30.0, 0.0), (20.0, 5.0), (20.0, 0.0)];
    let line = [(40.0, 0.0), (50.0, 0.0), (60.0, 0.0)];
    let mut strands = strokes(&[&SQUARE, &triangle, &line], Kind::Contour);
    strands.extend(strokes(&[&[(70.0, 0.0), (80.0, 0.0), (80.0, 9.0), (70.0, 0.0)]], Kind::Cap));
    let found = loops(&refs(&strands));
    let corners = |points: &[(f64, f64)]| -> Vec<DVec2> {
        points[1..].iter().copied().map(DVec2::from).collect()
    };
    let sorted = |mut ring: Vec<DVec2>| {
        ring.sort_by(|a, b| a.x.total_cmp(&b.x).then(a.y.total_cmp(&b.y)));
        ring
    };
    let found: Vec<Vec<DVec2>> = found.into_iter().map(sorted).collect();
    assert_eq!(found, [sorted(corners(&SQUARE)), sorted(corners(&triangle))]);
}

#[test]
fn a_brim_lies_ring_by_ring_a_strand_further_out() {
    let p = PATH;
    let rings = brim(&refs(&strokes(&[&SQUARE], Kind::Contour)), 3, &p);
    assert_eq!(rings.len(), 3);
    for (ring, i) in rings.iter().zip(1..) {
        let [low, high] = off_square(ring);
        let wanted = f64::from(i) * p.strand;
        assert!((low - wanted).abs() < 1e-6 && (high - wanted).abs() < 1e-6, "{low} {high} {i}");
    }
    // What is round a hole is no ring's: a contour within another one adds none.
    let hole: Vec<(f64, f64)> =
        SQUARE.iter().rev().map(|&(x, y)| (0.2 * x + 4.0, 0.2 * y + 4.0)).collect();
    let both = strokes(&[&SQUARE, &hole], Kind::Contour);
    assert_eq!(brim(&refs(&both), 3, &p).len(), 3);
    assert!(brim(&[], 3, &p).is_empty());
}

#[test]
fn a_skirt_lies_around_all_from_outside_in() {
    let p = PathParams { skirt_rings: 3, skirt_gap: 2.5, ..PATH };
    let first = strokes(&[&SQUARE], Kind::Contour);
    // Round corners of the brim are a little nearer than its sides.
    let assert_around = |brim: &[Vec<DVec2>], wanted: [f64; 3]| {
        let rings = skirt(&refs(&first), brim, &p);
        let found: Vec<f64> = rings.iter().map(|ring| off_square(ring)[0]).collect();
        assert_eq!(found.len(), 3);
        assert!(found.iter().zip(wanted).all(|(a, b)| (a - b).abs() < 0.01), "{found:?}");
    };
    assert_around(&[], [3.9, 3.2, 2.5]);
    assert_around(&brim(&refs(&first), 1, &p), [4.6, 3.9, 3.2]);
    // Nothing to go round.
    let line = strokes(&[&[(0.0, 0.0), (9.0, 0.0)]], Kind::Contour);
    assert!(skirt(&refs(&line), &[], &p).is_empty());
}

#[test]
fn rings_that_the_bed_does_not_hold_are_left_out() {
    let plate = |reach: f64| PathParams {
        plate: BedShape::Rectangle(DVec2::splat(reach)),
        skirt_rings: 2,
        skirt_gap: 2.0,
        ..PATH
    };
    let first = strokes(&[&SQUARE], Kind::Contour);
    let count = |reach: f64| {
        let p = plate(reach);
        [brim(&refs(&first), 2, &p).len(), skirt(&refs(&first), &[], &p).len()]
    };
    // The square's farthest corner lies 10 mm off the middle.
    assert_eq!(count(10.5), [0, 0]);
    assert_eq!(count(11.0), [1, 0]);
    assert_eq!(count(12.1), [2, 1]);
    assert_eq!(count(13.0), [2, 2]);
}

#[test]
fn a_hull_is_as_wide_as_its_narrowest_side_on() {
    let hull = |points: &[(f64, f64)]| -> Vec<DVec2> {
        points.iter().map(|&p| DVec2::from_angle(0.3).rotate(DVec2::from(p))).collect()
    };
    let rectangle = hull(&[(0.0, 0.0), (30.0, 0.0), (30.0, 12.0), (0.0, 12.0)]);
    let triangle = hull(&[(0.0, 0.0), (40.0, 0.0), (20.0, 7.0)]);
    assert!((width(&rectangle) - 12.0).abs() < 1e-9 && (width(&triangle) - 7.0).abs() < 1e-9);
    assert_eq!(width(&[]), 0.0);
}

#[test]
fn a_foot_too_small_for_the_height_gets_as_many_rings_as_it_lacks() {
    let first = strokes(&[&SQUARE], Kind::Contour);
    let told = |height: f64, asked: Option<u32>| {
        rings(&refs(&first), height, &PathParams { brim_rings: asked, ..PATH })
    };
    // A quarter of the height, in rings that widen it by two strands each.
    assert_eq!([39.0, 40.0, 41.0, 46.0, 60.0, 500.0].map(|z| told(z, None)), [0, 0, 1, 2, 4, 10]);
    assert_eq!((told(500.0, Some(3)), told(10.0, Some(0))), (3, 0));
}
