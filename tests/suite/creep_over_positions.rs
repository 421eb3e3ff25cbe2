//! Tangential models against boundary elements on the same pressure, over all of a wheel's positions
//! on its rail: forces, moments, power and where wear lies.

use crate::tolerance;
use std::f64::consts::PI;
use std::fmt::Write;

use crate::common::summary::Summary;
use crate::common::wheel::{pressed, rolling};
use crate::common::{quantiles, write_report};
use wheelrail::element::parameters::{CreepageModel, TangentialModel};
use wheelrail::element::{Element, Input, Output, Parameters, WornBody};
use wheelrail::wear::{WearDistribution, WearModel};

/// Creepages of the wheel's motion besides that of its place: longitudinal and lateral.
const MOTIONS: [[f64; 2]; 12] = [
    [0.0, 0.0],
    [3e-4, 0.0],
    [-3e-4, 5e-4],
    [0.0, 1e-3],
    [0.0, -1e-3],
    [1e-3, 0.0],
    [-1e-3, 1e-3],
    [1e-3, -2e-3],
    [0.0, 4e-3],
    [0.0, -4e-3],
    [3e-3, 1e-3],
    [-3e-3, -3e-3],
];

/// Compares models with boundary elements on the same pressure at positions `step` apart [m].
fn over_positions(step: f64, pairs: &[[&str; 2]], name: &str) -> [[f64; 3]; 4] {
    let models = [
        ("marches", TangentialModel::Marches),
        ("fastsim", TangentialModel::Fastsim),
        ("fastsim_corrected", TangentialModel::FastsimCorrected),
        ("tables", TangentialModel::Tables),
    ];
    let mut summary = Summary::new(name);
    let mut report =
        String::from("wheel,rail,y_mm,depth_um,longitudinal,lateral,model,share of load,error\n");
    // Of force, spin moment, frictional power, and of the forces of all patches of a wheel.
    let mut errors = vec![[const { Vec::<f64>::new() }; 4]; models.len()];
    let mut fallbacks = vec![0; models.len()];
    for [wheel, rail] in pairs {
        let parameters = |tangential_model| {
            let mut parameters = Parameters {
                tangential_model,
                creepage_model: CreepageModel::Flat,
                normal_elements: [60, 60],
                ..Parameters::default()
            };
            parameters.wheel.profile = (*wheel).into();
            parameters.rails[0].profile = (*rail).into();
            parameters
        };
        let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/fmu/resources/profiles");
        let new = |p: &Parameters| Element::new(p, &Input::default(), &[folder.into()]).unwrap();
        let mut reference = new(&parameters(TangentialModel::BoundaryElement));
        let mut others: Vec<_> = models.iter().map(|(_, model)| new(&parameters(*model))).collect();
        let mut place = -6e-3;
        while place <= 8.2e-3 {
            for depth in [4e-5, 7e-5, 1.1e-4] {
                for [longitudinal, lateral] in MOTIONS {
                    let mut input = rolling(place, 20.0);
                    input.wheel.pitch_rate *= 1.0 - longitudinal;
                    input.wheel.velocity[1] = 20.0 * lateral;
                    let input = pressed(&mut reference, &input, depth);
                    let (mut exact, mut found) = (Output::default(), Output::default());
                    reference.evaluate(&input, &mut exact).unwrap();
                    assert_eq!(exact.fallback_count, 0);
                    for (i, (model, _)) in models.iter().enumerate() {
                        let errors = &mut errors[i];
                        others[i].evaluate(&input, &mut found).unwrap();
                        fallbacks[i] = found.fallback_count;
                        let patches = exact.patch_count as usize;
                        let mut power = [0.0; 2];
                        let mut whole = [0.0; 3];
                        for (a, b) in found.patches.iter().zip(&exact.patches).take(patches) {
                            let limit = input.friction * b.normal_force;
                            let [x, y] = [0, 1].map(|i| a.creep_force[i] - b.creep_force[i]);
                            let force = x.hypot(y) / limit;
                            whole = [whole[0] + x, whole[1] + y, whole[2] + limit];
                            let c = (b.area / PI).sqrt();
                            errors[0].push(100.0 * force);
                            errors[1]
                                .push(100.0 * (a.spin_moment - b.spin_moment).abs() / (limit * c));
                            power[0] += (a.frictional_power - b.frictional_power).abs();
                            power[1] += b.frictional_power;
                            let [mm, um] = [1e3 * place, 1e6 * depth];
                            let share = b.normal_force / exact.wheel.force[2].abs();
                            writeln!(
                                report,
                                "{wheel},{rail},{mm:.1},{um:.0},{longitudinal},{lateral},{model},{share:.4},{force:.5}"
                            )
                            .unwrap();
                        }
                        errors[2].push(100.0 * power[0] / power[1]);
                        errors[3].push(100.0 * whole[0].hypot(whole[1]) / whole[2]);
                    }
                }
            }
            place += step;
        }
    }
    for (i, (model, _)) in models.iter().enumerate() {
        let quantities = ["force", "spin moment", "frictional power", "force of the whole wheel"];
        for (quantity, errors) in quantities.iter().zip(&errors[i]) {
            let title = format!("{model}: {quantity} [%]");
            println!("{title}: {:.3?} of {}", quantiles(errors.clone()), errors.len());
            summary.add(&title, errors.iter().copied(), "");
        }
        println!("{model}: {} of {} fall back", fallbacks[i], errors[i][3].len());
    }
    summary.write();
    write_report(&format!("{name}.csv"), &report);
    [0, 1, 2, 3].map(|k| quantiles(errors[0][k].clone()))
}

