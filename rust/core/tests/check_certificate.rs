//! The certificate on hand-made prints: a correct wire cube passes, each planted breach is found.
#![allow(clippy::unwrap_used)]

use glam::{DVec2, DVec3, dvec2, dvec3};
use wireprint_core::check::{
    Bed, Bound, Certificate, Dwell, Limits, Obstacle, Rules, Settling, certify,
};
use wireprint_core::gcode::event::Step;
use wireprint_core::head::Head;

const FIRST: f64 = 0.35;
const SLAB: f64 = 4.0;

fn rules() -> Rules {
    Rules {
        head: Head::new(0.5, 32.0, 6.0, 20.0, 40.0, 35.0).unwrap(),
        strand: 0.7,
        bed_contact: 0.7,
        span_limit: 65.0,
        free_end_limit: 20.0,
        bed: Bed::new(DVec2::ZERO, dvec2(85.0, 85.0), true, 200.0),
        limits: Limits {
            feed: 200.0,
            flow: 15.0,
            filament_only: 50.0,
            pulled_back: 1.0,
            filament_area: 2.405,
        },
        settling: Settling { dwell: 0.0, slow: 0.0 },
        coldest: 170.0,
    }
}

fn step(line: u64, from: DVec3, to: DVec3, filament: f64, speed: f64) -> Step {
    Step { line, from, to, filament, speed, rapid: false, homing: false, feature: 0 }
}

/// Moves under construction; lines count from 1, one per move.
struct Pen {
    at: DVec3,
    moves: Vec<Step>,
}

impl Pen {
    fn new(at: DVec3) -> Self {
        Self { at, moves: Vec::new() }
    }

    fn go(&mut self, to: DVec3, filament: f64) {
        self.moves.push(step(self.moves.len() as u64 + 1, self.at, to, filament, 30.0));
        self.at = to;
    }

    fn travel(&mut self, to: DVec3) {
        self.go(to, 0.0);
    }

    fn draw(&mut self, to: DVec3) {
        self.go(to, 0.16 * self.at.distance(to));
    }
}

/// Points of a square's outline of side 28 mm with four posts a side, from one corner on.
fn outline() -> Vec<DVec2> {
    let corners = [dvec2(-14.0, -14.0), dvec2(14.0, -14.0), dvec2(14.0, 14.0), dvec2(-14.0, 14.0)];
    (0..12).map(|i| corners[i / 3].lerp(corners[(i / 3 + 1) % 4], (i % 3) as f64 / 3.0)).collect()
}

/// A wire cube of three slabs as one continuous strand.
fn cube() -> Vec<Step> {
    let outline = outline();
    let at = |i: usize, z: f64| outline[i % outline.len()].extend(z);
    let mut pen = Pen::new(dvec3(0.0, 0.0, 50.0));
    pen.travel(at(0, 10.0));
    pen.travel(at(0, FIRST));
    let mut first = 0;
    for slab in 0..4 {
        let z = FIRST + f64::from(slab) * SLAB;
        for i in 1..=outline.len() {
            pen.draw(at(first + i, z));
        }
        if slab < 3 {
            for i in 0..outline.len() {
                if i > 0 {
                    pen.draw(at(first + i, z));
                }
                pen.draw(at(first + i, z + SLAB));
            }
            first += outline.len() - 1;
        }
    }
    pen.travel(pen.at.with_z(60.0));
    pen.moves
}

fn verdict(moves: &[Step]) -> Certificate {
    certify(moves, &[], &rules())
}

/// Index of the `n`-th move that extrudes and whose height changes by `rise`.
fn stroke(moves: &[Step], rise: f64, n: usize) -> usize {
    let strokes = moves
        .iter()
        .enumerate()
        .filter(|(_, step)| step.filament > 0.0 && (step.to.z - step.from.z - rise).abs() < 1e-9);
    strokes.map(|(index, _)| index).nth(n).unwrap()
}

/// Moves the point where moves `index` and `index + 1` meet.
fn shift(moves: &mut [Step], index: usize, by: DVec3) {
    moves[index].to += by;
    moves[index + 1].from += by;
}

#[test]
fn a_correct_wire_cube_passes() {
    let certificate = verdict(&cube());
    assert!(certificate.ok(), "{certificate:#?}");
    assert!(certificate.max_span > 7.0 && certificate.max_span < 12.0, "{}", certificate.max_span);
    assert!(certificate.max_free_end > 3.0 && certificate.max_free_end < 4.0);
}

