//! Prints that are stacked layers in part.

use std::ops::Range;

use glam::{DVec2, DVec3};
use wireprint_core::geometry::curve::Curve;
use wireprint_core::mesh::Mesh;
use wireprint_core::strand::{Kind, Strand};
use wireprint_core::wireframe::plan::sliced::Sliced;
use wireprint_core::wireframe::regions::layered::{Layered, LayeredSlab, Line, Stretch};
use wireprint_core::wireframe::regions::layers::cut_layers;

use crate::printer::{Print, Printer};
use crate::rules::breaches;
use crate::shapes::{block, cylinder, leaning, tube};

/// Height of a layer as a part of the strand.
const THICKNESS: f64 = 0.6;

/// What is layers of each contour: all of it, or a share of its length from the place on that is next to
/// a point.
#[derive(Debug, Clone, Copy)]
enum Part {
    Whole,
    From(DVec2, f64),
}

/// Layers in some slabs of a model, where the lines follow its contours.
fn layered(
    printer: &Printer,
    mesh: &Mesh,
    sliced: &Sliced,
    slabs: Range<usize>,
    part: Part,
) -> Layered {
    let strand = printer.wire.strand;
    let mut found = Layered::default();
    found.slabs.resize_with(slabs.end, LayeredSlab::default);
    for slab in slabs.clone() {
        let own = &mut found.slabs[slab];
        let contours = 0..sliced.lower[slab + 1].len() as u32;
        match part {
            Part::Whole => own.strips = (0..sliced.strips[slab].len() as u32).collect(),
            Part::From(from, share) => own.stretches.extend(contours.map(|contour| {
                let points = &sliced.lower[slab + 1][contour as usize].points;
                let curve = Curve::new(points, true).unwrap();
                Stretch { contour, from: curve.nearest(from).s, length: share * curve.length() }
            })),
        }
    }
    for layer in cut_layers(mesh, sliced, THICKNESS * strand, strand) {
        if !slabs.contains(&(layer.slab as usize)) {
            continue;
        }
        for contour in &layer.contours {
            let curve = Curve::new(&contour.points, true).unwrap();
            let length = curve.length();
            let points = match part {
                Part::Whole => curve.arc(0.0, length),
                Part::From(from, share) => curve.arc(curve.nearest(from).s, share * length),
            };
            let points = points.into_iter().map(|p| p.extend(layer.z)).collect();
            let flow = layer.thickness / strand;
            found.slabs[layer.slab as usize].lines.push(Line { points, flow, inside: false });
        }
    }
    found
}

/// A print with layers, and the one without.
fn both(mesh: &Mesh, slabs: Range<usize>, part: Part) -> (Print, Print, Layered) {
    let printer = Printer::paper();
    let sliced = printer.slice(mesh);
    let layered = layered(&printer, mesh, &sliced, slabs, part);
    layered.fits(&sliced).unwrap();
    (printer.print_sliced(sliced, &layered), printer.print(mesh), layered)
}

fn of_layers(print: &Print) -> Vec<&Strand> {
    print.frame.strands.iter().filter(|strand| strand.kind.is_layered()).collect()
}

fn assert_keeps_all_rules(print: &Print) {
    let found = breaches(print).0;
    assert!(found.is_empty(), "{found}");
}

#[test]
fn layers_on_one_side_are_printed_and_wire_elsewhere_stays_what_it_was() {
    for mesh in [block(18.0, 24.0), cylinder(18.0, 24.0), leaning(18.0, 24.0, 10.0)] {
        for slabs in [0..1, 1..3, 2..4] {
            let (print, plain, layered) =
                both(&mesh, slabs.clone(), Part::From(DVec2::new(30.0, -8.0), 0.2));
            assert_keeps_all_rules(&print);
            assert!(print.is_whole(), "{:?}", print.frame.unprinted);
            let lines = layered.slabs.iter().flat_map(|slab| &slab.lines);
            let length: f64 =
                lines.flat_map(|l| l.points.windows(2)).map(|p| p[0].distance(p[1])).sum();
            assert!((print.frame.length_of(Kind::LayerWise) - length).abs() < 1e-6);
            // Posts of the plain print keep their places, but for those that layers bar.
            let stands =
                |post: &DVec3| print.frame.posts.iter().any(|p| p.post.peak.distance(*post) < 1e-6);
            let kept = plain.frame.posts.iter().filter(|p| stands(&p.post.peak)).count();
            let share = kept as f64 / plain.frame.posts.len() as f64;
            assert!(share > 0.75, "{share} of the posts are kept");
        }
    }
}

#[test]
fn slabs_that_are_layers_all_through_have_no_posts_and_carry_the_next() {
    for mesh in [block(18.0, 24.0), tube(24.0, 8.0, 20.0)] {
        let (print, plain, _) = both(&mesh, 1..2, Part::Whole);
        assert_keeps_all_rules(&print);
        assert!(print.is_whole(), "{:?}", print.frame.unprinted);
        let posts =
            |print: &Print, slab: u32| print.frame.posts.iter().filter(|p| p.slab == slab).count();
        assert_eq!(posts(&print, 1), 0);
        for slab in [0, 2] {
            let (own, before) = (posts(&print, slab), posts(&plain, slab));
            assert!(own.abs_diff(before) <= 1 + before / 8, "{own} posts where {before} stood");
        }
        let layers = of_layers(&print);
        assert!(layers.iter().all(|strand| strand.slab == 1 && strand.flow == layers[0].flow));
        // The head goes straight from line to line once the first is reached.
        let begun: Vec<bool> = layers
            .windows(2)
            .filter(|pair| pair[0].to != pair[1].from)
            .map(|pair| pair[1].direct)
            .collect();
        assert!(!begun.is_empty() && begun.iter().all(|&direct| direct));
        assert!(!layers[0].direct);
    }
}

