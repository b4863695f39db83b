//! What comments say of the moves that follow: `;TYPE:` and `;KIND:` labels, and layers.

use super::number::decimal;

/// Different `;TYPE:` labels told apart; later ones count as the first, unnamed one.
const MAX_FEATURES: usize = 1 << 10;

/// The labels met so far.
#[derive(Debug, Clone)]
pub(super) struct Features {
    /// In small letters; the first, empty one is that of what came before any.
    pub(super) names: Vec<String>,
    /// Index of the one that holds now.
    pub(super) current: u16,
}

/// What a comment says.
pub(super) enum Remark {
    /// Nothing of concern, or a label.
    None,
    /// A layer begins.
    Layer,
    /// The layer's height, mm.
    Height(f64),
}

impl Features {
    pub(super) fn new() -> Self {
        Self { names: vec![String::new()], current: 0 }
    }

    /// Reads a comment.
    pub(super) fn comment(&mut self, text: &[u8]) -> Remark {
        // Ours, where `TYPE` has the words that a slicer's viewer knows.
        let label = text.strip_prefix(b"TYPE:").or_else(|| text.strip_prefix(b"KIND:"));
        if let Some(label) = label {
            self.current = self.index_of(label);
        } else if text.starts_with(b"LAYER_CHANGE") || is_layer_number(text) {
            return Remark::Layer;
        } else if let Some(height) = text.strip_prefix(b"Z:")
            && let Some((height, _)) = decimal(height.trim_ascii())
        {
            return Remark::Height(height);
        }
        Remark::None
    }

    fn index_of(&mut self, label: &[u8]) -> u16 {
        let label = String::from_utf8_lossy(label.trim_ascii()).to_lowercase();
        let known = self.names.iter().position(|name| *name == label);
        let index = known.unwrap_or_else(|| {
            if self.names.len() == MAX_FEATURES {
                return 0;
            }
            self.names.push(label);
            self.names.len() - 1
        });
        u16::try_from(index).unwrap_or(0)
    }
}

fn is_layer_number(text: &[u8]) -> bool {
    text.strip_prefix(b"LAYER:")
        .is_some_and(|rest| rest.trim_ascii().iter().all(|b| b.is_ascii_digit() || *b == b'-'))
}
