//! Tangential contact: creep forces of loaded zones.

pub mod fastsim;
pub mod flexibility;
pub mod kalker_coefficients;

/// Creepage of the wheel against the rail at one point of the contact plane.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Creepage {
    /// Longitudinal, ξ = relative velocity along x over V [-].
    pub longitudinal: f64,
    /// Lateral, η, along the lateral axis of the contact frame [-].
    pub lateral: f64,
    /// Spin, φ = normal component of the relative angular velocity over V [1/m].
    pub spin: f64,
}

impl Creepage {
    /// Whether all three vanish, so that there is nothing to compute.
    #[must_use]
    pub fn is_zero(&self) -> bool {
        [self.longitudinal, self.lateral, self.spin].iter().all(|c| c.abs() == 0.0)
    }
}

/// Which end of the strips leads.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Rolling {
    /// The contact moves towards positive x.
    Forward,
    /// The contact moves towards negative x.
    Backward,
}

/// Creep force of one zone on the wheel, in the contact frame.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct CreepForce {
    /// Longitudinal force [N].
    pub longitudinal: f64,
    /// Lateral force [N].
    pub lateral: f64,
    /// Moment about the normal through the centroid of the load [N m].
    pub spin_moment: f64,
    /// Area that slips [m²].
    pub slip_area: f64,
}
