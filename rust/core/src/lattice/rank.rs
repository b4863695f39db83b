//! What is printed next of what could be: low struts first, what closes before what hangs, and what an
//! earlier round could not print any more before the rest.

use glam::DVec3;

use super::state::State;
use super::{Laid, Lattice, Rules};

/// Heights of a strut above the others that one failure makes good, strands.
const BLAME: f64 = 4.0;
/// By how much chance may lift or lower a strut in later rounds, strands.
const CHANCE: f64 = 4.0;

/// How a round ranks what could be printed.
#[derive(Debug, Clone)]
pub struct StrokeRank {
    /// By strut: rounds that could not print it.
    blame: Vec<u32>,
    /// The round.
    round: u32,
}

impl StrokeRank {
    /// All struts alike.
    pub fn new(lattice: &Lattice) -> Self {
        Self { blame: vec![0; lattice.len()], round: 0 }
    }

    /// The next round prefers what this one could not print.
    pub fn blame(&mut self, struts: &[u32]) {
        self.round += 1;
        struts.iter().for_each(|&strut| self.blame[strut as usize] += 1);
    }

    /// What could be printed next, the best first: the lowest, of these what ends where it is held,
    /// then what hangs least, then what is near the head.
    pub fn choices(&self, lattice: &Lattice, rules: &Rules, state: &State<'_>) -> Vec<Laid> {
        let at = state.laid.last().map(|laid| lattice.places(laid.stroke)[1]);
        let open = (0..lattice.len() as u32).filter(|&strut| !state.printed[strut as usize]);
        let held = open
            .filter(|&strut| lattice.edges[strut as usize].iter().any(|&node| state.is_held(node)));
        let reached = held
            .flat_map(|strut| lattice.strokes_of(strut).filter_map(|stroke| state.reached(stroke)));
        let mut choices: Vec<([f64; 5], Laid)> = reached
            .filter(|&laid| state.holds(laid))
            .map(|laid| (self.key(lattice, rules, state, laid, at), laid))
            .collect();
        choices.sort_by(|(a, one), (b, other)| {
            let mut keys = a.iter().zip(b).map(|(a, b)| a.total_cmp(b));
            keys.find(|order| order.is_ne()).unwrap_or_else(|| one.stroke.cmp(&other.stroke))
        });
        choices.into_iter().map(|(_, laid)| laid).collect()
    }

    /// The same for each strut and round, within ±½; none in the first rounds.
    fn chance(&self, strut: u32) -> f64 {
        if self.round < 4 {
            return 0.0;
        }
        // Steele, Lea and Flood's SplitMix64, as a hash.
        let seed =
            (u64::from(self.round) << 32 | u64::from(strut)).wrapping_mul(0x9e37_79b9_7f4a_7c15);
        let mixed = (seed ^ (seed >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let mixed = (mixed ^ (mixed >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        (mixed >> 11) as f64 / (1_u64 << 53) as f64 - 0.5
    }

    fn key(
        &self,
        lattice: &Lattice,
        rules: &Rules,
        state: &State<'_>,
        laid: Laid,
        at: Option<DVec3>,
    ) -> [f64; 5] {
        let [from, to] = lattice.places(laid.stroke);
        let strut = lattice.strut(laid.stroke);
        let blame = BLAME * f64::from(self.blame[strut as usize]);
        let chance = CHANCE * self.chance(strut);
        let top = (from.z.max(to.z) / rules.strand + chance).round() - blame;
        let floats = f64::from(u8::from(laid.floating));
        let hangs =
            if laid.floating { (state.hanging(laid.stroke) / rules.strand).round() } else { 0.0 };
        // Straight where that does as well: knees take room from others.
        let bent = (lattice.pieces(laid.stroke).count() - 1) as f64;
        let travel = at.map_or(0.0, |at| at.distance(from));
        match self.round % 2 {
            0 => [top, floats, hangs, bent, travel],
            _ => [floats, top, hangs, bent, travel],
        }
    }
}
