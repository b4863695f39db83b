//! The cut and the nesting, on solids whose sections are known.

#![allow(clippy::unwrap_used, reason = "a test may panic")]

mod solids;

use glam::{DMat3, DVec2, DVec3};
use solids::{Random, cuboid, inverted, moved, revolved, sphere, together, torus};
use wireprint_core::contours::{Contour, contours, sliced, union};
use wireprint_core::geometry::polygon::{length, signed_area};
use wireprint_core::mesh::Mesh;
use wireprint_core::slices::{Loop, Plane, Side, cut};

const SIDES: [Side; 2] = [Side::Below, Side::Above];

fn plane(z: f64, side: Side) -> Plane {
    Plane { z, side }
}

fn slice(mesh: &Mesh, z: f64, side: Side) -> Vec<Contour> {
    sliced(mesh, &[plane(z, side)], 0.0).remove(0)
}

fn total(contours: &[Contour]) -> f64 {
    contours.iter().map(|c| c.area).sum()
}

fn assert_close(got: f64, wanted: f64, tolerance: f64) {
    assert!((got - wanted).abs() <= tolerance, "{got} is not {wanted} within {tolerance}");
}

/// Random heights over the mesh's extent, and its vertices' own, from both sides.
fn all_planes(mesh: &Mesh, count: usize, random: &mut Random) -> Vec<Plane> {
    let (low, high) = mesh.bounds();
    let heights = (0..count).map(|_| random.between(low.z - 0.1, high.z + 0.1));
    let own = mesh.vertices.iter().map(|v| v.z).take(count);
    heights.chain(own).flat_map(|z| SIDES.map(|side| plane(z, side))).collect()
}

#[test]
fn a_closed_mesh_gives_only_closed_loops_at_any_height_and_rotation() {
    let mut random = Random(1);
    let solids = [
        cuboid(DVec3::ZERO, DVec3::ONE),
        sphere(12),
        torus(3.0, 1.0, 24, 12),
        revolved(&[(2.0, 0.0), (0.5, 1.0), (0.5, 2.0), (0.0, 3.0)], 9),
    ];
    for solid in &solids {
        for turn in 0..20 {
            let rotation = if turn == 0 { DMat3::IDENTITY } else { random.rotation() };
            let mesh = moved(solid, rotation, DVec3::ZERO);
            for l in cut(&mesh, &all_planes(&mesh, 500, &mut random)).iter().flatten() {
                assert!(l.closed);
                assert_eq!(l.points.len(), l.faces.len());
            }
        }
    }
}

#[test]
fn sections_integrate_to_the_volume() {
    let mut random = Random(2);
    for solid in [torus(3.0, 1.0, 48, 24), sphere(24), cuboid(DVec3::ZERO, DVec3::ONE)] {
        let mesh = moved(&solid, random.rotation(), DVec3::ZERO);
        let (low, high) = mesh.bounds();
        let n = 4000;
        let step = (high.z - low.z) / f64::from(n);
        let middles = (0..n).map(|i| plane(low.z + (f64::from(i) + 0.5) * step, Side::Below));
        let slices = sliced(&mesh, &middles.collect::<Vec<_>>(), 0.0);
        let volume: f64 = slices.iter().map(|slice| total(slice) * step).sum();
        assert_close(volume, mesh.volume(), 1e-5 * mesh.volume());
    }
}

#[test]
fn a_cube_has_its_square_from_both_ends_and_nothing_beyond() {
    let mesh = cuboid(DVec3::ZERO, DVec3::splat(28.0));
    for (z, side, area) in [
        (0.0, Side::Below, 0.0),
        (0.0, Side::Above, 784.0),
        (14.0, Side::Below, 784.0),
        (28.0, Side::Below, 784.0),
        (28.0, Side::Above, 0.0),
    ] {
        let contours = slice(&mesh, z, side);
        assert_close(total(&contours), area, 1e-9);
        assert_eq!(contours.len(), usize::from(area > 0.0));
        let around: f64 = contours.iter().map(|c| length(&c.points, true)).sum();
        assert_close(around, 4.0 * area.sqrt(), 1e-9);
    }
}

