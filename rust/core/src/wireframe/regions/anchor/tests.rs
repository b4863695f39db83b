//! Lines that begin on something, by hand; and that passes look only where something changed.

use super::*;
use crate::solids::Random;

const STRAND: f64 = 0.4;
const LAYER: f64 = 0.2;

fn touchable(rims: &[(i64, [DVec2; 2])]) -> Touchable {
    Touchable::new(Layers::default(), Layers::new(rims), STRAND, LAYER)
}

/// The lines of a layer in plan.
type Plan = Vec<Vec<(f64, f64)>>;

fn ends(from: (f64, f64), to: (f64, f64)) -> [DVec2; 2] {
    [DVec2::from(from), DVec2::from(to)]
}

fn line(number: i64, points: &[(f64, f64)]) -> LayerLine {
    let z = LAYER * (number + 1) as f64;
    LayerLine { points: points.iter().map(|&(x, y)| DVec3::new(x, y, z)).collect(), group: 0 }
}

fn layer(number: i64, lines: &[&[(f64, f64)]]) -> LayerLines {
    LayerLines { number, lines: lines.iter().map(|points| line(number, points)).collect() }
}

fn plan(layer: &LayerLines) -> Plan {
    let rounded = |v: f64| (v * 1000.0).round() / 1000.0;
    let points = |line: &LayerLine| {
        line.points.iter().map(|p| (rounded(p.x), rounded(p.y))).collect::<Vec<_>>()
    };
    layer.lines.iter().map(points).collect()
}

fn anchored(touchable: &Touchable, layers: Vec<LayerLines>) -> Vec<Plan> {
    touchable.anchored(layers, &Layers::default()).iter().map(plan).collect()
}

#[test]
fn what_lies_on_something_stays_as_it_is() {
    let bed = touchable(&[(-1, ends((0.0, 0.0), (9.0, 0.0)))]);
    let lines: &[&[(f64, f64)]] = &[&[(0.0, 0.0), (9.0, 0.0)], &[(9.0, 0.3), (0.0, 0.3)]];
    assert_eq!(anchored(&bed, vec![layer(0, lines), layer(1, lines)]), [lines, lines]);
}

#[test]
fn a_line_that_begins_in_the_air_is_turned_round_and_loses_what_nothing_holds() {
    let bed = touchable(&[(-1, ends((6.0, 0.0), (9.0, 0.0)))]);
    let found = anchored(&bed, vec![layer(0, &[&[(0.0, 0.0), (9.0, 0.0)]])]);
    let [begin, end] = found[0][0][..] else { panic!("{found:?}") };
    assert_eq!(begin, (9.0, 0.0));
    assert!(end.0 > 5.5 && end.0 < 6.2, "{end:?}");
}

#[test]
fn a_line_that_only_its_middle_holds_is_parted_there() {
    let barely: &[(f64, f64)] = &[(0.0, 0.0), (8.0, 0.0)];
    let held = touchable(&[
        (0, ends((4.0, -1.0), (4.0, 1.0))),
        (0, ends((-0.25, -1.0), (-0.25, 1.0))),
        (0, ends((8.25, -1.0), (8.25, 1.0))),
    ]);
    let found = held.anchored(vec![layer(1, &[barely])], &Layers::default());
    let [right, left] = &plan(&found[0])[..] else { panic!("{found:?}") };
    assert!(right[0] == left[0] && right[1].0 > 7.0 && left[1].0 < 1.0);
}

#[test]
fn what_nothing_holds_falls_and_what_lies_on_it_with_it() {
    let bed = touchable(&[(-1, ends((0.0, 0.0), (9.0, 0.0)))]);
    let [lies, hangs]: [&[(f64, f64)]; 2] = [&[(0.0, 0.0), (9.0, 0.0)], &[(0.0, 5.0), (9.0, 5.0)]];
    let layers = (0..4).map(|number| layer(number, &[lies, hangs])).collect();
    assert_eq!(anchored(&bed, layers), vec![[lies]; 4]);
}

#[test]
fn a_line_waits_for_another_of_its_layer_that_it_may_lean_on() {
    let bed = touchable(&[(-1, ends((0.0, 0.0), (9.0, 0.0)))]);
    let [leans, lies]: [&[(f64, f64)]; 2] =
        [&[(0.0, 0.38), (9.0, 0.38)], &[(0.0, 0.0), (9.0, 0.0)]];
    assert_eq!(anchored(&bed, vec![layer(0, &[leans, lies])]), [[lies, leans]]);
    // A strand apart, they do not touch.
    let apart: &[(f64, f64)] = &[(0.0, 0.4), (9.0, 0.4)];
    assert_eq!(anchored(&bed, vec![layer(0, &[lies, apart])]), [[lies]]);
}

#[test]
fn nothing_holds_a_line_at_a_loose_place() {
    let bed = touchable(&[(-1, ends((0.0, 0.0), (9.0, 0.0)))]);
    let loose = Layers::new(&[(0, [DVec2::ZERO; 2])]);
    let found = bed.anchored(vec![layer(0, &[&[(0.0, 0.0), (9.0, 0.0)]])], &loose);
    let found = plan(&found[0]);
    assert!(found[0][0].0 > STRAND);
    assert_eq!(found[0][1], (9.0, 0.0));
}

/// What is told of the passes: layers that nothing changed need not be looked at again.
#[test]
fn layers_on_their_own_end_as_they_do_among_others() {
    let mut random = Random(7);
    let mut stack = |from: i64| -> Vec<LayerLines> {
        (from..from + 6)
            .map(|number| {
                let lines: Vec<Vec<(f64, f64)>> = (0..12)
                    .map(|_| {
                        let mut at = || (random.between(0.0, 6.0), random.between(0.0, 6.0));
                        vec![at(), at(), at()]
                    })
                    .collect();
                layer(number, &lines.iter().map(Vec::as_slice).collect::<Vec<_>>())
            })
            .collect()
    };
    let (low, high) = (stack(0), stack(20));
    let rims = |at: i64| [(at - 1, ends((0.0, 3.0), (6.0, 3.0)))];
    let all = touchable(&[rims(0), rims(20)].concat());
    let found = anchored(&all, [low.clone(), high.clone()].concat());
    let alone = [anchored(&touchable(&rims(0)), low), anchored(&touchable(&rims(20)), high)];
    // That lines wait no more is told of all layers at once, after so many passes.
    assert_eq!(found.len(), 12);
    let count = |layers: &[Plan]| layers.iter().map(Vec::len).sum::<usize>();
    assert_eq!(count(&found), count(&alone.concat()));
}
