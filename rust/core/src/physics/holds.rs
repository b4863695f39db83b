//! Does a post hold when the nozzle leaves it?

use super::flow::Matter;

/// Parts of Simpson's rule over a post.
const PARTS: u32 = 64;

/// How far a post's tip gives way when the nozzle leaves it, by its own softness, mm/N.
///
/// `∫ s²/(E(T(s))·I) ds` over the way back from the tip; the last diameter stays molten under the
/// nozzle and is left out. `celsius` tells how warm it is then, so far (mm) from its tip.
pub(super) fn softness(matter: &Matter, length: f64, celsius: impl Fn(f64) -> f64) -> f64 {
    let diameter = matter.thermal.strand;
    if length <= diameter {
        return 0.0;
    }
    let moment = std::f64::consts::PI * diameter.powi(4) / 64.0;
    let step = (length - diameter) / f64::from(PARTS);
    let bends = |i: u32| {
        let back = diameter + f64::from(i) * step;
        let weight = match i {
            0 | PARTS => 1.0,
            i if i % 2 == 1 => 4.0,
            _ => 2.0,
        };
        weight * back * back / (matter.modulus(celsius(back)) * moment)
    };
    (0..=PARTS).map(bends).sum::<f64>() * step / 3.0
}

/// A stroke as a planner times it: speeding up, at its own speed, and braking as it sped up.
#[derive(Debug, Clone, Copy)]
pub(super) struct Stroke {
    /// mm.
    pub length: f64,
    /// From begin to end, s.
    pub seconds: f64,
    /// Its own speed, mm/s.
    pub speed: f64,
}

impl Stroke {
    /// How long before its end the nozzle was so far (mm) from there, s.
    pub(super) fn before_end(self, back: f64) -> f64 {
        let Self { length, seconds, speed } = self;
        let steady = length / speed;
        if seconds <= steady {
            return back * seconds / length;
        }
        if seconds >= 2.0 * steady {
            // It never reaches its own speed.
            let half = |way: f64| seconds * (way.max(0.0) / length / 2.0).sqrt();
            return if back < length / 2.0 { half(back) } else { seconds - half(length - back) };
        }
        let braking = seconds - steady;
        let way = speed * braking / 2.0;
        let edge = |back: f64| (2.0 * back.max(0.0) * braking / speed).sqrt();
        if back < way {
            edge(back)
        } else if back > length - way {
            seconds - edge(length - back)
        } else {
            back / speed + braking / 2.0
        }
    }
}

/// The shortest pause after which a post leans by no more than half a strand, s; `most` where none
/// does.
///
/// The nozzle pulls at its tip with `pull` N; the post was drawn at `speed` mm/s, and `celsius`
/// tells its temperature by age.
pub fn pause(
    matter: &Matter,
    [length, speed]: [f64; 2],
    pull: f64,
    most: f64,
    celsius: impl Fn(f64) -> f64,
) -> f64 {
    let allowed = matter.thermal.strand / 2.0 / pull;
    let leans =
        |pause: f64| softness(matter, length, |back| celsius(pause + back / speed)) > allowed;
    let [mut low, mut high] = [0.0, most];
    if !leans(low) {
        return 0.0;
    }
    if leans(high) {
        return most;
    }
    // Halved until the middle of two numbers is one of them; some 60 times.
    while high - low > f64::EPSILON * most {
        let middle = low.midpoint(high);
        *(if leans(middle) { &mut low } else { &mut high }) = middle;
    }
    high
}

#[cfg(test)]
mod tests {
    use super::super::cooling::Fall;
    use super::super::flow::tests::ABS;
    use super::*;

    #[test]
    fn a_stroke_brakes_as_it_sped_up() {
        for (seconds, speed) in [(0.2, 30.0), (0.25, 30.0), (0.4, 30.0), (0.9, 30.0), (0.1, 30.0)] {
            let stroke = Stroke { length: 6.0, seconds, speed };
            let at = |back: f64| stroke.before_end(back);
            assert!(at(0.0).abs() < 1e-12 && (at(6.0) - seconds).abs() < 1e-9);
            assert!((at(3.0) - seconds / 2.0).abs() < 1e-9, "the two halves are alike");
            assert!((0..60).all(|i| at(f64::from(i) / 10.0) < at(f64::from(i + 1) / 10.0)));
            assert!((at(2.0) + at(4.0) - seconds).abs() < 1e-9);
        }
    }

    #[test]
    fn a_cold_post_is_a_cantilever_without_its_last_diameter() {
        let moment = std::f64::consts::PI * 0.7_f64.powi(4) / 64.0;
        let expected = (6.0_f64.powi(3) - 0.7_f64.powi(3)) / (3.0 * ABS.modulus(25.0) * moment);
        assert!((softness(&ABS, 6.0, |_| 25.0) / expected - 1.0).abs() < 1e-9);
        assert!(softness(&ABS, 0.7, |_| 25.0).abs() < 1e-12);
    }

    /// The paper's best pause of 1 s, for ABS of 0.7 mm in air jets; hardly any of it depends on
    /// the length of a post or on the pull.
    #[test]
    fn the_papers_pause_comes_out_for_posts_of_any_length() {
        let fall = Fall::of(&ABS.thermal, 6000.0);
        let of = |length, pull| pause(&ABS, [length, 30.0], pull, 60.0, |age| fall.at(age));
        for length in [2.0, 4.0, 7.0, 11.0] {
            assert!((0.9..1.3).contains(&of(length, 0.01)), "{length} {}", of(length, 0.01));
        }
        assert!((of(5.0, 0.02) / of(5.0, 0.007) - 1.0).abs() < 0.1);
        assert!(of(1.05, 0.01) <= 0.0, "short strokes need none");
        assert!(of(25.0, 0.01) >= 60.0, "what is too soft when it is cold, no pause helps");
    }

    /// The paper's figure 15: full speed and a pause take less time for a post and its diagonal
    /// than a slow head does.
    #[test]
    fn full_speed_and_a_pause_beat_a_slow_head() {
        let fall = Fall::of(&ABS.thermal, 6000.0);
        let of = |speed| pause(&ABS, [5.0, speed], 0.01, 60.0, |age| fall.at(age));
        let takes = |speed: f64| (5.0 + 8.5) / speed + of(speed);
        assert!(of(5.0) < of(10.0) && of(10.0) < of(30.0) && of(30.0) < of(60.0));
        assert!(takes(30.0) < (5.0 + 8.5) / 5.0);
        assert!(takes(60.0) < takes(30.0) && takes(30.0) < takes(10.0) && takes(10.0) < takes(5.0));
    }
}
