//! Derivatives by parameters and profiles from those by the numbers that an evaluation takes.

use super::gradient::{Back, Gradient, LawSlopes, ParameterSlopes};
use super::input::Input;
use super::parameters::{RAILS, Side, VerticalMode};
use super::rail::moving_contact::Kink;
use super::wheel_on_rails::Element;
use crate::geometry::curves::knot_slopes::KnotSlopes;
use crate::geometry::profiles::profile::ProfileKind;
use crate::leaves;
use crate::math::real::Leaf;

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
