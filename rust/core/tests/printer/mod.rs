//! Printers, and a mesh as a print of theirs: the one place where tests state figures of a printer.
#![allow(dead_code, reason = "each test binary uses some of it")]
#![allow(clippy::unwrap_used, reason = "a test may panic")]

use glam::DVec2;
use wireprint_core::head::Head;
use wireprint_core::mesh::Mesh;
use wireprint_core::slices::heights::HeightParams;
use wireprint_core::strand::Kind;
use wireprint_core::stroke::Strokes;
use wireprint_core::toolpath::{BedShape, CoolingMethod, PathParams, PressureAdvance, Strategy};
use wireprint_core::wireframe::build::build;
use wireprint_core::wireframe::frame::Wireframe;
use wireprint_core::wireframe::params::{Pattern, Times, WireParams};
use wireprint_core::wireframe::place::zigzag::Placement;
use wireprint_core::wireframe::plan::sliced::{Sliced, slice_model};
use wireprint_core::wireframe::regions::layered::Layered;

/// A toolpath of 0.7 mm strand from 1.75 mm filament, nothing on the bed but the print.
pub const PATH: PathParams = PathParams {
    standing: 0.0,
    centre: DVec2::new(100.0, 80.0),
    plate: BedShape::Rectangle(DVec2::new(100.0, 80.0)),
    strand: 0.7,
    filament: 1.75,
    first_layer: 0.35,
    print_speed: 30.0,
    bed_speed: 20.0,
    layer_speed: 15.0,
    slow_speed: 5.0,
    travel_speed: 150.0,
    strategy: Strategy::Pause,
    cooling: CoolingMethod::Valve,
    pause: 1.2,
    climb: None,
    overshoot: 0.5,
    pressure_lag: 0.0,
    advance: PressureAdvance::None,
    retract: 4.0,
    layer_retract_over: 2.0,
    retract_speed: 30.0,
    unretract_speed: 25.0,
    prime: 5.0,
    travel_lift: 1.0,
    skirt_rings: 0,
    skirt_gap: 3.0,
    brim_rings: Some(0),
};

/// A printer with its wire.
#[derive(Debug, Clone)]
pub struct Printer {
    pub head: Head,
    pub heights: HeightParams,
    pub wire: WireParams,
}

impl Printer {
    /// A printer whose strand, tip and heights are `scale` times those of the paper's, which has a
    /// flank of 32°.
    pub fn new(scale: f64, slant_deg: f64) -> Self {
        let strand = 0.7 * scale;
        let head = Head::new(
            0.5 * scale,
            slant_deg,
            6.0 * scale,
            20.0 * scale,
            30.0 * scale,
            60.0 * scale,
        );
        let head = head.unwrap();
        let heights = HeightParams {
            slab_min: 1.4 * scale,
            slab_max: 6.0 * scale,
            first_layer: 0.35 * scale,
            strand,
            free_end: 20.0 * scale,
            deviation_target: 0.3 * scale,
            speed: 30.0 * scale,
            pause: 1.0,
            low_slabs: Vec::new(),
            hop: 0.3,
            coils: true,
            climb: None,
        };
        let wire = WireParams {
            strand,
            pattern: Pattern::Zigzag,
            placement: Placement::Optimal,
            caps: true,
            supports: true,
            bearing: false,
            cap_spacing: 6.0 * scale,
            span_limit: 65.0 * scale,
            free_end_limit: 20.0 * scale,
            times: Times {
                print_speed: 30.0 * scale,
                travel_speed: 150.0 * scale,
                pause: 1.0,
                hop: 0.3,
                climb: None,
            },
        };
        Self { head, heights, wire }
    }

    /// The paper's printer.
    pub fn paper() -> Self {
        Self::new(1.0, 32.0)
    }

    /// The paper's printer, one with a fine and slim nozzle, and one with a blunt one.
    pub fn all() -> [Self; 3] {
        [Self::paper(), Self::new(0.6, 55.0), Self::new(0.8, 25.0)]
    }

    pub fn strokes(&self) -> Strokes {
        Strokes::new(&self.head, self.wire.strand)
    }

    pub fn slice(&self, mesh: &Mesh) -> Sliced {
        slice_model(mesh, &self.head, &self.heights).unwrap()
    }

    pub fn print(&self, mesh: &Mesh) -> Print {
        self.print_sliced(self.slice(mesh), &Layered::default())
    }

    pub fn print_sliced(&self, sliced: Sliced, layered: &Layered) -> Print {
        let frame = build(sliced, layered, &self.head, &self.wire);
        Print { printer: self.clone(), frame }
    }
}

/// A print and its printer.
#[derive(Debug)]
pub struct Print {
    pub printer: Printer,
    pub frame: Wireframe,
}

impl Print {
    /// Number of strands of a kind.
    pub fn count(&self, kind: Kind) -> usize {
        self.frame.strands.iter().filter(|strand| strand.kind == kind).count()
    }

    /// Whether nothing is left out.
    pub fn is_whole(&self) -> bool {
        self.frame.unprinted.is_empty()
    }
}
