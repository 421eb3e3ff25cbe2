//! How long a step may be: slopes of the contact at a state of the wheelset.

use anyhow::Result;
use wheelrail::element::{Inertia, StepLimit};

use super::body::State;
use super::{Moment, Wheel, Wheelset};

impl<W: Wheel> Wheelset<W> {
    /// Measures the limits at `state` by differences of the forces; the wheels must touch.
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
        let lateral = (force.y - beside.y) / sideways;
        let beside = self.force(&State { yaw_rate: state.yaw_rate + turn, ..*state }, moment)?;
        let yaw = (force.yaw - beside.yaw) / turn;
        let beside =
            self.force(&State { pitch_rate: state.pitch_rate + spin, ..*state }, moment)?;
        let pitch = (force.pitch - beside.pitch) / spin;
        let inertia = Inertia {
            mass: self.body.mass,
            transverse: self.body.inertia,
            axle: self.body.axle_inertia,
        };
        let creep_rate = inertia.fastest_rate([lateral, yaw, pitch]);
        Ok(StepLimit { stiffness, damping, creep_rate })
    }
}

#[cfg(test)]
mod tests {
    use super::super::conical_wheel::wheelset;

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
}
