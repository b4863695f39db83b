//! Whether E counts from the start or from the last move, where a file leaves that to a macro.
//!
//! Firmwares start in absolute mode. A file whose moves are relative, but whose M83 stands in a macro
//! of the printer's, then runs backwards all the time: that no extruder is meant to.

use std::ops::ControlFlow;

use super::command::{Axes, Command};
use super::reader::Commands;

/// So many moves must run backwards or stand still, and such a share of all that should extrude.
/// A file in absolute words goes backwards only to wipe.
const LEAST_BACK: u32 = 3;
const SHARE_BACK: f64 = 1.0 / 3.0;

/// Whether E must be relative in a text that does not say so.
#[must_use]
pub fn is_relative(text: &[u8]) -> bool {
    let mut mode = ImpliedMode::default();
    let _ = Commands::new(text).try_for_each(|(_, command)| mode.see(&command));
    mode.is_relative()
}

/// Looks at the commands of a file from its start on, until one states the mode.
#[derive(Debug, Default)]
pub struct ImpliedMode {
    /// E as it was written last.
    last: f64,
    moves: u32,
    back: u32,
    /// Whether coordinates are relative, and E with them.
    relative: bool,
}

impl ImpliedMode {
    /// Takes the next command; breaks off where nothing that follows matters.
    pub fn see(&mut self, command: &Command<'_>) -> ControlFlow<()> {
        match command {
            Command::Linear { axes, .. } | Command::Arc { axes, .. } if !self.relative => {
                self.moved(axes);
            }
            Command::Extrusion { .. } => return ControlFlow::Break(()),
            Command::Positioning { relative, .. } => self.relative = *relative,
            Command::SetPosition { axes, .. } => {
                let bare = axes.x.or(axes.y).or(axes.z).is_none();
                self.last = axes.e.or(bare.then_some(0.0)).unwrap_or(self.last);
            }
            _ => {}
        }
        ControlFlow::Continue(())
    }

    fn moved(&mut self, axes: &Axes) {
        let Some(value) = axes.e else { return };
        if axes.x.or(axes.y).or(axes.z).is_some() {
            self.moves = self.moves.saturating_add(1);
            self.back = self.back.saturating_add(u32::from(value <= self.last));
        }
        self.last = value;
    }

    /// Whether E must be relative, though nothing said so.
    #[must_use]
    pub fn is_relative(&self) -> bool {
        self.back >= LEAST_BACK && f64::from(self.back) >= SHARE_BACK * f64::from(self.moves)
    }
}

#[cfg(test)]
mod tests {
    use super::is_relative as of_bytes;

    fn is_relative(text: &str) -> bool {
        of_bytes(text.as_bytes())
    }

    #[test]
    fn moves_that_run_backwards_all_the_time_are_relative() {
        let text = "PRINT_START\nG1 X1 E2\nG1 X2 E2\nG1 X3 E1\nG1 E-1\nG1 X4 E1\nG1 X5 E1\n";
        assert!(is_relative(text));
        assert!(!is_relative(&format!("M82\n{text}")), "the file says what it is");
        assert!(!is_relative(&format!("M83\n{text}")), "and needs no guess then");
    }

    #[test]
    fn absolute_words_may_wipe_and_start_anew() {
        let layer: String = (1..40).map(|i| format!("G1 X{i} E{i}\n")).collect();
        let wiping = "G1 X39 E38.5\nG1 X38 E38\nG92 E0\n";
        assert!(!is_relative(&format!("{layer}{wiping}{layer}{wiping}")));
    }
}
