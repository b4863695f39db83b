//! Stage 5: what the head does with strands, against plain expectations.

mod printer;

use glam::{DVec2, DVec3};
use printer::PATH as PARAMS;
use proptest::prelude::*;
use wireprint_core::climb::Climb;
use wireprint_core::strand::{Kind, Strand};
use wireprint_core::toolpath::{
    BedShape, CoolingMethod, PathParams, PressureAdvance, Strategy as Holding, Toolpath, toolpath,
};

fn strand(from: [f64; 3], to: [f64; 3], kind: Kind) -> Strand {
    Strand {
        from: from.into(),
        to: to.into(),
        kind,
        slab: 0,
        floating: kind == Kind::Post,
        flow: 1.0,
        direct: false,
    }
}

fn strands_along(points: &[[f64; 3]], kind: Kind) -> Vec<Strand> {
    points.windows(2).map(|pair| strand(pair[0], pair[1], kind)).collect()
}

/// A square on the bed, a zigzag over one of its sides, and the contour through its peaks, bent in
/// the middle of its last stretch.
fn fence() -> Vec<Strand> {
    let mut all = strands_along(
        &[[0.0, 0.0, 0.35], [20.0, 0.0, 0.35], [20.0, 20.0, 0.35], [0.0, 0.0, 0.35]],
        Kind::Contour,
    );
    for i in 0..3 {
        let x = 8.0 * f64::from(i);
        all.push(strand([x, 0.0, 0.35], [x, 0.0, 6.0], Kind::Post));
        if i < 2 {
            all.push(strand([x, 0.0, 6.0], [x + 8.0, 0.0, 0.35], Kind::Diagonal));
        }
    }
    let top = [[16.0, 0.0, 6.0], [8.0, 0.0, 6.0], [5.0, 1.0, 6.0], [0.0, 0.0, 6.0]];
    all.extend(strands_along(&top, Kind::Contour));
    all
}

/// One move as the head makes it.
#[derive(Debug, Clone, Copy)]
struct Move {
    from: DVec3,
    to: DVec3,
    kind: Kind,
    speed: f64,
    filament: f64,
    pause: f64,
    air: bool,
}

impl Move {
    fn length(&self) -> f64 {
        self.from.distance(self.to)
    }

    fn is_strand(&self) -> bool {
        !matches!(self.kind, Kind::Travel | Kind::Retract | Kind::Unretract) && self.length() > 0.0
    }
}

fn moves(path: &Toolpath) -> Vec<Move> {
    let mut from = path.start;
    let each = (0..path.to.len()).map(|i| {
        let to = path.to[i];
        Move {
            from: std::mem::replace(&mut from, to),
            to,
            kind: path.kind[i],
            speed: path.speed[i],
            filament: path.filament[i],
            pause: path.pause[i],
            air: path.air[i],
        }
    });
    each.collect()
}

fn plan(strands: &[Strand], p: &PathParams) -> Vec<Move> {
    moves(&toolpath(strands, p))
}

/// Strands that begin anywhere: each other one goes on from the last.
fn anywhere() -> impl Strategy<Value = Vec<Strand>> {
    let place = prop::array::uniform3(0.0..40.0_f64);
    prop::collection::vec((place.clone(), place, any::<bool>()), 2..20).prop_map(|places| {
        let mut strands: Vec<Strand> = Vec::new();
        for (from, to, goes_on) in places {
            let from = strands.last().filter(|_| goes_on).map_or(from, |s| s.to.to_array());
            strands.push(strand(from, to, Kind::Cap));
        }
        strands
    })
}

