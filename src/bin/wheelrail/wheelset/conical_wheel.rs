//! A cone on the edge of a knife with linear creep forces, against which the dynamics are tested.

use anyhow::Result;
use nalgebra::Vector3;
use wheelrail::element::output::Wrench;

use super::body::Body;
use super::suspension::Suspension;
use super::track::{RampShape, Track};
use super::{Moment, Wheel, WheelInput, Wheelset};

/// Radius where the cone rests on the edge when centred [m].
const RADIUS: f64 = 0.46;

/// The wheel; the side follows from the sign of its lateral position.
#[derive(Clone, Copy, Debug)]
pub struct ConicalWheel {
    pub slope: f64,
    pub stiffness: f64,
    pub damping: f64,
    pub creep_coefficient: f64,
}

impl Wheel for ConicalWheel {
    fn wrench(&mut self, input: &WheelInput, _moment: Moment) -> Result<Wrench> {
        let wheel = &input.wheel;
        let side = wheel.position[1].signum();
        let outward = side * (side * 0.75 + input.rail.y - wheel.position[1]);
        // The edge in the rolled wheel's own profile.
        let radius = RADIUS - self.slope * (outward + side * wheel.roll * RADIUS);
        let arm = Vector3::new(0.0, side * outward, radius);
        let axle = Vector3::new(-wheel.yaw, 1.0, wheel.roll);
        let turning = Vector3::new(wheel.roll_rate, 0.0, wheel.yaw_rate) + axle * wheel.pitch_rate;
        let velocity = Vector3::from(wheel.velocity) + turning.cross(&arm);
        let penetration = wheel.position[2] + radius + side * wheel.roll * outward;
        let normal = self.stiffness * penetration + self.damping * velocity.z;
        if penetration <= 0.0 || normal <= 0.0 {
            return Ok(Wrench::default());
        }
        let creepage = |v: f64| v / wheel.velocity[0];
        let lateral = velocity.y - input.rail.vy;
        let force = Vector3::new(
            -self.creep_coefficient * creepage(velocity.x),
            -self.creep_coefficient * creepage(lateral),
            -normal,
        );
        Ok(Wrench { force: force.into(), moment: arm.cross(&force).into() })
    }
}

/// A wheelset without suspension stiffness on such wheels, 100 kN on the rails.
pub fn wheelset(speed: f64, slope: f64) -> Wheelset<ConicalWheel> {
    let wheel = ConicalWheel { slope, stiffness: 1e9, damping: 2e5, creep_coefficient: 1e7 };
    Wheelset {
        body: Body {
            mass: 1500.0,
            inertia: 900.0,
            axle_inertia: 100.0,
            half_marker_distance: 0.75,
        },
        suspension: Suspension {
            half_distance: 1.0,
            stiffness: [0.0; 3],
            damping: [0.0; 3],
            load: 85e3,
            resting_z: 0.0,
        },
        track: Track { ramp_start: 1.0, ramp_length: 1.0, ramp: 0.002, shape: RampShape::Linear },
        speed,
        wheels: [wheel; 2],
        wrenches: [Wrench::default(); 2],
    }
}

#[cfg(test)]
mod tests {
    use super::super::body::State;
    use super::*;

    #[test]
    fn a_wheelset_displaced_to_the_right_is_steered_to_the_left() {
        let mut wheelset = wheelset(15.0, 0.05);
        let state = wheelset.find_equilibrium([-RADIUS; 2]).unwrap();
        let displaced = State { y: 0.003, ..state };
        let force = wheelset.force(&displaced, Moment::Initialization).unwrap();
        assert!(force.yaw < 0.0, "{force:?}");
        // Nose to the right: the wheels pull to the right.
        let yawed = State { yaw: 0.001, ..state };
        assert!(wheelset.force(&yawed, Moment::Initialization).unwrap().y > 0.0);
    }
}