#[test]
fn what_the_correct_cube_relaxes_to_is_the_cube() {
    let certificate = verdict(&cube());
    let length =
        |strands: &mut dyn Iterator<Item = [DVec3; 2]>| strands.map(|[a, b]| a.distance(b)).sum();
    let commanded: f64 = length(&mut certificate.strands.iter().copied());
    let relaxed: f64 = length(&mut certificate.relaxed.iter().map(|piece| piece.ends));
    assert!((commanded - relaxed).abs() < 1e-6 * commanded, "{commanded} {relaxed}");
}

#[test]
fn a_lowered_travel_is_a_collision_with_the_strands_it_crosses() {
    let mut moves = cube();
    let last = moves.pop().unwrap();
    let mut pen = Pen { at: last.from, moves };
    let low = last.from.z - 2.0;
    pen.travel(dvec3(0.0, 0.0, 40.0));
    pen.travel(dvec3(50.0, 0.0, 40.0));
    pen.travel(dvec3(50.0, 0.0, low));
    pen.travel(dvec3(0.0, 0.0, low));
    let certificate = verdict(&pen.moves);
    let [hit] = &certificate.collisions[..] else { panic!("{certificate:#?}") };
    assert_eq!(hit.line as usize, pen.moves.len());
    assert!(hit.depth > 0.35 && hit.depth <= 2.0);
    assert!(matches!(hit.obstacle, Obstacle::Strand { .. }));
}

#[test]
fn a_steepened_diagonal_hits_its_own_post() {
    let mut moves = cube();
    let diagonal = stroke(&moves, -SLAB, 3);
    let run = moves[diagonal].to - moves[diagonal].from;
    shift(&mut moves, diagonal, -0.55 * run.with_z(0.0));
    let certificate = verdict(&moves);
    assert!(certificate.collisions.iter().any(|hit| hit.line as usize == diagonal + 1));
}

#[test]
fn a_post_that_is_only_travelled_leaves_its_diagonal_without_a_start() {
    let mut moves = cube();
    let post = stroke(&moves, SLAB, 5);
    moves[post].filament = 0.0;
    let certificate = verdict(&moves);
    let starts: Vec<_> = certificate.floating_starts.iter().map(|start| start.line).collect();
    assert_eq!(starts, [post as u64 + 2]);
}

#[test]
fn a_shifted_start_floats() {
    let mut moves = cube();
    moves[1].to.z = 1.5;
    moves[2].from.z = 1.5;
    let certificate = verdict(&moves);
    assert_eq!(certificate.floating_starts.len(), 1);
    assert_eq!(certificate.floating_starts[0].line, 3);
}

#[test]
fn an_end_in_the_air_dangles_unless_a_later_strand_meets_it() {
    let mut pen = Pen::new(dvec3(0.0, 0.0, FIRST));
    pen.draw(dvec3(10.0, 0.0, FIRST));
    pen.draw(dvec3(10.0, 0.0, 5.0));
    let alone = verdict(&pen.moves);
    assert_eq!(alone.dangling_ends.iter().map(|end| end.line).collect::<Vec<_>>(), [2]);
    pen.travel(dvec3(10.0, 0.0, 9.0));
    pen.travel(dvec3(10.0, 0.0, 5.0));
    pen.draw(dvec3(18.0, 0.0, FIRST));
    assert!(verdict(&pen.moves).ok(), "{:#?}", verdict(&pen.moves));
}

#[test]
fn a_span_over_the_limit_is_measured_between_its_supports() {
    let mut pen = Pen::new(dvec3(-40.0, 0.0, FIRST));
    pen.draw(dvec3(-40.0, 10.0, FIRST));
    pen.draw(dvec3(-40.0, 10.0, 5.0));
    pen.draw(dvec3(40.0, 10.0, 5.0));
    pen.draw(dvec3(50.0, 10.0, FIRST));
    let certificate = verdict(&pen.moves);
    let [span] = &certificate.spans_over[..] else { panic!("{certificate:#?}") };
    let fall = 10.0_f64.hypot(5.0 - FIRST);
    let landing = fall * (0.7 - FIRST) / (5.0 - FIRST);
    assert!((span.length - (80.0 + fall - landing)).abs() < 0.01, "{}", span.length);
    assert_eq!(span.from, dvec3(-40.0, 10.0, 5.0));
}

#[test]
fn a_free_end_has_its_own_lesser_limit() {
    let mut pen = Pen::new(dvec3(0.0, 0.0, FIRST));
    pen.draw(dvec3(1.0, 0.0, FIRST));
    pen.draw(dvec3(1.0, 0.0, 30.0));
    pen.draw(dvec3(60.0, 0.0, FIRST));
    let certificate = verdict(&pen.moves);
    assert!(certificate.spans_over.iter().any(|span| span.free_end && span.length > 29.0));
}

