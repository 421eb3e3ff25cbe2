//! A contact of wheel and rail: the place of first touch and the frame there.

use crate::math::numbers::{Numbers, numbers};
use crate::math::real::Real;

/// One patch: where wheel and rail touch first and the frame there.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct Contact<T = f64> {
    /// Parameter of the contact line [m].
    pub u: T,
    /// Parameter of the rail's curve [m].
    pub rail_s: T,
    /// Penetration δ > 0 [m].
    pub penetration: T,
    /// Point of the rail: the origin of the contact frame [m].
    pub origin: [T; 2],
    /// Unit vector (y, z) of the frame's lateral axis.
    pub tangent: [T; 2],
    /// First and one past the last of its probes.
    pub probes: [usize; 2],
}

numbers!(Contact: u, rail_s, penetration, origin, tangent; kept probes);

impl<T: Real> Contact<T> {
    /// The same without derivatives.
    pub fn value(&self) -> Contact {
        self.each(&mut T::value)
    }

    /// Unit vector (y, z) of the frame's normal, into the rail.
    pub fn normal(&self) -> [T; 2] {
        [-self.tangent[1], self.tangent[0]]
    }

    /// Roll of the contact frame about x [rad].
    pub fn angle(&self) -> T {
        self.tangent[1].atan2(self.tangent[0])
    }
}
