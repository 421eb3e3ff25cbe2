//! What an evaluation depends on besides the parameters.

use super::parameters::{Mirror, RAILS};
use crate::defaults::with_defaults;
use crate::error::ContactError;
pub use crate::kinematics::motion::{RailMotion, WheelMotion};
use crate::math::numbers::{Numbers, numbers};
use crate::math::real::Real;
use crate::open::Open;

/// Greatest number that is told from a greater one, whatever its unit.
const MAX_NUMBER: f64 = 1e100;

with_defaults! {
    /// All inputs; one field for each FMU input of docs/fmi.md. A literal ends with
    /// `..Input::default()`, as there may be more of them in later versions. The default is the
    /// nominal position of a right wheel, just lifted, at rest. (The units and the command line
    /// start rolling and loaded.)
    #[derive(Clone, Copy, Debug, PartialEq)]
    pub struct Input<T = f64> {
        /// The wheel.
        pub wheel: WheelMotion<T> = WheelMotion {
            position: [0.0, 0.75, -0.46],
            roll: 0.0,
            yaw: 0.0,
            pitch: 0.0,
            velocity: [0.0; 3],
            roll_rate: 0.0,
            yaw_rate: 0.0,
            pitch_rate: 0.0,
        },
        /// Vertical force of the wheel on all rails together, down, if the load is given and not
        /// the height; a wheel with none or a negative one is lifted [N].
        pub wheel_load: T = 0.0,
        /// The rails, `rail[1]` first.
        pub rails: [RailMotion<T>; RAILS] = [RailMotion::default(); RAILS],
        /// Station along the track [m].
        pub track_s: T = 0.0,
        /// Coefficient of friction where it is the same everywhere, ≥ 0 [-].
        pub friction: T = 0.3,
        /// Coefficient of friction of the tread of the rails where they have regions, ≥ 0 [-].
        pub tread_friction: T = 0.3,
        /// Coefficient of friction of their gauge faces, ≥ 0 [-].
        pub gauge_face_friction: T = 0.3,
        #[doc(hidden)]
        pub open: Open = Open::default(),
    }
}

numbers!(
    Input: wheel, wheel_load, rails, track_s, friction, tread_friction, gauge_face_friction;
    kept open
);

impl<T: Real> Mirror for Input<T> {
    fn mirrored(&self) -> Self {
        let wheel = &self.wheel;
        let [x, y, z] = wheel.position;
        let [vx, vy, vz] = wheel.velocity;
        Self {
            wheel: WheelMotion {
                position: [x, -y, z],
                roll: -wheel.roll,
                yaw: -wheel.yaw,
                velocity: [vx, -vy, vz],
                roll_rate: -wheel.roll_rate,
                yaw_rate: -wheel.yaw_rate,
                ..*wheel
            },
            rails: self.rails.map(|rail| RailMotion {
                y: -rail.y,
                roll: -rail.roll,
                vy: -rail.vy,
                roll_rate: -rail.roll_rate,
                ..rail
            }),
            ..*self
        }
    }
}

impl<T: Real> Input<T> {
    /// All inputs, in the order of [`INPUT_NAMES`].
    #[doc(hidden)]
    pub fn to_array(&self) -> [T; INPUTS] {
        let mut copy = *self;
        copy.in_order().map(|number| *number)
    }

    /// The inputs of [`to_array`](Self::to_array).
    #[doc(hidden)]
    pub fn from_array(all: [T; INPUTS]) -> Self {
        let mut input = Self::at_rest();
        for (place, number) in input.in_order().into_iter().zip(all) {
            *place = number;
        }
        input
    }

    /// The numbers, in the order of [`INPUT_NAMES`].
    #[rustfmt::skip]
    fn in_order(&mut self) -> [&mut T; INPUTS] {
        // By name, so that a further input is not left out here without a word.
        let Self {
            wheel: w, wheel_load, rails: [r, s],
            track_s, friction, tread_friction, gauge_face_friction, open: _,
        } = self;
        let ([x, y, z], [vx, vy, vz]) = (&mut w.position, &mut w.velocity);
        [
            x, y, z, &mut w.roll, &mut w.yaw, &mut w.pitch,
            vx, vy, vz, &mut w.roll_rate, &mut w.yaw_rate, &mut w.pitch_rate,
            &mut r.y, &mut r.z, &mut r.roll, &mut r.vy, &mut r.vz, &mut r.roll_rate,
            &mut s.y, &mut s.z, &mut s.roll, &mut s.vy, &mut s.vz, &mut s.roll_rate,
            track_s, friction, wheel_load, tread_friction, gauge_face_friction,
            &mut r.pitch_rate, &mut s.pitch_rate,
        ]
    }

    /// All numbers zero: no rates.
    pub fn at_rest() -> Self {
        Input::default().each(&mut |_| T::from(0.0))
    }

    /// The values without derivatives.
    pub fn value(&self) -> Input {
        self.each(&mut Real::value)
    }
}

/// Number of inputs.
#[doc(hidden)]
pub const INPUTS: usize = 31;

