//! Where the time goes: by feature, by layer, by move.

use serde::{Deserialize, Serialize};

use super::queue::{MoveTag, Sink};

/// Classes of time that geometry alone tells; labelled strands come after them.
const TRAVEL: u16 = 0;
const RETRACT: u16 = 1;
const DWELL: u16 = 2;
const FIRST_FEATURE: u16 = 3;

/// Their names.
const FIXED: [&str; FIRST_FEATURE as usize] = ["travel", "retract", "dwell"];

/// Name of what extrudes without a `;TYPE:` label.
const UNLABELLED: &str = "other";

/// A layer's height and time.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct LayerTime {
    /// Height, mm, as its comment states it, else the end of its first strand; `None` where
    /// nothing is extruded.
    pub z: Option<f64>,
    /// Time of its moves and dwells, s.
    pub time_s: f64,
}

/// One row for each move and each dwell, in the file's order.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
pub struct Moves {
    /// Line of the file, from 1.
    pub line: Vec<u64>,
    /// Time, s.
    pub duration_s: Vec<f64>,
    /// Index into `types`.
    pub kind: Vec<u16>,
    /// What the entries of `kind` stand for.
    pub types: Vec<String>,
}

/// Adds up.
#[derive(Debug)]
pub(super) struct Tally {
    classes: Vec<f64>,
    layers: Vec<LayerTime>,
    moves: Option<Moves>,
    fed_mm: f64,
    filament_mm: f64,
}

/// What a tally comes to.
#[derive(Debug, Default)]
pub(super) struct Totals {
    pub(super) moving_s: f64,
    pub(super) travel_s: f64,
    pub(super) dwell_s: f64,
    pub(super) filament_mm: f64,
    pub(super) by_feature: Vec<(String, f64)>,
    pub(super) by_layer: Vec<LayerTime>,
    pub(super) moves: Option<Moves>,
}

impl Tally {
    pub(super) fn new(per_move: bool) -> Self {
        Self {
            classes: vec![0.0; usize::from(FIRST_FEATURE)],
            layers: vec![LayerTime { z: None, time_s: 0.0 }],
            moves: per_move.then(Moves::default),
            fed_mm: 0.0,
            filament_mm: 0.0,
        }
    }

    /// Notes a step's filament and says what its time will count as.
    #[inline]
    pub(super) fn tag(&mut self, line: u64, feature: u16, feed: Feed) -> MoveTag {
        let class = match feed {
            Feed::None => TRAVEL,
            Feed::Standing(_) => RETRACT,
            Feed::Moving { filament, .. } if filament < 0.0 => TRAVEL,
            Feed::Moving { .. } => self.strand_class(feature),
        };
        if let Feed::Moving { filament, .. } | Feed::Standing(filament) = feed {
            self.fed_mm += filament;
            self.filament_mm = self.filament_mm.max(self.fed_mm);
        }
        if let (Feed::Moving { z, .. }, Some(layer)) = (feed, self.layers.last_mut())
            && class >= FIRST_FEATURE
        {
            layer.z.get_or_insert(z);
        }
        MoveTag { line, layer: self.current_layer(), class }
    }

    #[inline]
    fn strand_class(&mut self, feature: u16) -> u16 {
        let class = FIRST_FEATURE.saturating_add(feature);
        if usize::from(class) >= self.classes.len() {
            self.classes.resize(usize::from(class) + 1, 0.0);
        }
        class
    }

    #[inline]
    fn current_layer(&self) -> u32 {
        u32::try_from(self.layers.len() - 1).unwrap_or(u32::MAX)
    }

    pub(super) fn begin_layer(&mut self) {
        self.layers.push(LayerTime { z: None, time_s: 0.0 });
    }

    pub(super) fn set_layer_height(&mut self, z: f64) {
        if let Some(layer) = self.layers.last_mut() {
            layer.z = Some(z);
        }
    }

    /// Notes a dwell; every move before it must have left its queue.
    pub(super) fn dwell(&mut self, line: u64, seconds: f64) {
        let tag = MoveTag { line, layer: self.current_layer(), class: DWELL };
        self.take(tag, seconds);
    }

    /// Adds up; `labels` are the machine's.
    pub(super) fn finish(mut self, labels: &[String]) -> Totals {
        let class_s = |class: u16| self.classes.get(usize::from(class)).copied().unwrap_or(0.0);
        let (travel_s, dwell_s) = (class_s(TRAVEL), class_s(DWELL));
        let moving_s = self.classes.iter().sum::<f64>() - dwell_s;
        let mut types: Vec<String> = FIXED.map(str::to_owned).into();
        types.extend(
            labels.iter().map(
                |label| {
                    if label.is_empty() { UNLABELLED.to_owned() } else { label.clone() }
                },
            ),
        );
        let mut by_feature: Vec<(String, f64)> = Vec::new();
        for (name, seconds) in types.iter().zip(self.classes) {
            add(&mut by_feature, name, seconds);
        }
        self.layers.retain(|layer| layer.time_s > 0.0 || layer.z.is_some());
        Totals {
            moving_s,
            travel_s,
            dwell_s,
            filament_mm: self.filament_mm,
            by_feature,
            by_layer: self.layers,
            moves: self.moves.map(|moves| Moves { types, ..moves }),
        }
    }
}

/// What a step does with the filament.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Feed {
    /// Nothing.
    None,
    /// Feeds it while the head stands, mm.
    Standing(f64),
    /// Feeds it while the head moves to height `z`, mm.
    Moving { filament: f64, z: f64 },
}

impl Sink for Tally {
    #[inline]
    fn take(&mut self, tag: MoveTag, seconds: f64) {
        if let Some(class) = self.classes.get_mut(usize::from(tag.class)) {
            *class += seconds;
        }
        if let Some(layer) = self.layers.get_mut(tag.layer as usize) {
            layer.time_s += seconds;
        }
        if let Some(moves) = &mut self.moves {
            moves.push(tag.line, seconds, tag.class);
        }
    }
}

impl Moves {
    fn push(&mut self, line: u64, seconds: f64, class: u16) {
        self.line.push(line);
        self.duration_s.push(seconds);
        self.kind.push(class);
    }
}

/// Adds to the entry of that name; one without time is not made.
fn add(entries: &mut Vec<(String, f64)>, name: &str, seconds: f64) {
    if seconds == 0.0 {
        return;
    }
    match entries.iter_mut().find(|(known, _)| known == name) {
        Some((_, sum)) => *sum += seconds,
        None => entries.push((name.to_owned(), seconds)),
    }
}
