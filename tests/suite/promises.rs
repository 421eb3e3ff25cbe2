//! What an element promises its host: no needless work, no memory of earlier inputs, refusals by
//! name.

use crate::common::random::Random;
use crate::common::wheel::{element, evaluate, pressed, random_input, rolling, the_patch};
use wheelrail::element::parameters::{CreepageModel, NormalModel, TangentialModel};
use wheelrail::element::{Element, Input, Output, Parameters};

#[test]
fn work_that_is_not_asked_for_is_not_done() {
    let cases = [
        ("no friction", Parameters::default(), 0.0),
        (
            "no tangential model",
            Parameters { tangential_model: TangentialModel::None, ..Parameters::default() },
            0.3,
        ),
    ];
    for (name, parameters, friction) in cases {
        let mut element = element(&parameters);
        let mut input = pressed(&mut element, &rolling(0.0, 20.0), 6e-5);
        input.wheel.velocity[1] = 0.1;
        input.friction = friction;
        let patch = the_patch(&evaluate(&mut element, &input));
        let work = element.work();
        assert_eq!((work.marches, work.zones, work.searches), (0, 1, 1), "{name}");
        assert!(patch.creep_force.iter().all(|f| f.abs() <= 0.0));
    }
    let mut element = element(&Parameters::default());
    let lifted = pressed(&mut element, &rolling(0.0, 20.0), -1e-3);
    let output = evaluate(&mut element, &lifted);
    let work = element.work();
    assert_eq!((work.lifted, work.searches, work.distances), (1, 0, 0));
    let mut expected = Output::default();
    expected.wheel_z = lifted.wheel.position[2];
    assert_eq!(output, expected);
}

#[test]
fn an_evaluation_depends_on_its_input_alone() {
    for (normal_model, creepage_model) in [
        (NormalModel::PiotrowskiKik, CreepageModel::Flat),
        (NormalModel::PiotrowskiKikCorrected, CreepageModel::Curved),
        (NormalModel::Hertz, CreepageModel::Curved),
    ] {
        let parameters = Parameters { normal_model, creepage_model, ..Parameters::default() };
        let mut element = element(&parameters);
        let mut random = Random::new(8);
        let inputs: Vec<Input> = (0..60).map(|_| random_input(&mut element, &mut random)).collect();
        // The text of a number tells its bits, and the sign of a zero too.
        let first: Vec<String> =
            inputs.iter().map(|i| format!("{:?}", evaluate(&mut element, i))).collect();
        for (input, expected) in inputs.iter().zip(&first).rev() {
            assert_eq!(&format!("{:?}", evaluate(&mut element, input)), expected);
        }
        let mut copy = element.clone();
        for (input, expected) in inputs.iter().zip(&first) {
            assert_eq!(&format!("{:?}", evaluate(&mut copy, input)), expected);
        }
    }
}

#[test]
fn an_input_that_is_no_number_is_refused_by_name_and_leaves_the_output() {
    type Place = fn(&mut Input) -> &mut f64;
    let places: [(&str, Place); 21] = [
        ("wheel.x", |i| &mut i.wheel.position[0]),
        ("wheel.y", |i| &mut i.wheel.position[1]),
        ("wheel.z", |i| &mut i.wheel.position[2]),
        ("wheel.roll", |i| &mut i.wheel.roll),
        ("wheel.yaw", |i| &mut i.wheel.yaw),
        ("wheel.pitch", |i| &mut i.wheel.pitch),
        ("wheel.vx", |i| &mut i.wheel.velocity[0]),
        ("wheel.vy", |i| &mut i.wheel.velocity[1]),
        ("wheel.vz", |i| &mut i.wheel.velocity[2]),
        ("wheel.roll_rate", |i| &mut i.wheel.roll_rate),
        ("wheel.yaw_rate", |i| &mut i.wheel.yaw_rate),
        ("wheel.pitch_rate", |i| &mut i.wheel.pitch_rate),
        ("wheel.load", |i| &mut i.wheel_load),
        ("rail[1].y", |i| &mut i.rails[0].y),
        ("rail[1].z", |i| &mut i.rails[0].z),
        ("rail[1].roll", |i| &mut i.rails[0].roll),
        ("rail[1].vy", |i| &mut i.rails[0].vy),
        ("rail[1].vz", |i| &mut i.rails[0].vz),
        ("rail[1].roll_rate", |i| &mut i.rails[0].roll_rate),
        ("track.s", |i| &mut i.track_s),
        ("friction.coefficient", |i| &mut i.friction),
    ];
    let mut element = element(&Parameters::default());
    let input = pressed(&mut element, &rolling(0.0, 20.0), 6e-5);
    let before = evaluate(&mut element, &input);
    for (name, place) in places {
        for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
            let mut wrong = input;
            *place(&mut wrong) = bad;
            let mut output = before;
            let message = element.evaluate(&wrong, &mut output).unwrap_err().to_string();
            assert!(message.contains(name), "{message}");
            assert_eq!(output, before);
        }
    }
    let mut wrong = input;
    wrong.friction = -0.1;
    let message = element.evaluate(&wrong, &mut Output::default()).unwrap_err().to_string();
    assert!(message.contains("friction.coefficient") && message.contains("-0.1"), "{message}");
    assert_eq!(evaluate(&mut element, &input), before);
}

#[test]
fn a_wrong_parameter_is_refused_by_name_and_value() {
    type Change = fn(&mut Parameters);
    let wrong: [(&str, &str, Change); 16] = [
        ("wheel.nominal_radius", "-0.46", |p| p.wheel.nominal_radius = -0.46),
        ("wheel.nominal_radius", "NaN", |p| p.wheel.nominal_radius = f64::NAN),
        ("wheel.young_modulus", "0", |p| p.wheel.young_modulus = 0.0),
        ("wheel.poisson_ratio", "0.6", |p| p.wheel.poisson_ratio = 0.6),
        ("rail.young_modulus", "inf", |p| p.rail_young_modulus = f64::INFINITY),
        ("rail.poisson_ratio", "-0.1", |p| p.rail_poisson_ratio = -0.1),
        ("rail[1].inclination", "40", |p| p.rails[0].inclination = 40.0),
        ("track.gauge", "0", |p| p.gauge = 0.0),
        ("track.gauge_depth", "-0.014", |p| p.gauge_depth = -0.014),
        ("profile.smoothing", "-2", |p| p.profile_smoothing = -2.0),
        ("normal.virtual_penetration", "1", |p| p.virtual_penetration = 1.0),
        ("normal.strips", "3", |p| p.strips = 3),
        ("normal.damping", "-1", |p| p.damping = -1.0),
        ("creepage.minimum_speed", "0", |p| p.minimum_speed = 0.0),
        ("tangential.elements_along", "201", |p| p.elements_along = 201),
        ("wheel.profile", "no_such_wheel", |p| p.wheel.profile = "no_such_wheel".into()),
    ];
    for (name, value, change) in wrong {
        let mut parameters = Parameters::default();
        change(&mut parameters);
        let message = Element::new(&parameters, &Input::default(), &[]).unwrap_err().to_string();
        assert!(message.contains(name) && message.contains(value), "{name}: {message}");
    }
}
