//! Which surface counts for coverage: the outer one, but for what options leave out on purpose.
#![allow(clippy::unwrap_used)]

use std::f64::consts::{PI, TAU};

use glam::{DVec3, dvec3};
use wireprint_core::fidelity::{Coverage, Terms, coverage};
use wireprint_core::mesh::Mesh;

const TERMS: Terms =
    Terms { within: 4.0, strand: 0.7, level: 0.175, caps: true, supports: true, span: 65.0 };

/// Bodies side by side in one mesh.
#[derive(Default, Clone)]
struct Model {
    vertices: Vec<DVec3>,
    faces: Vec<[u32; 3]>,
}

impl Model {
    fn add(mut self, vertices: &[DVec3], faces: &[[u32; 3]]) -> Self {
        let first = self.vertices.len() as u32;
        self.vertices.extend(vertices);
        self.faces.extend(faces.iter().map(|face| face.map(|v| first + v)));
        self
    }

    /// A box between two corners; turned inside out, a hollow.
    fn cuboid(self, low: [f64; 3], high: [f64; 3], hollow: bool) -> Self {
        let ends = [DVec3::from(low), DVec3::from(high)];
        let corner = |i: usize| dvec3(ends[i & 1].x, ends[i >> 1 & 1].y, ends[i >> 2].z);
        let quads =
            [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]];
        let faces: Vec<[u32; 3]> =
            quads.iter().flat_map(|&[a, b, c, d]| [[a, b, c], [a, c, d]]).collect();
        let turned = faces.iter().map(|&[a, b, c]| if hollow { [a, c, b] } else { [a, b, c] });
        self.add(&(0..8).map(corner).collect::<Vec<_>>(), &turned.collect::<Vec<_>>())
    }

    /// A ball in latitude and longitude, its poles along `axis`.
    fn ball(self, centre: DVec3, radius: f64, axis: usize, n: u32) -> Self {
        let point = |i: u32, j: u32| {
            let (polar, around) =
                (PI * f64::from(i) / f64::from(n), TAU * f64::from(j) / f64::from(2 * n));
            let [x, y, z] = [polar.sin() * around.cos(), polar.sin() * around.sin(), polar.cos()];
            let p = [dvec3(z, x, y), dvec3(y, z, x), dvec3(x, y, z)][axis];
            centre + radius * p
        };
        let mut vertices = vec![point(0, 0), point(n, 0)];
        vertices
            .extend((1..n).flat_map(|i| (0..2 * n).map(move |j| (i, j))).map(|(i, j)| point(i, j)));
        let at = |i: u32, j: u32| match i {
            0 => 0,
            _ if i == n => 1,
            _ => 2 + (i - 1) * 2 * n + j % (2 * n),
        };
        let mut faces = Vec::new();
        for i in 0..n {
            for j in 0..2 * n {
                faces.push([at(i, j), at(i + 1, j), at(i + 1, j + 1)]);
                faces.push([at(i, j), at(i + 1, j + 1), at(i, j + 1)]);
            }
        }
        faces.retain(|&[a, b, c]| a != b && b != c && c != a);
        self.add(&vertices, &faces)
    }

    fn mesh(self) -> Mesh {
        Mesh::new(self.vertices, self.faces)
    }

    /// Of the surface without any strand: share, area that counts, patches.
    fn bare(self, terms: &Terms) -> Coverage {
        coverage(&self.mesh(), &[], terms)
    }
}

fn assert_area(found: &Coverage, area: f64) {
    let sum: f64 = found.uncovered.iter().map(|patch| patch.area).sum();
    assert!((sum - area).abs() < 0.004 * area, "bare: {sum}, not {area}");
    assert!((found.area - area).abs() < 0.004 * area, "counts: {}, not {area}", found.area);
}

