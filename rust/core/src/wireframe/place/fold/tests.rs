//! Where thin contours turn back, and what their sides are.

#![allow(clippy::unwrap_used, reason = "a test may panic")]

use glam::DVec2;

use super::*;

/// A closed contour round a centre line, `thick` mm thick.
fn around(line: &[(f64, f64)], thick: f64) -> Curve {
    let line: Vec<DVec2> = line.iter().copied().map(DVec2::from).collect();
    let way = |i: usize| (line[i + 1] - line[i]).normalize();
    let aside = |i: usize| {
        let [before, behind] = [i.saturating_sub(1), i.min(line.len() - 2)].map(way);
        let normal = (before + behind).normalize().perp();
        normal * (0.5 * thick / normal.dot(behind.perp()))
    };
    let left = (0..line.len()).map(|i| line[i] + aside(i));
    let right = (0..line.len()).rev().map(|i| line[i] - aside(i));
    Curve::new(&left.chain(right).collect::<Vec<_>>(), true).unwrap()
}

fn arc(radius: f64, degrees: i32) -> Vec<(f64, f64)> {
    let at = |i: i32| DVec2::from_angle(f64::from(i).to_radians()) * radius;
    (0..=degrees).step_by(5).map(|i| at(i).into()).collect()
}

#[test]
fn plates_hooks_and_arcs_turn_back_at_both_ends() {
    let shapes = [
        vec![(0.0, 0.0), (60.0, 0.0)],
        vec![(0.0, 0.0), (40.0, 0.0), (40.0, 30.0)],
        vec![(0.0, 0.0), (40.0, 0.0), (40.0, 25.0), (0.0, 25.0)],
        arc(20.0, 300),
    ];
    for (shape, thick) in shapes.iter().flat_map(|shape| [0.4, 2.0, 4.0].map(|t| (shape, t))) {
        let curve = around(shape, thick);
        let tips = tips(&curve, 4.5).unwrap();
        let ends = [shape[0], shape[shape.len() - 1]].map(DVec2::from);
        for end in ends {
            let nearest = tips.map(|tip| curve.position(tip).distance(end));
            assert!(nearest[0].min(nearest[1]) < 2.2, "{shape:?} {thick} {tips:?}");
        }
        let [one, other] = sides(&curve, tips, 4.5).unwrap();
        let along = one.length() + other.length();
        assert!((along - curve.length()).abs() < 1e-6, "{along}");
        let apart =
            |one: Option<&DVec2>, other: Option<&DVec2>| one.unwrap().distance(*other.unwrap());
        assert!(apart(one.points().first(), other.points().first()) < 1e-9);
        assert!(apart(one.points().last(), other.points().last()) < 1e-9);
    }
}

#[test]
fn blocks_rings_and_crossings_are_no_thin_walls() {
    let cross = [(-2.0, -30.0), (2.0, -30.0), (2.0, -2.0), (30.0, -2.0), (30.0, 2.0), (2.0, 2.0)];
    let cross = cross.iter().flat_map(|&(x, y)| [DVec2::new(x, y), DVec2::new(-y, x)]);
    let cross: Vec<DVec2> = {
        let mut points: Vec<DVec2> = cross.collect();
        points.sort_by(|a, b| a.y.atan2(a.x).total_cmp(&b.y.atan2(b.x)));
        points
    };
    let contours = [
        Curve::new(&cross, true).unwrap(),
        around(&[(0.0, 0.0), (60.0, 0.0)], 8.0),
        Curve::new(&arc(30.0, 355).into_iter().map(DVec2::from).collect::<Vec<_>>(), true).unwrap(),
        // As thin as can be, but no longer than thick.
        around(&[(0.0, 0.0), (5.0, 0.0)], 4.0),
        Curve::new(&[DVec2::ZERO, DVec2::X * 50.0], false).unwrap(),
    ];
    for curve in &contours {
        assert_eq!(tips(curve, 4.5), None);
    }
    // Two tips do not make a thin wall of a lens.
    let lens = around(&[(0.0, 0.0), (60.0, 0.0)], 4.0);
    let round: Vec<DVec2> = lens.points().iter().map(|&p| DVec2::new(p.x, p.y * 6.0)).collect();
    let [a, b] =
        [0.0, 60.0].map(|x| Curve::new(&round, true).unwrap().nearest(DVec2::new(x, 0.0)).s);
    assert!(sides(&Curve::new(&round, true).unwrap(), [a, b], 4.5).is_none());
}

#[test]
fn the_share_near_another_curve_is_counted_along_it() {
    // Of a square's four sides, of 40 mm each, one lies 3 mm from a long wall.
    let own = around(&[(-20.0, 0.0), (20.0, 0.0)], 40.0);
    let wall = |x: f64| around(&[(x + 20.0, -90.0), (x + 20.0, 90.0)], 40.0);
    for (x, reach, share) in [(23.0, 3.5, 0.25), (23.0, 2.5, 0.0), (23.0, 23.1, 0.75 - 0.25)] {
        let found = share_near(&own, &wall(x), reach);
        // Within 23.1 mm lie that side, and half of the two beside it.
        assert!((found - share).abs() < 0.05, "{found} is not {share}");
    }
    assert_eq!(share_near(&own, &own, 0.1), 1.0);
}

