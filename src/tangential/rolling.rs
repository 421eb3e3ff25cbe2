//! How a loaded zone rolls.

use crate::kinematics::creepage::Creepage;
use crate::math::real::Real;
use crate::normal::Zone;

/// Which end of the strips leads.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Rolling {
    /// The contact moves towards positive x.
    Forward,
    /// The contact moves towards negative x.
    Backward,
}

impl Rolling {
    /// 1 when rolling forward, -1 when backward.
    pub(super) fn direction(self) -> f64 {
        match self {
            Self::Forward => 1.0,
            Self::Backward => -1.0,
        }
    }
}

/// How a zone rolls and how much friction it has.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RollingState<T = f64> {
    /// Creepage at the centroid of load of the zone.
    pub creepage: Creepage<T>,
    /// 1 when rolling forward, 0 when backward; see
    /// [`rolling_speed`](crate::kinematics::creepage::rolling_speed) [-].
    pub forward_share: T,
    /// Coefficient of friction, ≥ 0; without effect where strips have their own [-].
    pub friction: T,
    /// Normal force with damping over that without, ≥ 0 [-].
    pub load_factor: T,
    /// Speed that creepages refer to, ≥ 0 [m/s]; for friction that falls with the slip velocity
    /// alone.
    pub speed: T,
}

impl<T: Real> RollingState<T> {
    /// Friction limit μ N of `zone`, ≥ 0 [N].
    pub fn friction_limit(&self, zone: &Zone<T>) -> T {
        self.friction * zone.load * self.load_factor
    }
}
