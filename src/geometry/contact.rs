//! A contact of wheel and rail: the place of first touch and the frame there.

/// One patch: where wheel and rail touch first and the frame there.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Contact {
    /// Parameter of the contact line [m].
    pub u: f64,
    /// Parameter of the rail's curve [m].
    pub rail_s: f64,
    /// Penetration δ > 0 [m].
    pub penetration: f64,
    /// Point of the rail: the origin of the contact frame [m].
    pub origin: [f64; 2],
    /// Unit vector (y, z) of the frame's lateral axis.
    pub tangent: [f64; 2],
    /// First and one past the last of its probes.
    pub probes: [usize; 2],
}

impl Contact {
    /// Unit vector (y, z) of the frame's normal, into the rail.
    #[must_use]
    pub fn normal(&self) -> [f64; 2] {
        [-self.tangent[1], self.tangent[0]]
    }

    /// Roll of the contact frame about x [rad].
    #[must_use]
    pub fn angle(&self) -> f64 {
        self.tangent[1].atan2(self.tangent[0])
    }
}
