//! Equations of motion of a wheelset about even rolling in the middle of the track, with exact
//! derivatives of the contact forces.

use anyhow::{Result, bail};
use nalgebra::{Complex, Matrix2, SMatrix, Vector2};
use wheelrail::wheelset::{Input, Output, Wheelset};

use crate::wheelset::GRAVITY;
use crate::wheelset::body::Body;
use crate::wheelset::suspension::Suspension;

/// Coordinates, and behind them their rates.
pub const STATES: [&str; 9] =
    ["y", "z", "roll", "yaw", "vy", "vz", "roll_rate", "yaw_rate", "pitch_rate"];
const POSITIONS: usize = 4;

/// Steps after which the search for the equilibrium gives up; five are usual.
const MAX_STEPS: usize = 30;
/// Unbalanced force at which it ends, as a share of the load.
const ACCURACY: f64 = 1e-10;
/// Overlap of wheel and rail at which it begins [m].
const FIRST_PENETRATION: f64 = 1e-4;
/// Greatest step of the height [m] and of the pitch rate, as a share of it: creep forces are linear
/// in small ones only.
const MAX_STEP: [f64; 2] = [5e-5, 5e-4];

/// The system matrix A of s' = A s.
pub type SystemMatrix = SMatrix<f64, 9, 9>;

/// A wheelset with its suspension.
#[derive(Debug)]
pub struct LinearWheelset<'a> {
    pub contact: &'a mut Wheelset,
    pub body: Body,
    pub suspension: Suspension,
    /// Coefficient of friction [-].
    pub friction: f64,
}

impl LinearWheelset<'_> {
    /// The input at which the centred wheelset rolls at `speed` [m/s] without acceleration.
    pub fn equilibrium(&mut self, speed: f64) -> Result<Input> {
        let weight = self.suspension.load + self.body.mass * GRAVITY;
        let mut input = Input::default();
        let radius = -self.contact.nominal_z();
        input.wheelset.position[2] = FIRST_PENETRATION - radius;
        input.wheelset.velocity[0] = speed;
        input.wheelset.pitch_rate = -speed / radius;
        for side in &mut input.sides {
            side.friction = self.friction;
        }
        let mut output = Output::default();
        let mut down = Input::at_rest();
        down.wheelset.position[2] = 1.0;
        let mut turning = Input::at_rest();
        turning.wheelset.pitch_rate = 1.0;
        for _ in 0..MAX_STEPS {
            self.contact.evaluate(&input, &mut output)?;
            let forces =
                |output: &Output| Vector2::new(output.wheelset.force[2], output.wheelset.moment[1]);
            let rest = forces(&output) + Vector2::new(weight, 0.0);
            if rest.x.abs() < ACCURACY * weight && rest.y.abs() < ACCURACY * weight * radius {
                return Ok(input);
            }
            let [by_height, by_rate] = [&down, &turning].map(|direction| {
                let mut rates = Output::default();
                self.contact.directional_derivative(&input, direction, &mut rates)?;
                anyhow::Ok(forces(&rates))
            });
            let slopes = Matrix2::from_columns(&[by_height?, by_rate?]);
            let Some(step) = slopes.lu().solve(&-rest) else { break };
            let most = [MAX_STEP[0], MAX_STEP[1] * input.wheelset.pitch_rate.abs()];
            input.wheelset.position[2] += step.x.clamp(-most[0], most[0]);
            input.wheelset.pitch_rate += step.y.clamp(-most[1], most[1]);
        }
        bail!("no equilibrium found at {speed} m/s in {MAX_STEPS} steps")
    }

    /// The system matrix about that equilibrium.
    ///
    /// With h the momentum about the axle, C and D what forces and moments change by with
    /// coordinates and rates:
    ///
    /// ```text
    /// m y'' = F_y,  m z'' = F_z,  I roll'' = M_x + h yaw',  I yaw'' = M_z - h roll',  I_a pitch'' = M_y
    /// ```
    pub fn system(&mut self, at: &Input) -> Result<SystemMatrix> {
        let mut matrix = SystemMatrix::zeros();
        let Body { mass, inertia, axle_inertia, .. } = self.body;
        for column in 0..STATES.len() {
            let mut direction = Input::at_rest();
            let wheelset = &mut direction.wheelset;
            *match column {
                0 => &mut wheelset.position[1],
                1 => &mut wheelset.position[2],
                2 => &mut wheelset.roll,
                3 => &mut wheelset.yaw,
                4 => &mut wheelset.velocity[1],
                5 => &mut wheelset.velocity[2],
                6 => &mut wheelset.roll_rate,
                7 => &mut wheelset.yaw_rate,
                _ => &mut wheelset.pitch_rate,
            } = 1.0;
            let mut rates = Output::default();
            self.contact.directional_derivative(at, &direction, &mut rates)?;
            let [_, y, z] = rates.wheelset.force;
            let [about_x, about_y, about_z] = rates.wheelset.moment;
            let forces =
                [y / mass, z / mass, about_x / inertia, about_z / inertia, about_y / axle_inertia];
            for (row, force) in forces.into_iter().enumerate() {
                matrix[(POSITIONS + row, column)] = force;
            }
        }
        self.add_suspension(&mut matrix);
        let spin = axle_inertia * at.wheelset.pitch_rate / inertia;
        matrix[(6, 7)] += spin;
        matrix[(7, 6)] -= spin;
        for place in 0..POSITIONS {
            matrix[(place, POSITIONS + place)] = 1.0;
        }
        Ok(matrix)
    }

    fn add_suspension(&self, matrix: &mut SystemMatrix) {
        let Body { mass, inertia, .. } = self.body;
        let arm = self.suspension.half_distance * self.suspension.half_distance;
        for (first, [x, y, z]) in
            [(0, self.suspension.stiffness), (POSITIONS, self.suspension.damping)]
        {
            // Of both axle boxes, on y, z, roll and yaw.
            let own = [y / mass, z / mass, z * arm / inertia, x * arm / inertia];
            for (row, own) in own.into_iter().enumerate() {
                matrix[(POSITIONS + row, first + row)] -= 2.0 * own;
            }
        }
    }
}

