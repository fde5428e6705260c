//! Linear theory (4.3): creepage and spin so small that slip is confined to the trailing edge.

/// Creepage and spin coefficients `C_ij` (Table 3).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CreepageCoefficients {
    /// Longitudinal force by longitudinal creepage.
    pub c11: f64,
    /// Lateral force by lateral creepage.
    pub c22: f64,
    /// Lateral force by spin.
    pub c23: f64,
    /// Moment by lateral creepage; `-c23` in the limit of infinite degree.
    pub c32: f64,
    /// Moment by spin.
    pub c33: f64,
}
