//! Wheels that are not round on rails whose section varies along the track.

mod first_touch;
mod scene;

use self::scene::{
    ECCENTRICITY, FLAT, REAL_TIME, anyhow, apart, crossing_at, crossing_of, eccentric, element,
    folder, on_crossing, wheel_of, worn,
};
use crate::allocations;
use crate::tolerance;
use std::f64::consts::PI;

use crate::common::random::Random;
use crate::common::spread;
use crate::common::vectors::{assert_balanced, cross};
use crate::common::wheel::{evaluate, rolling};
use crate::varying_rail::roll_without_jumps;
use approx::{assert_abs_diff_eq, assert_relative_eq};
use wheelrail::element::parameters::{FlatShape, NormalModel, Side, VerticalMode};
use wheelrail::element::{Element, Input, Output, Parameters};
use wheelrail::geometry::profile::ProfileKind;
use wheelrail::io::load_profile;

#[test]
fn equal_sections_around_are_a_round_wheel_on_a_rail_that_varies() {
    let folder = folder(25.0);
    let elements = (NormalModel::BoundaryElement, 3, tolerance::EQUAL_SLICES_ELEMENTS);
    let models = REAL_TIME.map(|model| (model, 60, tolerance::EQUAL_SECTIONS_AROUND));
    for (normal_model, poses, allowed) in models.into_iter().chain([elements]) {
        let [mut round, mut around] = ["S1002", "same.csv"].map(|wheel| {
            let own = Parameters { normal_model, damping: 1e5, ..Parameters::default() };
            element(&on_crossing(own, wheel), &folder)
        });
        let mut random = Random::new(3);
        let mut errors = Vec::new();
        for _ in 0..poses {
            let input = anyhow(&mut round, &mut random);
            let (one, other) = (evaluate(&mut round, &input), evaluate(&mut around, &input));
            assert_eq!(one.patch_count, other.patch_count);
            errors.extend(apart(&one, &other));
        }
        let found = spread(errors);
        println!("{normal_model:?}: {found:?}");
        assert!(found[2] <= allowed, "{normal_model:?} {found:?}");
    }
}

#[test]
fn a_rail_of_equal_slices_is_one_profile_for_a_wheel_that_varies() {
    let folder = folder(25.0);
    eccentric(&folder);
    let elements = (NormalModel::BoundaryElement, 2, tolerance::EQUAL_SLICES_ELEMENTS);
    let models = REAL_TIME.map(|model| (model, 20, tolerance::EQUAL_SLICES));
    for (normal_model, poses, allowed) in models.into_iter().chain([elements]) {
        let [mut even, mut varying] = ["60E1", "even.csv"].map(|rail| {
            let mut own = Parameters { normal_model, damping: 1e5, ..Parameters::default() };
            own.profile_smoothing = 0.0;
            (own.wheel.profile, own.rails[0].profile) = ("wheel.slcw".into(), rail.into());
            element(&own, &folder)
        });
        let mut random = Random::new(5);
        let mut errors = Vec::new();
        for _ in 0..poses {
            let input = anyhow(&mut even, &mut random);
            let (one, other) = (evaluate(&mut even, &input), evaluate(&mut varying, &input));
            assert_eq!(one.patch_count, other.patch_count);
            errors.extend(apart(&one, &other));
        }
        let found = spread(errors);
        println!("{normal_model:?}: {found:?}");
        assert!(found[2] <= allowed, "{normal_model:?} {found:?}");
    }
}

/// Gives a wheel its shape.
type Change = fn(&mut Parameters);

