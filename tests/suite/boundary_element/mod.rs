//! The boundary element solution against closed forms, Kalker's coefficients and CONTACT.
//!
//! The whole sets are behind `--ignored` and want a release build: `cargo test --release --test
//! suite boundary_element:: -- --ignored`. They leave tables in target/reports.

mod drifting_patch;
mod limits;
mod unlike;
mod unlike_wheel;
mod wheel;

use crate::common;
use crate::tolerance;
use std::f64::consts::PI;
use std::fmt::Write;

use crate::common::planar::{HertzRow, STEEL, steel_case};
use crate::common::{Table, column, median_and_worst, quantiles, read_table, value};
use wheelrail::boundary_element::friction::Tractions;
use wheelrail::boundary_element::grid::Grid;
use wheelrail::boundary_element::pressure::PressureSolver;
use wheelrail::boundary_element::rolling::steady_rolling;
use wheelrail::boundary_element::shift::shift;
use wheelrail::element::parameters::{NormalModel, TangentialModel};
use wheelrail::element::{Element, Input, Output, Parameters};
use wheelrail::material::{Material, MaterialPair};
use wheelrail::math::elliptic::complete;
use wheelrail::planar::{PlanarCase, fields, solve};
use wheelrail::tangential::field::Adherence;

fn boundary_case(
    separation: &[[f64; 2]],
    radius: f64,
    approach: f64,
    elements: usize,
) -> PlanarCase<'_> {
    PlanarCase {
        normal_model: NormalModel::BoundaryElement,
        tangential_model: TangentialModel::None,
        elements: [elements; 2],
        ..steel_case(separation, radius, approach)
    }
}

fn separation_of(case: &str) -> Vec<[f64; 2]> {
    let table = read_table(&format!("contact_25_1/planar/{case}.csv"));
    let point = |row| [1e-3 * value(&table, row, "y_mm"), 1e-3 * value(&table, row, "f_mm")];
    table.rows.iter().map(point).collect()
}

/// Greatest errors of load, pressure and area at 60x60 of the cases with `regions` patches, every
/// so many.
fn normal_errors(every: usize, regions: usize) -> [[f64; 2]; 3] {
    let table = read_table("contact_25_1/planar_normal.csv");
    let mut errors: [Vec<f64>; 3] = Default::default();
    let rows =
        table.rows.iter().filter(|row| row[column(&table, "regions")] == regions.to_string());
    for row in rows.step_by(every) {
        let v = |name: &str| value(&table, row, name);
        let points = separation_of(&row[0]);
        let case = boundary_case(&points, 1e-3 * v("radius_mm"), 1e-3 * v("approach_mm"), 60);
        let found = solve(&case).unwrap();
        assert_eq!(found.patches, regions);
        assert!(!found.fallback);
        errors[0].push((found.normal_force / v("normal_force_n") - 1.0).abs());
        errors[1].push((1e-6 * found.max_pressure / v("max_pressure_mpa") - 1.0).abs());
        errors[2].push((1e6 * found.area / v("area_mm2") - 1.0).abs());
    }
    errors.map(median_and_worst)
}

fn check_normal(every: usize, name: &str) {
    let one = normal_errors(every, 1);
    let two = normal_errors(every, 2);
    let mut report = String::from("regions,quantity,median,worst\n");
    for (regions, errors) in [(1, one), (2, two)] {
        for (name, [median, worst]) in ["load", "pressure", "area"].iter().zip(errors) {
            writeln!(report, "{regions},{name},{median:.5},{worst:.5}").unwrap();
        }
    }
    common::write_report(name, &report);
    for (errors, bounds) in [
        (one, tolerance::BOUNDARY_NORMAL_ONE_REGION),
        (two, tolerance::BOUNDARY_NORMAL_TWO_REGIONS),
    ] {
        for (error, bound) in errors.iter().zip(bounds) {
            assert!(error[1] <= bound, "{report}");
        }
    }
}

#[test]
fn profiles_are_pressed_together_as_by_contact() {
    check_normal(4, "boundary_normal_some.csv");
}

#[test]
#[ignore = "the whole set: seconds in release builds"]
fn all_profiles_are_pressed_together_as_by_contact() {
    check_normal(1, "boundary_normal.csv");
}

