//! Small solids that wire prints are made of.

use glam::{DMat3, DVec3};
use wireprint_core::mesh::Mesh;

use crate::solids::{Random, cuboid, inverted, moved, revolved, sphere, together, torus};

/// A box on the bed, its corners `half` mm from its axis.
pub fn block(half: f64, height: f64) -> Mesh {
    cuboid(DVec3::new(-half, -half, 0.0), DVec3::new(half, half, height))
}

pub fn cylinder(radius: f64, height: f64) -> Mesh {
    revolved(&[(radius, 0.0), (radius, height)], 48)
}

/// A tube whose wall is `wall` mm thick.
pub fn tube(radius: f64, wall: f64, height: f64) -> Mesh {
    let inner = radius - wall;
    let ring = |r: f64, z: f64, i: usize| {
        let angle = std::f64::consts::TAU * i as f64 / 48.0;
        DVec3::new(r * angle.cos(), r * angle.sin(), z)
    };
    let corners = [(radius, 0.0), (radius, height), (inner, height), (inner, 0.0)];
    let vertices: Vec<DVec3> =
        corners.iter().flat_map(|&(r, z)| (0..48).map(move |i| ring(r, z, i))).collect();
    let faces = (0..4_u32).flat_map(|side| {
        (0..48).flat_map(move |i| {
            let at = |side: u32, i: u32| 48 * (side % 4) + i % 48;
            let [a, b] = [at(side, i), at(side, i + 1)];
            let [c, d] = [at(side + 1, i + 1), at(side + 1, i)];
            [[a, b, c], [a, c, d]]
        })
    });
    Mesh::new(vertices, faces.collect())
}

pub fn cone(radius: f64, height: f64) -> Mesh {
    revolved(&[(radius, 0.0), (0.0, height)], 48)
}

/// A cylinder that leans by `degrees`, cut off level at both ends.
pub fn leaning(radius: f64, height: f64, degrees: f64) -> Mesh {
    let slope = degrees.to_radians().tan();
    let shear = DMat3::from_cols(DVec3::X, DVec3::Y, DVec3::new(slope, 0.0, 1.0));
    moved(&cylinder(radius, height), shear, DVec3::ZERO)
}

/// A wide step with a narrow one on it.
pub fn steps() -> Mesh {
    revolved(&[(26.0, 0.0), (26.0, 9.0), (14.0, 9.0), (14.0, 22.0)], 48)
}

/// A thin plate with a boss in its middle.
pub fn plate_with_boss() -> Mesh {
    revolved(&[(30.0, 0.0), (30.0, 2.0), (8.0, 2.0), (8.0, 14.0)], 48)
}

/// A disc on a stem: all of its rim begins in the air.
pub fn mushroom(stem: f64, disc: f64) -> Mesh {
    revolved(&[(stem, 0.0), (stem, 18.0), (disc, 18.0), (disc, 26.0)], 48)
}

pub fn ball(radius: f64) -> Mesh {
    moved(&sphere(24), DMat3::IDENTITY * radius, DVec3::Z * radius)
}

/// A torus that lies on the bed.
pub fn ring() -> Mesh {
    moved(&torus(24.0, 8.0, 64, 32), DMat3::IDENTITY, DVec3::Z * 8.0)
}

/// A torus that stands on the bed: it splits, and merges again.
pub fn wheel() -> Mesh {
    let upright = DMat3::from_rotation_x(std::f64::consts::FRAC_PI_2);
    moved(&torus(26.0, 9.0, 64, 32), upright, DVec3::Z * 35.0)
}

/// A box with a closed hollow in it.
pub fn hollow_box() -> Mesh {
    let hollow = cuboid(DVec3::new(-16.0, -16.0, 6.0), DVec3::new(16.0, 16.0, 20.0));
    together(&[block(24.0, 28.0), inverted(&hollow)])
}

