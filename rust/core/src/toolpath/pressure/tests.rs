//! What is squeezed, pulled back and given again, step by step.

use glam::DVec3;

use super::*;
use crate::printer::PATH;
use crate::strand::Kind;

fn stroke(to: DVec3, flow: f64) -> Strand {
    let (from, kind) = (DVec3::ZERO, Kind::Post);
    Strand { from, to, kind, slab: 0, floating: true, flow, direct: false }
}

#[test]
fn a_stroke_wants_what_its_feed_squeezes_unless_firmware_sees_to_it() {
    let wants = |to: DVec3, flow: f64, advance: PressureAdvance| {
        wanted(&stroke(to, flow), 30.0, &PathParams { pressure_lag: 0.5, advance, ..PATH })
    };
    // 0.16 mm of filament a mm: 2.4 mm in half a second.
    let (up, aside) = (DVec3::Z, DVec3::new(0.0, 3.0, 4.0));
    for to in [up, aside] {
        assert!((wants(to, 1.0, PressureAdvance::None) - 2.4).abs() < 1e-9);
        assert!((wants(to, 0.5, PressureAdvance::None) - 1.2).abs() < 1e-9);
        assert_eq!(wants(to, 1.0, PressureAdvance::All), 0.0);
    }
    assert!((wants(up, 1.0, PressureAdvance::Sideways) - 2.4).abs() < 1e-9);
    assert_eq!(wants(aside, 1.0, PressureAdvance::Sideways), 0.0);
}

#[test]
fn only_differences_that_the_file_can_tell_are_fed() {
    let mut pressure = Pressure::default();
    assert_eq!(pressure.prepare(LEAST), None);
    assert_eq!(pressure.prepare(2.0), Some(2.0));
    assert_eq!((pressure.prepare(2.0), pressure.prepare(2.0 - 0.9 * LEAST)), (None, None));
    assert_eq!((pressure.prepare(0.5), pressure.prepare(1.5)), (Some(-1.5), Some(1.0)));
    assert_eq!((pressure.ease(), pressure.ease()), (Some(1.5), None));
    assert_eq!(pressure.prepare(1.5), Some(1.5));
    pressure.fill(LEAST);
    assert_eq!(pressure.ease(), None);
}

#[test]
fn a_retraction_pulls_back_what_is_left_of_it() {
    let eased = |by: f64| {
        let mut pressure = Pressure::default();
        pressure.fill(by);
        pressure.ease();
        pressure
    };
    let left = |pressure: Pressure, advance: PressureAdvance| {
        pressure.left_of(4.0, &PathParams { advance, ..PATH })
    };
    assert_eq!(left(eased(1.5), PressureAdvance::None), 2.5);
    assert_eq!(
        (left(eased(5.0), PressureAdvance::None), left(eased(0.0), PressureAdvance::None)),
        (0.0, 4.0)
    );
    assert_eq!(
        (left(eased(1.5), PressureAdvance::All), left(eased(1.5), PressureAdvance::Sideways)),
        (4.0, 4.0)
    );
    let mut again = eased(1.5);
    again.prepare(1.0);
    assert_eq!(left(again, PressureAdvance::None), 4.0);
}