#[test]
fn faces_between_bodies_that_touch_are_no_surface() {
    let stacked = Model::default().cuboid([0.0; 3], [40.0, 40.0, 10.0], false).cuboid(
        [0.0, 0.0, 10.0],
        [40.0, 40.0, 20.0],
        false,
    );
    assert_area(&stacked.bare(&TERMS), 2.0 * 1600.0 + 4.0 * 800.0);
    let beside = Model::default().cuboid([0.0; 3], [20.0, 40.0, 20.0], false).cuboid(
        [20.0, 10.0, 0.0],
        [40.0, 30.0, 20.0],
        false,
    );
    assert_area(&beside.bare(&TERMS), 4000.0 + 2400.0 - 2.0 * 400.0);
}

#[test]
fn what_lies_within_another_body_or_a_hollow_is_no_surface() {
    let inner =
        Model::default().cuboid([0.0; 3], [30.0; 3], false).cuboid([10.0; 3], [20.0; 3], false);
    assert_area(&inner.bare(&TERMS), 5400.0);
    let shut_in = Model::default()
        .cuboid([0.0; 3], [60.0; 3], false)
        .cuboid([5.0; 3], [55.0; 3], true)
        .cuboid([20.0; 3], [40.0; 3], false);
    assert_area(&shut_in.bare(&TERMS), 21600.0);
}

#[test]
fn a_gap_narrower_than_half_a_strand_shows_none() {
    let gap = |gap: f64| {
        Model::default()
            .cuboid([0.0; 3], [40.0, 40.0, 10.0], false)
            .cuboid([0.0, 0.0, 10.0 + gap], [40.0, 40.0, 20.0 + gap], false)
            .bare(&TERMS)
    };
    assert_area(&gap(0.2), 6400.0);
    assert_area(&gap(0.5), 9600.0);
}

#[test]
fn one_strand_covers_both_sides_of_a_wall_that_is_thinner() {
    let wall = Model::default().cuboid([0.0; 3], [40.0, 0.6, 0.6], false).mesh();
    let strand = [dvec3(0.0, 0.0, 0.3), dvec3(40.0, 0.0, 0.3)];
    let found = coverage(&wall, &[strand], &Terms { within: 0.1, ..TERMS });
    assert!((found.share - 1.0).abs() < 1e-9, "{found:?}");
}

#[test]
fn a_vase_of_one_wall_encloses_what_stands_in_it_and_a_hilly_sheet_does_not() {
    let mut vase = Model::default().cuboid([0.0; 3], [40.0, 40.0, 30.0], false);
    vase.faces.drain(2..4);
    let inner = vase.clone().cuboid([10.0, 10.0, 5.0], [30.0, 30.0, 25.0], false);
    assert_area(&inner.bare(&TERMS), vase.bare(&TERMS).area);
    // A saddle whose rim rises and falls, with a box above its middle.
    let at = |i: u32, j: u32| 11 * i + j;
    let points: Vec<DVec3> = (0..11)
        .flat_map(|i| (0..11).map(move |j| (f64::from(i) - 5.0, f64::from(j) - 5.0)))
        .map(|(x, y)| dvec3(4.0 * x, 4.0 * y, 0.4 * (x * x - y * y)))
        .collect();
    let faces: Vec<[u32; 3]> = (0..10)
        .flat_map(|i| (0..10).map(move |j| (i, j)))
        .flat_map(|(i, j)| {
            [[at(i, j), at(i + 1, j), at(i + 1, j + 1)], [at(i, j), at(i + 1, j + 1), at(i, j + 1)]]
        })
        .collect();
    let hilly = Model::default().add(&points, &faces);
    let whole = hilly.clone().mesh().area();
    let boxed = hilly.clone().cuboid([-3.0, -3.0, 2.0], [3.0, 3.0, 8.0], false);
    assert_area(&hilly.bare(&TERMS), whole);
    assert_area(&boxed.bare(&TERMS), whole + 216.0);
}

