//! Firmwares as readers of G-code.

/// Whose reading of ambiguous commands applies.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Dialect {
    /// G4 reads P only; G91 makes E relative while it lasts, G90 leaves M83 standing.
    Klipper,
    /// G4 lets S win over P; G90 and G91 set E too, as M82 and M83 do. Also `RepRapFirmware`'s
    /// and Repetier's kin, as far as files have both.
    Marlin,
}
