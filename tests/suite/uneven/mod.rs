//! Corrugated rails, out-of-round wheels and flats: places of contact, forces and what follows from
//! them.

mod on_flats;
mod passage;

use crate::tolerance;
use std::f64::consts::TAU;

use crate::common::random::Random;
use crate::common::wheel::{element, evaluate, plain_parameters, pressed, random_input, rolling};
use wheelrail::element::parameters::{FlatShape, NormalModel, TangentialModel};
use wheelrail::element::{Element, Input, Output, Parameters};
use wheelrail::geometry::profile::ProfileKind;
use wheelrail::geometry::rail::placed_rail::PlacedRail;
use wheelrail::io::load_profile;

fn corrugated(amplitude: f64, wavelength: f64) -> Parameters {
    let mut parameters = Parameters::default();
    let corrugation = &mut parameters.rails[0].corrugation;
    (corrugation.amplitude, corrugation.wavelength) = (amplitude, wavelength);
    parameters
}

fn with_flat(length: f64, shape: FlatShape) -> Parameters {
    let mut parameters = Parameters::default();
    (parameters.wheel.flat.length, parameters.wheel.flat.shape) = (length, shape);
    parameters
}

/// Deviations of every kind, with a smooth profile pair.
fn all_kinds() -> Vec<Parameters> {
    let mut out_of_round = Parameters::default();
    (out_of_round.wheel.out_of_round.amplitude, out_of_round.wheel.out_of_round.order) = (3e-4, 6);
    let mut both = with_flat(0.04, FlatShape::Worn);
    both.rails[0].corrugation.amplitude = 3e-5;
    vec![
        corrugated(2e-5, 0.033),
        corrugated(6e-5, 0.033),
        out_of_round,
        with_flat(0.05, FlatShape::Fresh),
        with_flat(0.06, FlatShape::Worn),
        both,
    ]
}

/// A place along the track and a turn of the wheel near the deviations of [`all_kinds`].
fn anywhere(input: &mut Input, random: &mut Random) {
    input.track_s = random.about(0.05);
    input.wheel.pitch = random.about(0.1);
}

#[test]
fn deviations_that_vanish_change_nothing() {
    let mut random = Random::new(71);
    for normal_model in [NormalModel::PiotrowskiKik, NormalModel::Hertz, NormalModel::Strips] {
        let mut even = element(&Parameters { normal_model, ..Parameters::default() });
        let uneven = Parameters { normal_model, ..corrugated(1e-13, 0.033) };
        let mut uneven = element(&uneven);
        let (mut worst, mut others) = (0f64, 0);
        for _ in 0..60 {
            let mut input = random_input(&mut even, &mut random);
            input.track_s = random.about(1.0);
            let (a, b) = (evaluate(&mut even, &input), evaluate(&mut uneven, &input));
            // An overlap without a minimum of its own is taken at a step of the search, which is
            // finer here.
            let same =
                |k: usize| (a.patches[k].penetration - b.patches[k].penetration).abs() < 1e-9;
            if !(0..8).all(same) {
                others += 1;
                continue;
            }
            let size = a.patches[0].normal_force.max(1.0);
            for k in 0..3 {
                let miss = (a.wheel.force[k] - b.wheel.force[k]).abs() / size;
                worst = worst.max(miss);
            }
        }
        println!("{normal_model:?}: {worst:e}");
        assert!(worst < tolerance::VANISHING_DEVIATIONS, "{normal_model:?}: {worst:e}");
        assert!(others <= 3, "{others} contacts at other places");
    }
}

