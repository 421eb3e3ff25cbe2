//! Wheels whose section varies around: slices and tables of sections.

mod flats;
mod rough;

use crate::allocations;
use crate::tolerance;
use std::f64::consts::{PI, TAU};
use std::fmt::Write;
use std::fs;

use crate::common::random::Random;
use crate::common::varying::{errors_on_flat, on_crown, wheel_with_flat};
use crate::common::vectors::{assert_balanced, cross};
use crate::common::wheel::{evaluate, rail_marker, random_input, rolling};
use crate::common::{median_and_worst, spread};
use approx::{assert_abs_diff_eq, assert_relative_eq};
use tempfile::TempDir;
use wheelrail::element::input::RailMotion;
use wheelrail::element::parameters::{NormalModel, Side, TangentialModel, VerticalMode, WearModel};
use wheelrail::element::{Element, Input, Output, Parameters};
use wheelrail::geometry::profile::ProfileKind;
use wheelrail::io::load_profile;

/// How far the wheel stands beside its axle [m].
const ECCENTRICITY: f64 = 5e-4;

fn element(parameters: &Parameters, folder: &TempDir) -> Element {
    Element::new(parameters, &Input::default(), &[folder.path().to_path_buf()]).unwrap()
}

fn with(profile: &str) -> Parameters {
    let mut parameters = Parameters { profile_smoothing: 0.0, ..Parameters::default() };
    parameters.wheel.profile = profile.into();
    parameters
}

/// A folder with a wheel S1002 in `round.txt`, and in `wheel.slcw` the same by slices every 5
/// degrees, turning about an axle beside its own: at angle 0 it reaches farthest.
pub fn eccentric() -> TempDir {
    let folder = TempDir::new().unwrap();
    let wheel = load_profile("wheel", "S1002", ProfileKind::Wheel, 0.0, &[]).unwrap();
    let (start, end) = (wheel.curve.start(), wheel.curve.end());
    let points: Vec<[f64; 2]> = (0..=500)
        .map(|i| wheel.curve.at(start + (end - start) * f64::from(i) / 500.0).point)
        .collect();
    let radius = Parameters::default().wheel.nominal_radius;
    let write = |name: &str, height: &dyn Fn(f64) -> f64| {
        let mut text = String::from("# mirror_z 0\n# mirror_y 0\n");
        for [y, z] in &points {
            writeln!(text, "{:.10} {:.10}", 1e3 * y, 1e3 * height(*z)).unwrap();
        }
        fs::write(folder.path().join(name), text).unwrap();
    };
    write("round.txt", &|z| z);
    let mut listed = String::new();
    for i in -36..36 {
        let angle = f64::from(i) * TAU / 72.0;
        let (sine, cosine) = angle.sin_cos();
        let file = format!("{}.txt", i + 36);
        write(&file, &|z| {
            let beside = ECCENTRICITY * sine;
            ECCENTRICITY * cosine + ((radius + z).powi(2) - beside * beside).sqrt() - radius
        });
        writeln!(listed, "{angle:.12} '{file}'").unwrap();
    }
    let text = format!("% offset and scale\n0 1\n72\n0 0 0\n1\n{listed}");
    fs::write(folder.path().join("wheel.slcw"), text).unwrap();
    folder
}

fn largest(numbers: &[f64]) -> f64 {
    numbers.iter().fold(0.0, |most, number| most.max(number.abs()))
}

fn apart(one: &[f64; 3], other: &[f64; 3]) -> f64 {
    largest(&[0, 1, 2].map(|i| one[i] - other[i]))
}

#[test]
fn sections_that_are_all_the_same_are_one_profile() {
    let folder = TempDir::new().unwrap();
    let table = "angle_deg,profile\n-180,S1002\n-60,S1002\n60,S1002\n180,S1002\n";
    fs::write(folder.path().join("wheel.csv"), table).unwrap();
    let models =
        [(NormalModel::Strips, 60), (NormalModel::Hertz, 60), (NormalModel::BoundaryElement, 10)];
    for (normal_model, poses) in models {
        let [mut even, mut varying] = ["S1002", "wheel.csv"].map(|profile| {
            let mut parameters = Parameters { normal_model, damping: 1e5, ..Parameters::default() };
            parameters.wheel.profile = profile.into();
            element(&parameters, &folder)
        });
        let mut random = Random::new(7);
        for _ in 0..poses {
            let mut input = random_input(&mut even, &mut random);
            input.wheel.pitch = random.about(20.0);
            // A search ends at a nanometre. On the flank of a yawed wheel, whose line leads there,
            // that turns the frame and the force with it.
            input.wheel.yaw = 0.0;
            let (one, other) = (evaluate(&mut even, &input), evaluate(&mut varying, &input));
            assert_eq!(one.patch_count, other.patch_count);
            let scale = largest(&one.wheel.force) * tolerance::SIMILARITY + tolerance::NO_FORCE;
            for i in 0..3 {
                assert_relative_eq!(one.wheel.force[i], other.wheel.force[i], epsilon = scale);
                assert_relative_eq!(one.wheel.moment[i], other.wheel.moment[i], epsilon = scale);
            }
        }
    }
}

