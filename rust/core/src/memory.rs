//! How much memory a run may take: large allocations are claimed before they are made, so that a
//! file or a number in it ends as an error, not as an abort.

use std::sync::OnceLock;

use sysinfo::System;

use crate::error::{CoreError, Result};

/// The environment variable that sets the budget: bytes, or a number with K, M, G or T behind it.
pub const VARIABLE: &str = "WIREPRINT_MEMORY";
/// Share of what the machine or the control group allows that a run may take.
const SHARE: f64 = 0.75;
/// Where the system does not tell: as much as a small machine has, bytes.
const UNKNOWN: u64 = 2 << 30;

/// The budget of a run, bytes.
///
/// # Errors
/// [`CoreError::Memory`] where the variable is set to what is no amount.
pub fn budget() -> Result<u64> {
    static BUDGET: OnceLock<std::result::Result<u64, String>> = OnceLock::new();
    let found = BUDGET.get_or_init(|| match std::env::var_os(VARIABLE) {
        Some(text) if !text.is_empty() => given(&text.to_string_lossy()),
        _ => Ok(allowed()),
    });
    found.clone().map_err(CoreError::Memory)
}

/// The budget that the variable sets.
fn given(text: &str) -> std::result::Result<u64, String> {
    parsed(text).ok_or_else(|| {
        format!(
            "{VARIABLE} is {text:?}; it must be a number of bytes, or one with K, M, G or T behind \
             it, such as {VARIABLE}=4G"
        )
    })
}

/// Refuses an allocation that does not fit into the budget.
///
/// `what` says what the memory is for: "1 000 000 triangles".
///
/// # Errors
/// [`CoreError::Memory`] where `bytes` exceed the budget, or as [`budget`].
pub fn claim(bytes: u64, what: impl FnOnce() -> String) -> Result<()> {
    within(budget()?, bytes, what)
}

fn within(budget: u64, bytes: u64, what: impl FnOnce() -> String) -> Result<()> {
    if bytes <= budget {
        return Ok(());
    }
    let (needs, has) = (megabytes(bytes), megabytes(budget));
    Err(CoreError::Memory(format!(
        "{} would take about {needs} MB of memory, and {has} MB are allowed; {VARIABLE} sets how \
         much, e.g. {VARIABLE}={}G",
        what(),
        bytes.div_ceil(1 << 30),
    )))
}

fn megabytes(bytes: u64) -> u64 {
    bytes.div_ceil(1 << 20)
}

/// What the machine has, or its control group allows, less a reserve.
fn allowed() -> u64 {
    let mut system = System::new();
    system.refresh_memory();
    let machine = system.total_memory();
    let group = system.cgroup_limits().map_or(u64::MAX, |limits| limits.total_memory);
    match machine.min(group) {
        0 => UNKNOWN,
        bytes => (bytes as f64 * SHARE) as u64,
    }
}

/// Bytes from a number with an optional unit; None for anything else.
fn parsed(text: &str) -> Option<u64> {
    let text = text.trim().trim_end_matches(['B', 'b']);
    let unit = text.chars().next_back().map(|unit| unit.to_ascii_uppercase());
    let shift = unit.and_then(|unit| "KMGT".find(unit)).map_or(0, |place| 10 * (place as u32 + 1));
    let digits = if shift > 0 { &text[..text.len() - 1] } else { text };
    let number: f64 = digits.trim().parse().ok()?;
    let bytes = number * f64::from(2_u32).powi(shift as i32);
    (bytes.is_finite() && bytes >= 1.0).then_some(bytes as u64)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn units_are_powers_of_1024() {
        assert_eq!(parsed("1024"), Some(1024));
        assert_eq!(parsed("2K"), Some(2048));
        assert_eq!(parsed(" 1.5 GB "), Some(3 << 29));
        assert_eq!(parsed("3m"), Some(3 << 20));
        for nonsense in ["", "much", "-4G", "inf", "nan", "0"] {
            assert_eq!(parsed(nonsense), None, "{nonsense:?}");
            assert!(given(nonsense).unwrap_err().contains("WIREPRINT_MEMORY=4G"));
        }
    }

    #[test]
    fn what_exceeds_the_budget_is_refused_with_a_way_out() {
        assert!(within(1000, 1000, String::new).is_ok());
        let error = within(1 << 20, 3 << 30, || "12 triangles".into()).unwrap_err().to_string();
        assert!(error.starts_with("12 triangles would take about 3072 MB"), "{error}");
        assert!(error.contains("WIREPRINT_MEMORY=3G"), "{error}");
    }

    #[test]
    fn some_memory_is_always_allowed() {
        assert!(budget().unwrap() > 0);
    }
}
