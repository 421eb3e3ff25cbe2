//! What an evaluation depends on besides the parameters.

use super::parameters::RAILS;
use crate::error::ContactError;
use crate::math::real::Real;
pub use crate::kinematics::motion::{RailMotion, WheelMotion};

/// All inputs; one field for each FMU input of design section 3.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Input<T = f64> {
    /// The wheel.
    pub wheel: WheelMotion<T>,
    /// Vertical force of the wheel on all rails together, down, if the load is given and not the height; a wheel with none or a
    /// negative one is lifted [N].
    pub wheel_load: T,
    /// The rails, `rail[1]` first.
    pub rails: [RailMotion<T>; RAILS],
    /// Station along the track [m].
    pub track_s: T,
    /// Coefficient of friction, ≥ 0 [-].
    pub friction: T,
}

impl Default for Input {
    /// The nominal position of a right wheel, just lifted, at rest.
    fn default() -> Self {
        Self {
            wheel: WheelMotion {
                position: [0.0, 0.75, -0.46],
                roll: 0.0,
                yaw: 0.0,
                pitch: 0.0,
                velocity: [0.0; 3],
                roll_rate: 0.0,
                yaw_rate: 0.0,
                pitch_rate: 0.0,
            },
            wheel_load: 0.0,
            rails: [RailMotion::default(); RAILS],
            track_s: 0.0,
            friction: 0.3,
        }
    }
}

impl<T: Real> Input<T> {
    /// The same situation seen in a mirror along the track: a left wheel as a right one and the reverse.
    #[must_use]
    pub(crate) fn mirrored(&self) -> Self {
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

impl Input {
    /// Every input with its FMU name.
    fn named(&self) -> impl Iterator<Item = (&'static str, Option<usize>, f64)> {
        let w = &self.wheel;
        let rails = self.rails;
        [
            ("wheel.x", w.position[0]),
            ("wheel.y", w.position[1]),
            ("wheel.z", w.position[2]),
            ("wheel.roll", w.roll),
            ("wheel.yaw", w.yaw),
            ("wheel.pitch", w.pitch),
            ("wheel.vx", w.velocity[0]),
            ("wheel.vy", w.velocity[1]),
            ("wheel.vz", w.velocity[2]),
            ("wheel.roll_rate", w.roll_rate),
            ("wheel.yaw_rate", w.yaw_rate),
            ("wheel.pitch_rate", w.pitch_rate),
            ("wheel.load", self.wheel_load),
            ("track.s", self.track_s),
            ("friction.coefficient", self.friction),
        ]
        .into_iter()
        .map(|(name, value)| (name, None, value))
        .chain(rails.into_iter().enumerate().flat_map(|(k, rail)| {
            [
                ("y", rail.y),
                ("z", rail.z),
                ("roll", rail.roll),
                ("vy", rail.vy),
                ("vz", rail.vz),
                ("roll_rate", rail.roll_rate),
            ]
            .map(|(name, value)| (name, Some(k + 1), value))
        }))
    }

    /// Whether every input is finite and friction is not negative.
    ///
    /// # Errors
    /// The first input at fault, by its FMU name.
    pub fn check(&self) -> Result<(), ContactError> {
        // At every evaluation this runs; the names are only looked up when there is one to report.
        let w = &self.wheel;
        let wheel = [
            w.position,
            w.velocity,
            [w.roll, w.yaw, w.pitch],
            [w.roll_rate, w.yaw_rate, w.pitch_rate],
        ];
        let rails = self.rails.map(|r| [r.y, r.z, r.roll, r.vy, r.vz, r.roll_rate]);
        let all = wheel.as_flattened().iter().chain(rails.as_flattened());
        // Zero times anything that is not finite is not a number.
        let sum: f64 = all.map(|value| 0.0 * value).sum();
        if (sum + 0.0 * self.track_s + 0.0 * self.friction + 0.0 * self.wheel_load).is_nan() {
            return Err(self.not_finite());
        }
        if self.friction < 0.0 {
            let allowed = "a finite number, at least 0";
            return Err(ContactError::bad_value("friction.coefficient", self.friction, allowed));
        }
        Ok(())
    }

    /// The error for the first input that is not finite.
    #[cold]
    fn not_finite(&self) -> ContactError {
        let named = self.named().find(|(_, _, value)| !value.is_finite());
        let (name, rail, value) = named.unwrap_or(("input", None, f64::NAN));
        let name = rail.map_or(name.to_owned(), |k| format!("rail[{k}].{name}"));
        ContactError::bad_value(name, value, "a finite number")
    }
}