#[test]
fn an_eccentric_wheel_is_a_round_one_beside_its_axle() {
    let folder = eccentric();
    let exact = [NormalModel::Strips, NormalModel::Hertz, NormalModel::PiotrowskiKik];
    let models = exact.map(|model| (model, 40, tolerance::ECCENTRIC));
    let elements = (NormalModel::BoundaryElement, 15, tolerance::ECCENTRIC_ELEMENTS);
    for (normal_model, poses, allowed) in models.into_iter().chain([elements]) {
        let of = |profile: &str| Parameters { normal_model, damping: 1e5, ..with(profile) };
        let mut varying = element(&of("wheel.slcw"), &folder);
        let mut round = element(&of("round.txt"), &folder);
        let mut random = Random::new(5);
        let mut errors = [Vec::new(), Vec::new()];
        for _ in 0..poses {
            let mut moved = random_input(&mut round, &mut random);
            moved.friction = 0.0;
            let pitch = random.about(PI);
            moved.wheel.pitch = pitch;
            let wheel = &moved.wheel;
            let ((sin_roll, cos_roll), (sin_yaw, cos_yaw)) =
                (wheel.roll.sin_cos(), wheel.yaw.sin_cos());
            let axle = [-sin_yaw, cos_yaw * cos_roll, cos_yaw * sin_roll];
            let down = [0.0, -sin_roll, cos_roll];
            let ahead = cross(axle, down);
            let beside = |forward: f64, downward: f64| -> [f64; 3] {
                std::array::from_fn(|i| ECCENTRICITY * (forward * ahead[i] + downward * down[i]))
            };
            let (sine, cosine) = pitch.sin_cos();
            let (to, way) = (beside(sine, cosine), beside(cosine, -sine));
            // Turning about the other axes moves the middle of the round wheel too.
            let mut input = moved;
            (moved.wheel.roll_rate, moved.wheel.yaw_rate) = (0.0, 0.0);
            (input.wheel.roll_rate, input.wheel.yaw_rate) = (0.0, 0.0);
            for i in 0..3 {
                input.wheel.position[i] -= to[i];
                moved.wheel.velocity[i] += moved.wheel.pitch_rate * way[i];
            }
            let (one, other) = (evaluate(&mut round, &moved), evaluate(&mut varying, &input));
            assert_eq!(one.patch_count, other.patch_count);
            let size = largest(&one.wheel.force) + 1e3;
            let moment = cross(to, one.wheel.force);
            let moment: [f64; 3] = std::array::from_fn(|i| one.wheel.moment[i] + moment[i]);
            errors[0].push(apart(&one.wheel.force, &other.wheel.force) / size);
            errors[1].push(apart(&moment, &other.wheel.moment) / size);
        }
        for (errors, allowed) in errors.into_iter().zip(allowed) {
            let found = median_and_worst(errors);
            assert!(found[0] <= allowed[0] && found[1] <= allowed[1], "{normal_model:?} {found:?}");
        }
    }
}

#[test]
fn an_eccentric_wheel_goes_up_and_down() {
    let folder = eccentric();
    let mut wheel = element(&with("wheel.slcw"), &folder);
    let mut round = element(&with("round.txt"), &folder);
    for i in 0..40 {
        let mut input = rolling(1e-3, 20.0);
        let even = round.touching_height(&input);
        input.wheel.pitch = -0.5 * f64::from(i);
        let expected = even - ECCENTRICITY * input.wheel.pitch.cos();
        assert_relative_eq!(wheel.touching_height(&input), expected, epsilon = 2e-9);
    }
}