#[test]
fn a_pyramid_shrinks_with_the_square_of_height_to_a_point() {
    let n = 64;
    let mesh = revolved(&[(5.0, 0.0), (0.0, 8.0)], n);
    let base = 0.5 * n as f64 * 25.0 * (std::f64::consts::TAU / n as f64).sin();
    for z in [0.5, 2.0, 7.75] {
        let contours = slice(&mesh, z, Side::Below);
        assert_close(total(&contours), base * (1.0 - z / 8.0).powi(2), 1e-9);
    }
    let apex = cut(&mesh, &[plane(8.0, Side::Below)]).remove(0);
    assert_eq!(apex.len(), 1);
    assert_eq!(apex[0].points, [DVec2::ZERO]);
    assert!(slice(&mesh, 8.0, Side::Above).is_empty());
}

#[test]
fn a_sphere_has_circles() {
    let mesh = sphere(300);
    for z in [-0.9_f64, -0.31, 0.0, 0.5] {
        let contours = slice(&mesh, z, Side::Below);
        assert_eq!(contours.len(), 1);
        let square = 1.0 - z * z;
        assert_close(contours[0].area, std::f64::consts::PI * square, 5e-4);
        let around = length(&contours[0].points, true);
        assert_close(around, std::f64::consts::TAU * square.sqrt(), 5e-4);
    }
}

#[test]
fn a_lying_torus_has_a_hole_and_a_standing_one_has_two_islands() {
    let mesh = torus(3.0, 1.0, 128, 64);
    let lying = slice(&mesh, 0.3, Side::Below);
    assert_eq!(lying.iter().map(|c| c.depth).collect::<Vec<_>>(), [0, 1]);
    assert_eq!(lying[1].parent, Some(0));
    assert!(lying[0].area > 0.0 && lying[1].area < 0.0);
    let width = 2.0 * (1.0_f64 - 0.09).sqrt();
    assert_close(total(&lying), std::f64::consts::TAU * 3.0 * width, 0.1);

    let upright = moved(&mesh, DMat3::from_rotation_x(1.5), DVec3::ZERO);
    let standing = slice(&upright, 0.3, Side::Below);
    assert_eq!(standing.iter().map(|c| c.depth).collect::<Vec<_>>(), [0, 0]);
    assert!(standing.iter().all(|c| c.area > 0.0));
}

#[test]
fn planes_in_any_order_and_repeated_give_the_same_slices() {
    let mesh = torus(3.0, 1.0, 24, 12);
    let mut random = Random(3);
    let mut planes = all_planes(&mesh, 40, &mut random);
    planes.extend_from_within(..20);
    let together = cut(&mesh, &planes);
    for (one, loops) in planes.iter().zip(&together) {
        let alone = cut(&mesh, &[*one]).remove(0);
        assert_eq!(format!("{alone:?}"), format!("{loops:?}"));
    }
}

#[test]
fn one_thread_and_many_give_the_same_slices() {
    let mut random = Random(9);
    let mesh =
        together(&[sphere(40), moved(&torus(1.0, 0.4, 60, 30), random.rotation(), DVec3::X)]);
    let planes = all_planes(&mesh, 100, &mut random);
    let with = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        format!("{:?}", pool.install(|| sliced(&mesh, &planes, 0.0)))
    };
    let alone = with(1);
    assert!((2..6).all(|threads| with(threads) == alone));
}

#[test]
fn every_segment_lies_on_the_face_that_it_names() {
    let mut random = Random(4);
    let mesh = moved(&torus(3.0, 1.0, 24, 12), random.rotation(), DVec3::ZERO);
    let z = 0.4;
    for l in cut(&mesh, &[plane(z, Side::Below)]).remove(0) {
        let n = l.points.len();
        for (i, &face) in l.faces.iter().enumerate() {
            let [a, b, c] = mesh.corners(face as usize);
            let normal = (b - a).cross(c - a).normalize();
            for p in [l.points[i], l.points[(i + 1) % n]] {
                assert_close((p.extend(z) - a).dot(normal), 0.0, 1e-12);
            }
            let along = l.points[(i + 1) % n] - l.points[i];
            assert!(along.perp_dot(normal.truncate()) <= 1e-12, "solid lies to the left");
        }
    }
}

#[test]
fn an_open_mesh_gives_open_polylines_with_both_ends_on_the_border() {
    let mut mesh = cuboid(DVec3::ZERO, DVec3::ONE);
    mesh.faces.retain(|f| f.iter().any(|&v| mesh.vertices[v as usize].x == 0.0));
    mesh.faces.retain(|f| !f.iter().all(|&v| mesh.vertices[v as usize].x == 0.0));
    let mesh = Mesh::new(mesh.vertices, mesh.faces);
    let loops = cut(&mesh, &[plane(0.5, Side::Below)]).remove(0);
    assert!(!loops.is_empty());
    for l in &loops {
        assert!(!l.closed);
        assert_eq!(l.faces.len() + 1, l.points.len());
    }
    let contours = contours(loops, 0.0);
    assert!(contours.iter().all(|c| c.area == 0.0 && !c.closed));
}

