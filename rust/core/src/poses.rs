//! Poses in which a model may be printed: along the axes, and as it comes to rest when it falls.
//!
//! A body that lies on a plane rolls towards its centre of mass until that stands over what it
//! touches the plane with. Let go in many directions it finds every pose that is worth a name;
//! rolled step by step, from contact to contact, these are exact.

use glam::{DQuat, DVec2, DVec3, EulerRot};
use rayon::prelude::*;

use crate::geometry::polygon::convex_hull;
use crate::mesh::Mesh;

/// Points this near to the plane, as a share of the model's extent, touch it.
const TOUCH: f64 = 2e-5;
/// Poses nearer than this are one, rad.
const SAME: f64 = 2e-3;
/// Far more contacts than any model rolls over.
const MOST_ROLLS: usize = 200;
/// A surface that faces down more than this (the cosine from the vertical) hangs.
const HANGING: f64 = 0.7;

/// A way to stand a model on the bed.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Pose {
    /// The turn that leads there.
    pub turn: DQuat,
    /// Whether the model rests there by itself.
    pub rests: bool,
    /// Area in plan of the surface that hangs over the air, mm².
    pub hanging: f64,
}

impl Pose {
    /// The turn as angles about x, then y, then z, rad.
    #[must_use]
    pub fn angles(&self) -> DVec3 {
        let (z, y, x) = self.turn.to_euler(EulerRot::ZYX);
        DVec3::new(x, y, z)
    }
}

impl Mesh {
    /// The pose it is given in first, then those in which it rests, the most stable first, then
    /// the other axes.
    #[must_use]
    pub fn poses(&self) -> Vec<Pose> {
        let given = -DVec3::Z;
        let axes = [given, DVec3::Z, -DVec3::X, DVec3::X, -DVec3::Y, DVec3::Y];
        let centre = self.centroid();
        let mut rests: Vec<(f64, DVec3)> = directions()
            .par_iter()
            .filter_map(|&d| self.at_rest(centre, d))
            .map(|d| (self.depth(d) - centre.dot(d), d))
            .collect();
        // What lies lowest lies safest.
        rests.sort_by(|a, b| a.0.total_cmp(&b.0));
        let mut downs = vec![(given, false)];
        for (down, rest) in rests.iter().map(|r| (r.1, true)).chain(axes.map(|d| (d, false))) {
            match downs.iter_mut().find(|d| d.0.angle_between(down) < SAME) {
                Some(same) => same.1 |= rest,
                None => downs.push((down, rest)),
            }
        }
        let pose = |&(down, rests): &(DVec3, bool)| Pose {
            turn: turn(down),
            rests,
            hanging: self.hanging(down),
        };
        downs.par_iter().map(pose).collect()
    }

    /// Centre of mass of the surface: a wire print is a shell.
    fn centroid(&self) -> DVec3 {
        let (mut sum, mut area) = (DVec3::ZERO, 0.0);
        for f in 0..self.faces.len() {
            let [a, b, c] = self.corners(f);
            let twofold = (b - a).cross(c - a).length();
            sum += twofold * (a + b + c) / 3.0;
            area += twofold;
        }
        sum / area.max(f64::MIN_POSITIVE)
    }

    /// The direction that points down once the model, let go with `down` below, has come to rest.
    fn at_rest(&self, centre: DVec3, mut down: DVec3) -> Option<DVec3> {
        let (low, high) = self.bounds();
        let touch = TOUCH * (high - low).max_element();
        for _ in 0..MOST_ROLLS {
            let depth = self.depth(down);
            let (x, y) = down.any_orthonormal_pair();
            let plan = |v: DVec3| DVec2::new((v - centre).dot(x), (v - centre).dot(y));
            let touching: Vec<DVec2> = self
                .vertices
                .iter()
                .filter(|v| depth - v.dot(down) < touch)
                .map(|&v| plan(v))
                .collect();
            let Some(pivot) = nearest_to_origin(&convex_hull(touching)) else {
                return Some(self.squared(down, depth, touch));
            };
            down = self.roll(centre, down, depth, x * pivot.x + y * pivot.y, touch)?;
        }
        None
    }

    /// Rolls over a pivot, given from beneath the centre, until something else touches.
    fn roll(
        &self,
        centre: DVec3,
        down: DVec3,
        depth: f64,
        pivot: DVec3,
        touch: f64,
    ) -> Option<DVec3> {
        let back = -pivot.try_normalize()?;
        let at = centre + pivot + down * (depth - centre.dot(down));
        let angle = |v: &DVec3| {
            let away = *v - at;
            let (ahead, up) = (away.dot(back), -away.dot(down));
            (ahead > touch && up > 0.5 * touch).then(|| up.atan2(ahead))
        };
        let least = self.vertices.iter().filter_map(angle).min_by(f64::total_cmp)?;
        Some((down * least.cos() + back * least.sin()).normalize())
    }

    /// A resting direction squared with the flat face, if there is one, that it rests on.
    fn squared(&self, down: DVec3, depth: f64, touch: f64) -> DVec3 {
        let touches = |v: &u32| depth - self.vertices[*v as usize].dot(down) < 2.0 * touch;
        let mut sum = DVec3::ZERO;
        for (f, _) in self.faces.iter().enumerate().filter(|(_, face)| face.iter().all(touches)) {
            let [a, b, c] = self.corners(f);
            sum += (b - a).cross(c - a);
        }
        sum.try_normalize().filter(|n| n.angle_between(down) < SAME).unwrap_or(down)
    }

    /// How far the model reaches in a direction, mm.
    fn depth(&self, down: DVec3) -> f64 {
        self.vertices.iter().map(|v| v.dot(down)).fold(f64::NEG_INFINITY, f64::max)
    }

