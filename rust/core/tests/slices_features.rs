//! Features of the height function, against a plain walk through the vertices in their order.

mod solids;

use glam::{DMat3, DVec3};
use solids::{Random, cuboid, moved, revolved, sphere, together, torus};
use wireprint_core::mesh::Mesh;
use wireprint_core::slices::crests::crests;
use wireprint_core::slices::features::{Feature, FeatureKind, features};

/// A feature without its width, so that lists can be compared.
type Told = (i64, FeatureKind, i64);

fn told(z: f64, kind: FeatureKind, size: f64) -> Told {
    let micrometres = |v: f64| if v.is_finite() { (v * 1e6).round() as i64 } else { i64::MAX };
    (micrometres(z), kind, micrometres(size))
}

fn sorted(mut all: Vec<Told>) -> Vec<Told> {
    all.sort_by_key(|&(z, kind, size)| (z, kind as u8, size));
    all
}

fn found(mesh: &Mesh, least: f64, kinds: &[FeatureKind]) -> Vec<Told> {
    let all = features(mesh, least);
    let own = all.iter().filter(|f| kinds.contains(&f.kind));
    sorted(own.map(|f| told(f.low, f.kind, f.size)).collect())
}

/// Extrema with their saddles by the elder rule: the surface up to each vertex in turn, its pieces
/// labelled anew.
fn extrema(mesh: &Mesh, least: f64, up: bool) -> Vec<Told> {
    let sign = if up { 1.0 } else { -1.0 };
    let end = if up { FeatureKind::Minimum } else { FeatureKind::Maximum };
    let mut order: Vec<usize> = (0..mesh.vertices.len()).collect();
    let key = |v: usize| (sign * mesh.vertices[v].z, if up { v as i64 } else { -(v as i64) });
    order.sort_by(|&a, &b| key(a).0.total_cmp(&key(b).0).then(key(a).1.cmp(&key(b).1)));
    // The extremum of the piece that each vertex belongs to; none before its turn.
    let mut piece: Vec<Option<usize>> = vec![None; order.len()];
    let mut all = Vec::new();
    for &v in &order {
        let at = |f: &&[u32; 3]| f.contains(&(v as u32));
        let around = mesh.faces.iter().filter(at).flatten();
        let mut pieces: Vec<usize> = around.filter_map(|&w| piece[w as usize]).collect();
        pieces.sort_by(|&a, &b| key(a).0.total_cmp(&key(b).0).then(key(a).1.cmp(&key(b).1)));
        pieces.dedup();
        let elder = pieces.first().copied().unwrap_or(v);
        piece[v] = Some(elder);
        for &younger in pieces.iter().skip(1) {
            let (z, saddle) = (mesh.vertices[younger].z, mesh.vertices[v].z);
            if (saddle - z).abs() >= least {
                all.push(told(z, end, (saddle - z).abs()));
                all.push(told(saddle, FeatureKind::Saddle, (saddle - z).abs()));
            }
            for label in piece.iter_mut().filter(|label| **label == Some(younger)) {
                *label = Some(elder);
            }
        }
    }
    let mut last: Vec<usize> = piece.into_iter().flatten().collect();
    last.sort_unstable();
    last.dedup();
    all.extend(last.into_iter().map(|v| told(mesh.vertices[v].z, end, f64::INFINITY)));
    all
}

/// A sphere whose vertices were all pushed to and fro: bumps and dents of all sizes.
fn bumpy(random: &mut Random) -> Mesh {
    let ball = sphere(8);
    let mut mesh = moved(&ball, random.rotation() * 10.0, DVec3::ZERO);
    for vertex in &mut mesh.vertices {
        vertex.z += random.between(-3.0, 3.0);
    }
    mesh
}

#[test]
fn extrema_and_the_saddles_that_end_them_are_those_of_a_plain_walk() {
    let mut random = Random(5);
    for _ in 0..20 {
        let mesh = together(&[bumpy(&mut random), bumpy(&mut random)]);
        for least in [0.0, 1.0, 2.5] {
            let (up, down) = (extrema(&mesh, least, true), extrema(&mesh, least, false));
            let kinds = [FeatureKind::Minimum, FeatureKind::Maximum, FeatureKind::Saddle];
            assert_eq!(found(&mesh, least, &kinds), sorted([up, down].concat()));
        }
    }
}

#[test]
fn a_handle_has_two_saddles_that_always_count() {
    let mut random = Random(3);
    for _ in 0..20 {
        let mesh = moved(&torus(10.0, 3.0, 48, 24), random.rotation(), DVec3::ZERO);
        let saddles = found(&mesh, 0.5, &[FeatureKind::Saddle]);
        let lasting = saddles.iter().filter(|&&(_, _, size)| size == i64::MAX);
        assert_eq!(lasting.count(), 2);
    }
}

