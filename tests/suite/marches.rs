//! The tangential model marches against boundary elements, CONTACT's ellipses and Kalker's linear
//! theory, and how smooth its forces are.

use crate::common::kinked_heads::milled;
use crate::common::planar::{creepage_of, hertzian_bodies, separations, steel_case};
use crate::common::summary::Summary;
use crate::common::wheel::{pressed, rolling};
use crate::common::{column, quantiles, read_table, value};
use crate::tolerance;
use std::f64::consts::PI;
use wheelrail::element::parameters::TangentialModel;
use wheelrail::element::{Element, Input, Output, Parameters};
use wheelrail::normal::NormalModel;
use wheelrail::planar::{Indentation, PlanarCase, PlanarResult, solve};
use wheelrail::tangential::kalker_coefficients::kalker_coefficients;

/// A case of steel bodies with the normal solution that elements start with.
fn case(separation: &[[f64; 2]], radius: f64, creepage: [f64; 3]) -> PlanarCase<'_> {
    PlanarCase {
        normal_model: NormalModel::Strips,
        tangential_model: TangentialModel::Marches,
        strips: Parameters::default().strips,
        creepage,
        ..steel_case(separation, radius, 1e-4)
    }
}

#[test]
fn real_patches_roll_as_by_boundary_elements() {
    let data = read_table("boundary_elements/planar_creep.csv");
    let separations = separations();
    let mut summary = Summary::new("marches_profiles");
    for (set, most) in
        [("dense", tolerance::MARCHES_DENSE), ("held_out", tolerance::MARCHES_HELD_OUT)]
    {
        let (mut forces, mut moments) = (Vec::new(), Vec::new());
        for row in data.rows.iter().filter(|row| &row[column(&data, "set")] == set) {
            let v = |name: &str| value(&data, row, name);
            let separation = &separations[&row[column(&data, "case")]];
            let indentation = Indentation::Approach(1e-3 * v("approach_mm"));
            let case = case(separation, 1e-3 * v("radius_mm"), creepage_of(&v));
            let found = solve(&PlanarCase { indentation, ..case }).unwrap();
            assert!(!found.fallback);
            let limit = 0.3 * v("normal_force_n");
            let c = (found.area / PI).sqrt();
            forces.push((found.fx - v("fx_n")).hypot(found.fy - v("fy_n")) / limit);
            moments.push((found.mz - 1e-3 * v("mz_nmm")).abs() / (limit * c));
        }
        for (name, errors) in [("force", &forces), ("moment", &moments)] {
            let title = format!("{set}: {name} [% of the limit]");
            summary.add(&title, errors.iter().map(|error| 100.0 * error), "");
        }
        let [forces, moments] = [forces, moments].map(quantiles);
        println!("{set}: force {forces:.4?}, moment {moments:.4?}");
        for (found, most) in forces.into_iter().zip(most) {
            assert!(found <= most, "{set}: {forces:?}");
        }
        assert!(moments[0] <= tolerance::MARCHES_MOMENT, "{set}: {moments:?}");
    }
    summary.write();
}

/// An ellipse under load, its friction limit 0.3 of it.
fn on_ellipse(a: f64, b: f64, load: f64, creepage: [f64; 3]) -> PlanarResult {
    let (radius, separation) = hertzian_bodies(a, b, load);
    let indentation = Indentation::Load(load);
    solve(&PlanarCase { indentation, ..case(&separation, radius, creepage) }).unwrap()
}

#[test]
fn three_hundred_ellipses_roll_as_by_contact() {
    let data = read_table("contact_25_1/hertz_tangential.csv");
    let (mut forces, mut moments) = (Vec::new(), Vec::new());
    for row in &data.rows {
        let v = |name: &str| value(&data, row, name);
        let (a, b, load) = (1e-3 * v("a_mm"), 1e-3 * v("b_mm"), v("normal_force_n"));
        let found = on_ellipse(a, b, load, creepage_of(&v));
        let limit = 0.3 * load;
        let [x, y] = [found.fx / limit - v("fx_over_mu_n"), found.fy / limit - v("fy_over_mu_n")];
        forces.push(x.hypot(y));
        moments.push((found.mz - 1e-3 * v("mz_44_nmm")).abs() / (limit * (a * b).sqrt()));
    }
    let found = quantiles(forces);
    println!("300 ellipses: {found:.4?}, moment {:.4?}", quantiles(moments));
    for (found, most) in found.into_iter().zip(tolerance::MARCHES_ELLIPSES) {
        assert!(found <= most, "{found}");
    }
}