/// Eigenvalues of a matrix, the one that grows most first; of pairs the one with a positive
/// frequency [1/s].
pub fn eigenvalues(matrix: &SystemMatrix) -> Vec<Complex<f64>> {
    let all = matrix.complex_eigenvalues();
    let mut found: Vec<Complex<f64>> =
        all.iter().copied().filter(|value| value.im >= 0.0).collect();
    found.sort_by(|a, b| b.re.total_cmp(&a.re));
    found
}

#[cfg(test)]
mod tests {
    use wheelrail::element;
    use wheelrail::element::parameters::{NormalModel, TangentialModel};
    use wheelrail::wheelset::Parameters;

    use super::*;

    fn parts() -> (Wheelset, Body, Suspension) {
        let one = element::Parameters {
            normal_model: NormalModel::PiotrowskiKik,
            tangential_model: TangentialModel::Tables,
            ..element::Parameters::default()
        };
        let parameters = Parameters::of_both(&one);
        let contact = Wheelset::new(&parameters, &Input::default(), &[]).unwrap();
        let body =
            Body { mass: 1500.0, inertia: 900.0, axle_inertia: 100.0, half_marker_distance: 0.75 };
        let suspension = Suspension {
            half_distance: 1.0,
            stiffness: [1e6, 5e5, 1e6],
            damping: [0.0, 0.0, 2e4],
            load: 85e3,
            resting_z: 0.0,
        };
        (contact, body, suspension)
    }

    /// The same equations, not linear: a run from a small displacement.
    #[test]
    fn a_run_grows_and_swings_as_the_eigenvalue_says() {
        let (speed, step) = (40.0, 2e-5);
        let (mut contact, body, suspension) = parts();
        let mut linear = LinearWheelset { contact: &mut contact, body, suspension, friction: 0.3 };
        let start = linear.equilibrium(speed).unwrap();
        let matrix = linear.system(&start).unwrap();
        let hunting = eigenvalues(&matrix).into_iter().find(|value| value.im > 1.0).unwrap();
        let mut state = crate::wheelset::body::State {
            y: 1e-5,
            z: start.wheelset.position[2],
            pitch_rate: start.wheelset.pitch_rate,
            ..Default::default()
        };
        let suspension = Suspension { resting_z: state.z, ..suspension };
        let mut samples = Vec::new();
        let mut output = Output::default();
        for i in 0..60_000 {
            let mut input = start;
            let right = body.wheel_motion(&state, speed, 0.0);
            input.wheelset = right;
            contact.evaluate(&input, &mut output).unwrap();
            let axes = body.axes(&state);
            let moment = nalgebra::Vector3::from(output.wheelset.moment);
            let track = crate::wheelset::track::Lateral { position: 0.0, slope: 0.0 };
            let mut force = suspension.force(&state, track, speed);
            force.y += output.wheelset.force[1];
            force.z += output.wheelset.force[2] + body.mass * GRAVITY;
            force.roll += moment.dot(&axes.roll);
            force.yaw += moment.dot(&axes.yaw);
            force.pitch += moment.dot(&axes.axle);
            body.advance(&mut state, &force, speed, step);
            let time = step * f64::from(i);
            if time > 0.5 {
                samples.push((time, state.y));
            }
        }
        let found = crate::wheelset::oscillation::oscillation(&samples).unwrap();
        let period = std::f64::consts::TAU / hunting.im;
        approx::assert_relative_eq!(found.wavelength, period, max_relative = 5e-3);
        approx::assert_relative_eq!(found.decay, (hunting.re * period).exp(), max_relative = 5e-3);
    }

    #[test]
    fn a_load_that_nothing_carries_is_an_error() {
        let (mut contact, body, suspension) = parts();
        let suspension = Suspension { load: 1e12, ..suspension };
        let mut linear = LinearWheelset { contact: &mut contact, body, suspension, friction: 0.3 };
        let message = linear.equilibrium(20.0).unwrap_err().to_string();
        assert!(message.contains("no equilibrium found at 20 m/s"), "{message}");
    }
}