/// How often triangles wind around a point, by solid angles (Van Oosterom and Strackee, 1983).
fn winding(mesh: &Mesh, faces: std::ops::Range<usize>, point: DVec3) -> f64 {
    let angle = |face: usize| {
        let [a, b, c] = mesh.corners(face).map(|p| p - point);
        let (la, lb, lc) = (a.length(), b.length(), c.length());
        let along = la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb;
        2.0 * a.dot(b.cross(c)).atan2(along)
    };
    faces.map(angle).sum::<f64>() / (4.0 * PI)
}

#[test]
fn outer_surface_is_what_solid_angles_call_so() {
    let mut state = 11_u64;
    let mut unit = || {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
        (state >> 11) as f64 / (1_u64 << 53) as f64
    };
    for round in 0..4 {
        let mut model = Model::default();
        let mut ends = vec![0];
        for i in 0..5 {
            let centre = dvec3(unit(), unit(), unit()) * 40.0;
            let size = 4.0 + 8.0 * unit();
            model = if (round + i) % 2 == 0 {
                model.ball(centre, size, i % 3, 9)
            } else {
                model.cuboid((centre - size).into(), (centre + size).into(), false)
            };
            ends.push(model.faces.len());
        }
        let mesh = model.clone().mesh();
        // One strand far off, so that everything is bare but what it happens to pass.
        let found = model.bare(&TERMS);
        let outer: f64 = (0..mesh.faces.len())
            .map(|face| {
                let [a, b, c] = mesh.corners(face);
                let normal = (b - a).cross(c - a);
                let (area, off) = (normal.length() / 2.0, normal.normalize() * 0.35);
                let n = (1.5 * area.sqrt()).ceil() as u32;
                let places = (0..n).flat_map(|i| (0..n - i).map(move |j| (i, j)));
                let outside = places.filter(|&(i, j)| {
                    let [u, v] = [i, j].map(|k| (f64::from(k) + 0.33) / f64::from(n));
                    let p = a + (b - a) * u + (c - a) * v + off;
                    ends.windows(2).all(|w| winding(&mesh, w[0]..w[1], p).abs() < 0.5)
                });
                area * outside.count() as f64 / f64::from(n * (n + 1) / 2)
            })
            .sum();
        let sum: f64 = found.uncovered.iter().map(|patch| patch.area).sum();
        assert!((sum - outer).abs() < 0.01 * mesh.area(), "{round}: {sum} {outer}");
        assert!((found.area - outer).abs() < 0.01 * mesh.area(), "{round}: {found:?} {outer}");
    }
}

#[test]
fn two_places_on_one_large_face_are_two_patches_and_one_across_faces_is_one() {
    let plate = Model::default().cuboid([0.0; 3], [100.0, 60.0, 0.5], false).mesh();
    let strands: Vec<[DVec3; 2]> = (0..20)
        .map(|i| dvec3(0.0, 3.0 * f64::from(i) + 1.5, 0.25))
        .flat_map(|p| [[p, p + 20.0 * DVec3::X], [p + 30.0 * DVec3::X, p + 60.0 * DVec3::X]])
        .collect();
    let found = coverage(&plate, &strands, &Terms { within: 2.0, ..TERMS });
    // A strip of 6 mm and the plate's end of 38 mm, each around both rims from top to bottom, but
    // for samples as large as the distance.
    let [end, strip] = found.uncovered[..] else { panic!("{found:?}") };
    assert!((strip.area - 2.0 * 6.0 * 60.5).abs() < 60.0, "{strip:?}");
    assert!((strip.low.x - 22.0).abs() < 2.0 && (strip.high.x - 28.0).abs() < 2.0, "{strip:?}");
    assert!((end.area - (2.0 * 38.0 * 60.5 + 30.0)).abs() < 60.0, "{end:?}");
    assert!(end.high.x == 100.0 && strip.high.z == 0.5 && strip.low.z == 0.0);
}

