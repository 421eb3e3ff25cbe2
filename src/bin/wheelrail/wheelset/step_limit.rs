//! How long a step may be, from the contact's own stiffness and damping.
//!
//! A contact force held over a step h puts the energy of a stiffness k h/2 of negative damping into
//! the motion, which the damping c of the contact must cover: h ≤ 2 c/k. Creep forces act as
//! dampers of rate λ = (∂F/∂v)/m, which an explicit step follows stably for h ≤ 2/λ.

use anyhow::Result;

use super::body::State;
use super::{Moment, Wheel, Wheelset};

/// Stiffness, damping and rates of the contact at one state, and the limits that follow.
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
    /// Longest step by the normal contact, 2 c/k [s].
    #[must_use]
    pub fn normal(&self) -> f64 {
        2.0 * self.damping / self.stiffness
    }

    /// Longest step by the creep forces, 2/λ [s]; infinite without creep forces.
    #[must_use]
    pub fn creep(&self) -> f64 {
        2.0 / self.creep_rate
    }

    /// The shorter of both [s].
    #[must_use]
    pub fn longest(&self) -> f64 {
        self.normal().min(self.creep())
    }

    /// A round step (1, 2 or 5 times a power of ten) of at most half the limit [s].
    #[must_use]
    pub fn proposal(&self) -> f64 {
        let half = 0.5 * self.longest();
        let decade = 10f64.powf(half.log10().floor());
        decade * [5.0, 2.0, 1.0].into_iter().find(|m| m * decade <= half).unwrap_or(0.5)
    }
}

impl<W: Wheel> Wheelset<W> {
    /// Measures the limits at `state` by differences of the forces; the wheels must touch.
    ///
    /// # Errors
    /// If a contact element refuses its input.
    pub fn step_limit(&mut self, state: &State) -> Result<StepLimit> {
        let (dz, dvz) = (1e-8, 1e-5);
        let creepage = 1e-7;
        let sideways = creepage * self.speed;
        let turn = creepage * self.speed / self.body.half_marker_distance;
        let spin = creepage * state.pitch_rate;
        let moment = Moment::Initialization;

        let force = self.force(state, moment)?;
        let wheel = self.wrenches[0].force[2];
        self.force(&State { z: state.z + dz, ..*state }, moment)?;
        let stiffness = (wheel - self.wrenches[0].force[2]) / dz;
        self.force(&State { vz: state.vz + dvz, ..*state }, moment)?;
        let damping = (wheel - self.wrenches[0].force[2]) / dvz;
        let beside = self.force(&State { vy: state.vy + sideways, ..*state }, moment)?;
        let lateral = (force.y - beside.y) / (sideways * self.body.mass);
        let beside = self.force(&State { yaw_rate: state.yaw_rate + turn, ..*state }, moment)?;
        let yaw = (force.yaw - beside.yaw) / (turn * self.body.inertia);
        let beside =
            self.force(&State { pitch_rate: state.pitch_rate + spin, ..*state }, moment)?;
        let pitch = (force.pitch - beside.pitch) / (spin * self.body.axle_inertia);
        Ok(StepLimit { stiffness, damping, creep_rate: lateral.max(yaw).max(pitch).max(0.0) })
    }
}

#[cfg(test)]
mod tests {
    use super::super::conical_wheel::wheelset;
    use super::*;

    #[test]
    fn stiffness_damping_and_rates_of_a_known_contact_are_found() {
        let mut wheelset = wheelset(15.0, 0.05);
        let state = wheelset.find_equilibrium([-0.46; 2]).unwrap();
        let limit = wheelset.step_limit(&state).unwrap();
        let wheel = wheelset.wheels[0];
        approx::assert_relative_eq!(limit.stiffness, wheel.stiffness, max_relative = 1e-4);
        approx::assert_relative_eq!(limit.damping, wheel.damping, max_relative = 1e-4);
        let pitch = 2.0 * wheel.creep_coefficient * 0.46 * 0.46 / 15.0 / 100.0;
        approx::assert_relative_eq!(limit.creep_rate, pitch, max_relative = 1e-3);
    }

    #[test]
    fn proposals_are_round_and_leave_half_of_the_limit() {
        let limit = |damping| StepLimit { stiffness: 1e9, damping, creep_rate: 1.0 };
        approx::assert_relative_eq!(limit(1e5).proposal(), 1e-4, max_relative = 1e-12);
        approx::assert_relative_eq!(limit(0.9e5).proposal(), 5e-5, max_relative = 1e-12);
        approx::assert_relative_eq!(limit(0.45e5).proposal(), 2e-5, max_relative = 1e-12);
    }
}
