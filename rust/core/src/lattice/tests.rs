use std::ops::ControlFlow;

use glam::dvec3;

use super::bars::Bars;
use super::effort::SearchEffort;
use super::lock::Rest;
use super::state::State;
use super::*;

fn head() -> Head {
    Head::new(0.5, 60.0, 30.0, 20.0, 40.0, 60.0).unwrap()
}

fn rules() -> Rules {
    Rules { strand: 0.7, bed: 0.4, span: 65.0, free_end: 20.0, most_work: u64::MAX, partial: false }
}

fn order(lattice: &Lattice, head: &Head, rules: &Rules) -> Ordered {
    super::order(lattice, head, rules, &mut |_| ControlFlow::Continue(()))
}

/// A lattice whose struts are all straight.
fn straight(nodes: Vec<DVec3>, edges: &[[u32; 2]]) -> Result<Lattice> {
    let place = |node: u32| nodes.get(node as usize).copied().unwrap_or_default();
    let form = |(strut, edge): (u32, &[u32; 2])| Form { strut, knees: edge.map(place) };
    let forms = (0..).zip(edges).map(form).collect();
    Lattice::new(nodes, edges.to_vec(), forms)
}

fn lattice(nodes: &[[f64; 3]], edges: &[[u32; 2]]) -> Lattice {
    straight(nodes.iter().map(|&n| n.into()).collect(), edges).unwrap()
}

/// A pyramid on the bed: four feet, four struts to the top.
fn pyramid() -> Lattice {
    let nodes = [[0., 0., 0.], [20., 0., 0.], [20., 20., 0.], [0., 20., 0.], [10., 10., 8.]];
    lattice(&nodes, &[[0, 4], [1, 4], [2, 4], [3, 4], [0, 1], [1, 2], [2, 3], [3, 0]])
}

/// Every rule, asked of each pair anew.
fn keeps_the_rules(lattice: &Lattice, found: &Ordered, head: &Head, rules: &Rules) {
    let squash = Strokes::new(head, rules.strand).squash();
    let mut held: Vec<bool> = lattice.nodes.iter().map(|node| node.z <= rules.bed).collect();
    for (number, laid) in found.strokes.iter().enumerate() {
        let [from, to] = lattice.ends(laid.stroke).map(|node| node as usize);
        assert!(held[from], "{laid:?} begins in the air");
        assert_eq!(laid.floating, !held[to]);
        (held[from], held[to]) = (true, true);
        let way = lattice.places(laid.stroke);
        for before in &found.strokes[..number] {
            let stands = lattice.places(before.stroke);
            assert!(head.deeper_than(squash, way, stands).is_none(), "{laid:?} hits {before:?}");
        }
    }
}

#[test]
fn feet_come_first_and_each_strut_goes_up() {
    let (lattice, head, rules) = (pyramid(), head(), rules());
    let found = order(&lattice, &head, &rules);
    assert!(found.left.is_empty(), "{found:?}");
    keeps_the_rules(&lattice, &found, &head, &rules);
    let first: Vec<u32> = found.strokes[..4].iter().map(|laid| laid.stroke.form).collect();
    assert!(first.iter().all(|&edge| edge >= 4), "{first:?}");
    assert!(found.strokes[4].floating);
    assert!(found.strokes[5..].iter().all(|laid| !laid.floating));
}

#[test]
fn what_nothing_leads_to_floats() {
    let lattice =
        lattice(&[[0., 0., 0.], [10., 0., 0.], [0., 0., 9.], [10., 0., 9.]], &[[0, 1], [2, 3]]);
    let found = order(&lattice, &head(), &rules());
    assert_eq!(found.left, [(1, Why::Floats)]);
}

#[test]
fn what_only_falls_steeply_to_a_node_is_told() {
    // A post, a beam from its top to another post, and a strut that hangs from the beam's end.
    let nodes = [[0., 0., 0.], [0., 0., 9.], [10., 0., 9.], [10., 0., 4.]];
    let hook = lattice(&nodes, &[[0, 1], [1, 2], [2, 3]]);
    let found = order(&hook, &head(), &rules());
    assert!(found.left.contains(&(2, Why::FromAbove)), "{found:?}");
}

