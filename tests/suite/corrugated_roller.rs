//! Rollers of rigs that are corrugated: their arc on top is the station.

use crate::allocations;
use crate::common;
use crate::tolerance;
use std::f64::consts::{PI, TAU};
use std::fs;

use crate::common::vectors::assert_balanced;
use crate::common::wheel::{evaluate, rolling, the_patch};
use approx::assert_relative_eq;
use tempfile::TempDir;
use wheelrail::element::parameters::{NormalModel, Placement, Side, TangentialModel, VerticalMode};
use wheelrail::element::{Element, Input, Output, Parameters};

const ROLLER: f64 = 0.8;
const WHEEL: f64 = 0.46;
/// Place of the highest point [m].
const PLACE: [f64; 2] = [0.75, 0.02];
const NORMAL_MODELS: [NormalModel; 3] =
    [NormalModel::Strips, NormalModel::PiotrowskiKik, NormalModel::Hertz];

/// A cylinder on a roller with a crown and `count` waves around it; without friction.
fn smooth(radius: f64, amplitude: f64, count: f64) -> Parameters {
    let mut parameters = Parameters::default();
    parameters.wheel.profile = "cylindrical".into();
    let rail = &mut parameters.rails[0];
    rail.profile = "arc:0.3".into();
    (rail.placement, rail.position, rail.inclination) = (Placement::Position, PLACE, 0.0);
    rail.roller_radius = radius;
    let wave = &mut rail.corrugation;
    (wave.amplitude, wave.wavelength) = (amplitude, TAU * radius / count);
    parameters.tangential_model = TangentialModel::None;
    parameters
}

/// S1002 on 60E1 around a roller.
fn corrugated(amplitude: f64, count: f64) -> Parameters {
    let mut parameters = Parameters::default();
    let rail = &mut parameters.rails[0];
    rail.roller_radius = ROLLER;
    let wave = &mut rail.corrugation;
    (wave.amplitude, wave.wavelength, wave.phase) = (amplitude, TAU * ROLLER / count, 0.4);
    parameters
}

fn element(parameters: &Parameters) -> Element {
    common::wheel::element(parameters)
}

/// A wheel that stands still at `x` above the arc `top` of a roller and rolls at `speed` with it.
fn on_rig([x, top]: [f64; 2], speed: f64) -> Input {
    let mut input = rolling(0.0, speed);
    input.wheel.position[0] = x;
    input.wheel.velocity[0] = 0.0;
    input.rails[0].pitch_rate = speed / ROLLER;
    input.track_s = top;
    input
}

#[test]
fn a_wheel_stands_on_the_crests_that_a_scan_of_wheel_and_roller_finds() {
    // The last one is hollow for the wheel between its crests; the first one only turns off centre.
    for (amplitude, count) in [(1e-3, 1.0), (2e-5, 50.0), (1e-5, 152.0), (5e-5, 152.0)] {
        let mut element = element(&smooth(ROLLER, amplitude, count));
        for (i, x) in [-0.04, 0.0, 0.013, 0.06].into_iter().enumerate() {
            for step in 0..12 {
                let top = 0.0013 * f64::from(step) + 0.4 * i as f64;
                let distance = |angle: f64| {
                    let wave = (count / ROLLER * (top + ROLLER * angle)).cos();
                    let r = ROLLER + amplitude * wave;
                    let to = r * angle.sin() - x;
                    PLACE[1] + ROLLER - r * angle.cos() - (WHEEL * WHEEL - to * to).sqrt()
                };
                let scan = (-40_000..=40_000).map(|k| distance(4e-6 * f64::from(k)));
                let scan = scan.fold(f64::INFINITY, f64::min);
                let touch = element.touching_height(&on_rig([x, top], 0.0));
                assert_relative_eq!(touch, scan, epsilon = 1e-9);
            }
        }
        // On top of a crest.
        let touch = element.touching_height(&on_rig([0.0, 0.0], 0.0));
        assert_relative_eq!(touch, PLACE[1] - WHEEL - amplitude, epsilon = 1e-9);
    }
}

