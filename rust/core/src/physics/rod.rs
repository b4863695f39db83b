//! A strand in the air as a planar rod that flows while it is hot.
//!
//! Elements between nodes with a place and a turn each; each element stretches and bends as
//! Maxwell's body with the modulus and the viscosity of its own age, and keeps its volume. Its
//! rotations may be large (Crisfield, Non-linear Finite Element Analysis, 1991, 7.2), inertia is
//! left out, and strains change at one rate within a step. SI units throughout this file.

use super::band::Band;

const GRAVITY: f64 = 9.80665;
/// Corrections after which a step of time is taken in two halves instead.
const CORRECTIONS: usize = 30;
/// A step is solved where a correction moves no node by more than this share of an element.
const SOLVED: f64 = 1e-8;
/// Halvings of a step after which the rod counts as torn.
const HALVINGS: u32 = 12;

/// What an element is like at a time: its modulus, and its viscosity in stretching.
pub(super) trait Ageing {
    /// Modulus (Pa) and viscosity in stretching (Pa·s) at an age in s.
    fn at(&self, age: f64) -> [f64; 2];
}

/// One element, as the last step left it.
#[derive(Debug, Clone, Copy)]
struct Element {
    /// When it left the nozzle, s.
    born: f64,
    /// m³.
    volume: f64,
    /// m.
    length: f64,
    /// By how much its ends are turned against its chord, rad.
    turned: [f64; 2],
    /// Pull along it, Pa.
    stress: f64,
    /// Moments at its ends, N·m.
    moments: [f64; 2],
}

/// Forces of an element on its ends, and what they grow by.
struct Answer {
    next: Element,
    forces: [f64; 6],
    stiffness: [[f64; 6]; 6],
}

/// A rod that starts at the origin, where it is clamped, and runs along x; y points up.
#[derive(Debug, Clone)]
pub(super) struct Rod {
    /// kg/m³.
    density: f64,
    elements: Vec<Element>,
    /// x, y and turn of each node.
    nodes: Vec<[f64; 3]>,
    now: f64,
    /// Whether the far end is held in its place.
    pub held: bool,
}

impl Rod {
    /// No rod yet, of a density in kg/m³; its far end will be held by the nozzle.
    pub(super) fn new(density: f64) -> Self {
        Self { density, elements: Vec::new(), nodes: vec![[0.0; 3]], now: 0.0, held: true }
    }

    /// Begins an element at the far end: in the next `step` s the nozzle goes on by `length` m and
    /// feeds a strand of `section` m², `drawn` times too short.
    pub(super) fn begin(&mut self, length: f64, section: f64, drawn: f64, step: f64) {
        let Some(&last) = self.nodes.last() else { return };
        let end = [last[0] + length, 0.0];
        let slope = (end[1] - last[1]).atan2(end[0] - last[0]);
        let away = (end[0] - last[0]).hypot(end[1] - last[1]);
        self.nodes.push([end[0], end[1], slope]);
        let turned = [last[2] - slope, 0.0];
        // The pull goes on to the nozzle; what leaves it is under that pull at once.
        let pull = self.elements.last().map_or(0.0, |last| last.stress * last.volume / last.length);
        self.elements.push(Element {
            born: self.now + step / 2.0,
            volume: section * length,
            // Where the strand hangs below the nozzle, what joins them is longer than its feed.
            length: away / drawn,
            turned,
            stress: pull / (section * drawn),
            moments: [0.0; 2],
        });
    }

    /// Feeds the last element likewise.
    pub(super) fn feed(&mut self, length: f64, section: f64, drawn: f64, step: f64) {
        if let (Some(last), [.., from, end]) = (self.elements.last_mut(), &mut self.nodes[..]) {
            let slope = |end: &[f64; 3]| (end[1] - from[1]).atan2(end[0] - from[0]);
            let before = slope(end);
            let added = length / drawn;
            let share = section * length / (last.volume + section * length);
            last.born += share * (self.now + step / 2.0 - last.born);
            last.length += added;
            last.volume += section * length;
            end[0] += length;
            // What is added is laid as it lies, and bent by nothing.
            let turn = slope(end) - before;
            last.turned.iter_mut().for_each(|turned| *turned -= turn);
        }
    }

