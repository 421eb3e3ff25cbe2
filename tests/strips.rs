//! The strip model against CONTACT and Hertz; see the heads of the files under tests/data.

mod common;
mod tolerance;

use std::fmt::Write;

use common::planar::{parabola, steel_case, steel_modulus};
use common::random::Random;
use common::wheel::{evaluate, pressed, rolling};
use common::{column, median_and_worst, read_table, value, write_report};
use wheelrail::element::parameters::{NormalModel, TangentialModel};
use wheelrail::element::{Element, Input, Parameters};
use wheelrail::normal::hertz;
use wheelrail::planar::{PlanarCase, PlanarResult, solve};

/// Points (y, f) of a separation of the reference [m].
fn separation(case: &str) -> Vec<[f64; 2]> {
    let table = read_table(&format!("contact_25_1/planar/{case}.csv"));
    table
        .rows
        .iter()
        .map(|row| [1e-3 * value(&table, row, "y_mm"), 1e-3 * value(&table, row, "f_mm")])
        .collect()
}

struct Compared {
    name: String,
    regions: usize,
    /// Errors of normal force, greatest pressure and area [-].
    errors: [f64; 3],
    result: PlanarResult,
}

/// The 32 planar cases with `strips` strips by `model`.
fn planar_cases(model: NormalModel, strips: usize) -> Vec<Compared> {
    let table = read_table("contact_25_1/planar_normal.csv");
    let case_column = column(&table, "case");
    table
        .rows
        .iter()
        .map(|row| {
            let v = |name: &str| value(&table, row, name);
            let points = separation(&row[case_column]);
            let result = solve(&PlanarCase {
                normal_model: model,
                tangential_model: TangentialModel::None,
                strips,
                ..steel_case(&points, 1e-3 * v("radius_mm"), 1e-3 * v("approach_mm"))
            })
            .unwrap();
            Compared {
                name: format!("{} {}", &row[case_column], v("approach_mm")),
                regions: v("regions") as usize,
                errors: [
                    result.normal_force / v("normal_force_n") - 1.0,
                    1e-6 * result.max_pressure / v("max_pressure_mpa") - 1.0,
                    1e6 * result.area / v("area_mm2") - 1.0,
                ],
                result,
            }
        })
        .collect()
}

/// Median and worst of the absolute errors of normal force, greatest pressure and area in per cent.
fn summary(cases: &[&Compared]) -> [[f64; 2]; 3] {
    std::array::from_fn(|quantity| {
        let errors = cases.iter().map(|c| 100.0 * c.errors[quantity].abs()).collect();
        median_and_worst(errors)
    })
}

#[test]
fn planar_patches_are_those_of_contact() {
    let mut report = String::from("strips,case,regions,patches,n,p_max,area\n");
    for strips in [11, 15, 21, 31, 41] {
        let cases = planar_cases(NormalModel::Strips, strips);
        for c in &cases {
            let [n, p, a] = c.errors.map(|e| 100.0 * e);
            let (name, patches) = (&c.name, c.result.patches);
            writeln!(report, "{strips},{name},{},{patches},{n:.3},{p:.3},{a:.3}", c.regions)
                .unwrap();
        }
        let one: Vec<&Compared> = cases.iter().filter(|c| c.regions == 1).collect();
        let two: Vec<&Compared> = cases.iter().filter(|c| c.regions == 2).collect();
        let (all, two) = (summary(&one), summary(&two));
        writeln!(report, "{strips},one region,median and worst,,{all:.3?}").unwrap();
        writeln!(report, "{strips},two regions,median and worst,,{two:.3?}").unwrap();
        let fallbacks = cases.iter().filter(|c| c.result.fallback).count();
        writeln!(report, "{strips},fallbacks,{fallbacks},,,,").unwrap();
        if strips == 31 {
            write_report("strips_planar.csv", &report);
            for (errors, bound) in all.iter().zip(tolerance::STRIPS_PLANAR_PERCENT) {
                assert!(errors[0] <= bound[0] && errors[1] <= bound[1], "{report}");
            }
            for (errors, bound) in two.iter().zip(tolerance::STRIPS_TWO_REGIONS_PERCENT) {
                assert!(errors[1] <= bound, "{report}");
            }
        }
    }
    write_report("strips_planar.csv", &report);
}

#[test]
fn ellipses_are_those_of_hertz() {
    let mut report = String::from("strips,a_over_b,n,p0,area\n");
    for strips in [11, 21] {
        for ratio in [0.05, 0.1, 0.2, 0.5, 1.0, 2.0, 5.0, 10.0, 20.0] {
            // Unit semi-axis across of 2 mm at 1 GPa.
            let (radius, points, ellipse) = hertzian(ratio);
            let result = solve(&PlanarCase {
                normal_model: NormalModel::Strips,
                tangential_model: TangentialModel::None,
                strips,
                ..steel_case(&points, radius, APPROACH)
            })
            .unwrap();
            let area = std::f64::consts::PI * ellipse.semi_axis_along * ellipse.semi_axis_across;
            let errors = [
                result.normal_force / ellipse.load - 1.0,
                result.max_pressure / ellipse.max_pressure - 1.0,
                result.area / area - 1.0,
            ];
            let [n, p, a] = errors.map(|e| 100.0 * e);
            writeln!(report, "{strips},{ratio},{n:.4},{p:.4},{a:.4}").unwrap();
            assert!(!result.fallback);
            if strips == 21 {
                assert!(errors[0].abs() <= tolerance::STRIPS_HERTZ, "{report}");
                assert!(errors[1].abs() <= tolerance::STRIPS_HERTZ, "{report}");
            }
        }
    }
    write_report("strips_hertz.csv", &report);
}