#[test]
fn a_large_roller_that_turns_is_a_corrugated_rail_under_a_wheel_that_rolls_on() {
    let folder = TempDir::new().unwrap();
    let table = "station_m,profile\n-1,arc:0.3\n-0.02,arc:0.3\n0.03,arc:0.3\n2,arc:0.3\n";
    fs::write(folder.path().join("rail.csv"), table).unwrap();
    let speed = 20.0;
    // Height, place, pressure, forward and vertical force against the rail, over those of a wheel
    // on one without corrugation where they have a size.
    let worst = [10.0, 100.0].map(|radius: f64| {
        let count = (TAU * radius / 0.05).round();
        let mut round = smooth(radius, 1e-5, count);
        round.tangential_model = Parameters::default().tangential_model;
        let mut straight = round.clone();
        straight.rails[0].roller_radius = 0.0;
        straight.rails[0].profile = "rail.csv".into();
        let mut round = element(&round);
        let folders = [folder.path().to_path_buf()];
        let mut straight = Element::new(&straight, &Input::default(), &folders).unwrap();
        let mut worst = [0.0_f64; 5];
        for i in 0..20 {
            let mut rolls = rolling(0.0, speed);
            rolls.track_s = 2.6e-3 * f64::from(i);
            rolls.wheel.position[2] = PLACE[1] - WHEEL + 8e-5;
            let mut stands = rolls;
            stands.wheel.velocity[0] = 0.0;
            stands.rails[0].pitch_rate = speed / radius;
            let heights = straight.touching_height(&rolls) - round.touching_height(&stands);
            let (one, other) = (evaluate(&mut straight, &rolls), evaluate(&mut round, &stands));
            let [a, b] = [&one, &other].map(the_patch);
            let force = one.wheel.force[2];
            let errors = [
                heights / 1e-6,
                (a.position[0] - b.position[0]) / 1e-3,
                a.max_pressure / b.max_pressure - 1.0,
                (one.wheel.force[0] - other.wheel.force[0]) / (0.3 * force),
                other.wheel.force[2] / force - 1.0,
            ];
            worst = [0, 1, 2, 3, 4].map(|k| worst[k].max(errors[k].abs()));
        }
        println!("{radius}: {worst:?}");
        worst
    });
    let [near, far] = worst;
    for k in 0..5 {
        // The errors go with the curvature of the roller: a tenth, but for what they are at the
        // end, a twentieth of a micrometre, a micrometre and five parts in ten thousand.
        assert!(far[k] < 5e-4 || far[k] < 0.2 * near[k], "{k}: {near:?} {far:?}");
        assert!(far[k] < 0.05, "{k}: {far:?}");
    }
}