#[test]
fn hanging_corners_relax_to_the_chord() {
    let mut pen = Pen::new(dvec3(0.0, 0.0, FIRST));
    pen.draw(dvec3(0.0, 0.0, 4.0));
    pen.draw(dvec3(10.0, 10.0, 4.0));
    pen.draw(dvec3(20.0, 0.0, 4.0));
    pen.draw(dvec3(30.0, 0.0, FIRST));
    let certificate = verdict(&pen.moves);
    assert!(certificate.relaxed.iter().all(|piece| piece.ends.iter().all(|p| p.y.abs() < 1e-9)));
}

#[test]
fn a_corner_where_the_head_dwells_holds_itself_unless_it_is_too_far_out() {
    let mut pen = Pen::new(dvec3(0.0, 0.0, FIRST));
    pen.draw(dvec3(0.0, 0.0, 4.0));
    pen.draw(dvec3(8.0, 10.0, 4.0));
    pen.draw(dvec3(16.0, 0.0, 4.0));
    pen.draw(dvec3(24.0, 0.0, FIRST));
    let bent = |certificate: &Certificate| {
        certificate.relaxed.iter().flat_map(|piece| piece.ends).any(|p| p.y == 10.0)
    };
    assert!(!bent(&certify(&pen.moves, &[], &rules())));
    let held = certify(&pen.moves, &[Dwell { after: 1, seconds: 1.0 }], &rules());
    assert!(bent(&held) && held.max_free_end > 12.0);
    let short = Rules { free_end_limit: 10.0, ..rules() };
    assert!(!bent(&certify(&pen.moves, &[Dwell { after: 1, seconds: 1.0 }], &short)));
}

#[test]
fn an_end_in_the_air_dangles_even_if_the_head_dwells_there() {
    let mut pen = Pen::new(dvec3(0.0, 0.0, FIRST));
    pen.draw(dvec3(0.0, 0.0, 4.0));
    assert_eq!(
        certify(&pen.moves, &[Dwell { after: 0, seconds: 1.0 }], &rules()).dangling_ends.len(),
        1
    );
}

#[test]
fn leaving_the_round_bed_the_height_or_the_bed_plane_is_reported() {
    let mut pen = Pen::new(dvec3(0.0, 0.0, 10.0));
    pen.travel(dvec3(61.0, 61.0, 10.0));
    pen.travel(dvec3(0.0, 0.0, 201.0));
    pen.travel(dvec3(0.0, 0.0, -0.1));
    let certificate = verdict(&pen.moves);
    let bounds: Vec<_> = certificate.out_of_bounds.iter().map(|b| (b.line, b.bound)).collect();
    assert_eq!(bounds, [(1, Bound::Volume), (2, Bound::Volume)]);
    assert!((certificate.out_of_bounds[0].value - (61.0 * 2.0_f64.sqrt() - 85.0)).abs() < 1e-9);
    let [hit] = &certificate.collisions[..] else { panic!("{certificate:#?}") };
    assert_eq!((hit.line, hit.obstacle), (3, Obstacle::Bed));
    assert!((hit.depth - 0.1).abs() < 1e-12);
}

#[test]
fn feeds_flow_and_filament_only_moves_have_limits() {
    let at = dvec3(0.0, 0.0, FIRST);
    let to = dvec3(10.0, 0.0, FIRST);
    let moves = [
        step(1, at, to, 0.0, 201.1),
        step(2, to, at, 10.0, 30.0),
        step(3, at, at, -51.0, 30.0),
        step(4, at, at, -49.0, 1e6),
    ];
    let certificate = verdict(&moves);
    let bounds: Vec<_> = certificate.out_of_bounds.iter().map(|b| (b.line, b.bound)).collect();
    assert_eq!(bounds, [(1, Bound::Feed), (2, Bound::Flow), (3, Bound::FilamentOnly)]);
}

#[test]
fn nothing_at_all_is_not_a_breach() {
    assert!(verdict(&[]).ok());
}

#[test]
fn the_verdict_does_not_depend_on_the_number_of_threads() {
    let mut moves = cube();
    for index in (10..90).step_by(7) {
        shift(&mut moves, index, dvec3(0.3, -2.0, -1.0));
    }
    let report = |threads| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        format!("{:?}", pool.install(|| verdict(&moves)))
    };
    assert!(!verdict(&moves).ok());
    assert_eq!(report(1), report(4));
}
