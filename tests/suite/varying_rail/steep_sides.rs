//! Rails with a side that runs off fast, and with a crest where a rise ends.

use super::*;

/// Points of the right side of a flangeway: a wall leaning by 4 degrees, a corner of 9 mm and a top
/// that rises by 1:20, `aside` to the right [mm].
fn side_of_flangeway(aside: f64) -> String {
    const CORNER: f64 = 9.0;
    let (lean, rise) = (4.0_f64.to_radians(), 0.05_f64.atan());
    let first = FRAC_PI_2 - lean;
    let corner: Vec<[f64; 2]> = (0..=40)
        .map(|k| {
            let angle = first - (first + rise) * f64::from(k) / 40.0;
            [-CORNER * angle.sin(), CORNER * (1.0 - angle.cos())]
        })
        .collect();
    let ([low, high], step) = ([corner[0], corner[40]], |k: i32| 0.5 * f64::from(k));
    let wall = (1..=80).rev().map(&step).map(|way| {
        let [y, z] = low;
        [y - way * lean.sin(), z + way * lean.cos()]
    });
    let top = (1..120).map(step).map(|way| {
        let [y, z] = high;
        [y + way * rise.cos(), z - way * rise.sin()]
    });
    let all = wall.chain(corner.iter().copied()).chain(top);
    all.fold(String::from("# mirror_z 0\n"), |text, [y, z]| {
        text + &format!("{:.9} {z:.9}\n", y + aside)
    })
}

/// The wall is a steep flank that other rows than the corner's are met on, far ahead or behind: an
/// outline through them is none unless those that nothing touches go along.
#[test]
fn a_flange_is_carried_by_the_wall_of_a_flangeway_that_runs_off() {
    let folder = slices((-36..=36).map(|i| 5.0 * f64::from(i)), |s| side_of_flangeway(s / 6.0));
    for normal_model in [NormalModel::Strips, NormalModel::PiotrowskiKik] {
        let mut own = of_slices(Parameters { normal_model, ..Parameters::default() });
        own.vertical_mode = VerticalMode::Load;
        let mut element = element(&own, &folder);
        for yaw in [-0.01, 0.0, 0.01] {
            for step in 0..9 {
                let mut input = Input { friction: 0.0, wheel_load: 60e3, ..Input::default() };
                input.wheel.position[1] = 0.774 + 1e-3 * f64::from(step);
                input.wheel.yaw = yaw;
                let output = evaluate(&mut element, &input);
                let told = format!("{normal_model:?} yaw {yaw} step {step}");
                assert_eq!(output.fallback_count, 0, "{told}");
                let [_, fy, fz] = output.wheel.force;
                assert_relative_eq!(fz, -60e3, max_relative = tolerance::PRESCRIBED_LOAD);
                // By a flange, not by a side that is held on to from behind: that pushes by meganewtons.
                assert!(fy < -3e4 && fy > -9e4, "{told}: {fy}");
            }
        }
    }
}

/// A wheel of radius r, ahead of which by x a rise ends in a level, stands on the crest where its
/// own slope there is less than that of the rise: as high as r and x say.
#[test]
fn a_wheel_stands_on_the_crest_where_a_rise_ends() {
    const RISE: f64 = 0.1;
    let folder =
        slices((-20..=0).map(|i| 10.0 * f64::from(i)), |place| crown(1.0, [0.0, -RISE * place]));
    for normal_model in [NormalModel::Strips, NormalModel::PiotrowskiKik] {
        let mut own = of_slices(Parameters { normal_model, ..Parameters::default() });
        own.wheel.profile = "cylindrical".into();
        let radius = own.wheel.nominal_radius;
        let mut by_height = element(&own, &folder);
        own.vertical_mode = VerticalMode::Load;
        let mut by_load = element(&own, &folder);
        for station in [-0.01, -0.02, -0.03, -0.04] {
            let mut input = Input { track_s: station, friction: 0.0, ..Input::default() };
            let below = (radius * radius - station * station).sqrt();
            let touch = by_height.touching_height(&input);
            assert_relative_eq!(touch, -below, epsilon = 1e-9);
            input.wheel_load = 60e3;
            let output = evaluate(&mut by_load, &input);
            let [fx, _, fz] = output.wheel.force;
            // Along the radius of the wheel, but for the depth over it.
            assert_relative_eq!(fx / fz, -station / below, max_relative = 1e-3);
            assert_relative_eq!(fz, -60e3, max_relative = tolerance::PRESCRIBED_LOAD);
            assert_eq!(output.fallback_count, 0);
        }
    }
}
