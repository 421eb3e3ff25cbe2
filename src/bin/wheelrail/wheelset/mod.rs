//! A wheelset as a rigid body on two contact elements, held by its primary suspension.
//!
//! Degrees of freedom are y, z, roll, yaw and pitch of the centre in the track frame; the speed
//! along the track is held. The equations of the symmetric rigid body are exact for R = `R_x(roll)`
//! `R_z(yaw)` `R_y(pitch)`; the springs and dampers of the suspension are linear in the angles.

pub mod body;
pub mod equilibrium;
pub mod options;
pub mod oscillation;
pub mod record;
mod step_limit;
pub mod suspension;
pub mod track;

#[cfg(test)]
mod conical_wheel;

use anyhow::Result;
use nalgebra::Vector3;
use wheelrail::element::input::{RailMotion, WheelMotion};
use wheelrail::element::output::Wrench;

use body::{Body, GeneralizedForce, State};
use suspension::Suspension;
use track::Track;

/// Acceleration of free fall, EN 14363 and ISO 80000-3 [m/s²].
pub const GRAVITY: f64 = 9.806_65;

/// What a contact element is told.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WheelInput {
    /// Motion of the wheel.
    pub wheel: WheelMotion,
    /// Motion of the rail under it.
    pub rail: RailMotion,
    /// Station along the track [m].
    pub station: f64,
}

/// When a contact element is asked.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Moment {
    /// Before the run, as often as needed.
    Initialization,
    /// At the start `time` [s] of a step of length `step` [s], once.
    Step {
        /// Start of the step [s].
        time: f64,
        /// Length of the step [s].
        step: f64,
    },
}

/// A contact element: one wheel on its rail.
pub trait Wheel {
    /// Force on the wheel and moment about its marker, in the track frame.
    fn wrench(&mut self, input: &WheelInput, moment: Moment) -> Result<Wrench>;
}

/// The wheelset on the track.
#[derive(Debug)]
pub struct Wheelset<W> {
    /// Inertia and size.
    pub body: Body,
    /// Springs and dampers at the axle boxes.
    pub suspension: Suspension,
    /// Course of the track.
    pub track: Track,
    /// Speed along the track, > 0 [m/s].
    pub speed: f64,
    /// The contact elements, right one first.
    pub wheels: [W; 2],
    /// What the wheels last answered.
    pub wrenches: [Wrench; 2],
}

impl<W: Wheel> Wheelset<W> {
    /// Inputs of the wheel on the side of `sign` (right +1, left -1).
    fn wheel_input(&self, state: &State, sign: f64) -> WheelInput {
        let lateral = self.track.lateral(state.distance);
        WheelInput {
            wheel: self.body.wheel_motion(state, self.speed, sign),
            // The rails lie still and only run askew: where the next wheel position finds them is
            // not where they move to, so their velocity is zero. (With the velocity of the ramp as
            // seen from the wheel, friction would drag the wheelset along with the track.)
            rail: RailMotion { y: lateral.position, ..RailMotion::default() },
            station: state.distance,
        }
    }

    /// Force of wheels, suspension and weight on each degree of freedom.
    pub fn force(&mut self, state: &State, moment: Moment) -> Result<GeneralizedForce> {
        let axes = self.body.axes(state);
        let mut force =
            self.suspension.force(state, self.track.lateral(state.distance), self.speed);
        force.z += self.body.mass * GRAVITY;
        for (index, sign) in [1.0, -1.0].into_iter().enumerate() {
            let input = self.wheel_input(state, sign);
            let wrench = self.wheels[index].wrench(&input, moment)?;
            self.wrenches[index] = wrench;
            let arm = axes.axle * (sign * self.body.half_marker_distance);
            let on_centre = Vector3::from(wrench.moment) + arm.cross(&Vector3::from(wrench.force));
            force.y += wrench.force[1];
            force.z += wrench.force[2];
            force.roll += on_centre.dot(&axes.roll);
            force.yaw += on_centre.dot(&axes.yaw);
            force.pitch += on_centre.dot(&axes.axle);
        }
        Ok(force)
    }

    /// Moves `state` from `time` over `step` [s] by the semi-implicit Euler method: forces at the
    /// start of the step give the new velocities, these the new positions.
    pub fn advance(&mut self, state: &mut State, time: f64, step: f64) -> Result<()> {
        let force = self.force(state, Moment::Step { time, step })?;
        self.body.advance(state, &force, self.speed, step);
        Ok(())
    }
}