/// The Hertzian pressure of an ellipse under `load` on a grid 1.1 times as large, by boundary
/// elements.
fn ellipse_pressure(a: f64, b: f64, load: f64, count: usize) -> (Grid, Vec<f64>) {
    let grid = Grid::over([-1.1 * a, 1.1 * a], [-1.1 * b, 1.1 * b], count, count);
    let modulus = MaterialPair::new(STEEL, STEEL).contact_modulus;
    let p0 = 1.5 * load / (PI * a * b);
    let (major, minor) = (a.max(b), a.min(b));
    // Johnson (4.26); the circle is the limit.
    let complement = (minor / major).powi(2).min(1.0 - 1e-9);
    let e = complete(complement);
    let scale = p0 / modulus * minor / ((1.0 - complement) * major * major);
    let flat = scale * e.first_minus_second;
    let steep = scale * e.second_minus_reduced_first / complement;
    let (along, across) = if a > b { (flat, steep) } else { (steep, flat) };
    let separation = grid.sample(|x, y| along * x * x + across * y * y);
    let approach = p0 / modulus * minor * e.first;
    let solution = PressureSolver::new(grid, modulus).at_approach(&separation, approach, None);
    assert!(solution.converged);
    (grid, solution.pressure)
}

fn force(grid: &Grid, tractions: &Tractions) -> [f64; 2] {
    [&tractions.x, &tractions.y].map(|p| p.iter().sum::<f64>() * grid.element_area())
}

fn rigid_slip(grid: &Grid, creepage: [f64; 3]) -> Vec<[f64; 2]> {
    let [longitudinal, lateral, spin] = creepage;
    (0..grid.len())
        .map(|k| {
            let (x, y) = (grid.x(k % grid.along), grid.y(k / grid.along));
            [longitudinal - spin * y, lateral + spin * x]
        })
        .collect()
}

/// Errors |ΔF|/(μ N) on every so many of the 300 ellipses.
fn ellipse_errors(count: usize, every: usize) -> Vec<f64> {
    let table = read_table("contact_25_1/hertz_tangential.csv");
    let steel = MaterialPair::new(STEEL, STEEL);
    let errors = table.rows.iter().step_by(every).map(|row| {
        let v = |name: &str| -> f64 { row[column(&table, name)].parse().unwrap() };
        let load = v("normal_force_n");
        let (grid, pressure) = ellipse_pressure(1e-3 * v("a_mm"), 1e-3 * v("b_mm"), load, count);
        let bound: Vec<f64> = pressure.iter().map(|p| 0.3 * p).collect();
        let creepage = [v("creepage_longitudinal"), v("creepage_lateral"), 1e3 * v("spin_per_mm")];
        let found = steady_rolling(&grid, &steel, &bound, &rigid_slip(&grid, creepage));
        assert!(found.converged, "{} sweeps", found.sweeps);
        let [fx, fy] = force(&grid, &found).map(|f| f / (0.3 * load));
        (fx - v("fx_over_mu_n")).hypot(fy - v("fy_over_mu_n"))
    });
    errors.collect()
}

#[test]
fn ellipses_roll_as_by_contact() {
    let [mean, _, worst] = quantiles(ellipse_errors(22, 12));
    let [most_mean, most_worst] = tolerance::BOUNDARY_ELLIPSES;
    assert!(mean <= most_mean && worst <= most_worst, "mean {mean}, worst {worst}");
}

#[test]
#[ignore = "the whole set: half a minute in release builds"]
fn all_ellipses_roll_as_by_contact() {
    let mut report = String::from("elements,mean,p95,worst\n");
    for count in [11, 22, 44] {
        let [mean, most, worst] = quantiles(ellipse_errors(count, 1));
        writeln!(report, "{count}x{count},{mean:.4},{most:.4},{worst:.4}").unwrap();
        let [most_mean, most_worst] = tolerance::BOUNDARY_ELLIPSES;
        assert!(count < 22 || mean <= most_mean && worst <= most_worst, "{report}");
    }
    common::write_report("boundary_ellipses.csv", &report);
}

