use std::ops::ControlFlow;

use glam::dvec3;

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
