//! What an evaluation depends on besides the parameters.

use super::parameters::RAILS;
use crate::error::ContactError;
pub use crate::kinematics::motion::{RailMotion, WheelMotion};

/// Greatest number that is told from a greater one, whatever its unit.
const MOST: f64 = 1e100;

/// All inputs; one field for each FMU input of design section 3.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Input {
    /// The wheel.
    pub wheel: WheelMotion,
    /// Vertical force of the wheel on all rails together, down, if the load is given and not the height; a wheel with none or a
    /// negative one is lifted [N].
    pub wheel_load: f64,
    /// The rails, `rail[1]` first.
    pub rails: [RailMotion; RAILS],
    /// Station along the track [m].
    pub track_s: f64,
    /// Coefficient of friction, ≥ 0 [-].
    pub friction: f64,
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

impl Input {
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
        self.admitted().map(|_| ())
    }

    /// The input as it is evaluated: numbers beyond [`MOST`] are taken as that, so that no product of them is infinite.
    ///
    /// # Errors
    /// As [`check`](Self::check).
    pub(crate) fn admitted(&self) -> Result<Self, ContactError> {
        // At every evaluation this runs; the names are only looked up when there is one to report.
        let w = &self.wheel;
        let wheel = [
            w.position,
            w.velocity,
            [w.roll, w.yaw, w.pitch],
            [w.roll_rate, w.yaw_rate, w.pitch_rate],
        ];
        let rails = self.rails.map(|r| [r.y, r.z, r.roll, r.vy, r.vz, r.roll_rate]);
        let others = [self.track_s, self.friction, self.wheel_load];
        let all = wheel.as_flattened().iter().chain(rails.as_flattened()).chain(&others);
        let sum: f64 = all.map(|value| value.abs()).sum();
        // Nothing compares with what is not a number.
        let admitted = if sum <= MOST { *self } else { self.bounded()? };
        if self.friction < 0.0 {
            let allowed = "a finite number, at least 0";
            return Err(ContactError::bad_value("friction.coefficient", self.friction, allowed));
        }
        Ok(admitted)
    }

    /// The same with every number within [`MOST`].
    ///
    /// # Errors
    /// The first input that is not finite.
    #[cold]
    fn bounded(&self) -> Result<Self, ContactError> {
        if self.named().any(|(_, _, value)| !value.is_finite()) {
            return Err(self.not_finite());
        }
        let within = |value: f64| value.clamp(-MOST, MOST);
        let w = &self.wheel;
        Ok(Self {
            wheel: WheelMotion {
                position: w.position.map(within),
                roll: within(w.roll),
                yaw: within(w.yaw),
                pitch: within(w.pitch),
                velocity: w.velocity.map(within),
                roll_rate: within(w.roll_rate),
                yaw_rate: within(w.yaw_rate),
                pitch_rate: within(w.pitch_rate),
            },
            wheel_load: within(self.wheel_load),
            rails: self.rails.map(|r| RailMotion {
                y: within(r.y),
                z: within(r.z),
                roll: within(r.roll),
                vy: within(r.vy),
                vz: within(r.vz),
                roll_rate: within(r.roll_rate),
            }),
            track_s: within(self.track_s),
            friction: within(self.friction),
        })
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