/// Errors |ΔF|/(μ N) on real patches, of references with `reference` elements across.
fn planar_errors(table: &Table, reference: &str, every: usize, elements: usize) -> Vec<f64> {
    let rows = table.rows.iter().filter(|row| &row[column(table, "elements")] == reference);
    let errors = rows.step_by(every).map(|row| {
        let v = |name: &str| value(table, row, name);
        let points = separation_of(&row[0]);
        let found = solve(&PlanarCase {
            tangential_model: TangentialModel::BoundaryElement,
            creepage: [v("creepage_longitudinal"), v("creepage_lateral"), 1e3 * v("spin_per_mm")],
            ..boundary_case(&points, 1e-3 * v("radius_mm"), 1e-3 * v("approach_mm"), elements)
        })
        .unwrap();
        assert!(!found.fallback);
        (found.fx - v("fx_n")).hypot(found.fy - v("fy_n")) / (0.3 * v("normal_force_n"))
    });
    errors.collect()
}

#[test]
fn profiles_roll_as_by_contact() {
    let table = read_table("contact_25_1/planar_tangential.csv");
    // Coarser than the reference: debug builds are slow.
    let [mean, _, worst] = quantiles(planar_errors(&table, "80", 17, 24));
    let [most_mean, most_worst] = tolerance::BOUNDARY_PROFILES_COARSE;
    assert!(mean <= most_mean && worst <= most_worst, "mean {mean}, worst {worst}");
}

#[test]
#[ignore = "the whole set: half a minute in release builds"]
fn all_profiles_roll_as_by_contact() {
    let table = read_table("contact_25_1/planar_tangential.csv");
    let mut report = String::from("reference,elements,mean,p95,worst\n");
    for (reference, bounds) in
        [("40", tolerance::BOUNDARY_PROFILES), ("80", tolerance::BOUNDARY_PROFILES_FINE)]
    {
        let [mean, most, worst] = quantiles(planar_errors(&table, reference, 1, 40));
        writeln!(report, "{reference} across,40x40,{mean:.4},{most:.4},{worst:.4}").unwrap();
        assert!(mean <= bounds[0] && worst <= bounds[1], "{report}");
    }
    common::write_report("boundary_profiles.csv", &report);
}

#[test]
fn every_creepage_from_none_to_gross_sliding_converges() {
    let (grid, pressure) = ellipse_pressure(5e-3, 3e-3, 6e4, 16);
    let steel = MaterialPair::new(STEEL, STEEL);
    let bound: Vec<f64> = pressure.iter().map(|p| 0.3 * p).collect();
    let limit = bound.iter().sum::<f64>() * grid.element_area();
    for size in [0.0, 1e-9, 1e-5, 1e-3, 4e-3, 1e-2, 1.0, 100.0] {
        for [x, y, spin] in
            [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 200.0], [-1.0, 0.6, 300.0]]
        {
            let creepage = [size * x, size * y, size * spin];
            let found = steady_rolling(&grid, &steel, &bound, &rigid_slip(&grid, creepage));
            assert!(found.converged, "{creepage:?}: {} sweeps", found.sweeps);
            let [fx, fy] = force(&grid, &found);
            assert!(fx.hypot(fy) <= (1.0 + 1e-9) * limit);
            for k in (0..grid.len()).filter(|&k| bound[k] > 0.0) {
                let p = [found.x[k], found.y[k]];
                let size = p[0].hypot(p[1]);
                assert!(size <= bound[k] * (1.0 + 1e-9));
                let power = p[0] * found.slip_x[k] + p[1] * found.slip_y[k];
                let slip = found.slip_x[k].hypot(found.slip_y[k]);
                let allowed = if found.slips[k] { 1e-2 } else { 1.0 };
                assert!(power <= allowed * size * slip.max(1e-12), "friction drives at {k}");
            }
            if size >= 1.0 && spin == 0.0 {
                assert!(fx.hypot(fy) >= 0.999 * limit);
            }
        }
    }
}

#[test]
fn fields_sum_to_the_forces() {
    let points = separation_of("y5");
    let case = PlanarCase {
        tangential_model: TangentialModel::BoundaryElement,
        creepage: [5e-4, -1e-3, 0.3],
        ..boundary_case(&points, 0.4605, 5e-5, 20)
    };
    let result = solve(&case).unwrap();
    let all = fields(&case).unwrap();
    assert_eq!((all.len(), result.patches), (1, 2));
    let field = &all[0];
    let sum =
        |c: usize| field.traction.iter().map(|p| p[c]).sum::<f64>() * field.grid.element_area();
    let load = field.pressure.iter().sum::<f64>() * field.grid.element_area();
    approx::assert_relative_eq!(load, result.normal_force, max_relative = 1e-9);
    // Each zone is solved with its own creepage: in a planar problem they are one.
    approx::assert_relative_eq!(sum(0), result.fx, max_relative = 1e-3);
    approx::assert_relative_eq!(sum(1), result.fy, max_relative = 1e-3);
    assert!(
        field.adherence.contains(&Adherence::Slip)
            && field.adherence.contains(&Adherence::Adhesion)
    );
}

