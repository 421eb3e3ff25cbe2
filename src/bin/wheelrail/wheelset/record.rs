//! What is kept of a run of a wheelset.

use wheelrail::element::output::Wrench;

use super::body::State;

/// Names of the wheels in the order of the simulation.
pub const SIDES: [&str; 2] = ["right", "left"];

/// The run at one moment.
#[derive(Clone, Debug)]
pub struct Record {
    /// Time [s].
    pub time: f64,
    /// Lateral position of the track's centre line [m].
    pub track_y: f64,
    /// Motion of the wheelset.
    pub state: State,
    /// Forces on the wheels and moments about their markers, right one first.
    pub wrenches: [Wrench; 2],
    /// Patches of the wheels, right one first.
    pub patches: [Vec<Patch>; 2],
}

/// One patch as the history and the figures show it.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Patch {
    /// Number of the rail, from 1.
    pub rail: i32,
    /// Normal force [N].
    pub normal_force: f64,
    /// Contact angle [rad].
    pub contact_angle: f64,
    /// Lateral position on the rail profile [m].
    pub rail_y: f64,
    /// Lateral position on the wheel profile [m].
    pub wheel_y: f64,
    /// Extent across [m].
    pub width: f64,
    /// Lateral position in the track frame [m].
    pub position_y: f64,
    /// Distance of the contact point from the axle [m].
    pub rolling_radius: f64,
    /// Greatest pressure [Pa].
    pub max_pressure: f64,
}
