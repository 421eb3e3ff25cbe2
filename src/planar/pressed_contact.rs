//! Bodies that stay pressed together while they roll at one creepage after the other: adhesion and
//! what it depends on.

use super::{PlanarCase, Pressed, press_together, tangential_of};
use crate::error::ContactError;
use crate::kinematics::creepage::{Creepage, bounded};
use crate::material::MaterialPair;
use crate::math::dual::Dual;
use crate::math::real::Real;
use crate::normal::Strips;
use crate::tangential::flash_temperature::FlashTemperature;
use crate::tangential::friction_law::FrictionLaw;
use crate::tangential::{RollingState, RollingZone, Tangential, TangentialModel, UnderLaw};

/// What the derivatives of adhesion are by: friction, then share and decay of its fall, then
/// initial slope, share and decay of the reduction.
pub const LAW_PARAMETERS: usize = 6;
type Number = Dual<LAW_PARAMETERS>;

/// Bodies pressed together by the normal force of a planar case.
#[derive(Debug)]
pub struct PressedContact {
    strips: Strips<Number>,
    material: MaterialPair<Number>,
    /// Without laws of friction: they come with each call.
    tangential: Tangential,
    flash_temperature: Option<FlashTemperature>,
    contact_y: f64,
    /// Normal force [N].
    load: f64,
}

impl PressedContact {
    /// The bodies of `case`, whose creepage, friction and law are those of each call later.
    ///
    /// # Errors
    /// A value that is not admitted; [`ContactError::NoDerivative`] with boundary elements for the
    /// tractions.
    pub fn new(case: &PlanarCase) -> Result<Self, ContactError> {
        if case.tangential_model == TangentialModel::BoundaryElement {
            let name = Some("tangential.model = boundary_element");
            let reason = "they are there for real-time models";
            return Err(ContactError::NoDerivative { name, reason });
        }
        let Pressed { strips, material, contact_y, .. } = press_together(case)?;
        Ok(Self {
            load: strips.load(),
            strips: strips.in_other_numbers(),
            material: material.fixed(),
            tangential: tangential_of(case)
                .with_law(FrictionLaw::default())
                .with_flash_temperature(FlashTemperature::default()),
            flash_temperature: case.flash_temperature.is_on().then_some(case.flash_temperature),
            contact_y,
        })
    }

    /// Creep force over normal force for a `creepage` (longitudinal, lateral [-], spin [1/m]) at a
    /// rolling `speed` [m/s], and its derivatives by `friction` and the parameters of `law`, in the
    /// order of [`LAW_PARAMETERS`].
    pub fn adhesion(
        &self,
        creepage: [f64; 3],
        speed: f64,
        friction: f64,
        law: &FrictionLaw,
    ) -> (f64, [f64; LAW_PARAMETERS]) {
        let law = FrictionLaw {
            falling_law: law.falling_law,
            falling_share: Number::variable(law.falling_share, 1),
            falling_decay: Number::variable(law.falling_decay, 2),
            reduction: Number::variable(law.reduction, 3),
            reduction_share: Number::variable(law.reduction_share, 4),
            reduction_decay: Number::variable(law.reduction_decay, 5),
        };
        let [longitudinal, lateral, spin] = creepage.map(bounded);
        let mut force = [Number::from(0.0); 2];
        let zones = self.strips.zones.iter();
        let laws = zones.clone().map(|zone| {
            let y = self.contact_y + zone.y.value();
            let at = Creepage { longitudinal: bounded(longitudinal - spin * y), lateral, spin };
            let state = RollingState {
                creepage: Creepage {
                    longitudinal: at.longitudinal.into(),
                    lateral: at.lateral.into(),
                    spin: at.spin.into(),
                },
                forward_share: Number::from(1.0),
                friction: Number::variable(friction, 0),
                load_factor: Number::from(1.0),
                speed: Number::from(speed),
            };
            let heat = self.flash_temperature.as_ref();
            UnderLaw::of(Some(&[law; 2]), heat, zone, &self.strips, &self.material, &state)
        });
        let laws: Vec<_> = laws.collect();
        if laws.iter().all(|law| law.state.creepage.is_zero()) {
            return (0.0, [0.0; LAW_PARAMETERS]);
        }
        let rolling =
            zones.zip(&laws).map(|(zone, law)| RollingZone::flat(zone, &self.strips, law));
        // A copy, as several callers may ask at once.
        let mut tangential = self.tangential.clone();
        tangential.roll(rolling, |_, _, strip| {
            force = [force[0] + strip.longitudinal, force[1] + strip.lateral];
        });
        let adhesion = force[0].hypotenuse(force[1]) / self.load;
        (adhesion.value, adhesion.slopes)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::element::Parameters;
    use crate::planar::{Indentation, solve};
    use crate::tangential::friction_law::FallingLaw;
    use approx::assert_relative_eq;

    #[test]
    fn adhesion_and_its_derivatives_are_those_of_the_planar_problem() {
        let separation: Vec<[f64; 2]> =
            (-50..=50).map(|i| 2e-4 * f64::from(i)).map(|y| [y, 1.6 * y * y]).collect();
        let law = FrictionLaw {
            falling_law: FallingLaw::Exponential,
            falling_share: 0.4,
            falling_decay: 0.6,
            reduction: 0.7,
            reduction_share: 0.3,
            reduction_decay: 0.5,
        };
        let creepage = [8e-3, 1e-3, 0.05];
        let cold = FlashTemperature::default();
        let hot = FlashTemperature { share: 0.4, range: 200.0, ..cold };
        let mut adhesions = Vec::new();
        for heat in [cold, hot] {
            let found = |friction: f64, law: FrictionLaw| {
                let parameters = Parameters {
                    friction_law: law,
                    flash_temperature: heat,
                    ..Parameters::default()
                };
                let load = Indentation::Load(8e4);
                let case = parameters.planar_case(&separation, 0.46, load, creepage, friction);
                PlanarCase { speed: 15.0, ..case }
            };
            let case = found(0.35, law);
            let contact = PressedContact::new(&case).unwrap();
            let (adhesion, slopes) = contact.adhesion(creepage, 15.0, 0.35, &law);
            let planar = |friction: f64, law: FrictionLaw| {
                let result = solve(&found(friction, law)).unwrap();
                result.fx.hypotenuse(result.fy) / result.normal_force
            };
            assert_relative_eq!(adhesion, planar(0.35, law), max_relative = 1e-12);
            adhesions.push(adhesion);
            let h = 1e-6;
            let moved: [fn(&mut f64, &mut FrictionLaw, f64); LAW_PARAMETERS] = [
                |friction, _, h| *friction += h,
                |_, law, h| law.falling_share += h,
                |_, law, h| law.falling_decay += h,
                |_, law, h| law.reduction += h,
                |_, law, h| law.reduction_share += h,
                |_, law, h| law.reduction_decay += h,
            ];
            for (slope, change) in slopes.iter().zip(moved) {
                let at = |h: f64| {
                    let (mut friction, mut law) = (0.35, law);
                    change(&mut friction, &mut law, h);
                    contact.adhesion(creepage, 15.0, friction, &law).0
                };
                let expected = (at(h) - at(-h)) / (2.0 * h);
                assert_relative_eq!(*slope, expected, max_relative = 1e-5, epsilon = 1e-9);
            }
        }
        assert!(adhesions[1] < 0.95 * adhesions[0], "{adhesions:?}");
    }
}