#[test]
fn small_creepages_have_the_coefficients_of_the_linear_theory() {
    const SMALL: f64 = 1e-9;
    let (modulus, load) = (82e9, 8e4);
    let mut errors = [const { Vec::new() }; 4];
    for i in 0..40 {
        let ratio = 0.1 * 100f64.powf(f64::from(i) / 39.0);
        let c: f64 = 5e-3;
        let (a, b) = (c * ratio.sqrt(), c / ratio.sqrt());
        let [x, y, spin] = [[SMALL, 0.0, 0.0], [0.0, SMALL, 0.0], [0.0, 0.0, SMALL / c]]
            .map(|creepage| on_ellipse(a, b, load, creepage));
        let exact = kalker_coefficients(ratio, 0.28);
        let scale = -modulus * c * c * SMALL;
        let found = [
            x.fx / scale / exact.c11,
            y.fy / scale / exact.c22,
            spin.fy / scale / exact.c23,
            spin.mz / (scale * c) / exact.c33,
        ];
        for (errors, found) in errors.iter_mut().zip(found) {
            errors.push((found - 1.0).abs());
        }
    }
    let found = errors.map(quantiles);
    println!("c11, c22, c23, c33: {found:.4?}");
    for (found, most) in found.into_iter().zip(tolerance::MARCHES_KALKER) {
        assert!(found[1] <= most, "{found:?}");
    }
}

/// A crown of 0.3 m with ridges of 13 µm every two millimetres.
fn ridges() -> Vec<[f64; 2]> {
    let (width, crown) = (2e-3, 0.3);
    let circle = |y: f64| y * y / (2.0 * crown);
    let points = (-100..=100).map(|i| 1e-4 * f64::from(i)).map(|y: f64| {
        let left = (y / width).floor() * width;
        let [from, to] = [left, left + width].map(circle);
        let chord = from + (to - from) * (y - left) / width;
        [y, circle(y) + 8.0 * (chord - circle(y))]
    });
    points.collect()
}

#[test]
fn ridges_beside_each_other_are_not_driven_apart() {
    let separation = ridges();
    for creepage in [[1e-4, 0.0, 0.0], [0.0, 1e-4, 0.0]] {
        let pressed =
            PlanarCase { indentation: Indentation::Load(8e4), ..case(&separation, 0.46, creepage) };
        let force = |case: &PlanarCase| {
            let found = solve(case).unwrap();
            found.fx.hypot(found.fy)
        };
        let exact = force(&PlanarCase {
            normal_model: NormalModel::BoundaryElement,
            tangential_model: TangentialModel::BoundaryElement,
            elements: [40, 80],
            ..pressed
        });
        // Few strips make three zones of it, many seventeen.
        for strips in [20, 40, 80] {
            let found = force(&PlanarCase { strips, ..pressed });
            println!("{creepage:?}, {strips} strips: {found:.0} N for {exact:.0}");
            let error = (found - exact).abs() / found.max(exact);
            assert!(error <= tolerance::MARCHES_RIDGES, "{strips}: {found} N for {exact}");
        }
    }
}

