//! Derivatives of a number by inputs, parameters and profiles.

use super::input::{INPUTS, Input};
use super::parameters::{Parameters, RAILS};
use crate::material::{Material, MaterialPair};

/// Derivatives of a weighted sum of the outputs by all that it depends on, each in the unit of the
/// sum over that of what it is by.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Gradient {
    /// By the inputs.
    pub input: Input,
    /// By the parameters that are real numbers.
    pub parameters: ParameterSlopes,
    /// By normal displacements of the points of the wheel's profile, out of the wheel, as
    /// [`Profile::displaced`](crate::geometry::profile::Profile::displaced) takes them [1/m].
    pub wheel_points: Vec<f64>,
    /// The same of each rail, out of the rail; none of rails that are not there, that are rollers,
    /// or whose section varies along the track. The parameters of rails go by the profile as it
    /// is placed anew, and friction by place stays where it is [1/m].
    pub rail_points: [Vec<f64>; RAILS],
}

impl Default for Gradient {
    fn default() -> Self {
        Self {
            input: Input::at_rest(),
            parameters: ParameterSlopes::default(),
            wheel_points: Vec::new(),
            rail_points: Default::default(),
        }
    }
}

/// Derivatives by parameters, each under the name of its own in
/// [`Parameters`](super::Parameters).
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct ParameterSlopes {
    /// By the radius of the nominal rolling circle.
    pub nominal_radius: f64,
    /// By Young's modulus of the wheel.
    pub wheel_young_modulus: f64,
    /// By that of the rails.
    pub rail_young_modulus: f64,
    /// By Poisson's ratio of the wheel.
    pub wheel_poisson_ratio: f64,
    /// By that of the rails.
    pub rail_poisson_ratio: f64,
    /// By the track gauge, where it says where rails stand.
    pub gauge: f64,
    /// By the depth at which it is measured; NaN where there is none, as for the inclination.
    pub gauge_depth: f64,
    /// By the inclination of each rail; NaN, as there is none, for rollers and rails whose section
    /// varies along the track.
    pub inclination: [f64; RAILS],
    /// By the position (y, z) of each rail that is placed by it.
    pub position: [[f64; 2]; RAILS],
    /// By the stiffness of rails without mass on their foundation, across and down.
    pub foundation_stiffness: [f64; 2],
    /// By the virtual over the true penetration.
    pub virtual_penetration: f64,
    /// By the contact damping.
    pub damping: f64,
    /// By the floor of the speed that creepages refer to, where that is no greater.
    pub minimum_speed: f64,
    /// By the numbers of the law of friction, or of that of the tread; zero where all laws are off.
    pub friction_law: LawSlopes,
    /// By those of the gauge face.
    pub gauge_face_law: LawSlopes,
}

/// Derivatives by the numbers of a law of friction.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct LawSlopes {
    /// By friction at infinite slip velocity over that without sliding.
    pub falling_share: f64,
    /// By the decay with the slip velocity.
    pub falling_decay: f64,
    /// By the initial slope over that of clean bodies.
    pub reduction: f64,
    /// By what is left of that at great creepages.
    pub reduction_share: f64,
    /// By the decay with creepage.
    pub reduction_decay: f64,
}

impl ParameterSlopes {
    /// All of them, each with the FMI name of its parameter; NaN where there is none.
    pub fn named(&self) -> [(&'static str, f64); 28] {
        let [tread, face] = [&self.friction_law, &self.gauge_face_law];
        [
            ("wheel.nominal_radius", self.nominal_radius),
            ("wheel.young_modulus", self.wheel_young_modulus),
            ("rail.young_modulus", self.rail_young_modulus),
            ("wheel.poisson_ratio", self.wheel_poisson_ratio),
            ("rail.poisson_ratio", self.rail_poisson_ratio),
            ("track.gauge", self.gauge),
            ("track.gauge_depth", self.gauge_depth),
            ("rail[1].inclination", self.inclination[0]),
            ("rail[2].inclination", self.inclination[1]),
            ("rail[1].position.y", self.position[0][0]),
            ("rail[1].position.z", self.position[0][1]),
            ("rail[2].position.y", self.position[1][0]),
            ("rail[2].position.z", self.position[1][1]),
            ("track.foundation.stiffness.y", self.foundation_stiffness[0]),
            ("track.foundation.stiffness.z", self.foundation_stiffness[1]),
            ("normal.virtual_penetration", self.virtual_penetration),
            ("normal.damping", self.damping),
            ("creepage.minimum_speed", self.minimum_speed),
            ("friction.falling.share", tread.falling_share),
            ("friction.falling.decay", tread.falling_decay),
            ("friction.reduction.initial", tread.reduction),
            ("friction.reduction.share", tread.reduction_share),
            ("friction.reduction.decay", tread.reduction_decay),
            ("friction.gauge_face.falling.share", face.falling_share),
            ("friction.gauge_face.falling.decay", face.falling_decay),
            ("friction.gauge_face.reduction.initial", face.reduction),
            ("friction.gauge_face.reduction.share", face.reduction_share),
            ("friction.gauge_face.reduction.decay", face.reduction_decay),
        ]
    }
}

/// What parameters are wanted for besides by derivatives backwards.
#[derive(Clone, Copy, Debug)]
pub(super) struct Wanted {
    pub wheel: Material,
    pub rail: Material,
}

impl Wanted {
    /// Of these parameters.
    pub fn of(parameters: &Parameters) -> Self {
        let [wheel, rail] = parameters.materials();
        Self { wheel, rail }
    }

    /// Derivative by Young's modulus of `body` from those by contact modulus, shear modulus and
    /// Poisson's ratio of the `pair`.
    pub fn by_modulus(&self, body: Material, pair: &MaterialPair, by: [f64; 3]) -> f64 {
        // With the compliances s of both, G = 2/(s1 + s2) and ν = (ν1 s1 + ν2 s2)/(s1 + s2).
        let compliance = 1.0 / body.shear_modulus();
        let both = 1.0 / self.wheel.shear_modulus() + 1.0 / self.rail.shear_modulus();
        let rate = -compliance / body.young_modulus;
        let plane = (1.0 - body.poisson_ratio * body.poisson_ratio)
            / (body.young_modulus * body.young_modulus);
        by[0] * pair.contact_modulus * pair.contact_modulus * plane
            - by[1] * pair.shear_modulus / both * rate
            + by[2] * (body.poisson_ratio - pair.poisson_ratio) / both * rate
    }

    /// Derivative by Poisson's ratio of `body` from the same.
    pub fn by_ratio(&self, body: Material, pair: &MaterialPair, by: [f64; 3]) -> f64 {
        let compliance = 1.0 / body.shear_modulus();
        let both = 1.0 / self.wheel.shear_modulus() + 1.0 / self.rail.shear_modulus();
        let rate = 2.0 / body.young_modulus;
        by[0] * pair.contact_modulus * pair.contact_modulus * body.poisson_ratio * rate
            - by[1] * pair.shear_modulus / both * rate
            + by[2] * (compliance + (body.poisson_ratio - pair.poisson_ratio) * rate) / both
    }
}

/// What a sweep back has found beside the tape.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Back {
    /// Derivatives by the inputs.
    pub by_input: [f64; INPUTS],
    /// By the stiffness of the foundation.
    pub by_stiffness: [f64; 2],
}