#[test]
fn a_feature_smaller_than_asked_for_is_none() {
    // A dumbbell on end: its upper ball ends 4 mm above its neck, or begins so far above it.
    let profile = [(0.0, 0.0), (4.0, 4.0), (1.0, 8.0), (3.0, 10.0), (0.0, 12.0)];
    let lying = moved(&revolved(&profile, 24), DMat3::from_rotation_x(1.4), DVec3::ZERO);
    let maxima = |least| found(&lying, least, &[FeatureKind::Maximum]).len();
    assert_eq!((maxima(0.1), maxima(50.0)), (2, 1));
}

fn flats(mesh: &Mesh, least: f64) -> Vec<Feature> {
    features(mesh, least).into_iter().filter(|f| f.kind == FeatureKind::Flat).collect()
}

#[test]
fn flats_have_the_area_of_their_faces_and_the_width_of_their_shape() {
    let slab = cuboid(DVec3::ZERO, DVec3::new(30.0, 10.0, 4.0));
    let near = cuboid(DVec3::new(50.0, 0.0, 0.0), DVec3::new(60.0, 10.0, 4.004));
    let found = flats(&together(&[slab, near]), 1.0);
    let heights: Vec<(f64, f64)> = found.iter().map(|f| (f.low, f.high)).collect();
    assert_eq!(heights, [(0.0, 0.0), (4.0, 4.004)]);
    for flat in found {
        assert!((flat.size - 400.0_f64.sqrt()).abs() < 1e-9);
        // Twice 400 mm² over edges of 80 mm and 40 mm.
        assert!((flat.width - 800.0 / 120.0).abs() < 1e-9);
    }
}

#[test]
fn a_face_that_leans_by_less_than_a_degree_is_a_flat() {
    let has_flats = |degrees: f64| {
        let plate = cuboid(DVec3::new(-10.0, -5.0, 0.0), DVec3::new(10.0, 5.0, 4.0));
        let leaning = moved(&plate, DMat3::from_rotation_y(degrees.to_radians()), DVec3::ZERO);
        !flats(&leaning, 4.0).is_empty()
    };
    // The cosine of the angle is at least 0.9999: 0.81 degrees.
    assert!(has_flats(0.0) && has_flats(0.8) && !has_flats(0.83));
}

#[test]
fn a_flat_smaller_than_asked_for_is_none() {
    let mesh = cuboid(DVec3::ZERO, DVec3::new(3.0, 3.0, 20.0));
    assert_eq!((flats(&mesh, 2.9).len(), flats(&mesh, 3.1).len()), (2, 0));
}

/// A bar along x whose section is seen whole from its first corner.
fn bar(width: f64, section: &[(f64, f64)]) -> Mesh {
    let count = section.len() as u32;
    let corners = section.iter().flat_map(|&(y, z)| [0.0, width].map(|x| DVec3::new(x, y, z)));
    let mut faces = Vec::new();
    for i in 0..count {
        let (a, b) = (2 * i, 2 * ((i + 1) % count));
        faces.extend([[a, b + 1, a + 1], [a, b, b + 1]]);
    }
    for i in 1..count - 1 {
        faces.extend([[0, 2 * i + 2, 2 * i], [1, 2 * i + 1, 2 * i + 3]]);
    }
    Mesh::new(corners.collect(), faces)
}

#[test]
fn crests_are_level_lines_along_which_the_surface_turns() {
    let found = |section: &[(f64, f64)], least| -> Vec<(f64, bool, f64)> {
        let mesh = bar(7.0, section);
        assert!(mesh.volume().abs() > 1.0);
        crests(&mesh, least, 4.0, 0.5)
            .iter()
            .map(|c| (c.z(), c.falls, c.length(|_| true)))
            .collect()
    };
    // A keel and a ridge; a valley above and a crown below, between edges; steep ones; a level top.
    let diamond = [(0.0, 0.0), (4.0, 1.0), (0.0, 2.0), (-4.0, 1.0)];
    assert_eq!(found(&diamond, 1.0), [(0.0, false, 7.0), (2.0, true, 7.0)]);
    assert_eq!(found(&diamond, 7.1), []);
    let grooved = [(0.0, 1.0), (-6.0, 3.0), (-6.0, -3.0), (0.0, -1.0), (6.0, -3.0), (6.0, 3.0)];
    let edges = [(-3.0, false, 7.0), (-1.0, true, 7.0), (1.0, false, 7.0), (3.0, true, 14.0)];
    assert_eq!(found(&grooved, 1.0), edges);
    let steep = [(0.0, 0.0), (1.0, 4.0), (0.0, 8.0), (-1.0, 4.0)];
    assert_eq!(found(&steep, 1.0), [(0.0, false, 7.0), (8.0, true, 7.0)]);
    assert_eq!(found(&[(0.0, 0.0), (9.0, 0.0), (9.0, 3.0), (0.0, 3.0)], 1.0), []);
}
