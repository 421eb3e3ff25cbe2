//! Derivatives of a number by inputs, parameters and profiles.

use super::input::{INPUTS, Input};
use super::parameters::{Parameters, RAILS, Side, VerticalMode};
use super::rail::moving_contact::Kink;
use super::wheel_on_rails::Element;
use crate::geometry::curves::knot_slopes::KnotSlopes;
use crate::geometry::profiles::profile::ProfileKind;
use crate::leaves;
use crate::material::{Material, MaterialPair};
use crate::math::real::Leaf;

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
    wheel: Material,
    rail: Material,
}

impl Wanted {
    /// Of these parameters.
    pub fn of(parameters: &Parameters) -> Self {
        let [wheel, rail] = parameters.materials();
        Self { wheel, rail }
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

impl Element {
    /// Whether the profile of a body, 0 the wheel and 1 and 2 the rails, is one of many, so that
    /// there are no derivatives by its points: sections that vary, or a roller.
    #[doc(hidden)]
    pub fn point_varies(&self, body: usize) -> bool {
        let contacts = self.rails.each_ref().map(Option::as_ref);
        match body.checked_sub(1) {
            None => contacts.iter().flatten().any(|contact| contact.wheel_varies()),
            Some(rail) => contacts[rail].is_some_and(|contact| contact.rail.variation().is_some()),
        }
    }

    /// Derivatives by the nominal radius of the rate at which a wheel rolls freely, from those by
    /// the `input` as it is evaluated.
    pub(super) fn back_to_radius(&self, input: &Input, by_input: &Input) -> f64 {
        // The rate goes with the inverse of the radius.
        let rolls = self.rolling.is_some();
        let by_rate = by_input.wheel.pitch_rate * -input.wheel.pitch_rate / self.nominal_radius;
        if rolls { by_rate } else { 0.0 }
    }

    /// Brings derivatives by inputs, constants, the knots of the `wheel` and of the placed `rails`
    /// to those by inputs, parameters and points of a right wheel.
    pub(super) fn fill(
        &self,
        back: &Back,
        by_leaf: impl Fn(Leaf) -> f64,
        (wheel, rails): (&mut KnotSlopes, &mut [KnotSlopes; RAILS]),
        gradient: &mut Gradient,
    ) -> Result<(), Kink> {
        let by_input = Input::from_array(back.by_input);
        let law = |which: usize| {
            let number = |n: u32| by_leaf(leaves::of_law(which, n));
            LawSlopes {
                falling_share: number(0),
                falling_decay: number(1),
                reduction: number(2),
                reduction_share: number(3),
                reduction_decay: number(4),
            }
        };
        let pair = &self.models.material;
        let by_pair = [
            by_leaf(leaves::CONTACT_MODULUS) / pair.contact_modulus,
            by_leaf(leaves::SHEAR_MODULUS),
            by_leaf(leaves::POISSON_RATIO),
        ];
        let mut found = ParameterSlopes {
            wheel_young_modulus: self.wanted.by_modulus(self.wanted.wheel, pair, by_pair),
            rail_young_modulus: self.wanted.by_modulus(self.wanted.rail, pair, by_pair),
            wheel_poisson_ratio: self.wanted.by_ratio(self.wanted.wheel, pair, by_pair),
            rail_poisson_ratio: self.wanted.by_ratio(self.wanted.rail, pair, by_pair),
            foundation_stiffness: back.by_stiffness,
            virtual_penetration: by_leaf(leaves::VIRTUAL_PENETRATION),
            // A given load is that of a wheel at rest.
            damping: if self.vertical_mode == VerticalMode::Penetration {
                by_leaf(leaves::DAMPING)
            } else {
                0.0
            },
            minimum_speed: by_leaf(leaves::MINIMUM_SPEED),
            friction_law: law(0),
            gauge_face_law: law(1),
            ..ParameterSlopes::default()
        };
        // Every look at the wheel's profile adds the nominal radius to z.
        found.nominal_radius = wheel.knots.iter().map(|knot| knot.point[1]).sum();
        let worn = self.models.wear.is_some();
        let contacts = self.rails.iter().zip(rails).enumerate();
        gradient.rail_points.iter_mut().for_each(Vec::clear);
        gradient.wheel_points.clear();
        for (k, (contact, knots)) in contacts {
            let Some(contact) = contact else { continue };
            let marker = [by_input.rails[k].y, by_input.rails[k].z];
            let constants = leaves::of_rail(k as u32).map(&by_leaf);
            let varies = contact.rail.variation().is_some();
            let points = &mut gradient.rail_points[k];
            let stays = worn || varies;
            let placed = contact.rail.back_to_placement(knots, marker, constants, stays, points);
            found.gauge += placed.gauge;
            found.gauge_depth += placed.gauge_depth;
            let [y, z] = placed.position;
            found.position[k] = [if self.side == Side::Left { -y } else { y }, z];
            if varies {
                points.clear();
            } else {
                found.inclination[k] = placed.inclination;
            }
            if gradient.wheel_points.is_empty() {
                let outside = ProfileKind::Wheel.outside();
                let points = &mut gradient.wheel_points;
                wheel.by_displacements(&contact.wheel.curve, outside, points);
            }
        }
        let points = gradient.rail_points.iter().flatten().chain(&gradient.wheel_points);
        let numbers = found.named();
        let all = points.chain(&back.by_input).chain(numbers.iter().map(|(_, slope)| slope));
        if !all.sum::<f64>().is_finite() {
            return Err("a force grows without bound there");
        }
        for (contact, inclination) in self.rails.iter().zip(&mut found.inclination) {
            let Some(contact) = contact.as_ref().filter(|c| c.rail.variation().is_some()) else {
                continue;
            };
            // Rows that vary do not go back to the profiles that they were laid through.
            *inclination = f64::NAN;
            if contact.rail.is_placed_by_gauge() {
                found.gauge_depth = f64::NAN;
            }
        }
        (gradient.input, gradient.parameters) = (by_input, found);
        Ok(())
    }
}

impl Wanted {
    /// Derivative by Young's modulus of `body` from those by contact modulus, shear modulus and
    /// Poisson's ratio of the `pair`.
    fn by_modulus(&self, body: Material, pair: &MaterialPair, by: [f64; 3]) -> f64 {
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
    fn by_ratio(&self, body: Material, pair: &MaterialPair, by: [f64; 3]) -> f64 {
        let compliance = 1.0 / body.shear_modulus();
        let both = 1.0 / self.wheel.shear_modulus() + 1.0 / self.rail.shear_modulus();
        let rate = 2.0 / body.young_modulus;
        by[0] * pair.contact_modulus * pair.contact_modulus * body.poisson_ratio * rate
            - by[1] * pair.shear_modulus / both * rate
            + by[2] * (compliance + (body.poisson_ratio - pair.poisson_ratio) * rate) / both
    }
}