    /// How far its lowest node hangs below its start, m.
    pub(super) fn sag(&self) -> f64 {
        self.nodes.iter().fold(0.0, |lowest: f64, node| lowest.max(-node[1]))
    }

    /// Lets it flow for `step` s; false where it tears.
    pub(super) fn flow(&mut self, step: f64, ageing: &impl Ageing) -> bool {
        self.flow_in_parts(step, ageing, HALVINGS)
    }

    fn flow_in_parts(&mut self, step: f64, ageing: &impl Ageing, halvings: u32) -> bool {
        if self.settle(step, ageing) {
            return true;
        }
        halvings > 0
            && self.flow_in_parts(step / 2.0, ageing, halvings - 1)
            && self.flow_in_parts(step / 2.0, ageing, halvings - 1)
    }

    /// One step by Newton's method; false, and nothing changed, where it does not converge.
    fn settle(&mut self, step: f64, ageing: &impl Ageing) -> bool {
        let now = self.now + step;
        // Half-way through the step, lest the cooling within it be counted twice.
        let middle = self.now + step / 2.0;
        let laws: Vec<[f64; 2]> = self
            .elements
            .iter()
            .map(|element| ageing.at((middle - element.born).max(0.0)))
            .collect();
        let mut nodes = self.nodes.clone();
        let count = 3 * nodes.len();
        let size = self.elements.iter().map(|element| element.length).fold(0.0, f64::max);
        for _ in 0..CORRECTIONS {
            let mut matrix = Band::zeros(count);
            let mut right = vec![0.0; count];
            let mut next = Vec::with_capacity(self.elements.len());
            for (i, (element, law)) in self.elements.iter().zip(&laws).enumerate() {
                let answer = element.answer([nodes[i], nodes[i + 1]], *law, step);
                let weight = self.density * element.volume * GRAVITY / 2.0;
                for (k, row) in answer.stiffness.iter().enumerate() {
                    right[3 * i + k] -= answer.forces[k];
                    for (l, &value) in row.iter().enumerate() {
                        matrix.add(3 * i + k, 3 * i + l, value);
                    }
                }
                right[3 * i + 1] -= weight;
                right[3 * i + 4] -= weight;
                next.push(answer.next);
            }
            let far = if self.held { count - 3..count - 1 } else { 0..0 };
            for unknown in (0..3).chain(far) {
                matrix.hold(unknown);
                right[unknown] = 0.0;
            }
            if !matrix.solve(&mut right) {
                return false;
            }
            let moved = right.chunks(3).fold(0.0, |most: f64, by| {
                most.max(by[0].abs()).max(by[1].abs()).max(by[2].abs() * size)
            });
            for (node, by) in nodes.iter_mut().zip(right.chunks(3)) {
                node.iter_mut().zip(by).for_each(|(place, by)| *place += by);
            }
            if moved < SOLVED * size {
                self.elements = next;
                self.nodes = nodes;
                self.now = now;
                return true;
            }
            if moved > 1e3 * size {
                return false;
            }
        }
        false
    }
}