#[test]
fn the_depth_is_that_of_the_real_surfaces() {
    let mut random = Random::new(72);
    let curve = load_profile("wheel", "S1002", ProfileKind::Wheel, 0.0, &[]).unwrap().curve;
    let rail = load_profile("rail", "60E1", ProfileKind::Rail, 0.0, &[]).unwrap();
    let rail = PlacedRail::by_gauge(&rail.curve, 0.025, 1.435, 0.014, false).unwrap();
    let radius = 0.46;
    let amplitude = 5e-5;
    let mut parameters = corrugated(amplitude, 0.03);
    (parameters.wheel.out_of_round.amplitude, parameters.wheel.out_of_round.order) = (2e-4, 9);
    let mut element = element(&parameters);
    let mut worst = 0f64;
    for (index, shift) in [-3e-3, 1e-3, 7.5e-3, -2e-3, 8e-3, 3e-3].into_iter().enumerate() {
        let mut input = rolling(shift, 20.0);
        anywhere(&mut input, &mut random);
        input.wheel.yaw = if index < 3 { 0.0 } else { random.about(0.015) };
        let input = pressed(&mut element, &input, 6e-5);
        let output = evaluate(&mut element, &input);
        let found = output.patches.iter().map(|p| p.penetration).fold(0.0, f64::max);
        let (sine, cosine) = input.wheel.yaw.sin_cos();
        // Distance of a point of the wheel from the rail below it, each with its deviation.
        let distance = |s: f64, angle: f64| {
            let [profile_y, profile_z] = curve.at(s).point;
            let own = 2e-4 * (9.0 * (angle - input.wheel.pitch)).cos();
            let r = radius + profile_z + own;
            let (along, down) = (r * angle.sin(), r * angle.cos());
            let x = cosine * along - sine * profile_y;
            let y = sine * along + cosine * profile_y + input.wheel.position[1] - rail.marker[0];
            let height = amplitude * (TAU * (input.track_s + x) / 0.03).cos();
            let z = input.wheel.position[2] + down + height;
            rail.nearest([y, z], rail.coarse_nearest([y, z]), 1e-12).distance
        };
        let (mut s_middle, mut s_half, mut a_middle, mut a_half) = (0.075, 0.06, 0.0, 0.1);
        let mut best = f64::INFINITY;
        for pass in 0..7 {
            let count = if pass == 0 { 300 } else { 40 };
            let (mut s_best, mut a_best) = (s_middle, a_middle);
            for i in -count..=count {
                let s = s_middle + s_half * f64::from(i) / f64::from(count);
                for j in -count..=count {
                    let angle = a_middle + a_half * f64::from(j) / f64::from(count);
                    let d = distance(s, angle);
                    if d < best {
                        (best, s_best, a_best) = (d, s, angle);
                    }
                }
            }
            (s_middle, a_middle) = (s_best, a_best);
            (s_half, a_half) = (5.0 * s_half / f64::from(count), 5.0 * a_half / f64::from(count));
        }
        println!("shift {shift}, yaw {}: {found:e}, surfaces {:e}", input.wheel.yaw, -best);
        worst = worst.max((found + best).abs());
    }
    assert!(worst < tolerance::UNEVEN_DEPTH, "{worst:e}");
}

#[test]
fn on_a_long_wave_crest_and_trough_are_a_smaller_and_a_larger_wheel() {
    let radius = 0.46;
    for (phase, sign) in [(0.0, 1.0), (0.5 * TAU, -1.0)] {
        let mut parameters = plain_parameters("cylindrical", "arc:0.3");
        let (amplitude, wavelength) = (4e-3, 0.5);
        let corrugation = &mut parameters.rails[0].corrugation;
        (corrugation.amplitude, corrugation.wavelength, corrugation.phase) =
            (amplitude, wavelength, phase);
        let mut uneven = element(&parameters);
        let wave: f64 = TAU / wavelength;
        let mut even = plain_parameters("cylindrical", "arc:0.3");
        even.wheel.nominal_radius = 1.0 / (1.0 / radius + sign * amplitude * wave * wave);
        let mut start = rolling(-0.03, 0.0);
        start.wheel.pitch_rate = 0.0;
        let mut even = Element::new(&even, &start, &[]).unwrap();
        let [a, b] = [&mut uneven, &mut even].map(|element| {
            let input = pressed(element, &start, 6e-5);
            evaluate(element, &input).patches[0]
        });
        for (a, b) in [
            (a.normal_force, b.normal_force),
            (a.max_pressure, b.max_pressure),
            (a.area, b.area),
            (a.length, b.length),
        ] {
            assert!((a / b - 1.0).abs() < tolerance::LONG_WAVE, "{a} {b}");
        }
    }
}