#[test]
fn struts_that_bar_each_other_are_proven_to_whatever_else_there_is() {
    // Two steep struts from one foot: each has its upper end in the cone of whoever comes second.
    let nodes = [[0., 0., 0.], [1.0, 0., 9.], [-1.0, 0., 9.], [30., 0., 0.], [40., 0., 0.]];
    let both = lattice(&nodes, &[[0, 1], [0, 2], [1, 2], [3, 4]]);
    let found = order(&both, &head(), &rules());
    let locked: Vec<u32> = found.left.iter().map(|&(strut, _)| strut).collect();
    assert_eq!(locked, [0, 1], "{found:?}");
    assert!(found.left.iter().all(|&(_, why)| why == Why::Locked));
    // Where a part is wanted, one of them is enough to leave out, and the rest can be printed.
    let partial = Rules { partial: true, ..rules() };
    assert_eq!(order(&both, &head(), &partial).left, [(0, Why::Locked)]);
    let rest = lattice(&nodes, &[[0, 2], [1, 2], [3, 4]]);
    assert_eq!(order(&rest, &head(), &partial).left, []);
    // In no order of the four, in whichever directions, does each keep clear of those before it.
    let squash = Strokes::new(&head(), 0.7).squash();
    let keeps = |order: &[(u32, bool)]| {
        (0..order.len()).all(|n| {
            let (form, reversed) = order[n];
            let way = both.places(Stroke { form, reversed });
            may_fall(&head(), 0.7, way)
                && order[..n].iter().all(|&(form, reversed)| {
                    let stands = both.places(Stroke { form, reversed });
                    head().deeper_than(squash, way, stands).is_none()
                })
        })
    };
    let pairs = [[(0, false), (1, false)], [(0, true), (1, true)], [(0, false), (1, true)]];
    for [one, other] in pairs {
        assert!(!keeps(&[one, other]) && !keeps(&[other, one]));
    }
}

#[test]
fn a_form_with_knees_makes_room_for_what_is_steep() {
    // A tripod of steep legs: straight, a second leg has the node in its way; with a knee it has not.
    let turn =
        |degrees: f64| [6. * degrees.to_radians().cos(), 6. * degrees.to_radians().sin(), 0.];
    let nodes = [turn(0.), turn(120.), turn(240.), [0., 0., 9.]];
    let edges = [[0, 3], [1, 3], [2, 3]];
    let straight = lattice(&nodes, &edges);
    assert!(!order(&straight, &head(), &rules()).left.is_empty());
    let top = DVec3::from(nodes[3]);
    let forms = (0..3).flat_map(|strut| {
        let foot = DVec3::from(nodes[strut]);
        let knee = top + 1.2 * (foot - top).truncate().normalize().extend(0.0);
        [[foot, top], [foot, knee]].map(|knees| Form { strut: strut as u32, knees })
    });
    let nodes: Vec<DVec3> = nodes.iter().map(|&node| node.into()).collect();
    let bent = Lattice::new(nodes, edges.to_vec(), forms.collect()).unwrap();
    let found = order(&bent, &head(), &rules());
    assert!(found.left.is_empty(), "{found:?}");
    // The first is straight: a knee is where it is needed.
    let bends: Vec<usize> =
        found.strokes.iter().map(|laid| bent.pieces(laid.stroke).count() - 1).collect();
    assert_eq!(bends, [0, 1, 1]);
}

#[test]
fn forms_that_do_not_go_with_the_struts_are_refused() {
    let nodes = vec![DVec3::ZERO, DVec3::Z, DVec3::X];
    let edges = vec![[0, 1], [0, 2]];
    let form = |strut| Form { strut, knees: [DVec3::ZERO; 2] };
    for forms in [vec![form(0)], vec![form(1), form(0)], vec![form(0), form(1), form(2)]] {
        assert!(Lattice::new(nodes.clone(), edges.clone(), forms).is_err());
    }
    let odd = Form { strut: 1, knees: [DVec3::NAN; 2] };
    assert!(Lattice::new(nodes, edges, vec![form(0), odd]).is_err());
}

#[test]
fn what_hangs_too_far_is_too_long() {
    let lattice = lattice(&[[0., 0., 0.], [0., 70., 10.]], &[[0, 1]]);
    assert_eq!(order(&lattice, &head(), &rules()).left, [(0, Why::TooLong)]);
}