/// A box with a pocket in its top: the pocket's floor lies `deep` mm below.
pub fn pocket(deep: f64) -> Mesh {
    // From the outer bottom up, over the rim, down the pocket; as a square ring with 4 corners.
    let (outer, inner, top) = (24.0, 14.0, 20.0);
    let profile = [(outer, 0.0), (outer, top), (inner, top), (inner, top - deep)];
    let corner = |r: f64, z: f64, i: usize| {
        let [x, y] = [[1.0, 1.0], [-1.0, 1.0], [-1.0, -1.0], [1.0, -1.0]][i];
        DVec3::new(r * x, r * y, z)
    };
    let vertices: Vec<DVec3> =
        profile.iter().flat_map(|&(r, z)| (0..4).map(move |i| corner(r, z, i))).collect();
    let mut faces: Vec<[u32; 3]> = (0..3_u32)
        .flat_map(|k| {
            (0..4_u32).flat_map(move |i| {
                let at = |k: u32, i: u32| 4 * k + i % 4;
                let [a, b, c, d] = [at(k, i), at(k, i + 1), at(k + 1, i + 1), at(k + 1, i)];
                [[a, b, c], [a, c, d]]
            })
        })
        .collect();
    faces.extend([[0, 2, 1], [0, 3, 2], [12, 13, 14], [12, 14, 15]]);
    Mesh::new(vertices, faces)
}

/// Two towers with a beam across.
pub fn bridge(span: f64) -> Mesh {
    let half = 0.5 * span;
    // One outline, extruded along y: no two shells meet face to face.
    let outline = [
        (-half - 10.0, 0.0),
        (-half, 0.0),
        (-half, 16.0),
        (half, 16.0),
        (half, 0.0),
        (half + 10.0, 0.0),
        (half + 10.0, 24.0),
        (-half - 10.0, 24.0),
    ];
    let triangles: [[u32; 3]; 6] =
        [[0, 1, 2], [0, 2, 7], [2, 3, 6], [2, 6, 7], [3, 4, 5], [3, 5, 6]];
    let at = |y: f64| outline.iter().map(move |&(x, z)| DVec3::new(x, y, z));
    let vertices: Vec<DVec3> = at(-9.0).chain(at(9.0)).collect();
    let mut faces: Vec<[u32; 3]> = Vec::new();
    for [a, b, c] in triangles {
        faces.push([a, b, c]);
        faces.push([a + 8, c + 8, b + 8]);
    }
    for i in 0..8_u32 {
        let j = (i + 1) % 8;
        faces.extend([[i, i + 8, j + 8], [i, j + 8, j]]);
    }
    Mesh::new(vertices, faces)
}

/// Towers that stand so close that they bar each other's posts.
pub fn towers() -> Mesh {
    let tower = |x: f64, y: f64| moved(&block(3.0, 16.0), DMat3::IDENTITY, DVec3::new(x, y, 0.0));
    let places = (0..9).map(|i| (f64::from(i % 3) * 10.0, f64::from(i / 3) * 10.0));
    together(&places.map(|(x, y)| tower(x, y)).collect::<Vec<_>>())
}

/// Boxes, drums and cones one upon the other or beside each other.
pub fn heap(random: &mut Random) -> Mesh {
    let mut z = 0.0;
    let mut profile = vec![];
    let mut radius = random.between(14.0, 28.0);
    for _ in 0..3 {
        profile.push((radius, z));
        z += random.between(3.0, 12.0);
        radius *= random.between(0.75, 1.1);
        profile.push((radius, z));
        radius *= [0.6, 1.0, 1.25][(random.unit() * 3.0) as usize];
    }
    profile.dedup();
    let sides = 5 + (random.unit() * 40.0) as usize;
    let shear = DMat3::from_cols(
        DVec3::X,
        DVec3::Y,
        DVec3::new(random.between(-0.4, 0.4), random.between(-0.4, 0.4), 1.0),
    );
    moved(&revolved(&profile, sides), shear, DVec3::ZERO)
}

/// What all prints of which are whole, by name.
pub fn plain() -> Vec<(&'static str, Mesh)> {
    vec![
        ("block", block(18.0, 20.0)),
        ("cylinder", cylinder(18.0, 20.0)),
        ("tube", tube(24.0, 3.0, 18.0)),
        ("cone", cone(22.0, 30.0)),
        ("leaning", leaning(16.0, 24.0, 30.0)),
        ("steps", steps()),
        ("plate with boss", plate_with_boss()),
        ("ball", ball(22.0)),
        ("ring", ring()),
        ("wheel", wheel()),
        ("hollow box", hollow_box()),
        ("pocket", pocket(12.0)),
        ("mushroom", mushroom(10.0, 24.0)),
        ("bridge", bridge(30.0)),
        ("towers", towers()),
    ]
}