/// FMU names of the inputs, in the order of the columns of a
/// [`jacobian`](super::Element::jacobian).
pub const INPUT_NAMES: &[&str] = &NAMES;

#[rustfmt::skip]
const NAMES: [&str; INPUTS] = [
    "wheel.x", "wheel.y", "wheel.z", "wheel.roll", "wheel.yaw", "wheel.pitch",
    "wheel.vx", "wheel.vy", "wheel.vz", "wheel.roll_rate", "wheel.yaw_rate", "wheel.pitch_rate",
    "rail[1].y", "rail[1].z", "rail[1].roll", "rail[1].vy", "rail[1].vz", "rail[1].roll_rate",
    "rail[2].y", "rail[2].z", "rail[2].roll", "rail[2].vy", "rail[2].vz", "rail[2].roll_rate",
    "track.s", "friction.coefficient", "wheel.load",
    "friction.tread.coefficient", "friction.gauge_face.coefficient",
    "rail[1].pitch_rate", "rail[2].pitch_rate",
];

/// Moves all rails of an array of inputs, or of their rates, by `way`; `first` is the place of the
/// component of rail 1.
pub(super) fn move_all(numbers: &mut [f64; INPUTS], first: usize, way: f64) {
    numbers[first] += way;
    numbers[first + RAIL] += way;
}

/// Places of height and load among the inputs.
pub(super) const HEIGHT: usize = 2;
pub(super) const LOAD: usize = 26;
/// Places among the inputs: lateral and vertical coordinate of rail 1, its velocities, and how far
/// behind it rail 2 is.
pub(super) const PLACES: [usize; 2] = [12, 13];
pub(super) const VELOCITIES: [usize; 2] = [15, 16];
const RAIL: usize = 6;

impl Input {
    /// The same with all rails of the side moved.
    pub(super) fn with_rails_moved(&self, deflection: [f64; 2], velocity: [f64; 2]) -> Self {
        let mut moved = *self;
        for rail in &mut moved.rails {
            (rail.y, rail.z) = (rail.y + deflection[0], rail.z + deflection[1]);
            (rail.vy, rail.vz) = (rail.vy + velocity[0], rail.vz + velocity[1]);
        }
        moved
    }

    /// Whether every input is finite and friction is not negative.
    ///
    /// # Errors
    /// The first input at fault, by its FMU name.
    pub fn check(&self) -> Result<(), ContactError> {
        self.admitted().map(|_| ())
    }

    /// The input as it is evaluated: numbers beyond [`MAX_NUMBER`] are taken as that, so that no
    /// product of them is infinite.
    ///
    /// # Errors
    /// As [`check`](Self::check).
    pub(crate) fn admitted(&self) -> Result<Self, ContactError> {
        // At every evaluation this runs; the names are only looked up when there is one to report.
        let mut sum = 0.0;
        self.each(&mut |value| sum += value.abs());
        // Nothing compares with what is not a number.
        let admitted = if sum <= MAX_NUMBER { *self } else { self.bounded()? };
        if self.friction.min(self.tread_friction).min(self.gauge_face_friction) < 0.0 {
            return Err(self.negative_friction());
        }
        Ok(admitted)
    }

    /// The error for the first coefficient of friction that is negative.
    #[cold]
    fn negative_friction(&self) -> ContactError {
        let all = [
            ("friction.coefficient", self.friction),
            ("friction.tread.coefficient", self.tread_friction),
            ("friction.gauge_face.coefficient", self.gauge_face_friction),
        ];
        let [.., last] = all;
        let (name, value) = all.into_iter().find(|(_, value)| *value < 0.0).unwrap_or(last);
        ContactError::bad_value(name, value, "a finite number, at least 0")
    }

    /// The same with every number within [`MAX_NUMBER`].
    ///
    /// # Errors
    /// The first input that is not finite.
    #[cold]
    fn bounded(&self) -> Result<Self, ContactError> {
        let all = self.to_array();
        if all.iter().any(|value| !value.is_finite()) {
            return Err(self.not_finite());
        }
        Ok(Self::from_array(all.map(|value| value.clamp(-MAX_NUMBER, MAX_NUMBER))))
    }

    /// The error for the first input that is not finite.
    #[cold]
    fn not_finite(&self) -> ContactError {
        let all = self.to_array();
        let place = all.iter().position(|value| !value.is_finite());
        let (name, value) = place.map_or(("input", f64::NAN), |i| (INPUT_NAMES[i], all[i]));
        ContactError::bad_value(name, value, "a finite number")
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_places_among_the_inputs_are_those_of_the_rails() {
        let moved = Input::default().with_rails_moved([1e-3, 2e-3], [3e-3, 4e-3]);
        let mut numbers = Input::default().to_array();
        for (place, way) in PLACES.into_iter().chain(VELOCITIES).zip([1e-3, 2e-3, 3e-3, 4e-3]) {
            move_all(&mut numbers, place, way);
        }
        for (number, moved) in numbers.into_iter().zip(moved.to_array()) {
            assert_eq!(number.to_bits(), moved.to_bits());
        }
    }
}
