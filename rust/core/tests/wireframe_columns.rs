//! Columns against rays, and what is thinner than a slab against its known sections.

#![allow(clippy::unwrap_used, reason = "a test may panic")]

mod printer;
mod solids;

use glam::{DVec2, DVec3};
use printer::Printer;
use solids::{Random, cuboid, inverted, revolved, sphere, together};
use wireprint_core::contours::Contour;
use wireprint_core::geometry::polygon::contains;
use wireprint_core::head::Head;
use wireprint_core::mesh::Mesh;
use wireprint_core::wireframe::params::WireParams;
use wireprint_core::wireframe::plan::columns::{Need, add};
use wireprint_core::wireframe::plan::sliced::{Column, Sliced};

fn head() -> Head {
    Printer::paper().head
}

fn sliced(mesh: &Mesh) -> Sliced {
    Printer::paper().slice(mesh)
}

fn wire() -> WireParams {
    Printer::paper().wire
}

/// Height at which a ray down from a point meets the surface; 0, the bed, where it does not.
fn below(mesh: &Mesh, from: DVec3) -> f64 {
    let hit = |face: usize| {
        let [a, b, c] = mesh.corners(face);
        let normal = (b - a).cross(c - a);
        let inside = contains(&[a, b, c].map(DVec3::truncate), from.truncate());
        let z = a.z - (from - a).truncate().dot(normal.truncate()) / normal.z;
        (inside && z < from.z - 1e-6).then_some(z)
    };
    (0..mesh.faces.len()).filter_map(hit).fold(0.0, f64::max)
}

fn is_column(contour: &Contour, place: DVec2) -> bool {
    contour.support && contains(&contour.points, place)
}

fn area(contours: &[Contour]) -> f64 {
    contours.iter().map(|c| c.area).sum()
}

/// A closed box with a hollow in it, and a wide roof beside it on a wall.
fn hall() -> Mesh {
    let hollow = inverted(&cuboid(DVec3::new(-50.0, -50.0, 12.0), DVec3::new(50.0, 50.0, 40.0)));
    together(&[
        cuboid(DVec3::new(-60.0, -60.0, 0.0), DVec3::new(60.0, 60.0, 60.0)),
        hollow,
        cuboid(DVec3::new(80.0, -60.0, 0.0), DVec3::new(90.0, 60.0, 20.0)),
    ])
}

#[test]
fn a_column_stands_on_the_first_surface_below_it() {
    let mesh = hall();
    let plain = sliced(&mesh);
    let mut random = Random(7);
    for _ in 0..60 {
        let place = DVec2::new(random.between(-35.0, 35.0), random.between(-35.0, 35.0));
        let level = 2 + random.between(0.0, plain.levels.len() as f64 - 2.0) as usize;
        let need = Need { level, place, urgent: true };
        let foot = below(&mesh, place.extend(plain.levels[level].z));
        let mut propped = plain.clone();
        add(&mut propped, &[need], &[], &head(), &wire());
        let stands = |l: &usize| propped.upper[*l].iter().any(|c| is_column(c, place));
        let lowest = (0..level).find(stands);
        match lowest {
            Some(lowest) => {
                assert!((plain.levels[lowest].z - foot).abs() < 0.7, "{lowest} is not on {foot}");
                assert!((lowest..level).all(|l| stands(&l)));
                assert!(propped.lower[level].iter().any(|c| is_column(c, place)));
                assert!(!propped.upper[level].iter().any(|c| is_column(c, place)));
            }
            // What is wanted on a face stands on it already.
            None => assert!(plain.levels[level].z - foot < 0.7, "no column from {foot}"),
        }
    }
}

#[test]
fn what_can_do_without_gets_no_column_inside_a_body() {
    let mesh = hall();
    let mut propped = sliced(&mesh);
    let level = propped.levels.len() - 1;
    let need = Need { level, place: DVec2::ZERO, urgent: false };
    assert!(!add(&mut propped, &[need], &[], &head(), &wire()));
    assert!(propped.columns.is_empty());
}