#[test]
fn tractions_on_the_pressure_of_other_models_have_its_load() {
    let row = HertzRow::with_ratio(1.5);
    let separation = row.separation();
    let hertz = PlanarCase {
        tangential_model: TangentialModel::BoundaryElement,
        creepage: [3e-4, 2e-4, 0.1],
        elements: [24, 24],
        strips: 30,
        ..steel_case(&separation, 0.5 / row.along, row.approach)
    };
    let own = PlanarCase { normal_model: NormalModel::BoundaryElement, ..hertz };
    let (spread, exact) = (solve(&hertz).unwrap(), solve(&own).unwrap());
    let limit = 0.3 * row.load;
    assert!(!spread.fallback);
    let error = (spread.fx - exact.fx).hypot(spread.fy - exact.fy) / limit;
    assert!(error <= tolerance::BOUNDARY_SPREAD, "{error}");
    // Gross sliding has the load of the model.
    let slides = solve(&PlanarCase { creepage: [0.1, 0.0, 0.0], ..hertz }).unwrap();
    approx::assert_relative_eq!(slides.fx, -limit, max_relative = 1e-6);
}

#[test]
fn the_element_takes_boundary_elements() {
    let coarse = Parameters { normal_elements: [14, 14], ..Parameters::default() };
    let exact = Parameters {
        normal_model: NormalModel::BoundaryElement,
        tangential_model: TangentialModel::BoundaryElement,
        ..coarse.clone()
    };
    let mixed = Parameters { normal_model: NormalModel::PiotrowskiKik, ..exact.clone() };
    let mut input = Input::default();
    input.wheel.position[1] -= 3e-3;
    input.wheel.yaw = 4e-3;
    input.wheel.velocity[0] = 20.0;
    input.wheel.pitch_rate = -20.0 / 0.46;
    let mut element = Element::new(&exact, &input, &[]).unwrap();
    input.wheel.position[2] = element.nominal_wheel_z() + 8e-5;
    let solve = |parameters: &Parameters, input: &Input| {
        let mut output = Output::default();
        Element::new(parameters, input, &[]).unwrap().evaluate(input, &mut output).unwrap();
        assert_eq!((output.fallback_count, output.patch_count), (0, 1));
        output
    };
    let (fast, found, spread) =
        (solve(&coarse, &input), solve(&exact, &input), solve(&mixed, &input));
    let load = found.patches[0].normal_force;
    assert!((fast.patches[0].normal_force / load - 1.0).abs() < tolerance::BOUNDARY_ELEMENT_LOAD);
    // Loads differ at the same height: compared is the share of the limit.
    let share = |output: &Output, c: usize| {
        output.patches[0].creep_force[c] / (0.3 * output.patches[0].normal_force)
    };
    for (output, bound) in [(&fast, 2.0), (&spread, 1.0)] {
        for c in 0..2 {
            let missed = share(output, c) - share(&found, c);
            assert!(missed.abs() <= bound * tolerance::BOUNDARY_ELEMENT_CREEP, "{missed}");
        }
    }
    // Lifted, and the same again afterwards: nothing is remembered.
    let mut first = Output::default();
    element.evaluate(&input, &mut first).unwrap();
    let mut lifted = input;
    lifted.wheel.position[2] -= 1e-2;
    let mut output = Output::default();
    element.evaluate(&lifted, &mut output).unwrap();
    assert_eq!(output.patch_count, 0);
    element.evaluate(&input, &mut output).unwrap();
    assert_eq!(output, first);
    // Backwards it is the mirror image across the track.
    let mut back = input;
    back.wheel.velocity[0] *= -1.0;
    back.wheel.pitch_rate *= -1.0;
    back.wheel.yaw *= -1.0;
    let found_back = solve(&exact, &back);
    let [x, y] = found.patches[0].creep_force;
    let [back_x, back_y] = found_back.patches[0].creep_force;
    for missed in [x + back_x, y - back_y] {
        assert!(missed.abs() <= tolerance::BOUNDARY_BACKWARDS * 0.3 * load, "{missed}");
    }
}
