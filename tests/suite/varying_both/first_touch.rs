//! Heights of first touch of wheels that are not round.

use super::*;

/// Height of first touch of a cone with a worn flat on the crossing by dense search in three
/// dimensions.
fn touch_by_search(input: &Input, slope: f64) -> f64 {
    let marker = input.wheel.position[1];
    let separation = |[x, y]: [f64; 2]| {
        let [down, aside] = crossing_at(input.track_s + x);
        let across = y - 0.75 - aside;
        let rail = 0.3 - (0.3 * 0.3 - across * across).sqrt() + down;
        let radius = 0.46 + slope * (y - marker);
        let mut below = radius;
        for _ in 0..20 {
            let out = radius - worn(f64::atan2(x, below) - input.wheel.pitch);
            below = (out * out - x * x).sqrt();
        }
        rail - below
    };
    let mut best = ([0.0, 0.75], f64::INFINITY);
    let mut look = |at: [f64; 2]| {
        let found = separation(at);
        if found < best.1 {
            best = (at, found);
        }
        best
    };
    for i in -120..=120 {
        for j in -30..=30 {
            look([5e-4 * f64::from(i), 0.75 + 5e-4 * f64::from(j)]);
        }
    }
    let mut step = 5e-4;
    while step > 1e-8 {
        step *= 0.6;
        let ([x, y], _) = look([0.0, 0.75]);
        for i in -2..=2 {
            for j in -2..=2 {
                look([x + step * f64::from(i), y + step * f64::from(j)]);
            }
        }
    }
    best.1
}

#[test]
fn a_wheel_with_a_flat_first_touches_a_crossing_where_a_dense_search_finds() {
    let folder = folder(5.0);
    let angles = (-60..=60).map(|i| 2e-3 * f64::from(i));
    wheel_of(&folder, "conical:0.05", angles, |angle, _| -worn(angle));
    let cone = load_profile("wheel", "conical:0.05", ProfileKind::Wheel, 0.0, &[]).unwrap().curve;
    let [a, b] = [cone.start(), cone.end()].map(|s| cone.at(s).point);
    let slope = (b[1] - a[1]) / (b[0] - a[0]);
    let around = on_crossing(Parameters::default(), "wheel.slcw");
    let mut wave = on_crossing(Parameters::default(), "conical:0.05");
    (wave.wheel.flat.length, wave.wheel.flat.shape) = (FLAT, FlatShape::Worn);
    let mut elements = [around, wave].map(|parameters| element(&parameters, &folder));
    let mut errors = [Vec::new(), Vec::new()];
    for i in 0..30 {
        let mut input = Input { track_s: 4e-3 * f64::from(i) - 0.06, ..Input::default() };
        input.wheel.pitch = 4e-3 * f64::from(i * 7 % 30 - 15);
        input.wheel.position[1] = 0.75 + 1e-3 * f64::from(i % 5 - 2);
        let wanted = touch_by_search(&input, slope);
        for (element, errors) in elements.iter_mut().zip(&mut errors) {
            errors.push((element.touching_height(&input) - wanted).abs());
        }
    }
    let errors = errors.map(spread);
    println!("by sections {:?}, by parameters {:?}", errors[0], errors[1]);
    for found in errors {
        assert!(found[2] <= tolerance::VARYING_HEIGHT, "{found:?}");
    }
}

#[test]
fn a_roller_turns_under_wheels_that_are_not_round() {
    let folder = folder(25.0);
    eccentric(&folder);
    let of = |wheel: &str, amplitude: f64| {
        let mut own = Parameters { profile_smoothing: 0.0, ..Parameters::default() };
        (own.wheel.profile, own.wheel.out_of_round.amplitude) = (wheel.into(), amplitude);
        own.rails[0].roller_radius = 0.5;
        element(&own, &folder)
    };
    let mut round = of("round.txt", 0.0);
    let (mut around, mut wave) = (of("wheel.slcw", 0.0), of("round.txt", ECCENTRICITY));
    for i in 0..24 {
        let mut input = Input::default();
        input.wheel.position[0] = 0.01 * (0.9 * f64::from(i)).sin();
        input.wheel.pitch = 0.27 * f64::from(i);
        let (sine, cosine) = input.wheel.pitch.sin_cos();
        let mut moved = input;
        moved.wheel.position[0] += ECCENTRICITY * sine;
        let wanted = round.touching_height(&moved) - ECCENTRICITY * cosine;
        assert_abs_diff_eq!(around.touching_height(&input), wanted, epsilon = 1e-8);
        let found = wave.touching_height(&input);
        assert_abs_diff_eq!(found, wanted, epsilon = tolerance::VARYING_HEIGHT);
    }
}
