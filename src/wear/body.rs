//! The body that wears.

/// Of which body a profile is, and over what the wear of its section is spread.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Body {
    /// A wheel: over the circumference at each place of its profile. Material is where z is
    /// smaller.
    Wheel {
        /// Radius of the nominal rolling circle [m].
        nominal_radius: f64,
    },
    /// A rail: over the running distance that it stands for. Material is where z is greater.
    Rail {
        /// That distance [m].
        distance: f64,
    },
}

impl Body {
    /// Distance of z = 0 from the axle, 0 of a rail [m].
    pub(super) fn radius(self) -> f64 {
        match self {
            Self::Wheel { nominal_radius } => nominal_radius,
            Self::Rail { .. } => 0.0,
        }
    }
}