#[test]
fn shells_inside_shells_nest_by_depth() {
    let onion: Vec<Mesh> = (1..=6)
        .map(|i| {
            let shell = cuboid(DVec3::splat(-f64::from(i)), DVec3::splat(f64::from(i)));
            if i % 2 == 0 { shell } else { inverted(&shell) }
        })
        .collect();
    let contours = slice(&together(&onion), 0.25, Side::Below);
    assert_eq!(contours.iter().map(|c| c.depth).collect::<Vec<_>>(), [0, 1, 2, 3, 4, 5]);
    assert_close(total(&contours), 144.0 - 100.0 + 64.0 - 36.0 + 16.0 - 4.0, 1e-9);
}

#[test]
fn overlapping_shells_become_one_contour_whose_segments_keep_their_faces() {
    let mesh = together(&[
        cuboid(DVec3::ZERO, DVec3::splat(2.0)),
        cuboid(DVec3::splat(1.0), DVec3::splat(3.0)),
    ]);
    let z = 1.5;
    let contours = slice(&mesh, z, Side::Below);
    assert_eq!(contours.len(), 1);
    assert_close(contours[0].area, 7.0, 1e-8);
    let n = contours[0].points.len();
    for (i, &face) in contours[0].faces.iter().enumerate() {
        let [a, b, c] = mesh.corners(face as usize);
        let normal = (b - a).cross(c - a).normalize();
        for p in [contours[0].points[i], contours[0].points[(i + 1) % n]] {
            assert_close((p.extend(z) - a).dot(normal), 0.0, 1e-8);
        }
    }
}

#[test]
fn a_shell_wholly_inside_another_vanishes() {
    let mesh = together(&[
        cuboid(DVec3::ZERO, DVec3::splat(3.0)),
        cuboid(DVec3::splat(1.0), DVec3::splat(2.0)),
    ]);
    let contours = slice(&mesh, 1.5, Side::Below);
    assert_eq!(contours.len(), 1);
    assert_close(contours[0].area, 9.0, 1e-8);
}

#[test]
fn an_inside_out_shell_is_filled_all_the_same() {
    let contours = slice(&inverted(&cuboid(DVec3::ZERO, DVec3::ONE)), 0.5, Side::Below);
    assert_eq!(contours.len(), 1);
    assert_close(contours[0].area, 1.0, 1e-8);
}

#[test]
fn boxes_that_share_a_wall_become_one_contour() {
    let mesh = together(&[
        cuboid(DVec3::ZERO, DVec3::ONE),
        cuboid(DVec3::new(1.0, 0.25, 0.0), DVec3::new(2.0, 0.75, 1.0)),
    ]);
    let mut random = Random(10);
    for turn in 0..100 {
        let angle = if turn == 0 { 0.0 } else { random.between(0.0, 7.0) };
        let mesh = moved(&mesh, DMat3::from_rotation_z(angle), DVec3::splat(angle));
        let contours = slice(&mesh, angle + 0.5, Side::Below);
        assert_eq!(contours.len(), 1, "at {angle}");
        assert_close(contours[0].area, 1.5, 1e-8);
    }
}

#[test]
fn contours_that_touch_in_a_vertex_stay_as_they_are() {
    let mesh = moved(&torus(3.0, 1.0, 24, 16), DMat3::from_rotation_x(TURN), DVec3::ZERO);
    // The saddle of a standing torus: two legs below meet where one contour begins above.
    let saddle = mesh.vertices.iter().map(|v| v.z).filter(|&z| z > 1.5).fold(9.0, f64::min);
    let below = slice(&mesh, saddle, Side::Below);
    let above = slice(&mesh, saddle, Side::Above);
    assert_close(total(&below), total(&above), 1e-9);
    assert!(below.len() + above.len() >= 3);
    for contour in below.iter().chain(&above) {
        let whole = signed_area(&contour.points);
        assert_eq!(whole, contour.area);
    }
}

const TURN: f64 = std::f64::consts::FRAC_PI_2;