#[test]
fn waves_and_flats_on_equal_slices_are_those_on_one_profile() {
    let folder = folder(25.0);
    let once = |p: &mut Parameters| p.wheel.out_of_round.amplitude = 5e-4;
    let twelve = |p: &mut Parameters| {
        (p.wheel.out_of_round.amplitude, p.wheel.out_of_round.order) = (1e-4, 12);
    };
    let hollow = |p: &mut Parameters| {
        (p.wheel.flat.length, p.wheel.flat.shape) = (FLAT, FlatShape::Worn);
    };
    let chord = |p: &mut Parameters| p.wheel.flat.length = FLAT;
    let shapes: [(&str, Change, f64); 4] = [
        ("eccentric", once, 0.1),
        ("twelve waves", twelve, 0.1),
        ("worn flat", hollow, 0.003),
        ("fresh flat", chord, 0.003),
    ];
    for normal_model in [NormalModel::Strips, NormalModel::Hertz] {
        for (shape, change, step) in shapes {
            let [mut even, mut varying] = ["60E1", "even.csv"].map(|rail| {
                let vertical_mode = VerticalMode::Load;
                let mut own = Parameters { normal_model, vertical_mode, ..Parameters::default() };
                change(&mut own);
                own.rails[0].profile = rail.into();
                element(&own, &folder)
            });
            let mut errors = [(); 4].map(|()| Vec::new());
            for i in 0..60 {
                let mut input = rolling(3e-3 * f64::from(i % 5 - 2), 20.0);
                // Not upon the middle of a flat, where a wheel stands on both of its ends.
                (input.wheel_load, input.wheel.pitch) = (8e4, step * (f64::from(i - 30) + 0.3));
                let (one, other) = (evaluate(&mut even, &input), evaluate(&mut varying, &input));
                let [a, b] = [&one, &other].map(|output| &output.patches[0]);
                let force = [0, 1].map(|axis| one.wheel.force[axis] - other.wheel.force[axis]);
                errors[0].push((one.wheel_z - other.wheel_z).abs());
                errors[1].push((a.position[0] - b.position[0]).abs());
                errors[2].push((a.max_pressure / b.max_pressure - 1.0).abs());
                errors[3].push(force[0].hypot(force[1]) / (0.3 * 8e4));
            }
            let [height, place, pressure, force] = errors.map(spread);
            println!("{normal_model:?} {shape}: {height:?} {place:?} {pressure:?} {force:?}");
            // An even rail takes parabolas for circles and arcs for angles: at the ends of a fresh
            // flat, 25 mm ahead, that is some micrometres.
            let k = usize::from(shape != "fresh flat");
            assert!(height[k] <= tolerance::VARYING_HEIGHT, "{shape} {height:?}");
            assert!(place[k] <= tolerance::VARYING_PLACE, "{shape} {place:?}");
            assert!(pressure[k] <= tolerance::VARYING_PRESSURE, "{shape} {pressure:?}");
            assert!(force[k] <= tolerance::VARYING_FORCE, "{shape} {force:?}");
        }
    }
}

#[test]
fn an_eccentric_wheel_on_a_crossing_is_a_round_one_beside_its_axle() {
    let rail = load_profile("rail", "60E1", ProfileKind::Rail, 0.0, &[]).unwrap().curve;
    let folder = crossing_of(25.0, |[aside, down]| {
        rail.knots().fold(String::new(), |text, s| {
            let [y, z] = rail.at(s).point;
            text + &format!("{:.9} {:.9}\n", 1e3 * y + aside, 1e3 * z + down)
        })
    });
    eccentric(&folder);
    for normal_model in REAL_TIME {
        let of = |wheel: &str, amplitude: f64| {
            let own = Parameters { normal_model, damping: 1e5, ..Parameters::default() };
            let mut own = on_crossing(own, wheel);
            own.wheel.out_of_round.amplitude = amplitude;
            element(&own, &folder)
        };
        let mut round = of("round.txt", 0.0);
        let (mut around, mut wave) = (of("wheel.slcw", 0.0), of("round.txt", ECCENTRICITY));
        let mut random = Random::new(5);
        let (mut errors, mut heights) = ([Vec::new(), Vec::new()], [Vec::new(), Vec::new()]);
        for _ in 0..30 {
            let mut moved = anyhow(&mut round, &mut random);
            moved.friction = 0.0;
            let pitch = random.about(PI);
            moved.wheel.pitch = pitch;
            (moved.wheel.roll_rate, moved.wheel.yaw_rate) = (0.0, 0.0);
            let (sin_roll, cos_roll) = moved.wheel.roll.sin_cos();
            let (axle, down) = ([0.0, cos_roll, sin_roll], [0.0, -sin_roll, cos_roll]);
            let ahead = cross(axle, down);
            let beside = |forward: f64, downward: f64| -> [f64; 3] {
                std::array::from_fn(|i| ECCENTRICITY * (forward * ahead[i] + downward * down[i]))
            };
            let (sine, cosine) = pitch.sin_cos();
            let (to, way) = (beside(sine, cosine), beside(cosine, -sine));
            let mut input = moved;
            for i in 0..3 {
                input.wheel.position[i] -= to[i];
                moved.wheel.velocity[i] += moved.wheel.pitch_rate * way[i];
            }
            let mut one = evaluate(&mut round, &moved);
            let moment = cross(to, one.wheel.force);
            one.wheel.moment = std::array::from_fn(|i| one.wheel.moment[i] + moment[i]);
            let [force, moment] = apart(&one, &evaluate(&mut around, &input));
            errors[0].push(force);
            errors[1].push(moment);
            if normal_model != NormalModel::Strips {
                continue;
            }
            let touch = round.touching_height(&moved) - to[2];
            heights[0].push((around.touching_height(&input) - touch).abs());
            // Along the normal.
            let cosine = one.patches[0].contact_angle.cos();
            heights[1].push((wave.touching_height(&input) - touch).abs() * cosine);
        }
        let errors = errors.map(spread);
        println!("{normal_model:?}: {errors:?}");
        for (found, allowed) in errors.into_iter().zip(tolerance::ECCENTRIC) {
            assert!(found[0] <= allowed[0] && found[2] <= allowed[1], "{normal_model:?} {found:?}");
        }
        if normal_model != NormalModel::Strips {
            continue;
        }
        let heights = heights.map(spread);
        println!("heights: {heights:?}");
        assert!(heights[0][2] <= 1e-8, "{heights:?}");
        // A wave of one harmonic is a circle but for ε²/2R, a quarter of a micrometre.
        assert!(heights[1][2] <= tolerance::VARYING_HEIGHT, "{heights:?}");
    }
}

