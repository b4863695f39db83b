//! The way home: which strokes a G28 makes.

use glam::{DVec2, DVec3};
use serde::Deserialize;

/// Angles of a delta's towers, as parts of a turn; both Klipper and Marlin put them there.
const TOWERS: [f64; 3] = [7.0 / 12.0, 11.0 / 12.0, 3.0 / 12.0];

/// Most strokes of one homing.
const STROKES: usize = 5;

/// What a printer does when it is told to home.
#[derive(Debug, Clone, Copy, PartialEq, Deserialize)]
pub struct Homing {
    /// Where the tip is when all axes are home, mm.
    #[serde(rename = "at_mm")]
    pub at: DVec3,
    /// The way there.
    pub way: Way,
}

/// The way home.
#[derive(Debug, Clone, Copy, PartialEq, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Way {
    /// Each axis by itself: x, y, then z.
    Axes {
        /// Whether z comes first, as it does where its end is at the top.
        z_first: bool,
        /// Height that the tip is raised to, if it is lower, before x or y is homed, mm.
        #[serde(rename = "lift_mm")]
        lift: f64,
        /// Where z is homed, mm; `None`: wherever the head is.
        #[serde(rename = "z_place_mm")]
        place: Option<DVec2>,
    },
    /// A delta: whatever is named, all carriages climb to their ends.
    Delta {
        /// Horizontal distance from the effector's joints to the towers when centred, mm.
        #[serde(rename = "delta_radius")]
        radius: f64,
        /// Length of the arms, mm.
        #[serde(rename = "arm_length")]
        arm: f64,
    },
}

impl Homing {
    /// Axes that are home at the lowest corner, each by itself: what is assumed of a machine of
    /// which nothing is known.
    pub const AT_ORIGIN: Self =
        Self { at: DVec3::ZERO, way: Way::Axes { z_first: false, lift: 0.0, place: None } };

    /// Which axes are home afterwards.
    #[must_use]
    pub fn homes(&self, named: [bool; 3]) -> [bool; 3] {
        if matches!(self.way, Way::Delta { .. }) { [true; 3] } else { named }
    }

    /// Ends of the strokes that home the axes `named` from `from`; some may go nowhere.
    #[must_use]
    pub fn strokes(&self, from: DVec3, named: [bool; 3]) -> HomingStrokes {
        let mut strokes = HomingStrokes { ends: [from; STROKES], count: 0 };
        match self.way {
            Way::Delta { radius, arm } => {
                strokes.go(from.with_z(self.first_end(from, radius, arm)));
                strokes.go(self.at);
            }
            Way::Axes { z_first, lift, place } => {
                let [x, y, z] = named;
                let mut at = from;
                if z && z_first {
                    at.z = self.at.z;
                    strokes.go(at);
                }
                if (x || y) && at.z < lift {
                    at.z = lift;
                    strokes.go(at);
                }
                if x {
                    at.x = self.at.x;
                    strokes.go(at);
                }
                if y {
                    at.y = self.at.y;
                    strokes.go(at);
                }
                if z && !z_first {
                    if let Some(place) = place {
                        at = place.extend(at.z.max(lift));
                        strokes.go(at);
                    }
                    strokes.go(at.with_z(self.at.z));
                }
            }
        }
        strokes
    }

    /// Height of the tip when the first carriage of a delta is at its end: until then all climb
    /// alike, so the tip rises straight.
    fn first_end(&self, from: DVec3, radius: f64, arm: f64) -> f64 {
        // A carriage is √(arm² − d²) above the tip, d the distance over xy to its tower.
        let above = |squared_d: f64| (arm * arm - squared_d).max(0.0).sqrt();
        let end = self.at.z + above(radius * radius);
        let highest = TOWERS.iter().map(|turn| {
            let tower = DVec2::from_angle(turn * std::f64::consts::TAU) * radius;
            above(tower.distance_squared(from.truncate()))
        });
        (end - highest.fold(0.0, f64::max)).max(from.z)
    }
}

/// Where the strokes of a homing end.
#[derive(Debug, Clone, Copy)]
pub struct HomingStrokes {
    ends: [DVec3; STROKES],
    count: usize,
}

impl HomingStrokes {
    fn go(&mut self, to: DVec3) {
        if let Some(end) = self.ends.get_mut(self.count) {
            *end = to;
            self.count += 1;
        }
    }

    /// The ends, in order.
    pub fn iter(&self) -> impl Iterator<Item = DVec3> {
        self.ends.iter().take(self.count).copied()
    }
}

#[cfg(test)]
mod tests {
    use glam::{dvec2, dvec3};

    use super::*;

    fn ends(homing: Homing, from: DVec3, named: [bool; 3]) -> Vec<DVec3> {
        homing.strokes(from, named).iter().collect()
    }

    #[test]
    fn axes_home_one_after_the_other_and_only_those_that_are_named() {
        let from = dvec3(5.0, 6.0, 7.0);
        let all = ends(Homing::AT_ORIGIN, from, [true; 3]);
        assert_eq!(all, [dvec3(0.0, 6.0, 7.0), dvec3(0.0, 0.0, 7.0), DVec3::ZERO]);
        let y = ends(Homing::AT_ORIGIN, from, [false, true, false]);
        assert_eq!(y, [dvec3(5.0, 0.0, 7.0)]);
    }

    #[test]
    fn z_rises_first_where_its_end_is_at_the_top() {
        let way = Way::Axes { z_first: true, lift: 0.0, place: None };
        let homing = Homing { at: dvec3(0.0, 0.0, 200.0), way };
        let all = ends(homing, dvec3(5.0, 6.0, 7.0), [true; 3]);
        assert_eq!(all[0], dvec3(5.0, 6.0, 200.0));
        assert_eq!(all[2], homing.at);
    }

    #[test]
    fn a_lift_comes_before_x_and_y_and_z_is_homed_in_its_place() {
        let way = Way::Axes { z_first: false, lift: 10.0, place: Some(dvec2(50.0, 60.0)) };
        let homing = Homing { at: dvec3(0.0, 0.0, 0.0), way };
        let all = ends(homing, dvec3(5.0, 6.0, 7.0), [true; 3]);
        assert_eq!(all[0], dvec3(5.0, 6.0, 10.0));
        assert_eq!(all[3..], [dvec3(50.0, 60.0, 10.0), dvec3(50.0, 60.0, 0.0)]);
        let high = ends(homing, dvec3(5.0, 6.0, 70.0), [true, false, false]);
        assert_eq!(high, [dvec3(0.0, 6.0, 70.0)]);
    }

    #[test]
    fn a_delta_rises_until_its_first_carriage_is_home_and_never_sinks() {
        let homing =
            Homing { at: dvec3(0.0, 0.0, 280.0), way: Way::Delta { radius: 101.0, arm: 218.0 } };
        for angle in 0..12 {
            let out = DVec2::from_angle(f64::from(angle)) * 85.0;
            let [up, home] = ends(homing, out.extend(3.0), [true, false, false])[..] else {
                unreachable!("two strokes");
            };
            assert_eq!(up.truncate(), out);
            assert!((250.0..280.0).contains(&up.z), "{up}");
            assert_eq!(home, homing.at);
        }
        assert!((ends(homing, dvec3(0.0, 0.0, 3.0), [true; 3])[0].z - 280.0).abs() < 1e-9);
    }
}