#[test]
fn a_round_wheel_feels_no_torque_and_an_even_rail_no_push_along_the_track() {
    let mut random = Random::new(73);
    for mut parameters in all_kinds() {
        parameters.tangential_model = TangentialModel::None;
        let round =
            parameters.wheel.flat.length <= 0.0 && parameters.wheel.out_of_round.amplitude <= 0.0;
        let even = parameters.rails[0].corrugation.amplitude <= 0.0;
        let mut element = element(&parameters);
        for _ in 0..15 {
            let mut input = rolling(random.within(-4e-3, 4e-3), 0.0);
            anywhere(&mut input, &mut random);
            let input = pressed(&mut element, &input, 6e-5);
            let output = evaluate(&mut element, &input);
            let size = output.patches[0].normal_force;
            assert!(size > 1e3);
            if round {
                let torque = output.wheel.moment[1].abs();
                assert!(torque < tolerance::FREE_TORQUE * size, "{torque} N m of {size} N");
            }
            if even {
                let push = output.wheel.force[0].abs();
                assert!(push <= f64::EPSILON * size, "{push} N of {size} N");
            }
            // And the rail gets what the wheel gives.
            for k in 0..3 {
                assert!((output.wheel.force[k] + output.rails[0].force[k]).abs() < 1e-6);
            }
        }
    }
}

#[test]
fn the_closing_speed_is_the_rate_of_the_depth() {
    let mut random = Random::new(74);
    // An ellipse closes at its point; strips on their mean.
    for mut parameters in all_kinds() {
        parameters.normal_model = NormalModel::Hertz;
        let damped_parameters = Parameters { damping: 1e4, ..parameters.clone() };
        let free_parameters = Parameters { damping: 0.0, ..parameters };
        let (mut damped, mut free) = (element(&damped_parameters), element(&free_parameters));
        for _ in 0..8 {
            let mut input = rolling(random.within(-4e-3, -1e-3), 10.0);
            anywhere(&mut input, &mut random);
            input.wheel.position[0] = random.about(0.1);
            let input = pressed(&mut free, &input, 8e-5);
            let depth = |element: &mut Element, dt: f64| {
                let mut later = input;
                later.wheel.position[0] += 10.0 * dt;
                later.wheel.pitch += input.wheel.pitch_rate * dt;
                evaluate(element, &later).patches[0].penetration
            };
            let (a, b) = (evaluate(&mut damped, &input), evaluate(&mut free, &input));
            if a.patch_count != 1 || a.patches[0].normal_force <= 0.0 {
                continue;
            }
            let dt = 1e-8;
            let rate = (depth(&mut free, dt) - depth(&mut free, -dt)) / (2.0 * dt);
            let (load, penetration) = (b.patches[0].normal_force, b.patches[0].penetration);
            let expected = wheelrail::normal::damping::damped_load(load, penetration, rate, 1e4);
            let found = a.patches[0].normal_force;
            assert!(
                (found - expected).abs() < tolerance::CLOSING_RATE * load,
                "{found} against {expected} at a rate of {rate} m/s"
            );
        }
    }
}

#[test]
fn a_wheel_on_a_fresh_flat_rolls_over_its_corners() {
    let mut parameters = plain_parameters("cylindrical", "arc:0.3");
    (parameters.wheel.flat.length, parameters.wheel.flat.angle) = (0.05, 0.3);
    let mut start = Input::default();
    start.wheel.position[1] = 0.72;
    let mut element = Element::new(&parameters, &start, &[]).unwrap();
    let radius: f64 = 0.46;
    let half_angle = 0.5 * 0.05 / radius;
    let mut worst = 0f64;
    for step in -80..=80 {
        let from_flat = 1.5e-3 * f64::from(step);
        start.wheel.pitch = -(0.3 + from_flat);
        // A wheel on a corner stands as high as the corner leans.
        let lean = (half_angle - from_flat.abs()).max(0.0);
        let height = -element.touching_height(&start);
        worst = worst.max((height - radius * lean.cos()).abs());
    }
    println!("worst {worst:e} m of {:e} m", 0.05 * 0.05 / (8.0 * radius));
    assert!(worst < tolerance::FLAT_HEIGHT, "{worst:e}");
}

#[test]
fn in_a_trough_that_is_hollow_for_the_wheel_it_stands_on_two_patches() {
    let mut parameters = plain_parameters("cylindrical", "arc:0.3");
    // Strips have one stretch each.
    parameters.normal_model = NormalModel::PiotrowskiKik;
    parameters.wheel.nominal_radius = 0.5;
    let corrugation = &mut parameters.rails[0].corrugation;
    (corrugation.amplitude, corrugation.phase) = (1.2e-4, 0.5 * TAU);
    let mut start = rolling(-0.03, 0.0);
    start.wheel.position[2] = -0.5;
    let mut element = Element::new(&parameters, &start, &[]).unwrap();
    let light = pressed(&mut element, &start, 8e-6);
    let output = evaluate(&mut element, &light);
    assert_eq!(output.patch_count, 2, "{output:?}");
    let [front, back] = [output.patches[0], output.patches[1]];
    let apart = front.position[0] - back.position[0];
    assert!(apart.abs() > 5e-3, "ahead and behind: {apart}");
    assert!(
        (front.position[0] + back.position[0]).abs() < 1e-6,
        "{} {} N {} {}",
        front.position[0],
        back.position[0],
        front.normal_force,
        back.normal_force
    );
    assert!((front.normal_force / back.normal_force - 1.0).abs() < 1e-6);
    // Under load they grow into one, longer than that of the even rail.
    let heavy = pressed(&mut element, &start, 1.6e-4);
    let output = evaluate(&mut element, &heavy);
    assert_eq!(output.patch_count, 1);
    assert!(output.patches[0].length > 0.02 && output.patches[0].normal_force.is_finite());
}

