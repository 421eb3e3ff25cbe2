//! Forces on the wheels, brought from the frames of their rails to that of the track and to the
//! centre of the wheelset.

use nalgebra::Vector3;

use super::rail_frame::RailFrame;
use crate::element::input::WheelMotion;
use crate::element::output::{Output, Wrench};
use crate::math::real::Real;

/// Adds to `total`, which is about the centre with that `motion`, a force on the body and its
/// moment about the point of the axle `along` [m] to the right of there.
pub fn add<T: Real>(
    total: &mut Wrench<T>,
    motion: &WheelMotion<T>,
    along: f64,
    wrench: &Wrench<T>,
) {
    let force = Vector3::from(wrench.force);
    let moment = Vector3::from(wrench.moment) + (motion.axle() * T::from(along)).cross(&force);
    for i in 0..3 {
        total.force[i] += force[i];
        total.moment[i] += moment[i];
    }
}

/// Brings the vectors, places and heights of an output from the `frame` of the rails of a side to
/// that of the track. The wheel marker is at the height `z` in the latter and `within` in the
/// former; contact angles and creepages stay those against the rails.
pub fn bring_out<T: Real>(frame: &RailFrame<T>, [z, within]: [T; 2], output: &mut Output<T>) {
    output.wheel = frame.wrench(&output.wheel);
    for rail in &mut output.rails {
        *rail = frame.wrench(rail);
    }
    output.wheel_z = frame.height(z, [within, output.wheel_z]);
    for patch in output.patches.iter_mut().filter(|patch| patch.rail > 0) {
        patch.position = frame.place(patch.position);
    }
}