#[test]
fn level_faces_do_not_count_where_caps_are_off() {
    let open = Terms { caps: false, ..TERMS };
    let block = Model::default().cuboid([0.0; 3], [30.0, 20.0, 10.0], false);
    assert_area(&block.bare(&open), 1000.0);
    let roof = [[0.0, 0.0, 0.0], [30.0, 0.0, 0.0], [30.0, 5.0, 5.0], [0.0, 5.0, 5.0]];
    let sloped = Model::default().add(&roof.map(DVec3::from), &[[0, 1, 2], [0, 2, 3]]);
    assert_area(&sloped.bare(&open), 30.0 * 50.0_f64.sqrt());
}

#[test]
fn what_hangs_does_not_count_where_supports_are_off() {
    let free = Terms { supports: false, ..TERMS };
    // A post with an arm at the top, from whose end a peg hangs down by 10 mm.
    let quad = |p: [[f64; 2]; 12]| {
        let ring = p.iter().flat_map(|&[x, z]| [dvec3(x, 0.0, z), dvec3(x, 10.0, z)]);
        ring.collect::<Vec<_>>()
    };
    let outline = quad([
        [0.0, 0.0],
        [10.0, 0.0],
        [10.0, 20.0],
        [30.0, 20.0],
        [30.0, 10.0],
        [40.0, 10.0],
        [40.0, 20.0],
        [40.0, 30.0],
        [30.0, 30.0],
        [10.0, 30.0],
        [0.0, 30.0],
        [0.0, 20.0],
    ]);
    let side = |i: u32| {
        let (a, b) = (2 * i, 2 * ((i + 1) % 12));
        [[a, b, b + 1], [a, b + 1, a + 1]]
    };
    let ends: [[u32; 4]; 5] =
        [[0, 1, 2, 11], [11, 2, 9, 10], [2, 3, 8, 9], [3, 6, 7, 8], [3, 4, 5, 6]];
    let mut faces: Vec<[u32; 3]> = (0..12).flat_map(side).collect();
    for [a, b, c, d] in ends.map(|quad| quad.map(|i| 2 * i)) {
        faces.extend([[a, c, b], [a, d, c]]);
        faces.extend([[a, b, c], [a, c, d]].map(|face| face.map(|v| v + 1)));
    }
    let faces: Vec<[u32; 3]> = faces.into_iter().map(|[a, b, c]| [a, c, b]).collect();
    let mesh = Model::default().add(&outline, &faces);
    let whole = mesh.clone().mesh().area();
    assert_area(&mesh.clone().bare(&TERMS), whole);
    assert_area(&mesh.bare(&free), whole - 4.0 * 100.0 - 100.0);
    // A body that rests on another does not hang; one that floats does.
    let resting = Model::default().cuboid([0.0; 3], [40.0, 40.0, 10.0], false).cuboid(
        [10.0, 10.0, 10.0],
        [60.0, 30.0, 20.0],
        false,
    );
    assert_area(&resting.clone().bare(&free), resting.bare(&TERMS).area);
    let floating = Model::default().cuboid([0.0; 3], [40.0, 40.0, 10.0], false).cuboid(
        [10.0, 10.0, 15.0],
        [60.0, 30.0, 20.0],
        false,
    );
    assert_area(&floating.bare(&free), 4800.0);
}

#[test]
fn level_faces_wider_than_a_span_do_not_count_without_supports() {
    let roof = Model::default().cuboid([0.0; 3], [90.0, 80.0, 10.0], false).mesh();
    let rim = |x: f64, y: f64| dvec3(x * 90.0, y * 80.0, 5.0);
    let around =
        [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0], [0.0, 0.0]].map(|[x, y]| rim(x, y));
    let strands: Vec<[DVec3; 2]> = around.windows(2).map(|w| [w[0], w[1]]).collect();
    let terms = Terms { within: 5.5, ..TERMS };
    assert!(coverage(&roof, &strands, &terms).share < 0.3);
    let free = Terms { supports: false, ..terms };
    assert_eq!(coverage(&roof, &strands, &free).share, 1.0);
    assert!(coverage(&roof, &strands, &Terms { span: 85.0, ..free }).share < 0.3);
}
