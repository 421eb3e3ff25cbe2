//! How stiff the contact is and how much it damps, vertically and by its creep forces.

use nalgebra::Vector3;

use super::derivative_memory::DIRECTIONS;
use super::output::Wrench;
use super::parameters::{Side, VerticalMode};
use super::{Element, Input, Output};
use crate::error::ContactError;
use crate::math::real::Real;

/// Changes of the force of one wheel with its motion as a part of a wheelset, signs turned: all are
/// positive as a rule.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct ContactSlopes {
    /// -∂F_z/∂z [N/m].
    pub stiffness: f64,
    /// -∂F_z/∂v_z [N s/m].
    pub damping: f64,
    /// -∂F_y/∂v_y: damping of a lateral motion by creep forces [N s/m].
    pub lateral: f64,
    /// The same of a yaw motion about the centre of the wheelset, of the moment there [N m s].
    pub yaw: f64,
    /// The same of a rotation about the axle [N m s].
    pub pitch: f64,
}

/// Motions by which the slopes are taken.
const MOTIONS: usize = 5;
const _: () = assert!(MOTIONS <= DIRECTIONS);

/// Height over which differences are taken where there are no derivatives [m].
const HEIGHT_STEP: f64 = 1e-8;
/// Vertical velocity over which they are [m/s].
const VELOCITY_STEP: f64 = 1e-4;
/// Creepage over which they are.
const CREEPAGE_STEP: f64 = 1e-6;

/// Motions of a wheelset, of which the wheel is a part.
#[derive(Clone, Copy, Debug)]
struct Motions {
    axle: Vector3<f64>,
    yaw_axis: Vector3<f64>,
    /// From the centre to the wheel marker [m].
    arm: Vector3<f64>,
}

impl Motions {
    /// Of a wheelset whose centre is `along` [m] to the left of the marker.
    fn of(input: &Input, along: f64) -> Self {
        let axle = input.wheel.axle();
        let (sin_roll, cos_roll) = input.wheel.roll.sin_cos();
        Self { axle, yaw_axis: Vector3::new(0.0, -sin_roll, cos_roll), arm: axle * along }
    }

    /// Height and the velocities as rates of the inputs: vertical, lateral, yaw, pitch.
    fn directions(&self) -> [Input; MOTIONS] {
        let mut all = [Input::at_rest(); MOTIONS];
        let [down, falling, aside, yawing, turning] = &mut all;
        down.wheel.position[2] = 1.0;
        falling.wheel.velocity[2] = 1.0;
        aside.wheel.velocity[1] = 1.0;
        yawing.wheel.velocity = self.yaw_axis.cross(&self.arm).into();
        yawing.wheel.yaw_rate = 1.0;
        turning.wheel.pitch_rate = 1.0;
        all
    }

    /// The slopes from the `rates` of force and moment on the wheel.
    fn slopes(&self, rates: &[Wrench; MOTIONS]) -> ContactSlopes {
        let [down, falling, aside, yawing, turning] = rates;
        let moment = |wrench: &Wrench, axis: &Vector3<f64>| {
            let by_force = self.arm.cross(&Vector3::from(wrench.force));
            (Vector3::from(wrench.moment) + by_force).dot(axis)
        };
        ContactSlopes {
            stiffness: -down.force[2],
            damping: -falling.force[2],
            lateral: -aside.force[1],
            yaw: -moment(yawing, &self.yaw_axis),
            pitch: -moment(turning, &self.axle),
        }
    }
}

impl Element {
    /// Stiffness and damping at the height of `input`, also where a load is given, though without
    /// the normal damping that goes with a given height: exact derivatives, or central differences
    /// with the models that have none. The wheel turns with a wheelset whose centre is `lever` [m]
    /// from the wheel marker along the axle. All is left as it was; the first call allocates.
    ///
    /// # Errors
    /// The input at fault, by its FMU name, or [`ContactError::NoDerivative`] where contacts
    /// remember.
    pub fn contact_slopes(
        &mut self,
        input: &Input,
        lever: f64,
    ) -> Result<ContactSlopes, ContactError> {
        input.check()?;
        if self.remembers() {
            return Err(ContactError::NoDerivative {
                name: Some("tangential.history = transient"),
                reason: "forces follow from steps, not from inputs alone",
            });
        }
        let mode = std::mem::replace(&mut self.vertical_mode, VerticalMode::Penetration);
        let fallbacks = self.fallbacks;
        let outward = if self.side == Side::Left { -lever } else { lever };
        let found = self.slopes_at(input, outward);
        (self.vertical_mode, self.fallbacks) = (mode, fallbacks);
        found
    }

    /// Whether the height follows a load.
    pub(crate) fn follows_load(&self) -> bool {
        self.vertical_mode == VerticalMode::Load
    }

    fn slopes_at(&mut self, input: &Input, along: f64) -> Result<ContactSlopes, ContactError> {
        let motions = Motions::of(input, along);
        let mut rates = [Wrench::default(); MOTIONS];
        if self.wheel_rates(input, &motions.directions(), &mut rates).is_err() {
            self.wheel_differences(input, &motions, &mut rates)?;
        }
        Ok(motions.slopes(&rates))
    }

