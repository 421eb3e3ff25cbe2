//! What is odd about the place in which a wheel starts: nothing that is refused, but a host should
//! hear of it before it wonders at the forces.

use super::parameters::Side;

/// Something odd about the place in which a wheel starts.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum StartWarning {
    /// It stands beside all rails, at this y, or is on the other side of the track.
    BesideTheRails {
        /// Lateral position of the wheel marker [m].
        y: f64,
        /// Side of the track that the parameters name.
        side: Side,
    },
    /// It hangs far above the height of first touch.
    InTheAir {
        /// Height of the wheel marker [m].
        z: f64,
        /// Height at which the wheel would just touch [m].
        nominal: f64,
    },
    /// It is far below the height of first touch.
    InsideARail {
        /// Height of the wheel marker [m].
        z: f64,
        /// Height at which the wheel would just touch [m].
        nominal: f64,
    },
    /// Where it first touches it overlaps its rail at once: the force begins with a jump.
    BeginsAtOnce {
        /// By how much, vertically [m].
        overlap: f64,
    },
    /// Where it stands on rail 1 it overlaps rail 2 from the side.
    InRail2 {
        /// By how much [m].
        overlap: f64,
    },
}

impl StartWarning {
    /// The words for it; `prefix` stands before the names of variables of this wheel in a wheelset.
    pub fn message(&self, prefix: &str) -> String {
        let of = |name: &str| {
            if prefix.is_empty() { format!("wheel.{name}") } else { format!("wheelset.{name}") }
        };
        match *self {
            Self::BesideTheRails { y, side } => {
                let (side, sign) = match side {
                    Side::Right => ("right", "positive"),
                    Side::Left => ("left", "negative"),
                };
                format!(
                    "the wheel on the {side} side starts beside its rails, with its marker at y = {y} m: it carries nothing there; on this side y \
                     is {sign}, about half the gauge: set {}",
                    of("y")
                )
            }
            Self::InTheAir { z, nominal } | Self::InsideARail { z, nominal } => {
                let mm = 1e3 * (z - nominal).abs();
                let (place, what) = if z < nominal {
                    ("above", "it hangs in the air")
                } else {
                    ("below", "it is inside the rail")
                };
                format!(
                    "the wheel starts with its marker at z = {z} m, {mm:.1} mm {place} {prefix}nominal.wheel_z = {nominal:.6} m, where it would \
                     just touch: {what}; set {} from that height",
                    of("z")
                )
            }
            Self::BeginsAtOnce { overlap } => format!(
                "where the wheel first touches, at this yaw and roll, it overlaps its rail by {:.0} um at once: it comes over the side of the rail, and \
                 the force begins there with a jump; look at {} and {}",
                1e6 * overlap,
                of("yaw"),
                of("roll")
            ),
            Self::InRail2 { overlap } => format!(
                "where the wheel stands on {prefix}rail[1] it overlaps {prefix}rail[2] by {:.1} mm from the side: move it by {prefix}rail[2].position.y, which counts with {prefix}rail[2].placement = position",
                1e3 * overlap
            ),
        }
    }
}