/// Asserts that forces are within `forces`, and the targets of moment and power.
fn reach(found: &[[f64; 3]; 4], forces: [f64; 3]) {
    let [force, moment, power, _] = found;
    for (found, most) in force.iter().zip(forces) {
        assert!(*found <= 100.0 * most, "{force:?}");
    }
    let [most_moment, most_power] = tolerance::MARCHES_POSITIONS_OTHERS;
    assert!(
        moment[0] <= 100.0 * most_moment && power[1] <= 100.0 * most_power,
        "{moment:?} {power:?}"
    );
}

#[test]
fn forces_over_a_tread_are_those_of_boundary_elements() {
    let found = over_positions(3.1e-3, &[["S1002", "60E1"]], "creep_over_positions");
    reach(&found, tolerance::MARCHES_POSITIONS);
}

#[test]
#[ignore = "15 000 states against boundary elements: minutes in release builds"]
fn forces_all_over_profiles_are_those_of_boundary_elements() {
    let pairs = [["S1002", "60E1"], ["S1002", "54E1"], ["S1002_worn.txt", "60E1"]];
    let found = over_positions(0.1e-3, &pairs, "creep_over_positions_dense");
    reach(&found, tolerance::MARCHES_ALL_POSITIONS);
}

#[test]
fn wear_lies_across_a_patch_as_by_boundary_elements() {
    let models = [
        TangentialModel::BoundaryElement,
        TangentialModel::Marches,
        TangentialModel::Fastsim,
        TangentialModel::FastsimCorrected,
    ];
    let mut elements = models.map(|tangential_model| {
        let mut parameters = Parameters { tangential_model, ..Parameters::default() };
        parameters.creepage_model = CreepageModel::Flat;
        parameters.normal_elements = [60, 60];
        parameters.wear.model = WearModel::FrictionalWork;
        parameters.wear.distribution = WearDistribution::Strips;
        parameters.wear.smoothing = 2e-3;
        Element::new(&parameters, &Input::default(), &[]).unwrap()
    });
    let unworn = elements.each_ref().map(|element| element.wear_state().unwrap());
    let mut summary = Summary::new("wear_across");
    let mut errors = [const { Vec::new() }; 3];
    let mut output = Output::default();
    for shift in (-60..=80).step_by(20) {
        for [longitudinal, lateral] in MOTIONS.into_iter().skip(1) {
            let mut input = rolling(1e-4 * f64::from(shift), 20.0);
            input.wheel.pitch_rate *= 1.0 - longitudinal;
            input.wheel.velocity[1] = 20.0 * lateral;
            let input = pressed(&mut elements[0], &input, 7e-5);
            let depths: Vec<Vec<f64>> = elements
                .iter_mut()
                .zip(&unworn)
                .map(|(element, unworn)| {
                    assert!(element.set_wear_state(unworn));
                    element.accumulate(&input, &mut output, 1e-2).unwrap();
                    element.update_profiles();
                    element.wear_depth(WornBody::Rail(0)).iter().map(|[_, depth]| *depth).collect()
                })
                .collect();
            let whole: f64 = depths[0].iter().sum();
            assert!(whole > 0.0);
            for (errors, own) in errors.iter_mut().zip(&depths[1..]) {
                let wrong: f64 = own.iter().zip(&depths[0]).map(|(a, b)| (a - b).abs()).sum();
                errors.push(100.0 * wrong / whole);
            }
        }
    }
    for (model, errors) in models[1..].iter().zip(&errors) {
        println!("{model:?}: wear across {:.3?}", quantiles(errors.clone()));
        summary.add(&format!("{model:?}: wear across [%]"), errors.iter().copied(), "");
    }
    summary.write();
    let [marches, ..] = errors.map(quantiles);
    assert!(marches[1] <= 100.0 * tolerance::MARCHES_WEAR_ACROSS, "{marches:?}");
}
