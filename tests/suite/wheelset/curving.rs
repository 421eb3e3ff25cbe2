//! A wheelset that runs evenly through a curve under a lateral force, held by a yaw spring, against
//! its linear equations of equilibrium.

use super::*;
use approx::assert_relative_eq;
use nalgebra::{Matrix2, Matrix3, Vector2, Vector3};
use wheelrail::element::Parameters as ElementParameters;
use wheelrail::element::parameters::{CreepageModel, TangentialModel};
use wheelrail::tangential::kalker_coefficients::kalker_coefficients;

const SPEED: f64 = 20.0;
const RADIUS: f64 = 0.46;
const CONICITY: f64 = 0.02;
const LOAD: f64 = 6e4;
const YOUNG: f64 = 2.1e11;
const POISSON: f64 = 0.28;

/// What a wheelset is under besides its rails.
#[derive(Clone, Copy)]
struct Guided {
    /// Of the track, to the right [1/m].
    curvature: f64,
    /// Lateral force [N].
    force: f64,
    /// Stiffness of the yaw spring [N m/rad] and the angle at which it is slack [rad].
    stiffness: f64,
    slack: f64,
}

/// Cones on rails as crowned as the wheels are round, so that contacts are circles, with linear
/// creep forces.
fn cones() -> Wheelset {
    let mut parameters = ElementParameters {
        normal_model: NormalModel::Hertz,
        tangential_model: TangentialModel::Linear,
        creepage_model: CreepageModel::Flat,
        vertical_mode: VerticalMode::Load,
        ..ElementParameters::default()
    };
    parameters.wheel.profile = format!("conical:{CONICITY}");
    parameters.rails[0].profile = format!("arc:{RADIUS}");
    parameters.rails[0].inclination = 0.0;
    wheelset(&Parameters::of_both(&parameters))
}

fn rolling(curvature: f64) -> Input {
    let mut input = Input::default();
    input.wheelset.velocity[0] = SPEED;
    input.wheelset.pitch_rate = -SPEED / RADIUS;
    input.track.curvature = curvature;
    input.sides.iter_mut().for_each(|side| side.wheel_load = LOAD);
    input
}

/// Lateral shift, yaw and pitch rate at which nothing pushes or turns the wheelset, by Newton's
/// method with the exact derivatives.
fn equilibrium(wheelset: &mut Wheelset, guided: &Guided) -> (Input, Output) {
    let mut input = rolling(guided.curvature);
    let coordinates: [fn(&mut Input) -> &mut f64; 3] = [
        |input| &mut input.wheelset.position[1],
        |input| &mut input.wheelset.yaw,
        |input| &mut input.wheelset.pitch_rate,
    ];
    for _ in 0..8 {
        let Wrench { force, moment } = evaluate(wheelset, &input).wheelset;
        let spring = guided.stiffness * (guided.slack - input.wheelset.yaw);
        let excess = Vector3::new(force[1] + guided.force, moment[2] + spring, moment[1]);
        let columns = coordinates.map(|coordinate| {
            let mut direction = Input::at_rest();
            *coordinate(&mut direction) = 1.0;
            let mut rates = Output::default();
            wheelset.directional_derivative(&input, &direction, &mut rates).unwrap();
            let Wrench { force, moment } = rates.wheelset;
            let spring = guided.stiffness * direction.wheelset.yaw;
            Vector3::new(force[1], moment[2] - spring, moment[1])
        });
        let step = Matrix3::from_columns(&columns).lu().solve(&excess).unwrap();
        for (coordinate, step) in coordinates.iter().zip(step.iter()) {
            *coordinate(&mut input) -= step;
        }
    }
    let output = evaluate(wheelset, &input);
    let Wrench { force, moment } = output.wheelset;
    assert!((force[1] + guided.force).abs() < 1e-3, "{force:?}");
    assert!((moment[2] + guided.stiffness * (guided.slack - input.wheelset.yaw)).abs() < 1e-3);
    assert!(moment[1].abs() < 1e-3, "{moment:?}");
    (input, output)
}

