//! The certificate of random prints against all pairs of moves and strands, without any grid.
#![allow(clippy::unwrap_used)]

use glam::{DVec2, DVec3, dvec2, dvec3};
use proptest::prelude::*;
use wireprint_core::check::{Bed, Limits, Rules, Settling, certify};
use wireprint_core::gcode::event::Step;
use wireprint_core::head::{Head, HeadPart, Shape};

/// A duct that is turned, and a probe beyond the carriage.
fn parts() -> Vec<HeadPart> {
    let duct = Shape::Box { x_mm: [8.0, 30.0], y_mm: [-3.0, 6.0], bottom_mm: 2.0, turn_deg: 25.0 };
    let probe = Shape::Cylinder { centre_mm: [-10.0, 38.0], radius_mm: 4.0, bottom_mm: 1.5 };
    [duct, probe].map(|shape| HeadPart::try_from(shape).unwrap()).to_vec()
}

fn rules() -> Rules {
    Rules {
        head: Head::new(0.5, 32.0, 6.0, 20.0, 30.0, 35.0).unwrap().with_parts(parts()),
        strand: 0.7,
        bed_contact: 0.7,
        span_limit: 65.0,
        free_end_limit: 20.0,
        bed: Bed::new(DVec2::ZERO, dvec2(40.0, 60.0), false, 80.0),
        limits: Limits {
            feed: 200.0,
            flow: 1e9,
            filament_only: 50.0,
            pulled_back: 1.0,
            filament_area: 2.405,
        },
        settling: Settling { dwell: 0.0, slow: 0.0 },
        coldest: 170.0,
    }
}

/// Points of a random walk that rises slowly and sometimes leaps; whether each stroke extrudes.
fn walk() -> impl Strategy<Value = Vec<(DVec3, bool)>> {
    let stroke = (-9.0..9.0_f64, -9.0..9.0_f64, -3.0..4.0_f64, 0_u8..10, any::<bool>());
    proptest::collection::vec(stroke, 2..120).prop_map(|strokes| {
        let mut at = dvec3(0.0, 0.0, 0.3);
        strokes
            .into_iter()
            .map(|(x, y, z, leap, extrudes)| {
                let scale = if leap == 0 { 6.0 } else { 1.0 };
                at += dvec3(x, y, z) * scale;
                at = at.clamp(dvec3(-39.0, -59.0, 0.0), dvec3(39.0, 59.0, 79.0));
                (at, extrudes && leap > 0)
            })
            .collect()
    })
}

fn moves(walk: &[(DVec3, bool)]) -> Vec<Step> {
    walk.windows(2)
        .zip(1..)
        .filter(|(pair, _)| pair[0].0 != pair[1].0)
        .map(|(pair, line)| Step {
            line,
            from: pair[0].0,
            to: pair[1].0,
            filament: if pair[1].1 { 1.0 } else { 0.0 },
            speed: 30.0,
            rapid: false,
            homing: false,
            feature: 0,
        })
        .collect()
}

/// Deepest hit of each move that collides: line and depth.
fn collisions(moves: &[Step], rules: &Rules) -> Vec<(u64, f64)> {
    let depth = |index: usize| {
        let step = &moves[index];
        let earlier = moves[..index].iter().filter(|strand| strand.filament > 0.0);
        let others = earlier.filter_map(|strand| {
            rules.head.worst_depth(step.from, step.to, strand.from, strand.to)
        });
        let own = rules.head.worst_depth(step.to, step.to, step.from, step.to);
        let own = own.filter(|_| step.filament > 0.0);
        others.chain(own).map(|hit| hit.depth).fold(0.0, f64::max)
    };
    (0..moves.len())
        .map(|index| (moves[index].line, depth(index)))
        .filter(|(_, depth)| *depth > rules.tolerance())
        .collect()
}

fn distance(p: DVec3, strand: &Step) -> f64 {
    let run = strand.to - strand.from;
    let u = ((p - strand.from).dot(run) / run.length_squared()).clamp(0.0, 1.0);
    p.distance(strand.from + u * run)
}

/// Lines of the strands that start a chain without contact.
fn floating_starts(moves: &[Step], rules: &Rules) -> Vec<u64> {
    let starts = |index: usize| {
        let step = &moves[index];
        let begins = index == 0 || moves[index - 1].filament == 0.0;
        let earlier = moves[..index].iter().filter(|strand| strand.filament > 0.0);
        let nearest = earlier.map(|strand| distance(step.from, strand)).fold(f64::MAX, f64::min);
        step.filament > 0.0
            && begins
            && step.from.z > rules.bed_contact + 2e-3
            && nearest > rules.strand + 2e-3
    };
    (0..moves.len()).filter(|&index| starts(index)).map(|index| moves[index].line).collect()
}

/// Lines of the strands that end a chain where neither earlier nor later material is near.
fn dangling_ends(moves: &[Step], rules: &Rules) -> Vec<u64> {
    let chain_of = |index: usize| moves[..index].iter().filter(|step| step.filament == 0.0).count();
    let dangles = |index: usize| {
        let step = &moves[index];
        let ends = moves.get(index + 1).is_none_or(|next| next.filament == 0.0);
        let others = (0..moves.len())
            .filter(|&other| moves[other].filament > 0.0 && chain_of(other) != chain_of(index));
        let nearest = others.map(|other| distance(step.to, &moves[other])).fold(f64::MAX, f64::min);
        step.filament > 0.0
            && ends
            && step.to.z > rules.bed_contact + 2e-3
            && nearest > rules.strand + 2e-3
    };
    (0..moves.len()).filter(|&index| dangles(index)).map(|index| moves[index].line).collect()
}