#[test]
fn a_roller_that_turns_its_crests_up_closes_as_a_wheel_does_that_comes_down() {
    let speed = 20.0;
    for normal_model in NORMAL_MODELS {
        let mut parameters = smooth(ROLLER, 1e-5, 100.0);
        let wavelength = parameters.rails[0].corrugation.wavelength;
        (parameters.normal_model, parameters.damping) = (normal_model, 2e5);
        let mut element = element(&parameters);
        let mut felt: f64 = 0.0;
        for i in 0..12 {
            let place = [0.0, 4.2e-3 * f64::from(i)];
            let mut turning = on_rig(place, speed);
            let touch = element.touching_height(&turning);
            turning.wheel.position[2] = touch + 8e-5;
            let mut still = on_rig(place, 0.0);
            still.wheel.position[2] = turning.wheel.position[2];
            let h = 1e-6;
            let [before, after] =
                [-h, h].map(|by| element.touching_height(&on_rig([place[0], place[1] + by], 0.0)));
            // The speed at which the wheel has to go down so as to stay at its depth.
            let follows = speed * (after - before) / (2.0 * h);
            let force =
                |element: &mut Element, input: &Input| evaluate(element, input).wheel.force[2];
            let undamped = force(&mut element, &still);
            let lifted = force(&mut element, &turning);
            still.wheel.velocity[2] = -follows;
            let lowered = force(&mut element, &still);
            turning.wheel.velocity[2] = follows;
            let followed = force(&mut element, &turning);
            felt = felt.max((lifted / undamped - 1.0).abs());
            let part = |force: f64| force / undamped - 1.0;
            // The mean slope under the pressure of Piotrowski and Kik is less than that of the wave
            // where it is touched, under half an ellipse by about (π L/λ)²/8; over the square of the
            // overlap of strips, which goes farther than their load, by (π L/λ)²/7.
            let part_of_square = match normal_model {
                NormalModel::PiotrowskiKik => 8.0,
                NormalModel::Strips => 7.0,
                _ => f64::INFINITY,
            };
            let length = evaluate(&mut element, &still).patches[0].length;
            let share = (PI * length / wavelength).powi(2) / part_of_square;
            // The places of touch of a wheel that is pressed are a little beside the first one, and
            // strips each have one of their own.
            let most = 2e-3 + share * part(lowered).abs();
            assert_relative_eq!(part(lifted), part(lowered), epsilon = most);
            assert_relative_eq!(part(followed), 0.0, epsilon = most);
        }
        assert!(felt > 0.05, "{felt}");
    }
}

#[test]
fn a_round_roller_closes_no_gap_by_turning() {
    let mut parameters = smooth(ROLLER, 0.0, 100.0);
    parameters.damping = 2e5;
    let mut element = element(&parameters);
    for x in [0.0, 0.03] {
        let mut input = on_rig([x, 0.3], 20.0);
        input.wheel.position[2] = element.touching_height(&input) + 8e-5;
        let turning = evaluate(&mut element, &input).wheel.force[2];
        input.rails[0].pitch_rate = 0.0;
        let still = evaluate(&mut element, &input).wheel.force[2];
        assert_relative_eq!(turning, still, max_relative = 1e-12);
    }
}

#[test]
fn frictionless_forces_of_a_corrugated_roller_have_an_energy() {
    // The change of the vertical force with the arc on top is that of the roller's torque with the
    // height.
    for normal_model in NORMAL_MODELS {
        let mut parameters = smooth(ROLLER, 5e-5, 20.0);
        (parameters.normal_model, parameters.damping) = (normal_model, 0.0);
        let mut element = element(&parameters);
        for (x, top) in [(0.0, 0.03), (0.02, 0.06), (-0.03, 0.2)] {
            let mut input = on_rig([x, top], 0.0);
            let height = element.touching_height(&input) + 1e-4;
            // Vertical force on the wheel, and work on the roller by its arc.
            let mut force = |arc: f64, down: f64| {
                input.track_s = top + arc;
                input.wheel.position[2] = height + down;
                let output = evaluate(&mut element, &input);
                let roller = output.rails[0];
                let torque = roller.moment[1] - ROLLER * roller.force[0];
                [output.wheel.force[2], torque / ROLLER]
            };
            let (h, d) = (2e-6, 2e-7);
            let by_arc = (force(h, 0.0)[0] - force(-h, 0.0)[0]) / (2.0 * h);
            let by_height = (force(0.0, d)[1] - force(0.0, -d)[1]) / (2.0 * d);
            let scale = (force(0.0, d)[0] - force(0.0, -d)[0]).abs() / (2.0 * d);
            println!("{normal_model:?} {x}: {by_arc:e} {by_height:e} {scale:e}");
            // The greatest slope of the waves is 1/800.
            let allowed = tolerance::VARYING_ENERGY * 1.25e-3 * scale;
            assert!((by_arc - by_height).abs() < allowed, "{normal_model:?} {x} {top}");
        }
    }
}

