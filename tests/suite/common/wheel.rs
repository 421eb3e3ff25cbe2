//! Elements and inputs of wheels on rails, as several tests use them.

use wheelrail::element::input::RailMotion;
use wheelrail::element::output::Patch;
use wheelrail::element::parameters::Side;
use wheelrail::element::{Element, Input, Output, Parameters};
use wheelrail::geometry::profile::{Profile, ProfileKind};
use wheelrail::geometry::rail::placed_rail::PlacedRail;
use wheelrail::io::load_profile;

use super::planar::STEEL;
use super::random::Random;

/// An element with built-in profiles.
pub fn element(parameters: &Parameters) -> Element {
    Element::new(parameters, &Input::default(), &[]).unwrap()
}

/// A wheel of the default parameters with the given profiles on a rail without inclination.
pub fn plain_parameters(wheel: &str, rail: &str) -> Parameters {
    let mut parameters = Parameters::default();
    parameters.wheel.profile = wheel.into();
    parameters.rails[0].profile = rail.into();
    parameters.rails[0].inclination = 0.0;
    parameters
}

/// The same motion seen in a mirror across the track: it runs backwards.
pub fn reversed(input: &Input) -> Input {
    let mut back = *input;
    let wheel = &mut back.wheel;
    for value in [
        &mut wheel.position[0],
        &mut wheel.velocity[0],
        &mut wheel.yaw,
        &mut wheel.yaw_rate,
        &mut wheel.pitch_rate,
    ] {
        *value = -*value;
    }
    back
}

/// The result of one evaluation.
pub fn evaluate(element: &mut Element, input: &Input) -> Output {
    let mut output = Output::default();
    element.evaluate(input, &mut output).unwrap();
    output
}

/// The wheel marker moved to `depth` below the height of first touch.
pub fn pressed(element: &mut Element, input: &Input, depth: f64) -> Input {
    let mut pressed = *input;
    pressed.wheel.position[2] = element.touching_height(input) + depth;
    pressed
}

/// A wheel shifted by `shift` that rolls forward at `speed`, not yet pressed on the rail.
pub fn rolling(shift: f64, speed: f64) -> Input {
    let mut input = Input::default();
    input.wheel.position[1] += shift;
    input.wheel.velocity[0] = speed;
    input.wheel.pitch_rate = -speed / 0.46;
    input
}

/// Anything a right wheel may do on a rail that moves and rolls, pressed on it.
pub fn random_input(element: &mut Element, random: &mut Random) -> Input {
    let mut input = rolling(random.within(-5e-3, 8e-3), random.about(60.0));
    let wheel = &mut input.wheel;
    wheel.position[0] = random.about(0.02);
    (wheel.roll, wheel.yaw, wheel.pitch) =
        (random.about(0.01), random.about(0.03), random.about(3.0));
    wheel.velocity[1] = random.about(0.3);
    wheel.velocity[2] = random.about(0.02);
    (wheel.roll_rate, wheel.yaw_rate) = (random.about(0.05), random.about(0.1));
    wheel.pitch_rate *= 1.0 + random.about(1.0).powi(3) * 0.02;
    input.rails[0] = RailMotion {
        y: random.about(2e-3),
        z: random.about(2e-3),
        roll: random.about(0.02),
        vy: random.about(0.1),
        vz: random.about(0.02),
        roll_rate: random.about(0.1),
        // Without effect on straight rails.
        pitch_rate: 3.0,
    };
    input.friction = random.within(0.05, 0.6);
    (input.tread_friction, input.gauge_face_friction) = (input.friction, 0.4 * input.friction);
    let depth = random.within(0.0, 1.2e-4);
    pressed(element, &input, depth)
}

/// Marker of the right rail in design position.
pub fn rail_marker(parameters: &Parameters) -> [f64; 3] {
    let rail = &parameters.rails[0];
    let profile = load_profile("rail", &rail.profile, ProfileKind::Rail, 0.0, &[]).unwrap();
    let placed = PlacedRail::by_gauge(
        &profile.curve,
        rail.inclination,
        parameters.gauge,
        parameters.gauge_depth,
        false,
    );
    let [y, z] = placed.unwrap().marker;
    [0.0, y, z]
}

/// The only patch of an evaluation.
pub fn the_patch(output: &Output) -> Patch {
    assert_eq!(output.patch_count, 1, "{output:?}");
    output.patches[0]
}

