//! Primary suspension: springs and dampers between the axle boxes and a frame.
//!
//! The frame runs straight ahead at the speed of the wheelset and keeps to the track's centre line,
//! as a heavy bogie frame does on average; it does not turn. Axle boxes stand outside the wheels.

use super::body::{GeneralizedForce, State};
use super::track::Lateral;

/// Springs and dampers of the two axle boxes together with the load they carry.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Suspension {
    /// Half the distance of the axle boxes [m].
    pub half_distance: f64,
    /// Stiffness of one axle box along x, y, z [N/m].
    pub stiffness: [f64; 3],
    /// Damping of one axle box along x, y, z [N s/m].
    pub damping: [f64; 3],
    /// Static vertical force of both axle boxes on the wheelset [N].
    pub load: f64,
    /// Height of the wheelset at which the springs carry just the load [m].
    pub resting_z: f64,
}

impl Suspension {
    /// Force on the wheelset at `state`, the track's centre line being at `track`, at `speed`
    /// [m/s].
    pub fn force(&self, state: &State, track: Lateral, speed: f64) -> GeneralizedForce {
        let [cx, cy, cz] = self.stiffness.map(|one| 2.0 * one);
        let [dx, dy, dz] = self.damping.map(|one| 2.0 * one);
        let arm = self.half_distance * self.half_distance;
        GeneralizedForce {
            y: -cy * (state.y - track.position) - dy * (state.vy - track.slope * speed),
            z: self.load - cz * (state.z - self.resting_z) - dz * state.vz,
            roll: -arm * (cz * state.roll + dz * state.roll_rate),
            yaw: -arm * (cx * state.yaw + dx * state.yaw_rate),
            pitch: 0.0,
        }
    }
}