#[test]
fn columns_keep_out_of_walls_and_of_each_other() {
    let mesh = hall();
    let mut propped = sliced(&mesh);
    let level = propped.levels.iter().position(|l| (l.z - 40.0).abs() < 0.7).unwrap();
    let places = [(-49.0, 0.0), (-47.0, 3.0), (0.0, 0.0), (5.0, 0.0), (20.0, 0.0)];
    let needs = places.map(|p| Need { level, place: DVec2::from(p), urgent: true });
    assert!(add(&mut propped, &needs, &[], &head(), &wire()));
    for (i, column) in propped.columns.iter().enumerate() {
        assert!(column.place.abs().max_element() < 50.0 - 4.0);
        for other in &propped.columns[..i] {
            assert!(other.place.distance(column.place) > 8.0);
        }
    }
    for place in places.map(DVec2::from) {
        assert!(propped.columns.iter().any(|c| c.place.distance(place) < 13.0));
    }
}

#[test]
fn a_later_column_goes_on_from_one_below_it() {
    let mesh = hall();
    let mut propped = sliced(&mesh);
    let level = |z: f64| sliced(&hall()).levels.iter().position(|l| (l.z - z).abs() < 0.7).unwrap();
    let need = |level: usize| Need { level, place: DVec2::new(70.0, 0.0), urgent: true };
    let (low, high) = (level(12.0), level(40.0));
    assert!(add(&mut propped, &[need(low)], &[], &head(), &wire()));
    assert!(add(&mut propped, &[need(high)], &[], &head(), &wire()));
    let one = |contours: &[Contour]| contours.iter().filter(|c| c.support).count() == 1;
    assert!((0..high).all(|l| one(&propped.upper[l])));
    assert!((1..=high).all(|l| one(&propped.lower[l])));
}

#[test]
fn where_more_is_wanted_at_the_level_that_a_column_ends_at_another_one_rises_beside_it() {
    let mut propped = sliced(&hall());
    let level = propped.levels.iter().position(|l| (l.z - 40.0).abs() < 0.7).unwrap();
    let need = Need { level, place: DVec2::new(70.0, 0.0), urgent: true };
    assert!(add(&mut propped, &[need], &[], &head(), &wire()));
    assert!(add(&mut propped, &[need], &[], &head(), &wire()));
    let [one, other] = &propped.columns[..] else { panic!("{} columns", propped.columns.len()) };
    for column in [one, other] {
        assert!(column.first < level && column.level == level, "{column:?}");
    }
    assert!(one.place.distance(other.place) > 8.0);
}

#[test]
fn a_face_is_carried_where_other_columns_begin_on_it() {
    // A shelf over another one, and a wanted place over each underside, a little apart.
    let shelf =
        |low: f64, high: f64| cuboid(DVec3::new(-60.0, -60.0, low), DVec3::new(60.0, 60.0, high));
    let mut propped = sliced(&together(&[shelf(0.0, 10.0), shelf(20.0, 40.0)]));
    let levels: Vec<f64> = propped.levels.iter().map(|l| l.z).collect();
    let level = |z: f64| levels.iter().position(|l| (l - z).abs() < 0.7).unwrap();
    let (under, top) = (level(20.0), level(40.0));
    let need = |level, x: f64| Need { level, place: DVec2::new(x, 0.0), urgent: true };
    for apart in [0.0, 3.0, 6.0, 12.0] {
        assert!(add(&mut propped, &[need(top, 0.0), need(under, apart)], &[], &head(), &wire()));
        let is_under = |c: &Column| c.level == under && c.place == DVec2::new(apart, 0.0);
        assert!(propped.columns.iter().any(is_under), "{apart}: {:?}", propped.columns);
        propped.columns.clear();
    }
}

#[test]
fn a_thin_plate_under_a_tower_is_a_sheet_on_the_bed() {
    let tower = revolved(&[(40.0, 0.0), (40.0, 1.0), (10.0, 1.0), (10.0, 30.0)], 48);
    let sliced = sliced(&tower);
    let [plate] = &sliced.sheets[0][..] else { panic!("{} sheets", sliced.sheets[0].len()) };
    assert!(area(&plate.contours) > 4900.0 && area(&sliced.upper[0]) < 320.0);
    assert_eq!(sliced.first().unwrap().contours.len(), 1);
}