proptest! {
    #[test]
    fn travels_clear_all_that_stands(strands in anywhere()) {
        let mut top = PARAMS.first_layer;
        for m in plan(&strands, &PARAMS) {
            let sideways = m.from.truncate().distance(m.to.truncate());
            if m.kind == Kind::Travel && sideways > 1e-9 {
                prop_assert!((m.from.z - m.to.z).abs() < 1e-9, "{m:?} is not level");
                prop_assert!(m.from.z >= top + PARAMS.travel_lift - 1e-9, "{m:?} under {top}");
            }
            if m.is_strand() {
                top = top.max(m.from.z).max(m.to.z);
            }
        }
    }

    #[test]
    fn a_travel_goes_with_the_filament_pulled_back(strands in anywhere(), lag in 0.0..0.5_f64) {
        let p = PathParams { pressure_lag: lag, ..PARAMS };
        let (mut back, mut primed) = (0.0_f64, false);
        for m in plan(&strands, &p) {
            match m.kind {
                // Down to the first strand there is nothing yet that could ooze out.
                Kind::Travel if m.length() > 1.0 + p.travel_lift && primed => {
                    prop_assert!((back - p.retract).abs() < 1e-9, "{back} mm back at {m:?}");
                }
                Kind::Retract => back -= m.filament,
                Kind::Unretract => {
                    back -= if primed { m.filament } else { 0.0 };
                    primed = true;
                }
                _ if m.is_strand() => prop_assert!(back.abs() < 1e-9, "{back} mm missing at {m:?}"),
                _ => {}
            }
        }
        prop_assert!((back - p.retract).abs() < 1e-9, "the print ends with {back} mm back");
    }

    #[test]
    fn filament_adds_up(strands in anywhere(), lag in 0.0..0.5_f64, floats in any::<bool>()) {
        let p = PathParams { pressure_lag: lag, ..PARAMS };
        let strands: Vec<Strand> =
            strands.into_iter().map(|s| Strand { floating: floats, ..s }).collect();
        let path = toolpath(&strands, &p);
        let length: f64 = strands.iter().map(|s| s.from.distance(s.to)).sum();
        // A 0.7 mm strand takes 0.16 of its length of 1.75 mm filament. What a first stroke on the
        // bed lacks of the pressure that faster ones want is fed once.
        let melt = 0.16 * length + p.prime - p.retract;
        let slack = lag * 0.16 * p.print_speed;
        let found = path.figures().filament;
        prop_assert!((found - melt).abs() <= slack + 1e-6, "{found} mm fed for {melt}");
    }
}

#[test]
fn short_hops_keep_their_filament() {
    let near = [
        strand([0.0, 0.0, 0.35], [9.0, 0.0, 0.35], Kind::Contour),
        strand([9.5, 0.0, 0.35], [20.0, 0.0, 0.35], Kind::Contour),
    ];
    let kinds: Vec<Kind> = plan(&near, &PARAMS).iter().map(|m| m.kind).collect();
    let last = kinds.iter().rposition(|&kind| kind == Kind::Contour).unwrap();
    assert!(!kinds[..last].contains(&Kind::Retract), "{kinds:?}");
}

#[test]
fn a_pause_ends_every_floating_stroke_and_nothing_else() {
    for m in plan(&fence(), &PARAMS) {
        let expected = if m.kind == Kind::Post { PARAMS.pause } else { 0.0 };
        assert!((m.pause - expected).abs() < 1e-12, "{m:?}");
    }
}

#[test]
fn what_rises_slowly_has_cooled_on_the_way() {
    let pauses = |speed: f64, accel: f64| -> Vec<(f64, f64)> {
        let p = PathParams { climb: Some(Climb { speed, accel }), ..PARAMS };
        let posts = plan(&fence(), &p).into_iter().filter(|m| m.kind == Kind::Post);
        posts.map(|m| (m.pause, m.length())).collect()
    };
    // Six diameters at 5 mm/s in place of 30.
    let late: f64 = 6.0 * 0.7 * (1.0 / 5.0 - 1.0 / 30.0);
    for (pause, _) in pauses(5.0, 1e9) {
        assert!((pause - (PARAMS.pause - late.min(0.5 * PARAMS.pause))).abs() < 1e-6, "{pause}");
    }
    // As fast as it prints, but it must brake: √(2s/a) for the last of the way.
    let late = (2.0 * 4.2 / 100.0_f64).sqrt() - 4.2 / 30.0;
    for (pause, _) in pauses(30.0, 100.0) {
        assert!((pause - (PARAMS.pause - late)).abs() < 1e-9, "{pause}");
    }
    // In between, told by small steps backwards from where it stands: as fast as it may be there.
    for (speed, accel) in [(12.0_f64, 60.0), (20.0, 150.0), (8.0, 400.0), (29.0, 90.0)] {
        let steps = 200_000;
        let step = 6.0 * 0.7 / f64::from(steps);
        let fastest = |i: i32| speed.min((2.0 * accel * (f64::from(i) + 0.5) * step).sqrt());
        let late = (0..steps).map(|i| step / fastest(i) - step / 30.0).sum::<f64>();
        for (pause, _) in pauses(speed, accel) {
            let wanted = PARAMS.pause - late.min(0.5 * PARAMS.pause);
            assert!((pause - wanted).abs() < 1e-3, "{pause}, not {wanted}");
        }
    }
    // No machine waits longer than the strand needs, nor less than half of it.
    for (speed, accel) in [(200.0, 1e5), (30.0, 1e9), (0.1, 1.0)] {
        for (pause, length) in pauses(speed, accel) {
            assert!((0.5 * PARAMS.pause..=PARAMS.pause).contains(&pause), "{pause} {length}");
        }
    }
}