    /// Differences of the force and the moment on the wheel along each of the motions.
    fn wheel_differences(
        &mut self,
        input: &Input,
        motions: &Motions,
        rates: &mut [Wrench; MOTIONS],
    ) -> Result<(), ContactError> {
        let sliding = CREEPAGE_STEP * input.wheel.velocity[0].hypotenuse(self.models.minimum_speed);
        let turning = sliding / motions.arm.norm();
        let steps = [HEIGHT_STEP, VELOCITY_STEP, sliding, turning, turning];
        let at = input.to_array();
        let mut output = Output::default();
        for ((rate, way), step) in rates.iter_mut().zip(motions.directions()).zip(steps) {
            let way = way.to_array();
            let mut beside = |step: f64| {
                let place = std::array::from_fn(|i| at[i] + step * way[i]);
                self.evaluate(&Input::from_array(place), &mut output).map(|()| output.wheel)
            };
            let (low, high) = (beside(-step)?, beside(step)?);
            let slope = |low: [f64; 3], high: [f64; 3]| {
                [0, 1, 2].map(|i| (high[i] - low[i]) / (2.0 * step))
            };
            *rate = Wrench {
                force: slope(low.force, high.force),
                moment: slope(low.moment, high.moment),
            };
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::element::Parameters;
    use crate::element::parameters::NormalModel;

    /// A wheel that rolls, with 7e-5 m of penetration.
    fn rolling(parameters: &Parameters) -> (Element, Input) {
        let mut input = Input::default();
        if parameters.side == Side::Left {
            input.wheel.position[1] *= -1.0;
        }
        let element = Element::new(parameters, &input, &[]).unwrap();
        input.wheel.position[2] = element.nominal_wheel_z() + 7e-5;
        (input.wheel.velocity[0], input.wheel.pitch_rate) = (20.0, -43.6);
        (element, input)
    }

    /// Slopes by differences.
    fn by_differences(element: &mut Element, input: &Input, along: f64) -> ContactSlopes {
        let motions = Motions::of(input, along);
        let mut rates = [Wrench::default(); MOTIONS];
        element.wheel_differences(input, &motions, &mut rates).unwrap();
        motions.slopes(&rates)
    }

    #[test]
    fn differences_and_derivatives_agree_whatever_is_given() {
        for mode in [VerticalMode::Penetration, VerticalMode::Load] {
            let parameters = Parameters { vertical_mode: mode, ..Parameters::default() };
            let (mut element, input) = rolling(&parameters);
            let exact = element.contact_slopes(&input, 0.75).unwrap();
            element.vertical_mode = VerticalMode::Penetration;
            let found = by_differences(&mut element, &input, 0.75);
            println!("{exact:?} {found:?}");
            approx::assert_relative_eq!(exact.stiffness, found.stiffness, max_relative = 1e-6);
            approx::assert_relative_eq!(exact.damping, found.damping, max_relative = 1e-5);
            approx::assert_relative_eq!(exact.lateral, found.lateral, max_relative = 1e-5);
            approx::assert_relative_eq!(exact.yaw, found.yaw, max_relative = 1e-5);
            approx::assert_relative_eq!(exact.pitch, found.pitch, max_relative = 1e-5);
            // A given load is static, without normal damping: creep forces are left.
            let most = if mode == VerticalMode::Load { 1e3 } else { 5e5 };
            let least = if mode == VerticalMode::Load { 1.0 } else { 5e4 };
            assert!(exact.stiffness > 5e8, "{exact:?}");
            assert!(exact.damping > least && exact.damping < most, "{exact:?}");
            assert!(exact.lateral > 1e4 && exact.yaw > 1e4 && exact.pitch > 1e3, "{exact:?}");
        }
    }

    #[test]
    fn a_left_wheel_has_the_slopes_of_its_mirror_image() {
        let (mut right, mut input) = rolling(&Parameters::default());
        input.wheel.yaw = 2e-3;
        let wanted = right.contact_slopes(&input, 0.75).unwrap();
        let left = Parameters { side: Side::Left, ..Parameters::default() };
        let (mut left, _) = rolling(&left);
        let found = left.contact_slopes(&Side::Left.mirror(input), 0.75).unwrap();
        approx::assert_relative_eq!(found.yaw, wanted.yaw, max_relative = 1e-9);
        approx::assert_relative_eq!(found.lateral, wanted.lateral, max_relative = 1e-9);
        approx::assert_relative_eq!(found.pitch, wanted.pitch, max_relative = 1e-9);
    }

    #[test]
    fn models_without_derivatives_have_slopes_too() {
        let parameters = Parameters {
            normal_model: NormalModel::BoundaryElement,
            normal_elements: [8, 8],
            ..Parameters::default()
        };
        let (mut element, input) = rolling(&parameters);
        let mut rates = [Wrench::default(); MOTIONS];
        let directions = Motions::of(&input, 0.75).directions();
        assert!(element.wheel_rates(&input, &directions, &mut rates).is_err());
        let found = element.contact_slopes(&input, 0.75).unwrap();
        assert!(found.stiffness > 5e8 && found.pitch > 1e3, "{found:?}");
    }
}