impl Element {
    /// What it does where its ends are at places, `step` s after it was as it is.
    fn answer(
        &self,
        [from, to]: [[f64; 3]; 2],
        [modulus, viscosity]: [f64; 2],
        step: f64,
    ) -> Answer {
        let (dx, dy) = (to[0] - from[0], to[1] - from[1]);
        let length = dx.hypot(dy);
        let (cos, sin) = (dx / length, dy / length);
        let slope = dy.atan2(dx);
        let turned = [from[2] - slope, to[2] - slope];
        // σ' = E·(ε' − σ/3η) over a step in which ε' does not change: what is left of the old, and
        // how stiff the new is.
        let times = modulus * step / viscosity;
        let left = (-times).exp();
        let stiff = if times > 0.0 { modulus * -(-times).exp_m1() / times } else { modulus };
        let section = self.volume / self.length;
        let bend = stiff * section * section / (4.0 * std::f64::consts::PI) / self.length;
        let stress = self.stress * left + stiff * (length / self.length).ln();
        let pull = stress * section;
        let by = [turned[0] - self.turned[0], turned[1] - self.turned[1]];
        let moments = [
            self.moments[0] * left + bend * (4.0 * by[0] + 2.0 * by[1]),
            self.moments[1] * left + bend * (2.0 * by[0] + 4.0 * by[1]),
        ];
        let along = [-cos, -sin, 0.0, cos, sin, 0.0];
        let across = [sin, -cos, 0.0, -sin, cos, 0.0];
        let first: [f64; 6] =
            std::array::from_fn(|k| f64::from(u8::from(k == 2)) - across[k] / length);
        let second: [f64; 6] =
            std::array::from_fn(|k| f64::from(u8::from(k == 5)) - across[k] / length);
        let forces = std::array::from_fn(|k| {
            pull * along[k] + moments[0] * first[k] + moments[1] * second[k]
        });
        let sum = (moments[0] + moments[1]) / (length * length);
        let stiffness = std::array::from_fn(|k| {
            std::array::from_fn(|l| {
                section * stiff / length * along[k] * along[l]
                    + bend * 4.0 * (first[k] * first[l] + second[k] * second[l])
                    + bend * 2.0 * (first[k] * second[l] + second[k] * first[l])
                    + pull / length * across[k] * across[l]
                    + sum * (along[k] * across[l] + across[k] * along[l])
            })
        });
        let next = Self { length, turned, stress, moments, ..*self };
        Answer { next, forces, stiffness }
    }
}

#[cfg(test)]
mod tests {
    use std::f64::consts::PI;

    use super::*;

    /// Of one modulus and one viscosity at all ages.
    struct Same([f64; 2]);

    impl Ageing for Same {
        fn at(&self, _: f64) -> [f64; 2] {
            self.0
        }
    }

    const DIAMETER: f64 = 0.7e-3;
    const DENSITY: f64 = 1040.0;

    /// A straight rod that is there all at once.
    fn laid(length: f64, elements: u32) -> Rod {
        let mut rod = Rod::new(DENSITY);
        for _ in 0..elements {
            rod.begin(length / f64::from(elements), PI / 4.0 * DIAMETER * DIAMETER, 1.0, 0.0);
        }
        rod
    }

    fn weight() -> f64 {
        DENSITY * GRAVITY * PI / 4.0 * DIAMETER * DIAMETER
    }

    const COLD: Same = Same([2.2e9, 1e30]);

    #[test]
    fn a_cold_rod_is_a_beam() {
        let bend = 2.2e9 * PI * DIAMETER.powi(4) / 64.0;
        let length = 0.02_f64;
        let mut hinged = laid(length, 64);
        assert!(hinged.flow(1.0, &COLD));
        // The greatest deflection of a beam, clamped and hinged: Roark's formulas, table 8.1, 2c.
        let expected = 0.005_416_1 * weight() * length.powi(4) / bend;
        assert!((hinged.sag() / expected - 1.0).abs() < 2e-3, "{} {expected}", hinged.sag());
        let mut free = Rod { held: false, ..laid(length, 64) };
        assert!(free.flow(1.0, &COLD));
        let expected = weight() * length.powi(4) / 8.0 / bend;
        assert!((free.sag() / expected - 1.0).abs() < 2e-3, "{} {expected}", free.sag());
    }

    #[test]
    fn a_hot_rod_is_a_string_that_flows() {
        let viscosity = 3000.0;
        for length in [0.02_f64, 0.04] {
            for time in [0.3, 1.0] {
                let mut rod = laid(length, 80);
                for _ in 0..200 {
                    assert!(rod.flow(time / 200.0, &Same([1e9, 3.0 * viscosity])));
                }
                let cube = 3.0 * DENSITY * GRAVITY * length.powi(4) * time / (128.0 * viscosity);
                let share = rod.sag() / cube.cbrt();
                assert!((share - 1.0).abs() < 0.08, "{length} {time}: {share}");
            }
        }
    }
}
