//! How stiff the contact is, and how much it damps, vertically.

use super::parameters::VerticalMode;
use super::{Element, Input, Output};
use crate::error::ContactError;

/// Changes of the vertical force on the wheel with its height and its vertical velocity, signs
/// turned: both are positive as a rule.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct VerticalSlopes {
    /// -∂F_z/∂z [N/m].
    pub stiffness: f64,
    /// -∂F_z/∂v_z [N s/m].
    pub damping: f64,
}

/// Distances over which differences are taken where there are no derivatives: of height [m] and of
/// velocity [m/s].
const STEPS: [f64; 2] = [1e-8, 1e-4];

impl Element {
    /// Stiffness and damping at the height of `input`, also where a load is given, though without
    /// the normal damping that goes with a given height: exact derivatives, or central differences
    /// with the models that have none. All is left as it was; the first call allocates.
    ///
    /// # Errors
    /// The input at fault, by its FMU name.
    pub fn vertical_slopes(&mut self, input: &Input) -> Result<VerticalSlopes, ContactError> {
        input.check()?;
        let mode = std::mem::replace(&mut self.vertical_mode, VerticalMode::Penetration);
        let fallbacks = self.fallbacks;
        let found = self.exact_slopes(input).or_else(|_| self.differences(input));
        (self.vertical_mode, self.fallbacks) = (mode, fallbacks);
        let [stiffness, damping] = found?;
        Ok(VerticalSlopes { stiffness, damping })
    }

    fn exact_slopes(&mut self, input: &Input) -> Result<[f64; 2], ContactError> {
        let mut rates = Output::default();
        let mut slopes = [0.0; 2];
        for (slope, number) in slopes.iter_mut().zip(VERTICAL) {
            let mut direction = Input::at_rest();
            *number(&mut direction) = 1.0;
            self.directional_derivative(input, &direction, &mut rates)?;
            *slope = -rates.wheel.force[2];
        }
        Ok(slopes)
    }

    fn differences(&mut self, input: &Input) -> Result<[f64; 2], ContactError> {
        let mut output = Output::default();
        let mut slopes = [0.0; 2];
        for ((slope, number), step) in slopes.iter_mut().zip(VERTICAL).zip(STEPS) {
            let mut at = |way: f64| {
                let mut beside = *input;
                *number(&mut beside) += way;
                self.evaluate(&beside, &mut output).map(|()| output.wheel.force[2])
            };
            *slope = (at(-step)? - at(step)?) / (2.0 * step);
        }
        Ok(slopes)
    }
}

/// Height and vertical velocity.
const VERTICAL: [fn(&mut Input) -> &mut f64; 2] =
    [|input| &mut input.wheel.position[2], |input| &mut input.wheel.velocity[2]];

#[cfg(test)]
mod tests {
    use super::*;
    use crate::element::Parameters;
    use crate::element::parameters::NormalModel;

    #[test]
    fn differences_and_derivatives_agree_whatever_is_given() {
        for mode in [VerticalMode::Penetration, VerticalMode::Load] {
            let parameters = Parameters { vertical_mode: mode, ..Parameters::default() };
            let mut input = Input::default();
            let mut element = Element::new(&parameters, &input, &[]).unwrap();
            input.wheel.position[2] = element.nominal_wheel_z() + 7e-5;
            (input.wheel.velocity[0], input.wheel.pitch_rate) = (20.0, -43.6);
            let exact = element.vertical_slopes(&input).unwrap();
            element.vertical_mode = VerticalMode::Penetration;
            let [stiffness, damping] = element.differences(&input).unwrap();
            approx::assert_relative_eq!(exact.stiffness, stiffness, max_relative = 1e-6);
            approx::assert_relative_eq!(exact.damping, damping, max_relative = 1e-5);
            // A given load is static, without normal damping: creep forces are left.
            let most = if mode == VerticalMode::Load { 1e3 } else { 5e5 };
            let least = if mode == VerticalMode::Load { 1.0 } else { 5e4 };
            assert!(stiffness > 5e8 && damping > least && damping < most, "{damping}");
        }
    }

    #[test]
    fn models_without_derivatives_have_a_stiffness_too() {
        let parameters = Parameters {
            normal_model: NormalModel::BoundaryElement,
            normal_elements: [8, 8],
            ..Parameters::default()
        };
        let mut input = Input::default();
        let mut element = Element::new(&parameters, &input, &[]).unwrap();
        input.wheel.position[2] = element.nominal_wheel_z() + 7e-5;
        assert!(element.exact_slopes(&input).is_err());
        assert!(element.vertical_slopes(&input).unwrap().stiffness > 5e8);
    }
}