#[test]
fn every_finite_place_and_turn_gives_a_finite_force() {
    let mut random = Random::new(75);
    for parameters in all_kinds() {
        let mut element = element(&parameters);
        for _ in 0..120 {
            let mut input = random_input(&mut element, &mut random);
            input.track_s = random.about(1e5);
            input.wheel.position[0] = random.about(1e4);
            input.wheel.pitch = random.about(1e6);
            input.wheel.yaw = random.about(0.2);
            input.wheel.position[2] += random.about(2e-3);
            let output = evaluate(&mut element, &input);
            let all = output.wheel.force.iter().chain(&output.wheel.moment);
            assert!(all.clone().all(|f| f.is_finite()), "{parameters:?}\n{input:?}");
        }
    }
}

#[test]
fn models_that_do_not_know_uneven_bodies_are_refused_by_name() {
    let refused = |change: fn(&mut Parameters)| {
        let mut parameters = corrugated(2e-5, 0.033);
        change(&mut parameters);
        Element::new(&parameters, &Input::default(), &[]).unwrap_err().to_string()
    };
    let text = refused(|p| p.normal_model = NormalModel::PiotrowskiKikCorrected);
    assert!(text.contains("normal.model") && text.contains("corrugation"), "{text}");
    let text = refused(|p| p.rails[0].corrugation.amplitude = 0.005);
    assert!(text.contains("rail[1].corrugation.wavelength"), "{text}");
    let text = refused(|p| p.wheel.flat.length = -0.1);
    assert!(text.contains("wheel.flat.length"), "{text}");
    let text = refused(|p| p.wheel.out_of_round.file = "nowhere.csv".into());
    assert!(text.contains("wheel.out_of_round.file") && text.contains("nowhere.csv"), "{text}");
}

#[test]
fn files_say_the_same_as_waves() {
    let folder = tempfile::tempdir().unwrap();
    let mut rail = String::from("station_m,height_mm\n");
    for i in -200..=200 {
        let s = 5e-4 * f64::from(i);
        rail += &format!("{s},{}\n", 0.04 * (TAU * s / 0.033).cos());
    }
    let mut wheel = String::from("angle_deg,radius_mm\n");
    for i in 0..720 {
        let angle = 0.5 * f64::from(i);
        wheel += &format!("{angle},{}\n", 0.2 * (5.0 * angle.to_radians()).cos());
    }
    std::fs::write(folder.path().join("rail.csv"), rail).unwrap();
    std::fs::write(folder.path().join("wheel.csv"), wheel).unwrap();
    let mut waves = corrugated(4e-5, 0.033);
    (waves.wheel.out_of_round.amplitude, waves.wheel.out_of_round.order) = (2e-4, 5);
    let mut files = Parameters::default();
    files.rails[0].corrugation.file = "rail.csv".into();
    files.wheel.out_of_round.file = "wheel.csv".into();
    let folders = [folder.path().to_path_buf()];
    let mut files = Element::new(&files, &Input::default(), &folders).unwrap();
    let mut waves = element(&waves);
    let mut random = Random::new(76);
    for _ in 0..20 {
        let mut input = rolling(random.within(-3e-3, 3e-3), 20.0);
        input.track_s = random.about(0.05);
        input.wheel.pitch = random.about(3.0);
        let input = pressed(&mut waves, &input, 6e-5);
        let (a, b): (Output, Output) = (evaluate(&mut waves, &input), evaluate(&mut files, &input));
        let ratio = b.patches[0].normal_force / a.patches[0].normal_force;
        assert!((ratio - 1.0).abs() < tolerance::DEVIATION_FILES, "{ratio}");
    }
}