#[test]
fn forces_of_a_flat_on_a_crossing_have_an_energy_and_close_as_it_rises() {
    let folder = folder(10.0);
    let mut own = on_crossing(Parameters { damping: 0.0, ..Parameters::default() }, "conical:0.05");
    (own.wheel.flat.length, own.wheel.flat.shape) = (0.1, FlatShape::Worn);
    let mut bare = element(&own, &folder);
    let mut damped = element(&Parameters { damping: 1e5, ..own.clone() }, &folder);
    for (station, pitch) in [(-0.04, 0.05), (-0.01, -0.04), (0.02, 0.03), (0.05, 0.06)] {
        let mut input = Input { friction: 0.0, track_s: station, ..Input::default() };
        input.wheel.pitch = pitch;
        let height = bare.touching_height(&input) + 1e-4;
        let wrench = |element: &mut Element, turn: f64, down: f64| {
            let mut input = input;
            input.wheel.pitch += turn;
            input.wheel.position[2] = height + down;
            evaluate(element, &input).wheel
        };
        let (h, d) = (4e-6, 2e-7);
        let by_turn = wrench(&mut bare, h, 0.0).force[2] - wrench(&mut bare, -h, 0.0).force[2];
        let by_height = wrench(&mut bare, 0.0, d).moment[1] - wrench(&mut bare, 0.0, -d).moment[1];
        let (by_turn, by_height) = (by_turn / (2.0 * h), by_height / (2.0 * d));
        println!("{station}: {by_turn:.5e} {by_height:.5e}");
        assert_relative_eq!(by_turn, by_height, max_relative = tolerance::VARYING_FORCE);
        // The rate at which the height falls at which the force stays as the wheel moves on and turns.
        let rates = [0.1, -0.3];
        let mut force = |time: f64, down: f64| {
            let mut input = input;
            input.track_s += rates[0] * time;
            input.wheel.pitch += rates[1] * time;
            input.wheel.position[2] = height + down;
            evaluate(&mut bare, &input).wheel.force[2]
        };
        let [by_time, by_way] = [[1e-5, 0.0], [0.0, d]]
            .map(|[time, way]| (force(time, way) - force(-time, -way)) / (2.0 * (time + way)));
        let sinking = -by_time / by_way;
        input.wheel.position[2] = height;
        let mut moving = input;
        (moving.wheel.velocity[0], moving.wheel.pitch_rate) = (rates[0], rates[1]);
        let mut falling = input;
        falling.wheel.velocity[2] = -sinking;
        let [still, one, other] =
            [input, moving, falling].map(|input| evaluate(&mut damped, &input).wheel.force[2]);
        println!("{station}: {still:.5e} {:.4e} {:.4e}", one - still, other - still);
        assert_relative_eq!(one - still, other - still, max_relative = tolerance::VARYING_ENERGY);
    }
}

#[test]
fn wheels_that_are_not_round_roll_over_a_crossing_without_jumps() {
    let folder = folder(25.0);
    eccentric(&folder);
    let mut own = Parameters { vertical_mode: VerticalMode::Load, ..Parameters::default() };
    own = on_crossing(own, "conical:0.01");
    let mut wavy = own.clone();
    (wavy.wheel.out_of_round.amplitude, wavy.wheel.out_of_round.order) = (1e-4, 12);
    let mut flat = own.clone();
    (flat.wheel.flat.length, flat.wheel.flat.shape) = (FLAT, FlatShape::Worn);
    flat.wheel.flat.depth = 1e-4;
    let around = on_crossing(own, "wheel.slcw");
    for (parameters, step, count) in [(wavy, 5e-5, 1200), (around, 5e-5, 400), (flat, 1e-5, 1200)] {
        // Where a flat ends, 25 mm from its middle, the curvature of the wheel has a step.
        roll_without_jumps(&mut element(&parameters, &folder), step, count);
    }
}