#[test]
fn nesting_agrees_with_testing_every_pair_of_squares() {
    let mut random = Random(5);
    for _ in 0..200 {
        let squares = random_squares(&mut random);
        let loops = squares.iter().map(|s| s.as_loop()).collect();
        let contours = contours(loops, 0.0);
        assert_eq!(contours.len(), squares.len());
        for contour in &contours {
            let p = contour.points[0];
            let around = contours.iter().filter(|c| c.area.abs() > contour.area.abs());
            let around: Vec<_> = around.filter(|c| inside(p, &c.points)).collect();
            assert_eq!(around.len(), contour.depth as usize);
            let nearest = around.iter().map(|c| c.area.abs()).fold(f64::INFINITY, f64::min);
            match contour.parent {
                Some(parent) => assert_eq!(contours[parent as usize].area.abs(), nearest),
                None => assert!(around.is_empty()),
            }
        }
    }
}

#[test]
fn loops_that_do_not_meet_keep_their_very_points() {
    let mut random = Random(8);
    for _ in 0..20 {
        let mesh = moved(&torus(3.0, 1.0, 48, 24), random.rotation(), DVec3::splat(0.1));
        let planes = all_planes(&mesh, 50, &mut random);
        for (loops, contours) in cut(&mesh, &planes).iter().zip(sliced(&mesh, &planes, 0.0)) {
            for contour in &contours {
                assert!(loops.iter().any(|l| l.points == contour.points));
            }
            assert_eq!(loops.len(), contours.len());
        }
    }
}

#[test]
fn contours_cover_what_the_union_covers_for_any_loops() {
    let mut random = Random(6);
    for round in 0..3000 {
        // Points on a coarse grid meet, touch and overlap in every way; others never do.
        let grid = round % 2 == 0;
        let loops: Vec<Loop> = (0..1 + round % 4).map(|_| scribble(&mut random, grid)).collect();
        let covered: f64 = union(loops.clone()).iter().map(|l| signed_area(&l.points)).sum();
        let contours = contours(loops.clone(), 0.0);
        assert!((total(&contours) - covered).abs() < 1e-6, "round {round}: {loops:?}");
        for contour in contours.iter().filter(|contour| contour.area != 0.0) {
            assert_eq!(contour.area > 0.0, contour.depth % 2 == 0, "round {round}: {loops:?}");
        }
    }
}

/// A closed loop through random points.
fn scribble(random: &mut Random, grid: bool) -> Loop {
    let count = 3 + (random.unit() * 5.0) as usize;
    let mut points: Vec<DVec2> = Vec::new();
    while points.len() < count {
        let p = DVec2::new(random.between(0.0, 6.0), random.between(0.0, 6.0));
        let p = if grid { p.floor() } else { p };
        if points.last() != Some(&p) && (points.len() + 1 < count || points[0] != p) {
            points.push(p);
        }
    }
    Loop { faces: (0..count as u32).collect(), points, closed: true }
}

/// A square standing at some angle, with the depth at which it was made.
struct Square {
    centre: DVec2,
    half: DVec2,
    depth: usize,
}

impl Square {
    fn as_loop(&self) -> Loop {
        let turn = DVec2::new(-self.half.y, self.half.x);
        let mut points: Vec<DVec2> =
            [self.half, turn, -self.half, -turn].map(|d| self.centre + d).to_vec();
        if self.depth % 2 == 1 {
            points.reverse();
        }
        Loop { points, faces: vec![0, 1, 2, 3], closed: true }
    }
}

/// Squares in squares: each holds up to four smaller ones in its quarters.
fn random_squares(random: &mut Random) -> Vec<Square> {
    let half = DVec2::from_angle(random.between(0.0, 6.0)) * 10.0;
    let mut squares = vec![Square { centre: DVec2::ZERO, half, depth: 0 }];
    let mut next = 0;
    while next < squares.len() && squares.len() < 60 {
        let Square { centre, half, depth } = squares[next];
        next += 1;
        for way in [half, half.perp(), -half, -half.perp()] {
            if random.unit() < 0.6 {
                // A circle of radius 0.45 about the middle of the way lies in the quarter.
                let size = half.length() * random.between(0.05, 0.3);
                let turned = DVec2::from_angle(random.between(0.0, 6.0)) * size;
                squares.push(Square { centre: centre + way * 0.5, half: turned, depth: depth + 1 });
            }
        }
    }
    squares
}

fn inside(p: DVec2, ring: &[DVec2]) -> bool {
    let n = ring.len();
    let crossings = (0..n).filter(|&i| {
        let (a, b) = (ring[i], ring[(i + 1) % n]);
        (a.y > p.y) != (b.y > p.y) && p.x < a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x)
    });
    crossings.count() % 2 == 1
}