#[test]
fn level_strokes_keep_their_pause_on_a_slow_axis() {
    let mut tie = strand([0.0, 0.0, 6.0], [5.0, 0.0, 6.0], Kind::Cap);
    tie.floating = true;
    let climb = Some(Climb { speed: 5.0, accel: 30.0 });
    let path = plan(&[tie], &PathParams { climb, ..PARAMS });
    let dwells: Vec<f64> = path.iter().map(|m| m.pause).filter(|&s| s > 0.0).collect();
    assert_eq!(dwells, [PARAMS.pause]);
}

#[test]
fn a_slow_head_pauses_nowhere_and_crawls_where_strands_hang() {
    for m in plan(&fence(), &PathParams { strategy: Holding::Slow, ..PARAMS }) {
        let expected = match m.kind {
            Kind::Post | Kind::Diagonal => 5.0,
            Kind::Contour if m.to.z < 1.0 => 20.0,
            Kind::Contour => 30.0,
            _ => continue,
        };
        assert!((m.speed - expected).abs() < 1e-12, "{m:?}");
        assert!(m.pause == 0.0, "{m:?}");
    }
}

#[test]
fn the_air_stops_two_diameters_short_of_what_a_strand_lands_on() {
    let bond = 1.4;
    let mut airy = 0;
    let mut all = fence();
    all.push(strand([0.0, 0.0, 6.0], [16.0, 9.0, 6.0], Kind::Cap));
    let path = plan(&all, &PARAMS);
    for (m, next) in path.iter().zip(path.iter().skip(1).map(Some).chain([None])) {
        if m.is_strand() {
            let on_bed = m.from.z.max(m.to.z) < 1.0;
            let is_bond = !on_bed && (m.length() - bond).abs() < 1e-9;
            assert_eq!(m.air, !on_bed && !is_bond, "{m:?}");
            airy += usize::from(is_bond);
            // Where it goes on with air, it is cut: the rest of the strand is its bond.
            let cut = next.filter(|n| m.air && n.is_strand() && !n.air);
            assert!(cut.is_none_or(|n| n.kind == m.kind && (n.length() - bond).abs() < 1e-9));
        }
    }
    // Two diagonals, the contour at two peaks (not at its bend in between), and the cap.
    assert_eq!(airy, 2 + 2 + 1);
}

#[test]
fn a_contour_goes_on_with_air_where_nothing_lies_below_it() {
    // From a peak to a peak, bent in the air between them; the last one was printed before.
    let mut all = vec![
        strand([20.0, 0.0, 0.35], [20.0, 0.0, 6.0], Kind::Post),
        strand([0.0, 0.0, 0.35], [0.0, 0.0, 6.0], Kind::Post),
    ];
    all.extend(strands_along(&[[0.0, 0.0, 6.0], [9.0, 3.0, 6.0], [20.0, 0.0, 6.0]], Kind::Contour));
    let path = plan(&all, &PARAMS);
    let contour = path.iter().filter(|m| m.kind == Kind::Contour);
    let airy: Vec<bool> = contour.map(|m| m.air).collect();
    assert_eq!(airy, [true, true, false]);
}