#[test]
fn a_thin_shelf_is_a_sheet_wherever_it_is() {
    for low in [9.0, 17.3, 21.9] {
        let high = low + 0.6;
        let profile =
            [(10.0, 0.0), (10.0, low), (30.0, low), (30.0, high), (10.0, high), (10.0, 40.0)];
        let sliced = sliced(&revolved(&profile, 48));
        let sheets: Vec<f64> = sliced.sheets.iter().flatten().map(|s| area(&s.contours)).collect();
        let slices = sliced.lower.iter().chain(&sliced.upper).map(|slice| area(slice));
        assert!(sheets.iter().copied().chain(slices).any(|a| a > 2700.0), "{low}: {sheets:?}");
    }
}

#[test]
fn what_no_feature_parts_has_no_sheets() {
    let ball = solids::moved(&sphere(24), glam::DMat3::IDENTITY * 25.0, DVec3::Z * 25.0);
    for mesh in [ball, cuboid(DVec3::ZERO, DVec3::splat(28.0))] {
        assert!(sliced(&mesh).sheets.iter().all(Vec::is_empty));
    }
}

#[test]
fn a_column_stands_at_the_nearest_place_with_room_or_where_there_is_most() {
    let (mesh, printer) = (hall(), Printer::paper());
    let plain = sliced(&mesh);
    let level = plain.levels.iter().position(|l| (l.z - 40.0).abs() < 0.7).unwrap();
    let strokes = printer.strokes();
    let radius = 0.4 * strokes.run(strokes.tallest(printer.head.cone_height));
    let mut random = Random(17);
    for _ in 0..80 {
        // Near a wall of the hollow, or in a corner of it.
        let wanted = DVec2::new(random.between(30.0, 49.9), random.between(-49.9, 49.9));
        let room = |p: DVec2| (50.0 - p.abs()).min_element();
        let ring = |k: i32| {
            let turn = |i: i32| DVec2::from_angle(std::f64::consts::TAU * f64::from(i) / 8.0);
            let count = if k == 0 { 1 } else { 8 };
            (0..count).map(move |i| wanted + radius * f64::from(k) * turn(i))
        };
        let places: Vec<DVec2> = (0..=3).flat_map(ring).filter(|&p| room(p) > 0.0).collect();
        let roomy = places.iter().copied().find(|&p| room(p) >= 2.0 * radius);
        let tight = places.iter().copied().filter(|&p| room(p) >= 1.2 * radius);
        let tight = tight.reduce(|best, p| if room(p) > room(best) { p } else { best });
        let mut propped = plain.clone();
        add(&mut propped, &[Need { level, place: wanted, urgent: true }], &[], &head(), &wire());
        let found = propped.columns.first().map(|column| column.place);
        match roomy.or(tight) {
            Some(best) => {
                let found = found.unwrap();
                assert!(found.distance(best) < 1e-9, "{found}, not {best}, for {wanted}");
            }
            None => assert_eq!(found, None),
        }
    }
}

#[test]
fn a_column_serves_what_lies_near_where_it_stands_or_near_what_it_was_wanted_for() {
    let (mesh, p) = (hall(), wire());
    let plain = sliced(&mesh);
    let level = plain.levels.iter().position(|l| (l.z - 40.0).abs() < 0.7).unwrap();
    let columns = |places: &[DVec2]| {
        let needs: Vec<Need> =
            places.iter().map(|&place| Need { level, place, urgent: true }).collect();
        let mut propped = plain.clone();
        add(&mut propped, &needs, &[], &head(), &p);
        propped.columns.iter().map(|column| column.place).collect::<Vec<DVec2>>()
    };
    // Beside a wall there is no room, so the column stands away from where it is wanted.
    let wanted = DVec2::new(49.0, 0.0);
    let stands = columns(&[wanted])[0];
    let aside = (stands - wanted).normalize();
    let (near, far) = (0.18 * p.span_limit, 0.2 * p.span_limit);
    assert!(stands.distance(wanted) > far - near, "{stands}");
    assert_eq!(columns(&[wanted, stands + aside * near]), [stands]);
    assert_eq!(columns(&[wanted, stands + aside * far]).len(), 2);
    let along = aside.perp();
    assert!((wanted + along * near).distance(stands) > far);
    assert_eq!(columns(&[wanted, wanted + along * near]), [stands]);
    assert_eq!(columns(&[wanted, wanted + along * 3.0 * far]).len(), 2);
}