#[test]
fn what_wheel_and_corrugated_roller_lose_is_the_frictional_power() {
    let mut parameters = corrugated(2e-5, 100.0);
    parameters.damping = 0.0;
    let mut element = element(&parameters);
    for i in 0..20 {
        let mut input = on_rig([1e-3 * f64::from(i % 3), 3.3e-3 * f64::from(i)], 20.0);
        input.wheel.pitch_rate *= 1.0 + 2e-4 * f64::from(i - 10);
        input.wheel.velocity[1] = 0.02 * f64::from(i % 5 - 2);
        input.wheel.position[2] = element.touching_height(&input) + 1e-4;
        let mut power = |input: &Input| {
            let output = evaluate(&mut element, input);
            let roller = output.rails[0];
            let torque = roller.moment[1] - ROLLER * roller.force[0];
            let (wheel, moved) = (output.wheel, input.wheel);
            let pushed: f64 = (0..3).map(|k| wheel.force[k] * moved.velocity[k]).sum();
            let turned = wheel.moment[1] * moved.pitch_rate + torque * input.rails[0].pitch_rate;
            (pushed + turned, output)
        };
        let (with, output) = power(&input);
        // The normal force is the same without friction.
        let (without, _) = power(&Input { friction: 0.0, ..input });
        let size = output.wheel.force[2].abs() * 20.0;
        assert!(output.frictional_power > 0.0);
        let lost = (with - without) / size;
        assert_relative_eq!(lost, -output.frictional_power / size, epsilon = tolerance::SIMILARITY);
    }
}

#[test]
fn a_corrugated_roller_turns_under_a_wheel_without_jumps() {
    for amplitude in [1e-5, 3e-5] {
        let mut parameters = corrugated(amplitude, 152.0);
        parameters.vertical_mode = VerticalMode::Load;
        let mut element = element(&parameters);
        let mut last: Vec<[f64; 3]> = Vec::new();
        let mut output = Output::default();
        let limit = 0.3 * 80e3;
        for i in 0..1200 {
            // Over the place where the arc begins again.
            let mut input = on_rig([2e-3, -0.03 + 5e-5 * f64::from(i)], 20.0);
            input.wheel_load = 80e3;
            element.evaluate(&input, &mut output).unwrap();
            let [fx, fy, _] = output.wheel.force.map(|force| force / limit);
            last.push([output.wheel_z, fx, fy]);
        }
        // As on rails that vary.
        let height = output.patches[0].penetration * tolerance::WALK_JUMPS[0] / 1.5;
        for window in last.windows(4) {
            let allowed = [height, tolerance::WALK_JUMPS[1], tolerance::WALK_JUMPS[1]];
            for (k, allowed) in allowed.into_iter().enumerate() {
                let [a, b, c, d] = [0, 1, 2, 3].map(|i| window[i][k]);
                let jump = (d - 3.0 * c + 3.0 * b - a).abs();
                assert!(jump < allowed, "{amplitude} {k}: {jump:e}");
            }
        }
    }
}