#[test]
fn forces_on_wheel_and_rail_are_in_balance_and_the_left_side_is_a_mirror() {
    let folder = eccentric();
    let parameters = with("wheel.slcw");
    let mut right = element(&parameters, &folder);
    let mut left = element(&parameters.on_side(Side::Left), &folder);
    let marker = rail_marker(&with("S1002"));
    let mut random = Random::new(3);
    for _ in 0..30 {
        let mut input = random_input(&mut right, &mut random);
        input.rails[0] = RailMotion::default();
        input.wheel.position[2] = right.touching_height(&input) + 8e-5;
        let sides = [&mut right, &mut left];
        let output = assert_balanced(sides, &input, marker, tolerance::SIMILARITY);
        assert!(output.patch_count > 0);
    }
}

#[test]
fn a_load_is_carried_all_around_and_nothing_is_remembered() {
    let folder = eccentric();
    let parameters = Parameters { vertical_mode: VerticalMode::Load, ..with("wheel.slcw") };
    let [mut one, mut other] = [(); 2].map(|()| element(&parameters, &folder));
    let mut input = rolling(1e-3, 20.0);
    input.wheel_load = 7e4;
    let mut last = Output::default();
    for i in 0..30 {
        input.wheel.pitch = -0.3 * f64::from(i);
        last = evaluate(&mut one, &input);
        assert_relative_eq!(last.load_carried, 7e4, max_relative = tolerance::SIMILARITY);
        let moment = -last.wheel.force[2] * ECCENTRICITY * input.wheel.pitch.sin();
        let creep = last.wheel.moment[1] - moment;
        assert!(creep.abs() < 0.3 * 7e4 * 0.47, "{creep}");
    }
    // An element that comes from elsewhere finds the same.
    assert_eq!(evaluate(&mut other, &input), last);
}

#[test]
fn sections_of_other_outlines_stand_where_wheels_of_them_would() {
    // At both sections the wheel is even around: it stands as high as a round one, but for its
    // curvature along the rail.
    let folder = TempDir::new().unwrap();
    let worn = concat!(env!("CARGO_MANIFEST_DIR"), "/fmu/resources/profiles/S1002_worn.txt");
    fs::copy(worn, folder.path().join("worn.txt")).unwrap();
    for other in ["worn.txt", "conical:0.05"] {
        for sections in [["S1002", other], [other, "S1002"]] {
            let table = format!("angle_deg,profile\n0,{}\n180,{}\n", sections[0], sections[1]);
            fs::write(folder.path().join("around.csv"), table).unwrap();
            let mut varying = with("around.csv");
            varying.vertical_mode = VerticalMode::Load;
            let mut around = element(&varying, &folder);
            let mut input = Input { wheel_load: 8e4, friction: 0.0, ..Input::default() };
            for (turn, section) in sections.into_iter().enumerate() {
                let mut round = element(
                    &Parameters { vertical_mode: VerticalMode::Load, ..with(section) },
                    &folder,
                );
                input.wheel.pitch = PI * turn as f64;
                let [own, wanted] = [&mut around, &mut round].map(|it| evaluate(it, &input));
                assert_abs_diff_eq!(own.wheel_z, wanted.wheel_z, epsilon = 1e-6);
                assert_relative_eq!(own.wheel.force[2], -8e4, max_relative = tolerance::SIMILARITY);
            }
            for k in 0..12 {
                input.wheel.pitch = TAU * f64::from(k) / 12.0;
                let output = evaluate(&mut around, &input);
                assert_relative_eq!(
                    output.wheel.force[2],
                    -8e4,
                    max_relative = tolerance::SIMILARITY
                );
            }
        }
    }
}

/// Waves of the wheel of [`waves`]: how high they are [m] and how many go around. They are four times
/// as long as a patch: sections around are bridged by a chord, strips by all that overlaps.
const WAVES: (f64, usize) = (4e-5, 58);

/// A folder with the wheel S1002 in sections, twelve to each of four waves of its radius about
/// angle 0; beyond, it stays as on their crests.
fn waves() -> TempDir {
    let folder = TempDir::new().unwrap();
    let wheel = load_profile("wheel", "S1002", ProfileKind::Wheel, 0.0, &[]).unwrap();
    let (start, end) = (wheel.curve.start(), wheel.curve.end());
    let mut listed = String::new();
    for i in 0..=48 {
        let phase = TAU * f64::from(i - 24) / 12.0;
        let mut section = String::from("# mirror_z 0\n# mirror_y 0\n");
        for k in 0..=500 {
            let [y, z] = wheel.curve.at(start + (end - start) * f64::from(k) / 500.0).point;
            writeln!(section, "{:.10} {:.10}", 1e3 * y, 1e3 * (z + WAVES.0 * phase.cos())).unwrap();
        }
        fs::write(folder.path().join(format!("{i}.txt")), section).unwrap();
        writeln!(listed, "{:.12} '{i}.txt'", phase / WAVES.1 as f64).unwrap();
    }
    let text = format!("0 1\n49\n0 0 0\n1\n{listed}");
    fs::write(folder.path().join("wheel.slcw"), text).unwrap();
    folder
}

