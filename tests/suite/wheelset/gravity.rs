//! What weight alone does to a wheelset without friction: it swings sideways as a pendulum and
//! turns away from straight ahead.

use super::*;
use approx::assert_relative_eq;
use nalgebra::{Matrix3, Vector2};
use wheelrail::element::Parameters as ElementParameters;

/// Radii of the arcs of wheel and rail, nominal radius of the wheel [m].
const WHEEL_ARC: f64 = 0.5;
const RAIL_ARC: f64 = 0.3;
const RADIUS: f64 = 0.46;

/// A hollow arc on a crowned rail that touch at `angle` [rad] when the wheelset stands in the
/// middle.
fn arcs(angle: f64, normal_model: NormalModel) -> Parameters {
    let mut parameters = ElementParameters {
        normal_model,
        gauge: 2.0 * (HALF - (WHEEL_ARC - RAIL_ARC) * angle.sin() - 0.035),
        ..ElementParameters::default()
    };
    parameters.wheel.profile = format!("arc:{WHEEL_ARC}");
    parameters.rails[0].profile = format!("arc:{RAIL_ARC}");
    parameters.rails[0].inclination = 0.0;
    Parameters::of_both(&parameters)
}

/// A wheelset without friction in the middle of the track, at the height where its contacts carry
/// `load` together [N].
fn standing(wheelset: &mut Wheelset, load: f64) -> Input {
    let mut input = Input::default();
    input.sides.iter_mut().for_each(|side| side.friction = 0.0);
    let [mut high, mut low] = [wheelset.nominal_z(), wheelset.nominal_z() + 1e-3];
    while high < low {
        input.wheelset.position[2] = 0.5 * (high + low);
        if [high, low].contains(&input.wheelset.position[2]) {
            break;
        }
        let carried = -evaluate(wheelset, &input).wheelset.force[2];
        *(if carried < load { &mut high } else { &mut low }) = input.wheelset.position[2];
    }
    input
}

/// Derivative of the forces by a coordinate, of which `coordinate` of an input at rest has the
/// rate 1.
fn rates(wheelset: &mut Wheelset, input: &Input, coordinate: fn(&mut Input) -> &mut f64) -> Wrench {
    let mut direction = Input::at_rest();
    *coordinate(&mut direction) = 1.0;
    let mut rates = Output::default();
    wheelset.directional_derivative(input, &direction, &mut rates).unwrap();
    rates.wheelset
}

/// Height and roll of the centre at the lateral displacement `y` when the arcs are rigid: the
/// wheelset hangs by two links from the centres of the rails' arcs to those of the wheels'
/// [m, rad].
fn hanging(y: f64, angle: f64) -> [f64; 2] {
    let link = WHEEL_ARC - RAIL_ARC;
    let [mut z, mut roll] = [link * angle.cos() - RADIUS - WHEEL_ARC, 0.0_f64];
    for _ in 0..50 {
        let mut error = Vector2::zeros();
        let mut slopes = nalgebra::Matrix2::zeros();
        for (k, side) in [1.0, -1.0].into_iter().enumerate() {
            let [a, h] = [side * HALF, RADIUS + WHEEL_ARC];
            let (sine, cosine) = roll.sin_cos();
            let rail = Vector2::new(side * (HALF - link * angle.sin()), 0.0);
            let own = Vector2::new(a * cosine - h * sine, a * sine + h * cosine);
            let along = Vector2::new(y, z) + own - rail;
            error[k] = along.norm_squared() - link * link;
            slopes[(k, 0)] = 2.0 * along.y;
            slopes[(k, 1)] = 2.0 * along.dot(&Vector2::new(-own.y, own.x));
        }
        let step = slopes.lu().solve(&error).unwrap();
        z -= step[0];
        roll -= step[1];
    }
    [z, roll]
}

#[test]
fn a_wheelset_without_friction_swings_as_the_pendulum_of_its_geometry() {
    let angle = 0.05;
    // Light, so that the contacts are rigid against the weight.
    let (mass, inertia, gravity) = (200.0_f64, 100.0_f64, 9.81);
    for (normal_model, most) in [
        (NormalModel::PiotrowskiKik, tolerance::GRAVITY),
        (NormalModel::Strips, tolerance::GRAVITY_STRIPS),
    ] {
        let slowest = slowest_swing(&arcs(angle, normal_model), [mass, inertia, gravity], most);
        // Small swings of the rigid mechanism.
        let step = 1e-4;
        let [left, middle, right] = [-step, 0.0, step].map(|y| hanging(y, angle));
        let bend = (left[0] - 2.0 * middle[0] + right[0]) / (step * step);
        let turn = (right[1] - left[1]) / (2.0 * step);
        let rigid = (-mass * gravity * bend / (mass + inertia * turn * turn)).sqrt();
        println!("{normal_model:?}: {slowest} rad/s, rigid {rigid} rad/s");
        assert_relative_eq!(slowest, rigid, max_relative = most);
    }
}

/// Lowest angular frequency of a wheelset of the given mass and moment of inertia under gravity on
/// its contacts, whose stiffness is symmetric to the share `most` [rad/s].
fn slowest_swing(parameters: &Parameters, [mass, inertia, gravity]: [f64; 3], most: f64) -> f64 {
    let mut wheelset = wheelset(parameters);
    let input = standing(&mut wheelset, mass * gravity);
    let coordinates: [fn(&mut Input) -> &mut f64; 3] = [
        |input| &mut input.wheelset.position[1],
        |input| &mut input.wheelset.position[2],
        |input| &mut input.wheelset.roll,
    ];
    let columns = coordinates.map(|coordinate| {
        let Wrench { force, moment } = rates(&mut wheelset, &input, coordinate);
        nalgebra::Vector3::new(-force[1], -force[2], -moment[0])
    });
    let stiffness = Matrix3::from_columns(&columns);
    let root = Matrix3::from_diagonal(&nalgebra::Vector3::new(
        1.0 / mass.sqrt(),
        1.0 / mass.sqrt(),
        1.0 / inertia.sqrt(),
    ));
    let scaled = root * stiffness * root;
    assert!((scaled - scaled.transpose()).norm() < most * scaled.norm());
    (0.5 * (scaled + scaled.transpose())).symmetric_eigenvalues().min().sqrt()
}

#[test]
fn weight_turns_a_yawed_wheelset_further_by_the_lean_of_its_contacts() {
    let mut cone = ElementParameters::default();
    cone.wheel.profile = "conical:0.1".into();
    cone.rails[0].profile = format!("arc:{RAIL_ARC}");
    cone.rails[0].inclination = 0.1;
    for parameters in [
        Parameters::of_both(&cone),
        arcs(0.05, NormalModel::PiotrowskiKik),
        arcs(0.08, NormalModel::PiotrowskiKik),
    ] {
        let mut wheelset = wheelset(&parameters);
        let input = standing(&mut wheelset, 2e4);
        let found = rates(&mut wheelset, &input, |input| &mut input.wheelset.yaw).moment[2];
        let patch = evaluate(&mut wheelset, &input).sides[RIGHT].patches[0];
        let (sine, cosine) = (-patch.contact_angle).sin_cos();
        let arm = patch.position[1] - patch.rolling_radius * sine / cosine;
        let stiffness = -2.0 * patch.normal_force * sine * arm;
        println!("angle {:.4}: {found} N m, {}", -patch.contact_angle, -stiffness);
        assert_relative_eq!(-found, stiffness, max_relative = tolerance::GRAVITY);
    }
}
