//! How well strands weld to what they are laid on.

use super::contacts::Contact;
use super::scene::{Found, Scene};
use super::weld::Welds;

/// Joints by strand.
pub(super) struct Joints {
    /// Age of what a strand is joined to at its weaker end, s.
    pub age: Vec<f64>,
    /// Temperature of that, °C.
    pub celsius: Vec<f64>,
    /// Share of a whole weld there.
    pub weld: Vec<f64>,
    pub found: Found,
    /// Of all strands that have a joint.
    pub median: f64,
}

/// One joint: share of a weld, and age and temperature of the older strand.
type Joint = (f64, f64, f64);

/// Looks at the joints between strands; lying on the bed is none, nor is going on.
pub(super) fn joints(scene: &Scene<'_>, contacts: &[Contact]) -> Joints {
    let matter = &scene.terms.matter;
    let tables: Vec<Welds> =
        scene.climate.speeds().iter().map(|&speed| Welds::of(matter, speed)).collect();
    let count = scene.deposit.strands.len();
    // The best joint of each half of a strand.
    let mut best: Vec<[Option<Joint>; 2]> = vec![[None; 2]; count];
    for contact in contacts.iter().filter(|contact| !contact.goes_on()) {
        let [old, new] = contact.strands.map(|strand| strand as usize);
        let now = scene.when(new, contact.at[1]);
        let laid = scene.when(old, contact.at[0]);
        let celsius = scene.climate.celsius(laid, now);
        let joint = (tables[scene.climate.level(now)].at(celsius), now - laid, celsius);
        let half = &mut best[new][usize::from(contact.at[1] >= 0.5)];
        if half.is_none_or(|known| joint.0 > known.0) {
            *half = Some(joint);
        }
    }
    let mut found = Joints {
        age: vec![f64::NAN; count],
        celsius: vec![f64::NAN; count],
        weld: vec![f64::NAN; count],
        found: Found::default(),
        median: f64::NAN,
    };
    let mut shares = Vec::new();
    for (strand, halves) in best.into_iter().enumerate() {
        let weaker = halves.into_iter().flatten().min_by(|a, b| a.0.total_cmp(&b.0));
        let Some((share, age, celsius)) = weaker else { continue };
        (found.weld[strand], found.age[strand], found.celsius[strand]) = (share, age, celsius);
        found.found.add(scene.at_end(strand, 1.0 - share, 0.0, celsius), f64::INFINITY);
        shares.push(share);
    }
    shares.sort_by(f64::total_cmp);
    found.median = shares.get(shares.len() / 2).copied().unwrap_or(f64::NAN);
    found
}