/// Where each strand's chain is at its start, mm along the chain, and which chain that is.
fn arcs(moves: &[Step]) -> Vec<(usize, f64)> {
    let (mut chain, mut arc) = (0, 0.0);
    moves
        .iter()
        .map(|step| {
            let here = (chain, arc);
            if step.filament > 0.0 {
                arc += step.from.distance(step.to);
            } else {
                (chain, arc) = (chain + 1, 0.0);
            }
            here
        })
        .collect()
}

/// Whether anything may hold a point of a strand: the bed, another chain that `counts`, or what the
/// same chain laid more than three diameters before. Generous by `play` mm.
fn may_be_held(
    (index, along): (usize, f64),
    counts: impl Fn(usize) -> bool,
    moves: &[Step],
    rules: &Rules,
    play: f64,
) -> bool {
    let (step, arcs) = (&moves[index], arcs(moves));
    let point = step.from + (step.to - step.from).normalize() * along;
    let reach = rules.strand + play;
    let own_arc = arcs[index].1 + along - 3.0 * rules.strand;
    let near = |other: usize| {
        let strand = &moves[other];
        let length = strand.from.distance(strand.to);
        let laid = if arcs[other].0 == arcs[index].0 { own_arc - arcs[other].1 } else { length };
        let end = strand.from.lerp(strand.to, (laid / length).min(1.0));
        strand.filament > 0.0
            && laid > 0.0
            && distance(point, &Step { to: end, ..*strand }) <= reach
    };
    let own = |other: usize| arcs[other].0 == arcs[index].0 && other <= index;
    point.z <= rules.bed_contact + play
        || (0..moves.len()).any(|other| (own(other) || counts(other)) && near(other))
}

/// Lines of the strands that end a chain where nothing but themselves is near, their own chain included,
/// which they may end on.
fn surely_dangling(moves: &[Step], rules: &Rules) -> Vec<u64> {
    const PLAY: f64 = 1e-2;
    let last = moves.len() - 1;
    let dangles = |&index: &usize| {
        let end = moves[index].to;
        let ends = index == last || moves[index + 1].filament == 0.0;
        let others = (0..moves.len()).filter(|&i| i != index && moves[i].filament > 0.0);
        let mut off = others.map(|other| distance(end, &moves[other]));
        moves[index].filament > 0.0
            && ends
            && end.z > rules.bed_contact + PLAY
            && off.all(|off| off > rules.strand + PLAY)
    };
    (0..moves.len()).filter(dangles).map(|index| moves[index].line).collect()
}

/// Lengths of the strands that nothing holds anywhere, by points a twentieth of a mm apart.
fn surely_hanging(moves: &[Step], rules: &Rules) -> Vec<f64> {
    const APART: f64 = 0.05;
    let hangs = |&index: &usize| {
        let points = (moves[index].from.distance(moves[index].to) / APART).ceil();
        let earlier = |other: usize| other < index;
        moves[index].filament > 0.0
            && (0..=points as usize).all(|point| {
                let along = moves[index].from.distance(moves[index].to) * point as f64 / points;
                !may_be_held((index, along), earlier, moves, rules, APART)
            })
    };
    let length = |index: usize| moves[index].from.distance(moves[index].to);
    (0..moves.len()).filter(hangs).map(length).collect()
}

proptest! {
    #[test]
    fn every_collision_of_a_random_print_is_found_and_nothing_else(walk in walk()) {
        let (moves, rules) = (moves(&walk), rules());
        let found = certify(&moves, &[], &rules).collisions;
        let expected = collisions(&moves, &rules);
        prop_assert_eq!(found.len(), expected.len());
        for (hit, (line, depth)) in found.iter().zip(expected) {
            prop_assert_eq!(hit.line, line);
            prop_assert!((hit.depth - depth).abs() < 1e-9);
        }
    }

    #[test]
    fn a_start_floats_exactly_if_nothing_earlier_is_within_a_strand(walk in walk()) {
        let (moves, rules) = (moves(&walk), rules());
        let found = certify(&moves, &[], &rules).floating_starts;
        let lines: Vec<_> = found.iter().map(|start| start.line).collect();
        prop_assert_eq!(lines, floating_starts(&moves, &rules));
    }

    #[test]
    fn an_end_dangles_if_nothing_is_near_and_only_if_no_other_chain_is(walk in walk()) {
        let (moves, rules) = (moves(&walk), rules());
        let found = certify(&moves, &[], &rules).dangling_ends;
        let lines: Vec<_> = found.iter().map(|end| end.line).collect();
        let (may, must) = (dangling_ends(&moves, &rules), surely_dangling(&moves, &rules));
        prop_assert!(lines.iter().all(|line| may.contains(line)));
        prop_assert!(must.iter().all(|line| lines.contains(line)));
    }

    #[test]
    fn spans_are_as_long_as_the_strands_that_hang_and_no_longer_than_their_chains(walk in walk()) {
        let (moves, mut rules) = (moves(&walk), rules());
        (rules.span_limit, rules.free_end_limit) = (8.0, 8.0);
        let certificate = certify(&moves, &[], &rules);
        let strands: f64 = certificate.strands.iter().map(|[a, b]| a.distance(*b)).sum();
        let relaxed: f64 = certificate.relaxed.iter().map(|p| p.ends[0].distance(p.ends[1])).sum();
        prop_assert!(relaxed <= strands + 1e-9);
        let longest = certificate.max_span.max(certificate.max_free_end);
        prop_assert!(longest <= strands + 1e-9);
        let hanging = surely_hanging(&moves, &rules).into_iter().fold(0.0, f64::max);
        prop_assert!(longest >= hanging - 1e-9);
        prop_assert_eq!(certificate.spans_over.is_empty(), longest <= 8.0);
    }
}