#[test]
fn too_short_a_stroke_keeps_its_air() {
    let short = [
        strand([0.0, 0.0, 6.0], [4.0, 0.0, 6.0], Kind::Cap),
        strand([0.0, 5.0, 6.0], [5.0, 5.0, 6.0], Kind::Cap),
    ];
    let path = plan(&short, &PARAMS);
    let strands: Vec<(f64, bool)> =
        path.iter().filter(|m| m.is_strand()).map(|m| (m.length(), m.air)).collect();
    assert_eq!(strands.len(), 3);
    assert_eq!(strands.iter().map(|s| s.1).collect::<Vec<_>>(), [true, true, false]);
}

#[test]
fn a_valve_that_halts_the_head_is_opened_once() {
    let path = plan(&fence(), &PathParams { cooling: CoolingMethod::HaltingValve, ..PARAMS });
    let first = path.iter().position(|m| m.air).unwrap();
    assert!(path[..first].iter().filter(|m| m.is_strand()).all(|m| m.to.z < 1.0));
    assert!(path[first..].iter().all(|m| m.air), "it is closed in mid-air");
}

#[test]
fn a_fan_blows_above_the_bed_and_still_air_never() {
    for (cooling, blows) in [(CoolingMethod::Fan, true), (CoolingMethod::Still, false)] {
        for m in plan(&fence(), &PathParams { cooling, ..PARAMS }) {
            assert!(!m.is_strand() || m.air == (blows && m.from.z.max(m.to.z) > 1.0), "{m:?}");
        }
    }
}

#[test]
fn stacked_layers_bond_without_an_air_jet() {
    let wall = strands_along(&[[0.0, 0.0, 6.0], [9.0, 0.0, 6.0], [9.0, 9.0, 6.0]], Kind::LayerWise);
    for (cooling, blows) in [
        (CoolingMethod::Valve, false),
        (CoolingMethod::HaltingValve, false),
        (CoolingMethod::Fan, true),
    ] {
        let path = plan(&wall, &PathParams { cooling, ..PARAMS });
        assert!(path.iter().filter(|m| m.is_strand()).all(|m| m.air == blows));
    }
}

/// Filament fed in place under a strand's kind, with the place and the pause that follows.
fn fed_in_place(path: &[Move]) -> Vec<(f64, DVec3, f64)> {
    let own = |m: &&Move| !matches!(m.kind, Kind::Travel | Kind::Retract | Kind::Unretract);
    let standing = path.iter().filter(own).filter(|m| m.length() == 0.0);
    standing.map(|m| (m.filament, m.to, m.pause)).collect()
}

#[test]
fn without_pressure_advance_the_nozzle_is_relieved_while_the_head_stands() {
    let p = PathParams { pressure_lag: 0.4, ..PARAMS };
    let path = plan(&fence(), &p);
    // 0.16 mm of filament a mm: 3.2 mm/s on the bed, 4.8 in the air.
    let (bed, full) = (0.4 * 3.2, 0.4 * 4.8);
    let fed = fed_in_place(&path);
    let amounts: Vec<f64> = fed.iter().map(|f| f.0).collect();
    let expected = [full - bed, -full, full, -full, full, -full, full];
    assert_eq!(amounts.len(), expected.len(), "{amounts:?}");
    assert!(amounts.iter().zip(expected).all(|(a, b)| (a - b).abs() < 1e-9), "{amounts:?}");
    for &(amount, at, pause) in &fed {
        if amount < 0.0 {
            assert!((at.z - 6.0).abs() < 1e-9, "it is relieved at a peak");
            // Pulling back, waiting and pushing forward together take the pause.
            let standing = full / p.retract_speed + pause + full / p.unretract_speed;
            assert!((standing - p.pause).abs() < 1e-9, "{standing}");
        }
    }
    assert!(path.iter().filter(|m| m.pause > 0.0).count() == 3);
}

#[test]
fn a_retraction_after_a_dwell_pulls_back_no_more_than_what_is_left() {
    let lone = [
        strand([0.0, 0.0, 0.35], [0.0, 0.0, 6.0], Kind::Post),
        strand([9.0, 0.0, 0.35], [9.0, 0.0, 6.0], Kind::Post),
    ];
    let path = plan(&lone, &PathParams { pressure_lag: 0.4, ..PARAMS });
    let eased = 0.4 * 4.8;
    let retracted: Vec<f64> =
        path.iter().filter(|m| m.kind == Kind::Retract).map(|m| m.filament).collect();
    assert!(retracted.iter().all(|r| (r + PARAMS.retract - eased).abs() < 1e-9), "{retracted:?}");
    assert_eq!(retracted.len(), 2);
}