#[test]
fn a_strut_under_a_roof_is_printed_before_it() {
    // A low strut between the feet of a table: once the table's top is there, the head cannot get in.
    let nodes =
        [[0., 0., 0.], [12., 0., 0.], [0., 0., 10.], [12., 0., 10.], [6., -3., 0.], [6., 3., 4.]];
    let lattice = lattice(&nodes, &[[2, 3], [0, 2], [1, 3], [4, 5]]);
    let found = order(&lattice, &head(), &rules());
    assert!(found.left.is_empty(), "{found:?}");
    keeps_the_rules(&lattice, &found, &head(), &rules());
    let place = |edge: u32| found.strokes.iter().position(|laid| laid.stroke.form == edge);
    assert!(place(3) < place(0));
}

#[test]
fn the_same_lattice_gives_the_same_order_on_any_number_of_threads() {
    let (lattice, head, rules) = (pyramid(), head(), rules());
    let one = rayon::ThreadPoolBuilder::new().num_threads(1).build().unwrap();
    let alone = one.install(|| order(&lattice, &head, &rules));
    assert_eq!(alone.strokes, order(&lattice, &head, &rules).strokes);
}

#[test]
fn what_is_no_lattice_is_refused() {
    let at = |edges: &[[u32; 2]]| straight(vec![DVec3::ZERO, dvec3(0., 0., 1.)], edges);
    assert!(at(&[[0, 2]]).is_err());
    assert!(at(&[[1, 1]]).is_err());
    assert!(straight(vec![DVec3::NAN], &[]).is_err());
    let empty = at(&[]).unwrap();
    assert!(empty.is_empty() && order(&empty, &head(), &rules()).strokes.is_empty());
}

#[test]
fn struts_that_go_on_from_a_free_end_hang_with_it() {
    // A beam that sticks out from a post: the post and its first part may hang, all of it may not.
    let nodes = [[0., 0., 0.], [0., 0., 8.], [10., 0., 8.], [20., 0., 8.]];
    let beam = lattice(&nodes, &[[0, 1], [1, 2], [2, 3]]);
    let found = order(&beam, &head(), &rules());
    assert_eq!(found.strokes.len(), 2);
    assert_eq!(found.left.len(), 1);
    // A second post at its end is printed before it, and all of it after that.
    let nodes = [nodes.as_slice(), &[[20., 0., 0.]]].concat();
    let table = lattice(&nodes, &[[0, 1], [1, 2], [2, 3], [4, 3]]);
    let found = order(&table, &head(), &rules());
    assert!(found.left.is_empty(), "{found:?}");
    keeps_the_rules(&table, &found, &head(), &rules());
}

/// Whether all that is not printed can still be, past the head and from what is held: asked from the beginning.
fn rest_can_be_printed(lattice: &Lattice, rules: &Rules, bars: &Bars, laid: &[Laid]) -> bool {
    let mut printed = vec![false; lattice.len()];
    let mut barred = vec![false; 2 * lattice.forms.len()];
    for one in laid {
        printed[lattice.strut(one.stroke) as usize] = true;
        bars.of_form(one.stroke.form).iter().for_each(|stroke| barred[stroke.index()] = true);
    }
    let all = 0..lattice.len() as u32;
    let rest: Vec<u32> = all.filter(|&strut| !printed[strut as usize]).collect();
    let mut barring = vec![0; barred.len()];
    for stroke in rest.iter().flat_map(|&strut| bars.of_strut(strut)) {
        barring[stroke.index()] += 1;
    }
    let open = |stroke: Stroke| bars.is_drawn(stroke) && !barred[stroke.index()];
    if !Rest::of(lattice, bars, &printed, &barring, open).locked().is_empty() {
        return false;
    }
    let mut held: Vec<bool> = lattice.nodes.iter().map(|node| node.z <= rules.bed).collect();
    for node in laid.iter().flat_map(|one| lattice.ends(one.stroke)) {
        held[node as usize] = true;
    }
    let begins = |stroke: Stroke, held: &[bool]| {
        let [from, _] = lattice.ends(stroke);
        open(stroke) && held[from as usize]
    };
    // As often as there are struts is often enough.
    for _ in &rest {
        for &strut in &rest {
            if lattice.strokes_of(strut).any(|stroke| begins(stroke, &held)) {
                lattice.edges[strut as usize].iter().for_each(|&node| held[node as usize] = true);
            }
        }
    }
    rest.iter().all(|&strut| lattice.strokes_of(strut).any(|stroke| begins(stroke, &held)))
}