#[test]
fn corrugation_under_sections_around_is_that_under_a_round_wheel() {
    let folder = folder(25.0);
    let [mut round, mut around] =
        [("S1002", "even.csv"), ("same.csv", "60E1")].map(|(wheel, rail)| {
            let mut own = Parameters { vertical_mode: VerticalMode::Load, ..Parameters::default() };
            (own.wheel.profile, own.rails[0].profile) = (wheel.into(), rail.into());
            own.rails[0].corrugation.amplitude = 2e-5;
            element(&own, &folder)
        });
    for i in 0..20 {
        let mut input = rolling(1e-3 * f64::from(i % 5), 20.0);
        (input.wheel_load, input.track_s) = (8e4, 3.1e-3 * f64::from(i));
        let (one, other) = (evaluate(&mut round, &input), evaluate(&mut around, &input));
        assert_abs_diff_eq!(one.wheel_z, other.wheel_z, epsilon = 1e-12);
        let found = apart(&one, &other);
        assert!(found[0].max(found[1]) <= tolerance::SIMILARITY, "{found:?}");
    }
}

#[test]
fn forces_are_in_balance_and_the_left_side_is_a_mirror() {
    let folder = folder(25.0);
    eccentric(&folder);
    let mut flat = on_crossing(Parameters::default(), "conical:0.025");
    flat.wheel.flat.length = FLAT;
    // The highest point of the first section, at the end of the crossing.
    let [down, aside] = crossing_at(-0.3);
    for parameters in [flat, on_crossing(Parameters::default(), "wheel.slcw")] {
        let mut right = element(&parameters, &folder);
        let mut left = element(&parameters.on_side(Side::Left), &folder);
        let mut random = Random::new(3);
        for _ in 0..10 {
            let mut input = anyhow(&mut right, &mut random);
            input.wheel.position[1] = 0.75 + random.about(2e-3);
            (input.wheel.roll, input.wheel.pitch) = (random.about(1e-3), random.about(0.06));
            input.wheel.position[2] = right.touching_height(&input) + 8e-5;
            let marker = [0.0, 0.75 + aside, down];
            let sides = [&mut right, &mut left];
            let output = assert_balanced(sides, &input, marker, tolerance::SIMILARITY);
            assert!(output.patch_count > 0);
        }
    }
}

#[test]
fn evaluations_of_both_allocate_nothing() {
    let folder = folder(25.0);
    eccentric(&folder);
    let mut flat = on_crossing(Parameters::default(), "S1002");
    flat.wheel.flat.length = FLAT;
    let around = on_crossing(Parameters::default(), "wheel.slcw");
    for parameters in [flat, around] {
        for vertical_mode in [VerticalMode::Penetration, VerticalMode::Load] {
            let mut wheel = element(&Parameters { vertical_mode, ..parameters.clone() }, &folder);
            let mut output = Output::default();
            let mut touched = 0;
            let before = allocations::count();
            for i in 0..50 {
                let t = f64::from(i);
                let mut input = rolling(5e-3 * (0.3 * t).sin(), 20.0);
                input.track_s = 0.25 * (0.05 * t).sin();
                (input.wheel.pitch, input.wheel.yaw) = (0.37 * t, 0.02 * (0.7 * t).sin());
                input.wheel.position[2] = -0.46 + 1e-3 * (0.11 * t).sin();
                input.wheel_load = 5e4 * (0.2 * t).sin();
                wheel.evaluate(&input, &mut output).unwrap();
                touched += i32::from(output.patch_count > 0);
            }
            assert_eq!(allocations::count(), before);
            assert!(touched > 10, "{touched}");
        }
    }
}

#[test]
fn derivatives_of_both_are_refused_by_name() {
    let folder = folder(25.0);
    let normal_model = NormalModel::PiotrowskiKik;
    let mut flat = on_crossing(Parameters { normal_model, ..Parameters::default() }, "S1002");
    flat.wheel.flat.length = FLAT;
    let around = on_crossing(Parameters::default(), "same.csv");
    for (parameters, name) in [(flat, "wheel.flat"), (around, "wheel.profile")] {
        let mut wheel = element(&parameters, &folder);
        let (input, mut rates) = (rolling(0.0, 20.0), Output::default());
        let asked = wheel.directional_derivative(&input, &input, &mut rates);
        assert!(asked.unwrap_err().to_string().contains(name));
    }
}
