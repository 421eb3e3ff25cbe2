//! Creep force of an ellipse, as the table has it.

/// Creep force of an ellipse over μ N (moment over μ N c), on the body whose creepage is given.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct EllipseForce<T = f64> {
    /// Longitudinal and lateral force and spin moment.
    pub force: [T; 3],
    /// Share of the area that slips, 0 to 1.
    pub slip_share: T,
}

/// Derivatives of longitudinal and lateral force, moment and share of slip by the three creepages v
/// and ln(a/b).
pub type ForceSlopes = [[f64; 4]; 4];