#[test]
fn strips_bridge_waves_of_sections_as_those_of_a_wheel_that_is_out_of_round() {
    let folder = waves();
    let loaded = |profile: &str| Parameters { vertical_mode: VerticalMode::Load, ..with(profile) };
    let mut sections = element(&loaded("wheel.slcw"), &folder);
    let mut uneven = loaded("S1002");
    let wave = &mut uneven.wheel.out_of_round;
    (wave.amplitude, wave.order) = (WAVES.0, WAVES.1);
    let mut uneven = element(&uneven, &folder);
    let mut pressures = Vec::new();
    for i in -20..=20 {
        let mut input = rolling(0.0, 20.0);
        input.wheel_load = 8e4;
        input.wheel.pitch = 2.7e-3 * f64::from(i);
        let [one, other] = [&mut sections, &mut uneven].map(|wheel| evaluate(wheel, &input));
        assert_abs_diff_eq!(one.wheel_z, other.wheel_z, epsilon = tolerance::BRIDGED_HEIGHT);
        let [own, pressure] = [&one, &other].map(|o| o.patches[0].max_pressure);
        assert_relative_eq!(own, pressure, max_relative = tolerance::BRIDGED_PRESSURE);
        pressures.push(own);
    }
    let [median, worst] = median_and_worst(pressures);
    let by = 1.0 + 5.0 * tolerance::BRIDGED_PRESSURE;
    assert!(worst > by * median, "waves that do not matter: {median} {worst}");
}

#[test]
fn what_does_not_go_with_sections_around_is_refused_by_name() {
    let folder = eccentric();
    let refused = |change: &dyn Fn(&mut Parameters), words: &str| {
        let mut parameters = with("wheel.slcw");
        change(&mut parameters);
        let made = Element::new(&parameters, &Input::default(), &[folder.path().to_path_buf()]);
        let message = made.unwrap_err().to_string();
        assert!(message.contains("wheel.profile") && message.contains(words), "{message}");
    };
    refused(&|p| p.wheel.out_of_round.amplitude = 1e-4, "wheel.out_of_round");
    refused(&|p| p.wear.model = WearModel::Archard, "wear.model");
    refused(&|p| p.wheel.flat.length = 0.03, "wheel.flat");
    let mut wheel = element(&with("wheel.slcw"), &folder);
    let (input, mut rates) = (rolling(0.0, 20.0), Output::default());
    let asked = wheel.directional_derivative(&input, &input, &mut rates);
    assert!(asked.unwrap_err().to_string().contains("wheel.profile"));
    for (text, words) in [
        ("station_m,profile\n0,S1002\n1,S1002\n", "angle_deg"),
        ("angle_deg,profile\n0,S1002\n0,S1002\n", "0.001 rad"),
        ("angle_deg,profile\n0,S1002\n", "two or more"),
    ] {
        fs::write(folder.path().join("bad.csv"), text).unwrap();
        let made =
            Element::new(&with("bad.csv"), &Input::default(), &[folder.path().to_path_buf()]);
        let message = made.unwrap_err().to_string();
        assert!(message.contains("bad.csv") && message.contains(words), "{message}");
    }
}

#[test]
fn evaluations_of_a_wheel_that_varies_allocate_nothing() {
    let folder = eccentric();
    for vertical_mode in [VerticalMode::Penetration, VerticalMode::Load] {
        let mut wheel = element(&Parameters { vertical_mode, ..with("wheel.slcw") }, &folder);
        let mut output = Output::default();
        let mut touched = 0;
        let before = allocations::count();
        for i in 0..100 {
            let t = f64::from(i);
            let mut input = rolling(6e-3 * (0.3 * t).sin(), 20.0);
            input.wheel.pitch = 0.37 * t;
            input.wheel.yaw = 0.02 * (0.7 * t).sin();
            input.wheel.position[2] = -0.46 + 8e-4 * (0.11 * t).sin();
            input.wheel_load = 5e4 * (0.2 * t).sin();
            wheel.evaluate(&input, &mut output).unwrap();
            touched += i32::from(output.patch_count > 0);
        }
        assert_eq!(allocations::count(), before);
        assert!(touched > 20, "{touched}");
    }
}