/// The inputs of a left wheel that is the mirror image of a right one.
pub fn mirrored(input: &Input) -> Input {
    let mut left = *input;
    let wheel = &mut left.wheel;
    for value in [
        &mut wheel.position[1],
        &mut wheel.velocity[1],
        &mut wheel.roll,
        &mut wheel.yaw,
        &mut wheel.roll_rate,
        &mut wheel.yaw_rate,
    ] {
        *value = -*value;
    }
    for rail in &mut left.rails {
        for value in [&mut rail.y, &mut rail.roll, &mut rail.vy, &mut rail.roll_rate] {
            *value = -*value;
        }
    }
    left
}

/// Tables of the reference.
pub const FRICTION_TABLES: [&str; 2] = [
    "inclination_deg friction\n-20 0.20\n-10 0.30\n",
    "inclination_deg friction\n-45 0.15\n-25 0.40\n0 0.35\n",
];

/// A wheel with S1002 profile and `parameters` on the arcs of the Manchester benchmark's rail,
/// which are within 1.5 µm of its points on the top and 6 µm at the corners; both of the
/// reference's steel.
pub fn benchmark(parameters: Parameters) -> Element {
    let mut parameters = parameters;
    parameters.wheel.young_modulus = STEEL.young_modulus;
    parameters.wheel.poisson_ratio = STEEL.poisson_ratio;
    parameters.rail_young_modulus = STEEL.young_modulus;
    parameters.rail_poisson_ratio = STEEL.poisson_ratio;
    let wheel = load_profile("wheel.profile", "S1002", ProfileKind::Wheel, 0.0, &[]).unwrap();
    // Radius and half width of the arcs, radius of the corners, half width of the head.
    let arcs = [[0.3, 0.010_499_81], [0.08, 0.025_988_03]];
    let rail = Profile::rail_from_arcs("benchmark", &arcs, 0.013, 0.034);
    let start = Input::default();
    let start = if parameters.side == Side::Left { mirrored(&start) } else { start };
    Element::with_profiles(&parameters, &start, &wheel, &[Some(rail), None]).unwrap()
}

/// The wheel 0.75 m to the right of the centre of a wheelset in the state of a row, under its load.
pub fn of_wheelset(v: &dyn Fn(&str) -> f64) -> Input {
    let ((sin_roll, cos_roll), (sin_yaw, cos_yaw)) =
        (v("roll_ws_rad").sin_cos(), v("yaw_ws_rad").sin_cos());
    let arm = [-sin_yaw, cos_yaw * cos_roll, cos_yaw * sin_roll].map(|u| 0.75 * u);
    let (roll_rate, yaw_rate) = (v("v_roll_rad_s"), v("v_yaw_rad_s"));
    // The pitch does not move the wheel marker.
    let turning = [roll_rate, -sin_roll * yaw_rate, cos_roll * yaw_rate];
    let mut input = Input { wheel_load: v("fz_rail_total_N"), friction: 0.3, ..Input::default() };
    let wheel = &mut input.wheel;
    (wheel.roll, wheel.yaw) = (v("roll_ws_rad"), v("yaw_ws_rad"));
    wheel.position = [arm[0], 1e-3 * v("y_ws_mm") + arm[1], -0.46 + 1e-3 * v("z_ws_mm") + arm[2]];
    (wheel.roll_rate, wheel.yaw_rate) = (roll_rate, yaw_rate);
    wheel.pitch_rate = v("v_pitch_rad_s");
    wheel.velocity = [
        1e-3 * v("v_s_mm_s") + turning[1] * arm[2] - turning[2] * arm[1],
        1e-3 * v("v_y_mm_s") + turning[2] * arm[0] - turning[0] * arm[2],
        1e-3 * v("v_z_mm_s") + turning[0] * arm[1] - turning[1] * arm[0],
    ];
    input
}

/// The wheel on a `side` of the Manchester benchmark's wheelset in the state of a row, its centre
/// at (0, y, -R0), turned by R_x(roll) R_z(yaw), under 10 kN.
pub fn of_manchester(v: &dyn Fn(&str) -> f64, side: Side) -> Input {
    let arm = if side == Side::Left { -0.75 } else { 0.75 };
    let (roll, yaw) = (v("roll_rad"), v("yaw_rad"));
    let mut input = Input { wheel_load: 1e4, friction: 0.3, ..Input::default() };
    input.wheel.position = [
        -arm * yaw.sin(),
        1e-3 * v("y_ws_mm") + arm * yaw.cos() * roll.cos(),
        -0.46 + arm * yaw.cos() * roll.sin(),
    ];
    (input.wheel.roll, input.wheel.yaw) = (roll, yaw);
    input.wheel.pitch_rate = v("pitch_vel_rad_s");
    input.wheel.velocity = [2.0, 0.0, 0.0];
    input
}