#[test]
fn a_cap_ends_where_layers_have_closed_the_face() {
    let (printer, mesh) = (Printer::paper(), block(18.0, 12.0));
    let sliced = printer.slice(&mesh);
    let top = sliced.strips.len() - 1;
    let mut layered =
        layered(&printer, &mesh, &sliced, top..top + 1, Part::From(DVec2::new(-18.0, -18.0), 0.25));
    let lid = [(-18.0, -18.0), (18.0, -18.0), (18.0, 0.0), (-18.0, 0.0)].map(DVec2::from);
    layered.slabs[top].lids.push(lid.to_vec());
    let height = sliced.levels[top + 1].z;
    let print = printer.print_sliced(sliced, &layered);
    let caps = print.frame.strands.iter().filter(|s| s.kind == Kind::Cap && s.from.z >= height);
    let middles: Vec<DVec3> = caps.map(|s| s.from.midpoint(s.to)).collect();
    // Turns along the rim are not behind the wall.
    let is_closed = |p: &&DVec3| p.x.abs() < 17.9 && p.y < 0.0;
    assert!(middles.len() > 4 && middles.iter().find(is_closed).is_none(), "{middles:?}");
}

#[test]
fn a_marked_face_is_closed_side_by_side() {
    let (printer, mesh) = (Printer::paper(), block(12.0, 12.0));
    for (bottom, z) in [(true, 0.0), (false, 12.0)] {
        let sliced = printer.slice(&mesh);
        let grid = (-11..=11).flat_map(|x| (-11..=11).map(move |y| (f64::from(x), f64::from(y))));
        let flats = grid.map(|(x, y)| (DVec3::new(x, y, z), true)).collect();
        let layered = Layered { slabs: Vec::new(), flats };
        let print = printer.print_sliced(sliced, &layered);
        assert_keeps_all_rules(&print);
        let layers = of_layers(&print);
        assert!(layers.iter().all(|s| (s.from.z < 6.0) == bottom));
        let area: f64 = layers.iter().map(|s| s.from.distance(s.to)).sum::<f64>();
        // On the bed a strand is squeezed, and so wider.
        let width = if bottom { 0.7 * 0.7 * std::f64::consts::FRAC_PI_4 / 0.35 } else { 0.7 };
        let closed = area * width / (24.0 * 24.0);
        assert!((0.9..1.15).contains(&closed), "{closed} of the face is closed");
    }
}

#[test]
fn what_is_named_must_be_there() {
    let printer = Printer::paper();
    let sliced = printer.slice(&block(18.0, 12.0));
    let slab = |strips: Vec<u32>, contours: Vec<u32>| LayeredSlab {
        strips,
        stretches: contours
            .into_iter()
            .map(|contour| Stretch { contour, from: 0.0, length: 1.0 })
            .collect(),
        ..LayeredSlab::default()
    };
    let fits = |slabs: Vec<LayeredSlab>| {
        let layered = Layered { slabs, flats: Vec::new() };
        layered.fits(&sliced).map_err(|error| error.to_string())
    };
    assert_eq!(fits(vec![slab(vec![0], vec![0])]), Ok(()));
    assert!(fits(vec![slab(vec![7], vec![])]).unwrap_err().contains("strip 7 in slab 0"));
    assert!(fits(vec![slab(vec![], vec![9])]).unwrap_err().contains("contour 9 in slab 0"));
    let many = vec![LayeredSlab::default(); 40];
    assert!(fits(many).unwrap_err().contains("no slab"));
}

#[test]
fn layers_fill_each_slab_evenly_and_know_their_strips() {
    let printer = Printer::paper();
    let tube = tube(24.0, 8.0, 20.0);
    let sliced = printer.slice(&tube);
    let layers = cut_layers(&tube, &sliced, 0.4, 0.7);
    for (slab, ends) in sliced.levels.windows(2).enumerate() {
        let own: Vec<_> = layers.iter().filter(|l| l.slab as usize == slab).collect();
        let sum: f64 = own.iter().map(|layer| layer.thickness).sum();
        assert!((sum - (ends[1].z - ends[0].z)).abs() < 1e-9);
        assert!((own[own.len() - 1].z - ends[1].z).abs() < 1e-12);
        for layer in own {
            assert!((layer.thickness - 0.4).abs() < 0.1);
            // Two walls, each of which is its own strip.
            assert_eq!(layer.contours.len(), 2);
            let mut strips = layer.strips.clone();
            strips.sort();
            assert_eq!(strips, [Some(0), Some(1)]);
            // The strip of the outer wall leads up to the outer contour.
            for (contour, strip) in layer.contours.iter().zip(&layer.strips) {
                let upper = sliced.strips[slab][strip.unwrap() as usize].upper[0];
                let top = &sliced.lower[slab + 1][upper as usize];
                assert!((contour.area.abs() - top.area.abs()).abs() < 1.0);
            }
        }
    }
}