#[test]
fn however_long_the_lag_the_head_still_dwells() {
    for lag in [1.0, 3.0, 5.0] {
        let path = plan(&fence(), &PathParams { pressure_lag: lag, ..PARAMS });
        let dwells: Vec<f64> = path.iter().map(|m| m.pause).filter(|&s| s > 0.0).collect();
        assert_eq!(dwells.len(), 3);
        assert!(dwells.iter().all(|&s| s >= PARAMS.pause / 2.0 - 1e-12), "{dwells:?}");
    }
}

#[test]
fn firmware_that_advances_pressure_is_left_to_it() {
    let all = PathParams { pressure_lag: 0.4, advance: PressureAdvance::All, ..PARAMS };
    assert!(fed_in_place(&plan(&fence(), &all)).is_empty());
    // Klipper leaves strokes out that move along z alone: those are filled and relieved.
    let sideways = PathParams { advance: PressureAdvance::Sideways, ..all };
    let fed = fed_in_place(&plan(&fence(), &sideways));
    let full = 0.4 * 4.8;
    assert_eq!(fed.len(), 6, "two for each post");
    for pair in fed.chunks(2) {
        assert!((pair[0].0 - full).abs() < 1e-9 && (pair[1].0 + full).abs() < 1e-9, "{fed:?}");
        assert!(pair[0].1.z < 1.0 && pair[1].1.z > 5.0, "{fed:?}");
    }
}

#[test]
fn only_floating_strokes_are_overshot_and_others_neither_pause_nor_go_on() {
    let lone = [
        strand([0.0, 0.0, 6.0], [9.0, 0.0, 6.0], Kind::Cap),
        strand([9.0, 0.0, 6.0], [9.0, 9.0, 6.0], Kind::Cap),
    ];
    for strategy in [Holding::Overshoot, Holding::Pause, Holding::Slow] {
        let path = plan(&lone, &PathParams { strategy, cooling: CoolingMethod::Still, ..PARAMS });
        let kinds: Vec<Kind> = path.iter().map(|m| m.kind).collect();
        let first = kinds.iter().position(|&kind| kind == Kind::Cap).unwrap();
        assert_eq!(kinds[first..], [Kind::Cap, Kind::Cap, Kind::Retract, Kind::Travel]);
        assert!(path.iter().all(|m| m.pause == 0.0));
    }
}

#[test]
fn overshoot_goes_on_without_feeding_and_comes_back() {
    let path = plan(&fence(), &PathParams { strategy: Holding::Overshoot, ..PARAMS });
    let posts: Vec<usize> = (0..path.len()).filter(|&i| path[i].kind == Kind::Post).collect();
    for i in posts {
        let (up, down) = (path[i + 1], path[i + 2]);
        assert!((up.to.z - path[i].to.z - PARAMS.overshoot).abs() < 1e-9);
        assert_eq!(down.to, path[i].to);
        assert!(up.filament == 0.0 && down.filament == 0.0 && path[i].pause == 0.0);
    }
}

/// Distance of a point from a closed ring.
fn distance(ring: &[DVec2], p: DVec2) -> f64 {
    let edges = ring.iter().zip(ring.iter().cycle().skip(1));
    let to_edge = |(&a, &b): (&DVec2, &DVec2)| {
        let along = ((p - a).dot(b - a) / (b - a).length_squared()).clamp(0.0, 1.0);
        p.distance(a.lerp(b, along))
    };
    edges.map(to_edge).fold(f64::INFINITY, f64::min)
}

/// The closed rings of a kind, in the order of printing.
fn rings(path: &[Move], kind: Kind) -> Vec<Vec<DVec2>> {
    let mut rings: Vec<Vec<DVec2>> = Vec::new();
    let mut end = None;
    for m in path.iter().filter(|m| m.kind == kind && m.length() > 0.0) {
        if end != Some(m.from) {
            rings.push(Vec::new());
        }
        if let Some(ring) = rings.last_mut() {
            ring.push(m.to.truncate());
        }
        end = Some(m.to);
    }
    rings
}