/// Numbers from 0 to below `most`, the same for each seed (Knuth's linear congruences).
fn chance(seed: u64) -> impl FnMut(usize) -> usize {
    let mut state = seed;
    move |most| {
        state =
            state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (state >> 33) as usize % most
    }
}

/// Struts between neighbours of a crooked grid, some with knees; few of its nodes are on the bed.
fn crooked(seed: u64) -> Lattice {
    let mut draw = chance(seed);
    let mut nodes = Vec::new();
    for place in 0..36 {
        let [x, y, z] = [place % 4, place / 4 % 3, place / 12].map(f64::from);
        let off = [draw(40), draw(40), draw(30)].map(|by| by as f64 / 10.0);
        nodes.push(dvec3(
            9. * x + off[0],
            9. * y + off[1],
            if z > 0. { 7. * z + off[2] } else { 0. },
        ));
    }
    let mut edges = Vec::new();
    for a in 0..36_u32 {
        for b in a + 1..36 {
            let near = nodes[a as usize].distance(nodes[b as usize]) < 15.0;
            if near && draw(3) > 0 {
                edges.push([a, b]);
            }
        }
    }
    let mut forms = Vec::new();
    for (strut, edge) in (0..).zip(&edges) {
        let [a, b] = edge.map(|node| nodes[node as usize]);
        forms.push(Form { strut, knees: [a, b] });
        if draw(2) > 0 && a.truncate() != b.truncate() {
            let level = (b - a).truncate().normalize().extend(0.0);
            forms.push(Form { strut, knees: [a + 1.2 * level, b] });
        }
    }
    Lattice::new(nodes, edges, forms).unwrap()
}

#[test]
fn what_would_be_lost_is_told_as_if_it_were_asked_from_the_beginning() {
    let (head, rules) = (Head::new(0.5, 75.0, 40.0, 20.0, 60.0, 60.0).unwrap(), rules());
    let (mut tried, mut refused) = (0, 0);
    for seed in 0..12 {
        let whole = crooked(seed);
        let bars = Bars::of(&whole, &head, &rules);
        let watch = &mut |_| ControlFlow::Continue(());
        let effort = &mut SearchEffort::new(u64::MAX, watch);
        // Without what no order has: something can be printed at first.
        let mut gone = State::new(&whole, &rules, &bars).rest().too_many(effort);
        let kept = |gone: &[u32]| {
            let stays = |strut: &u32| !gone.contains(strut);
            let edges = (0..).zip(&whole.edges).filter(|(strut, _)| stays(strut));
            let forms: Vec<Form> =
                whole.forms.iter().filter(|form| stays(&form.strut)).copied().collect();
            let struts: Vec<u32> = edges.clone().map(|(strut, _)| strut).collect();
            let place = |form: Form| struts.binary_search(&form.strut).unwrap() as u32;
            let forms = forms.into_iter().map(|form| Form { strut: place(form), ..form });
            let edges = edges.map(|(_, &edge)| edge).collect();
            (Lattice::new(whole.nodes.clone(), edges, forms.collect()).unwrap(), struts)
        };
        let lattice = loop {
            let (lattice, struts) = kept(&gone);
            let bars = Bars::of(&lattice, &head, &rules);
            let lost = State::new(&lattice, &rules, &bars).lost(effort);
            if lost.is_empty() {
                break lattice;
            }
            gone.extend(lost.into_iter().map(|strut| struts[strut as usize]));
        };
        let bars = Bars::of(&lattice, &head, &rules);
        let mut state = State::new(&lattice, &rules, &bars);
        assert!(state.lost(effort).is_empty());
        let mut draw = chance(seed + 99);
        for _ in 0..4 * lattice.len() {
            let open = (0..lattice.len() as u32).filter(|&strut| !state.printed[strut as usize]);
            let reached = open.flat_map(|strut| lattice.strokes_of(strut));
            let choices: Vec<Laid> = reached.filter_map(|stroke| state.reached(stroke)).collect();
            if choices.is_empty() || draw(6) == 0 {
                state.take_back();
                continue;
            }
            let laid = choices[draw(choices.len())];
            let after = [state.laid.as_slice(), &[laid]].concat();
            let can = rest_can_be_printed(&lattice, &rules, &bars, &after);
            assert_eq!(state.try_print(laid, effort), can, "seed {seed}, {after:?}");
            (tried, refused) = (tried + 1, refused + usize::from(!can));
        }
    }
    assert!(refused > tried / 50 && refused < tried, "{refused} of {tried}");
}