#[test]
fn a_plate_turns_back_in_the_middle_of_its_ends_if_it_is_long_and_thin_enough() {
    let reach = 4.0;
    for (long, thick) in [(60.0, 1.0), (60.0, 4.0), (25.0, 4.1), (11.1, 1.0), (33.3, 3.0)] {
        let plate = around(&[(0.0, 0.0), (long, 0.0)], thick);
        let found = tips(&plate, reach).unwrap().map(|tip| plate.position(tip));
        let off = |end: DVec2| found[0].distance(end).min(found[1].distance(end));
        // As near as the places lie that are looked at.
        let step = reach / LOOKS;
        assert!(off(DVec2::ZERO) <= step && off(DVec2::X * long) <= step, "{long} {thick}");
        assert!(found[0].distance(found[1]) > long - 0.5 * thick, "{found:?}");
    }
    let found = |long: f64, thick: f64| tips(&around(&[(0.0, 0.0), (long, 0.0)], thick), reach);
    // Its sides are nearer to each other than a wall's thickness and some slack, or not.
    assert!(found(60.0, 4.0).is_some() && found(60.0, 4.21).is_none());
    // All around it is as long as both tips take to turn, or shorter.
    assert!(found(11.01, 1.0).is_some() && found(10.99, 1.0).is_none());
    // Three ends are one too many.
    let y = [0.0_f64, 120.0, 240.0].iter().flat_map(|turn| {
        let way = DVec2::from_angle(turn.to_radians());
        let [end, crotch] = [way * 30.0, DVec2::from_angle((turn + 60.0).to_radians()) * 2.0];
        [end - way.perp(), end + way.perp(), crotch]
    });
    assert_eq!(tips(&Curve::new(&y.collect::<Vec<_>>(), true).unwrap(), reach), None);
}

#[test]
fn wherever_a_contour_begins_its_tips_are_the_same() {
    let hook = around(&[(0.0, 0.0), (40.0, 0.0), (40.0, 30.0)], 3.0);
    let ends = [DVec2::ZERO, DVec2::new(40.0, 30.0)];
    for shift in 0..30 {
        let begin = hook.length() * f64::from(shift) / 30.0;
        let points = hook.arc(begin, hook.length());
        let turned = Curve::new(&points, true).unwrap();
        let [one, two] = tips(&turned, 4.0).unwrap().map(|tip| turned.position(tip));
        let far = |a: DVec2, b: DVec2| a.distance(ends[0]).max(b.distance(ends[1]));
        assert!(far(one, two).min(far(two, one)) < 1.1, "{shift}: {one} {two}");
    }
}

#[test]
fn sides_are_a_thin_walls_where_half_of_each_is_near_the_other() {
    // A plate whose second half widens: near for the length of `even`.
    let wedge = |even: f64| {
        let outline = [(0.0, 0.0), (even, 0.0), (40.0, -6.0), (40.0, 9.0), (even, 3.0), (0.0, 3.0)];
        let curve = Curve::new(&outline.map(DVec2::from), true).unwrap();
        let ends = [(0.0, 1.5), (40.0, 1.5)].map(|p| curve.nearest(p.into()).s);
        sides(&curve, ends, 3.5).is_some()
    };
    assert!(wedge(30.0) && wedge(22.0) && !wedge(17.0) && !wedge(5.0));
}

#[test]
fn places_just_within_reach_are_near() {
    let line = |from: (f64, f64), to: (f64, f64)| {
        Curve::new(&[DVec2::from(from), DVec2::from(to)], false).unwrap()
    };
    let own = line((0.0, 0.0), (10.0, 0.0));
    // Ten places, of which those at 0 to 4 lie below the other line, and 5 beside it.
    assert_eq!(share_near(&own, &line((0.0, 2.0), (4.5, 2.0)), 2.0), 0.5);
    assert_eq!(share_near(&own, &line((0.0, 2.0), (5.0, 2.0)), 2.0), 0.6);
    assert_eq!(share_near(&own, &line((0.0, 2.1), (5.0, 2.1)), 2.0), 0.0);
    // Eight places at least.
    let short = line((0.0, 0.0), (1.0, 0.0));
    assert_eq!(share_near(&short, &line((0.0, 2.0), (0.3, 2.0)), 2.0), 3.0 / 8.0);
}

#[test]
fn a_side_that_leads_away_from_the_other_makes_no_thin_wall() {
    // A straight side, all of it near the other one, which goes round a bay on its way.
    let bay = |deep: f64| {
        let other = [(40.0, 3.0), (25.0, 3.0), (25.0, deep), (15.0, deep), (15.0, 3.0), (0.0, 3.0)];
        let outline: Vec<DVec2> =
            [(0.0, 0.0), (40.0, 0.0)].into_iter().chain(other).map(DVec2::from).collect();
        let curve = Curve::new(&outline, true).unwrap();
        let ends = [(0.0, 1.5), (40.0, 1.5)].map(|p| curve.nearest(p.into()).s);
        let swapped = [ends[1], ends[0]];
        [ends, swapped].map(|ends| sides(&curve, ends, 3.5).is_some())
    };
    assert_eq!((bay(10.0), bay(30.0)), ([true; 2], [false; 2]));
}