fn square(at: f64, side: f64) -> Vec<Strand> {
    let (a, b) = (at, at + side);
    let corners = [[a, a, 0.35], [b, a, 0.35], [b, b, 0.35], [a, b, 0.35], [a, a, 0.35]];
    strands_along(&corners, Kind::Contour)
}

#[test]
fn brim_rings_lie_a_strand_apart_and_a_strand_from_the_contour() {
    let p = PathParams { brim_rings: Some(4), ..PARAMS };
    let path = plan(&square(0.0, 20.0), &p);
    let brim = rings(&path, Kind::Brim);
    let contours = rings(&path, Kind::Contour);
    assert_eq!((brim.len(), contours.len()), (4, 1));
    for (i, ring) in brim.iter().enumerate() {
        for (j, other) in brim.iter().chain(&contours).enumerate() {
            // The contour stands for a ring before the first.
            let apart = if j == brim.len() { i + 1 } else { i.abs_diff(j) } as f64 * p.strand;
            for &point in ring {
                // Corners are rounded by short chords, which cut in by a few hundredths of a mm.
                assert!((distance(other, point) - apart).abs() < 0.05, "{i} {j} {point}");
            }
        }
    }
}

#[test]
fn rings_of_a_skirt_lie_a_strand_apart_the_farthest_first() {
    let p = PathParams { skirt_rings: 4, strand: 0.5, ..PARAMS };
    let path = plan(&square(0.0, 20.0), &p);
    let (skirt, contours) = (rings(&path, Kind::Skirt), rings(&path, Kind::Contour));
    assert_eq!((skirt.len(), contours.len()), (4, 1));
    for (i, ring) in skirt.iter().enumerate() {
        let apart = p.skirt_gap + (3 - i) as f64 * p.strand;
        for &point in ring {
            assert!((distance(&contours[0], point) - apart).abs() < 0.05, "{i} {point}");
        }
    }
}

#[test]
fn the_skirt_goes_around_everything_and_the_brim_stays_on_the_bed() {
    let mut strands = square(0.0, 20.0);
    strands.extend(square(60.0, 10.0));
    let p = PathParams { brim_rings: Some(2), skirt_rings: 2, ..PARAMS };
    let path = plan(&strands, &p);
    let skirt = rings(&path, Kind::Skirt);
    assert_eq!(skirt.len(), 2);
    for contour in rings(&path, Kind::Contour) {
        for point in contour {
            assert!(skirt.iter().all(|ring| distance(ring, point) > p.skirt_gap));
        }
    }
    let edge = PathParams { plate: BedShape::Rectangle(DVec2::splat(70.9)), ..p };
    let half = DVec2::splat(70.9);
    for m in plan(&strands, &edge).iter().filter(|m| m.kind == Kind::Brim || m.kind == Kind::Skirt)
    {
        assert!((m.to.truncate() - p.centre).abs().cmple(half).all(), "{m:?} leaves the bed");
    }
}

#[test]
fn the_print_stands_about_the_bed_s_centre() {
    let strands = fence();
    let still = PathParams { cooling: CoolingMethod::Still, ..PARAMS };
    let printed: Vec<Move> = plan(&strands, &still).into_iter().filter(|m| m.is_strand()).collect();
    assert_eq!(printed.len(), strands.len());
    for (m, strand) in printed.iter().zip(&strands) {
        let centre = DVec3::new(100.0, 80.0, 0.0);
        assert_eq!((m.from - centre, m.to - centre), (strand.from, strand.to));
        assert!((m.filament - 0.16 * m.length()).abs() < 1e-12, "{m:?}");
    }
}

#[test]
fn filament_is_pulled_back_and_given_again_each_at_its_own_speed() {
    let p = PathParams { pressure_lag: 0.4, ..PARAMS };
    let path = plan(&fence(), &p);
    let standing = path.iter().filter(|m| m.length() == 0.0 && m.filament != 0.0);
    let (mut back, mut forth) = (0, 0);
    for m in standing {
        let speed = if m.filament < 0.0 { p.retract_speed } else { p.unretract_speed };
        assert_eq!(m.speed, speed, "{m:?}");
        if m.filament < 0.0 { back += 1 } else { forth += 1 }
    }
    assert!(back > 3 && forth > 3, "{back} {forth}");
}

