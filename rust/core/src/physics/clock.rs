//! When each move of a text begins and ends.

use crate::gcode::event::Step;

/// Times of the lines of a text, as a planner tells them: rows of a line follow each other.
#[derive(Debug, Clone, Copy)]
pub struct StrandTimes<'a> {
    /// Line of each row.
    pub lines: &'a [u64],
    /// How long each takes, s.
    pub durations: &'a [f64],
}

/// Begin and end of a move, s since the text began.
pub(super) type TimeSpan = [f64; 2];

/// When each step begins and ends: those of one line share its time by their paths, or, where
/// nothing but filament moves, by that.
pub(super) fn spans(steps: &[Step], times: StrandTimes<'_>) -> Vec<TimeSpan> {
    let mut rows = times.lines.iter().zip(times.durations).peekable();
    let mut now = 0.0;
    let mut spans = Vec::with_capacity(steps.len());
    for of_line in steps.chunk_by(|a, b| a.line == b.line) {
        let line = of_line[0].line;
        let mut takes = 0.0;
        while let Some((&at, &seconds)) = rows.next_if(|&(&at, _)| at <= line) {
            // What comes before are lines that move nothing, such as dwells.
            if at < line { now += seconds } else { takes += seconds }
        }
        let path = |step: &Step| step.from.distance(step.to);
        let moves = of_line.iter().any(|step| path(step) > 0.0);
        let weight = |step: &Step| if moves { path(step) } else { step.filament.abs() };
        let whole: f64 = of_line.iter().map(weight).sum();
        for step in of_line {
            let end = now + if whole > 0.0 { takes * weight(step) / whole } else { 0.0 };
            spans.push([now, end]);
            now = end;
        }
    }
    spans
}

#[cfg(test)]
mod tests {
    use glam::{DVec3, dvec3};

    use super::*;

    fn step(line: u64, x: f64) -> Step {
        Step {
            line,
            from: DVec3::ZERO,
            to: dvec3(x, 0.0, 0.0),
            filament: 1.0,
            speed: 1.0,
            rapid: false,
            homing: false,
            feature: 0,
        }
    }

    #[test]
    fn steps_of_a_line_share_its_time_and_dwells_come_between() {
        let steps = [step(1, 1.0), step(1, 3.0), step(3, 0.0), step(3, 0.0), step(9, 1.0)];
        let times = StrandTimes { lines: &[1, 1, 2, 3], durations: &[1.0, 3.0, 0.5, 1.0] };
        let expected = [[0.0, 1.0], [1.0, 4.0], [4.5, 5.0], [5.0, 5.5], [5.5, 5.5]];
        assert_eq!(spans(&steps, times), expected);
    }
}