    /// Area in plan that would hang, mm², with `down` below.
    fn hanging(&self, down: DVec3) -> f64 {
        let (low, high) = self.bounds();
        let foot = self.depth(down) - 10.0 * TOUCH * (high - low).max_element();
        let mut area = 0.0;
        for f in 0..self.faces.len() {
            let corners @ [a, b, c] = self.corners(f);
            let normal = (b - a).cross(c - a);
            let plan = normal.dot(down);
            if plan > HANGING * normal.length() && corners.iter().any(|v| v.dot(down) < foot) {
                area += 0.5 * plan;
            }
        }
        area
    }
}

/// The smallest turn that brings a direction down; over the x axis where it points up.
fn turn(down: DVec3) -> DQuat {
    if down.dot(DVec3::Z) > 1.0 - 1e-12 {
        return DQuat::from_rotation_x(std::f64::consts::PI);
    }
    DQuat::from_rotation_arc(down, -DVec3::Z)
}

/// Directions to let a model go in: towards the faces, edges and corners of a cube.
fn directions() -> Vec<DVec3> {
    let step = |i: i32| f64::from(i % 3 - 1);
    let all = (0..27).map(|i| DVec3::new(step(i), step(i / 3), step(i / 9)));
    all.filter_map(DVec3::try_normalize).collect()
}

/// The point of a convex polygon (counter-clockwise; a segment or a point, too) that is nearest
/// to the origin; none where the origin lies within.
fn nearest_to_origin(polygon: &[DVec2]) -> Option<DVec2> {
    let count = polygon.len();
    let sides = (0..count).map(|i| (polygon[i], polygon[(i + 1) % count]));
    if count > 2 && sides.clone().all(|(a, b)| (b - a).perp_dot(-a) >= 0.0) {
        return None;
    }
    let on_side = |(a, b): (DVec2, DVec2)| {
        let along = b - a;
        a + along * (-a.dot(along) / along.length_squared().max(f64::MIN_POSITIVE)).clamp(0.0, 1.0)
    };
    sides.map(on_side).min_by(|a, b| a.length_squared().total_cmp(&b.length_squared()))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn cuboid(size: DVec3) -> Mesh {
        let corner = |i: usize| {
            let pick = |axis: usize| if i >> axis & 1 == 0 { 0.0 } else { size[axis] };
            DVec3::new(pick(0), pick(1), pick(2))
        };
        let quads =
            [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]];
        let faces = quads.iter().flat_map(|&[a, b, c, d]| [[a, b, c], [a, c, d]]).collect();
        Mesh::new((0..8).map(corner).collect(), faces)
    }

    fn tipped(mut mesh: Mesh, turn: DQuat) -> Mesh {
        mesh.vertices.iter_mut().for_each(|v| *v = turn * *v);
        mesh
    }

    #[test]
    fn the_given_pose_comes_first_and_is_left_alone() {
        let first = cuboid(DVec3::new(10.0, 20.0, 30.0)).poses()[0];
        assert_eq!(first.turn, DQuat::IDENTITY);
    }

    #[test]
    fn a_box_rests_on_its_six_faces_however_it_lies() {
        for turn in [DQuat::IDENTITY, DQuat::from_euler(EulerRot::XYZ, 0.3, -1.1, 0.7)] {
            let mesh = tipped(cuboid(DVec3::new(10.0, 20.0, 30.0)), turn);
            let poses = mesh.poses();
            let rests: Vec<&Pose> = poses.iter().filter(|p| p.rests).collect();
            assert_eq!(rests.len(), 6);
            for pose in rests {
                let heights = mesh.vertices.iter().map(|&v| (pose.turn * v).z);
                let low = heights.clone().fold(f64::INFINITY, f64::min);
                assert_eq!(heights.filter(|z| z - low < 1e-9).count(), 4);
                assert!(pose.hanging < 1e-6);
            }
        }
    }

    #[test]
    fn a_leaning_box_falls_over() {
        // Sheared by more than its width: it does not rest on its base any more.
        let mut mesh = cuboid(DVec3::new(10.0, 10.0, 30.0));
        mesh.vertices.iter_mut().for_each(|v| v.x += 0.5 * v.z);
        let poses = mesh.poses();
        assert!(!poses[0].rests);
        assert!(poses.iter().any(|p| p.rests));
    }

    #[test]
    fn angles_make_the_same_turn() {
        let mesh = tipped(cuboid(DVec3::new(3.0, 4.0, 5.0)), DQuat::from_rotation_x(0.4));
        for pose in mesh.poses() {
            let a = pose.angles();
            let same = DQuat::from_rotation_z(a.z)
                * DQuat::from_rotation_y(a.y)
                * DQuat::from_rotation_x(a.x);
            assert!((same * DVec3::ONE).distance(pose.turn * DVec3::ONE) < 1e-9);
        }
    }

    #[test]
    fn what_overhangs_the_air_is_measured_in_plan() {
        let mut mesh = cuboid(DVec3::new(10.0, 20.0, 30.0));
        let mut upper = cuboid(DVec3::new(10.0, 20.0, 5.0));
        upper.vertices.iter_mut().for_each(|v| v.z += 50.0);
        let shift = mesh.vertices.len() as u32;
        mesh.vertices.append(&mut upper.vertices);
        mesh.faces.extend(upper.faces.iter().map(|f| f.map(|v| v + shift)));
        let both = Mesh::new(mesh.vertices, mesh.faces);
        assert!((both.poses()[0].hanging - 200.0).abs() < 1e-6);
    }
}