#[test]
fn the_head_comes_down_to_the_first_strand_and_leaves_above_all() {
    let mut low = fence();
    low.push(strand([30.0, 0.0, 0.35], [40.0, 0.0, 0.35], Kind::Contour));
    for prime in [0.0, 5.0] {
        let p = PathParams { prime, ..PARAMS };
        let path = toolpath(&low, &p);
        assert_eq!(path.start, DVec3::new(100.0, 80.0, 0.35 + 1.0));
        let path = moves(&path);
        assert_eq!(path[0].kind, Kind::Travel);
        let first = path.iter().position(Move::is_strand).unwrap();
        let primed: Vec<&Move> = path[..first].iter().filter(|m| m.filament != 0.0).collect();
        assert_eq!(primed.len(), usize::from(prime > 0.0));
        assert!(primed.iter().all(|m| m.kind == Kind::Unretract && m.filament == prime));
        let last = path[path.len() - 1];
        assert_eq!((last.kind, last.to), (Kind::Travel, DVec3::new(140.0, 80.0, 7.0)));
        assert_eq!(last.from.truncate(), last.to.truncate());
        let retract = path[path.len() - 2];
        assert_eq!((retract.kind, retract.filament), (Kind::Retract, -p.retract));
    }
    let none = PathParams { retract: 0.0, ..PARAMS };
    assert!(plan(&low, &none).iter().all(|m| m.kind != Kind::Retract));
}

#[test]
fn a_short_hop_over_what_stands_high_is_a_long_way() {
    let hop = |tall: f64| {
        let strands = [
            strand([0.0, 0.0, 0.35], [0.0, 0.0, tall], Kind::Post),
            strand([20.0, 0.0, 0.35], [30.0, 0.0, 0.35], Kind::Contour),
            strand([30.5, 0.0, 0.35], [40.0, 0.0, 0.35], Kind::Contour),
        ];
        let path = plan(&strands, &PARAMS);
        let contours: Vec<usize> =
            (0..path.len()).filter(|&i| path[i].kind == Kind::Contour).collect();
        let between = &path[contours[0] + 1..contours[1]];
        let over = between.iter().map(|m| m.to.z).fold(0.0, f64::max);
        assert!((over - tall.max(0.35) - 1.0).abs() < 1e-9, "{over} over {tall}");
        between.iter().any(|m| m.kind == Kind::Retract)
    };
    // Half a mm aside, and as far up as something stands: from a mm on, filament is pulled back.
    assert!(!hop(0.35 + 0.4) && hop(0.35 + 0.6) && hop(9.0));
}

#[test]
fn layers_lines_are_reached_straight_and_without_a_retraction_where_they_are_near() {
    for (gap, far) in [(1.9, false), (2.1, true)] {
        let mut all = strands_along(&[[0.0, 0.0, 6.0], [9.0, 0.0, 6.0]], Kind::LayerWise);
        let next = strand([9.0, gap, 6.0], [0.0, gap, 6.0], Kind::LayerWise);
        all.push(Strand { direct: true, ..next });
        let path = plan(&all, &PARAMS);
        let lines: Vec<usize> = (0..path.len()).filter(|&i| path[i].is_strand()).collect();
        let between = &path[lines[0] + 1..lines[1]];
        let travels: Vec<&Move> = between.iter().filter(|m| m.kind == Kind::Travel).collect();
        assert_eq!(travels.len(), 1);
        assert!((travels[0].length() - gap).abs() < 1e-9);
        assert_eq!(between.iter().any(|m| m.kind == Kind::Retract), far);
    }
}

#[test]
fn figures_are_sums_over_the_moves() {
    let path = toolpath(&fence(), &PARAMS);
    let (all, found) = (moves(&path), path.figures());
    let sum = |kinds: fn(&&Move) -> bool| all.iter().filter(kinds).map(Move::length).sum::<f64>();
    assert!((found.strand - sum(|m| m.is_strand())).abs() < 1e-9);
    assert!((found.travel - sum(|m| m.kind == Kind::Travel)).abs() < 1e-9);
    assert_eq!((found.pauses, found.pause), (3, 3.0 * PARAMS.pause));
    let filament: f64 = all.iter().map(|m| m.filament).sum();
    assert!((found.filament - filament).abs() < 1e-9);
}