/// The linear equations of a wheelset on cones in a curve: lateral shift, yaw, and longitudinal
/// creep force of the right wheel [m, rad, N].
///
/// The axle rolls by -Λ y/b, which moves the contacts on the crowns R of the rails too: Λ = λ (1 +
/// r λ/b)/(1 - R λ/b). With the creepages ∓(κ b + Λ y/r) along and -ψ across, and the spins κ ∓
/// λ/r - Λ y/(b r):
///
/// ```text
/// 2 f22 ψ - (2 N - 2 f23/r) Λ y/b = 2 f23 κ - H
/// (2 N λ (b - r λ) - 2 f23 - k) ψ - 2 b f11 Λ y/r = 2 b² f11 κ - k ψ₀
/// ```
///
/// f = G (c² c11, c² c22, c³ c23), c the radius of the circle of contact by Hertz.
fn linear_equilibrium(guided: &Guided, half: f64, radius: f64) -> [f64; 3] {
    let modulus = YOUNG / (2.0 * (1.0 - POISSON * POISSON));
    let circle = (0.75 * LOAD * RADIUS / modulus).cbrt();
    let shear = YOUNG / (2.0 * (1.0 + POISSON));
    let c = kalker_coefficients(1.0, POISSON);
    let [f11, f22, f23] = [c.c11, c.c22, c.c23 * circle].map(|c| shear * circle * circle * c);
    let Guided { curvature, force, stiffness, slack } = *guided;
    let conicity = CONICITY * (1.0 + radius * CONICITY / half) / (1.0 - RADIUS * CONICITY / half);
    let lean = conicity / half;
    let matrix = Matrix2::new(
        -(2.0 * LOAD - 2.0 * f23 / radius) * lean,
        2.0 * f22,
        -2.0 * half * f11 * conicity / radius,
        2.0 * LOAD * CONICITY * (half - radius * CONICITY) - 2.0 * f23 - stiffness,
    );
    let right = Vector2::new(
        2.0 * f23 * curvature - force,
        2.0 * half * half * f11 * curvature - stiffness * slack,
    );
    let found = matrix.lu().solve(&right).unwrap();
    let creepage = -(curvature * half + conicity * found[0] / radius);
    [found[0], found[1], -f11 * creepage]
}

#[test]
fn a_wheelset_in_a_curve_stands_where_its_linear_equations_have_it() {
    let mut wheelset = cones();
    let centred = evaluate(&mut wheelset, &rolling(0.0));
    let patch = centred.sides[RIGHT].patches[0];
    let (half, radius) = (patch.position[1], patch.rolling_radius);
    for guided in [
        // Free to steer: it rolls without slip along, on the outer side of the track.
        Guided { curvature: 2e-4, force: 0.0, stiffness: 0.0, slack: 0.0 },
        Guided { curvature: 2e-4, force: -3e3, stiffness: 0.0, slack: 0.0 },
        // In a stiff frame the leading wheelset has an angle of attack and is held by the creep
        // forces of its slip.
        Guided { curvature: 3e-4, force: -2e3, stiffness: 1e7, slack: 5e-4 },
        Guided { curvature: -2e-4, force: 5e3, stiffness: 3e6, slack: -3e-4 },
    ] {
        let (input, output) = equilibrium(&mut wheelset, &guided);
        let [shift, yaw, along] = linear_equilibrium(&guided, half, radius);
        let found = &input.wheelset;
        let creep = output.sides.each_ref().map(|side| side.patches[0].creep_force);
        println!(
            "shift {} {shift}, yaw {} {yaw}, along {creep:?} {along}",
            found.position[1], found.yaw
        );
        // Of what pure rolling needs, and of the force of the yaw that it takes.
        let rolling = half * radius * guided.curvature / CONICITY;
        let within = tolerance::LINEAR_CURVING;
        assert_relative_eq!(found.position[1], shift, epsilon = within * rolling.abs());
        assert_relative_eq!(found.yaw, yaw, epsilon = within * yaw.abs().max(1e-4));
        let scale = along.abs().max(1e3);
        assert_relative_eq!(creep[RIGHT][0], along, epsilon = within * scale);
        assert_relative_eq!(creep[LEFT][0], -along, epsilon = within * scale);
    }
}
