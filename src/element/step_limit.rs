//! How long a step may be over which a host holds the forces, from the slopes of the contact.
//!
//! A contact force held over a step h puts the energy of a stiffness k h/2 of negative damping into
//! the motion, which the damping c of the contact must cover: h ≤ 2 c/k. Creep forces act as
//! dampers of rate λ = (∂F/∂v)/m, which an explicit step follows stably for h ≤ 2/λ.

use super::stiffness::ContactSlopes;
use crate::defaults::with_defaults;

with_defaults! {
    /// Inertia of a wheelset, a body of revolution about its axle; by default of one of medium
    /// weight.
    #[derive(Clone, Copy, Debug, PartialEq)]
    pub struct Inertia {
        /// Mass [kg].
        pub mass: f64 = 1500.0,
        /// Moment of inertia about any axis through the centre normal to the axle [kg m²].
        pub transverse: f64 = 900.0,
        /// Moment of inertia about the axle [kg m²].
        pub axle: f64 = 100.0,
    }
}

impl Inertia {
    /// Fastest rate at which creep forces damp a wheelset [1/s], from how much they damp its
    /// lateral motion [N s/m], its yaw and its rotation about the axle [N m s].
    pub fn fastest_rate(&self, [lateral, yaw, pitch]: [f64; 3]) -> f64 {
        (lateral / self.mass).max(yaw / self.transverse).max(pitch / self.axle).max(0.0)
    }
}

/// Stiffness, damping and rates of the contact at one state, and the limits that follow.
///
/// ```
/// use wheelrail::element::{Element, Inertia, Input, Parameters, StepLimit};
///
/// let mut input = Input::default();
/// let mut element = Element::new(&Parameters::default(), &input, &[])?;
/// input.wheel.position[2] = element.nominal_wheel_z() + 1e-4;
/// (input.wheel.velocity[0], input.wheel.pitch_rate) = (20.0, -20.0 / 0.46);
/// // A wheelset with two such wheels, 0.75 m from its centre.
/// let slopes = element.contact_slopes(&input, 0.75)?;
/// let limit = StepLimit::of(&[slopes; 2], &Inertia::default());
/// assert!(limit.normal() > 1e-4 && limit.longest() == limit.normal());
/// # Ok::<(), wheelrail::error::ContactError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StepLimit {
    /// Vertical stiffness of one contact [N/m].
    pub stiffness: f64,
    /// Vertical damping of one contact [N s/m].
    pub damping: f64,
    /// Fastest rate at which creep forces damp lateral, yaw or pitch motion [1/s].
    pub creep_rate: f64,
}

impl StepLimit {
    /// Of a wheelset of that `inertia`, from the slopes of its wheels; stiffness and damping are
    /// those of the wheel whose normal contact has the shorter limit.
    pub fn of(wheels: &[ContactSlopes], inertia: &Inertia) -> Self {
        let sum = |slope: fn(&ContactSlopes) -> f64| wheels.iter().map(slope).sum::<f64>();
        let creep_rate = inertia.fastest_rate([
            sum(|one| one.lateral),
            sum(|one| one.yaw),
            sum(|one| one.pitch),
        ]);
        let limits = wheels.iter().map(|wheel| Self {
            stiffness: wheel.stiffness,
            damping: wheel.damping,
            creep_rate,
        });
        let free = Self { stiffness: 0.0, damping: 0.0, creep_rate };
        limits.min_by(|a, b| a.normal().total_cmp(&b.normal())).unwrap_or(free)
    }

    /// Longest step by the normal contact, 2 c/k [s]; infinite without contact.
    pub fn normal(&self) -> f64 {
        if self.stiffness > 0.0 {
            2.0 * self.damping.max(0.0) / self.stiffness
        } else {
            f64::INFINITY
        }
    }

    /// Longest step by the creep forces, 2/λ [s]; infinite without creep forces.
    pub fn creep(&self) -> f64 {
        2.0 / self.creep_rate
    }

    /// The shorter of both [s].
    pub fn longest(&self) -> f64 {
        self.normal().min(self.creep())
    }

    /// A round step (1, 2 or 5 times a power of ten) of at most half the limit [s].
    pub fn proposal(&self) -> f64 {
        let half = 0.5 * self.longest();
        let decade = 10f64.powf(half.log10().floor());
        decade * [5.0, 2.0, 1.0].into_iter().find(|m| m * decade <= half).unwrap_or(0.5)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_softer_damped_wheel_and_the_fastest_motion_limit_the_step() {
        let wheel = |damping: f64| ContactSlopes {
            stiffness: 1e9,
            damping,
            lateral: 3e5,
            yaw: 1e5,
            pitch: 4e4,
        };
        let limit = StepLimit::of(&[wheel(1e5), wheel(6e4)], &Inertia::default());
        approx::assert_relative_eq!(limit.normal(), 1.2e-4, max_relative = 1e-12);
        approx::assert_relative_eq!(limit.creep_rate, 800.0, max_relative = 1e-12);
        approx::assert_relative_eq!(limit.creep(), 2.5e-3, max_relative = 1e-12);
        let air = StepLimit::of(&[ContactSlopes::default(); 2], &Inertia::default());
        assert!(air.longest() == f64::INFINITY);
    }

    #[test]
    fn proposals_are_round_and_leave_half_of_the_limit() {
        let limit = |damping| StepLimit { stiffness: 1e9, damping, creep_rate: 1.0 };
        approx::assert_relative_eq!(limit(1e5).proposal(), 1e-4, max_relative = 1e-12);
        approx::assert_relative_eq!(limit(0.9e5).proposal(), 5e-5, max_relative = 1e-12);
        approx::assert_relative_eq!(limit(0.45e5).proposal(), 2e-5, max_relative = 1e-12);
    }
}
