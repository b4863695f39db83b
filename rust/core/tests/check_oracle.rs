//! The certificate of random prints against all pairs of moves and strands, without any grid.
#![allow(clippy::unwrap_used)]

use glam::{DVec2, DVec3, dvec2, dvec3};
use proptest::prelude::*;
use wireprint_core::check::{Bed, Limits, Rules, Settling, certify};
use wireprint_core::gcode::event::Step;
use wireprint_core::head::Head;

fn rules() -> Rules {
    Rules {
        head: Head::new(0.5, 32.0, 6.0, 20.0, 30.0, 35.0).unwrap(),
        strand: 0.7,
        bed_contact: 0.7,
        span_limit: 65.0,
        free_end_limit: 20.0,
        bed: Bed { centre: DVec2::ZERO, half: dvec2(40.0, 60.0), round: false, height: 80.0 },
        limits: Limits { feed: 200.0, flow: 1e9, filament_only: 50.0, filament_area: 2.405 },
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
    fn an_end_dangles_only_if_no_other_chain_is_within_a_strand(walk in walk()) {
        let (moves, rules) = (moves(&walk), rules());
        let expected = dangling_ends(&moves, &rules);
        for end in certify(&moves, &[], &rules).dangling_ends {
            prop_assert!(expected.contains(&end.line));
        }
    }

    #[test]
    fn spans_and_free_ends_are_never_longer_than_their_chains(walk in walk()) {
        let (moves, rules) = (moves(&walk), rules());
        let certificate = certify(&moves, &[], &rules);
        let strands: f64 = certificate.strands.iter().map(|[a, b]| a.distance(*b)).sum();
        let relaxed: f64 = certificate.relaxed.iter().map(|p| p.ends[0].distance(p.ends[1])).sum();
        prop_assert!(relaxed <= strands + 1e-9);
        prop_assert!(certificate.max_span.max(certificate.max_free_end) <= strands + 1e-9);
    }
}
