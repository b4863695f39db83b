//! Speed, air and bond of strands, case by case.

use glam::DVec3;

use super::*;
use crate::printer::PATH;
use crate::strand::Kind;

fn strand(kind: Kind, length: f64, z: f64) -> Strand {
    let from = DVec3::new(0.0, 0.0, z);
    let to = from + DVec3::X * length;
    Strand { from, to, kind, slab: 0, floating: false, flow: 1.0, direct: false }
}

#[test]
fn air_blows_wherever_strands_hang() {
    let kinds = [(Kind::Cap, 6.0), (Kind::Contour, 0.35), (Kind::LayerWise, 6.0)];
    let blows = |cooling: CoolingMethod| {
        let p = PathParams { cooling, ..PATH };
        kinds.map(|(kind, z)| air(&strand(kind, 9.0, z), &p))
    };
    assert_eq!(blows(CoolingMethod::Valve), [true, false, false]);
    assert_eq!(blows(CoolingMethod::HaltingValve), [true, false, false]);
    assert_eq!(blows(CoolingMethod::Fan), [true, false, true]);
    assert_eq!(blows(CoolingMethod::Still), [false; 3]);
}

#[test]
fn the_air_stops_before_a_joint_only_under_a_quick_valve_and_on_long_strands_that_land() {
    // Two diameters of 0.7 mm, of which a strand must be three times as long.
    let share = |kind: Kind, length: f64, z: f64, lands: bool, cooling: CoolingMethod| {
        airy_share(&strand(kind, length, z), lands, &PathParams { cooling, ..PATH })
    };
    let bond = 1.4;
    assert_eq!(share(Kind::Cap, 7.0, 6.0, true, CoolingMethod::Valve), 1.0 - bond / 7.0);
    assert_eq!(share(Kind::Cap, 4.21, 6.0, true, CoolingMethod::Valve), 1.0 - bond / 4.21);
    assert_eq!(share(Kind::Cap, 4.19, 6.0, true, CoolingMethod::Valve), 1.0);
    assert_eq!(share(Kind::Cap, 7.0, 6.0, false, CoolingMethod::Valve), 1.0);
    for cooling in [CoolingMethod::HaltingValve, CoolingMethod::Fan, CoolingMethod::Still] {
        assert_eq!(share(Kind::Cap, 7.0, 6.0, true, cooling), 1.0);
    }
    // Where none blows, none stops.
    assert_eq!(share(Kind::Contour, 7.0, 0.35, true, CoolingMethod::Valve), 1.0);
    assert_eq!(share(Kind::LayerWise, 7.0, 6.0, true, CoolingMethod::Valve), 1.0);
}

#[test]
fn strands_have_the_speed_of_what_they_lie_on() {
    let told = |strategy: Strategy, strand: &Strand| {
        let p = PathParams { strategy, ..PATH };
        speed(strand, &p)
    };
    let hanging = strand(Kind::Cap, 9.0, 6.0);
    let floating = Strand { floating: true, ..hanging };
    let rising = Strand { to: DVec3::new(9.0, 0.0, 9.0), kind: Kind::Diagonal, ..hanging };
    let layer = strand(Kind::LayerWise, 9.0, 6.0);
    for strategy in [Strategy::Pause, Strategy::Slow, Strategy::Overshoot] {
        assert_eq!(told(strategy, &strand(Kind::Contour, 9.0, 0.35)), 20.0);
        assert_eq!(told(strategy, &layer), 15.0);
        // No more melt a second than strands in the air take.
        assert_eq!(told(strategy, &Strand { flow: 4.0, ..layer }), 7.5);
        assert_eq!(told(strategy, &hanging), 30.0);
    }
    assert_eq!([floating, rising].map(|s| told(Strategy::Slow, &s)), [5.0, 5.0]);
    assert_eq!([floating, rising].map(|s| told(Strategy::Pause, &s)), [30.0, 30.0]);
}