/// Approach of the ellipses [m].
const APPROACH: f64 = 5e-5;

/// Wheel radius, separation and exact solution of an ellipse with a/b = `ratio`.
fn hertzian(ratio: f64) -> (f64, Vec<[f64; 2]>, hertz::Ellipse) {
    let along = 1.0;
    let (mut low, mut high) = (1e-6f64, 1e6f64);
    for _ in 0..200 {
        let across = (low * high).sqrt();
        let e = hertz::ellipse(along, across, APPROACH, steel_modulus());
        if e.semi_axis_along / e.semi_axis_across < ratio { low = across } else { high = across }
    }
    let across = (low * high).sqrt();
    let ellipse = hertz::ellipse(along, across, APPROACH, steel_modulus());
    // Far enough to hold all of the overlap.
    let reach = (APPROACH / across).sqrt();
    (0.5 / along, parabola(across, reach), ellipse)
}

/// A wheel with `model` on its rail, without creep forces.
fn wheel(model: NormalModel) -> Element {
    let parameters = Parameters {
        normal_model: model,
        strips: 15,
        tangential_model: TangentialModel::None,
        ..Parameters::default()
    };
    Element::new(&parameters, &Input::default(), &[]).unwrap()
}

#[test]
fn a_solution_is_found_wherever_a_wheel_may_stand() {
    let mut element = wheel(NormalModel::Strips);
    let mut random = Random::new(4);
    let mut report = String::from("shift_mm,roll_mrad,yaw_mrad,depth_um\n");
    let mut before = 0;
    for _ in 0..POSES {
        let mut input = rolling(random.within(-8e-3, 10e-3), 20.0);
        (input.wheel.roll, input.wheel.yaw) = (random.about(5e-3), random.about(0.02));
        let depth = random.within(2e-6, 1.2e-4);
        let at = pressed(&mut element, &input, depth);
        let output = evaluate(&mut element, &at);
        assert_eq!(output.fallback_count, 0, "{at:?}");
        let fixed = element.work().fixed_strips;
        if fixed > before {
            let (shift, roll, yaw) =
                (1e3 * (at.wheel.position[1] - 0.75), at.wheel.roll, at.wheel.yaw);
            let (roll, yaw, depth) = (1e3 * roll, 1e3 * yaw, 1e6 * depth);
            writeln!(report, "{shift:.3},{roll:.3},{yaw:.3},{depth:.2}").unwrap();
        }
        before = fixed;
    }
    write_report("strips_fixed.csv", &report);
    assert!(before as f64 <= tolerance::STRIPS_FIXED * f64::from(POSES), "{report}");
}

/// Random poses of a wheel.
const POSES: i32 = 1500;

/// Greatest change of the normal force over one step of 0.1 µm beyond that of its neighbours, over the force, near `middle` [m].
fn jump(model: NormalModel, middle: f64, depth: f64) -> f64 {
    let mut element = wheel(model);
    let mut start = rolling(middle, 20.0);
    start = pressed(&mut element, &start, depth);
    let loads: Vec<f64> = (-200..200)
        .map(|i| {
            let mut input = start;
            input.wheel.position[1] += 1e-7 * f64::from(i);
            let output = evaluate(&mut element, &input);
            output.patches.iter().map(|p| p.normal_force).sum()
        })
        .collect();
    let change = |i: usize| loads[i + 1] - loads[i];
    (1..398)
        .map(|i| (change(i) - 0.5 * (change(i - 1) + change(i + 1))).abs() / loads[i])
        .fold(0.0, f64::max)
}

#[test]
fn the_force_has_no_jump_where_the_deepest_place_changes() {
    let mut report = String::from("model,y_mm,depth_um,jump\n");
    for (middle, depth) in [(2.38e-4, 8e-5), (2.3e-4, 3e-5), (5.187e-3, 8e-5)] {
        for model in [NormalModel::PiotrowskiKik, NormalModel::Strips] {
            let found = jump(model, middle, depth);
            writeln!(report, "{model:?},{},{},{found:e}", 1e3 * middle, 1e6 * depth).unwrap();
            if model == NormalModel::Strips {
                assert!(found <= tolerance::STRIPS_JUMP, "{report}");
            }
        }
    }
    write_report("strips_jumps.csv", &report);
}

#[test]
fn every_admitted_number_of_strips_gives_a_finite_force() {
    for strips in (4..=12).chain([200]) {
        let parameters = Parameters {
            normal_model: NormalModel::Strips,
            strips,
            tangential_model: TangentialModel::None,
            ..Parameters::default()
        };
        let mut element = Element::new(&parameters, &Input::default(), &[]).unwrap();
        // Many strips take seconds in a debug build.
        let shifts = if strips > 12 { &[-3e-3][..] } else { &[-3e-3, 0.0, 5.2e-3] };
        for &shift in shifts {
            let at = pressed(&mut element, &rolling(shift, 20.0), 6e-5);
            let output = evaluate(&mut element, &at);
            assert!(output.wheel.force[2] < -1e3 && output.wheel.force[2] > -1e6, "{strips}");
            assert_eq!(output.fallback_count, 0, "{strips}");
        }
    }
}