#[test]
fn heights_around_a_roller_come_again_after_a_turn() {
    let folder = TempDir::new().unwrap();
    let circumference = TAU * ROLLER;
    let heights = |count: u32| {
        (0..count).fold(String::from("station_m,height_mm\n"), |text, i| {
            let arc = circumference * f64::from(i) / 400.0;
            text + &format!("{arc:.9} {:.9}\n", 0.05 * (20.0 * arc / ROLLER).cos())
        })
    };
    fs::write(folder.path().join("around.csv"), heights(400)).unwrap();
    fs::write(folder.path().join("long.csv"), heights(402)).unwrap();
    let wave = smooth(ROLLER, 5e-5, 20.0);
    let mut file = smooth(ROLLER, 0.0, 20.0);
    file.rails[0].corrugation.file = "around.csv".into();
    let folders = [folder.path().to_path_buf()];
    let mut wave = element(&wave);
    let mut around = Element::new(&file, &Input::default(), &folders).unwrap();
    for top in [0.03, circumference - 0.01, circumference + 2e-3, 7.0 * circumference + 0.4, -0.7] {
        let input = on_rig([0.0, top], 0.0);
        let [one, other] = [&mut wave, &mut around].map(|e| e.touching_height(&input));
        // Splines through twenty points of a wave of 50 µm.
        assert_relative_eq!(one, other, epsilon = 2e-8);
    }
    file.rails[0].corrugation.file = "long.csv".into();
    let message = Element::new(&file, &Input::default(), &folders).unwrap_err().to_string();
    for part in ["rail[1].corrugation.file", "long.csv", "one turn of the roller, 5.026548 m"] {
        assert!(message.contains(part), "{message}");
    }
}

#[test]
fn waves_that_do_not_close_around_the_roller_are_refused_with_those_that_do() {
    let mut parameters = corrugated(1e-5, 152.0);
    for (wavelength, closes) in [(0.033_069_4, true), (0.033, false), (6.0, false), (0.03307, true)]
    {
        parameters.rails[0].corrugation.wavelength = wavelength;
        let made = Element::new(&parameters, &Input::default(), &[]);
        match (made, closes) {
            (Ok(_), true) => (),
            (Err(refused), false) => {
                let message = refused.to_string();
                let waves = if wavelength > 1.0 {
                    "1 of them are 5.0265"
                } else {
                    "152 of them are 0.03306939"
                };
                for part in ["rail[1].corrugation.wavelength", &wavelength.to_string(), waves] {
                    assert!(message.contains(part), "{message}");
                }
            }
            (made, _) => panic!("{wavelength}: {:?}", made.err()),
        }
    }
}

#[test]
fn forces_are_in_balance_and_the_left_side_is_a_mirror() {
    let mut parameters = corrugated(2e-5, 152.0);
    let mut right = element(&parameters);
    parameters.side = Side::Left;
    let mut left = element(&parameters);
    let marker = common::wheel::rail_marker(&parameters);
    for i in 0..20 {
        let mut input = on_rig([2e-3 * f64::from(i % 5 - 2), 2.1e-3 * f64::from(i)], 15.0);
        input.wheel.position[1] += 1e-3 * f64::from(i % 7 - 3);
        input.wheel.yaw = 2e-3 * f64::from(i % 3 - 1);
        input.wheel.position[2] = right.touching_height(&input) + 8e-5;
        assert_balanced([&mut right, &mut left], &input, marker, tolerance::SIMILARITY);
    }
}

#[test]
fn evaluations_on_a_corrugated_roller_allocate_nothing() {
    let models = NORMAL_MODELS.into_iter();
    for (model, mode) in
        models.flat_map(|m| [VerticalMode::Penetration, VerticalMode::Load].map(|mode| (m, mode)))
    {
        let mut parameters = corrugated(5e-5, 152.0);
        (parameters.vertical_mode, parameters.normal_model) = (mode, model);
        let mut element = element(&parameters);
        let (mut output, mut touched) = (Output::default(), 0);
        let before = allocations::count();
        for i in 0..100 {
            let t = f64::from(i);
            let mut input = on_rig([0.02 * (0.17 * t).sin(), 1e-3 * t], 20.0);
            input.wheel.position[1] += 5e-3 * (0.3 * t).sin();
            input.wheel.yaw = 0.02 * (0.7 * t).sin();
            input.wheel.position[2] = -0.46 + 4e-4 * (0.11 * t).sin();
            input.wheel_load = 5e4 * (0.2 * t).sin();
            element.evaluate(&input, &mut output).unwrap();
            touched += i32::from(output.patch_count > 0);
        }
        assert_eq!(allocations::count(), before);
        assert!(touched > 25, "{touched}");
    }
}