#[test]
fn a_plate_holds_what_lies_on_it() {
    for (x, y, round, square) in
        [(9.9, 0.0, true, true), (8.0, 8.0, false, false), (0.0, -4.1, true, false)]
    {
        let p = DVec2::new(x, y);
        assert_eq!(BedShape::Round(10.0).holds(p), round);
        assert_eq!(BedShape::Rectangle(DVec2::new(10.0, 4.0)).holds(p), square, "{p}");
    }
    assert!(PARAMS.is_on_bed(0.35) && !PARAMS.is_on_bed(0.36));
}

#[test]
fn a_small_foot_under_a_tall_print_gets_a_brim() {
    let rings_of = |side: f64, height: f64| {
        let mut all = square(0.0, side);
        all.push(strand([0.0, 0.0, 0.35], [0.0, 0.0, height], Kind::Post));
        let p = PathParams { brim_rings: None, ..PARAMS };
        let path = toolpath(&all, &p);
        assert_eq!(rings(&moves(&path), Kind::Brim).len(), path.brim_rings as usize);
        path.brim_rings
    };
    // A foot of a quarter of the height is safe; what it lacks of that, rings of a strand add on both
    // sides, ten at the most.
    assert_eq!(rings_of(20.0, 80.0), 0);
    assert_eq!(rings_of(20.0, 81.0), 1);
    assert_eq!(rings_of(20.0, 100.0), (5.0_f64 / 1.4).ceil() as u32);
    assert_eq!(rings_of(10.0, 300.0), 10);
}

#[test]
fn figures_add_up_what_is_drawn_travelled_waited_and_fed() {
    let lone = [
        strand([0.0, 0.0, 0.35], [0.0, 0.0, 6.35], Kind::Post),
        strand([0.0, 0.0, 6.35], [8.0, 0.0, 0.35], Kind::Diagonal),
        strand([8.0, 0.0, 0.35], [8.0, 0.0, 6.35], Kind::Post),
    ];
    let path = toolpath(&lone, &PARAMS);
    let found = path.figures();
    assert!((found.strand - (6.0 + 10.0 + 6.0)).abs() < 1e-9);
    // Down to the first strand from a millimetre over it, and up from the last one.
    assert!((found.travel - 2.0).abs() < 1e-9, "{}", found.travel);
    assert_eq!(found.pauses, 2);
    assert!((found.pause - 2.0 * PARAMS.pause).abs() < 1e-12);
    // Filled once, pulled back in the end: 0.16 mm a mm between.
    assert!((found.filament - (5.0 + 22.0 * 0.16 - 4.0)).abs() < 1e-9, "{}", found.filament);
    assert_eq!(toolpath(&[], &PARAMS).figures().travel, 0.0);
}

#[test]
fn a_hop_of_a_millimetre_needs_no_retraction_and_a_longer_one_does() {
    let pulls = |gap: f64, lower: f64, retract: f64, direct: bool| {
        let first = strand([0.0, 0.0, 6.0], [9.0, 0.0, 6.0], Kind::Cap);
        let z = 6.0 - lower;
        let next = Strand { direct, ..strand([9.0 + gap, 0.0, z], [20.0, 0.0, z], Kind::Cap) };
        let path = plan(&[first, next], &PathParams { retract, ..PARAMS });
        let last = path.iter().rposition(|m| m.kind == Kind::Cap).unwrap();
        path[..last].iter().any(|m| m.kind == Kind::Retract)
    };
    assert!(!pulls(1.0, 0.0, 4.0, false) && pulls(1.01, 0.0, 4.0, false));
    // Between layers' lines as far as the settings say, whatever stands.
    assert!(!pulls(2.0, 0.0, 4.0, true) && pulls(2.01, 0.0, 4.0, true));
    assert!(!pulls(5.0, 0.0, 0.0, false));
    // Up over what stands, and down again: 0.6 mm to a place 0.6 mm lower.
    assert!(pulls(0.6, 0.9, 4.0, false) && !pulls(0.6, 0.6, 4.0, false));
}