#[test]
fn zones_of_a_milled_rail_feel_each_other() {
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("milled.csv"), milled()).unwrap();
    let mut exact = Parameters {
        normal_model: NormalModel::BoundaryElement,
        tangential_model: TangentialModel::BoundaryElement,
        normal_elements: [40, 60],
        damping: 0.0,
        ..Parameters::default()
    };
    exact.rails[0].profile = "milled.csv".into();
    let start = Parameters {
        normal_model: NormalModel::Strips,
        tangential_model: TangentialModel::Marches,
        ..exact.clone()
    };
    let element = |parameters: &Parameters| {
        Element::new(parameters, &Input::default(), &[folder.path().to_path_buf()]).unwrap()
    };
    let (mut own, mut exact) = (element(&start), element(&exact));
    let (mut worst, mut zones) = (0.0_f64, 0);
    for (y, lateral, turning) in
        [(-3e-3, 2e-4, 0.0), (-1e-3, 4e-4, 3e-4), (1.5e-3, -3e-4, -6e-4), (3e-3, 1e-3, 5e-4)]
    {
        let mut input = rolling(y, 20.0);
        input.wheel.velocity[1] = 20.0 * lateral;
        input.wheel.pitch_rate *= 1.0 + turning;
        let input = pressed(&mut own, &input, 4e-5);
        let [found, exact] = [&mut own, &mut exact].map(|element| {
            let mut output = Output::default();
            element.evaluate(&input, &mut output).unwrap();
            output
        });
        zones += found.patch_count;
        let sum = |output: &Output| {
            let (mut force, mut limit) = ([0.0; 2], 0.0);
            for patch in &output.patches[..output.patch_count as usize] {
                force = [0, 1].map(|i| force[i] + patch.creep_force[i]);
                limit += patch.friction_coefficient * patch.normal_force;
            }
            force.map(|force| force / limit)
        };
        let [found, exact] = [sum(&found), sum(&exact)];
        let error = (found[0] - exact[0]).hypot(found[1] - exact[1]);
        println!("y {y}: {found:.4?} for {exact:.4?}: {error:.4}");
        worst = worst.max(error);
    }
    assert!(zones >= 6, "{zones} zones at four poses");
    assert!(worst <= tolerance::MARCHES_MILLED_RAIL, "{worst}");
}

#[test]
fn steps_of_a_nanometre_show_no_roughness() {
    let parameters = Parameters {
        tangential_model: TangentialModel::Marches,
        damping: 0.0,
        ..Parameters::default()
    };
    let mut element = Element::new(&parameters, &Input::default(), &[]).unwrap();
    let mut output = Output::default();
    let mut bends = Vec::new();
    for y in [-4e-3, -1.7e-3, 0.0, 1.2e-3, 3e-3, 6.3e-3] {
        let mut start = rolling(y, 20.0);
        start.wheel.velocity[1] = 0.02;
        start.wheel.pitch_rate *= 1.001;
        let start = pressed(&mut element, &start, 7e-5);
        let forces: Vec<_> = (0..100)
            .map(|k| {
                let mut input = start;
                input.wheel.position[1] += 1e-9 * f64::from(k);
                element.evaluate(&input, &mut output).unwrap();
                let patch = &output.patches[0];
                patch.creep_force.map(|force| force / (0.3 * patch.normal_force))
            })
            .collect();
        for f in forces.windows(3) {
            let bend = [0, 1].map(|i| f[0][i] - 2.0 * f[1][i] + f[2][i]);
            bends.push(bend[0].hypot(bend[1]));
        }
    }
    let found = quantiles(bends);
    println!("roughness: {found:?}");
    assert!(found[1] <= tolerance::MARCHES_ROUGHNESS, "{found:?}");
}

#[test]
fn forces_are_continuous_in_the_depth_while_lobes_grow_together() {
    // Two lobes 6 mm apart, of which one is deeper.
    let separation: Vec<[f64; 2]> = (-300..=300)
        .map(|i| 4e-5 * f64::from(i))
        .map(|y| [y, 2e-5 * (1.0 - (y / 3e-3).powi(2)).powi(2) + 1e-3 * y])
        .collect();
    let at = |approach: f64| {
        let case = case(&separation, 0.46, [3e-4, 3e-4, 0.3]);
        let indentation = Indentation::Approach(approach);
        let found = solve(&PlanarCase { indentation, ..case }).unwrap();
        let limit = 0.3 * found.normal_force;
        [found.fx / limit, found.fy / limit]
    };
    let steps = 6000;
    let mut greatest: f64 = 0.0;
    let path: Vec<_> =
        (0..=steps).map(|k| at(1e-5 + 1e-4 * f64::from(k) / f64::from(steps))).collect();
    for f in path.windows(4) {
        // A jump shows in the third difference, where the force itself bends.
        let bend = [0, 1].map(|i| f[3][i] - 3.0 * f[2][i] + 3.0 * f[1][i] - f[0][i]);
        greatest = greatest.max(bend[0].hypot(bend[1]));
    }
    println!("greatest third difference over {steps} steps: {greatest:.2e} of the limit");
    assert!(greatest <= tolerance::MARCHES_STEPS, "{greatest:e}");
}
