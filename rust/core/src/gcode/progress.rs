//! Progress for the printer's display: how much is done, how long it still takes.

use memchr::memchr_iter;

use super::template::Template;

/// The fields of the template: percent done, minutes left.
pub const FIELDS: [&str; 2] = ["percent", "minutes"];

/// Inserts a line wherever percent or minutes change, in front of the move that is then due.
///
/// `lines` (from 1, ascending) and `durations` (s) describe the moves of `text`. Minutes are
/// rounded up, so that 0 stands only after the last move.
#[must_use]
pub fn insert(text: &[u8], lines: &[u64], durations: &[f64], template: &Template) -> Vec<u8> {
    let total: f64 = durations.iter().sum();
    let mut out = Vec::with_capacity(text.len() + text.len() / 8);
    let mut starts = std::iter::once(0).chain(memchr_iter(b'\n', text).map(|end| end + 1));
    let (mut line, mut start) = (1, starts.next().unwrap_or_default());
    let (mut copied, mut elapsed, mut shown) = (0, 0.0, None);
    for (&due, duration) in lines.iter().zip(durations) {
        let due_state = state(elapsed, total);
        if shown != Some(due_state) {
            while line < due {
                (line, start) = (line + 1, starts.next().unwrap_or(text.len()));
            }
            out.extend_from_slice(text.get(copied..start).unwrap_or_default());
            template.write(&mut out, &due_state, 0);
            (copied, shown) = (start, Some(due_state));
        }
        elapsed += duration;
    }
    out.extend_from_slice(text.get(copied..).unwrap_or_default());
    template.write(&mut out, &[100, 0], 0);
    out
}

fn state(elapsed: f64, total: f64) -> [i64; 2] {
    let percent = if total > 0.0 { 100.0 * elapsed / total } else { 0.0 };
    [(percent as i64).min(99), ((total - elapsed) / 60.0).ceil().max(1.0) as i64]
}

#[cfg(test)]
mod tests {
    use super::*;

    fn inserted(text: &str, lines: &[u64], durations: &[f64]) -> String {
        let template = Template::new("M73 P{percent} R{minutes}\n", &FIELDS).unwrap();
        String::from_utf8(insert(text.as_bytes(), lines, durations, &template)).unwrap()
    }

    #[test]
    fn a_line_stands_before_each_move_that_changes_it() {
        let text = "; comment\nG1 X1\nG1 X2\nG4 P1\nG1 X3\n";
        let expected = "; comment\nM73 P0 R3\nG1 X1\nM73 P50 R2\nG1 X2\nG4 P1\n\
             M73 P75 R1\nG1 X3\nM73 P100 R0\n";
        assert_eq!(inserted(text, &[2, 3, 4, 5], &[90.0, 0.5, 44.5, 45.0]), expected);
    }

    #[test]
    fn several_moves_of_one_line_stay_together() {
        assert_eq!(
            inserted("G2 X1 I1\n", &[1, 1, 1], &[60.0, 60.0, 60.0]).matches("G2 X1 I1\n").count(),
            1
        );
    }

    #[test]
    fn text_without_moves_is_complete_at_once() {
        assert_eq!(inserted("; nothing\n", &[], &[]), "; nothing\nM73 P100 R0\n");
    }

    #[test]
    fn without_its_insertions_the_text_is_as_before() {
        let text: String = (0..1000).map(|i| format!("G1 X{i}\n")).collect();
        let lines: Vec<u64> = (1..=1000).collect();
        let durations: Vec<f64> = (0..1000).map(|i| f64::from(i % 13)).collect();
        let with = inserted(&text, &lines, &durations);
        let without: String =
            with.lines().filter(|l| !l.starts_with("M73")).fold(String::new(), |mut all, line| {
                all.push_str(line);
                all.push('\n');
                all
            });
        assert_eq!(without, text);
        assert!(with.matches("M73").count() > 100);
    }
}
